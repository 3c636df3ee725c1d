// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/directional_bilateral.hlsli";

// Values in r and g in [0, 1], depth in a: two surfaces, noisy by some of their distance.
Image twoSurfaces(int width, int height, uint32_t seed, double distance) {
    Random random(seed);
    Image image(width, height);
    for (dvec4& texel : image.texels)
        texel = dvec4(random.unit(), random.unit(), 0.0,
                      static_cast<double>(static_cast<float>(
                          5.0 + distance * static_cast<double>(random.below(2)) + 0.01 * random.unit())));
    return image;
}

enum class Reads { linear, point };

// in0: uv, direction; in1: amplitude, smoothing
Function filterOf(const Image& image, Reads reads) {
    const bool linear = reads == Reads::linear;
    const std::string size =
        "float2(" + std::to_string(image.width) + ".0, " + std::to_string(image.height) + ".0)";
    const std::string name = linear ? "Linear" : "Point";
    return {linear ? "Bilateral3D5x5" : "Bilateral3D5x5Point",
            {header},
            name + "Taps taps = read" + name + "Taps(TEXTURE_ARGUMENT(gTexture0), in0.xy, in0.zw / " + size +
                ");" + "out0.xyz = bilateralOf" + name + "Taps(taps, in1.x, in1.y);" +
                "out1.xy = " + (linear ? "Bilateral3D5x5" : "Bilateral3D5x5Point") +
                "(TEXTURE_ARGUMENT(gTexture0), 1.0 / " + size + ", in0.xy, in0.zw, in1.x, in1.y);",
            2,
            2,
            {},
            reprise::Stage::compute,
            {{image, linear}}};
}

std::vector<Row> texelsOf(const Image& image, uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int axis = 0; axis < 2; ++axis) {
                const vec4 place((static_cast<float>(x) + 0.5f) / static_cast<float>(image.width),
                                 (static_cast<float>(y) + 0.5f) / static_cast<float>(image.height),
                                 axis == 0 ? 1.0f : 0.0f, axis == 0 ? 0.0f : 1.0f);
                rows.push_back(
                    {place, vec4(random.of(std::vector{0.0f, 1.0f, 10.0f, 1000.0f}),
                                 random.of(std::vector{0.0f, 0.5f, 1.0f, 4.0f, 16.0f}), 0.0f, 0.0f)});
            }
    return rows;
}

glm::ivec2 texelOf(const Row& in, const Image& image) {
    return glm::ivec2(glm::floor(xy(in[0]) * image.extent()));
}

Comparison filtering(const Image& image, Reads reads) {
    return {filterOf(image, reads), texelsOf(image, 3), [image, reads](const Row& in) {
                const glm::ivec2 texel = texelOf(in, image);
                const double depth = image.at(texel.x, texel.y).a, amp = in[1].x;
                const dvec2 value = oracle::directionalBilateral(image, texel, {in[0].z, in[0].w}, amp,
                                                                 in[1].y, reads == Reads::linear);
                // Values of at most 1, 9 taps, two divisions: some 20 roundings. Point taps add none. A
                // linear filter's place is uv, of 24 bits, times at most 16 texels, and moves by that between
                // values that differ by 1 and depths that differ by 3 and are rounded at 8 m. A similarity
                // follows the difference of two such depths by at most amp.
                const double place = reads == Reads::linear ? 32.0 * roundoff : 0.0;
                const double depthError = reads == Reads::linear ? 3.0 * place + 16.0 * roundoff : 0.0;
                const double bound = 20.0 * roundoff + 2.0 * divisionError + place + 2.0 * amp * depthError;
                Expected all = near(dvec3(value, depth), bound), listed = near(dvec2(value.x, depth), bound);
                all.bound.z = listed.bound.y = depthError;
                return std::vector{all, listed};
            }};
}

TEST(DirectionalBilateral, linearTapsAreTheListing) {
    expectAgrees(filtering(twoSurfaces(16, 9, 1, 3.0), Reads::linear));
    expectAgrees(filtering(twoSurfaces(1, 1, 1, 3.0), Reads::linear));
}

