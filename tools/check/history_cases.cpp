// SPDX-License-Identifier: Apache-2.0
// exponential_history.hlsli and history_write.hlsli: the formula, and what few bits do to it.
#include "cases.hpp"
#include "harness.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using oracle::held;

const std::string exponential = "reprise/exponential_history.hlsli", write = "reprise/history_write.hlsli";

// 0, 1, 2^-k and 1 - 2^-k.
std::vector<float> weights() {
    std::vector<float> all{0.0f, 1.0f};
    for (float share : powersOfHalf(1, 24)) {
        all.push_back(share);
        all.push_back(1.0f - share);
    }
    return all;
}

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

// Ten frames a turn: llvmpipe leaves its loops after 65,535 turns, all together.
constexpr int framesInAll = 100000;
const std::string tenThousandTurns = "[loop] for (int turn = 0; turn < 10000; ++turn) {\n"
                                     "    [unroll] for (int frame = 0; frame < 10; ++frame) {\n";

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

std::vector<Row> halves() {
    std::vector<Row> rows;
    for (uint32_t bits = 0; bits < 65536; ++bits)
        rows.push_back({vec4(harness::halfToFloat(static_cast<uint16_t>(bits)))});
    return rows;
}

std::vector<Case> stored() {
    return {{"every binary16",
             {"convergenceToUnorm8", {exponential}, "out0.x = convergenceToUnorm8(in0.x);"},
             {Unit::roundings, 5.0, "a division"},
             [](const Effort&) {
                 return Sweep{halves(), [](const Row& in) {
                                  const double value = held(in[0].x, 0.0, 255.0) / 255.0;
                                  return std::vector{right(value, value)};
                              }};
             }},
            {"every binary16",
             {"convergenceFromUnorm8", {exponential}, "out0.x = convergenceFromUnorm8(in0.x);"},
             {Unit::exact, 0.0, "whole frames; open within a rounding of half a frame"},
             [](const Effort&) {
                 return Sweep{halves(), [](const Row& in) {
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

// --- steps and the law

// Every binary16 that is a number, and the binary32 beside it.
std::vector<Row> aroundEveryHalf() {
    std::vector<Row> rows;
    for (const Row& half : halves())
        if (std::isfinite(half[0].x))
            rows.push_back({vec4(half[0].x, std::nextafter(half[0].x, 0.0f),
                                 std::nextafter(half[0].x, 2.0f * half[0].x), 0)});
    return rows;
}

Case law(const std::string& function, double stepsPerMissing) {
    return {"steps 2^-24 to 32, weights 0, 1, 2^-k, 1 - 2^-k",
            {function, {write}, "out0.x = " + function + "(in0.x, in0.y);"},
            {Unit::relative, 8.0 * roundoff, "a difference and a division; at weight 1 the law of 1 - 1e-7"},
            [stepsPerMissing](const Effort& effort) {
                std::vector<Row> rows;
                for (float step : std::vector{1.0f / 255.0f} + logarithmic(0x1p-24, 32.0, effort.of(1000)))
                    for (float weight : weights())
                        rows.push_back({vec4(step, weight, 0, 0)});
                return Sweep{rows, [stepsPerMissing](const Row& in) {
                                 const double missing = std::max(1.0 - static_cast<double>(in[0].y), 1e-7);
                                 return std::vector{right(stepsPerMissing * in[0].x / missing)};
                             }};
            }};
}

// --- writes

// value, noise
std::vector<Row> noisyValues(const Effort& effort) {
    Random random(5);
    std::vector<Row> rows;
    for (const Row& half : halves())
        rows.push_back({vec4(half[0].x, random.unit(), 0, 0)});
    for (float value : beyondMarks)
        for (float noise : beyondMarks + std::vector{0.5f, 0.99999994f, notANumber})
            rows.push_back({vec4(value, noise, 0, 0)});
    for (size_t i = 0; i < effort.of(40000); ++i) {
        rows.push_back({vec4(random.colourValue() * (i % 2 == 0 ? 1.0f : -1.0f), random.unit(), 0, 0)});
        rows.push_back({vec4(random.unit(), random.unit(), 0, 0)});
    }
    return rows;
}

double heldHalf(double value) {
    return std::isnan(value) ? 0.0 : held(value, -65504.0, 65504.0);
}

// Down to the step below value + noise steps; where the sum is whole to within its rounding, to either.
Right ditheredRight(double value, double step, double noise, double slack) {
    const double position = value / step + held(noise, 0.0, 0.9998), whole = std::floor(position);
    if (std::min(position - whole, whole + 1.0 - position) < 3e-4) return open(1);
    return right(whole * step, slack);
}

std::vector<Case> writes() {
    const std::string sweep = "every binary16, to ±1e30, noise 0 to 1";
    return {
        {"every binary16 and the binary32 beside it",
         {"binary16Step",
          {write},
          "out0.xyz = float3(binary16Step(in0.x), binary16Step(in0.y), binary16Step(in0.z));"},
         {Unit::exact, 0.0, "powers of 2"},
         [](const Effort&) {
             return Sweep{aroundEveryHalf(), [](const Row& in) {
                              return std::vector{
                                  right(dvec3(oracle::binary16Step(in[0].x), oracle::binary16Step(in[0].y),
                                              oracle::binary16Step(in[0].z)))};
                          }};
         }},
        {sweep,
         {"ditheredHalf", {write}, "out0.x = ditheredHalf(in0.x, in0.y);"},
         {Unit::exact, 0.0, "multiples of a power of 2; open where the sum is whole to within 3e-4"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort), [](const Row& in) {
                              const double value = heldHalf(in[0].x);
                              return std::vector{
                                  ditheredRight(value, oracle::binary16Step(value), in[0].y, 0.0)};
                          }};
         }},
        {sweep,
         {"ditheredUnorm8", {write}, "out0.x = ditheredUnorm8(in0.x, in0.y);"},
         {Unit::roundings, 6.0, "a division by 255; open where the sum is whole to within 3e-4"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort), [](const Row& in) {
                              return std::vector{
                                  ditheredRight(held(in[0].x, 0.0, 1.0), 1.0 / 255.0, in[0].y, 1.0)};
                          }};
         }},
        {sweep,
         {"errorCarryingHalf", {write}, "out0.xy = errorCarryingHalf(in0.x);"},
         {Unit::exact, 0.0,
          "multiples of a power of 2, and exact differences; open within 3e-4 of half a step"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort), [](const Row& in) {
                              const double value = heldHalf(in[0].x);
                              const Right kept = ditheredRight(value, oracle::binary16Step(value), 0.5, 0.0);
                              if (std::isinf(kept.size.x)) return std::vector{open(2)};
                              const double rest = (value - kept.value.x) / oracle::binary16Step(kept.value.x);
                              return std::vector{right(dvec2(kept.value.x, rest))};
                          }};
         }},
        {sweep,
         {"errorCarryingUnorm8", {write}, "out0.xy = errorCarryingUnorm8(in0.x);"},
         {Unit::roundings, 6.0, "divisions by 255; open where a rounding decides a code"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort), [](const Row& in) {
                              const double value = held(in[0].x, 0.0, 1.0);
                              const Right kept = ditheredRight(value, 1.0 / 255.0, 0.5, 0.0);
                              const double code = (value - kept.value.x) * 255.0 * 254.0 + 127.0;
                              const bool decided = std::abs(code - std::floor(code) - 0.5) > 0.02;
                              if (std::isinf(kept.size.x) || !decided) return std::vector{open(2)};
                              return std::vector{
                                  right(dvec2(kept.value.x, std::floor(code + 0.5) / 255.0), 1.0)};
                          }};
         }},
        {"every binary16, to ±1e30, there and back",
         {"errorCarriedHalf", {write}, "out0.x = errorCarriedHalf(errorCarryingHalf(in0.x));"},
         {Unit::roundings, 3.0, "the value again, in three roundings of it"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort), [](const Row& in) {
                              const double value = heldHalf(in[0].x);
                              return std::vector{right(value, std::abs(value) + 1e-4)};
                          }};
         }},
        {"every binary16, to ±1e30, there and back",
         {"errorCarriedUnorm8", {write}, "out0.x = errorCarriedUnorm8(errorCarryingUnorm8(in0.x));"},
         {Unit::absolute, 0.5 / 254.0 / 255.0 + 4.0 * roundoff, "half a code of the second channel"},
         [](const Effort& effort) {
             return Sweep{noisyValues(effort),
                          [](const Row& in) { return std::vector{right(held(in[0].x, 0.0, 1.0))}; }};
         }},
        {"channels to ±1e30, NaN and infinite",
         {"errorCarriedHalf",
          {write},
          "out0.xy = float2(errorCarriedHalf(in0.xy), errorCarriedUnorm8(in0.xy));"},
         {Unit::finite, 0.0, "a history, whichever"},
         [](const Effort&) {
             std::vector<Row> rows;
             for (float a : beyondMarks + std::vector{infinity, -infinity, notANumber})
                 for (float b : beyondMarks + std::vector{infinity, -infinity, notANumber})
                     rows.push_back({vec4(a, b, 0, 0)});
             return Sweep{rows, [](const Row&) { return std::vector{open(2)}; }};
         }}};
}

