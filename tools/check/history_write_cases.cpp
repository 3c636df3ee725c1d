// SPDX-License-Identifier: Apache-2.0
// history_write.hlsli: what few bits do to a history, and the two remedies.
#include "cases.hpp"
#include "few_bits.hpp"
#include "long_feedback.hpp"

namespace check {
namespace {

using oracle::held;

const std::string write = "reprise/history_write.hlsli";

// --- steps and the law

// Every binary16 that is a number, and the binary32 beside it.
std::vector<Row> aroundEveryHalf() {
    std::vector<Row> rows;
    for (const Row& half : justHalves())
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
    for (const Row& half : justHalves())
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
         {Unit::absolute, 0x1p-102,
          "multiples of a power of 2, and exact differences; a denormal, of steps of 2^-24, may be taken for "
          "0; open within 3e-4 of half a step"},
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

std::vector<Case> historyWriteCases() {
    std::vector<Case> all = writes();
    all.push_back(law("feedbackResidual", 0.5));
    all.push_back(law("feedbackResidualTruncated", 1.0));
    for (const Store& store : storeForms())
        for (bool stiffest : {false, true})
            all.push_back(feedback(store, stiffest));
    return all;
}

} // namespace check
