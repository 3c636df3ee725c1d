// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"
#include "printed_forms.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

using glm::ivec2;

const std::string header = "reprise/bilateral_upsampling.hlsli";

// --- Footprint

ivec2 coarseSizeOf(ivec2 fine, int ratio) {
    return {(fine.x + ratio - 1) / ratio, (fine.y + ratio - 1) / ratio};
}

const ivec2 fineSizes[] = {{1, 1}, {2, 2}, {7, 5}, {8, 6}, {13, 9}};

struct Layout {
    ivec2 fine;
    int ratio;
    std::string name() const {
        return std::to_string(fine.x) + "x" + std::to_string(fine.y) + " by " + std::to_string(ratio);
    }
};

std::vector<Layout> layouts() {
    std::vector<Layout> all;
    for (ivec2 fine : fineSizes)
        for (int ratio : {2, 3, 4})
            all.push_back({fine, ratio});
    return all;
}

// in0 is (position, coarse size), in1 (ratio, depth of the pixel, fine size).
std::vector<Row> pixelRows(const Layout& layout) {
    Random random(1);
    std::vector<Row> rows;
    for (int y = 0; y < layout.fine.y; ++y)
        for (int x = 0; x < layout.fine.x; ++x)
            rows.push_back({vec4(x + 0.5, y + 0.5, glm::vec2(coarseSizeOf(layout.fine, layout.ratio))),
                            vec4(layout.ratio, random.in(1.0f, 3.0f), glm::vec2(layout.fine))});
    return rows;
}

std::array<oracle::CoarseTap, 4> tapsOf(const Row& in) {
    return oracle::coarseTaps(ivec2(glm::floor(xy(in[0]))), static_cast<int>(in[1].x),
                              ivec2(in[0].z, in[0].w));
}

const std::string footprintBody = "CoarseFootprint f = coarseFootprint(in0.xy, in1.x, in0.zw);\n";

Comparison footprint(const Layout& layout) {
    return {{"coarseFootprint",
             {header},
             footprintBody + "out0 = float4(f.leftUp, f.rightUp); out1 = float4(f.leftDown, f.rightDown);"
                             "out2 = f.bilinearWeights;",
             2,
             3},
            pixelRows(layout),
            [](const Row& in) {
                const auto taps = tapsOf(in);
                dvec4 weights;
                std::array<dvec2, 4> uv;
                for (size_t i = 0; i < 4; ++i) {
                    weights[static_cast<int>(i)] = taps[i].bilinear;
                    uv[i] = (dvec2(taps[i].texel) + 0.5) / dvec2(in[0].z, in[0].w);
                }
                // One division each; the position is at most 7 texels, and the weights are products of two.
                const double error = 7.0 * divisionError + 4.0 * roundoff;
                return std::vector{near(dvec4(uv[0], uv[1]), divisionError),
                                   near(dvec4(uv[2], uv[3]), divisionError), near(weights, 2.0 * error)};
            }};
}

TEST(BilateralUpsampling, footprintIsThatOfPixelCentresForOddAndEvenSizes) {
    for (const Layout& layout : layouts()) {
        SCOPED_TRACE(layout.name());
        // Of ratio 3 a pixel lies on a coarse centre, where rounding may take either pair: same value.
        if (layout.ratio != 3) expectAgrees(footprint(layout));
    }
}

// Figure 7.2 as numbers, in sixteenths: the coarse texel whose tile holds the pixel counts 9.
TEST(BilateralUpsampling, weightsAreTheTableOfFigure72) {
    const std::vector<Row> rows = {{vec4(2.5, 2.5, 4, 4), vec4(2)},
                                   {vec4(3.5, 2.5, 4, 4), vec4(2)},
                                   {vec4(2.5, 3.5, 4, 4), vec4(2)},
                                   {vec4(3.5, 3.5, 4, 4), vec4(2)}};
    const vec4 table[] = {{1, 3, 3, 9}, {3, 1, 9, 3}, {3, 9, 1, 3}, {9, 3, 3, 1}};
    const auto out = run(footprint(layouts()[0]).function, rows);
    for (size_t texelNo = 0; texelNo < 4; ++texelNo)
        for (int i = 0; i < 4; ++i)
            EXPECT_EQ(out[texelNo][2][i], table[texelNo][i] / 16.0f) << texelNo << " " << i; // dyadic, exact
}

