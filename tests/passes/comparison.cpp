// SPDX-License-Identifier: Apache-2.0
#include "comparison.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace passes {

namespace {

// How far a channel may be off.
double boundOf(const Pixels& got, const Expected& expected, int channel) {
    return expected.bound[channel] + storeError(got.format, expected.value[channel]);
}

// How many bounds the texel lies from what is expected; NaN is infinitely far.
double excessOf(const Pixels& got, int x, int y, const Expected& expected, int channels) {
    double excess = 0.0;
    for (int c = 0; c < channels; ++c) {
        const double ratio = std::abs(got.at(x, y, c) - expected.value[c]) / boundOf(got, expected, c);
        excess = ratio >= 0.0 ? std::max(excess, ratio) : std::numeric_limits<double>::infinity();
    }
    return excess;
}

// Where the largest error of an image is; a bound of 1e6 and more asks for nothing.
struct Largest {
    double error = 0.0;
    int x = 0, y = 0, channel = 0;

    void take(const Pixels& got, int atX, int atY, const Expected& expected, int channels) {
        for (int c = 0; c < channels; ++c) {
            const double difference = std::abs(got.at(atX, atY, c) - expected.value[c]);
            if (difference > error && expected.bound[c] < 1e6) *this = {difference, atX, atY, c};
        }
    }
};

std::string texelText(const Pixels& got, int x, int y, const Expected& expected, int channels) {
    std::ostringstream stream;
    stream.precision(9);
    stream << "pixel (" << x << ", " << y << ")";
    for (int c = 0; c < channels; ++c)
        stream << " | channel " << c << " is " << got.at(x, y, c) << ", expected " << expected.value[c]
               << " +- " << boundOf(got, expected, c);
    return stream.str();
}

} // namespace

Comparison compare(const Pixels& got, const ExpectedAt& expectedAt, int channels) {
    Comparison comparison;
    Largest largest;
    for (int y = 0; y < got.height; ++y) {
        for (int x = 0; x < got.width; ++x) {
            ++comparison.pixels;
            Expected expected = expectedAt(x, y, false);
            double excess = excessOf(got, x, y, expected, channels);
            if (!(excess <= 1.0)) {
                expected = expectedAt(x, y, true);
                excess = excessOf(got, x, y, expected, channels);
            }
            largest.take(got, x, y, expected, channels);
            if (excess <= 1.0) continue;
            ++comparison.outside;
            if (excess <= comparison.largestExcess) continue;
            comparison.largestExcess = excess;
            comparison.worst = texelText(got, x, y, expected, channels);
        }
    }
    comparison.largestError = largest.error;
    if (got.width > 0)
        comparison.boundThere = boundOf(got, expectedAt(largest.x, largest.y, true), largest.channel);
    return comparison;
}

void join(Comparison& all, const Comparison& other, std::string_view name) {
    all.pixels += other.pixels;
    all.outside += other.outside;
    if (other.largestError >= all.largestError) {
        all.largestError = other.largestError;
        all.boundThere = other.boundThere;
    }
    if (other.largestExcess <= all.largestExcess) return;
    all.largestExcess = other.largestExcess;
    all.worst = std::string(name) + " " + other.worst;
}

std::string text(const Comparison& comparison) {
    return std::to_string(comparison.outside) + " of " + std::to_string(comparison.pixels) +
           " pixels are outside of their bounds; the worst: " + comparison.worst;
}

} // namespace passes
