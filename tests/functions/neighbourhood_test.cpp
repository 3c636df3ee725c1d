// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "squares.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/neighbourhood.hlsli";

using BoxOf = oracle::Box (*)(const oracle::Square&);
using BoundOf = std::pair<dvec3, dvec3> (*)(const oracle::Square&);

Comparison boxes(const std::string& function, BoxOf oracleOf, BoundOf boundOf) {
    return {{function,
             {header},
             fillNeighbourhood + "ColourBox box = " + function +
                 "(n); out0.xyz = box.minimum; out1.xyz = box.maximum;",
             9,
             2},
            squares(1),
            [=](const Row& in) {
                const oracle::Square square = squareOf(in);
                const oracle::Box box = oracleOf(square);
                const auto [low, high] = boundOf(square);
                return std::vector{near(box.minimum, low), near(box.maximum, high)};
            }};
}

std::pair<dvec3, dvec3> exact(const oracle::Square&) {
    return {dvec3(flush), dvec3(flush)}; // minimum and maximum choose, they compute nothing
}

// One sum, rounded at twice the size of the result, and halved exactly.
std::pair<dvec3, dvec3> ofMean(const oracle::Square& square) {
    const oracle::Box box = oracle::boxRounded(square);
    return {2.0 * roundoff * glm::abs(box.minimum) + flush, 2.0 * roundoff * glm::abs(box.maximum) + flush};
}

// The variance about the centre texel errs by some 24 roundings at the square of the largest difference from
// it; under the root, that is an error of its own root where the variance vanishes and a quotient elsewhere.
// The mean adds ten roundings at the largest colour.
std::pair<dvec3, dvec3> ofVariance(const oracle::Square& square) {
    dvec3 bound;
    const oracle::Box box = oracle::boxOfVariance(square);
    for (int c = 0; c < 3; ++c) {
        double reach = 0.0, largestColour = 0.0;
        for (dvec3 colour : square) {
            reach = std::max(reach, std::abs(colour[c] - square[4][c]));
            largestColour = std::max(largestColour, std::abs(colour[c]));
        }
        const double deviation = (box.maximum[c] - box.minimum[c]) / 2.0;
        const double error = 24.0 * roundoff * reach * reach;
        const double root =
            deviation > 0.0 ? std::min(std::sqrt(error), error / deviation) : std::sqrt(error);
        // A square below 1e-38 may be flushed: 1e-19 of the deviation.
        bound[c] =
            root + divisionError * deviation + (10.0 * roundoff + divisionError) * largestColour + 1.2e-19;
    }
    return {bound, bound};
}

Comparison plusBox() {
    return boxes("boxOfPlus", oracle::boxOfPlus, exact);
}
Comparison squareBox() {
    return boxes("boxOfSquare", oracle::boxOfSquare, exact);
}
Comparison roundedBox() {
    return boxes("boxRounded", oracle::boxRounded, ofMean);
}
oracle::Box varianceOracle(const oracle::Square& square) {
    return oracle::boxOfVariance(square);
}
Comparison varianceBox() {
    return boxes("boxOfVariance", varianceOracle, ofVariance);
}

TEST(Neighbourhood, plusAndSquareAreTheirSmallestAndLargest) {
    expectAgrees(plusBox());
    expectAgrees(squareBox());
}

// The colours of the other tests are not negative either.
Comparison asBits(Comparison comparison) {
    comparison.function.defines = {{"COLOURS_NOT_NEGATIVE", 1}};
    return comparison;
}

TEST(Neighbourhood, bitsOfColoursThatAreNotNegativeOrderAsTheColours) {
    for (const Comparison& each : {asBits(plusBox()), asBits(squareBox()), asBits(roundedBox())}) {
        for (const Row& row : each.inputs)
            for (const vec4& colour : row)
                ASSERT_TRUE(colour.x >= 0.0f && colour.y >= 0.0f && colour.z >= 0.0f);
        expectAgrees(each);
    }
    expectCaught(asBits(squareBox()), {header, "asfloat(max(max(asint(a), asint(b)), asint(c)))",
                                       "asfloat(max(asint(a), asint(c)))"});
}

TEST(Neighbourhood, roundedIsTheMeanOfBothBoxes) {
    expectAgrees(roundedBox());
}

TEST(Neighbourhood, varianceIsMeanAndDeviationOfNine) {
    expectAgrees(varianceBox());
}

TEST(Neighbourhood, roundedWithoutThePlusIsCaught) {
    expectCaught(roundedBox(), {header, "plus.minimum + square.minimum", "2.0 * square.minimum"});
    expectCaught(roundedBox(), {header, "plus.maximum + square.maximum", "2.0 * plus.maximum"});
}

TEST(Neighbourhood, boxWithAForgottenOrWrongTexelIsCaught) {
    expectCaught(squareBox(), {header, "min3(n.leftUp, n.rightUp, n.up)", "min3(n.leftUp, n.leftUp, n.up)"});
    expectCaught(plusBox(), {header, "box.maximum = max3(max3(n.left, n.right, n.centre)",
                             "box.maximum = max3(max3(n.left, n.left, n.centre)"});
    expectCaught(plusBox(), {header, "box.minimum = min3(min3(n.left", "box.minimum = max3(min3(n.left"});
}

