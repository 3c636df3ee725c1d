// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace functions {
namespace {

const std::string header = "reprise/exponential_history.hlsli";

// history, current, weight
Comparison history() {
    Random random(1);
    std::vector<Row> rows;
    for (float h : hostileAny)
        for (float r : hostileColour)
            for (float w : {0.0f, 0.5f, 0.9f, 0x1.fffffep-1f, 1.0f, -1.0f, 2.0f, notANumber})
                rows.push_back({vec4(h, r, w, 0.0f)});
    for (int i = 0; i < 4000; ++i)
        rows.push_back({vec4(random.colourValue(), random.colourValue(), random.unit(), 0.0f)});
    return {{"exponentialHistory",
             {header},
             "out0.xy = exponentialHistory(in0.xy, in0.yx, in0.z);"
             "out0.z = exponentialHistory(in0.x, in0.y, in0.z);"},
            rows,
            [](const Row& in) {
                // Two products, 1 - w and a sum, each at most the larger of the two.
                const double h = in[0].x, r = in[0].y, w = in[0].z;
                const double larger = std::max(std::isfinite(h) ? std::abs(h) : 0.0, std::abs(r));
                const double bound = 4.0 * roundoff * larger + flush;
                const double value = oracle::exponentialHistory(h, r, w);
                // The current value is a number by contract; here it takes the history's place, too.
                const bool both = std::isfinite(h);
                Expected expected =
                    near(dvec3(value, both ? oracle::exponentialHistory(r, h, w) : 0.0, value), bound);
                if (!both) expected.bound.y = std::numeric_limits<double>::quiet_NaN();
                return std::vector{expected};
            }};
}

TEST(ExponentialHistory, historyIsTheFormulaAndNaNIsForgotten) {
    expectAgrees(history());
}

TEST(ExponentialHistory, swappedOrUnboundedWeightsAreCaught) {
    expectCaught(history(),
                 {header, "history * w + current * (1.0 - w)", "current * w + history * (1.0 - w)"});
    expectCaught(history(), {header, "float w = bounded(weight, 0.0, 1.0);", "float w = weight;"});
}

TEST(ExponentialHistory, thePrintedProductWithABrokenHistoryIsCaught) {
    expectCaught(history(),
                 {header, "abs(history) <= LARGEST_HISTORY ? history * w + current * (1.0 - w) : current",
                  "history * w + current * (1.0 - w)"});
}

// speed, weight, slow, fast
Comparison steering() {
    Random random(2);
    std::vector<Row> rows;
    for (float speed : {0.0f, -1.0f, 1.999f, 2.0f, 8.5f, 14.999f, 15.0f, 1e6f, 1e30f, infinity, notANumber})
        rows.push_back({vec4(speed, 0.9f, 2.0f, 15.0f)});
    for (int i = 0; i < 4000; ++i) {
        const float slow = random.in(0.0f, 10.0f), fast = slow + random.in(0.01f, 20.0f);
        rows.push_back({vec4(random.in(0.0f, 40.0f), random.unit(), slow, fast)});
    }
    return {{"velocityWeight", {header}, "out0.x = velocityWeight(in0.x, in0.y, in0.z, in0.w);"},
            rows,
            [](const Row& in) {
                // Both differences are rounded at up to 40 px and divided by the range; the cubic's slope
                // is 1.5.
                const double range = static_cast<double>(in[0].w) - in[0].z;
                const double share = 2.0 * roundoff * 40.0 / range + divisionError;
                return std::vector{near(oracle::velocityWeight(in[0].x, in[0].y, in[0].z, in[0].w),
                                        1.5 * share + 6.0 * roundoff)};
            }};
}

TEST(ExponentialHistory, weightFallsSmoothlyWithSpeed) {
    expectAgrees(steering());
}

TEST(ExponentialHistory, steeringThatRisesOrHasCornersIsCaught) {
    expectCaught(steering(), {header, "bounded(fastPx - abs(speedPx), 0.0, range)",
                              "bounded(abs(speedPx) - slowPx, 0.0, range)"});
    expectCaught(steering(), {header, "room * room * (3.0 - 2.0 * room)", "room"});
}

TEST(ExponentialHistory, equalSpeedsAreAStep) {
    const auto out = run({"velocityWeight", {header}, "out0.x = velocityWeight(in0.x, 0.9, 4.0, 4.0);"},
                         {{vec4(3.99f)}, {vec4(4.01f)}});
    EXPECT_EQ(out[0][0].x, 0.9f);
    EXPECT_EQ(out[1][0].x, 0.0f);
}

// frames, confidence, maximum
Comparison convergence() {
    Random random(3);
    std::vector<Row> rows = hostileRows(hostileAny, 1, 500, 4);
    for (float frames : {0.0f, 1.0f, 7.0f, 254.0f, 255.0f, 256.0f})
        for (float confidence : {0.0f, 0.5f, 1.0f, 1.5f, -1.0f, notANumber})
            rows.push_back({vec4(frames, confidence, 0.97f, 0.0f)});
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.in(0.0f, 255.0f), random.unit(), random.unit(), 0.0f)});
    return {{"convergence",
             {header},
             "out0.x = nextConvergence(in0.x, in0.y);"
             "out0.y = convergenceWeight(in0.x, in0.z);"},
            rows,
            [](const Row& in) {
                // A product and a sum up to 255; a sum and a division up to 1.
                Expected expected = near(dvec2(oracle::nextConvergence(in[0].x, in[0].y),
                                               oracle::convergenceWeight(in[0].x, in[0].z)),
                                         2.0 * roundoff * 256.0);
                expected.bound.y = divisionError + roundoff;
                return std::vector{expected};
            }};
}

