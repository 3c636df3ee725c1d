// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include "harness.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/colour.hlsli";

std::vector<Row> colours(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows = triples(hostileColour);
    for (int i = 0; i < 4000; ++i)
        rows.push_back({random.colour()});
    for (int i = 0; i < 1000; ++i)
        rows.push_back({random.in4(0.0f, 1.0f)});
    return rows;
}

Comparison sanitizing() {
    Random random(1);
    std::vector<Row> rows = triples(hostileAny);
    for (int i = 0; i < 2000; ++i)
        rows.push_back({random.in4(-100.0f, 70000.0f)});
    // Only comparisons and copies: exact, but for flushed denormals.
    return {{"sanitize", {header}, "out0.xyz = sanitize(in0.xyz);"}, rows, [](const Row& in) {
                return std::vector{near(oracle::sanitize(xyz(in[0])), flush)};
            }};
}

TEST(Colour, sanitizeGivesFiniteColoursForAnything) {
    expectAgrees(sanitizing());
}

TEST(Colour, sanitizeByMaximumAloneIsCaught) {
    expectCaught(sanitizing(), {header, "return min(positive, MAX_COLOUR);", "return positive;"});
    expectCaught(sanitizing(), {header, "colour.g > 0.0 ? colour.g : 0.0", "colour.g"});
}

// A product by a constant that is off by up to a step: three roundings above the denormals.
Comparison unitColours() {
    Comparison comparison = sanitizing();
    comparison.function.name = "toUnitColour";
    comparison.function.body = "out0.xyz = toUnitColour(in0.xyz);";
    comparison.oracle = [](const Row& in) {
        const dvec3 share = oracle::unitColour(xyz(in[0]));
        return std::vector{near(share, 3.0 * roundoff * share + flush)};
    };
    return comparison;
}

Comparison throughUnitColours() {
    Comparison comparison = sanitizing();
    comparison.function.name = "fromUnitColour";
    comparison.function.body = "out0.xyz = fromUnitColour(toUnitColour(in0.xyz));";
    comparison.oracle = [](const Row& in) {
        const dvec3 colour = oracle::sanitize(xyz(in[0]));
        return std::vector{near(colour, 4.0 * roundoff * colour + oracle::maxColour * flush)};
    };
    return comparison;
}

TEST(Colour, unitColoursAreRepairedAndComeBack) {
    expectAgrees(unitColours());
    expectAgrees(throughUnitColours());
}

TEST(Colour, unitColourWithoutRepairOrOfAnotherRangeIsCaught) {
    expectCaught(unitColours(), {header, "saturate(colour * UNIT_PER_COLOUR)", "(colour * UNIT_PER_COLOUR)"});
    expectCaught(unitColours(),
                 {header, "saturate(colour * UNIT_PER_COLOUR)", "saturate(colour * (1.0 / 65536.0))"});
    expectCaught(throughUnitColours(), {header, "unit * MAX_COLOUR", "unit * 65536.0"});
}

// How many colours of binary16 come back smaller.
size_t shrunk(const Mutation& mutation = {}) {
    std::vector<Row> rows;
    for (uint16_t bits = 0; bits <= 0x7bff; ++bits)
        rows.push_back({vec4(harness::halfToFloat(bits))});
    const auto out = run(throughUnitColours().function, rows, {.mutation = mutation});
    size_t count = 0;
    for (size_t i = 0; i < rows.size(); ++i)
        count += out[i][0].x < rows[i][0].x;
    return count;
}

TEST(Colour, noUnitColourComesBackSmaller) {
    EXPECT_EQ(shrunk(), 0u);
    EXPECT_GT(shrunk({header, "colour * UNIT_PER_COLOUR", "colour * (1.0 / MAX_COLOUR)"}), 0u);
}

Comparison luminances() {
    // Three products and two sums of one sign: each partial result is at most the sum, 5 roundings.
    return {{"luminance", {header}, "out0.x = luminance(in0.xyz);"}, colours(2), [](const Row& in) {
                const double y = oracle::luminance(xyz(in[0]));
                return std::vector{near(y, 5.0 * roundoff * y + flush)};
            }};
}

TEST(Colour, luminanceIsThatOfRec709) {
    expectAgrees(luminances());
}

TEST(Colour, luminanceWithSwappedWeightsIsCaught) {
    expectCaught(luminances(), {header, "0.2126, 0.7152, 0.0722", "0.2126, 0.0722, 0.7152"});
    expectCaught(luminances(), {header, "0.2126, 0.7152, 0.0722", "0.299, 0.587, 0.114"});
}

Comparison toYcocg() {
    // Products by powers of two are exact; two sums of values up to the largest channel, 2 roundings and one
    // of slack for another order.
    return {{"rgbToYcocg", {header}, "out0.xyz = rgbToYcocg(in0.xyz);"}, colours(3), [](const Row& in) {
                const dvec3 rgb = xyz(in[0]);
                return std::vector{near(oracle::rgbToYcocg(rgb), 3.0 * roundoff * largest(rgb) + flush)};
            }};
}

