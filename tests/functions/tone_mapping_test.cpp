// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/tone_mapping.hlsli";

// 1e-4 to 65504, evenly over the logarithm, three a row, both ends among them.
std::vector<Row> range() {
    std::vector<float> values;
    for (int i = 0; i < 60000; ++i)
        values.push_back(static_cast<float>(1e-4 * std::pow(65504.0 / 1e-4, i / 59999.0)));
    values.front() = 1e-4f;
    values.back() = 65504.0f;
    std::vector<Row> rows;
    for (size_t i = 0; i < values.size(); i += 3)
        rows.push_back({vec4(values[i], values[i + 1], values[i + 2], 0.0f)});
    return rows;
}

std::vector<Row> colours(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows = triples(hostileColour);
    for (int i = 0; i < 3000; ++i)
        rows.push_back({random.colour()});
    return rows;
}

const Function reinhardTrip{
    "Reinhard and back", {header}, "out0.xyz = inverseToneMapReinhard(toneMapReinhard(in0.xyz));"};
const Function hableTrip{
    "Hable and back", {header}, "out0.xyz = inverseToneMapHable(toneMapHable(in0.xyz));"};

// The bars: relative errors of the round trip, from 1e-4 to 65504, and exactly 0 at 0.
const double reinhardBar = 3e-7, hableBar = 4e-6;

struct Worst {
    double relative = 0.0, at = 0.0;
    size_t negative = 0, count = 0;
};

Worst worstOf(const Function& function, const Mutation& mutation = {}) {
    const std::vector<Row> rows = range();
    const auto out = run(function, rows, {.mutation = mutation});
    Worst worst;
    for (size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            const double x = rows[i][0][c], error = std::abs(out[i][0][c] - x) / x;
            const double relative = std::isnan(error) ? infinity : error;
            ++worst.count;
            worst.negative += out[i][0][c] < 0.0f;
            if (relative <= worst.relative) continue;
            worst.relative = relative;
            worst.at = x;
        }
    return worst;
}

TEST(ToneMapping, roundTripsMeetTheirBarsFrom1eMinus4To65504) {
    const Worst reinhard = worstOf(reinhardTrip), hable = worstOf(hableTrip);
    measured("Reinhard round trip, worst relative error", reinhard.relative);
    measured("Hable round trip, worst relative error", hable.relative);
    measured("Hable round trip, where", hable.at);
    EXPECT_LE(reinhard.relative, reinhardBar) << reinhard.at;
    EXPECT_LE(hable.relative, hableBar) << hable.at;
}

// Every binary32 of the range, 245 million: in the shader, each row 32768 neighbours. The difference of two
// numbers within a factor of 2 is exact, so that the relative error is, too.
TEST(ToneMapping, roundTripsMeetTheirBarsForEveryBinary32) {
    const uint32_t first = 0x38d1b717u, last = 0x477fe000u, length = 32768; // 1e-4 and 65504
    std::vector<Row> rows;
    for (uint32_t bits = first; bits <= last; bits += length) {
        const uint32_t offset = bits - first; // in two parts that a float holds
        rows.push_back({vec4(static_cast<float>(offset / length),
                             static_cast<float>(std::min(length, last - bits + 1)), 0.0f, 0.0f)});
    }
    const auto out = run({"every binary32",
                          {header},
                          "uint bits = 0x38d1b717u + uint(in0.x) * 32768u;"
                          "for (int i = 0; i < int(in0.y); i += 3) {"
                          "    float3 x = asfloat(uint3(bits, bits + 1u, bits + 2u) + uint(i));"
                          "    x = min(x, 65504.0);"
                          "    float3 reinhard = abs(inverseToneMapReinhard(toneMapReinhard(x)) - x) / x;"
                          "    float3 hable = abs(inverseToneMapHable(toneMapHable(x)) - x) / x;"
                          "    out0.x = max(out0.x, max(reinhard.x, max(reinhard.y, reinhard.z)));"
                          "    out0.y = max(out0.y, max(hable.x, max(hable.y, hable.z)));"
                          "}"},
                         rows);
    double reinhard = 0.0, hable = 0.0;
    for (const Row& row : out) {
        reinhard = std::max(reinhard, static_cast<double>(row[0].x));
        hable = std::max(hable, static_cast<double>(row[0].y));
    }
    measured("Reinhard round trip, worst relative error of every binary32", reinhard);
    measured("Hable round trip, worst relative error of every binary32", hable);
    EXPECT_LE(reinhard, reinhardBar);
    EXPECT_LE(hable, hableBar);
    EXPECT_GT(reinhard, 0.0); // the loop ran
    EXPECT_GT(hable, 0.0);
}

