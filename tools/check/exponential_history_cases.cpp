// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "few_bits.hpp"
#include "long_feedback.hpp"

namespace check {
namespace {

using oracle::held;

const std::string exponential = "reprise/exponential_history.hlsli";

// --- the formula

std::vector<Row> histories(const Effort& effort) {
    const auto values = colourValues(effort) + std::vector{65520.0f, 1e30f, -1.0f, -1e30f};
    std::vector<Row> rows;
    for (float history : values + std::vector{infinity, -infinity, notANumber})
        for (float current : values)
            for (float weight : weights() + std::vector{-1.0f, 2.0f, notANumber})
                rows.push_back({vec4(history, current, weight, 0.0f)});
    return rows;
}

std::vector<Right> historyOracle(const Row& in) {
    const double history = in[0].x, current = in[0].y;
    const double larger = std::max(std::isfinite(history) ? std::abs(history) : 0.0, std::abs(current));
    const Right one = right(oracle::exponentialHistory(history, current, in[0].z), larger);
    return {one, {dvec4(one.value.x, one.value.x, 0, 0), dvec4(larger), 2}};
}

Case formula() {
    Case made{"to ±1e30, NaN and infinite, weights 0, 1, 2^-k, 1 - 2^-k",
              {"exponentialHistory",
               {exponential},
               "out0.x = exponentialHistory(in0.x, in0.y, in0.z);\n"
               "out1.xy = exponentialHistory(in0.xx, in0.yy, in0.z);",
               1,
               2},
              {Unit::roundings, 4.0, "two products, 1 - w and a sum at the larger of the two"},
              [](const Effort& effort) {
                  return Sweep{histories(effort), historyOracle};
              }};
    made.printed = {"Drobot, h(t)", "out0.x = in0.x * in0.z + in0.y * (1.0 - in0.z); out1.xy = out0.xx;", ""};
    return made;
}

Case longFormula() {
    return {
        "100,000 frames of two values in turn",
        {"exponentialHistory",
         {exponential},
         "float history = in0.y;\n" + tenThousandTurns +
             "        history = exponentialHistory(history, frame % 2 != 0 ? in0.z : in0.x, in0.w);\n"
             "    }\n}\nout0.x = history;"},
        {Unit::roundings, 4.0, "a frame's roundings, as often as 1 / (1 - weight) or as there were frames"},
        [](const Effort& effort) {
            const auto values = effort.quick
                                    ? std::vector{0.0f, 1.0f, 65504.0f}
                                    : std::vector{0.0f, 1e-7f, 0.001f, 0.2f, 1.0f, 1000.0f, 65504.0f};
            std::vector<Row> rows;
            for (float target : values)
                for (float start : values)
                    for (float weight : weights())
                        rows.push_back({vec4(target, start, 0.5f * start, weight)});
            return Sweep{rows, [](const Row& in) {
                             const double weight = in[0].w;
                             double history = in[0].y;
                             for (int frame = 0; frame < framesInAll; ++frame)
                                 history = oracle::exponentialHistory(
                                     history, frame % 2 != 0 ? in[0].z : in[0].x, weight);
                             const double frames = weight < 1.0
                                                       ? std::min(1.0 / (1.0 - weight), double(framesInAll))
                                                       : framesInAll;
                             return std::vector{right(history, std::max(in[0].x, in[0].y) * frames)};
                         }};
        }};
}

// --- steering

std::vector<Case> steering() {
    return {{"speed 0, 1e-12 to 1e6 px, NaN, infinite",
             {"velocityWeight", {exponential}, "out0.x = velocityWeight(in0.x, in0.y, in0.z, in0.w);"},
             {Unit::roundings, 8.0,
              "a difference at the fast speed over the range, a quotient and a cubic of slope 1.5"},
             [](const Effort& effort) {
                 const auto speeds =
                     ofBothSigns(std::vector{0.0f, 1e-40f, 2.0f, 15.0f, 1e30f, infinity, notANumber} +
                                 logarithmic(1e-12, 1e6, effort.of(10000)));
                 Random random(1);
                 std::vector<Row> rows;
                 for (float speed : speeds)
                     for (int i = 0; i < 4; ++i) {
                         const float slow = random.in(0.0f, 10.0f);
                         rows.push_back(
                             {vec4(speed, random.unit(), slow, slow + std::exp2(random.in(-4.0f, 6.0f)))});
                     }
                 return Sweep{rows, [](const Row& in) {
                                  const double range = static_cast<double>(in[0].w) - in[0].z;
                                  return std::vector{
                                      right(oracle::velocityWeight(in[0].x, in[0].y, in[0].z, in[0].w),
                                            2.0 + in[0].w / range)};
                              }};
             }},
            {"frames and confidence to ±1e30, NaN, infinite",
             {"nextConvergence", {exponential}, "out0.x = nextConvergence(in0.x, in0.y);"},
             {Unit::roundings, 2.0, "a product and a sum up to 256"},
             [](const Effort& effort) {
                 const auto values = beyondMarks + std::vector{0.5f,   0.97f,  7.0f,     254.0f,
                                                               255.0f, 256.0f, infinity, notANumber};
                 Random random(2);
                 std::vector<Row> rows;
                 for (float frames : values)
                     for (float confidence : values)
                         rows.push_back({vec4(frames, confidence, 0, 0)});
                 for (size_t i = 0; i < effort.of(40000); ++i)
                     rows.push_back({vec4(random.in(0.0f, 256.0f), random.unit(), 0, 0)});
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{right(oracle::nextConvergence(in[0].x, in[0].y), 256.0)};
                              }};
             }},
            {"frames to ±1e30, NaN, weights 0, 1, 1 - 2^-k",
             {"convergenceWeight", {exponential}, "out0.x = convergenceWeight(in0.x, in0.y);"},
             {Unit::roundings, 7.0, "a sum and a division below 1"},
             [](const Effort& effort) {
                 std::vector<Row> rows;
                 for (float frames : beyondMarks + std::vector{infinity, notANumber} +
                                         logarithmic(1e-12, 300.0, effort.of(1000)))
                     for (float most : weights() + std::vector{-1.0f, 2.0f, notANumber})
                         rows.push_back({vec4(frames, most, 0, 0)});
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{right(oracle::convergenceWeight(in[0].x, in[0].y), 1.0)};
                              }};
             }}};
}