TEST(BilateralUpsampling, wrongFootprintsAreCaught) {
    const Comparison right = footprint({{7, 5}, 2});
    // Not turned by the place in the tile: the pixel's own texel always the upper left of the four.
    expectCaught(right, {header, "bilinearWeightsAt(positionTexels - first)",
                         "bilinearWeightsAt(float2(0.25, 0.25))"});
    expectCaught(right, {header, "max(ratio, 1.0) - 0.5", "max(ratio, 1.0)"}); // half a texel off
    expectCaught(right, {header, "footprint.rightUp = float2(high.x, low.y);",
                         "footprint.rightUp = float2(low.x, high.y);"}); // another sample's coordinate
    expectCaught(right, {header, "float4(left.x, right.x, left.x, right.x)",
                         "float4(left.x, left.x, right.x, right.x)"});
    // Of even sizes the last pixel has no texel to its right.
    expectCaught(footprint({{8, 6}, 2}), {header, "clamp(first + 1.0, 0.0, size - 1.0)", "(first + 1.0)"});
}

// --- Normals

// Vulkan: log2 within 3 steps, or 2^-21 between 1/2 and 2; exp2 within 3 + 2 |x| steps. The cosine itself is
// a sum of three products. Relative to the weight.
double normalWeightError(double cosine, double contrast) {
    if (!(cosine > 0.0) || !(contrast > 0.0)) return 0.0;
    const double step = 2.0 * roundoff, exponent = std::min(contrast, 256.0);
    const double log = std::log2(std::min(cosine, 1.0)), power = exponent * log;
    const double logError =
        (cosine >= 0.5 ? 0x1p-21 : 3.0 * step * std::abs(log)) + 6.0 * roundoff / (cosine * std::log(2.0));
    return std::log(2.0) * (exponent * logError + std::abs(power) * step) +
           (3.0 + 2.0 * std::abs(power)) * step;
}

glm::vec3 unitVector(Random& random) {
    glm::vec3 v(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    return glm::length(v) > 0.01f ? glm::normalize(v) : glm::vec3(0, 0, 1);
}

const float contrasts[] = {-1.0f, 0.0f, 0.5f, 1.0f, 8.0f, 64.0f, 255.0f, 256.0f, 1e30f};

Comparison likeness() {
    Random random(2);
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec3 hi = unitVector(random);
        const float spread = random.of(std::vector{0.0f, 0.05f, 0.5f, 2.0f});
        const glm::vec3 low = glm::normalize(hi + spread * unitVector(random) + glm::vec3(1e-6f));
        rows.push_back({vec4(i % 7 == 0 ? -hi : low, 0.0f), vec4(hi, random.of(contrasts))});
    }
    return {{"normalWeight", {header}, "out0.x = normalWeight(in0.xyz, in1.xyz, in1.w);", 2},
            rows,
            [](const Row& in) {
                const double weight = oracle::normalWeight(xyz(in[0]), xyz(in[1]), in[1].w);
                const double cosine = glm::dot(xyz(in[0]), xyz(in[1]));
                // Where the sign of the cosine is not certain, neither is a weight of a small exponent.
                if (std::abs(cosine) < 6.0 * roundoff) return std::vector{finite()};
                return std::vector{near(weight, weight * normalWeightError(cosine, in[1].w) + flush)};
            }};
}

TEST(BilateralUpsampling, likenessOfNormalsAgreesUpToAContrastOf256) {
    expectAgrees(likeness());
}

TEST(BilateralUpsampling, thePrintedNegativeBaseUnderPowIsCaught) {
    expectCaught(likeness(),
                 {header,
                  "similarity > 0.0 ? pow(min(abs(similarity), 1.0), min(contrastCoef, MAX_CONTRAST)) : 0.0",
                  "pow(similarity, min(contrastCoef, MAX_CONTRAST))"});
    // Its common repair lets a normal that faces away count as one that faces here.
    expectCaught(likeness(),
                 {header,
                  "similarity > 0.0 ? pow(min(abs(similarity), 1.0), min(contrastCoef, MAX_CONTRAST)) : 0.0",
                  "pow(min(abs(similarity), 1.0), min(contrastCoef, MAX_CONTRAST))"});
}

