// SPDX-License-Identifier: Apache-2.0
// jitter.hlsli, sample_pattern.hlsli, unjitter.hlsli, motion_blur.hlsli, resampling.hlsli and
// quad_sharing.hlsli.
#include "ambient_occlusion.hpp"
#include "cases.hpp"
#include "images.hpp"
#include "squares.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using functions::brokenImage;
using functions::filterStep;
using functions::randomImage;

const std::string jitter = "reprise/jitter.hlsli", pattern = "reprise/sample_pattern.hlsli",
                  unjitter = "reprise/unjitter.hlsli", motionBlur = "reprise/motion_blur.hlsli",
                  resampling = "reprise/resampling.hlsli", quadSharing = "reprise/quad_sharing.hlsli";

// --- jitter

Case inverse(int base) {
    return {
        "every index to 4095, base " + std::to_string(base),
        {"radicalInverse", {jitter}, "out0.x = radicalInverse(in0.x, in0.y);"},
        {Unit::absolute, base == 2 ? 0.0 : 3.0 * divisionError,
         base == 2 ? "digits of base 2 are exact" : "a chain of divisions, of which each place is a third"},
        [base](const Effort&) {
            std::vector<Row> rows;
            for (int index = 0; index < 4096; ++index)
                rows.push_back({vec4(index, base, 0, 0)});
            return Sweep{rows, [](const Row& in) {
                             return std::vector{right(oracle::radicalInverse(
                                 static_cast<uint64_t>(in[0].x), static_cast<uint64_t>(in[0].y)))};
                         }};
        }};
}

// Frames to 2^23, where frame + 1/2 is still a number of binary32.
std::vector<Row> frames(const Effort& effort) {
    Random random(1);
    std::vector<Row> rows;
    for (float period : {8.0f, 16.0f}) {
        for (size_t frame = 0; frame < effort.of(20000); ++frame)
            rows.push_back({vec4(frame, period, 0, 0)});
        for (size_t i = 0; i < effort.of(20000); ++i)
            rows.push_back({vec4(std::floor(random.in(0.0f, 8388600.0f)), period, 0, 0)});
        for (int frame = 8388544; frame < 8388608; ++frame)
            rows.push_back({vec4(frame, period, 0, 0)});
    }
    return rows;
}

std::vector<Case> sequences() {
    return {inverse(2),
            inverse(3),
            {"frames to 2^23, periods 8 and 16",
             {"haltonJitterPx", {jitter}, "out0.xy = haltonJitterPx(in0.x, in0.y);"},
             {Unit::absolute, 4.0 * divisionError, "as radicalInverse, and a difference"},
             [](const Effort& effort) {
                 return Sweep{frames(effort), [](const Row& in) {
                                  return std::vector{right(oracle::haltonJitterPx(
                                      static_cast<uint64_t>(in[0].x), static_cast<uint64_t>(in[0].y)))};
                              }};
             }},
            {"frames to 2^23",
             {"uniform4HelixJitterPx", {jitter}, "out0.xy = uniform4HelixJitterPx(in0.x);"},
             {Unit::exact, 0.0, "quarters"},
             [](const Effort& effort) {
                 return Sweep{frames(effort), [](const Row& in) {
                                  return std::vector{
                                      right(oracle::uniform4HelixJitterPx(static_cast<uint64_t>(in[0].x)))};
                              }};
             }}};
}

// --- sample pattern

Case dither() {
    return {"pixels to 2^22",
            {"pixelOffsets", {pattern}, "out0.xy = pixelOffsets(in0.xy);"},
            {Unit::exact, 0.0, "sixteenths"},
            [](const Effort& effort) {
                Random random(15);
                std::vector<Row> rows;
                for (int i = 0; i < 64 * 64; ++i)
                    rows.push_back({vec4(i % 64, i / 64, 0, 0)});
                const auto any = [&] { return std::floor(std::exp2(random.in(0.0f, 22.0f))); };
                for (size_t i = 0; i < effort.of(40000); ++i)
                    rows.push_back({vec4(any(), any(), 0, 0)});
                return Sweep{rows, [](const Row& in) {
                                 const auto x = static_cast<int>(in[0].x), y = static_cast<int>(in[0].y);
                                 return std::vector{right(
                                     dvec2(oracle::orderedOffset(x, y), oracle::orderedOffset(y + 1, x)))};
                             }};
            }};
}

