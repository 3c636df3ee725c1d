// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include "harness.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/history_write.hlsli";

// Every binary16 that is a number, and the binary32 beside it.
std::vector<Row> aroundEveryHalf() {
    std::vector<Row> rows;
    for (uint32_t bits = 0; bits < 65536; ++bits) {
        const float value = harness::halfToFloat(static_cast<uint16_t>(bits));
        if (!std::isfinite(value)) continue;
        rows.push_back({vec4(value, std::nextafter(value, 0.0f), std::nextafter(value, 2.0f * value), 0.0f)});
    }
    return rows;
}

Comparison steps() {
    return {{"binary16Step",
             {header},
             "out0.xyz = float3(binary16Step(in0.x), binary16Step(in0.y), binary16Step(in0.z));"},
            aroundEveryHalf(),
            [](const Row& in) { // powers of 2: exact
                return std::vector{near(dvec3(oracle::binary16Step(in[0].x), oracle::binary16Step(in[0].y),
                                              oracle::binary16Step(in[0].z)),
                                        0.0)};
            }};
}

TEST(HistoryWrite, stepIsTheDistanceOfNeighbouringHalfs) {
    expectAgrees(steps());
    for (uint16_t bits = 0; bits < 0x7bff; ++bits) { // the oracle, against the bits themselves
        const double value = harness::halfToFloat(bits), next = harness::halfToFloat(bits + 1);
        ASSERT_EQ(oracle::binary16Step(value), next - value) << bits;
    }
}

TEST(HistoryWrite, wrongStepsAreCaught) {
    expectCaught(steps(), {header, "return power / 1024.0;", "return power / 2048.0;"});
    expectCaught(steps(), {header, "power *= magnitude >= power * 4.0 ? 4.0 : 1.0;", ""});
    expectCaught(steps(), {header, "magnitude >= power * 2.0 ?", "magnitude > power * 2.0 ?"});
    expectCaught(steps(), {header, "float power = 0.00006103515625;",
                           "float power = 0.000030517578125;"}); // subnormals
}

// value, noise
std::vector<Row> noisyValues() {
    Random random(1);
    std::vector<Row> rows;
    for (float value : {0.0f, 1.0f, -1.0f, 2047.0f, 65504.0f, -65504.0f, 1e30f, -1e30f, 6e-8f, 0x1.ffcp-1f})
        for (float noise : {0.0f, 0.5f, 0.99999994f})
            rows.push_back({vec4(value, noise, 0.0f, 0.0f)});
    for (int i = 0; i < 20000; ++i)
        rows.push_back({vec4(random.colourValue() * (i % 2 == 0 ? 1.0f : -1.0f), random.unit(), 0.0f, 0.0f)});
    return rows;
}

// What is written lies on the format, and rounds as the noise says: down to the step below value + noise
// steps.
Comparison dithering(bool half) {
    return {{half ? "ditheredHalf" : "ditheredUnorm8",
             {header},
             half ? "out0.x = ditheredHalf(in0.x, in0.y);" : "out0.x = ditheredUnorm8(in0.x, in0.y);"},
            noisyValues(),
            [half](const Row& in) {
                const double value =
                    half ? oracle::held(in[0].x, -65504.0, 65504.0) : oracle::held(in[0].x, 0.0, 1.0);
                const double step = half ? oracle::binary16Step(value) : 1.0 / 255.0;
                const double position = value / step + std::min(in[0].y, 0.9998f);
                // Onto the step below; where the sum is a whole number to within its rounding, onto either.
                const double whole = std::floor(position),
                             beside = std::min(position - whole, whole + 1.0 - position);
                const double slack = beside < 3e-4 ? step : half ? 0.0 : 4.0 * roundoff;
                return std::vector{near(whole * step, slack)};
            }};
}

TEST(HistoryWrite, ditheredValuesLieOnTheFormat) {
    expectAgrees(dithering(true));
    expectAgrees(dithering(false));
}