TEST(ExponentialHistory, convergenceCountsIsBoundedAndResetsOnAMiss) {
    expectAgrees(convergence());
}

TEST(ExponentialHistory, convergenceThatForgetsAMissOrItsBoundIsCaught) {
    expectCaught(convergence(), {header, "* bounded(confidence, 0.0, 1.0)", ""});
    expectCaught(convergence(), {header, "min(held + 1.0, MAX_CONVERGENCE)", "held + 1.0"});
    expectCaught(convergence(), {header, "held / (held + 1.0)", "1.0 / (held + 1.0)"});
}

// What the weight n / (n + 1) is for: ten frames, each in a row.
Comparison means() {
    Random random(5);
    std::vector<Row> rows;
    for (int i = 0; i < 200; ++i)
        rows.push_back({random.in4(0.0f, 1.0f), random.in4(0.0f, 1.0f)});
    return {{"mean of the first frames",
             {header},
             "float values[8] = {in0.x, in0.y, in0.z, in0.w, in1.x, in1.y, in1.z, in1.w};"
             "float value = 1e30, frames = 0.0;" // whatever was there before
             "for (int i = 0; i < 8; ++i) {"
             "    float confidence = i == 0 ? 0.0 : 1.0;"
             "    value = exponentialHistory(value, values[i], convergenceWeight(frames * confidence, 0.97));"
             "    frames = nextConvergence(frames, confidence);"
             "}"
             "out0.xy = float2(value, frames);",
             2},
            rows,
            [](const Row& in) {
                double sum = 0.0;
                for (const vec4& v : in)
                    sum += static_cast<double>(v.x) + v.y + v.z + v.w;
                return std::vector{near(dvec2(sum / 8.0, 8.0), 8.0 * 5.0 * roundoff)}; // eight blends
            }};
}

TEST(ExponentialHistory, historyOfTheFirstFramesIsTheirMean) {
    expectAgrees(means());
}

TEST(ExponentialHistory, weightOfAFrameTooManyIsCaught) {
    expectCaught(means(), {header, "min(held / (held + 1.0),", "min((held + 1.0) / (held + 2.0),"});
}

TEST(ExponentialHistory, eightBitsAndBinary16HoldEveryWholeConvergence) {
    std::vector<Row> frames;
    for (int i = 0; i < 256; ++i)
        frames.push_back({vec4(static_cast<float>(i))});
    const Function pack{"convergence in 8 bits", {header}, "out0 = convergenceToUnorm8(in0.x);"};
    const auto stored = run(pack, frames, {.outputFormat = "rgba8"});
    const auto back =
        run({"convergence from 8 bits", {header}, "out0.x = convergenceFromUnorm8(in0.x);"}, stored);
    const auto half = run({"convergence", {header}, "out0 = in0;"}, frames, {.outputFormat = "rgba16f"});
    for (size_t i = 0; i < 256; ++i) {
        EXPECT_EQ(back[i][0].x, static_cast<float>(i));
        EXPECT_EQ(half[i][0].x, static_cast<float>(i));
    }
}