TEST(BilateralUpsampling, exponentWithoutItsLimitIsCaught) {
    expectCaught(likeness(),
                 {header, "min(contrastCoef, MAX_CONTRAST)", "min(contrastCoef, 0.5 * MAX_CONTRAST)"});
    expectCaught(likeness(), {header, "return contrastCoef > 0.0 ? weight : 1.0;", "return weight;"});
}

// --- The whole

// in0, in1: two values of each of the four samples; in2: depths; in3 to in6: normals, in3.w the pixel's depth
// and in4.w the contrast; in7: the pixel's normal; in8: bilinear weights.
const std::string shareNormals = "float4 n = normalWeightsOf(in3.xyz, in4.xyz, in5.xyz, in6.xyz, in7.xyz, "
                                 "in4.w); float depthHi = in3.w;\n";

struct Upsampled {
    dvec4 value{0.0};
    double bound = 0.0;
    bool decided = true;
};

// The mean of `values` and how far it may be off: each weight by its own error and by what underflows in it,
// times the range; the sum by some roundings.
Upsampled upsampled(const Row& in, bool withNormals, int components) {
    std::array<bool, 4> usable;
    std::array<dvec4, 4> values;
    dvec4 normal(1.0);
    std::array<double, 4> relative{};
    for (size_t i = 0; i < 4; ++i) {
        const int c = static_cast<int>(i);
        values[i] = dvec4(in[0][c], in[1][c], -in[0][c], 2.0 * in[1][c]);
        usable[i] = std::abs(in[0][c]) <= 1e38f && (components == 1 || std::abs(in[1][c]) <= 1e38f) &&
                    (components < 4 || std::abs(2.0f * in[1][c]) <= 1e38f);
        if (!withNormals) continue;
        normal[c] = oracle::normalWeight(xyz(in[3 + i]), xyz(in[7]), in[4].w);
        relative[i] = normalWeightError(glm::dot(xyz(in[3 + i]), xyz(in[7])), in[4].w);
    }
    const auto shares = oracle::bilateralShares(dvec4(in[8]), normal, dvec4(in[2]), in[3].w, usable);
    Upsampled result;
    dvec4 lowest(HUGE_VAL), highest(-HUGE_VAL);
    double uncertain = 0.0, nearest = HUGE_VAL, tie = HUGE_VAL;
    for (size_t i = 0; i < 4; ++i) {
        if (!usable[i]) continue;
        result.value += shares.of[i] * values[i];
        lowest = glm::min(lowest, values[i]);
        highest = glm::max(highest, values[i]);
        uncertain += shares.of[i] * (relative[i] + 2.0 * divisionError);
        const double difference = std::abs(in[3].w - dvec4(in[2])[static_cast<int>(i)]);
        if (difference > nearest) tie = std::min(tie, difference - nearest);
        if (difference < nearest) tie = nearest - difference, nearest = difference;
    }
    const double least = 1e-30;
    if (shares.totalWeight < least)
        result.decided = tie > 1e-5; // depths here are below 64: their differences are rounded at 4e-6
    else
        uncertain += 4e4 * flush / shares.totalWeight;
    // The total is compared with `least`; its own error is that of the largest weight.
    const double totalError = uncertain * shares.totalWeight + 4e4 * flush;
    result.decided = result.decided && std::abs(shares.totalWeight - least) > totalError;
    double range = 0.0, size = 0.0;
    for (int c = 0; c < components; ++c)
        if (highest[c] >= lowest[c]) {
            range = std::max(range, highest[c] - lowest[c]);
            size = std::max({size, std::abs(highest[c]), std::abs(lowest[c])});
        }
    result.bound = 2.0 * uncertain * range + 16.0 * roundoff * size + flush;
    return result;
}

