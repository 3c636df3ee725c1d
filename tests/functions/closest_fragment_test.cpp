// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/closest_fragment.hlsli";

const std::string fillDepths = "DepthSquare d;\n"
                               "d.leftUp = in0.x; d.up = in0.y; d.rightUp = in0.z;\n"
                               "d.left = in1.x; d.centre = in1.y; d.right = in1.z;\n"
                               "d.leftDown = in2.x; d.down = in2.y; d.rightDown = in2.z;\n";

oracle::DepthSquare depthsOf(const Row& in) {
    oracle::DepthSquare square;
    for (int i = 0; i < 9; ++i)
        square[static_cast<size_t>(i)] = in[static_cast<size_t>(i / 3)][i % 3];
    return square;
}

Row rowOf(const oracle::DepthSquare& square) {
    Row row(3, vec4(0.0f));
    for (int i = 0; i < 9; ++i)
        row[static_cast<size_t>(i / 3)][i % 3] = static_cast<float>(square[static_cast<size_t>(i)]);
    return row;
}

std::map<std::string, int> reversedIs(bool reversed) {
    return {{"DEPTH_REVERSED", reversed}};
}

// The step along x and y, different and of both signs.
const dvec2 step(0.25, -2.0);

glm::ivec2 texelsOf(const Row& out) {
    return glm::ivec2(xy(out[0]) / step);
}

// Nine different depths: which one is closest is no question. Its depth comes with its offset.
Comparison closest(bool reversed) {
    Random random(1);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i) {
        oracle::DepthSquare square;
        for (size_t k = 0; k < 9; ++k)
            square[k] = (static_cast<double>(k) + random.unit()) / 9.0;
        for (size_t k = 8; k > 0; --k)
            std::swap(square[k], square[random.below(k + 1)]);
        rows.push_back(rowOf(square));
    }
    return {{"closestFragment",
             {header},
             fillDepths + "out0.xy = closestFragment(d, float2(0.25, -2.0), out0.z);",
             3,
             1,
             reversedIs(reversed)},
            rows,
            [reversed](const Row& in) {
                const oracle::DepthSquare square = depthsOf(in);
                const glm::ivec2 offset = oracle::closestFragment(square, reversed);
                const double depth = square[static_cast<size_t>((offset.y + 1) * 3 + offset.x + 1)];
                return std::vector{near(dvec3(dvec2(offset) * step, depth), 0.0)};
            }};
}

TEST(ClosestFragment, offsetLeadsToTheClosestOfNine) {
    expectAgrees(closest(false));
    expectAgrees(closest(true));
}

TEST(ClosestFragment, wrongOffsetsOrAForgottenRowAreCaught) {
    expectCaught(closest(false), {header, "float outerY = isCloser(down.x, up.x) ? step.y : -step.y;",
                                  "float outerY = isCloser(down.x, up.x) ? -step.y : step.y;"});
    expectCaught(closest(false), {header, "float outerY = isCloser(down.x, up.x) ? step.y : -step.y;",
                                  "float outerY = isCloser(down.x, up.x) ? step.x : -step.x;"});
    expectCaught(closest(false), {header, "float2(right, step) : float2(left, -step)",
                                  "float2(right, 1.0) : float2(left, -1.0)"});
    expectCaught(closest(false), {header, "closestInRow(d.leftUp, d.up, d.rightUp, step.x)",
                                  "closestInRow(d.leftUp, d.up, d.leftUp, step.x)"});
    expectCaught(closest(false),
                 {header, "depth = isCloser(outer.x, own.x) ? outer.x : own.x;", "depth = own.x;"});
    expectCaught(closest(true), {"reprise/depth.hlsli", "#if DEPTH_REVERSED", "#if !DEPTH_REVERSED"});
}

// Of depths on few levels, or NaN, what is chosen must be no farther than anything.
std::vector<Row> tiedRows(bool withNaN) {
    Random random(2);
    std::vector<Row> rows;
    for (int i = 0; i < 3000; ++i) {
        oracle::DepthSquare square;
        for (double& depth : square)
            depth = 0.25 * static_cast<double>(random.below(4));
        if (withNaN) square[random.below(9)] = square[random.below(9)] = notANumber;
        rows.push_back(rowOf(square));
    }
    return rows;
}