// frame, subsets
Comparison subsets() {
    Random random(6);
    std::vector<Row> rows;
    for (int count = 1; count <= 16; ++count)
        for (int i = 0; i < 200; ++i) {
            int frame = static_cast<int>(random.below(1u << 20));
            if (i % 3 == 0) frame -= frame % count;             // its first frame
            if (i % 3 == 1) frame += count - 1 - frame % count; // its last frame
            rows.push_back({vec4(static_cast<float>(frame), static_cast<float>(count), 0.0f, 0.0f)});
        }
    return {{"subsetOfFrame", {header}, "out0.x = subsetOfFrame(in0.x, in0.y);"}, rows, [](const Row& in) {
                return std::vector{near(static_cast<int>(in[0].x) % static_cast<int>(in[0].y), 0.0)};
            }};
}

TEST(ExponentialHistory, subsetsRepeatAfterNFrames) {
    expectAgrees(subsets());
}

TEST(ExponentialHistory, subsetsThatRepeatAFrameLateAreCaught) {
    expectCaught(subsets(), {header, "float count = wholeSubsets(subsetCount);\n    float frame",
                             "float count = wholeSubsets(subsetCount) + 1.0;\n    float frame"});
    expectCaught(subsets(), {header, "floor((frame + 0.5) / count)", "floor((frame + 1.0) / count)"});
}

TEST(ExponentialHistory, aCycleTakesEverySampleOfTheSetOnce) {
    for (int count : {1, 3, 4, 16}) {
        std::vector<Row> rows;
        for (int frame = 0; frame < count; ++frame)
            for (int tap = 0; tap < 4; ++tap)
                rows.push_back({vec4(static_cast<float>(frame + 1000), static_cast<float>(tap),
                                     static_cast<float>(count), 0.0f)});
        const auto out = run({"sampleOfSubset",
                              {header},
                              "out0.x = sampleOfSubset(in0.y, subsetOfFrame(in0.x, in0.z), in0.z);"},
                             rows);
        std::set<float> taken;
        for (const Row& row : out)
            taken.insert(row[0].x);
        EXPECT_EQ(taken.size(), static_cast<size_t>(4 * count));
        EXPECT_EQ(*taken.begin(), 0.0f);
        EXPECT_EQ(*taken.rbegin(), static_cast<float>(4 * count - 1));
    }
}

// age, weight, subsets
Comparison shares() {
    std::vector<Row> rows;
    for (int count : {1, 2, 3, 4, 9, 16})
        for (float w : {0.0f, 0.5f, 0.9f, 0.97f, 0.999f, 0x1.fffffep-1f, 1.0f})
            for (int age = 0; age < count; ++age)
                rows.push_back({vec4(static_cast<float>(age), w, static_cast<float>(count), 0.0f)});
    return {
        {"cycle", {header}, "out0.xy = float2(subsetShare(in0.x, in0.y, in0.z), cycleError(in0.y, in0.z));"},
        rows,
        [](const Row& in) {
            const int age = static_cast<int>(in[0].x), count = static_cast<int>(in[0].z);
            // A power of 15 products, a sum of 16 and a division, of at most 1. The root of a sum of squares
            // is off by at most the root of the sum of their errors' squares, 4 times one.
            Expected expected =
                near(dvec2(oracle::subsetShare(age, in[0].y, count), oracle::cycleError(in[0].y, count)),
                     40.0 * roundoff);
            expected.bound.y = 4.0 * 40.0 * roundoff;
            return std::vector{expected};
        }};
}

TEST(ExponentialHistory, sharesAndErrorOfTheCycleAreTheClosedForm) {
    expectAgrees(shares());
}

TEST(ExponentialHistory, wrongClosedFormsAreCaught) {
    expectCaught(shares(), {header, "return own / sum;", "return own * (1.0 - w);"}); // as if never repeated
    expectCaught(shares(), {header, "- 1.0 / count", "- 1.0 / (count + 1.0)"});
}