TEST(HistoryWrite, wrongDitheringIsCaught) {
    expectCaught(dithering(true),
                 {header, "known / stepSize + bounded(noise, 0.0, LARGEST_NOISE)", "known / stepSize + 0.5"});
    expectCaught(dithering(true), {header, "known / stepSize + bounded", "known / stepSize - bounded"});
    expectCaught(dithering(false), {header, "* 255.0 + bounded(noise, 0.0, LARGEST_NOISE)) / 255.0",
                                    "* 256.0 + bounded(noise, 0.0, LARGEST_NOISE)) / 256.0"});
    expectCaught(dithering(true),
                 {header, "(value < 0.0 ? -1.0 : 1.0);\n    float stepSize", "1.0;\n    float stepSize"});
}

// Whether the device's stores leave what the functions return as it is, and which way they round other
// values: what the loops below take for a store is the device's own.
TEST(HistoryWrite, deviceStoresWhatTheFunctionsReturnAsItIs) {
    const std::vector<Row> rows = noisyValues();
    const std::string dithered = "out0 = float4(ditheredHalf(in0.x, in0.y), errorCarryingHalf(in0.x), 0.0);";
    const auto exact = run({"dithered", {header}, dithered}, rows);
    const auto stored = run({"dithered", {header}, dithered}, rows, {.outputFormat = "rgba16f"});
    for (size_t i = 0; i < rows.size(); ++i)
        ASSERT_EQ(xy(stored[i][0]), xy(exact[i][0])) << rows[i][0].x;
    const std::string coded = "out0 = float4(ditheredUnorm8(in0.x, in0.y), errorCarryingUnorm8(in0.x), 0.0);";
    const auto exactCodes = run({"codes", {header}, coded}, rows);
    const auto storedCodes = run({"codes", {header}, coded}, rows, {.outputFormat = "rgba8"});
    for (size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float codes = exactCodes[i][0][c] * 255.0f;
            ASSERT_NEAR(codes, std::round(codes), 1e-4f) << i;
            ASSERT_EQ(std::lround(storedCodes[i][0][c] * 255.0f), std::lround(codes)) << i;
        }
}

struct Rounding {
    size_t nearest = 0, truncated = 0, other = 0;
};

Rounding roundingOf(const std::vector<float>& values, const std::vector<double>& results) {
    Rounding rounding;
    for (size_t i = 0; i < values.size(); ++i) {
        const double nearest = oracle::nearestBinary16(values[i]),
                     truncated = oracle::truncatedBinary16(values[i]);
        if (nearest == truncated) {
            EXPECT_EQ(results[i], nearest) << values[i];
            continue;
        }
        ++(results[i] == nearest     ? rounding.nearest
           : results[i] == truncated ? rounding.truncated
                                     : rounding.other);
    }
    return rounding;
}