// --- unjitter

dvec3 asVector(const oracle::AxisWeights& weights) {
    return {weights[0], weights[1], weights[2]};
}

std::vector<Row> jitters(const Effort& effort) {
    const auto magnitudes =
        std::vector{0.0f, 1e-40f, 0.49999997f, 0.5f} + logarithmic(1e-12, 0.5, effort.of(20000));
    std::vector<Row> rows;
    for (float value : ofBothSigns(magnitudes))
        rows.push_back({vec4(value)});
    return rows;
}

Case anyJitter(const std::string& function) {
    return {"jitters to ±1e30, which no sequence has",
            {function, {unjitter}, "out0.xyz = " + function + "(in0.x);"},
            {Unit::finite, 0.0, "no weight there is right, but none may be NaN or infinite"},
            [](const Effort& effort) {
                std::vector<Row> rows;
                for (float value : ofBothSigns(logarithmic(0.5, 1e30, effort.of(5000))))
                    rows.push_back({vec4(value)});
                return Sweep{rows, [](const Row&) { return std::vector{open(3)}; }};
            }};
}

// A sum of terms of one sign, or of terms that cancel.
std::vector<Right> weighingOracle(const Row& in) {
    const oracle::Square square = functions::squareOf(in);
    const dvec3 x = xyz(in[9]), y = xyz(in[10]);
    oracle::Square sizes;
    for (size_t i = 0; i < 9; ++i)
        sizes[i] = glm::abs(square[i]);
    const dvec3 ax = glm::abs(x), ay = glm::abs(y);
    return {right(oracle::weighSquare(square, {x[0], x[1], x[2]}, {y[0], y[1], y[2]}),
                  oracle::weighSquare(sizes, {ax[0], ax[1], ax[2]}, {ay[0], ay[1], ay[2]}))};
}

std::vector<Case> unjittering() {
    return {
        {"±0, 1e-12 to 0.5 px",
         {"unjitterWeightsBilinear", {unjitter}, "out0.xyz = unjitterWeightsBilinear(in0.x);"},
         {Unit::absolute, roundoff, "a difference from 1"},
         [](const Effort& effort) {
             return Sweep{jitters(effort), [](const Row& in) {
                              return std::vector{right(asVector(oracle::unjitterWeightsBilinear(in[0].x)))};
                          }};
         }},
        {"±0, 1e-12 to 0.5 px",
         {"unjitterWeightsGaussian", {unjitter}, "out0.xyz = unjitterWeightsGaussian(in0.x);"},
         {Unit::relative, 124.0 * roundoff + divisionError,
          "exponents to 7.4, which exp2 makes 26 roundings of, 36 of its own, twice for the sum, a division"},
         [](const Effort& effort) {
             return Sweep{jitters(effort), [](const Row& in) {
                              return std::vector{right(asVector(oracle::unjitterWeightsGaussian(in[0].x)))};
                          }};
         }},
        anyJitter("unjitterWeightsBilinear"),
        anyJitter("unjitterWeightsGaussian"),
        {"colours to ±1e30, weights -1 to 1",
         {"weighNeighbourhood",
          {unjitter},
          functions::fillNeighbourhood + "out0.xyz = weighNeighbourhood(n, in9.xyz, in10.xyz);",
          11},
         {Unit::roundings, 8.0, "two products and four sums deep, at the sum of the absolute terms"},
         [](const Effort& effort) {
             Random random(3);
             std::vector<Row> rows;
             for (size_t i = 0; i < effort.of(40000); ++i) {
                 Row row;
                 for (int texel = 0; texel < 9; ++texel)
                     row.push_back(i % 2 == 0 ? random.colour() : anyColour(random));
                 row.push_back(random.in4(i % 4 == 3 ? -1.0f : 0.0f, 1.0f));
                 row.push_back(random.in4(i % 4 == 3 ? -1.0f : 0.0f, 1.0f));
                 rows.push_back(row);
             }
             return Sweep{rows, weighingOracle};
         }}};
}