// --- 100,000 frames into few bits

// How a frame's `value` becomes the history of the next.
struct Store {
    std::string function, name, body;
    double step = 0.0;
    bool isMean = false; // of the last half of the frames, instead of the last of them
    // How far the history may be off, for a weight.
    double (*residual)(double step, double weight);
};

const std::string noise =
    "seed = seed * 1664525u + 1013904223u; float noise = float(seed >> 8) / 16777216.0;\n";

std::vector<Store> storeForms() {
    const double half = 0x1p-10, unorm8 = 1.0 / 255.0; // targets lie in [1, 2), in [0, 1]
    // Beside a law stand the blend's three roundings of binary32.
    const auto nearest = [](double step, double w) {
        return (0.5 * step + 3.0 * 2.0 * roundoff) / (1.0 - w);
    };
    const auto truncated = [](double step, double w) { return (step + 3.0 * 2.0 * roundoff) / (1.0 - w); };
    // Five deviations of the mean of 50,000 values of a first-order process of errors of half a step.
    const auto mean = [](double step, double w) {
        return 2.5 * step / (1.0 - w) / std::sqrt(50000.0) + 1e-3 * step;
    };
    const auto carriedHalf = [](double step, double w) {
        return (0x1p-12 * step + 3.0 * 2.0 * roundoff) / (1.0 - w);
    };
    const auto carriedUnorm8 = [](double step, double w) {
        return (0.5 / 254.0 * step + 3.0 * 2.0 * roundoff) / (1.0 - w);
    };
    return {
        {"feedbackResidual", "binary16, to nearest",
         "uint bits = asuint(value); history = asfloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);",
         half, false, nearest},
        {"feedbackResidualTruncated", "binary16, truncated",
         "history = asfloat(asuint(value) & 0xFFFFE000u);", half, false, truncated},
        {"feedbackResidual", "8-bit unorm", "history = floor(saturate(value) * 255.0 + 0.5) / 255.0;", unorm8,
         false, nearest},
        {"ditheredHalf", "binary16, dithered: mean", noise + "history = ditheredHalf(value, noise);", half,
         true, mean},
        {"ditheredUnorm8", "8-bit unorm, dithered: mean", noise + "history = ditheredUnorm8(value, noise);",
         unorm8, true, mean},
        {"errorCarryingHalf", "binary16, error carried",
         "float2 kept = asfloat(asuint(errorCarryingHalf(value)) & 0xFFFFE000u); history = "
         "errorCarriedHalf(kept);",
         half, false, carriedHalf},
        {"errorCarryingUnorm8", "8-bit unorm, error carried",
         "float2 kept = floor(errorCarryingUnorm8(value) * 255.0 + 0.5) / 255.0; history = "
         "errorCarriedUnorm8(kept);",
         unorm8, false, carriedUnorm8}};
}

