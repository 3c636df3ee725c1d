// SPDX-License-Identifier: Apache-2.0
#include "cache_pass.hpp"
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace functions {
namespace {

using Values = oracle::CachePass::Values;

const std::string header = "passes/cached_values.hlsli";

struct Kind {
    std::string macro;
    Values values;
};
const Kind kinds[] = {{"VALUES_ONE", Values::one},
                      {"VALUES_TWO", Values::two},
                      {"VALUES_FOUR", Values::four},
                      {"VALUES_OCCLUSION_IN_INTEGER", Values::occlusionInInteger},
                      {"VALUES_SHADOW_IN_INTEGER", Values::shadowInInteger},
                      {"VALUES_WITH_FRAMES", Values::withFrames}};

// Texels of values in [0,1], and of packed pairs; some hold what no cache can.
std::vector<Row> texels(Values values) {
    Random random(7);
    const float none = std::numeric_limits<float>::quiet_NaN();
    const float broken[] = {none, 1e6f, -1e6f, std::numeric_limits<float>::infinity()};
    std::vector<Row> rows;
    for (int i = 0; i < 400; ++i) {
        vec4 texel;
        for (int c = 0; c < 4; ++c)
            texel[c] = random.in(0.0f, 1.0f);
        if (oracle::isPacked(values)) texel.x *= 31.9f;
        if (values == Values::withFrames) texel.x = std::floor(texel.x * 0x1p24f);
        if (i % 8 == 0) texel[i / 8 % 4] = broken[i / 32 % 4];
        rows.push_back({texel, vec4(random.in(1.0f, 100.0f), random.in(0.0f, 255.0f), 0.0f, 0.0f)});
    }
    return rows;
}

// What the cache takes of a texel, packed again; its state; depth found in them, whether a history can hold
// the texel, the least of the values and the last.
Comparison texelsOf(const Kind& kind) {
    const std::string body = "CachedValues v = knownValues(in0);\n"
                             "float4 state = packState(in1.y, in1.x);\n"
                             "out0 = packValues(v, in1.y, in1.x);\n"
                             "out1 = float4(state.rg, areCacheable(unpackValues(in0)) ? 1.0 : 0.0,\n"
                             "              depthOf(out0, state));\n"
                             "out2 = float4(smallest(v), channelOf(v, VALUE_COUNT - 1), 0.0, 0.0);";
    return {{kind.macro, {header}, body, 2, 3, {{kind.macro, 1}}}, texels(kind.values), [=](const Row& in) {
                const bool framed = kind.values == Values::withFrames; // what is fresh is two values
                const dvec4 unpacked =
                    oracle::unpackedValues(framed ? Values::two : kind.values, dvec4(in[0]));
                const int count = oracle::valueCount(kind.values);
                dvec4 known = unpacked;
                bool cacheable = !framed || oracle::isCacheable(oracle::unpackedValues(kind.values, in[0]));
                double least = HUGE_VAL;
                for (int i = 0; i < 4; ++i) {
                    if (!oracle::isNumber(unpacked[i], 65504.0)) known[i] = 0.0;
                    if (i >= count) continue;
                    cacheable = cacheable && (framed || oracle::isNumber(unpacked[i], 65504.0));
                    least = std::min(least, known[i]);
                }
                const double depth = in[1].x, frames = in[1].y;
                const bool apart = oracle::isDepthApart(kind.values);
                // Packing again what was packed errs by roundings of numbers up to 32.
                return std::vector{
                    near(oracle::packedValues(kind.values, known, depth, frames), framed ? 1.0 : 8e-6),
                    near(dvec4(frames, apart ? depth : 0.0, cacheable ? 1.0 : 0.0, depth), 0.0),
                    near(dvec2(least, known[count - 1]), 1e-6)};
            }};
}

TEST(CachedValues, texelsHoldWhatTheSwitchSays) {
    for (const Kind& kind : kinds)
        expectAgrees(texelsOf(kind));
}

TEST(CachedValues, wrongLayoutsAreCaught) {
    expectCaught(texelsOf(kinds[0]), {header, "return float4(values, depth, 0.0, 0.0);",
                                      "return float4(values, 0.0, depth, 0.0);"});
    expectCaught(texelsOf(kinds[1]), {header, "return state.g;", "return values.g;"});
    expectCaught(texelsOf(kinds[2]), {header, "min(values.z, values.w)", "values.z"});
    expectCaught(texelsOf(kinds[3]),
                 {header, "? unpackOcclusionInInteger(texel.r)", "? unpackShadowInInteger(texel.r)"});
    expectCaught(texelsOf(kinds[4]), {header, "unpackShadowInInteger(texel.r) : 2.0 * LARGEST_NUMBER",
                                      "unpackShadowInInteger(texel.r) : 1.0"});
    expectCaught(texelsOf(kinds[1]),
                 {header, "return abs(values) <= MAX_COLOUR ? values : 0.0;", "return values;"});
}

} // namespace
} // namespace functions