// --- motion blur

const functions::Function trust{
    "motionBlurTrust", {motionBlur}, "out0.x = motionBlurTrust(in0.x, in0.y, in0.z);"};

std::vector<Case> trusts() {
    return {{"motion 0, 1e-12 to 1e6 px, 1e30",
             trust,
             {Unit::absolute, divisionError + 3.0 * roundoff, "two differences and a division, at most 1"},
             [](const Effort& effort) {
                 const auto motions =
                     std::vector{0.0f, 1e-40f, 1.9999999f, 2.0f, 2.0000002f, 15.0f, 15.000001f, 1e30f} +
                     logarithmic(1e-12, 1e6, effort.of(40000));
                 Random random(4);
                 std::vector<Row> rows;
                 for (float motion : motions) {
                     rows.push_back({vec4(motion, 2.0f, 15.0f, 0.0f)});
                     const float from = random.in(0.0f, 10.0f);
                     rows.push_back({vec4(motion, from, from + std::exp2(random.in(-3.0f, 6.0f)), 0.0f)});
                 }
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{
                                      right(oracle::motionBlurTrust(in[0].x, in[0].y, in[0].z))};
                              }};
             }},
            {"ends of the blur equal or swapped, motion NaN",
             trust,
             {Unit::finite, 0.0, "a share, whichever"},
             [](const Effort&) {
                 const float values[] = {0.0f, 1e-30f, 2.0f, 15.0f, 1e6f, 1e30f};
                 std::vector<Row> rows;
                 for (float motion : {0.0f, 2.0f, 15.0f, 1e30f, -1e30f, infinity, notANumber})
                     for (float from : values)
                         for (float to : values)
                             rows.push_back({vec4(motion, from, to, 0.0f)});
                 return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
             }}};
}

// in0 is a place, in1 the motion, both in UV.
std::vector<Row> motionsOver(const Effort& effort) {
    const auto lengths = std::vector{0.0f, 1e-40f} + logarithmic(1e-12, 65000.0, effort.of(4000));
    Random random(5);
    std::vector<Row> rows;
    for (float length : lengths)
        for (int i = 0; i < 8; ++i)
            rows.push_back(
                {vec4(random.in(-0.2f, 1.2f), random.in(-0.2f, 1.2f), 0, 0), length * random.in4(-1, 1)});
    return rows;
}

functions::Function blurOf(const oracle::Image& image) {
    return {"sampleMotion",
            {motionBlur},
            "out0.xyz = sampleMotion(TEXTURE_ARGUMENT(gTexture0), in0.xy, in1.xy);",
            2,
            1,
            {},
            reprise::Stage::compute,
            {{image, true}}};
}

std::vector<Case> blurs() {
    const oracle::Image whole = randomImage(16, 9, 6), broken = brokenImage(16, 9, 7);
    return {
        {"motion 0, 1e-12 to 1e6 px, texels 0 to 1",
         blurOf(whole),
         {Unit::absolute, 2.0 * filterStep + 10.0 * roundoff, "a step of the filter (1/256) on each axis"},
         [whole](const Effort& effort) {
             return Sweep{motionsOver(effort), [whole](const Row& in) {
                              return std::vector{right(oracle::sampleMotion(whole, xy(in[0]), xy(in[1])))};
                          }};
         }},
        {"texels NaN and infinite, motion NaN too",
         blurOf(broken),
         {Unit::finite, 0.0, "each read is repaired"},
         [](const Effort& effort) {
             std::vector<Row> rows = motionsOver(effort);
             for (size_t i = 0; i < rows.size(); i += 5)
                 rows[i][1] = vec4(i % 2 == 0 ? notANumber : 1e30f);
             return Sweep{rows, [](const Row&) { return std::vector{open(3)}; }};
         }}};
}

