// SPDX-License-Identifier: Apache-2.0
// Projections of every depth kind from 0.1 mm to 10 000 km, with near:far up to 1e11.
#pragma once

#include "projections.hpp"

namespace check {

inline std::vector<std::pair<double, double>> nearAndFar() {
    std::vector<std::pair<double, double>> pairs;
    for (double near : {1e-4, 1e-2, 1.0, 100.0})
        for (double ratio : {10.0, 1e3, 1e5, 1e7, 1e9, 1e11})
            if (near * ratio <= 1.001e7) pairs.emplace_back(near, near * ratio);
    return pairs;
}

inline std::vector<functions::Projection> standardDepth() {
    std::vector<functions::Projection> all;
    for (const auto& [near, far] : nearAndFar())
        all.push_back(functions::perspective("standard", near, far, false));
    return all;
}

inline std::vector<functions::Projection> reversedDepth() {
    std::vector<functions::Projection> all;
    for (const auto& [near, far] : nearAndFar())
        all.push_back(functions::perspective("reversed", near, far, true));
    return all;
}

inline std::vector<functions::Projection> infiniteDepth() {
    std::vector<functions::Projection> all;
    for (double near : {1e-4, 1e-2, 1.0, 100.0})
        all.push_back(
            functions::perspective("reversed infinite", near, std::numeric_limits<double>::infinity(), true));
    return all;
}

inline std::vector<functions::Projection> parallelDepth() {
    std::vector<functions::Projection> all;
    for (const auto& [near, far] : nearAndFar())
        for (bool reversed : {false, true})
            all.push_back(functions::orthographic("orthographic", near, far, reversed));
    return all;
}

// From near to far, an infinite one ending at 1e7 m, evenly in their logarithm.
inline std::vector<double> depthsOf(const functions::Projection& projection, size_t count) {
    const double far = std::min(projection.farM, 1e7);
    std::vector<double> depths;
    for (size_t i = 0; i < count; ++i)
        depths.push_back(
            projection.nearM *
            std::pow(far / projection.nearM, static_cast<double>(i) / static_cast<double>(count - 1)));
    return depths;
}

} // namespace check