TEST(HistoryWrite, emulatedStoresAreTheDevicesOwn) {
    Random random(2);
    std::vector<Row> rows;
    std::vector<float> values;
    for (int i = 0; i < 8192; ++i) {
        values.push_back(random.colourValue());
        rows.push_back({vec4(values.back(), 0.0f, 0.0f, 0.0f)});
    }
    const auto column = [&](const std::vector<Row>& out, int c) {
        std::vector<double> results;
        for (size_t i = 0; i < values.size(); ++i)
            results.push_back(out[i][0][c]);
        return results;
    };
    const auto stored = run({"store", {header}, "out0 = in0;"}, rows, {.outputFormat = "rgba16f"});
    // A colour target of the rasteriser: its values come from the pixel.
    const int side = 64;
    const std::string ofPixel = "float value = exp2(positionPx.x * 0.3 - 8.0) * (1.0 + positionPx.y / 97.0);";
    const Function pixel{"target", {header}, ofPixel + "out0 = value;", 0, 1, {}, reprise::Stage::fragment};
    const auto written = run(pixel, {}, {.extent = {side, side}, .outputFormat = "rgba16f"});
    std::vector<float> pixelValues;
    std::vector<double> pixelResults;
    for (const Row& row : run(pixel, {}, {.extent = {side, side}}))
        pixelValues.push_back(row[0].x);
    for (const Row& row : written)
        pixelResults.push_back(row[0].x);
    const Rounding byTarget = roundingOf(pixelValues, pixelResults);
    const auto emulated =
        run({"emulation",
             {header},
             "out0 = float4(f16tof32(f32tof16(in0.x)), asfloat(asuint(in0.x) & 0xFFFFE000u), 0, 0);"},
            rows);
    const Rounding byStore = roundingOf(values, column(stored, 0)),
                   byBuiltIn = roundingOf(values, column(emulated, 0)),
                   byMask = roundingOf(values, column(emulated, 1));
    measured("binary16 image store, share rounded to nearest",
             static_cast<double>(byStore.nearest) /
                 static_cast<double>(byStore.nearest + byStore.truncated + byStore.other));
    measured("f32tof16, share rounded to nearest",
             static_cast<double>(byBuiltIn.nearest) /
                 static_cast<double>(byBuiltIn.nearest + byBuiltIn.truncated + byBuiltIn.other));
    measured("binary16 colour target, share rounded to nearest",
             static_cast<double>(byTarget.nearest) /
                 static_cast<double>(byTarget.nearest + byTarget.truncated + byTarget.other));
    // One of the two laws is the device's, in each of its ways to store; both are measured below.
    for (const Rounding& each : {byStore, byTarget, byBuiltIn}) {
        EXPECT_EQ(each.other, 0u);
        EXPECT_TRUE(each.nearest == 0 || each.truncated == 0);
        EXPECT_GT(each.nearest + each.truncated, 1000u);
    }
    EXPECT_EQ(byMask.nearest + byMask.other, 0u);
}

// A frame: h w + r (1 - w), and the store.
const std::string blend = "float value = history * weight + target * (1.0 - weight);";
const std::string noise =
    "seed = seed * 1664525u + 1013904223u; float noise = float(seed >> 8) / 16777216.0;";

struct Store {
    std::string name, body;
};
const Store halfNearest{"binary16, to nearest", "history = f16tof32(f32tof16(value));"};
const Store halfTruncated{"binary16, truncated", "history = asfloat(asuint(value) & 0xFFFFE000u);"};
const Store unorm8{"8-bit unorm", "history = floor(saturate(value) * 255.0 + 0.5) / 255.0;"};
const Store halfDithered{"binary16, dithered", noise + "history = ditheredHalf(value, noise);"};
const Store unorm8Dithered{"8-bit unorm, dithered", noise + "history = ditheredUnorm8(value, noise);"};
// Both channels go through a store that truncates, the less kind one.
const Store halfCarrying{"binary16, error carried",
                         "float2 kept = errorCarryingHalf(value);"
                         "kept = asfloat(asuint(kept) & 0xFFFFE000u); history = errorCarriedHalf(kept);"};
const Store unorm8Carrying{"8-bit unorm, error carried",
                           "float2 kept = floor(errorCarryingUnorm8(value) * 255.0 + 0.5) / 255.0;"
                           "history = errorCarriedUnorm8(kept);"};

// in0: target, weight, start, frames. out0: the last history, and of the second half of the frames the mean
// difference to the target and its root mean square.
Function feedbackThrough(const Store& store) {
    return {store.name,
            {header},
            "float target = in0.x, weight = in0.y, history = in0.z;"
            "int frames = int(in0.w);"
            "uint seed = row * 747796405u + 2891336453u;"
            "float sum = 0.0, squares = 0.0, counted = 0.0;"
            "for (int frame = 0; frame < frames; ++frame) {" +
                blend + store.body +
                "    float late = frame * 2 >= frames ? 1.0 : 0.0, difference = (history - target) * late;"
                "    sum += difference; squares += difference * difference; counted += late;"
                "}"
                "out0 = float4(history, sum / counted, sqrt(squares / counted), counted);"};
}

constexpr float frames = 100000.0f;

// Targets within [1, 2), where binary16 has one step, 2^-10; the start is farther away than any residual.
std::vector<Row> rising(bool half) {
    Random random(3);
    std::vector<Row> rows;
    for (float weight : {0.5f, 0.75f, 0.9f, 0.97f, 0.99f, 1.0f - 0x1p-9f})
        for (int i = 0; i < 16; ++i)
            if (half || weight <= 0.99f)
                rows.push_back({vec4(half ? random.in(1.8f, 1.9f) : random.in(0.7f, 0.8f), weight,
                                     half ? 1.0f : 0.0f, frames)});
    return rows;
}