TEST(DirectionalBilateral, pointTapsHaveTheSameFootprintTexelByTexel) {
    expectAgrees(filtering(twoSurfaces(16, 9, 2, 3.0), Reads::point));
    expectAgrees(filtering(twoSurfaces(2, 5, 2, 3.0), Reads::point));
}

TEST(DirectionalBilateral, swappedWeightsPlacesOrSignsAreCaught) {
    const Comparison linear = filtering(twoSurfaces(16, 9, 4, 3.0), Reads::linear);
    const Comparison point = filtering(twoSurfaces(16, 9, 5, 3.0), Reads::point);
    expectCaught(linear,
                 {header, "BILATERAL_INNER_WEIGHT = 0.244201342", "BILATERAL_INNER_WEIGHT = 0.054488685"});
    expectCaught(point, {header, "i <= 2 ? BILATERAL_INNER_WEIGHT : BILATERAL_OUTER_WEIGHT",
                         "i <= 2 ? BILATERAL_OUTER_WEIGHT : BILATERAL_INNER_WEIGHT"});
    expectCaught(point, {header, "amount * 0.5 *", "amount *"});
    expectCaught(linear, {header, "UV - 3.5 * offSize", "UV - 3.0 * offSize"});
    expectCaught(point, {header, "float(i - 4) * offSize", "float(i - 3) * offSize"});
    // The depth term without its magnitude: what is nearer would count more than the centre.
    expectCaught(linear, {header, "abs(depth - centreDepth)", "(depth - centreDepth)"});
    expectCaught(linear, {header, "1.0 + bounded(diffAmp, 0.0, LARGEST_TAP) * difference",
                          "1.0 - bounded(diffAmp, 0.0, LARGEST_TAP) * difference"});
    expectCaught(linear, {header, "sum.values * (1.0 / sum.weight)", "sum.values"});
}

// Printed: one number comes back. The second pass reads r and a, and where a is not the depth it filters
// across every edge, or by what the target held.
TEST(DirectionalBilateral, thePrintedReturnOfTheValueWithoutItsDepthIsCaught) {
    const Comparison right = filtering(twoSurfaces(16, 9, 6, 3.0), Reads::linear);
    expectCaught(right, {header, "return float3(mean, bounded(centreDepth, 0.0, LARGEST_TAP));",
                         "return float3(mean, mean.x);"}); // a float assigned to a float4 target
    expectCaught(right, {header, "return bilateralOfLinearTaps(taps, diffAmp, smoothing).xz;",
                         "return bilateralOfLinearTaps(taps, diffAmp, smoothing).xx;"});
}

// The listing's skeleton: constants, the body after them, and what it returns.
std::string listing(const std::string& afterConstants, const std::string& unused, const std::string& sum) {
    return "[[vk::binding(0)]] RWTexture2D<float4> gOut;"
           "static const float IN_BilateralFilterAmp = 2.0;"
           "float filtered(float4 taps, float4 depths, float2 color) {"
           "    const float E = 1.0;"
           "    const float diffAmp = IN_BilateralFilterAmp;" +
           afterConstants + unused +
           "    float4 diffIp = 1.0 / (E + diffAmp * abs(color.yyyy - depths));"
           "    float Wp = 1.0 / (" +
           sum +
           " + 0.402619947);"
           "    return Wp * (dot(diffIp, taps) + color.x * 0.402619947);"
           "}"
           "[numthreads(8, 8, 1)] void mainCompute(uint3 id : SV_DispatchThreadID) {"
           "    float4 v = float4(id.x, id.y, id.x + id.y, 1.0);"
           "    gOut[id.xy] = filtered(v, v.yxzw, v.xy);"
           "}";
}

const std::string dotOfOnes = "dot(diffIp, float4(1.0, 1.0, 1.0, 1.0))";