Function upsampling() {
    return {
        "bilateralUpsample",
        {header},
        shareNormals +
            "out0.x = bilateralUpsample(in0, in8, n, in2, depthHi);\n"
            "out0.y = bilateralUpsample(in0, in8, in2, depthHi);\n"
            "float2 a = float2(in0.x, in1.x); float2 b = float2(in0.y, in1.y);\n"
            "float2 c = float2(in0.z, in1.z); float2 d = float2(in0.w, in1.w);\n"
            "out1.xy = bilateralUpsample(a, b, c, d, in8, n, in2, depthHi);\n"
            "out2.xy = bilateralUpsample(a, b, c, d, in8, in2, depthHi);\n"
            "float2 s = float2(-1.0, 2.0);\n"
            "out3 = bilateralUpsample(float4(a, a * s), float4(b, b * s), float4(c, c * s), float4(d, d * s),"
            " in8, n, in2, depthHi);\n"
            "out4 = bilateralUpsample(float4(a, a * s), float4(b, b * s), float4(c, c * s), float4(d, d * s),"
            " in8, in2, depthHi);",
        9,
        5};
}

std::vector<Expected> expectedUpsampling(const Row& in) {
    const auto component = [&](bool normals) { return upsampled(in, normals, 1); };
    const auto pair = [&](bool normals) {
        const Upsampled u = upsampled(in, normals, 2);
        return u.decided ? near(dvec2(u.value), u.bound) : finite();
    };
    const auto four = [&](bool normals) {
        const Upsampled u = upsampled(in, normals, 4);
        return u.decided ? near(u.value, u.bound) : finite();
    };
    const Upsampled with = component(true), without = component(false);
    Expected first = near(dvec2(with.value.x, without.value.x), 0.0);
    first.bound.x = with.decided ? with.bound : infinity;
    first.bound.y = without.decided ? without.bound : infinity;
    return {first, pair(true), pair(false), four(true), four(false)};
}

vec4 bilinearOf(Random& random) {
    const float x = random.of(std::vector{0.125f, 0.25f, 0.375f, 0.625f, 0.75f, 0.875f});
    const float y = random.of(std::vector{0.125f, 0.25f, 0.375f, 0.625f, 0.75f, 0.875f});
    return {(1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y};
}

// Flat ground, an edge between two depths, and any; with normals that agree, differ, and all face away.
Row upsamplingRow(Random& random, int i) {
    Row row(9, vec4(0.0f));
    row[0] = random.in4(0.0f, 1.0f);
    row[1] = random.in4(-2.0f, 3.0f);
    const float near = random.in(0.5f, 20.0f), far = near + random.in(0.01f, 40.0f);
    for (int c = 0; c < 4; ++c)
        row[2][c] = i % 3 == 0   ? near
                    : i % 3 == 1 ? (random.below(2) == 0 ? near : far)
                                 : random.in(0.5f, 60.0f);
    row[3].w = random.below(2) == 0 ? near : random.in(0.5f, 60.0f);
    row[4].w = random.of(contrasts);
    const glm::vec3 hi = unitVector(random);
    row[7] = vec4(hi, 0.0f);
    const float spread = random.of(std::vector{0.0f, 0.1f, 1.0f});
    for (size_t n = 3; n < 7; ++n) {
        const glm::vec3 low = glm::normalize(hi + spread * unitVector(random) + glm::vec3(1e-6f));
        row[n] = vec4(i % 8 == 0 ? -hi : low, row[n].w);
    }
    row[8] = bilinearOf(random);
    return row;
}

std::vector<Row> upsamplingRows(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i)
        rows.push_back(upsamplingRow(random, i));
    return rows;
}

// Some of the samples and of their depths are broken.
std::vector<Row> brokenRows(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    const float broken[] = {notANumber, infinity, -infinity, 3e38f};
    for (int i = 0; i < 3000; ++i) {
        Row row = upsamplingRow(random, i);
        for (int input = 0; input < 3; ++input)
            for (int c = 0; c < 4; ++c)
                if (random.below(4) == 0) row[static_cast<size_t>(input)][c] = random.of(broken);
        if (i % 10 == 0) row[3].w = random.of(broken);
        rows.push_back(row);
    }
    return rows;
}

Comparison upsamplingOf(std::vector<Row> rows) {
    return {upsampling(), std::move(rows), expectedUpsampling};
}

TEST(BilateralUpsampling, everyFormAgrees) {
    expectAgrees(upsamplingOf(upsamplingRows(3)));
}