std::vector<Row> falling() {
    std::vector<Row> rows = rising(true);
    for (Row& row : rows) {
        row[0].x -= 0.7f; // 1.1 to 1.2
        row[0].z = 1.999f;
    }
    return rows;
}

double stepOf(bool half) {
    return half ? 0x1p-10 : 1.0 / 255.0;
}

// The history comes nearer by at least a step while the residual is above the law's, so that it stops within
// a step below: (law - step, law]. The blend's three roundings of binary32 shift that by 2^-12 of a step over
// 1 - w.
void expectLaw(const Store& store, const std::vector<Row>& rows, bool half, double stepsPerMissing) {
    const auto out = run(feedbackThrough(store), rows);
    double worst = 0.0, worstSteps = 0.0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const double weight = rows[i][0].y, step = stepOf(half),
                     law = stepsPerMissing * step / (1.0 - weight);
        const double residual = std::abs(static_cast<double>(out[i][0].x) - rows[i][0].x);
        const double slack = 0x1p-11 * step / (1.0 - weight);
        EXPECT_LE(residual, law + slack)
            << store.name << ", weight " << weight << ", target " << rows[i][0].x;
        EXPECT_GT(residual, law - step - slack)
            << store.name << ", weight " << weight << ", target " << rows[i][0].x;
        if (rows[i][0].y == 0.97f)
            worst = std::max(worst, residual), worstSteps = std::max(worstSteps, residual / step);
    }
    measured(store.name + ", residual after 100000 frames at weight 0.97", worst);
    measured(store.name + ", the same in steps", worstSteps);
}

TEST(HistoryWrite, storedHistoryStopsShortOfItsTargetByTheLaw) {
    expectLaw(halfNearest, rising(true), true, 0.5);
    expectLaw(halfNearest, falling(), true, 0.5);
    expectLaw(halfTruncated, rising(true), true, 1.0);
    expectLaw(unorm8, rising(false), false, 0.5);
}

// From above a store that truncates goes down in every frame, past the target by less than a step.
TEST(HistoryWrite, truncatedHistoryReachesATargetBelow) {
    const auto rows = falling(), out = run(feedbackThrough(halfTruncated), rows);
    for (size_t i = 0; i < rows.size(); ++i)
        EXPECT_LE(std::abs(out[i][0].x - rows[i][0].x), stepOf(true)) << rows[i][0].y;
}

TEST(HistoryWrite, lawIsAFunction) {
    const Function law{
        "feedbackResidual",
        {header},
        "out0.xyz = float3(feedbackResidual(in0.x, in0.y), feedbackResidualTruncated(in0.x, in0.y), "
        "feedbackResidual(UNORM8_STEP, in0.y));"};
    const Comparison comparison{law, rising(true), [](const Row& in) {
                                    const double missing = 1.0 - static_cast<double>(in[0].y);
                                    const dvec3 value = dvec3(0.5 * in[0].x, in[0].x, 0.5 / 255.0) / missing;
                                    return std::vector{near(value, 2.0 * divisionError * value)};
                                }};
    expectAgrees(comparison);
    expectCaught(comparison, {header, "return 0.5 * stepSize", "return stepSize"});
}