Comparison fromYcocg() {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 3000; ++i) {
        const float scale = random.colourValue();
        rows.push_back(
            {vec4(scale * random.unit(), scale * random.in(-0.5f, 0.5f), scale * random.in(-0.5f, 0.5f), 0)});
    }
    // Two sums, each at most twice the largest component.
    return {{"ycocgToRgb", {header}, "out0.xyz = ycocgToRgb(in0.xyz);"}, rows, [](const Row& in) {
                const dvec3 ycocg = xyz(in[0]);
                return std::vector{near(oracle::ycocgToRgb(ycocg), 5.0 * roundoff * largest(ycocg) + flush)};
            }};
}

TEST(Colour, ycocgAgreesBothWays) {
    expectAgrees(toYcocg());
    expectAgrees(fromYcocg());
}

TEST(Colour, ycocgWithAFlippedSignIsCaught) {
    expectCaught(toYcocg(), {header, "-0.25 * rgb.r + 0.5 * rgb.g", "0.25 * rgb.r + 0.5 * rgb.g"});
    expectCaught(fromYcocg(), {header, "base - ycocg.y", "base + ycocg.y"});
}

TEST(Colour, ycocgRoundTripGivesTheColourBack) {
    // Four sums on the way, each rounded at most at the size of the largest channel, and their slack.
    expectAgrees({{"ycocg round trip", {header}, "out0.xyz = ycocgToRgb(rgbToYcocg(in0.xyz));"},
                  colours(5),
                  [](const Row& in) {
                      const dvec3 rgb = xyz(in[0]);
                      return std::vector{near(rgb, 6.0 * roundoff * largest(rgb) + flush)};
                  }});
}

TEST(Colour, ycocgStaysWithinItsRangesForColoursUpToOne) {
    Random random(6);
    const float ends[] = {0.0f, 1.0f};
    std::vector<Row> rows = triples(ends);
    for (int i = 0; i < 1000; ++i)
        rows.push_back({random.in4(0.0f, 1.0f)});
    for (const Row& out : run({"rgbToYcocg", {header}, "out0.xyz = rgbToYcocg(in0.xyz);"}, rows)) {
        EXPECT_GE(out[0].x, 0.0f);
        EXPECT_LE(out[0].x, 1.0f);
        EXPECT_LE(std::abs(out[0].y), 0.5f);
        EXPECT_LE(std::abs(out[0].z), 0.5f);
    }
}

Comparison compressing() {
    // A sum, relatively at most one rounding, and a division.
    return {{"compressHdr", {header}, "out0.xyz = compressHdr(in0.xyz);"}, colours(7), [](const Row& in) {
                const dvec3 value = oracle::compressHdr(xyz(in[0]));
                return std::vector{near(value, (divisionError + 2.0 * roundoff) * value + flush)};
            }};
}

TEST(Colour, compressionIsReinhardOfTheLargestComponent) {
    expectAgrees(compressing());
}

TEST(Colour, compressionOfEachChannelAloneIsCaught) {
    expectCaught(compressing(),
                 {header, "colour / (1.0 + max(maxComponent(colour), 0.0))", "colour / (1.0 + colour)"});
}

TEST(Colour, compressionStaysAtMostOne) {
    for (const Row& out :
         run({"compressHdr", {header}, "out0.xyz = compressHdr(in0.xyz);"}, triples(hostileColour)))
        for (int c = 0; c < 3; ++c)
            EXPECT_LE(out[0][c], 1.0f);
}

Comparison expanding() {
    Random random(8);
    std::vector<Row> rows = triples(hostileColour);
    for (int i = 0; i < 3000; ++i)
        rows.push_back({random.in4(0.0f, 1.0f)});
    for (int i = 0; i < 1000; ++i)
        rows.push_back({random.in4(0.9999f, 1.0001f)});
    // 1 - m is exact from 1/2 on and has one rounding below; the floor 1/65505 has the error of its division,
    // and where it takes over, both sides of it end at the same value.
    return {{"expandHdr", {header}, "out0.xyz = expandHdr(in0.xyz);"}, rows, [](const Row& in) {
                const dvec3 value = oracle::expandHdr(xyz(in[0]));
                return std::vector{near(value, (2.0 * divisionError + 2.0 * roundoff) * value + flush)};
            }};
}

TEST(Colour, expansionInvertsAndEndsAtTheLargestColour) {
    expectAgrees(expanding());
}

TEST(Colour, expansionWithoutItsGuardIsCaught) {
    expectCaught(expanding(), {header, "max(1.0 - maxComponent(compressed), 1.0 / (1.0 + MAX_COLOUR))",
                               "(1.0 - maxComponent(compressed))"});
}

TEST(Colour, compressionRoundTripKeepsWhatTheComplementCanHold) {
    // The complement 1 - m = 1 / (1 + max) carries the absolute error of m, a few roundings at 1; relative to
    // itself that is (1 + max) times as much. Between there are two divisions.
    expectAgrees({{"hdr round trip", {header}, "out0.xyz = expandHdr(compressHdr(in0.xyz));"},
                  colours(9),
                  [](const Row& in) {
                      const dvec3 colour = xyz(in[0]);
                      const double relative = (divisionError + 2.0 * roundoff) * (2.0 + largest(colour));
                      return std::vector{near(colour, (relative + 2.0 * divisionError) * colour + flush)};
                  }});
}

} // namespace
} // namespace functions