// --- resampling

functions::Function cubicOf(const oracle::Image& image) {
    return {
        "sampleCatmullRom5",
        {resampling},
        "out0.xyz = sampleCatmullRom5(TEXTURE_ARGUMENT(gTexture0), in0.xy, float4(in0.zw, 1.0 / in0.zw));",
        1,
        1,
        {},
        reprise::Stage::compute,
        {{image, true}}};
}

// In and around the image, on and beside texel centres and edges.
std::vector<Row> placesIn(const oracle::Image& image, const Effort& effort) {
    const auto width = static_cast<float>(image.width), height = static_cast<float>(image.height);
    Random random(8);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        vec4 place(random.in(-0.2f, 1.2f), random.in(-0.2f, 1.2f), width, height);
        if (i % 2 == 0)
            for (int axis = 0; axis < 2; ++axis) {
                const float beside =
                    std::exp2(random.in(-30.0f, 0.0f)) * (random.below(2) == 0 ? 1.0f : -1.0f);
                place[axis] =
                    (0.5f * static_cast<float>(random.below(33)) + beside) / (axis == 0 ? width : height);
            }
        rows.push_back({place});
    }
    return rows;
}

Case cubic(const std::string& sweep, const oracle::Image& image, double largestTexel) {
    return {sweep,
            cubicOf(image),
            {Unit::absolute, (1.6 * 2.0 * filterStep + 1e-5) * largestTexel,
             "a step of the filter (1/256) on each axis at weights of 1.6 in all; places to 1e-6 of a texel"},
            [image](const Effort& effort) {
                return Sweep{placesIn(image, effort), [image](const Row& in) {
                                 return std::vector{right(oracle::sampleCatmullRom5(image, xy(in[0])))};
                             }};
            }};
}

Case brokenCubic(const oracle::Image& image) {
    return {"texels NaN and infinite, places to ±1e30, NaN",
            cubicOf(image),
            {Unit::finite, 0.0, "each read is repaired, and the sum"},
            [image](const Effort& effort) {
                std::vector<Row> rows = placesIn(image, effort);
                Random random(9);
                for (size_t i = 0; i < rows.size(); i += 5)
                    rows[i][0].x = i % 2 == 0 ? notANumber : anyValue(random);
                return Sweep{rows, [](const Row&) { return std::vector{open(3)}; }};
            }};
}

// --- quads

Case sides() {
    return {"pixels of images to 16384",
            {"quadSide", {quadSharing}, "out0.xy = quadSide(in0.xy);"},
            {Unit::exact, 0.0, "halves and their fractions"},
            [](const Effort& effort) {
                Random random(10);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(60000); ++i)
                    rows.push_back({vec4(random.below(16384), random.below(16384), 0, 0) + 0.5f});
                return Sweep{rows, [](const Row& in) {
                                 const dvec2 pixel = glm::floor(xy(in[0]));
                                 return std::vector{
                                     right(2.0 * (pixel - 2.0 * glm::floor(pixel / 2.0)) - 1.0)};
                             }};
            }};
}

// in0 is a pixel's value; in1 and in2 are those of the other pixel in its row and in its column, for the
// oracle.
std::vector<Row> quads(const Effort& effort, bool beyond) {
    Random random(11);
    const size_t lines = effort.quick ? 64 : 512;
    std::vector<Row> rows(64 * lines, Row(3, vec4(0.0f)));
    for (Row& row : rows)
        row[0] = beyond ? anyColour(random) : random.colour();
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i][1] = rows[i ^ 1][0];
        rows[i][2] = rows[i ^ 64][0];
    }
    return rows;
}

