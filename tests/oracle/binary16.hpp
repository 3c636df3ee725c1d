// SPDX-License-Identifier: Apache-2.0
// What 16-bit floats and 8-bit unorm hold, and where feedback through them stops.
#pragma once

#include <algorithm>
#include <cmath>

namespace oracle {

// Distance of the neighbours at a magnitude: 11 significant bits, exponents from -14 to 15.
inline double binary16Step(double value) {
    const double magnitude = std::min(std::abs(value), 65504.0);
    if (magnitude < std::ldexp(1.0, -14)) return std::ldexp(1.0, -24);
    int exponent = 0;
    std::frexp(magnitude, &exponent); // magnitude = m * 2^exponent, m in [1/2, 1)
    return std::ldexp(1.0, exponent - 11);
}

// To nearest, ties to even; of finite values up to 65504.
inline double nearestBinary16(double value) {
    const double step = binary16Step(value);
    return std::nearbyint(value / step) * step;
}

// Towards 0.
inline double truncatedBinary16(double value) {
    const double step = binary16Step(value);
    return std::trunc(value / step) * step;
}

inline double nearestUnorm8(double value) {
    return std::floor(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5) / 255.0;
}

} // namespace oracle