TEST(DirectionalBilateral, thePrintedBraceAfterDiffAmpIsCaught) {
    EXPECT_TRUE(compiles(listing("", "", dotOfOnes)));
    EXPECT_FALSE(compiles(listing("}", "", dotOfOnes)));
}

TEST(DirectionalBilateral, thePrintedUnusedVariablesAndScalarOfTheDotChangeNothing) {
    const auto spirv = [](const std::string& text) {
        return reprisec::compileSource({.name = "listing",
                                        .text = text,
                                        .entry = "mainCompute",
                                        .defines = {},
                                        .includeDirectories = {}})
            ->spirv;
    };
    const std::string unused = "float4 pSamples, nSamples; float4 diffIn;";
    EXPECT_EQ(spirv(listing("", unused, dotOfOnes)), spirv(listing("", "", dotOfOnes)));
    EXPECT_EQ(spirv(listing("", "", "dot(diffIp, 1)")), spirv(listing("", "", dotOfOnes)));
}

TEST(DirectionalBilateral, printedWeightsSumToOneAndAreThoseOfAGaussianAtWholeDistances) {
    const double sum = oracle::bilateralCentre + 2.0 * (oracle::bilateralInner + oracle::bilateralOuter);
    measured("sum of the printed weights, less 1", sum - 1.0);
    EXPECT_NEAR(sum, 1.0, 2e-9); // nine printed digits
    EXPECT_NEAR(oracle::bilateralInner / oracle::bilateralCentre, std::exp(-0.5),
                1e-8); // distance 1, deviation 1
    EXPECT_NEAR(oracle::bilateralOuter / oracle::bilateralCentre, std::exp(-2.0), 1e-8); // distance 2
    double variance = 0.0;
    for (const auto& [offset, weight] : oracle::pointFootprint())
        variance += weight * offset * offset;
    measured("deviation of the footprint in texels", std::sqrt(variance));
}

// On one surface both are the same filter.
TEST(DirectionalBilateral, bothFormsAgreeWhereDepthIsConstant) {
    Image image = twoSurfaces(16, 9, 7, 0.0);
    for (dvec4& texel : image.texels)
        texel.a = 7.0;
    const std::vector<Row> rows = texelsOf(image, 8);
    const auto linear = run(filterOf(image, Reads::linear), rows),
               point = run(filterOf(image, Reads::point), rows);
    for (size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 2; ++c) // as the bounds of both
            EXPECT_NEAR(linear[i][0][c], point[i][0][c], 200.0 * roundoff) << i;
}

// A row of texels (value, depth) through the filter; what comes out at each.
std::vector<double> filteredRow(Reads reads, const std::vector<dvec2>& texels, double amp) {
    const int width = static_cast<int>(texels.size());
    Image image(width, 1);
    std::vector<Row> rows;
    for (int x = 0; x < width; ++x) {
        const dvec2 texel = texels[static_cast<size_t>(x)];
        image.at(x, 0) = dvec4(texel.x, texel.x, 0.0, texel.y);
        rows.push_back({vec4((static_cast<float>(x) + 0.5f) / static_cast<float>(width), 0.5f, 1.0f, 0.0f),
                        vec4(static_cast<float>(amp), 1.0f, 0.0f, 0.0f)});
    }
    std::vector<double> values;
    for (const Row& out : run(filterOf(image, reads), rows))
        values.push_back(out[0].x);
    return values;
}

