// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "squares.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using functions::fillNeighbourhood;
using functions::squareOf;

const std::string header = "reprise/neighbourhood.hlsli";

// Flat, smooth, with detail of 1e-7 to 1 of the base, with one texel that stands out, and without relation.
std::vector<Row> squares(const Effort& effort, uint32_t seed) {
    Random random(seed);
    const auto marks = colourMarks;
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float base = random.colourValue(),
                    spread = i % 4 == 0 ? 0.0f : std::exp2(random.in(-24.0f, 0.0f));
        Row row;
        for (int texel = 0; texel < 9; ++texel)
            row.push_back(i % 4 == 1
                              ? random.colour()
                              : glm::min(base * (1.0f + spread * random.in4(0.0f, 1.0f)), vec4(65504.0f)));
        if (i % 4 == 2)
            row[random.below(9)] = vec4(random.of(marks), random.of(marks), random.of(marks), 0.0f);
        rows.push_back(row);
    }
    return rows;
}

std::vector<Row> beyondSquares(const Effort& effort, uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(20000); ++i) {
        Row row;
        for (int texel = 0; texel < 9; ++texel)
            row.push_back(
                i % 2 == 0 ? anyColour(random)
                           : vec4(random.of(beyondMarks), random.of(beyondMarks), random.of(beyondMarks), 0));
        rows.push_back(row);
    }
    return rows;
}

functions::Function boxCall(const std::string& function) {
    return {function,
            {header},
            fillNeighbourhood + "ColourBox box = " + function +
                "(n); out0.xyz = box.minimum; out1.xyz = box.maximum;",
            9,
            2};
}

std::vector<Right> rights(const oracle::Box& box, dvec3 size = dvec3(0.0)) {
    return {right(box.minimum, size), right(box.maximum, size)};
}

dvec3 largestOf(const oracle::Square& square) {
    dvec3 most(0.0);
    for (dvec3 colour : square)
        most = glm::max(most, glm::abs(colour));
    return most;
}

constexpr double varianceRoundings = 24.0;

// The variance about the centre texel errs at the square of the largest difference from it; under the root,
// that is an error of its own root where the variance vanishes and a quotient elsewhere. The mean errs at the
// largest colour. A square of a difference below 1e-19 is a denormal.
std::vector<Right> varianceOracle(const Row& in) {
    const oracle::Square square = squareOf(in);
    const oracle::Box box = oracle::boxOfVariance(square);
    const dvec3 most = largestOf(square);
    dvec3 size(0.0);
    for (int c = 0; c < 3; ++c) {
        double reach = 0.0;
        for (dvec3 colour : square)
            reach = std::max(reach, std::abs(colour[c] - square[oracle::squareCentre][c]));
        const double deviation = (box.maximum[c] - box.minimum[c]) / 2.0;
        const double root = reach / std::sqrt(varianceRoundings * roundoff);
        size[c] = (deviation > 0.0 ? std::min(root, reach * reach / deviation) : root) + deviation + most[c] +
                  1.2e-19 / (varianceRoundings * roundoff);
    }
    return rights(box, size);
}

// Squares of differences beyond 1e19 are more than binary32 holds.
std::vector<Right> openBox(const Row&) {
    return {open(3), open(3)};
}

std::vector<Case> boxesOfNine() {
    struct Kind {
        const char* function;
        oracle::Box (*of)(const oracle::Square&);
    };
    std::vector<Case> all;
    for (const Kind& kind : {Kind{"boxOfPlus", oracle::boxOfPlus}, Kind{"boxOfSquare", oracle::boxOfSquare}})
        all.push_back(
            {"flat to unrelated, to ±1e30",
             boxCall(kind.function),
             {Unit::exact, 0.0, "minimum and maximum choose"},
             [kind](const Effort& effort) {
                 std::vector<Row> rows = squares(effort, 1);
                 for (const Row& row : beyondSquares(effort, 2))
                     rows.push_back(row);
                 return Sweep{rows, [kind](const Row& in) { return rights(kind.of(squareOf(in))); }};
             }});
    all.push_back({"flat to unrelated, to ±1e30",
                   boxCall("boxRounded"),
                   {Unit::roundings, 2.0, "a sum, halved exactly"},
                   [](const Effort& effort) {
                       std::vector<Row> rows = squares(effort, 3);
                       for (const Row& row : beyondSquares(effort, 4))
                           rows.push_back(row);
                       return Sweep{rows, [](const Row& in) {
                                        const oracle::Square square = squareOf(in);
                                        return rights(oracle::boxRounded(square), largestOf(square));
                                    }};
                   }});
    all.push_back({"flat to unrelated, 0 to 65504",
                   boxCall("boxOfVariance"),
                   {Unit::roundings, varianceRoundings,
                    "moments about the centre texel at the square of the largest difference, under the root"},
                   [](const Effort& effort) {
                       return Sweep{squares(effort, 5), varianceOracle};
                   }});
    all.push_back({"to ±1e30",
                   boxCall("boxOfVariance"),
                   {Unit::finite, 0.0, "squares of differences overflow; the box must not"},
                   [](const Effort& effort) {
                       return Sweep{beyondSquares(effort, 6), openBox};
                   }});
    return all;
}

