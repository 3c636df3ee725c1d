// SPDX-License-Identifier: Apache-2.0
// Tone mapping operators by their definitions, their inverses, and resolves of samples.
#pragma once

#include "colour.hpp"

#include <cmath>
#include <functional>
#include <vector>

namespace oracle {

inline double reinhard(double x) {
    return x / (1.0 + x);
}

inline constexpr double hableLimit = 1.0 - 0.02 / 0.3;

// The curve as published, with A to F; in extended precision, since it subtracts.
inline double hable(double x) {
    const long double a = 0.15L, b = 0.5L, c = 0.1L, d = 0.2L, e = 0.02L, f = 0.3L, v = x;
    return static_cast<double>((v * (a * v + c * b) + d * e) / (v * (a * v + b) + d * f) - e / f);
}

// 1 - E/F - hable(x)
inline double hableComplement(double x) {
    const long double a = 0.15L, b = 0.5L, c = 0.1L, d = 0.2L, e = 0.02L, f = 0.3L, v = x;
    return static_cast<double>(1.0L - (v * (a * v + c * b) + d * e) / (v * (a * v + b) + d * f));
}

// The x at which a rising curve has the value, by bisection between 0 and the largest colour: no quadratic.
inline double solveRising(const std::function<double(double)>& curve, double value) {
    double low = 0.0, high = maxColour;
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = 0.5 * (low + high);
        (curve(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

inline double resolveBox(const std::vector<double>& samples) {
    double sum = 0.0;
    for (double x : samples)
        sum += x;
    return sum / static_cast<double>(samples.size());
}

// Inverse of the mean of the mapped samples. Far up a curve the complement tells values apart that the curve
// itself does not, so that is what is averaged.
inline double resolveReinhard(const std::vector<double>& samples) {
    double value = 0.0, complement = 0.0; // their means; the inverse of y is y / (1 - y)
    for (double x : samples) {
        value += reinhard(x) / static_cast<double>(samples.size());
        complement += 1.0 / (1.0 + x) / static_cast<double>(samples.size());
    }
    return value / complement;
}

inline double resolveHable(const std::vector<double>& samples) {
    double value = 0.0, complement = 0.0;
    for (double x : samples) {
        value += hable(x) / static_cast<double>(samples.size());
        complement += hableComplement(x) / static_cast<double>(samples.size());
    }
    if (value < 0.5) return solveRising(hable, value);
    return solveRising([](double x) { return -hableComplement(x); }, -complement);
}

} // namespace oracle
