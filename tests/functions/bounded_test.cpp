// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/bounded.hlsli";

// v, low, high
Comparison holding() {
    std::vector<Row> rows;
    for (float v : hostileAny)
        for (float low : {-65504.0f, -1.0f, 0.0f, 0.5f})
            for (float width : {0.0f, 0.25f, 1e30f})
                rows.push_back({vec4(v, low, low + width, 0.0f)});
    return {{"bounded",
             {header},
             "out0 = float4(bounded(in0.x, in0.y, in0.z), bounded(in0.xx, in0.y, in0.z).y, 0.0, 0.0);"
             "out1 = bounded(in0.xxxx, in0.y, in0.z);"
             "out0.zw = bounded(in0.xxx, in0.y, in0.z).xz;",
             1,
             2},
            rows,
            [](const Row& in) {
                // It chooses: exact, but for flushed denormals.
                const dvec4 value(oracle::held(in[0].x, in[0].y, in[0].z));
                return std::vector{near(value, flush), near(value, flush)};
            }};
}

TEST(Bounded, valuesAreHeldAndNaNIsTheLowerEnd) {
    expectAgrees(holding());
}

TEST(Bounded, clampsThatNaNPassesAreCaught) {
    expectCaught(holding(), {header, "v > low ? min(v, high) : low", "v < low ? low : min(v, high)"});
    expectCaught(holding(), {header, "v > low ? min(v, high) : low", "v > low ? v : low"});
    expectCaught(holding(), {header, "bounded(v.z, low, high)", "bounded(v.y, high, low)"});
}

} // namespace
} // namespace functions