TEST(BilateralUpsampling, brokenSamplesAndDepthsTakeNoPart) {
    expectAgrees(upsamplingOf(brokenRows(4)));
}

// The comparisons above leave open what rounding decides: hardly any row.
TEST(BilateralUpsampling, theOracleDecidesNearlyEveryRow) {
    size_t open = 0;
    const auto rows = upsamplingRows(3);
    for (const Row& row : rows)
        open += upsampled(row, true, 4).decided && upsampled(row, false, 4).decided ? 0 : 1;
    EXPECT_LE(open, rows.size() / 100);
}

TEST(BilateralUpsampling, wrongWeightsAreCaught) {
    const Comparison right = upsamplingOf(upsamplingRows(5));
    expectCaught(right, {header, "bilinearWeights * normalWeights / (DEPTH_WEIGHT_FLOOR + depthDiff)",
                         "bilinearWeights * normalWeights * (DEPTH_WEIGHT_FLOOR + depthDiff)"});
    expectCaught(right, {header, "DEPTH_WEIGHT_FLOOR = 0.0001", "DEPTH_WEIGHT_FLOOR = 0.001"});
    expectCaught(right,
                 {header, "abs(depthHi - depthLow)", "(depthHi - depthLow)"}); // sign of the depth term
    expectCaught(right, {header, "shares.x * numberOrZero(leftUp) + shares.y * numberOrZero(rightUp)",
                         "shares.y * numberOrZero(leftUp) + shares.x * numberOrZero(rightUp)"});
}

TEST(BilateralUpsampling, thePrintedDivisionByAZeroSumIsCaught) {
    expectCaught(upsamplingOf(upsamplingRows(5)), {header, "return isWeighed ? weights / totalWeight :",
                                                   "return true ? weights / totalWeight :"});
}

TEST(BilateralUpsampling, samplesThatAreNotSkippedAreCaught) {
    const Comparison broken = upsamplingOf(brokenRows(6));
    expectCaught(broken, {header, "usable * numberMask(depthDiff)", "numberMask(depthDiff)"});
    expectCaught(broken, {header, "usable * numberMask(depthDiff)", "usable"});
    expectCaught(broken, {header, "distance <= nearest ? usable : 0.0", "distance <= nearest ? 1.0 : 0.0"});
    // A mask by multiplication leaves the NaN in.
    expectCaught(broken,
                 {header, "dot(usable > 0.5 ? sampleLow : 0.0, shares)", "dot(sampleLow * usable, shares)"});
}

TEST(BilateralUpsampling, withoutWeightTheSampleNearestInDepthIsTaken) {
    Row row = {vec4(10, 20, 30, 40),   vec4(0),           vec4(5, 2.5f, 9, 2),
               vec4(0, 0, -1, 2.125f), vec4(0, 0, -1, 8), vec4(0, 0, -1, 0),
               vec4(0, 0, -1, 0),      vec4(0, 0, 1, 0),  vec4(0.25f)};
    EXPECT_EQ(run(upsampling(), {row})[0][0].x, 40.0f); // one sample, exact
    row[2] = vec4(5, 2.25f, 9, 2);                      // two equally near
    EXPECT_EQ(run(upsampling(), {row})[0][0].x, 30.0f);
    row[0].w = notANumber;
    EXPECT_EQ(run(upsampling(), {row})[0][0].x, 20.0f);
    row[2] = vec4(notANumber);
    EXPECT_EQ(run(upsampling(), {row})[0][0].x, 20.0f); // the mean of 10, 20 and 30
    row[0] = vec4(infinity, notANumber, -infinity, 3.4e38f);
    EXPECT_EQ(run(upsampling(), {row})[0][0].x, 0.0f);
}