// in0: target, weight, start. The start is farther away than any residual.
Case feedback(const Store& store, bool stiffest) {
    const std::string body =
        "float history = in0.z, sum = 0.0;\nuint seed = row * 747796405u + 2891336453u;\n" +
        tenThousandTurns + "        float value = history * in0.y + in0.x * (1.0 - in0.y);\n" + store.body +
        "\n        sum += turn >= 5000 ? history - in0.x : 0.0;\n    }\n}\n"
        "out0.x = " +
        (store.isMean ? "in0.x + sum / 50000.0;" : "history;");
    const bool half = store.step < 1.0 / 512.0;
    return {"100,000 frames, " + store.name + ", weight " +
                (stiffest ? (half ? "to 1 - 2^-9" : "to 0.99") : "0.97"),
            {store.function, {write}, body},
            {Unit::roundings, 1.0, "the law of the residual: step and weight"},
            [store, stiffest, half](const Effort& effort) {
                std::vector<float> some{0.97f};
                if (stiffest) some = {0.0f, 0.5f, 0.75f, 0.9f, 0.97f, 0.99f};
                if (stiffest && half) some.push_back(1.0f - 0x1p-9f);
                Random random(6);
                std::vector<Row> rows;
                for (float weight : some)
                    for (size_t i = 0; i < effort.of(128); ++i)
                        rows.push_back({vec4(half ? random.in(1.8f, 1.9f) : random.in(0.7f, 0.8f), weight,
                                             half ? 1.0f : 0.0f, 0)});
                return Sweep{rows, [store](const Row& in) {
                                 return std::vector{right(static_cast<double>(in[0].x),
                                                          store.residual(store.step, in[0].y) / roundoff)};
                             }};
            }};
}

} // namespace

std::vector<Case> historyCases() {
    std::vector<Case> all{formula(), longFormula()};
    for (const auto& more : {steering(), stored(), subsets(), writes()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(law("feedbackResidual", 0.5));
    all.push_back(law("feedbackResidualTruncated", 1.0));
    for (const Store& store : storeForms())
        for (bool stiffest : {false, true})
            all.push_back(feedback(store, stiffest));
    return all;
}

} // namespace check
