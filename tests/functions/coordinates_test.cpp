// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/coordinates.hlsli";
const std::map<std::string, int> sharedY = {{"NDC_AND_UV_SHARE_Y", 1}};

std::vector<Row> places(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    const float marks[] = {-1.0f, -0.5f, -0.0f, 0.0f, denormal, 0.25f, 0.5f, 1.0f, 8.0f, -1e30f, 1e30f};
    for (float x : marks)
        for (float y : marks)
            rows.push_back({vec4(x, y, 0, 0)});
    for (int i = 0; i < 3000; ++i)
        rows.push_back({random.in4(-2.0f, 2.0f)});
    return rows;
}

// A product by a power of two is exact, the sum has one rounding at the size of the result or of 1/2; one
// more of slack.
double affineBound(dvec2 value) {
    return 2.0 * roundoff * std::max({std::abs(value.x), std::abs(value.y), 1.0});
}

Comparison toUv(bool shared) {
    return {{"ndcToUv", {header}, "out0.xy = ndcToUv(in0.xy);", 1, 1, shared ? sharedY : decltype(sharedY){}},
            places(1),
            [shared](const Row& in) {
                const dvec2 uv = oracle::ndcToUv(xy(in[0]), shared);
                return std::vector{near(uv, affineBound(uv))};
            }};
}

Comparison toNdc(bool shared) {
    // A product by a power of two and a sum.
    return {{"uvToNdc", {header}, "out0.xy = uvToNdc(in0.xy);", 1, 1, shared ? sharedY : decltype(sharedY){}},
            places(2),
            [shared](const Row& in) {
                const dvec2 ndc = oracle::uvToNdc(xy(in[0]), shared);
                return std::vector{near(ndc, 2.0 * affineBound(ndc))};
            }};
}

TEST(Coordinates, ndcAndUvAgreeBothWaysWithYUpAndWithYShared) {
    for (bool shared : {false, true}) {
        expectAgrees(toUv(shared));
        expectAgrees(toNdc(shared));
    }
}

TEST(Coordinates, flippedNdcYIsCaught) {
    expectCaught(toUv(false), {header, "float2(0.5, -0.5)", "float2(0.5, 0.5)"});
    expectCaught(toNdc(false), {header, "float2(2.0, -2.0)", "float2(2.0, 2.0)"});
    expectCaught(toUv(true), {header, "#if NDC_AND_UV_SHARE_Y", "#if !NDC_AND_UV_SHARE_Y"});
}

TEST(Coordinates, offsetBeforeScaleIsCaught) {
    expectCaught(toUv(false), {header, "ndc * NDC_TO_UV_SCALE + 0.5", "(ndc + 0.5) * NDC_TO_UV_SCALE"});
}

TEST(Coordinates, upperLeftOfTheImageIsMinusOnePlusOneInNdc) {
    const auto rows =
        run({"ndcToUv", {header}, "out0.xy = ndcToUv(in0.xy);"}, {{vec4(-1, 1, 0, 0)}, {vec4(1, -1, 0, 0)}});
    EXPECT_EQ(xy(rows[0][0]), dvec2(0.0, 0.0));
    EXPECT_EQ(xy(rows[1][0]), dvec2(1.0, 1.0));
}

TEST(Coordinates, ndcRoundTripGivesThePlaceBack) {
    for (bool shared : {false, true})
        // Two affine steps; the second doubles the rounding of the first, at the size of the place or of 1.
        expectAgrees(
            {{"round trip",
              {header},
              "out0.xy = uvToNdc(ndcToUv(in0.xy));",
              1,
              1,
              shared ? sharedY : decltype(sharedY){}},
             places(3),
             [](const Row& in) { return std::vector{near(xy(in[0]), 8.0 * affineBound(xy(in[0])))}; }});
}

Comparison toPxAndBack() {
    Random random(4);
    std::vector<Row> rows;
    for (glm::vec2 extent :
         {glm::vec2(1, 1), glm::vec2(2, 2), glm::vec2(7, 5), glm::vec2(641, 359), glm::vec2(16384, 1)})
        for (int i = 0; i < 300; ++i)
            rows.push_back({vec4(random.in(-0.5f, 1.5f), random.in(-0.5f, 1.5f), extent)});
    // One product to pixels; the way back has the rounding of 1 / extent and of its product beside it.
    return {{"uvToPx, pxToUv",
             {header},
             "out0.xy = uvToPx(in0.xy, in0.zw); out1.xy = pxToUv(out0.xy, 1.0 / in0.zw);",
             1,
             2},
            rows,
            [](const Row& in) {
                const dvec2 extent(in[0].z, in[0].w), px = xy(in[0]) * extent;
                return std::vector{near(px, 2.0 * roundoff * std::max(std::abs(px.x), std::abs(px.y))),
                                   near(xy(in[0]), 2.0 * (divisionError + 2.0 * roundoff))};
            }};
}

TEST(Coordinates, pixelsAndUvAgreeAndInvertEachOther) {
    expectAgrees(toPxAndBack());
}

TEST(Coordinates, pixelsWithoutTheExtentAreCaught) {
    expectCaught(toPxAndBack(), {header, "return uv * extent;", "return uv * extent - 0.5;"});
}

Comparison inside() {
    std::vector<Row> rows;
    const float marks[] = {0.0f, -0.0f, 1.0f,     1.0000001f, -1e-7f,    0.5f,
                           2.0f, -1.0f, infinity, -infinity,  notANumber};
    for (float x : marks)
        for (float y : marks)
            rows.push_back({vec4(x, y, 0, 0)});
    Random random(5);
    for (int i = 0; i < 2000; ++i)
        rows.push_back({random.in4(-0.5f, 1.5f)});
    return {{"isInsideUv", {header}, "out0.x = isInsideUv(in0.xy) ? 1.0 : 0.0;"}, rows, [](const Row& in) {
                return std::vector{near(oracle::isInsideUv(xy(in[0])) ? 1.0 : 0.0, 0.0)};
            }};
}

TEST(Coordinates, insideIncludesTheEdgesAndNoNaN) {
    expectAgrees(inside());
}

TEST(Coordinates, insideOfOneAxisOnlyIsCaught) {
    expectCaught(inside(), {header, "all(asuint(uv) <= asuint(1.0))", "any(asuint(uv) <= asuint(1.0))"});
    expectCaught(inside(),
                 {header, "all(asuint(uv) <= asuint(1.0))", "all(asint(uv) >= 0) && !any(uv > 1.0)"});
    expectCaught(inside(), {header, "all(asuint(uv) <= asuint(1.0))", "all(asuint(uv) < asuint(1.0))"});
}

} // namespace
} // namespace functions