// The frames of the loops above, through images of the device: the same history, bit for bit.
TEST(HistoryWrite, feedbackThroughTheDevicesImagesIsTheEmulatedOne) {
    for (const bool half : {true, false}) {
        std::vector<Row> rows = rising(half);
        const Function frame{"frame",
                             {header},
                             "float history = in0.x, target = in1.x, weight = in1.y;" + blend +
                                 "out0 = value;",
                             2};
        std::vector<Row> state, emulated = rows;
        for (const Row& row : rows)
            state.push_back({vec4(row[0].z), row[0]});
        for (int i = 0; i < 24; ++i) {
            const auto out = run(frame, state, {.outputFormat = half ? "rgba16f" : "rgba8"});
            for (size_t k = 0; k < state.size(); ++k)
                state[k][0] = out[k][0];
        }
        for (Row& row : emulated)
            row[0].w = 24.0f;
        const auto nearest = run(feedbackThrough(half ? halfNearest : unorm8), emulated),
                   truncated = run(feedbackThrough(half ? halfTruncated : unorm8), emulated);
        size_t asNearest = 0, asTruncated = 0;
        for (size_t k = 0; k < state.size(); ++k) {
            asNearest += std::abs(state[k][0].x - nearest[k][0].x) <= roundoff; // unorm8: code / 255, rounded
            asTruncated += std::abs(state[k][0].x - truncated[k][0].x) <= roundoff;
        }
        EXPECT_EQ(std::max(asNearest, asTruncated), state.size()) << (half ? "binary16" : "8 bits");
    }
}

// Unbiased noise: the mean over frames is the target, with the deviation of a first-order process of rounding
// errors of at most half a step, step / 2 / sqrt(1 - w^2), about it.
std::string offDither(const Store& store, bool half, const Mutation& mutation = {}) {
    const auto rows = rising(half), out = run(feedbackThrough(store), rows, {.mutation = mutation});
    std::string off;
    double worstMean = 0.0, worstDeviation = 0.0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const double weight = rows[i][0].y, step = stepOf(half);
        const double mean = std::abs(out[i][0].y), deviation = out[i][0].z;
        // Five deviations of the mean of that process over the counted frames; the sum is binary32's.
        const double meanBound = 5.0 * 0.5 * step / (1.0 - weight) / std::sqrt(out[i][0].w) + 1e-3 * step;
        const double deviationBound = 1.15 * 0.5 * step / std::sqrt(1.0 - weight * weight) + meanBound;
        if (!(mean <= meanBound && deviation <= deviationBound))
            off += "\n  weight " + std::to_string(weight) + ": mean " + std::to_string(mean / step) +
                   " steps, deviation " + std::to_string(deviation / step);
        if (rows[i][0].y == 0.97f)
            worstMean = std::max(worstMean, mean / step),
            worstDeviation = std::max(worstDeviation, deviation / step);
    }
    if (mutation.header.empty()) {
        measured(store.name + ", mean residual in steps over 50000 frames at weight 0.97", worstMean);
        measured(store.name + ", deviation in steps at weight 0.97", worstDeviation);
    }
    return off;
}

TEST(HistoryWrite, ditheredHistoryHasTheTargetAsItsMean) {
    EXPECT_EQ(offDither(halfDithered, true), "");
    EXPECT_EQ(offDither(unorm8Dithered, false), "");
}

TEST(HistoryWrite, noiseThatIsBiasedOrMissingIsCaught) {
    EXPECT_NE(offDither(halfDithered, true,
                        {header, "known / stepSize + bounded(noise, 0.0, LARGEST_NOISE)",
                         "known / stepSize + 0.5"}),
              "");
    EXPECT_NE(offDither(halfDithered, true,
                        {header, "known / stepSize + bounded(noise, 0.0, LARGEST_NOISE)",
                         "known / stepSize + 0.5 + bounded(noise, 0.0, LARGEST_NOISE)"}),
              "");
    EXPECT_NE(offDither(unorm8Dithered, false,
                        {header, "255.0 + bounded(noise, 0.0, LARGEST_NOISE)", "255.0 + 0.5"}),
              "");
}

// The law holds with the step of the second channel: 2^-12 of a step at most for binary16 that truncates,
// 1/254 and to nearest for 8 bits; beside it the blend's own three roundings.
std::string offCarrying(const Store& store, bool half, const Mutation& mutation = {}) {
    const auto rows = rising(half), out = run(feedbackThrough(store), rows, {.mutation = mutation});
    std::string off;
    double worst = 0.0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const double weight = rows[i][0].y, step = stepOf(half), missing = 1.0 - weight;
        const double second = half ? 0x1p-12 : 0.5 / 254.0;
        const double bound = (second * step + 3.0 * 2.0 * roundoff) / missing;
        const double residual = std::abs(static_cast<double>(out[i][0].x) - rows[i][0].x);
        if (!(residual <= bound))
            off += "\n  weight " + std::to_string(weight) + ": " + std::to_string(residual / step) + " steps";
        if (rows[i][0].y == 0.97f) worst = std::max(worst, residual / step);
    }
    if (mutation.header.empty())
        measured(store.name + ", residual in steps after 100000 frames at weight 0.97", worst);
    return off;
}