// Three thousand frames on the device: figure 7.6 itself. The residual against the whole set's mean is what
// the shares say of the subsets' means.
std::string runOfCycle(const std::string& repeat) {
    return "float means[4] = {in0.x, in0.y, in0.z, in0.w};"
           "float history = 0.5;"
           "int frames = int(in1.y);"
           "for (int t = 0; t < frames; ++t)"
           "    history = exponentialHistory(history, means[int(subsetOfFrame(float(t), " +
           repeat +
           "))], in1.x);"
           "out0.x = history - dot(in0, float4(0.25, 0.25, 0.25, 0.25));"
           "for (int age = 0; age < 4; ++age)"
           "    out0.y += (subsetShare(float(age), in1.x, 4.0) - 0.25) * means[int(subsetOfFrame(in1.y - 1.0 "
           "- "
           "float(age), 4.0))];";
}

Comparison residuals(const std::string& repeat) {
    Random random(7);
    std::vector<Row> rows;
    for (float w : {0.5f, 0.8f, 0.9f, 0.97f, 0.99f})
        for (int i = 0; i < 64; ++i)
            rows.push_back(
                {random.in4(0.0f, 1.0f), vec4(w, 3000.0f + static_cast<float>(i % 4), 0.0f, 0.0f)});
    return {{"residual of the cycle", {header}, runOfCycle(repeat), 2}, rows, [](const Row& in) {
                const std::vector<double> means{in[0].x, in[0].y, in[0].z, in[0].w};
                const double mean = (means[0] + means[1] + means[2] + means[3]) / 4.0;
                const double residual =
                    oracle::historyOfCycle(means, in[1].x, static_cast<int>(in[1].y)) - mean;
                // A frame's three roundings at 1 are forgotten by w: their sum is 1 / (1 - w) times as much.
                return std::vector{near(dvec2(residual), 4.0 * roundoff / (1.0 - in[1].x) + 50.0 * roundoff)};
            }};
}

TEST(ExponentialHistory, measuredResidualOfTheCycleIsTheClosedForm) {
    expectAgrees(residuals("4.0"));
    // Standard deviation over many sets, against cycleError.
    for (float w : {0.8f, 0.9f, 0.97f}) {
        Random random(8);
        std::vector<Row> rows;
        for (int i = 0; i < 4000; ++i)
            rows.push_back({random.in4(0.0f, 1.0f), vec4(w, 1000.0f, 0.0f, 0.0f)});
        double squares = 0.0;
        for (const Row& out : run({"residual of the cycle", {header}, runOfCycle("4.0"), 2}, rows))
            squares += static_cast<double>(out[0].x) * out[0].x / static_cast<double>(rows.size());
        // Means are uniform in [0, 1]: deviation sqrt(1/12). 4000 samples know it to 1 / sqrt(8000).
        const double relative = std::sqrt(squares * 12.0), closed = oracle::cycleError(w, 4);
        measured("cycle of 4, weight " + std::to_string(w) + ", error over the subsets' deviation", relative);
        EXPECT_NEAR(relative, closed, 4.0 * closed / std::sqrt(8000.0));
    }
}

TEST(ExponentialHistory, cycleThatDoesNotRepeatAfterNIsCaught) {
    EXPECT_NE(mismatches(residuals("3.0")), "");
}

TEST(ExponentialHistory, noInputGivesNaNOrInfinity) {
    const Function all{
        "exponential history",
        {header},
        "out0 = float4(exponentialHistory(in1.x, in0.y, in0.z), velocityWeight(in0.x, in0.y, in0.z, "
        "in0.w), nextConvergence(in1.x, in1.y), convergenceWeight(in1.x, in1.y));"
        "out1 = float4(convergenceToUnorm8(in1.x), convergenceFromUnorm8(in1.x), "
        "subsetOfFrame(in1.x, in1.y), sampleOfSubset(in0.x, 0.0, in1.y));"
        "out2 = float4(subsetShare(in1.x, in1.y, in1.z), cycleError(in1.x, in1.y), 0.0, 0.0);",
        2,
        3};
    std::vector<Row> rows = hostileRows(hostileFinite, 2, 2000, 9);
    // The second input is what a history holds.
    const std::vector<Row> broken = hostileRows(hostileAny, 2, 2000, 10);
    for (size_t i = 0; i < rows.size() && i < broken.size(); ++i)
        if (i % 2 == 0) rows[i][1] = broken[i][1];
    expectNumbers(all, rows);
}

} // namespace
} // namespace functions