TEST(ToneMapping, roundTripsAreExactAtZero) {
    for (const Function& function : {reinhardTrip, hableTrip})
        EXPECT_EQ(xyz(run(function, {{vec4(0.0f)}})[0][0]), dvec3(0.0)) << function.name;
}

Comparison mapping(bool hable) {
    // A product or two, a sum or two and a division, all of positive terms: no more than some 10 roundings
    // and the rounding of the constants.
    return {{hable ? "toneMapHable" : "toneMapReinhard",
             {header},
             std::string("ToneMapped mapped = ") + (hable ? "toneMapHable" : "toneMapReinhard") +
                 "(in0.xyz); out0.xyz = mapped.value; out1.xyz = mapped.complement;",
             1,
             2},
            colours(1),
            [hable](const Row& in) {
                dvec3 value, complement;
                for (int c = 0; c < 3; ++c) {
                    const double x = in[0][c];
                    value[c] = hable ? oracle::hable(x) : oracle::reinhard(x);
                    complement[c] = hable ? oracle::hableComplement(x) : 1.0 / (1.0 + x);
                }
                const double relative = 10.0 * roundoff + divisionError;
                // Below, the oracle's own subtraction in 64-bit significands: 1e-19.
                return std::vector{near(value, relative * value + 1e-18),
                                   near(complement, relative * complement)};
            }};
}

TEST(ToneMapping, valueAndComplementAreBothExactToSomeRoundings) {
    expectAgrees(mapping(false));
    expectAgrees(mapping(true));
}

TEST(ToneMapping, wrongComplementsAreCaught) {
    // 1 - value: what is printed second. And to the wrong limit, or with E and F swapped.
    expectCaught(mapping(true), {header, "mapped.complement = (HABLE_BC * x + HABLE_DFE) / denominator;",
                                 "mapped.complement = 1.0 - mapped.value;"});
    expectCaught(mapping(true), {header, "mapped.complement = (HABLE_BC * x + HABLE_DFE) / denominator;",
                                 "mapped.complement = 14.0 / 15.0 - mapped.value;"});
    expectCaught(mapping(false), {header,
                                  "mapped.complement = 1.0 / (1.0 + sanitize(colour));\n"
                                  "    mapped.value = sanitize(colour) * mapped.complement;",
                                  "mapped.value = sanitize(colour) / (1.0 + sanitize(colour));\n"
                                  "    mapped.complement = 1.0 - mapped.value;"});
    expectCaught(mapping(true), {header, "HABLE_BCFE = 0.005", "HABLE_BCFE = 0.05"});
}

TEST(ToneMapping, wrongRootsAreCaught) {
    const auto worse = [](const Mutation& mutation) {
        return worstOf(hableTrip, mutation).relative > hableBar;
    };
    EXPECT_FALSE(worse({}));
    EXPECT_TRUE(worse({header, "m.x > 0.0 ? above.x : below.x", "m.x > 0.0 ? below.x : above.x"}));
    EXPECT_TRUE(worse({header, "+ abs(m);", "- abs(m);"}));
    // One form of the root for both sides of the turn loses what the other side needs.
    EXPECT_TRUE(worse(
        {header, "float3 below = 2.0 * HABLE_DF * t / both;",
         "float3 below = (sqrt(m * m + 4.0 * HABLE_A * HABLE_DF * c * t) + m) / (2.0 * HABLE_A * c);"}));
    // The middle term as a difference of what does not vanish.
    EXPECT_TRUE(worse({header, "HABLE_B * (t - HABLE_TURN)", "HABLE_BC - HABLE_B * (1.0 - t)"}));
    EXPECT_GT(
        worstOf(reinhardTrip, {header, "mapped.value / complement", "mapped.value / (1.0 - mapped.value)"})
            .relative,
        reinhardBar);
}

// The page's two inverses, as functions of A to F and the number that each takes, y; `sign` before the root
// is the printed + or what mends it.
const std::string constants = "const float A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30;"
                              "float3 x = in0.xyz;"
                              "float3 f = (x * (A * x + C * B) + D * E) / (x * (A * x + B) + D * F) - E / F;";

