// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/feedback.hlsli";

std::vector<Row> luminances(uint32_t seed) {
    std::vector<Row> rows;
    for (float current : hostileColour)
        for (float history : hostileColour)
            rows.push_back({vec4(current, history, 0.88f, 0.97f)});
    Random random(seed);
    for (int i = 0; i < 3000; ++i) {
        const float low = random.unit(), high = low + (1.0f - low) * random.unit();
        rows.push_back({vec4(random.colourValue(), random.colourValue(), low, high)});
        rows.push_back({vec4(random.in(0.0f, 0.4f), random.in(0.0f, 0.4f), low, high)});
    }
    return rows;
}

Comparison feedback() {
    // The quotient of at most 1 has a division and a rounding; one minus it, squared, doubles that; the lerp
    // multiplies by at most 1 and has three roundings at 1.
    return {{"luminanceFeedback", {header}, "out0.x = luminanceFeedback(in0.x, in0.y, in0.z, in0.w);"},
            luminances(1),
            [](const Row& in) {
                return std::vector{near(oracle::luminanceFeedback(in[0].x, in[0].y, in[0].z, in[0].w),
                                        2.0 * (divisionError + 2.0 * roundoff) + 5.0 * roundoff)};
            }};
}

TEST(Feedback, weightFallsWithTheSquareOfTheDifference) {
    expectAgrees(feedback());
}

TEST(Feedback, wrongWeightsAreCaught) {
    expectCaught(feedback(), {header, "agreement * agreement", "agreement"});
    expectCaught(feedback(), {header, "lerp(weightMin, weightMax,", "lerp(weightMax, weightMin,"});
    expectCaught(feedback(),
                 {header, "max(max(currentLuminance, historyLuminance), FEEDBACK_LUMINANCE_FLOOR)",
                  "max(currentLuminance, historyLuminance)"});
}

TEST(Feedback, weightStaysBetweenItsEnds) {
    const auto rows = luminances(2);
    const auto out =
        run({"luminanceFeedback", {header}, "out0.x = luminanceFeedback(in0.x, in0.y, in0.z, in0.w);"}, rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        // The lerp may pass an end by the rounding of its last sum.
        EXPECT_GE(out[i][0].x, rows[i][0].z - 2.0 * roundoff) << i;
        EXPECT_LE(out[i][0].x, rows[i][0].w + 2.0 * roundoff) << i;
    }
}

Comparison blending() {
    Random random(3);
    std::vector<Row> rows;
    for (const Row& current : triples(hostileColour))
        rows.push_back({current[0], vec4(random.colourValue(), 0.0f, 65504.0f,
                                         random.of(std::vector{0.0f, 0.9f, 1.0f}))});
    for (int i = 0; i < 3000; ++i) {
        vec4 history = random.colour();
        history.w = random.unit();
        rows.push_back({random.colour(), history});
    }
    // Difference, product and sum, each at most the larger of the two colours.
    return {{"blendHistory", {header}, "out0.xyz = blendHistory(in0.xyz, in1.xyz, in1.w);", 2},
            rows,
            [](const Row& in) {
                const dvec3 current = xyz(in[0]), history = xyz(in[1]);
                return std::vector{near(oracle::blendHistory(current, history, in[1].w),
                                        4.0 * roundoff * glm::max(current, history) + flush)};
            }};
}

TEST(Feedback, blendIsALerp) {
    expectAgrees(blending());
}

TEST(Feedback, blendTowardsTheCurrentColourIsCaught) {
    expectCaught(blending(),
                 {header, "(history - current) * weight", "(history - current) * (1.0 - weight)"});
}

TEST(Feedback, blendAtWeightZeroIsExactlyTheCurrentColour) {
    Random random(4);
    std::vector<Row> rows;
    for (float value : hostileFinite)
        rows.push_back({random.colour(), vec4(value)});
    const auto out =
        run({"blendHistory", {header}, "out0.xyz = blendHistory(in0.xyz, in1.xyz, 0.0 * in0.w);", 2}, rows);
    for (size_t i = 0; i < rows.size(); ++i)
        EXPECT_EQ(xyz(out[i][0]), xyz(rows[i][0])) << "history " << rows[i][1].x;
}

} // namespace
} // namespace functions
