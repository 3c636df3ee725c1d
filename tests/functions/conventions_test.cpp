// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/conventions.hlsli";

glm::dmat4 matrixOf(const Row& in) {
    return {dvec4(in[0]), dvec4(in[1]), dvec4(in[2]), dvec4(in[3])}; // GLM's columns, in memory order
}

// Four products a component; each partial sum is at most the sum of the absolute products: 4 roundings on
// each, one of slack. The absolute term covers products that are flushed.
double productBound(const glm::dmat4& m, dvec4 v) {
    double largestSum = 0.0;
    for (int row = 0; row < 4; ++row) {
        double sum = 0.0;
        for (int column = 0; column < 4; ++column)
            sum += std::abs(m[column][row] * v[column]);
        largestSum = std::max(largestSum, sum);
    }
    return 5.0 * roundoff * largestSum + 4.0 * flush;
}

// The bytes of a row_major float4x4: its rows one after the other. MATRIX_ROW_VECTORS is for engines that
// store a column-vector matrix row after row.
Comparison transforming(bool rowAfterRow) {
    Random random(1);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i) {
        Row row;
        for (int k = 0; k < 5; ++k)
            row.push_back(random.in4(-10.0f, 10.0f));
        rows.push_back(row);
    }
    for (float value : hostileFinite)
        rows.push_back({vec4(value, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(0, 0, 0, 1),
                        vec4(1, value, 2, 1)});
    return {{"transform",
             {header},
             "float4x4 m = float4x4(in0, in1, in2, in3); out0 = transform(m, in4);",
             5,
             1,
             {{"MATRIX_ROW_VECTORS", rowAfterRow}}},
            rows,
            [rowAfterRow](const Row& in) {
                const glm::dmat4 m = rowAfterRow ? glm::transpose(matrixOf(in)) : matrixOf(in);
                return std::vector{near(m * dvec4(in[4]), productBound(m, dvec4(in[4])))};
            }};
}

TEST(Conventions, transformAppliesAMatrixStoredAsGlmStoresIt) {
    expectAgrees(transforming(false));
}

TEST(Conventions, transformAppliesAMatrixStoredRowAfterRow) {
    expectAgrees(transforming(true));
}

TEST(Conventions, theOtherOrderIsCaught) {
    expectCaught(transforming(false), {header, "return mul(v, m);", "return mul(m, v);"});
    expectCaught(transforming(true), {header, "#if MATRIX_ROW_VECTORS", "#if !MATRIX_ROW_VECTORS"});
}

TEST(Conventions, theLargestColourIsTheLargestBinary16) {
    const auto rows = run({"MAX_COLOUR", {header}, "out0.x = MAX_COLOUR;"}, {{vec4(0.0f)}});
    EXPECT_EQ(rows[0][0].x, static_cast<float>(oracle::maxColour));
    EXPECT_EQ((2.0 - std::exp2(-10.0)) * std::exp2(15.0), oracle::maxColour);
}

} // namespace
} // namespace functions
