// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/history_constraint.hlsli";

// history, minimum, maximum, current
Row constraintRow(vec4 history, vec4 a, vec4 b, vec4 current) {
    return {history, glm::min(a, b), glm::max(a, b), current};
}

// `farthest` is the largest history beside binary16's.
void addHostile(std::vector<Row>& rows, Random& random, float farthest) {
    // Nothing between 0 and 1e-20: the guards against 0/0 take that for 0, and histories hold no less than
    // 6e-8.
    const float marks[] = {0.0f, 1e-7f, 0.5f, 1.0f, 65504.0f, -1.0f};
    const float far[] = {0.0f, 0.5f, 1.0f, 65504.0f, -65504.0f, farthest, -farthest};
    for (int i = 0; i < 3000; ++i) {
        vec4 a(0.0f), b(0.0f), history(0.0f), current(0.0f);
        for (int c = 0; c < 3; ++c) {
            a[c] = random.of(marks);
            b[c] = random.below(3) == 0 ? a[c] : random.of(marks);
            history[c] = random.of(far);
            current[c] = random.of(marks);
        }
        rows.push_back(constraintRow(history, a, b, current));
    }
}

std::vector<Row> constraintRows(uint32_t seed, float farthest = 1e30f) {
    Random random(seed);
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i) {
        const float size = random.of(std::vector{0.0f, 0.01f, 0.2f, 1.0f});
        const vec4 a = random.in4(-0.5f, 1.0f), b = a + size * random.in4(0.0f, 1.0f);
        rows.push_back(constraintRow(random.in4(-1.0f, 2.0f), a, b, glm::mix(a, b, random.unit())));
        // The rounded box need not hold the current colour.
        rows.push_back(constraintRow(random.colour(), random.colour(), random.colour(), random.colour()));
    }
    for (int i = 0; i < 500; ++i) { // one side without extent
        vec4 a = random.in4(0.0f, 1.0f), b = random.in4(0.0f, 1.0f);
        const int axis = static_cast<int>(random.below(3));
        b[axis] = a[axis];
        rows.push_back(constraintRow(random.in4(0.0f, 1.0f), a, b, random.in4(0.0f, 1.0f)));
    }
    addHostile(rows, random, farthest);
    return rows;
}

const std::string fillBox = "ColourBox box; box.minimum = in1.xyz; box.maximum = in2.xyz;\n";

oracle::Box boxOf(const Row& in) {
    return {xyz(in[1]), xyz(in[2])};
}

Comparison clamping() {
    return {{"clampToBox", {header}, fillBox + "out0.xyz = clampToBox(in0.xyz, box);", 4},
            constraintRows(1),
            [](const Row& in) {
                return std::vector{near(oracle::clampToBox(xyz(in[0]), boxOf(in)), flush)}; // chooses, exact
            }};
}

double largestSide(oracle::Box box) {
    return largest(box.maximum - box.minimum) / 2.0;
}

// Some ten roundings at the size of centre and extent. The centre itself is rounded, so a side that is about
// as short as that rounding makes the distance in boxes uncertain, and with it the way along the longest
// side.
double clipBound(oracle::Box box) {
    const dvec3 centre = (box.maximum + box.minimum) / 2.0;
    double uncertain = 0.0;
    for (int c = 0; c < 3; ++c) {
        if (box.maximum[c] == box.minimum[c]) continue; // half of twice the same is exact
        const double extent = std::max((box.maximum[c] - box.minimum[c]) / 2.0, oracle::minBoxExtent);
        uncertain = std::max(uncertain, 2.0 * roundoff * std::abs(centre[c]) / extent);
    }
    const double side = std::max(largestSide(box), oracle::minBoxExtent);
    return (8.0 * roundoff + divisionError) * (largest(centre) + side) + std::min(uncertain, 1.0) * side;
}

Comparison clippingToCentre() {
    return {{"clipToBoxCentre", {header}, fillBox + "out0.xyz = clipToBoxCentre(in0.xyz, box);", 4},
            constraintRows(2),
            [](const Row& in) {
                return std::vector{
                    near(oracle::clipToBoxCentre(xyz(in[0]), boxOf(in)), clipBound(boxOf(in)))};
            }};
}

Comparison clippingToTwiceTheBox() {
    Comparison comparison = clippingToCentre();
    comparison.function.body = fillBox + "box.minimum *= 2.0; box.maximum *= 2.0;"
                                         "out0.xyz = clipToBoxCentre(in0.xyz, box, 2.0, MIN_BOX_EXTENT);";
    return comparison;
}