// A near surface of value 0, a far one of value 1 beside it: all that the near one takes over is leaked.
TEST(DirectionalBilateral, linearTapsLeakTwiceAsMuchWhereATapStraddlesAnEdge) {
    std::vector<dvec2> edge(16, dvec2(0.0, 5.0));
    for (size_t x = 8; x < 16; ++x)
        edge[x] = dvec2(1.0, 6.0);
    for (double amp : {1.0, 10.0, 100.0, 1000.0}) {
        const auto linear = filteredRow(Reads::linear, edge, amp),
                   point = filteredRow(Reads::point, edge, amp);
        const std::string at = "leak at depth difference * amp of " + std::to_string(static_cast<int>(amp));
        measured(at + ", second texel from the edge, linear taps", linear[6]);
        measured(at + ", second texel from the edge, point taps", point[6]);
        // Beside the edge every tap lies on one side of it: the same filter.
        EXPECT_NEAR(linear[7], point[7], 200.0 * roundoff);
        // One further, the inner tap holds a texel of each: half the value at half the difference, 1 / (2 +
        // amp) of its weight, where the far texel alone weighs 1 / (2 + 2 amp). The outer tap leaks as
        // before, and the near texel no longer stands against it.
        EXPECT_GT(linear[6] / point[6], amp >= 10.0 ? 1.7 : 1.2) << amp;
        EXPECT_LT(linear[6] / point[6], 2.2) << amp;
    }
}

// A texel before and one behind: their mean is at the depth of the centre, which neither belongs to. No
// amplitude keeps a linear tap from it.
TEST(DirectionalBilateral, linearTapsTakeTwoForeignSurfacesForTheirOwn) {
    std::vector<dvec2> row(16, dvec2(0.0, 10.0));
    row[9] = dvec2(1.0, 5.0);
    row[10] = dvec2(1.0, 15.0);
    for (double amp : {10.0, 1000.0, 100000.0}) {
        const double linear = filteredRow(Reads::linear, row, amp)[8],
                     point = filteredRow(Reads::point, row, amp)[8];
        const std::string at =
            "leak of two foreign texels around the centre's depth, amp " + std::to_string(amp);
        measured(at + ", linear taps", linear);
        measured(at + ", point taps", point);
        EXPECT_NEAR(linear, oracle::bilateralInner, 1e-3) << amp; // the tap's full weight
        // Both texels 5 away, beside the weights of all others.
        const double apart = oracle::bilateralInner / (1.0 - oracle::bilateralInner) / (1.0 + 5.0 * amp);
        EXPECT_LT(point, 1.001 * apart) << amp;
    }
}

TEST(DirectionalBilateral, smoothingGrowsWhereConvergenceIsLow) {
    const Function function{
        "smoothingOfConvergence", {header}, "out0.x = smoothingOfConvergence(in0.x, in0.y, in0.z);"};
    const Comparison comparison{function,
                                {{vec4(0, 8, 4, 0)},
                                 {vec4(2, 8, 4, 0)},
                                 {vec4(8, 8, 4, 0)},
                                 {vec4(200, 8, 4, 0)},
                                 {vec4(notANumber, 8, 4, 0)},
                                 {vec4(4, 8, 0.5, 0)},
                                 {vec4(0, 8, 1e30f, 0)}},
                                [](const Row& in) {
                                    const double share = 1.0 - oracle::held(in[0].x / 8.0, 0.0, 1.0);
                                    const double most = oracle::held(in[0].z, 1.0, 16.0);
                                    return std::vector{near(1.0 + (most - 1.0) * share, 20.0 * roundoff)};
                                }};
    expectAgrees(comparison);
    expectCaught(comparison, {header, "1.0 - bounded(convergence / max(converged, 1.0), 0.0, 1.0)",
                              "bounded(convergence / max(converged, 1.0), 0.0, 1.0)"});
}

TEST(DirectionalBilateral, smoothingOfZeroKeepsTheCentre) {
    const Image image = twoSurfaces(16, 9, 9, 3.0);
    std::vector<Row> rows = texelsOf(image, 10);
    for (Row& row : rows)
        row[1].y = 0.0f;
    const auto out = run(filterOf(image, Reads::point), rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        const glm::ivec2 texel = texelOf(rows[i], image);
        EXPECT_NEAR(out[i][0].x, image.at(texel.x, texel.y).r,
                    2.0 * divisionError); // times and through the weight
    }
}