std::vector<Case> stored() {
    return {{"every binary16",
             {"convergenceToUnorm8", {exponential}, "out0.x = convergenceToUnorm8(in0.x);"},
             {Unit::roundings, 5.0, "a division"},
             [](const Effort&) {
                 return Sweep{justHalves(), [](const Row& in) {
                                  const double value = held(in[0].x, 0.0, 255.0) / 255.0;
                                  return std::vector{right(value, value)};
                              }};
             }},
            {"every binary16",
             {"convergenceFromUnorm8", {exponential}, "out0.x = convergenceFromUnorm8(in0.x);"},
             {Unit::exact, 0.0, "whole frames; open within a rounding of half a frame"},
             [](const Effort&) {
                 return Sweep{justHalves(), [](const Row& in) {
                                  const double frames = held(in[0].x, 0.0, 1.0) * 255.0;
                                  if (std::abs(frames - std::floor(frames) - 0.5) < 1e-4)
                                      return std::vector{open(1)};
                                  return std::vector{right(std::floor(frames + 0.5))};
                              }};
             }}};
}

// --- subsets

// frame or tap, subset count, weight
std::vector<Row> cycles(const Effort& effort) {
    Random random(3);
    std::vector<Row> rows;
    for (int count = 1; count <= 16; ++count)
        for (size_t i = 0; i < effort.of(2500); ++i) {
            int frame = static_cast<int>(random.below(1u << 20));
            if (i % 3 == 0) frame -= frame % count;
            if (i % 3 == 1) frame += count - 1 - frame % count;
            rows.push_back(
                {vec4(std::min(frame, 1 << 20), count, random.below(static_cast<size_t>(count)), 0)});
        }
    return rows;
}