TEST(BilateralUpsampling, hostileInputsGiveNumbers) {
    Random random(7);
    std::vector<float> values(std::begin(hostileFinite), std::end(hostileFinite));
    values.insert(values.end(), {1e38f, 3.4e38f, -3.4e38f, 1e-30f});
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i) {
        Row row(9);
        for (vec4& in : row)
            in = vec4(random.of(values), random.of(values), random.of(values), random.of(values));
        if (i % 2 == 0)
            row[static_cast<size_t>(random.below(3))][static_cast<int>(random.below(4))] = notANumber;
        rows.push_back(row);
    }
    expectAgrees({upsampling(), rows, [](const Row&) { return std::vector(5, finite()); }});
    expectAgrees({{"coarseFootprint",
                   {header},
                   "CoarseFootprint f = coarseFootprint(in0.xy, in0.z, in1.xy);\n"
                   "out0 = float4(f.leftUp, f.rightUp); out1 = float4(f.leftDown, f.rightDown);"
                   "out2 = f.bilinearWeights;",
                   9,
                   3},
                  rows,
                  [](const Row& in) {
                      const bool broken = std::isnan(in[0].x + in[0].y + in[0].z + in[1].x + in[1].y);
                      return broken ? std::vector<Expected>{} : std::vector(3, finite());
                  }});
}

// --- By depth alone, without a fallback

// in0 bilinear weights, in1 depths, in2 which are usable, in3.x the depth of the pixel; or in0.xy the place.
Comparison sharesOfDepths() {
    Random random(10);
    std::vector<Row> rows;
    const float marks[] = {0.0f, 1e-4f, 0.1f, 65503.996f, 65504.0f};
    const auto depthOf = [&](float near) {
        const uint32_t kind = random.below(4);
        return kind == 0   ? marks[random.below(5)]
               : kind == 1 ? near
               : kind == 2 ? std::min(near * (1.0f + std::exp2(random.in(-24.0f, 0.0f))), 65504.0f)
                           : std::exp2(random.in(-10.0f, 15.9f));
    };
    for (int i = 0; i < 6000; ++i) {
        const float near = std::exp2(random.in(-10.0f, 15.9f));
        Row row{bilinearOf(random), vec4(0.0f), vec4(1.0f), vec4(depthOf(near))};
        for (int c = 0; c < 4; ++c) {
            row[1][c] = depthOf(near);
            if (i % 3 == 0) row[2][c] = random.below(2) == 0 ? 1.0f : 0.0f;
        }
        rows.push_back(row);
    }
    return {{"bilateralSharesOfDepths", {header}, "out0 = bilateralSharesOfDepths(in0, in1, in3.x, in2);", 4},
            rows,
            [](const Row& in) {
                std::array<bool, 4> usable{};
                for (int c = 0; c < 4; ++c)
                    usable[static_cast<size_t>(c)] = in[2][c] > 0.5f;
                const auto shares =
                    oracle::bilateralShares(dvec4(in[0]), dvec4(1.0), dvec4(in[1]), in[3].x, usable);
                // Three roundings a denominator, of which a weight has three, and six products: 15. The total
                // has that and three sums, and is divided by.
                return std::vector{
                    near(dvec4(shares.of[0], shares.of[1], shares.of[2], shares.of[3]), 40.0 * roundoff)};
            }};
}

TEST(BilateralUpsampling, sharesOfDepthsAreThoseOfTheListing) {
    expectAgrees(sharesOfDepths());
}

TEST(BilateralUpsampling, sharesOfDepthsAddUpWhereAnyIsUsable) {
    const Comparison right = sharesOfDepths();
    const auto out = run(right.function, right.inputs);
    for (size_t i = 0; i < out.size(); ++i) {
        const float sum = glm::dot(out[i][0], vec4(1.0f)), usable = glm::dot(right.inputs[i][2], vec4(1.0f));
        ASSERT_NEAR(sum, usable > 0.0f ? 1.0f : 0.0f, 1e-6f) << "row " << i;
    }
}

TEST(BilateralUpsampling, wrongSharesOfDepthsAreCaught) {
    const Comparison right = sharesOfDepths();
    // The denominators of others, each with its own among them once.
    expectCaught(right,
                 {header, "denominators.yxxx * denominators.zzyy", "denominators.xxxx * denominators.zzyy"});
    expectCaught(right,
                 {header, "denominators.zzyy * denominators.wwwz", "denominators.zzyy * denominators.wwzz"});
    expectCaught(right,
                 {header, "bilinearWeights * usable * denominators", "bilinearWeights * denominators"});
    expectCaught(right, {header, "float4 denominators = DEPTH_WEIGHT_FLOOR + abs(depthHi - depthLow)",
                         "float4 denominators = abs(depthHi - depthLow)"});
    // A least total that a weight may be below.
    expectCaught(right, {header, "max(dot(weights, 1.0), MIN_TOTAL_WEIGHT)", "max(dot(weights, 1.0), 1e-9)"});
}

