// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include "reprise/camera.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/jitter.hlsli";

Comparison inverses() {
    std::vector<Row> rows;
    for (uint64_t index = 0; index < 4096; ++index)
        rows.push_back({vec4(index, 0, 0, 0)});
    // Base 2 is exact. Base 3 has up to 8 digits, each with the error of its place (a chain of divisions) and
    // of its sum: the places fall by 3, so the errors stay within a few roundings at 1.
    return {{"radicalInverse",
             {header},
             "out0.x = radicalInverse(in0.x, 2.0); out1.x = radicalInverse(in0.x, 3.0);",
             1,
             2},
            rows,
            [](const Row& in) {
                const auto index = static_cast<uint64_t>(in[0].x);
                return std::vector{near(oracle::radicalInverse(index, 2), 0.0),
                                   near(oracle::radicalInverse(index, 3), 3.0 * divisionError)};
            }};
}

TEST(Jitter, radicalInverseIsExactInDigitsUpTo4095) {
    expectAgrees(inverses());
}

TEST(Jitter, radicalInverseThatLosesDigitsIsCaught) {
    expectCaught(inverses(), {header, "floor((index + 0.5) / base)", "floor((index + 1.5) / base)"});
    expectCaught(inverses(), {header, "digit < 12", "digit < 11"});
}

// Frames around the period, and far out where floats still count by ones.
std::vector<Row> frames() {
    std::vector<Row> rows;
    for (float period : {8.0f, 16.0f}) {
        for (int frame = 0; frame < 200; ++frame)
            rows.push_back({vec4(frame, period, 0, 0)});
        for (int frame = 1048560; frame < 1048600; ++frame)
            rows.push_back({vec4(frame, period, 0, 0)});
    }
    return rows;
}

Comparison halton() {
    return {
        {"haltonJitterPx", {header}, "out0.xy = haltonJitterPx(in0.x, in0.y);"}, frames(), [](const Row& in) {
            const auto frame = static_cast<uint64_t>(in[0].x), period = static_cast<uint64_t>(in[0].y);
            // As radicalInverse, and the rounding of the subtraction.
            return std::vector{near(oracle::haltonJitterPx(frame, period), 4.0 * divisionError)};
        }};
}

TEST(Jitter, haltonRepeatsAfterItsPeriodAndStartsAtItsFirstIndex) {
    expectAgrees(halton());
}

TEST(Jitter, haltonFromIndexZeroOrWithSwappedBasesIsCaught) {
    expectCaught(halton(), {header, "floor((frame + 0.5) / period) + 1.0", "floor((frame + 0.5) / period)"});
    expectCaught(halton(), {header, "float2(radicalInverse(index, 2.0), radicalInverse(index, 3.0))",
                            "float2(radicalInverse(index, 3.0), radicalInverse(index, 2.0))"});
    expectCaught(halton(), {header, "radicalInverse(index, 3.0)) - 0.5", "radicalInverse(index, 3.0))"});
}

TEST(Jitter, haltonStaysWithinHalfAPixel) {
    for (const Row& out :
         run({"haltonJitterPx", {header}, "out0.xy = haltonJitterPx(in0.x, in0.y);"}, frames()))
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_GE(out[0][axis], -0.5f);
            EXPECT_LT(out[0][axis], 0.5f);
        }
}

Comparison helix() {
    return {{"uniform4HelixJitterPx", {header}, "out0.xy = uniform4HelixJitterPx(in0.x);"},
            frames(),
            [](const Row& in) {
                // Quarters are exact.
                return std::vector{near(oracle::uniform4HelixJitterPx(static_cast<uint64_t>(in[0].x)), 0.0)};
            }};
}

TEST(Jitter, helixVisitsTheQuarterPoints) {
    expectAgrees(helix());
}

TEST(Jitter, helixThatWalksAroundIsCaught) {
    // Around the square instead of across: two of its steps stay on their side of the centre line.
    expectCaught(helix(), {header, "index > 0.5 && index < 2.5", "index > 1.5"});
}

TEST(Jitter, everyStepOfTheHelixCrossesTheHorizontalCentreLine) {
    std::vector<Row> rows;
    for (int frame = 0; frame < 9; ++frame)
        rows.push_back({vec4(frame, 0, 0, 0)});
    const auto points = run({"helix", {header}, "out0.xy = uniform4HelixJitterPx(in0.x);"}, rows);
    for (size_t frame = 1; frame < points.size(); ++frame)
        EXPECT_LT(points[frame][0].y * points[frame - 1][0].y, 0.0f) << "from frame " << frame - 1;
    for (size_t a = 0; a < 4; ++a)
        for (size_t b = 0; b < a; ++b)
            EXPECT_NE(points[a][0], points[b][0]) << a << " and " << b;
}

// The contract says that the CPU gives the same: within the rounding of binary32 that is tested above.
TEST(Jitter, cpuAndGpuGiveTheSameSequence) {
    using reprise::JitterSequence;
    std::vector<Row> rows;
    for (int frame = 0; frame < 40; ++frame)
        rows.push_back({vec4(frame, 0, 0, 0)});
    const auto out = run({"sequences",
                          {header},
                          "out0.xy = haltonJitterPx(in0.x, 8.0); out1.xy = haltonJitterPx(in0.x, 16.0);"
                          "out2.xy = uniform4HelixJitterPx(in0.x);",
                          1,
                          3},
                         rows);
    const JitterSequence sequences[] = {JitterSequence::halton8, JitterSequence::halton16,
                                        JitterSequence::uniform4Helix};
    for (uint64_t frame = 0; frame < 40; ++frame)
        for (size_t i = 0; i < 3; ++i) {
            const dvec2 cpu = reprise::jitterPx(sequences[i], frame), gpu = xy(out[frame][i]);
            EXPECT_LE(largest(dvec3(cpu - gpu, 0.0)), 4.0 * divisionError)
                << "sequence " << i << " frame " << frame;
        }
}

} // namespace
} // namespace functions
