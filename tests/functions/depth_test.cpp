// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "projections.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/depth.hlsli";

std::map<std::string, int> definesOf(const Projection& projection) {
    return {{"ORTHOGRAPHIC", projection.orthographic}, {"DEPTH_REVERSED", projection.reversed}};
}

// Linear depths over the range of the projection, its ends among them. Infinite ones end at 1e6 m.
std::vector<double> depthsOf(const Projection& projection) {
    const double far = std::min(projection.farM, 1e6);
    std::vector<double> depths = {projection.nearM, far};
    for (int i = 1; i < 500; ++i)
        depths.push_back(projection.nearM * std::pow(far / projection.nearM, i / 500.0));
    return depths;
}

Comparison toLinear(const Projection& projection) {
    const dvec2 coefficients = linearDepthCoefficients(projection);
    std::vector<Row> rows;
    for (double linear : depthsOf(projection))
        rows.push_back(
            {vec4(oracle::deviceDepth(linear, projection.matrix), coefficients.x, coefficients.y, 0.0f)});
    return {{"linearDepthFromDevice",
             {header},
             "out0.x = linearDepthFromDevice(in0.x, in0.yz);",
             1,
             1,
             definesOf(projection)},
            rows,
            [&projection](const Row& in) {
                // The oracle takes the device depth as it was rounded to binary32. What the float form adds
                // is the rounding of both coefficients and of the sum, at the size of the larger coefficient.
                const double linear = oracle::linearDepth(in[0].x, projection.matrix);
                const double larger = std::max(std::abs(in[0].y), std::abs(in[0].z));
                const double slope = projection.orthographic ? 1.0 : linear * linear;
                return std::vector{near(linear, 5.0 * roundoff * larger * slope + divisionError * linear)};
            }};
}

TEST(Depth, linearDepthAgreesForEveryDepthKind) {
    for (const Projection& projection : projections()) {
        SCOPED_TRACE(projection.name);
        expectAgrees(toLinear(projection));
    }
}

TEST(Depth, linearDepthOfSwappedCoefficientsIsCaught) {
    const auto all = projections();
    expectCaught(toLinear(all[0]), {header, "deviceDepth * coefficients.x + coefficients.y",
                                    "deviceDepth * coefficients.y + coefficients.x"});
    expectCaught(toLinear(all[0]), {header, "#if ORTHOGRAPHIC", "#if !ORTHOGRAPHIC"});
}

TEST(Depth, farPlaneOfAnInfiniteProjectionIsFinite) {
    // 1/1e-30 within the error of a division.
    for (float affine : {0.0f, -0.0f, denormal, -1e-8f}) {
        const auto rows = run({"far plane", {header}, "out0.x = linearDepthFromDevice(in0.x, in0.yz);"},
                              {{vec4(1.0f, affine, 0.0f, 0.0f)}});
        EXPECT_NEAR(rows[0][0].x, 1e30, 1e30 * 1e-6) << "affine part " << affine;
    }
}

TEST(Depth, farPlaneWithoutItsGuardIsCaught) {
    const Comparison infinite = {{"far plane", {header}, "out0.x = linearDepthFromDevice(in0.x, in0.yz);"},
                                 {{vec4(0.0f, 10.0f, 0.0f, 0.0f)}},
                                 [](const Row&) { return std::vector{near(1e30, 1e24)}; }};
    expectCaught(infinite, {header, "1.0 / max(affine, 1e-30)", "1.0 / affine"});
}

Comparison roundTrip(const Projection& projection) {
    const dvec2 coefficients = linearDepthCoefficients(projection);
    std::vector<Row> rows;
    for (double linear : depthsOf(projection))
        rows.push_back({vec4(linear, coefficients.x, coefficients.y, 0.0f)});
    return {{"depth round trip",
             {header},
             "out0.x = deviceDepthFromLinear(in0.x, in0.yz); out1.x = linearDepthFromDevice(out0.x, in0.yz);",
             1,
             2,
             definesOf(projection)},
            rows,
            [&projection](const Row& in) {
                const double linear = in[0].x, x = std::abs(in[0].y), y = std::abs(in[0].z);
                const bool parallel = projection.orthographic;
                // (1/z - y) / x: each term rounded, then divided. The device depth's error, times x, is what
                // the way back sees of it.
                const double term = parallel ? linear : 1.0 / linear;
                const double device = oracle::deviceDepth(linear, projection.matrix);
                const double error = (divisionError * term + 3.0 * roundoff * (term + y)) / x + divisionError;
                const double slope = parallel ? 1.0 : linear * linear;
                const double back =
                    (error * x + 5.0 * roundoff * std::max(x, y)) * slope + divisionError * linear;
                return std::vector{near(device, error), near(linear, back)};
            }};
}

TEST(Depth, deviceDepthAgreesAndLeadsBackForEveryDepthKind) {
    for (const Projection& projection : projections()) {
        SCOPED_TRACE(projection.name);
        expectAgrees(roundTrip(projection));
    }
}

TEST(Depth, deviceDepthOfTheWrongSignIsCaught) {
    expectCaught(roundTrip(projections()[0]), {header, "(1.0 / max(linearDepth, 1e-30) - coefficients.y)",
                                               "(1.0 / linearDepth + coefficients.y)"});
}

TEST(Depth, noFiniteInputGivesNaNOrInfinity) {
    std::vector<Row> rows = triples(hostileFinite);
    for (bool orthographic : {false, true}) {
        const Function function = {"linear depth",
                                   {header},
                                   "out0.x = linearDepthFromDevice(in0.x, in0.yz);",
                                   1,
                                   1,
                                   {{"ORTHOGRAPHIC", orthographic}}};
        const auto outputs = run(function, rows);
        for (size_t i = 0; i < rows.size(); ++i) {
            const bool overflows = std::abs(static_cast<double>(rows[i][0].x) * rows[i][0].y) > 3e38;
            if (orthographic && overflows) continue; // 1e60 metres are no depth
            EXPECT_FALSE(std::isnan(outputs[i][0].x))
                << rows[i][0].x << " " << rows[i][0].y << " " << rows[i][0].z;
            EXPECT_TRUE(orthographic || std::isfinite(outputs[i][0].x)) << i;
        }
    }
}

Comparison closer(bool reversed) {
    std::vector<Row> rows;
    const float marks[] = {0.0f, -0.0f, 1e-7f,    0.5f,      0.50000006f,
                           1.0f, -1.0f, infinity, -infinity, notANumber};
    for (float a : marks)
        for (float b : marks)
            rows.push_back({vec4(a, b, 0, 0)});
    return {{"isCloser",
             {header},
             "out0.x = isCloser(in0.x, in0.y) ? 1.0 : 0.0;",
             1,
             1,
             {{"DEPTH_REVERSED", reversed}}},
            rows,
            [reversed](const Row& in) {
                return std::vector{near(oracle::isCloser(in[0].x, in[0].y, reversed) ? 1.0 : 0.0, 0.0)};
            }};
}

TEST(Depth, closerIsStrictAndNeverNaN) {
    expectAgrees(closer(false));
    expectAgrees(closer(true));
}

TEST(Depth, closerOfTheOtherDepthKindIsCaught) {
    expectCaught(closer(true), {header, "#if DEPTH_REVERSED", "#if !DEPTH_REVERSED"});
    expectCaught(closer(false), {header, "return a < b;", "return a <= b;"});
    expectCaught(closer(false), {header, "return a < b;", "return !(a >= b);"});
}

} // namespace
} // namespace functions
