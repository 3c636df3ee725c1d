// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace functions {
namespace {

const std::string header = "reprise/quad_sharing.hlsli";

struct Shared {
    Image image;
    std::vector<Row> out; // side, value of the row's other pixel, of the column's
};

Shared share(const Image& image, const Mutation& mutation) {
    const glm::ivec2 size(image.width, image.height);
    const std::string extent = "float2(" + std::to_string(size.x) + ".0, " + std::to_string(size.y) + ".0)";
    const Function function{"quad sharing",
                            {header},
                            "float3 value = SAMPLE(gTexture0, positionPx.xy / " + extent +
                                ").rgb;"
                                "float2 side = quadSide(positionPx.xy); out0.xy = side;"
                                "out1.xyz = quadSwapX(value, side); out2.xyz = quadSwapY(value, side);",
                            0,
                            3,
                            {},
                            reprise::Stage::fragment,
                            {{image, false}}};
    return {image, run(function, {}, {.mutation = mutation, .extent = size})};
}

// A quad is the 2x2 from an even pixel; at an odd edge its other pixels are helpers that read the clamped
// texel. What comes over is own + (other - own): two roundings, each at most at twice the larger.
std::string wrongPixels(const Image& image, const Mutation& mutation = {}) {
    const Shared shared = share(image, mutation);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Row& out = shared.out[static_cast<size_t>(y * image.width + x)];
            const dvec3 own(image.at(x, y)), row(oracle::texelClamped(image, x ^ 1, y)),
                column(oracle::texelClamped(image, x, y ^ 1));
            std::ostringstream where;
            where << "pixel " << x << ", " << y << " of " << image.width << "x" << image.height;
            if (xy(out[0]) != dvec2((x & 1) * 2 - 1, (y & 1) * 2 - 1)) return where.str() + ": side";
            for (int c = 0; c < 3; ++c) {
                const double boundX = 2.0 * roundoff * std::max(own[c], row[c]),
                             boundY = 2.0 * roundoff * std::max(own[c], column[c]);
                where << ": " << out[1][c] << " for " << row[c] << ", " << out[2][c] << " for " << column[c];
                if (!(std::abs(out[1][c] - row[c]) <= boundX) || !(std::abs(out[2][c] - column[c]) <= boundY))
                    return where.str();
            }
        }
    return "";
}

TEST(QuadSharing, valuesOfTheOtherPixelsComeOver) {
    for (glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(2, 2), glm::ivec2(7, 5), glm::ivec2(64, 64), glm::ivec2(33, 18)}) {
        EXPECT_EQ(wrongPixels(randomImage(size.x, size.y, 1)), "");
        EXPECT_EQ(wrongPixels(randomImage(size.x, size.y, 2, 0.0f, 65504.0f)), "");
    }
}

TEST(QuadSharing, smallValueBesideTheLargestColourComesOverWithinOneStepOfIt) {
    Image image(2, 2, dvec4(65504.0));
    image.at(0, 0) = dvec4(0.001f);
    EXPECT_EQ(wrongPixels(image), "");
}

TEST(QuadSharing, wrongDirectionOrSignIsCaught) {
    const Image image = randomImage(7, 5, 3);
    EXPECT_NE(
        wrongPixels(image, {header, "value - ddx_fine(value) * side.x", "value + ddx_fine(value) * side.x"}),
        "");
    EXPECT_NE(wrongPixels(image, {header, "ddy_fine(value) * side.y", "ddx_fine(value) * side.y"}), "");
    EXPECT_NE(wrongPixels(image, {header, "frac(floor(positionPx) * 0.5) * 4.0 - 1.0",
                                  "1.0 - frac(floor(positionPx) * 0.5) * 4.0"}),
              "");
}

