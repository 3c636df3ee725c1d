// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/resampling.hlsli";

Function catmullRom(const Image& image) {
    return {
        "sampleCatmullRom5",
        {header},
        "out0.xyz = sampleCatmullRom5(TEXTURE_ARGUMENT(gTexture0), in0.xy, float4(in0.zw, 1.0 / in0.zw));",
        2,
        1,
        {},
        reprise::Stage::compute,
        {{image, true}}};
}

Comparison resampling(const Image& image, bool broken = false) {
    return {catmullRom(image), randomPlaces({image.width, image.height}, 1), [image, broken](const Row& in) {
                if (broken) return std::vector{finite()};
                // A filter step on each axis of texels in [0, 1]; the absolute weights sum to at most 1.6. uv
                // times the size is rounded at 20 texels, which moves the sample by 1e-6 of a texel.
                return std::vector{
                    near(oracle::sampleCatmullRom5(image, xy(in[0])), 1.6 * 2.0 * filterStep + 1e-5)};
            }};
}

TEST(Resampling, fiveReadsAgree) {
    for (glm::ivec2 size : imageSizes) {
        SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y));
        expectAgrees(resampling(randomImage(size.x, size.y, 2)));
    }
}

// The oracle against itself: five bilinear reads are the twelve texels, where nothing is repaired.
TEST(Resampling, oracleOfFiveReadsIsThatOfTwelveTexels) {
    const Image image = randomImage(16, 9, 3, 0.4f, 0.6f); // lobes cannot make it negative
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const dvec2 uv(random.in(-0.2f, 1.2f), random.in(-0.2f, 1.2f));
        const dvec3 difference = oracle::sampleCatmullRom5(image, uv) - oracle::sampleCatmullRom12(image, uv);
        ASSERT_LE(largest(difference), 1e-12) << uv.x << " " << uv.y; // double precision
    }
}

// Between the texels of a smooth ramp a cubic is exact, where bilinear reads only have their filter step to
// lose.
TEST(Resampling, texelCentresGiveTheirTexels) {
    const Image image = randomImage(16, 9, 5);
    std::vector<Row> rows;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 16; ++x)
            rows.push_back(
                {vec4((static_cast<float>(x) + 0.5f) / 16.0f, (static_cast<float>(y) + 0.5f) / 9.0f, 16, 9),
                 vec4(0)});
    const auto out = run(catmullRom(image), rows);
    for (int i = 0; i < 16 * 9; ++i)
        for (int c = 0; c < 3; ++c)
            // uv times the size is off by some 1e-6 of a texel; the slope of the filter is below 2.
            EXPECT_NEAR(out[static_cast<size_t>(i)][0][c], image.texels[static_cast<size_t>(i)][c], 1e-5)
                << "texel " << i;
}

TEST(Resampling, wrongWeightsAreCaught) {
    const Comparison right = resampling(randomImage(16, 9, 6));
    expectCaught(right, {header, "f * (-0.5 + f * (1.0 - 0.5 * f))", "f * (-0.5 + f * (1.0 - f))"});
    expectCaught(right, {header, "f * f * (-0.5 + 0.5 * f)", "f * f * (0.5 - 0.5 * f)"});
    expectCaught(right, {header, "sanitize(sum / cross)", "sanitize(sum)"});
    expectCaught(right, {header, "(centrePx + w2 / w12)", "(centrePx + w1 / w12)"});
    expectCaught(right, {header, "(centrePx + 2.0)", "(centrePx + 1.0)"});
}

TEST(Resampling, lobesBesideAnEdgeStayAboveZero) {
    Image edge(16, 9);
    for (int y = 0; y < 9; ++y)
        for (int x = 8; x < 16; ++x)
            edge.at(x, y) = dvec4(65504.0);
    for (const Row& out : run(catmullRom(edge), randomPlaces({16, 9}, 7)))
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(out[0][c], 0.0f);
            EXPECT_LE(out[0][c], 65504.0f);
        }
}

TEST(Resampling, brokenTexelsGiveFiniteColours) {
    expectAgrees(resampling(brokenImage(16, 9, 8), true));
}

TEST(Resampling, readsThatAreNotRepairedAreCaught) {
    const Comparison broken = {catmullRom(brokenImage(16, 9, 9)), randomPlaces({16, 9}, 10), [](const Row&) {
                                   return std::vector{near(dvec3(32752.0), 32752.0)}; // [0, 65504]
                               }};
    expectCaught(broken, {header, "return sanitize(sum / cross);", "return sum / cross;"});
}

} // namespace
} // namespace functions