std::string wrongTies(bool reversed, const Mutation& mutation = {}) {
    const auto rows = tiedRows(false);
    const auto out = run(closest(reversed).function, rows, {.mutation = mutation});
    for (size_t i = 0; i < rows.size(); ++i) {
        const oracle::DepthSquare square = depthsOf(rows[i]);
        const glm::ivec2 offset = texelsOf(out[i]), best = oracle::closestFragment(square, reversed);
        const auto depthAt = [&](glm::ivec2 o) {
            return square[static_cast<size_t>((o.y + 1) * 3 + o.x + 1)];
        };
        if (depthAt(offset) != depthAt(best)) return "row " + std::to_string(i) + " is not the closest";
        if (square[4] == depthAt(best) && offset != glm::ivec2(0))
            return "row " + std::to_string(i) + " leaves the centre";
    }
    return "";
}

TEST(ClosestFragment, centreWinsAgainstEquals) {
    EXPECT_EQ(wrongTies(false), "");
    EXPECT_EQ(wrongTies(true), "");
}

TEST(ClosestFragment, centreThatLosesAgainstEqualsIsCaught) {
    EXPECT_NE(wrongTies(false, {header, "return isCloser(side.x, centre) ? side : float2(centre, 0.0);",
                                "return isCloser(centre, side.x) ? float2(centre, 0.0) : side;"}),
              "");
}

TEST(ClosestFragment, nanNeverWinsOverTheCentre) {
    for (bool reversed : {false, true}) {
        const auto rows = tiedRows(true);
        const auto out = run(closest(reversed).function, rows);
        for (size_t i = 0; i < rows.size(); ++i) {
            const oracle::DepthSquare square = depthsOf(rows[i]);
            const glm::ivec2 offset = texelsOf(out[i]);
            const double chosen = square[static_cast<size_t>((offset.y + 1) * 3 + offset.x + 1)];
            if (std::isnan(square[4]))
                EXPECT_EQ(offset, glm::ivec2(0)) << "row " << i;
            else
                EXPECT_FALSE(std::isnan(chosen)) << "row " << i << " offset " << offset.x << " " << offset.y;
        }
    }
}

// Each depth of the square at every pixel, by gathers and by single reads. GLES has the latter, in its
// fragment form.
std::string wrongReads(glm::ivec2 size, bool gathers, const Mutation& mutation = {}) {
    const Image depth = randomImage(size.x, size.y, 3);
    const std::string texel =
        "float2(1.0 / " + std::to_string(size.x) + ".0, 1.0 / " + std::to_string(size.y) + ".0)";
    const Function function{
        "readDepthSquare",
        {header},
        "DepthSquare d = readDepthSquare(TEXTURE_ARGUMENT(gTexture0), positionPx.xy * " + texel + ", " +
            texel +
            ");"
            "out0.xyz = float3(d.leftUp, d.up, d.rightUp); out1.xyz = float3(d.left, d.centre, d.right);"
            "out2.xyz = float3(d.leftDown, d.down, d.rightDown);",
        0,
        3,
        {{"PLATFORM_GLES", !gathers}},
        reprise::Stage::fragment,
        {{depth, false}}};
    const auto out = run(function, {}, {.mutation = mutation, .extent = size});
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const Row& read = out[static_cast<size_t>(y * size.x + x)];
            if (depthsOf(read) != oracle::depthSquareAt(depth, x, y)) // point reads copy: exact
                return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " of " +
                       std::to_string(size.x) + "x" + std::to_string(size.y);
        }
    return "";
}

TEST(ClosestFragment, nineDepthsAreReadByGathersAndBySingleReads) {
    for (glm::ivec2 size : imageSizes)
        for (bool gathers : {false, true})
            EXPECT_EQ(wrongReads(size, gathers), "") << (gathers ? "gathers" : "reads");
}

TEST(ClosestFragment, wrongTexelOfAGatherOrAReadIsCaught) {
    EXPECT_NE(wrongReads({7, 5}, true, {header, "d.leftUp = leftUp.w;", "d.leftUp = leftUp.x;"}), "");
    EXPECT_NE(wrongReads({7, 5}, false,
                         {header, "SAMPLE_OFFSET(depth, uv, texelSize, -1, 1)",
                          "SAMPLE_OFFSET(depth, uv, texelSize, -1, -1)"}),
              "");
}

} // namespace
} // namespace functions
