// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace functions {
namespace {

const std::string header = "passes/sample_count.hlsli";

// In a loop, as the passes have it.
Comparison count(int samples) {
    const std::string body = "int counted = 0;\n"
                             "[unroll] for (int i = 0; i < SAMPLE_COUNT; ++i) ++counted;\n"
                             "out0 = float4(counted, cos(FULL_TURN), sin(0.25 * FULL_TURN), in0.w);";
    return {{"SAMPLES_" + std::to_string(samples),
             {header},
             body,
             1,
             1,
             {{"SAMPLES_" + std::to_string(samples), 1}}},
            {{vec4(0.0f)}},
            [=](const Row&) { return std::vector{near(dvec4(samples, 1.0, 1.0, 0.0), 1e-6)}; }};
}

TEST(SampleCount, isTheSwitch) {
    for (const int samples : {1, 2, 4, 8, 12, 16, 32})
        expectAgrees(count(samples));
}

TEST(SampleCount, anotherNumberIsCaught) {
    expectCaught(count(12), {header, "SAMPLE_COUNT = 12", "SAMPLE_COUNT = 8"});
    expectCaught(count(32), {header, "6.2831853", "3.1415927"});
}

} // namespace
} // namespace functions
