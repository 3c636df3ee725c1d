// SPDX-License-Identifier: Apache-2.0
// What change detection makes of the values around a texel. Accumulation as a whole:
// reprojection_cache_test.cpp under tests/passes, against the oracle.
#include "cache_pass.hpp"
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace functions {
namespace {

const std::string header = "passes/accumulation.hlsli";

// What a pass declares before it includes the header, whose text stands in place of its #include.
std::string declared(const Mutation& mutation) {
    std::string text = hlslText(header);
    if (const size_t place = text.find(mutation.find); !mutation.find.empty() && place != std::string::npos)
        text.replace(place, mutation.find.size(), mutation.replacement);
    return "static const float4x4 gViewToPreviousClip = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };\n"
           "static const float4 gOutputSize = float4(64.0, 64.0, 1.0 / 64.0, 1.0 / 64.0), gViewRay = 1.0;\n"
           "static const float2 gFrameToCoarse = 1.0, gClipToDepth = float2(0.0, 1.0), gMissThreshold = "
           "1.0;\n"
           "static const float2 gSpeedPx = 1.0, gChange = float2(1.2, 0.1);\n"
           "static const float gConvergenceTime = 2.0, gMaxWeight = 0.9, gHistoryValid = 1.0;\n" +
           text;
}

// Sixteen values around a texel at (in0.x, in0.y), how alike in0.z is to them.
Comparison likeness(const Mutation& mutation = {}) {
    Random random(13);
    std::vector<Row> rows;
    for (int i = 0; i < 34 * 34; ++i) {
        Row row{vec4(i % 34, i / 34, random.in(0.0f, 1.0f), 0.0f)};
        for (int k = 0; k < 4; ++k)
            row.push_back(vec4(random.in(0.2f, 0.8f), random.in(0.2f, 0.8f), random.in(0.2f, 0.8f),
                               random.in(0.2f, 0.8f)));
        rows.push_back(row);
    }
    const std::string body = "float4 rows[4];\n"
                             "rows[0] = in1; rows[1] = in2; rows[2] = in3; rows[3] = in4;\n"
                             "float2 both = meanAndDeviation(rows, isInTile(in0.x), isInTile(in0.y));\n"
                             "Surroundings around;\n"
                             "setChannel(around, 0, both);\n"
                             "out0 = float4(both, likeness(in0.z, around), 0.0);\n"
                             "out1 = isInTile(in0.x);";
    Function function{"likeness", {}, body, 5, 2};
    function.defines = {{"VALUES_ONE", 1}, {"HISTORY_STILL", 1}, {"CHANGE_DETECTION", 1}};
    function.helpers = declared(mutation);
    return {function, rows, [](const Row& in) {
                const auto inside = [](float texel, int k) {
                    const int at = static_cast<int>(texel) + k - 1, tile = static_cast<int>(texel) / 16;
                    return at >= 16 * tile && at < 16 * tile + 16;
                };
                double count = 0.0, mean = 0.0, variance = 0.0;
                const auto each = [&](auto&& take) {
                    for (int i = 0; i < 16; ++i)
                        if (inside(in[0].x, i % 4) && inside(in[0].y, i / 4))
                            take(double{in[static_cast<size_t>(1 + i / 4)][i % 4]});
                };
                each([&](double) { count += 1.0; });
                each([&](double value) { mean += value / count; });
                each([&](double value) { variance += (value - mean) * (value - mean) / count; });
                const double deviation = std::sqrt(variance), allowed = 1.2 * deviation + 0.1;
                const double alike = std::clamp(2.0 - std::abs(in[0].z - mean) / allowed, 0.0, 1.0);
                dvec4 tile;
                for (int k = 0; k < 4; ++k)
                    tile[k] = inside(in[0].x, k) ? 1.0 : 0.0;
                return std::vector{near(dvec4(mean, deviation, alike, 0.0), 1e-5), near(tile, 0.0)};
            }};
}

TEST(Accumulation, likenessIsToTheValuesAroundWithinTheTile) {
    expectAgrees(likeness());
}

TEST(Accumulation, otherSurroundingsAreCaught) {
    for (const Mutation& mutation :
         {Mutation{header, "float4(-1.0, 0.0, 1.0, 2.0)", "float4(-2.0, -1.0, 0.0, 1.0)"},
          {header, "tile + 7.5", "tile + 8.5"},
          {header, "weightsY.y + rows[2] * weightsY.z", "weightsY.z + rows[2] * weightsY.y"},
          {header, "sqrt(dot(squares, weightsX) * perTexel)", "sqrt(dot(squares, weightsX) / 16.0)"},
          {header, "saturate(2.0 - ", "saturate(1.0 - "}}) {
        ASSERT_NE(hlslText(header).find(mutation.find), std::string::npos) << mutation.find;
        EXPECT_NE(mismatches(likeness(mutation)), "") << mutation.find;
    }
}

} // namespace
} // namespace functions