Comparison weightsAt() {
    Random random(11);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.unit(), random.unit(), 0, 0)});
    for (const float x : {0.0f, 0.125f, 0.25f, 0.5f, 0.875f, 1.0f})
        for (const float y : {0.0f, 0.375f, 0.75f, 1.0f})
            rows.push_back({vec4(x, y, 0, 0)});
    return {{"bilinearWeightsAt", {header}, "out0 = bilinearWeightsAt(in0.xy);"}, rows, [](const Row& in) {
                const double x = in[0].x, y = in[0].y;
                // A rounding of each difference and one of the product.
                return std::vector{
                    near(dvec4((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y), 3.0 * roundoff)};
            }};
}

TEST(BilateralUpsampling, bilinearWeightsAreThoseOfTheirPlace) {
    expectAgrees(weightsAt());
    expectCaught(weightsAt(), {header, "float4(left.y, left.y, right.y, right.y)",
                               "float4(left.y, right.y, left.y, right.y)"});
    expectCaught(weightsAt(), {header, "float2 left = 1.0 - right;", "float2 left = right;"});
}

// --- A pass over images

// The coarse texture has the value in red and the depth in alpha.
Comparison pass(const Layout& layout, const std::string& place) {
    const ivec2 coarse = coarseSizeOf(layout.fine, layout.ratio);
    const Texture texture{randomImage(coarse.x, coarse.y, 8, 1.0f, 3.0f), false};
    return {{"a pass",
             {header},
             "CoarseFootprint f = coarseFootprint(" + place +
                 ", in1.x, in0.zw);\n"
                 "float4 a = SAMPLE(gTexture0, f.leftUp); float4 b = SAMPLE(gTexture0, f.rightUp);\n"
                 "float4 c = SAMPLE(gTexture0, f.leftDown); float4 d = SAMPLE(gTexture0, f.rightDown);\n"
                 "out0.x = bilateralUpsample(float4(a.x, b.x, c.x, d.x), f.bilinearWeights,"
                 " float4(a.w, b.w, c.w, d.w), in1.y);",
             2,
             1,
             {},
             reprise::Stage::compute,
             {texture}},
            pixelRows(layout),
            [texture](const Row& in) {
                const auto taps = tapsOf(in);
                dvec4 bilinear, depth, value;
                for (int i = 0; i < 4; ++i) {
                    const auto& tap = taps[static_cast<size_t>(i)];
                    const dvec4 texel = texture.image.at(tap.texel.x, tap.texel.y);
                    bilinear[i] = tap.bilinear;
                    depth[i] = texel.w;
                    value[i] = texel.x;
                }
                const auto shares =
                    oracle::bilateralShares(bilinear, dvec4(1.0), depth, in[1].y, {true, true, true, true});
                double mean = 0.0;
                for (int i = 0; i < 4; ++i)
                    mean += shares.of[static_cast<size_t>(i)] * value[i];
                // Bilinear weights are off by some 1e-6 of their own for ratio 3, values lie within 2.
                return std::vector{near(mean, 2.0 * 2.0 * (2e-6 + 4.0 * divisionError) + 16.0 * roundoff)};
            }};
}

TEST(BilateralUpsampling, everyPixelReadsItsFourTexelsForOddAndEvenSizes) {
    for (const Layout& layout : layouts()) {
        SCOPED_TRACE(layout.name());
        expectAgrees(pass(layout, "in0.xy"));
    }
}

// Fine UV scaled to the coarse image: right for even sizes alone.
TEST(BilateralUpsampling, coarseUvTakenForFineUvIsCaught) {
    const std::string scaled = "in0.xy / in1.zw * in0.zw * in1.x";
    EXPECT_EQ(mismatches(pass({{8, 6}, 2}, scaled)), "");
    EXPECT_NE(mismatches(pass({{7, 5}, 2}, scaled)), "");
    EXPECT_NE(mismatches(pass({{13, 9}, 4}, scaled)), "");
}