const std::string fillRows =
    "ColourRow up, own, down;\n"
    "up.left = in0.xyz; up.centre = in1.xyz; up.right = in2.xyz;\n"
    "own.left = in3.xyz; own.centre = in4.xyz; own.right = in5.xyz;\n"
    "down.left = in6.xyz; down.centre = in7.xyz; down.right = in8.xyz;\n"
    "Neighbourhood n = neighbourhoodOf(up, own, down);\n"
    "out0.xyz = n.leftUp; out1.xyz = n.up; out2.xyz = n.rightUp; out3.xyz = n.left;\n"
    "out4.xyz = n.right; out5.xyz = n.leftDown; out6.xyz = n.down; out7.xyz = n.rightDown;";

std::vector<Case> others() {
    return {{"nine colours",
             {"neighbourhoodOf", {header}, fillRows, 9, 8},
             {Unit::exact, 0.0, "copies"},
             [](const Effort& effort) {
                 return Sweep{beyondSquares(effort, 7), [](const Row& in) {
                                  std::vector<Right> all;
                                  for (size_t i : {0, 1, 2, 3, 5, 6, 7, 8})
                                      all.push_back(right(xyz(in[i])));
                                  return all;
                              }};
             }},
            {"unrelated, to ±1e30",
             {"boxOfFourTaps",
              {header},
              "ColourBox box = boxOfFourTaps(in0.xyz, in1.xyz, in2.xyz, in3.xyz, in4.xyz);"
              "out0.xyz = box.minimum; out1.xyz = box.maximum;",
              9,
              2},
             {Unit::exact, 0.0, "minimum and maximum choose"},
             [](const Effort& effort) {
                 return Sweep{beyondSquares(effort, 8), [](const Row& in) {
                                  return rights(oracle::boxOfFourTaps(
                                      xyz(in[0]), {xyz(in[1]), xyz(in[2]), xyz(in[3]), xyz(in[4])}));
                              }};
             }},
            {"motion 0, 1e-12 to 1e6 px, 1e30",
             {"fourTapDistance", {header}, "out0.x = fourTapDistance(in0.x);"},
             {Unit::absolute, divisionError + 3.0 * roundoff, "a quotient of at most 1 and a lerp below 1"},
             [](const Effort& effort) {
                 std::vector<Row> rows{{vec4(0.0f)}, {vec4(1e-40f)}, {vec4(1e30f)}};
                 for (float motion : logarithmic(1e-12, 1e6, effort.of(50000)))
                     rows.push_back({vec4(motion)});
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{right(oracle::fourTapDistance(in[0].x))};
                              }};
             }},
            {"motion NaN and negative",
             {"fourTapDistance", {header}, "out0.x = fourTapDistance(in0.x);"},
             {Unit::finite, 0.0, "a place between the texels, whichever"},
             [](const Effort&) {
                 std::vector<Row> rows;
                 for (float motion : {notANumber, infinity, -infinity, -1.0f, -1e30f})
                     rows.push_back({vec4(motion)});
                 return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
             }},
            {"boxes and centres to ±1e30",
             {"shrinkChroma",
              {header},
              "ColourBox box; box.minimum = in0.xyz; box.maximum = in1.xyz;"
              "box = shrinkChroma(box, in2.xyz); out0.xyz = box.minimum; out1.xyz = box.maximum;",
              9,
              2},
             {Unit::roundings, 4.0, "a difference, an exact eighth and a sum at the largest of all"},
             [](const Effort& effort) {
                 std::vector<Row> rows = squares(effort, 9);
                 for (const Row& row : beyondSquares(effort, 10))
                     rows.push_back(row);
                 return Sweep{rows, [](const Row& in) {
                                  const dvec3 a = xyz(in[0]), b = xyz(in[1]), centre = xyz(in[2]);
                                  const double size =
                                      std::max(std::abs(a.x), std::abs(b.x)) + largest(centre);
                                  return rights(oracle::shrinkChroma({a, b}, centre), dvec3(size));
                              }};
             }}};
}

} // namespace

std::vector<Case> neighbourhoodCases() {
    std::vector<Case> all = boxesOfNine();
    for (Case& each : others())
        all.push_back(std::move(each));
    return all;
}

} // namespace check