Function firstInverse(const std::string& sign) {
    return {
        "first printed inverse",
        {header},
        constants +
            "float3 y = f;"
            "float3 root = sqrt((4.0 * y - 4.0 * y * y) * A * D * F * F * F + (-4.0 * y * A * D * E + B * B "
            "* C * C"
            "    - 2.0 * y * B * B * C + y * y * B * B) * F * F + (2.0 * y * B * B - 2.0 * B * B * C) * E * F"
            "    + B * B * E * E);"
            "out0.xyz = (" +
            sign + "root + (B * C - y * B) * F - B * E) / ((2.0 * y - 2.0) * A * F + 2.0 * A * E);"};
}

const Function secondInverse{
    "second printed inverse",
    {header},
    constants + "float3 y = 1.0 - f;"
                "float3 root = sqrt((4.0 * y - 4.0 * y * y) * A * D * F * F * F + ((4.0 * y - 4.0) * A * D * "
                "E + B * B * C * C"
                "    + (2.0 * y - 2.0) * B * B * C + (y * y - 2.0 * y + 1.0) * B * B) * F * F"
                "    + ((2.0 - 2.0 * y) * B * B - 2.0 * B * B * C) * E * F + B * B * E * E);"
                "out0.xyz = (root + ((1.0 - y) * B - B * C) * F + B * E) / (2.0 * y * A * F - 2.0 * A * E);"};

TEST(ToneMapping, thePrintedFirstInverseTakesTheWrongRootAndIsCaught) {
    const Worst printed = worstOf(firstInverse("")), mended = worstOf(firstInverse("-"));
    measured("first printed inverse, share of negative results",
             static_cast<double>(printed.negative) / static_cast<double>(printed.count));
    measured("first printed inverse, worst relative error", printed.relative);
    measured("first printed inverse with -sqrt, worst relative error", mended.relative);
    measured("first printed inverse with -sqrt, where", mended.at);
    EXPECT_GT(printed.relative, hableBar);
    EXPECT_EQ(printed.negative, printed.count); // "a negative value for every input"
    // The sign mends the root, not what was lost to cancellation.
    EXPECT_EQ(mended.negative, 0u);
    EXPECT_GT(mended.relative, hableBar);
    const auto middle = run(firstInverse("-"), {{vec4(0.5f, 1.0f, 2.0f, 0.0f)}});
    EXPECT_NEAR(middle[0][0].y, 1.0, 1e-4); // where little is lost, it is the inverse
}

TEST(ToneMapping, thePrintedSecondInverseLosesThreeDigitsAndIsCaught) {
    const Worst printed = worstOf(secondInverse);
    measured("second printed inverse, worst relative error", printed.relative);
    measured("second printed inverse, where", printed.at);
    const auto brightest = run(secondInverse, {{vec4(65504.0f)}});
    measured("second printed inverse, relative error at 65504", std::abs(brightest[0][0].x / 65504.0 - 1.0));
    EXPECT_GT(printed.relative, hableBar);
    EXPECT_EQ(printed.negative, 0u); // the root is right
    // "As colour intensity approaches infinity, the tone mapped colour approaches 1.0": it is 1 - E/F, so
    // that 1 - value ends at E/F and the precision near 0 is not used.
    EXPECT_NEAR(1.0 - oracle::hable(1e9), 0.02 / 0.3, 1e-6);
}

// n samples in one pixel: in0 ... in3, w the count in in0.w.
const std::string resolveBody = "float3 samples[4] = {in0.xyz, in1.xyz, in2.xyz, in3.xyz};"
                                "ToneMapped box = noSamples(), reinhard = noSamples(), hable = noSamples();"
                                "for (int i = 0; i < int(in0.w); ++i) {"
                                "    addBox(box, samples[i]); addReinhard(reinhard, samples[i]);"
                                "    addHable(hable, samples[i]);"
                                "}"
                                "out0.xyz = resolveBox(box, in0.w); out1.xyz = resolveReinhard(reinhard);"
                                "out2.xyz = resolveHable(hable, in0.w);";