// In compute the other invocation of a row is the neighbour in the group: rows of inputs 2 k and 2 k + 1.
std::string wrongInvocations(const Mutation& mutation = {}) {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 512; ++i)
        rows.push_back({random.colour()});
    for (size_t i = 0; i < 64; ++i)
        rows[i * 5][0].x = random.of(hostileAny);
    const Function function{
        "quad sharing in compute",
        {header},
        "float2 side = quadSide(float2(thread.xy) + 0.5); out0.xyz = quadSwapX(in0.xyz, side);"
        "out1.xy = quadSwapX(in0.xy, side);",
        1,
        2};
    const auto out = run(function, rows, {.mutation = mutation});
    const auto same = [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (size_t i = 0; i < rows.size(); ++i) {
        const vec4 other = rows[i ^ 1][0]; // copied: exact, also NaN
        for (int c = 0; c < 3; ++c)
            if (!same(out[i][0][c], other[c]) || (c < 2 && !same(out[i][1][c], other[c])))
                return "invocation " + std::to_string(i) + " has " + std::to_string(out[i][0][c]) + " for " +
                       std::to_string(other[c]);
    }
    return "";
}

// Rows of the subgroup: eight invocations on Mesa's CPU driver, which are also the rows of the runner's
// groups.
std::string wrongRows(const Mutation& mutation = {}) {
    constexpr size_t width = 8;
    Random random(5);
    std::vector<Row> rows;
    for (int i = 0; i < 512; ++i)
        rows.push_back({random.colour(), random.colour()});
    const Function function{"rows of the subgroup",
                            {header},
                            "out0.xyz = outerNeighbour(in0.xyz, in1.xyz);"
                            "out1.xyz = halfRowSwap(in0.xyz);"
                            "out2.xy = float2(SUBGROUP_ROW_WIDTH, subgroupColumn());",
                            2,
                            3};
    const auto out = run(function, rows, {.mutation = mutation});
    for (size_t i = 0; i < rows.size(); ++i) {
        const size_t first = i / width * width;
        const bool isEnd = i == first || i == first + width - 1;
        // The first and the last have each other's end.
        const vec4 outer = isEnd ? rows[2 * first + width - 1 - i][1] : rows[i % 2 == 0 ? i - 1 : i + 1][0];
        const vec4 half = rows[i ^ (width / 2)][0];
        for (int c = 0; c < 3; ++c)
            if (out[i][0][c] != outer[c] || out[i][1][c] != half[c])
                return "invocation " + std::to_string(i) + " has another one's value";
        if (out[i][2].x != width || out[i][2].y != static_cast<float>(i - first)) return "place in the row";
    }
    return "";
}

TEST(QuadSharing, rowsOfTheSubgroupShareWithTheirNeighboursAndEnds) {
    EXPECT_EQ(wrongRows(), "");
}

TEST(QuadSharing, rowsThatMixTheirSidesOrEndsAreCaught) {
    EXPECT_NE(wrongRows({header, "? column + 1u : column - 1u", "? column - 1u : column + 1u"}), "");
    EXPECT_NE(wrongRows({header, "column == 0u || column == last", "column == 0u"}), "");
    EXPECT_NE(wrongRows({header, "column == 0u || column == last", "column == last"}), "");
    EXPECT_NE(wrongRows({header, "outerColumn & last", "min(outerColumn, last)"}), "");
    EXPECT_NE(wrongRows({header, "SUBGROUP_ROW_WIDTH / 2u", "1u"}), "");
}

TEST(QuadSharing, computeTakesTheNeighboursValueExactly) {
    EXPECT_EQ(wrongInvocations(), "");
}

TEST(QuadSharing, readAcrossTheOtherAxisIsCaughtInCompute) {
    EXPECT_NE(
        wrongInvocations(
            {header, "float3 quadSwapX(float3 value, float2 side) {\n    return QuadReadAcrossX(value);",
             "float3 quadSwapX(float3 value, float2 side) {\n    return QuadReadAcrossY(value);"}),
        "");
}

} // namespace
} // namespace functions