// Nine taps in three inputs of (value, value, depth) ... from the row itself.
const std::string fillPointTaps = "PointTaps taps;"
                                  "taps.tap[0] = in0.xyz; taps.tap[1] = in1.xyz; taps.tap[2] = in2.xyz;"
                                  "taps.tap[3] = in3.xyz; taps.tap[4] = in4.xyz; taps.tap[5] = in5.xyz;"
                                  "taps.tap[6] = in6.xyz; taps.tap[7] = in7.xyz; taps.tap[8] = in8.xyz;"
                                  "LinearTaps five;"
                                  "for (int i = 0; i < 5; ++i) five.tap[i] = taps.tap[i + 2];";

TEST(DirectionalBilateral, noInputGivesNaNOrInfinity) {
    const Function both{"bilateral of any taps",
                        {header},
                        fillPointTaps + "out0.xyz = bilateralOfPointTaps(taps, in0.w, in1.w);"
                                        "out1.xyz = bilateralOfLinearTaps(five, in0.w, in1.w);"
                                        "out2.x = smoothingOfConvergence(in0.w, in1.w, in2.w);",
                        9,
                        3};
    expectNumbers(both, hostileRows(hostileFinite, 9, 4000, 11));
    expectNumbers(both, hostileRows(hostileAny, 9, 4000, 12));
}

TEST(DirectionalBilateral, brokenTapsAreLeftOut) {
    Random random(13);
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i) {
        Row row;
        for (int k = 0; k < 9; ++k)
            row.push_back(vec4(random.unit(), random.unit(), 5.0f, 2.0f));
        row[1].w = 1.0f;
        row[random.below(9)][static_cast<int>(random.below(3))] =
            random.of(std::vector{notANumber, infinity, -infinity});
        rows.push_back(row);
    }
    const Comparison comparison{{"bilateralOfPointTaps",
                                 {header},
                                 fillPointTaps + "out0.xyz = bilateralOfPointTaps(taps, in0.w, in1.w);",
                                 9},
                                rows,
                                [](const Row& in) {
                                    std::vector<oracle::BilateralTap> taps;
                                    const auto footprint = oracle::pointFootprint();
                                    for (size_t k = 0; k < 9; ++k)
                                        taps.push_back({xy(in[k]), in[k].z, footprint[k].second, k == 4});
                                    const dvec2 mean = oracle::bilateralMean(taps, in[0].w, 1.0);
                                    return std::vector{near(mean, 20.0 * roundoff + 2.0 * divisionError)};
                                }};
    expectAgrees(comparison);
    expectCaught(comparison, {header, "bool usable = abs(tap.x) <= LARGEST_TAP && abs(tap.y) <= LARGEST_TAP;",
                              "bool usable = true;"});
}

// Packed pairs under a linear filter: halfway between (0, 1) and (1, 0) lies neither's mean. Unpacked texel
// by texel it does. The header's own rule, shown.
TEST(DirectionalBilateral, packedDataThroughALinearFilterIsCaught) {
    const std::string packing = "reprise/occlusion_shadow_packing.hlsli";
    Random random(14);
    std::vector<Row> rows;
    for (int i = 0; i < 500; ++i)
        rows.push_back({vec4(random.unit(), random.unit(), random.unit(), random.unit())});
    const auto comparison = [&](const std::string& body) {
        return Comparison{{"mean of two packed texels",
                           {packing},
                           "float a = packOcclusionInInteger(in0.x, in0.y), "
                           "b = packOcclusionInInteger(in0.z, in0.w);" +
                               body},
                          rows,
                          [](const Row& in) {
                              // Half a level of the integer part; the fraction is off by the rounding at 32.
                              Expected expected =
                                  near(dvec2((in[0].x + in[0].z) / 2.0, (in[0].y + in[0].w) / 2.0),
                                       1.0 / 62.0 + 10.0 * roundoff);
                              return std::vector{expected};
                          }};
    };
    expectAgrees(comparison("out0.xy = 0.5 * (unpackOcclusionInInteger(a) + unpackOcclusionInInteger(b));"));
    EXPECT_NE(mismatches(comparison("out0.xy = unpackOcclusionInInteger(0.5 * (a + b));")), "");
}

} // namespace
} // namespace functions
