// SPDX-License-Identifier: Apache-2.0
// Executed on Direct3D 9's rule and devices: tests/passes/d3d9_rasterisation_test.cpp, ./run d3d.
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/half_pixel.hlsli";

// Clip positions in front of and behind the camera, and 1 / extent of targets of 1 to 4096 pixels.
std::vector<Row> positions() {
    Random random(1);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i) {
        const float width = std::exp2(std::floor(random.in(0.0f, 13.0f))),
                    height = std::floor(random.in(1.0f, 4096.0f));
        vec4 position = random.in4(-2.0f, 2.0f) * 10.0f;
        if (i % 8 == 0) position.w = -position.w;
        rows.push_back({position, vec4(1.0f / width, 1.0f / height, 0.0f, 0.0f)});
    }
    return rows;
}

// In Direct3D 9 the place uv of the screen lies at uv * extent of the viewport and pixel i at i; uv is that
// of the texel's centre, (i + 0.5) / extent. So the place has to move by half a pixel to the left and up.
dvec4 onPixelCentres(const Row& in) {
    const dvec4 clip(in[0]);
    const dvec2 texel(in[1].x, in[1].y);
    const dvec2 uv = oracle::ndcToUv(dvec2(clip) / clip.w) - 0.5 * texel;
    return dvec4(oracle::uvToNdc(uv) * clip.w, clip.z, clip.w);
}

Comparison offset(int d3d9) {
    return {{"halfPixelOffset",
             {header},
             "out0 = halfPixelOffset(in0, in1.xy);",
             2,
             1,
             {{"PLATFORM_D3D9", d3d9}}},
            positions(),
            [d3d9](const Row& in) {
                if (!d3d9) return std::vector{near(dvec4(in[0]), 0.0)};
                // A product and a sum, each rounded once; 1e-12 is the oracle's own way there and back.
                const dvec4 expected = onPixelCentres(in);
                const double largest = std::max(std::abs(expected.x), std::abs(expected.y)) +
                                       std::abs(in[0].w) * std::max(in[1].x, in[1].y);
                return std::vector{near(expected, 2.0 * roundoff * largest + 1e-12)};
            }};
}

TEST(HalfPixel, texelCentresLieOnPixelCentresInDirect3D9) {
    expectAgrees(offset(1));
}

TEST(HalfPixel, positionIsUntouchedElsewhere) {
    expectAgrees(offset(0));
    expectCaught(offset(0), {header, "#if PLATFORM_D3D9", "#if !PLATFORM_D3D9"});
}

TEST(HalfPixel, missingOffsetWrongSignAndMissingWAreCaught) {
    const std::string line = "positionCS.xy += float2(-texelSize.x, texelSize.y) * positionCS.w;";
    expectCaught(offset(1), {header, line, ""});
    expectCaught(offset(1), {header, "positionCS.xy +=", "positionCS.xy -="});
    expectCaught(offset(1), {header, "float2(-texelSize.x, texelSize.y)", "-texelSize"});
    expectCaught(offset(1), {header, "float2(-texelSize.x, texelSize.y)", "texelSize"});
    expectCaught(offset(1), {header, " * positionCS.w;", ";"});
    expectCaught(offset(1), {header, "texelSize.y) *", "texelSize.y) * 0.5 *"});
}

} // namespace
} // namespace functions