TEST(HistoryWrite, carriedErrorsBringHistoryToItsTarget) {
    EXPECT_EQ(offCarrying(halfCarrying, true), "");
    EXPECT_EQ(offCarrying(unorm8Carrying, false), "");
}

TEST(HistoryWrite, droppedOrNegatedErrorsAreCaught) {
    EXPECT_NE(offCarrying(halfCarrying, true,
                          {header,
                           "return stored + bounded(channels.y + 0.5, 0.0, 1.0) * "
                           "binary16Step(stored) - 0.5 * binary16Step(stored);",
                           "return stored;"}),
              "");
    EXPECT_NE(offCarrying(halfCarrying, true,
                          {header, "(known - stored) / binary16Step(stored)",
                           "(stored - known) / binary16Step(stored)"}),
              "");
    EXPECT_NE(offCarrying(unorm8Carrying, false,
                          {header, "floor(codes.y + 0.5) - 127.0", "floor(codes.y + 0.5) - 128.0"}),
              "");
}

// Pairs round trip: value to both channels and back.
Comparison carrying(bool half) {
    Random random(4);
    std::vector<Row> rows = noisyValues();
    for (int code = 0; code < 256; ++code)
        rows.push_back({vec4(static_cast<float>(code) / 255.0f)});
    return {{half ? "errorCarryingHalf" : "errorCarryingUnorm8",
             {header},
             half ? "float2 kept = errorCarryingHalf(in0.x); out0.xyz = float3(kept, errorCarriedHalf(kept));"
                  : "float2 kept = errorCarryingUnorm8(in0.x); out0.xyz = float3(kept, "
                    "errorCarriedUnorm8(kept));"},
            rows,
            [half](const Row& in) {
                const double value =
                    half ? oracle::held(in[0].x, -65504.0, 65504.0) : oracle::held(in[0].x, 0.0, 1.0);
                const double step = half ? oracle::binary16Step(value) : 1.0 / 255.0;
                // The first channel is within half a step, the second in half a step of the first's or in [0,
                // 1], and both together are the value: to a rounding of it, or to half a code of the second.
                return std::vector{near(dvec3(value, half ? 0.0 : 0.5, value),
                                        dvec3(0.5001 * step, 0.5,
                                              half ? 3.0 * roundoff * std::abs(value) + 1e-11
                                                   : 0.5 / 254.0 / 255.0 + 4.0 * roundoff))};
            }};
}

TEST(HistoryWrite, bothChannelsTogetherAreTheValue) {
    expectAgrees(carrying(true));
    expectAgrees(carrying(false));
    expectCaught(carrying(true), {header, "- 0.5 * binary16Step(stored)", ""});
    expectCaught(carrying(false), {header, "errorSteps * 254.0", "errorSteps * 127.0"});
}

TEST(HistoryWrite, noInputGivesNaNOrInfinity) {
    const Function all{"history write",
                       {header},
                       "out0 = float4(binary16Step(in0.x), feedbackResidual(binary16Step(in0.x), in0.y), "
                       "feedbackResidualTruncated(binary16Step(in0.x), in0.y), ditheredHalf(in0.x, in0.y));"
                       "out1 = float4(errorCarryingHalf(in0.x), errorCarryingUnorm8(in0.x));"
                       "out2.xyz = float3(errorCarriedHalf(in0.xy), errorCarriedUnorm8(in0.xy), "
                       "ditheredUnorm8(in0.x, in0.y));",
                       1,
                       3};
    expectNumbers(all, hostileRows(hostileFinite, 1, 2000, 5));
    expectNumbers(all, hostileRows(hostileAny, 1, 2000, 6));
}

} // namespace
} // namespace functions