Comparison clippingToLine() {
    return {{"clipToBoxLine", {header}, fillBox + "out0.xyz = clipToBoxLine(in0.xyz, in3.xyz, box);", 4},
            // Farther out the guard against 0/0 is no longer lost: history still ends in the box, which
            // clippedHistoryLiesInTheBox asks, but farther along the line. Colours end at 65504.
            constraintRows(3, 131008.0f),
            [](const Row& in) {
                const oracle::Box box = boxOf(in);
                // The start is exact and the way inside at most a side long: some eight roundings and a
                // division at the size of the sides and their ends.
                const double size = largest(box.minimum) + largest(box.maximum);
                return std::vector{near(oracle::clipToBoxLine(xyz(in[0]), xyz(in[3]), box),
                                        (8.0 * roundoff + divisionError) * size + 1e-29)};
            }};
}

const std::string clipShares = "offset * min(share.x, min(share.y, share.z))";

TEST(HistoryConstraint, clampHoldsEachChannel) {
    expectAgrees(clamping());
}

TEST(HistoryConstraint, clipToCentreAgreesFarOutsideAndInFlatBoxes) {
    expectAgrees(clippingToCentre());
    expectAgrees(clippingToTwiceTheBox());
    expectCaught(clippingToTwiceTheBox(),
                 {header, "history * (2.0 * times) - centre", "history * 2.0 - centre"});
}

TEST(HistoryConstraint, clipToLineAgreesFarOutsideAndInFlatBoxes) {
    expectAgrees(clippingToLine());
}

TEST(HistoryConstraint, clampThatSwapsItsEndsIsCaught) {
    expectCaught(clamping(), {header, "clamp(history, box.minimum, box.maximum)",
                              "clamp(history, box.maximum, box.minimum)"});
}

TEST(HistoryConstraint, thePrintedAxOfClipAabbIsCaught) {
    // Read as either of its arguments, or as their minimum, an axis falls out of the maximum.
    expectCaught(clippingToCentre(), {header, clipShares, "offset * min(share.x, share.y)"});
    expectCaught(clippingToCentre(), {header, clipShares, "offset * min(share.x, share.z)"});
    expectCaught(clippingToCentre(), {header, clipShares, "offset * min(share.x, max(share.y, share.z))"});
}

TEST(HistoryConstraint, thePrintedDivisionByAZeroExtentIsCaught) {
    expectCaught(clippingToCentre(), {header, "max(box.maximum - box.minimum, 2.0 * times * minExtent)",
                                      "box.maximum - box.minimum"});
    // The slide itself: unit space first, then the comparison.
    expectCaught(clippingToCentre(),
                 {header, "float3 extent = max(box.maximum - box.minimum, 2.0 * times * minExtent);",
                  "float3 middle = 0.5 * centre, extent = 0.5 * (box.maximum - box.minimum);"
                  "float3 printed = abs((history - middle) / extent);"
                  "float ma = max(printed.x, max(printed.y, printed.z));"
                  "return ma > 1.0 ? middle + (history - middle) / ma : history;"});
}

TEST(HistoryConstraint, clipThatPullsInsideHistoryToTheBorderIsCaught) {
    expectCaught(clippingToCentre(), {header, "saturate(extent / abs(offset))", "(extent / abs(offset))"});
}

TEST(HistoryConstraint, lineClipWithoutItsGuardsIsCaught) {
    expectCaught(clippingToLine(), {header, "(abs(room) + TINY) / (max(abs(direction), abs(room)) + TINY)",
                                    "abs(room) / max(abs(direction), abs(room))"});
    expectCaught(clippingToLine(), {header, "clampToBox(current, box)", "current"});
    expectCaught(clippingToLine(), {header, "direction * min(share.x, min(share.y, share.z))",
                                    "direction * max(share.x, max(share.y, share.z))"});
}

// What the box is for, whatever the bound of the agreement.
TEST(HistoryConstraint, clippedHistoryLiesInTheBox) {
    for (Comparison each : {clamping(), clippingToCentre(), clippingToLine()}) {
        each.inputs = constraintRows(5);
        const auto out = run(each.function, each.inputs);
        for (size_t i = 0; i < out.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                const oracle::Box box = boxOf(each.inputs[i]);
                const double slack =
                    (8.0 * roundoff + divisionError) * (std::abs(box.minimum[c]) + std::abs(box.maximum[c])) +
                    1.001 * oracle::minBoxExtent;
                ASSERT_GE(out[i][0][c], box.minimum[c] - slack) << each.function.name << " row " << i;
                ASSERT_LE(out[i][0][c], box.maximum[c] + slack) << each.function.name << " row " << i;
            }
    }
}

TEST(HistoryConstraint, invertedBoxGivesFiniteColours) {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 500; ++i)
        rows.push_back({random.colour(), vec4(1.0f), random.in4(0.0f, 1.0f), random.colour()});
    for (const Comparison& each : {clamping(), clippingToCentre(), clippingToLine()})
        expectAgrees({each.function, rows, [](const Row&) { return std::vector{finite()}; }});
}