Comparison resolving() {
    Random random(2);
    std::vector<Row> rows;
    for (int count = 1; count <= 4; ++count)
        for (int i = 0; i < 400; ++i) {
            Row row;
            for (int k = 0; k < 4; ++k)
                row.push_back(i % 3 == 0   ? random.in4(0.0f, 2.0f)
                              : i % 3 == 1 ? random.colour()
                                           : vec4(0.0f));
            if (i % 3 == 2)
                row[random.below(static_cast<size_t>(count))] = random.colour(); // a light beside the dark
            row[0].w = static_cast<float>(count);
            rows.push_back(row);
        }
    return {{"resolve", {header}, resolveBody, 4, 3}, rows, [](const Row& in) {
                dvec3 box, reinhard, hable;
                for (int c = 0; c < 3; ++c) {
                    std::vector<double> samples;
                    for (size_t k = 0; k < static_cast<size_t>(in[0].w); ++k)
                        samples.push_back(in[k][c]);
                    box[c] = oracle::resolveBox(samples);
                    reinhard[c] = oracle::resolveReinhard(samples);
                    hable[c] = oracle::resolveHable(samples);
                }
                // Sums of four positive numbers, and a division each; the bars of the round trips beside it.
                const double sums = 4.0 * roundoff + divisionError;
                return std::vector{near(box, sums * box + flush),
                                   near(reinhard, (sums + reinhardBar) * reinhard + flush),
                                   near(hable, (sums + hableBar) * hable + flush)};
            }};
}

TEST(ToneMapping, resolvesAreTheInversesOfTheMeans) {
    expectAgrees(resolving());
}

TEST(ToneMapping, wrongResolvesAreCaught) {
    expectCaught(resolving(), {header, "mean.complement = sum.complement / max(count, 1.0);",
                               "mean.complement = sum.complement;"});
    expectCaught(resolving(),
                 {header, "sum.complement += mapped.complement;", "sum.complement = mapped.complement;"});
    // Mapped back first and averaged then: the box.
    expectCaught(resolving(), {header, "return inverseToneMapReinhard(sum);",
                               "return sum.value / max(sum.complement, 1.0);"});
}

// What the page shows: beside the dark, a light does not take over the pixel.
TEST(ToneMapping, oneBrightSampleOfFourDoesNotOutshineTheOthers) {
    const auto out = run({"resolve", {header}, resolveBody, 4, 3},
                         {{vec4(50, 50, 50, 4), vec4(0.0f), vec4(0.0f), vec4(0.0f)}});
    EXPECT_FLOAT_EQ(out[0][0].x, 12.5f);
    EXPECT_LT(out[0][1].x, 0.4f); // a quarter of 50/51, inverted: 0.325
    EXPECT_LT(out[0][2].x, 1.0f);
    EXPECT_GT(out[0][1].x, 0.0f);
    EXPECT_GT(out[0][2].x, 0.0f);
}

TEST(ToneMapping, noInputGivesNaNOrInfinity) {
    const Function all{"tone mapping",
                       {header},
                       "ToneMapped any; any.value = in0.xyz; any.complement = in1.xyz;"
                       "out0.xyz = inverseToneMapReinhard(any); out1.xyz = inverseToneMapHable(any);"
                       "ToneMapped r = toneMapReinhard(in0.xyz), h = toneMapHable(in0.xyz);"
                       "out2.xyz = r.value + r.complement; out3.xyz = h.value + h.complement;"
                       "out4.xyz = resolveBox(any, in1.w); out5.xyz = resolveReinhard(any);"
                       "out6.xyz = resolveHable(any, in1.w);",
                       2,
                       7};
    expectNumbers(all, hostileRows(hostileFinite, 2, 3000, 3));
    expectNumbers(all, hostileRows(hostileAny, 2, 3000, 4));
}

TEST(ToneMapping, inversesEndAtTheLargestColour) {
    const Function both{"inverses",
                        {header},
                        "ToneMapped any; any.value = in0.xxx; any.complement = in0.yyy;"
                        "out0.x = inverseToneMapReinhard(any).x; out0.y = inverseToneMapHable(any).x;"};
    for (const Row& out : run(both, {{vec4(1, 0, 0, 0)}, {vec4(1, -1e-7f, 0, 0)}, {vec4(2, 1e-30f, 0, 0)}})) {
        EXPECT_EQ(out[0].x, 65504.0f);
        EXPECT_EQ(out[0].y, 65504.0f);
    }
}

} // namespace
} // namespace functions