Case swapped(const std::string& function, bool column) {
    return {"neighbours 1e-4 to 65504, in a fragment shader",
            {function,
             {quadSharing},
             "out0.xyz = " + function + "(in0.xyz, quadSide(positionPx.xy));",
             3,
             1,
             {},
             reprise::Stage::fragment},
            {Unit::roundings, 2.0, "a difference and a sum at the larger of the two values"},
            [column](const Effort& effort) {
                return Sweep{quads(effort, false), [column](const Row& in) {
                                 const dvec3 own = xyz(in[0]), other = xyz(in[column ? 2 : 1]);
                                 return std::vector{right(other, glm::max(own, other))};
                             }};
            }};
}

Case swappedExactly() {
    return {"neighbours to ±1e30, in a compute shader",
            {"quadSwapX",
             {quadSharing},
             "float2 side = quadSide(float2(thread.xy) + 0.5); out0.xyz = quadSwapX(in0.xyz, side);"
             "out1.xy = quadSwapX(in0.xy, side);",
             3,
             2},
            {Unit::exact, 0.0, "a copy"},
            [](const Effort& effort) {
                return Sweep{quads(effort, true), [](const Row& in) {
                                 return std::vector{right(xyz(in[1])), right(xy(in[1]))};
                             }};
            }};
}

// Rows of the subgroup, whatever their width: each case ends with the value of the other in the pair.
Case sharedInRow(const std::string& function, const std::string& value) {
    return {
        "neighbours to ±1e30, in a compute shader",
        {function,
         {quadSharing},
         "uint column = subgroupColumn(), other = column ^ 1u;"
         "uint last = SUBGROUP_ROW_WIDTH - 1u;"
         "uint second = ((column & 1u) != 0u ? column + 2u : column - 2u) & last;"
         "float3 given = valueInRow(in0.xyz, second), none = float3(0.0, 0.0, 0.0);"
         "bool isEnd = column == 0u || column == last;"
         "out0.xyz = " +
             value + ";",
         3,
         1},
        {Unit::exact, 0.0, "a copy"},
        [](const Effort& effort) {
            return Sweep{quads(effort, true), [](const Row& in) { return std::vector{right(xyz(in[1]))}; }};
        }};
}

std::vector<Case> sharedInRows() {
    return {
        sharedInRow("subgroupColumn", "WaveReadLaneAt(in0.xyz, WaveGetLaneIndex() - column + other)"),
        sharedInRow("laneInRow", "WaveReadLaneAt(in0.xyz, laneInRow(other))"),
        sharedInRow("valueInRow", "valueInRow(in0.xyz, other)"),
        sharedInRow("outerNeighbour", "outerNeighbour(isEnd ? none : given, isEnd ? given : none)"),
        sharedInRow("halfRowSwap", "halfRowSwap(valueInRow(in0.xyz, other ^ (SUBGROUP_ROW_WIDTH / 2u)))")};
}

} // namespace

std::vector<Case> samplingCases() {
    std::vector<Case> all = sequences();
    all.push_back(dither());
    for (const auto& more : {unjittering(), trusts(), blurs()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(cubic("in and around 16x9, texels 0 to 1", randomImage(16, 9, 12), 1.0));
    all.push_back(
        cubic("in and around 16x9, texels 0 to 65504", randomImage(16, 9, 13, 0.0f, 65504.0f), 65504.0));
    all.push_back(brokenCubic(brokenImage(16, 9, 14)));
    all.push_back(sides());
    all.push_back(swapped("quadSwapX", false));
    all.push_back(swapped("quadSwapY", true));
    all.push_back(swappedExactly());
    for (const Case& each : sharedInRows())
        all.push_back(each);
    return all;
}

} // namespace check
