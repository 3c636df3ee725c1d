// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/feedback.hlsli";

// 0, 1, 2^-k and 1 - 2^-k.
std::vector<float> weights() {
    std::vector<float> all{0.0f, 1.0f};
    for (float share : powersOfHalf(1, 24)) {
        all.push_back(share);
        all.push_back(1.0f - share);
    }
    return all;
}

const functions::Function luminanceWeight{
    "luminanceFeedback", {header}, "out0.x = luminanceFeedback(in0.x, in0.y, in0.z, in0.w);"};

std::vector<Case> luminanceFeedbacks() {
    return {{"luminances 0 to 65504, weights 0 to 1",
             luminanceWeight,
             {Unit::absolute, 2.0 * (divisionError + 2.0 * roundoff) + 5.0 * roundoff,
              "a quotient of at most 1, squared, and a lerp between weights of at most 1"},
             [](const Effort& effort) {
                 const auto values = colourValues(effort);
                 Random random(1);
                 std::vector<Row> rows;
                 for (float current : values)
                     for (float history : values)
                         for (float low : {0.0f, 0.88f, random.unit()})
                             for (float high : {1.0f, 0.97f, low})
                                 rows.push_back(
                                     {vec4(current, history, std::min(low, high), std::max(low, high))});
                 for (size_t i = 0; i < effort.of(60000); ++i)
                     rows.push_back({vec4(random.in(0.0f, 0.4f), random.in(0.0f, 0.4f), 0.88f, 0.97f)});
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{
                                      right(oracle::luminanceFeedback(in[0].x, in[0].y, in[0].z, in[0].w))};
                              }};
             }},
            {"luminances to ±1e30",
             luminanceWeight,
             {Unit::finite, 0.0, "luminances are not negative; beyond, a weight is at least finite"},
             [](const Effort& effort) {
                 std::vector<Row> rows;
                 for (float current : beyondMarks)
                     for (float history : beyondMarks)
                         rows.push_back({vec4(current, history, 0.88f, 0.97f)});
                 Random random(2);
                 for (size_t i = 0; i < effort.of(20000); ++i)
                     rows.push_back({vec4(anyValue(random), anyValue(random), 0.88f, 0.97f)});
                 return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
             }}};
}

std::vector<Right> blendOracle(const Row& in) {
    const dvec3 current = xyz(in[0]), history = xyz(in[1]);
    return {right(oracle::blendHistory(current, history, in[1].w),
                  glm::max(glm::abs(current), glm::abs(history)))};
}

std::vector<Row> blends(const std::vector<float>& values, const std::vector<float>& shares) {
    std::vector<Row> rows;
    for (float current : values)
        for (float history : values)
            for (float share : shares)
                rows.push_back({vec4(current), vec4(history, 0.5f * history, current, share)});
    return rows;
}

const functions::Function blend{
    "blendHistory", {header}, "out0.xyz = blendHistory(in0.xyz, in1.xyz, in1.w);", 2};

std::vector<Case> blending() {
    return {{"0 to 65504, weights 0, 1, 2^-k, 1 - 2^-k",
             blend,
             {Unit::roundings, 4.0, "difference, product and sum at the larger of the two colours"},
             [](const Effort& effort) {
                 return Sweep{blends(colourValues(effort), weights()), blendOracle};
             }},
            {"to ±1e30, weights 0, 1, 2^-k, 1 - 2^-k",
             blend,
             {Unit::roundings, 6.0, "the same; of opposite signs the difference is twice as large"},
             [](const Effort&) {
                 return Sweep{blends(beyondMarks, weights()), blendOracle};
             }},
            {"to ±1e30, weight 0",
             blend,
             {Unit::exact, 0.0, "the product is 0: exactly the current colour"},
             [](const Effort& effort) {
                 return Sweep{blends(beyondMarks + colourValues(effort), {0.0f}), blendOracle};
             }}};
}

// --- 100,000 frames

// One value against a current one that stands still, or that changes between two, as a jittered edge does.
// Ten frames a turn: llvmpipe leaves its loops after 65,535 turns, all together.
const int framesInAll = 100000;
const std::string manyFrames =
    "float3 history = in0.yyy;\n"
    "[loop] for (int turn = 0; turn < 10000; ++turn) {\n"
    "    [unroll] for (int frame = 0; frame < 10; ++frame)\n"
    "        history = blendHistory(frame % 2 != 0 ? in0.zzz : in0.xxx, history, in0.w);\n"
    "}\n"
    "out0.x = history.x;";

// Each frame rounds by up to four half steps at the largest of the three values, and of what it rounded
// 1 - weight is gone by the next: over all frames 1 / (1 - weight) of it, at most as many as there were.
std::vector<Right> manyFramesOracle(const Row& in) {
    const double first = in[0].x, second = in[0].z, weight = in[0].w;
    double history = in[0].y;
    for (int frame = 0; frame < framesInAll; ++frame)
        history = oracle::blendHistory(dvec3(frame % 2 != 0 ? second : first), dvec3(history), weight).x;
    const double largestValue =
        std::max({std::abs(first), std::abs(second), std::abs(static_cast<double>(in[0].y))});
    const double frames =
        weight < 1.0 ? std::min(1.0 / (1.0 - weight), double(framesInAll)) : double(framesInAll);
    return {right(history, largestValue * frames)};
}

Case longFeedback(bool alternating) {
    return {
        alternating ? "100,000 frames of two values in turn" : "100,000 frames of one value",
        {"blendHistory", {header}, manyFrames},
        {Unit::roundings, 4.0, "a frame's roundings, as often as 1 / (1 - weight) or as there were frames"},
        [alternating](const Effort& effort) {
            std::vector<Row> rows;
            const std::vector<float> values =
                effort.quick ? std::vector{0.0f, 1.0f, 65504.0f}
                             : std::vector{0.0f, 1e-7f, 0.001f, 0.2f, 1.0f, 1000.0f, 65504.0f};
            std::vector<float> shares{0.0f, 1.0f, 0.88f, 0.97f};
            for (float share : powersOfHalf(1, 24))
                shares.push_back(1.0f - share);
            for (float target : values)
                for (float start : values)
                    for (float share : shares)
                        rows.push_back({vec4(target, start, alternating ? 0.5f * start : target, share)});
            return Sweep{rows, manyFramesOracle};
        }};
}

} // namespace

std::vector<Case> feedbackCases() {
    std::vector<Case> all = luminanceFeedbacks();
    for (const auto& more : {blending(), std::vector{longFeedback(false), longFeedback(true)}})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