// --- Listing 7.1 itself

// The listing, corrected, with one of its places as given.
struct Listing {
    std::string sums = "float totalWeight = 0.0; float upsampledResult = 0.0;";
    std::string product = "dot(normalsLow[i], normalHi)";
    std::string base = "normalWeights[i]";
    std::string factor = "sampleWeight";
};

Function listing71(const Listing& text) {
    return {"Listing 7.1",
            {header},
            "float3 normalsLow[4]; normalsLow[0] = in3.xyz; normalsLow[1] = in4.xyz; normalsLow[2] = in5.xyz;"
            "normalsLow[3] = in6.xyz; float3 normalHi = in7.xyz; float contrastCoef = in4.w;\n"
            "float normalWeights[4]; float depthWeights[4];" +
                text.sums +
                "\nfor (int i = 0; i < 4; i++) {\n"
                "    normalWeights[i] = " +
                text.product +
                ";\n"
                "    normalWeights[i] = pow(" +
                text.base +
                ", contrastCoef);\n"
                "    depthWeights[i] = 1.0 / (0.0001f + abs(in3.w - in2[i]));\n"
                "    float sampleWeight = normalWeights[i] * depthWeights[i] * in8[i];\n"
                "    totalWeight += sampleWeight;\n"
                "    upsampledResult += in0[i] * " +
                text.factor +
                ";\n"
                "}\n"
                "out0.x = upsampledResult / totalWeight;",
            9};
}

// Normals that face the pixel's and moderate contrasts: what the listing is for.
Comparison listingComparison(const Listing& text) {
    Random random(9);
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i) {
        Row row = upsamplingRow(random, 8 * i + 1);
        row[4].w = random.in(0.5f, 16.0f);
        for (size_t n = 3; n < 7; ++n)
            if (glm::dot(xyz(row[n]), xyz(row[7])) < 0.1) row[n] = vec4(glm::vec3(row[7]), row[n].w);
        rows.push_back(row);
    }
    return {listing71(text), rows, [](const Row& in) {
                const Upsampled u = upsampled(in, true, 1);
                return std::vector{near(u.value.x, 2.0 * u.bound)}; // its sums are rounded one by one
            }};
}

TEST(BilateralUpsampling, theCorrectedListingAgrees) {
    expectAgrees(listingComparison({}));
}

TEST(BilateralUpsampling, thePrintedDotOfASumIsCaught) {
    Listing printed;
    printed.product = "dot(normalsLow[i] + normalHi)";
    expectDoesNotCompile(listing71(printed), "dot");
    // Read as the length of the sum, or as its cosine with itself, it is no likeness either.
    printed.product = "dot(normalsLow[i] + normalHi, normalsLow[i] + normalHi)";
    EXPECT_NE(mismatches(listingComparison(printed)), "");
}

TEST(BilateralUpsampling, thePrintedVNormalWeightsIsCaught) {
    Listing printed;
    printed.base = "VNormalWeights[i]";
    expectDoesNotCompile(listing71(printed), "VNormalWeights");
}

TEST(BilateralUpsampling, thePrintedFWeightIsCaught) {
    Listing printed;
    printed.factor = "fWeight";
    expectDoesNotCompile(listing71(printed), "fWeight");
}

TEST(BilateralUpsampling, thePrintedSumsWithoutAStartAreCaught) {
    Listing printed;
    printed.sums = "";
    expectDoesNotCompile(listing71(printed), "totalWeight");
    // Declared without a value they hold whatever was there, such as what the pixel before left.
    printed.sums = "float totalWeight = in8.x; float upsampledResult = in0.x;";
    EXPECT_NE(mismatches(listingComparison(printed)), "");
}

TEST(BilateralUpsampling, thePrintedListingWithNormalsThatFaceAwayIsCaught) {
    Comparison away = listingComparison({});
    for (Row& row : away.inputs)
        for (size_t n = 3; n < 7; ++n)
            row[n] = vec4(-glm::vec3(row[7]), row[n].w);
    EXPECT_NE(mismatches(away), "");
    away.function = upsampling();
    EXPECT_EQ(mismatches(away), "");
}

} // namespace
} // namespace functions
