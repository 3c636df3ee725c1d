// SPDX-License-Identifier: Apache-2.0
// Sample sequences of INSIDE I1 in pixels, x right, y down.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace oracle {

using glm::dvec2;

// The digits of index in the base, mirrored at the point.
inline double radicalInverse(uint64_t index, uint64_t base) {
    double result = 0.0, place = 1.0;
    for (; index > 0; index /= base) {
        place *= static_cast<double>(base);
        result += static_cast<double>(index % base) / place;
    }
    return result;
}

// Halton (2, 3) from its first index, centred; 8 or 16 long.
inline dvec2 haltonJitterPx(uint64_t frame, uint64_t period) {
    uint64_t index = frame % period + 1;
    return dvec2(radicalInverse(index, 2), radicalInverse(index, 3)) - 0.5;
}

// The quarter points: lower left, upper right, lower right, upper left, so that y changes side at every step.
// The talk's y runs up; y here runs down, which turns the helix over and keeps the property.
inline dvec2 uniform4HelixJitterPx(uint64_t frame) {
    constexpr std::array<std::array<double, 2>, 4> points = {
        {{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}}};
    const auto& point = points[frame % 4];
    return {point[0], point[1]};
}

} // namespace oracle
