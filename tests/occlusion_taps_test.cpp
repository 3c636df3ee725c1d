// SPDX-License-Identifier: Apache-2.0
// reprise::occlusionTaps: which points over a surface ambient occlusion checks in a frame.
#include "oracle/ambient_occlusion.hpp"
#include "reprise/ambient_occlusion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

namespace {

using reprise::occlusionTaps;

constexpr double roundoff = 0x1p-24;

// A point of the sequence as the pass takes it: by azimuth, by the square of the sine to the normal, and the
// number whose root is the distance.
glm::dvec4 tapOf(int index) {
    const glm::dvec3 point = oracle::sequencePoint(index);
    const double azimuth = glm::two_pi<double>() * point.x;
    return {std::sqrt(point.y) * std::cos(azimuth), std::sqrt(point.y) * std::sin(azimuth),
            std::sqrt(1.0 - point.y), point.z};
}

TEST(OcclusionTaps, areConsecutivePointsOfTheSequence) {
    for (const uint32_t samples : {1u, 2u, 4u, 8u, 12u, 16u, 32u})
        for (const uint32_t subsets : {1u, 3u, 8u, 16u})
            for (uint64_t frame = 0; frame < 2 * subsets; ++frame) {
                const auto taps = occlusionTaps(samples, frame, subsets);
                for (uint32_t i = 0; i < samples; ++i) {
                    const auto index = static_cast<int>((frame % subsets) * samples + i);
                    for (int c = 0; c < 4; ++c)
                        // Half a step of binary32 below 1; the oracle's sequence is the same in double.
                        ASSERT_NEAR(taps[i][c], tapOf(index)[c], 1.001 * roundoff)
                            << samples << " samples, frame " << frame << ", tap " << i << ", " << c;
                }
                for (size_t i = samples; i < taps.size(); ++i)
                    ASSERT_EQ(taps[i], glm::vec4(0.0f)) << "tap " << i;
            }
}

TEST(OcclusionTaps, areDirectionsOverTheSurface) {
    for (uint64_t frame = 0; frame < 16; ++frame)
        for (const glm::vec4& tap : occlusionTaps(32, frame, 16)) {
            EXPECT_LE(glm::length(glm::dvec3(tap)), 1.0 + 3.0 * roundoff);
            EXPECT_GE(glm::length(glm::dvec3(tap)), 1.0 - 3.0 * roundoff);
            EXPECT_GT(tap.z, 0.0f);
            EXPECT_GE(tap.w, 0.0f);
            EXPECT_LT(tap.w, 1.0f);
        }
}

TEST(OcclusionTaps, repeatAfterTheirSubsetsAndNotBefore) {
    for (const uint32_t subsets : {1u, 2u, 8u, 16u})
        for (uint64_t frame = 0; frame < 40; ++frame)
            for (uint64_t other = 0; other < frame; ++other)
                ASSERT_EQ(occlusionTaps(4, frame, subsets) == occlusionTaps(4, other, subsets),
                          frame % subsets == other % subsets)
                    << subsets << ": " << frame << " and " << other;
    // A frame index of any size, and counts beyond their range at its end.
    EXPECT_EQ(occlusionTaps(4, (uint64_t{1} << 60) + 3, 8), occlusionTaps(4, 3, 8));
    EXPECT_EQ(occlusionTaps(4, 17, 100), occlusionTaps(4, 1, 16));
    EXPECT_EQ(occlusionTaps(4, 5, 0), occlusionTaps(4, 0, 1));
    EXPECT_EQ(occlusionTaps(40, 1, 8), occlusionTaps(32, 1, 8));
}

// Largest difference between the share of points below a number and the number, of azimuth, of the square of
// the sine, which is uniform for a density as the cosine, and of the radial number.
double discrepancy(const std::vector<glm::vec4>& taps) {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> numbers;
        for (const glm::vec4& tap : taps)
            numbers.push_back(axis == 0   ? glm::fract(std::atan2(tap.y, tap.x) / glm::two_pi<double>() + 1.0)
                              : axis == 1 ? double(tap.x) * tap.x + double(tap.y) * tap.y
                                          : tap.w);
        std::ranges::sort(numbers);
        for (size_t i = 0; i < numbers.size(); ++i) {
            const double below = double(i) / double(numbers.size()),
                         upTo = double(i + 1) / double(numbers.size());
            largest = std::max({largest, std::abs(numbers[i] - below), std::abs(numbers[i] - upTo)});
        }
    }
    return largest;
}

// Of a frame, and of all of a cycle together: n numbers at equal distances are off by at most 1 / n, as many
// independent ones by 0.4 for four, 0.1 for 64 and 0.04 for 512 in the mean.
TEST(OcclusionTaps, areSpreadInAFrameAndOverACycle) {
    for (const uint32_t samples : {4u, 32u}) {
        std::vector<glm::vec4> cycle;
        for (uint64_t frame = 0; frame < 16; ++frame) {
            const auto taps = occlusionTaps(samples, frame, 16);
            const std::vector<glm::vec4> own(taps.begin(), taps.begin() + samples);
            EXPECT_LE(discrepancy(own), samples == 4 ? 0.5 : 0.25) << "frame " << frame;
            cycle.insert(cycle.end(), own.begin(), own.end());
        }
        EXPECT_LE(discrepancy(cycle), samples == 4 ? 0.05 : 0.02);
    }
}

} // namespace
