// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace functions {
namespace {

const std::string header = "passes/coarse_depth.hlsli";
constexpr int width = 9, height = 7;
constexpr double sky = 65504.0;

// What a pass declares before it includes the header, whose text stands in place of its #include.
std::string declared(const Mutation& mutation) {
    std::string text = hlslText(header);
    if (const size_t place = text.find(mutation.find); !mutation.find.empty() && place != std::string::npos)
        text.replace(place, mutation.find.size(), mutation.replacement);
    return "static const float4 gOutputSize = float4(9.0, 7.0, 1.0 / 9.0, 1.0 / 7.0);\n"
           "#define gInCoarseDepth gTexture0\n"
           "#define gInCoarseDepth_sampler gTexture0_sampler\n" +
           text;
}

Image depths() {
    Random random(11);
    const float odd[] = {std::numeric_limits<float>::quiet_NaN(), -1.0f, 0.0f, 1e38f};
    Image image(width, height);
    for (int i = 0; i < width * height; ++i)
        image.texels[static_cast<size_t>(i)] =
            dvec4(i % 6 == 5 ? odd[i / 6 % 4] : random.in(1.0f, 9.0f), 0.0, 0.0, 0.0);
    return image;
}

double known(const Image& image, int x, int y) {
    const double depth = image.at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1)).x;
    return depth > 0.0 ? std::min(depth, sky) : sky;
}

// Depths around each texel, whether it has neighbours, and the change to the side that is nearer in depth.
Comparison plus(const Mutation& mutation = {}) {
    const Texture texture{depths(), false};
    std::vector<Row> rows;
    for (int i = 0; i < width * height; ++i)
        rows.push_back({vec4((static_cast<float>(i % width) + 0.5f) / width,
                             (static_cast<float>(i / width) + 0.5f) / height, i % width, i / width)});
    const std::string body = "DepthPlus d = readDepthPlus(in0.xy);\n"
                             "bool2 before = hasTexelBefore(in0.xy), after = hasTexelAfter(in0.xy);\n"
                             "out0 = float4(d.left, d.right, d.up, d.down);\n"
                             "out1 = float4(d.centre, readDepth(in0.xy), depthAlone(d.up).left, before.x);\n"
                             "out2 = float4(changeOfDepth(d.left, d.centre, d.right, before.x, after.x),\n"
                             "              changeOfDepth(d.up, d.centre, d.down, before.y, after.y));";
    return {{"DepthPlus", {}, body, 1, 3, {}, reprise::Stage::compute, {texture}, declared(mutation)},
            rows,
            [texture](const Row& in) {
                const auto x = static_cast<int>(in[0].z), y = static_cast<int>(in[0].w);
                const auto at = [&](int i, int j) { return known(texture.image, x + i, y + j); };
                const auto change = [&](double before, double after, bool hasBefore, bool hasAfter) {
                    const double here = at(0, 0);
                    const bool first =
                        hasBefore && (!hasAfter || std::abs(before - here) < std::abs(after - here));
                    return first ? dvec2(here - before, before) : dvec2(after - here, after);
                };
                const dvec2 across = change(at(-1, 0), at(1, 0), x > 0, x + 1 < width);
                const dvec2 down = change(at(0, -1), at(0, 1), y > 0, y + 1 < height);
                return std::vector{near(dvec4(at(-1, 0), at(1, 0), at(0, -1), at(0, 1)), 0.0),
                                   near(dvec4(at(0, 0), at(0, 0), at(0, -1), x > 0 ? 1.0 : 0.0), 0.0),
                                   near(dvec4(across, down), 0x1p-24 * sky)};
            }};
}

TEST(CoarseDepth, isReadWithItsNeighboursAndTheirNearerSide) {
    expectAgrees(plus());
}

TEST(CoarseDepth, wrongSidesAreCaught) {
    for (const Mutation& mutation :
         {Mutation{header, "d.left = knownDepth(leftUp.x);", "d.left = knownDepth(leftUp.w);"},
          {header, "differenceBefore < differenceAfter", "differenceBefore >= differenceAfter"},
          {header, "return uv > gOutputSize.zw;", "return uv > 0.0;"},
          {header, "return uv < 1.0 - gOutputSize.zw;", "return uv < 1.0;"},
          {header, "min(depth, SKY_DEPTH) : SKY_DEPTH", "depth : SKY_DEPTH"}}) {
        ASSERT_NE(hlslText(header).find(mutation.find), std::string::npos) << mutation.find;
        EXPECT_NE(mismatches(plus(mutation)), "") << mutation.find;
    }
}

} // namespace
} // namespace functions
