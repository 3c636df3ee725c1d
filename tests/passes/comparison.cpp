// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace passes {

namespace {

// How many bounds the texel lies from what is expected; NaN is infinitely far.
double excessOf(const Pixels& got, int x, int y, const Expected& expected, int channels) {
    double excess = 0.0;
    for (int c = 0; c < channels; ++c) {
        const double difference = std::abs(got.at(x, y, c) - expected.value[c]);
        const double ratio = difference / (expected.bound[c] + storeError(got.format, expected.value[c]));
        excess = ratio >= 0.0 ? std::max(excess, ratio) : std::numeric_limits<double>::infinity();
    }
    return excess;
}

std::string texelText(const Pixels& got, int x, int y, const Expected& expected, int channels) {
    std::ostringstream stream;
    stream.precision(9);
    stream << "pixel (" << x << ", " << y << ")";
    for (int c = 0; c < channels; ++c)
        stream << " | channel " << c << " is " << got.at(x, y, c) << ", expected " << expected.value[c]
               << " +- " << expected.bound[c] + storeError(got.format, expected.value[c]);
    return stream.str();
}

} // namespace

Comparison compare(const Pixels& got, const ExpectedAt& expectedAt, int channels) {
    Comparison comparison;
    for (int y = 0; y < got.height; ++y) {
        for (int x = 0; x < got.width; ++x) {
            ++comparison.pixels;
            Expected expected = expectedAt(x, y, false);
            if (excessOf(got, x, y, expected, channels) <= 1.0) continue;
            expected = expectedAt(x, y, true);
            const double excess = excessOf(got, x, y, expected, channels);
            if (excess <= 1.0) continue;
            ++comparison.outside;
            if (excess <= comparison.largestExcess) continue;
            comparison.largestExcess = excess;
            comparison.worst = texelText(got, x, y, expected, channels);
        }
    }
    return comparison;
}

std::string text(const Comparison& comparison) {
    return std::to_string(comparison.outside) + " of " + std::to_string(comparison.pixels) +
           " pixels are outside of their bounds; the worst: " + comparison.worst;
}

} // namespace passes