TEST(Neighbourhood, varianceOfASampleOrAboutZeroIsCaught) {
    expectCaught(varianceBox(), {header, "square / 9.0", "square / 8.0"});
    expectCaught(varianceBox(), {header, "(mean - n.centre) * (mean - n.centre)", "mean * mean"});
}

// The deviation of dark detail on a bright base: 1000 and 1000.01, which squares about zero cannot tell.
TEST(Neighbourhood, varianceKeepsDarkDetailOnABrightBase) {
    Row row(9, vec4(1000.0f));
    for (size_t i : {0, 2, 6, 8})
        row[i] = vec4(1000.01f);
    const auto out = run(varianceBox().function, {row});
    const oracle::Box box = oracle::boxOfVariance(squareOf(row));
    const double deviation = (box.maximum.x - box.minimum.x) / 2.0;
    EXPECT_NEAR((out[0][1].x - out[0][0].x) / 2.0, deviation, 0.02 * deviation); // two steps of 6e-5 at 1000
}

TEST(Neighbourhood, flatNeighbourhoodGivesBoxesWithoutExtent) {
    std::vector<Row> rows;
    for (float value : hostileColour)
        rows.push_back(Row(9, vec4(value)));
    for (const Comparison& each : {plusBox(), squareBox(), roundedBox()})
        for (const Row& out : run(each.function, rows))
            EXPECT_EQ(out[0], out[1]) << each.function.name;
}

Comparison fourTaps() {
    return {{"boxOfFourTaps",
             {header},
             "ColourBox box = boxOfFourTaps(in0.xyz, in1.xyz, in2.xyz, in3.xyz, in4.xyz);"
             "out0.xyz = box.minimum; out1.xyz = box.maximum;",
             5,
             2},
            [] {
                std::vector<Row> rows = squares(2);
                for (Row& row : rows)
                    row.resize(5);
                return rows;
            }(),
            [](const Row& in) {
                const oracle::Box box =
                    oracle::boxOfFourTaps(xyz(in[0]), {xyz(in[1]), xyz(in[2]), xyz(in[3]), xyz(in[4])});
                return std::vector{near(box.minimum, flush), near(box.maximum, flush)};
            }};
}

TEST(Neighbourhood, fourTapsAndTheCentreSpanTheirBox) {
    expectAgrees(fourTaps());
}

TEST(Neighbourhood, fourTapsWithoutTheCentreAreCaught) {
    expectCaught(fourTaps(), {header, "box.minimum = min(centre, min(min(a, b), min(c, d)));",
                              "box.minimum = min(min(a, b), min(c, d));"});
}

Comparison distances() {
    Random random(3);
    std::vector<Row> rows;
    for (float motion : {0.0f, denormal, 5.0f, 9.999999f, 10.0f, 10.000001f, 1e30f})
        rows.push_back({vec4(motion)});
    for (int i = 0; i < 1000; ++i)
        rows.push_back({vec4(random.in(0.0f, 12.0f))});
    // A division and three roundings of values below 1.
    return {{"fourTapDistance", {header}, "out0.x = fourTapDistance(in0.x);"}, rows, [](const Row& in) {
                return std::vector{near(oracle::fourTapDistance(in[0].x), divisionError + 3.0 * roundoff)};
            }};
}

TEST(Neighbourhood, fourTapsMoveTowardsTheCentreWithMotion) {
    expectAgrees(distances());
}

TEST(Neighbourhood, fourTapsThatMoveAwayAreCaught) {
    expectCaught(distances(), {header, "lerp(0.666, 0.5,", "lerp(0.5, 0.666,"});
    expectCaught(distances(),
                 {header, "saturate(motionPx / FOUR_TAP_STRICT_PX)", "(motionPx / FOUR_TAP_STRICT_PX)"});
}

Comparison chroma() {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i) {
        const vec4 low = random.in4(-1.0f, 1.0f);
        rows.push_back({low, low + random.in4(0.0f, 1.0f), random.in4(-1.0f, 1.0f)});
    }
    rows.push_back({vec4(0.0f), vec4(0.0f), vec4(0.25f)});
    return {{"shrinkChroma",
             {header},
             "ColourBox box; box.minimum = in0.xyz; box.maximum = in1.xyz;"
             "box = shrinkChroma(box, in2.xyz); out0.xyz = box.minimum; out1.xyz = box.maximum;",
             3,
             2},
            rows,
            [](const Row& in) {
                const oracle::Box box = oracle::shrinkChroma({xyz(in[0]), xyz(in[1])}, xyz(in[2]));
                // A difference, an exact eighth and a sum, all below 2.
                return std::vector{near(box.minimum, 4.0 * roundoff), near(box.maximum, 4.0 * roundoff)};
            }};
}

TEST(Neighbourhood, chromaShrinksToAnEighthOfLumaAroundTheCentre) {
    expectAgrees(chroma());
}

TEST(Neighbourhood, chromaOfAnotherShareOrAsymmetricIsCaught) {
    expectCaught(chroma(), {header, "0.125 * (box.maximum.x - box.minimum.x)",
                            "0.25 * (box.maximum.x - box.minimum.x)"});
    expectCaught(chroma(), {header, "box.minimum.yz = centreYcocg.yz - extent;", ""});
}

} // namespace
} // namespace functions