// The talk's function by its own name; history and current colour with a fourth channel.
Comparison clippingAabb() {
    Random random(6);
    std::vector<Row> rows = constraintRows(7);
    for (Row& row : rows) {
        row[0].w = random.in(-1.0f, 2.0f);
        row[3].w = random.unit();
    }
    const size_t whole = rows.size();
    for (size_t i = 0; i < whole; i += 20) { // a history that is no number in one channel
        rows.push_back(rows[i]);
        rows.back()[0][static_cast<int>(random.below(4))] =
            random.of(std::vector{notANumber, infinity, -infinity});
    }
    return {
        {"clip_aabb", {header}, "out0 = clip_aabb(in1.xyz, in2.xyz, in3, in0);", 4}, rows, [](const Row& in) {
            const dvec4 value = oracle::clipAabb(boxOf(in), dvec4(in[3]), dvec4(in[0]));
            // What the longest side is uncertain by in relation to itself, the share of the way is, and with
            // it what the fourth channel goes. Where a side is lost in the rounding of the centre, that is
            // all of it.
            const double box = clipBound(boxOf(in));
            const double uncertain = 4.0 * box / std::max(largestSide(boxOf(in)), oracle::minBoxExtent);
            const double way =
                std::isfinite(in[0].w) ? std::abs(static_cast<double>(in[0].w) - in[3].w) : 0.0;
            const double gone = std::abs(value.w - in[3].w);
            Expected expected = near(value, box);
            expected.bound.w = (uncertain < 1.0 ? uncertain * gone : way) + 8.0 * roundoff * (1.0 + way);
            return std::vector{expected};
        }};
}

TEST(HistoryConstraint, clipAabbMovesAllFourChannelsByOneShareOfTheWay) {
    expectAgrees(clippingAabb());
}

TEST(HistoryConstraint, wrongFormsOfClipAabbAreCaught) {
    const std::string smallest = "float smallest = min(share.x, min(share.y, share.z));";
    expectCaught(clippingAabb(),
                 {header, "return smallest < 1.0 ? p_clip + v_clip * smallest : q;",
                  "return smallest < 1.0 ? float4(p_clip.xyz + v_clip.xyz * smallest, q.w) : q;"});
    expectCaught(clippingAabb(),
                 {header, "float4(0.5 * aabb_max + 0.5 * aabb_min, p.w)", "p"}); // towards p itself
    expectCaught(clippingAabb(), {header, smallest, "float smallest = min(share.x, share.y);"});
    expectCaught(clippingAabb(), {header, "if (!all(abs(q) <= 1e38))", "if (false)"});
    expectCaught(clippingAabb(), {header, "max(0.5 * aabb_max - 0.5 * aabb_min, MIN_BOX_EXTENT)",
                                  "0.5 * aabb_max - 0.5 * aabb_min"});
}

TEST(HistoryConstraint, historyInTheBoxPassesClipAabbUnchanged) {
    Random random(8);
    std::vector<Row> rows;
    for (int i = 0; i < 500; ++i) {
        const vec4 a = random.in4(0.0f, 1.0f), b = a + random.in4(0.1f, 1.0f);
        rows.push_back({glm::mix(a, b, random.in4(0.01f, 0.99f)), a, b, random.in4(0.0f, 1.0f)});
    }
    expectAgrees(
        {clippingAabb().function, rows, [](const Row& in) { return std::vector{near(dvec4(in[0]), 0.0)}; }});
}

TEST(HistoryConstraint, thePrintedAxOfClipAabbDoesNotCompile) {
    const auto text = [](const std::string& name) {
        return "[[vk::binding(0)]] RWTexture2D<float4> gOut;"
               "[numthreads(8, 8, 1)] void mainCompute(uint3 id : SV_DispatchThreadID) {"
               "    float3 a_unit = float3(id);"
               "    gOut[id.xy] = max(a_unit.x, " +
               name +
               "(a_unit.y, a_unit.z));"
               "}";
    };
    EXPECT_TRUE(compiles(text("max")));
    EXPECT_FALSE(compiles(text("ax")));
}

TEST(HistoryConstraint, clipAabbOfAnyFiniteOrBrokenHistoryIsFinite) {
    std::vector<Row> rows = hostileRows(hostileAny, 4, 3000, 9);
    const std::vector<Row> numbers = hostileRows(hostileFinite, 4, 3000, 10);
    for (size_t i = 0; i < rows.size(); ++i) {
        const Row& from = numbers[i % numbers.size()];
        rows[i][1] = glm::min(from[1], from[2]);
        rows[i][2] = glm::max(from[1], from[2]);
        rows[i][3] = from[3];
    }
    expectNumbers(clippingAabb().function, rows);
}

} // namespace
} // namespace functions
