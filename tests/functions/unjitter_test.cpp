// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "squares.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/unjitter.hlsli";

std::vector<Row> jitters() {
    Random random(1);
    std::vector<Row> rows;
    for (float jitter : {0.0f, -0.0f, denormal, -0.5f, 0.5f, 0.25f, -0.25f, 0.49999997f, 1e-7f})
        rows.push_back({vec4(jitter)});
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.in(-0.5f, 0.5f))});
    return rows;
}

dvec3 asVector(const oracle::AxisWeights& weights) {
    return {weights[0], weights[1], weights[2]};
}

Comparison bilinear() {
    return {{"unjitterWeightsBilinear", {header}, "out0.xyz = unjitterWeightsBilinear(in0.x);"},
            jitters(),
            [](const Row& in) {
                // One subtraction from 1.
                return std::vector{near(asVector(oracle::unjitterWeightsBilinear(in[0].x)), roundoff)};
            }};
}

Comparison gaussian() {
    return {{"unjitterWeightsGaussian", {header}, "out0.xyz = unjitterWeightsGaussian(in0.x);"},
            jitters(),
            [](const Row& in) {
                const dvec3 weights = asVector(oracle::unjitterWeightsGaussian(in[0].x));
                // Exponents reach 7.4 and carry five roundings, which exp2 turns into 26 relative ones; exp2
                // itself may err by 3 + 2 x steps, 36 roundings; the sum errs as much, and there is a
                // division.
                return std::vector{near(weights, (2.0 * 62.0 * roundoff + divisionError) * weights)};
            }};
}

TEST(Unjitter, bilinearWeightsAreATentAtTheJitter) {
    expectAgrees(bilinear());
}

TEST(Unjitter, gaussianWeightsAreNormalisedAroundTheJitter) {
    expectAgrees(gaussian());
}

TEST(Unjitter, flippedJitterIsCaught) {
    expectCaught(bilinear(), {header, "float3(max(-jitterPx, 0.0), 1.0 - abs(jitterPx), max(jitterPx, 0.0))",
                              "float3(max(jitterPx, 0.0), 1.0 - abs(jitterPx), max(-jitterPx, 0.0))"});
    expectCaught(gaussian(), {header, "float3(-1.0, 0.0, 1.0) - clamp(", "float3(-1.0, 0.0, 1.0) + clamp("});
}

TEST(Unjitter, gaussianOfAnotherBaseOrNotNormalisedIsCaught) {
    expectCaught(gaussian(), {header, "-0.72134752", "-0.5"});
    expectCaught(gaussian(), {header, "weights / (weights.x + weights.y + weights.z)", "weights"});
}

Comparison weighing() {
    Random random(2);
    std::vector<Row> rows = squares(2);
    for (Row& row : rows) {
        row.push_back(random.in4(0.0f, 1.0f));
        row.push_back(random.in4(0.0f, 1.0f));
    }
    return {{"weighNeighbourhood",
             {header},
             fillNeighbourhood + "out0.xyz = weighNeighbourhood(n, in9.xyz, in10.xyz);",
             11},
            rows,
            [](const Row& in) {
                const dvec3 x = xyz(in[9]), y = xyz(in[10]);
                const dvec3 sum = oracle::weighSquare(squareOf(in), {x[0], x[1], x[2]}, {y[0], y[1], y[2]});
                // All terms are of one sign: two products and four sums deep.
                return std::vector{near(sum, 8.0 * roundoff * sum + flush)};
            }};
}

TEST(Unjitter, weightsGoToTheirTexels) {
    expectAgrees(weighing());
}

TEST(Unjitter, mirroredOrTransposedTexelsAreCaught) {
    expectCaught(weighing(), {header, "weightsX.x * n.leftUp + weightsX.y * n.up + weightsX.z * n.rightUp",
                              "weightsX.z * n.leftUp + weightsX.y * n.up + weightsX.x * n.rightUp"});
    expectCaught(weighing(), {header, "weightsY.x * (", "weightsY.z * ("});
}

// What unjitter is for: the image is moved by +jitter, so pixel p shows the place p - jitter. Of a linear
// ramp the tent gives back exactly what stands at p.
Comparison ramp(const std::string& weights) {
    Random random(3);
    std::vector<Row> rows;
    for (int i = 0; i < 500; ++i) {
        const vec4 jitter = random.in4(-0.5f, 0.5f);
        Row row;
        for (int texel = 0; texel < 9; ++texel) {
            const auto x = static_cast<float>(texel % 3 - 1), y = static_cast<float>(texel / 3 - 1);
            row.push_back(vec4(100.0f + 3.0f * (x - jitter.x) - 7.0f * (y - jitter.y)));
        }
        row.push_back(jitter);
        rows.push_back(row);
    }
    return {{"ramp",
             {header},
             fillNeighbourhood + "out0.xyz = weighNeighbourhood(n, " + weights + "(in9.x), " + weights +
                 "(in9.y));",
             10},
            rows,
            [](const Row&) {
                return std::vector{near(dvec3(100.0), 12.0 * roundoff * 110.0)};
            }}; // 12 roundings at 110
}

TEST(Unjitter, bilinearGivesARampBackFromItsJitteredImage) {
    expectAgrees(ramp("unjitterWeightsBilinear"));
}

TEST(Unjitter, rampUnderFlippedJitterIsCaught) {
    expectCaught(ramp("unjitterWeightsBilinear"),
                 {header, "float3(max(-jitterPx, 0.0), 1.0 - abs(jitterPx), max(jitterPx, 0.0))",
                  "float3(max(jitterPx, 0.0), 1.0 - abs(jitterPx), max(-jitterPx, 0.0))"});
}

} // namespace
} // namespace functions