std::vector<Row> shares() {
    std::vector<Row> rows;
    for (int count = 1; count <= 16; ++count)
        for (float weight : weights())
            for (int age = 0; age < count; ++age)
                rows.push_back({vec4(age, weight, count, 0)});
    return rows;
}

std::vector<Case> subsets() {
    const Bound whole{Unit::exact, 0.0, "whole numbers"};
    return {
        {"counts to ±1e30, NaN",
         {"wholeSubsets", {exponential}, "out0.x = wholeSubsets(in0.x);"},
         whole,
         [](const Effort& effort) {
             std::vector<Row> rows;
             for (float count : beyondMarks + std::vector{infinity, -infinity, notANumber} +
                                    logarithmic(0.1, 100.0, effort.of(20000)))
                 rows.push_back({vec4(count)});
             return Sweep{rows, [](const Row& in) {
                              return std::vector{
                                  right(held(std::floor(static_cast<double>(in[0].x)), 1.0, 16.0))};
                          }};
         }},
        {"frames to 2^20, 1 to 16 subsets",
         {"subsetOfFrame", {exponential}, "out0.x = subsetOfFrame(in0.x, in0.y);"},
         whole,
         [](const Effort& effort) {
             return Sweep{cycles(effort), [](const Row& in) {
                              return std::vector{
                                  right(static_cast<int>(in[0].x) % static_cast<int>(in[0].y))};
                          }};
         }},
        {"taps to 2^20, 1 to 16 subsets",
         {"sampleOfSubset", {exponential}, "out0.x = sampleOfSubset(in0.x, in0.z, in0.y);"},
         whole,
         [](const Effort& effort) {
             return Sweep{cycles(effort), [](const Row& in) {
                              return std::vector{right(static_cast<double>(in[0].x) * in[0].y + in[0].z)};
                          }};
         }},
        {"1 to 16 subsets, weights 0, 1, 2^-k, 1 - 2^-k",
         {"subsetShare", {exponential}, "out0.x = subsetShare(in0.x, in0.y, in0.z);"},
         {Unit::absolute, 40.0 * roundoff, "powers of 15 products, a sum of 16 and a division, of at most 1"},
         [](const Effort&) {
             return Sweep{shares(), [](const Row& in) {
                              return std::vector{right(oracle::subsetShare(static_cast<int>(in[0].x), in[0].y,
                                                                           static_cast<int>(in[0].z)))};
                          }};
         }},
        {"1 to 16 subsets, weights 0, 1, 2^-k, 1 - 2^-k",
         {"cycleError", {exponential}, "out0.x = cycleError(in0.y, in0.z);"},
         {Unit::absolute, 160.0 * roundoff, "the root of a sum of 16 squares of such"},
         [](const Effort&) {
             return Sweep{shares(), [](const Row& in) {
                              return std::vector{
                                  right(oracle::cycleError(in[0].y, static_cast<int>(in[0].z)))};
                          }};
         }},
        {"all to ±1e30, NaN in what a history holds",
         {"subsetShare",
          {exponential},
          "out0 = float4(subsetOfFrame(in0.x, in0.y), subsetShare(in0.x, in0.z, in0.y), cycleError(in0.z, "
          "in0.y),\n"
          "              velocityWeight(in0.x, in0.y, in0.z, in0.w));"},
         {Unit::finite, 0.0, "a subset, a share, an error or a weight, whichever"},
         [](const Effort& effort) {
             const auto values = beyondMarks + std::vector{infinity, notANumber};
             Random random(4);
             std::vector<Row> rows;
             for (size_t i = 0; i < effort.of(20000); ++i)
                 rows.push_back(
                     {vec4(random.of(values), anyValue(random), random.of(values), anyValue(random))});
             return Sweep{rows, [](const Row&) { return std::vector{open(4)}; }};
         }}};
}

} // namespace

std::vector<Case> exponentialHistoryCases() {
    std::vector<Case> all{formula(), longFormula()};
    for (const auto& more : {steering(), stored(), subsets()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
