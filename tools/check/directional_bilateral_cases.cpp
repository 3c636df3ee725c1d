// SPDX-License-Identifier: Apache-2.0
// Listing 7.3.
#include "cases.hpp"
#include "images.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/directional_bilateral.hlsli";

// --- the weight of a depth difference

std::vector<Case> similarity() {
    return {{"depth 1e-4 to 1e7 m, amplitude 0 to 1e30, NaN and infinite",
             {"depthSimilarity", {header}, "out0.x = depthSimilarity(in0.x, in0.y, in0.z);"},
             {Unit::roundings, 10.0, "a difference, a product, a sum and a division, relative to themselves"},
             [](const Effort& effort) {
                 const auto broken = std::vector{infinity, notANumber, -1e30f, 1e30f};
                 Random random(1);
                 std::vector<Row> rows;
                 for (size_t i = 0; i < effort.of(60000); ++i) {
                     const float depth = std::exp2(random.in(-13.3f, 23.2f));
                     const float other = i % 2 == 0 ? depth * (1.0f + std::exp2(random.in(-24.0f, 4.0f)))
                                                    : std::exp2(random.in(-13.3f, 23.2f));
                     const float amp = i % 5 == 0 ? 0.0f : std::exp2(random.in(-20.0f, 100.0f));
                     rows.push_back({vec4(i % 9 == 0 ? random.of(broken) : other, depth, amp, 0)});
                 }
                 return Sweep{rows, [](const Row& in) {
                                  const double difference = std::abs(static_cast<double>(in[0].x) - in[0].y);
                                  const double value =
                                      std::isfinite(difference) ? 1.0 / (1.0 + in[0].z * difference) : 0.0;
                                  return std::vector{right(value, value)};
                              }};
             }},
            {"frames to ±1e30, NaN",
             {"smoothingOfConvergence", {header}, "out0.x = smoothingOfConvergence(in0.x, in0.y, in0.z);"},
             {Unit::roundings, 10.0, "a quotient and a product up to 16"},
             [](const Effort& effort) {
                 Random random(2);
                 std::vector<Row> rows;
                 for (size_t i = 0; i < effort.of(40000); ++i) {
                     const float frames = i % 3 == 0 ? anyValue(random) : random.in(0.0f, 300.0f);
                     rows.push_back({vec4(i % 7 == 0 ? notANumber : frames, random.in(1.0f, 64.0f),
                                          random.in(0.0f, 20.0f), 0)});
                 }
                 return Sweep{rows, [](const Row& in) {
                                  const double share =
                                      1.0 - oracle::held(static_cast<double>(in[0].x) / in[0].y, 0.0, 1.0);
                                  return std::vector{
                                      right(1.0 + (oracle::held(in[0].z, 1.0, 16.0) - 1.0) * share, 16.0)};
                              }};
             }}};
}

// --- the filter over given taps

// in0 to in8 are taps (value, value, depth), in9 the amplitude and the smoothing. The linear form takes in2
// to in6.
std::vector<Row> taps(const Effort& effort, bool broken) {
    Random random(3);
    const auto odd = std::vector{notANumber, infinity, -infinity};
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(40000); ++i) {
        const float depth = std::exp2(random.in(-13.3f, 23.2f));
        Row row;
        for (int k = 0; k < 9; ++k) {
            const float beside = i % 2 == 0 ? depth * (1.0f + std::exp2(random.in(-24.0f, 0.0f)))
                                            : std::exp2(random.in(-13.3f, 23.2f));
            row.push_back(vec4(random.colourValue(), random.colourValue(), i % 5 == 0 ? depth : beside, 0));
        }
        row.push_back(
            vec4(i % 7 == 0 ? 0.0f : std::exp2(random.in(-10.0f, 17.0f)), random.in(0.0f, 16.0f), 0, 0));
        if (broken)
            for (size_t k = 0; k < 9; ++k)
                if (random.below(3) == 0) row[k][static_cast<int>(random.below(2))] = random.of(odd);
        rows.push_back(row);
    }
    return rows;
}

// Each weight errs by some ten roundings of itself, and both sums by theirs.
std::vector<Right> meanOracle(const Row& in, const std::vector<std::pair<double, double>>& footprint,
                              size_t first) {
    std::vector<oracle::BilateralTap> list, magnitudes;
    for (size_t k = 0; k < footprint.size(); ++k) {
        const vec4& tap = in[first + k];
        list.push_back({xy(tap), tap.z, footprint[k].second, footprint[k].first == 0.0});
        magnitudes.push_back(list.back());
        magnitudes.back().values = glm::abs(list.back().values);
    }
    const size_t centre = first + footprint.size() / 2;
    const dvec2 mean = oracle::bilateralMean(list, in[9].x, in[9].y),
                size = oracle::bilateralMean(magnitudes, in[9].x, in[9].y);
    // Of a broken centre between neighbours of hardly any weight the total is lost.
    const bool lost = !std::isfinite(in[centre].x) || !std::isfinite(in[centre].y);
    double most = 0.0;
    for (size_t k = 0; k < footprint.size(); ++k)
        if (std::isfinite(list[k].values.x) && std::isfinite(list[k].values.y) && k != footprint.size() / 2)
            most = std::max(
                most, in[9].y / (1.0 + in[9].x * std::abs(list[k].depth - list[footprint.size() / 2].depth)));
    if (lost && most > 0.0 && most < 1e-25) return {open(3)};
    return {{dvec4(mean, in[centre].z, 0.0), dvec4(size, 0.0, 0.0), 3}};
}

std::vector<Right> pointOracle(const Row& in) {
    return meanOracle(in, oracle::pointFootprint(), 0);
}

std::vector<Right> linearOracle(const Row& in) {
    return meanOracle(in, oracle::linearFootprint(), 2);
}

const std::string fillPoint =
    "PointTaps t;\n"
    "t.tap[0] = in0.xyz; t.tap[1] = in1.xyz; t.tap[2] = in2.xyz; t.tap[3] = in3.xyz;\n"
    "t.tap[4] = in4.xyz; t.tap[5] = in5.xyz; t.tap[6] = in6.xyz; t.tap[7] = in7.xyz;\n"
    "t.tap[8] = in8.xyz;\n";
const std::string fillLinear =
    "LinearTaps t;\n"
    "t.tap[0] = in2.xyz; t.tap[1] = in3.xyz; t.tap[2] = in4.xyz; t.tap[3] = in5.xyz;\n"
    "t.tap[4] = in6.xyz;\n";

// The listing's sums, of either value; it carries no depth on.
const Printed listing{
    "Listing 7.3, one value and no depth",
    "float4 depths = float4(in2.z, in3.z, in5.z, in6.z);\n"
    "float4 weights = 1.0 / (1.0 + in9.x * abs(in4.z - depths)) *\n"
    "                 float4(0.054488685, 0.244201342, 0.244201342, 0.054488685);\n"
    "float total = 1.0 / (dot(weights, float4(1.0, 1.0, 1.0, 1.0)) + 0.402619947);\n"
    "out0.x = total * (dot(weights, float4(in2.x, in3.x, in5.x, in6.x)) + 0.402619947 * in4.x);\n"
    "out0.y = total * (dot(weights, float4(in2.y, in3.y, in5.y, in6.y)) + 0.402619947 * in4.y);\n"
    "out0.z = out0.x;",
    ""};

Case filtering(const std::string& function, const std::string& fill, Oracle oracle, bool broken) {
    Case made{
        broken ? "values NaN and infinite" : "depth 1e-4 to 1e7 m, amplitude to 1e5, smoothing to 16",
        {function, {header}, fill + "out0.xyz = " + function + "(t, in9.x, in9.y);", 10},
        {Unit::roundings, 30.0, "weights of ten roundings, two sums of up to nine terms and a division"},
        [oracle, broken](const Effort& effort) {
            return Sweep{taps(effort, broken), oracle};
        }};
    return made;
}

// At smoothing 1 it is the listing.
Case asListed(bool broken) {
    Case made = filtering("bilateralOfLinearTaps", fillLinear, linearOracle, broken);
    made.sweep = broken ? "values NaN and infinite, smoothing 1"
                        : "depth 1e-4 to 1e7 m, amplitude to 1e5, smoothing 1";
    made.make = [broken](const Effort& effort) {
        std::vector<Row> rows = taps(effort, broken);
        for (Row& row : rows)
            row[9].y = 1.0f;
        return Sweep{rows, linearOracle};
    };
    made.printed = listing;
    return made;
}

Case anyTaps(const std::string& function, const std::string& fill) {
    return {"all to ±1e30, NaN and infinite",
            {function, {header}, fill + "out0.xyz = " + function + "(t, in9.x, in9.y);", 10},
            {Unit::finite, 0.0, "means of numbers, and a depth"},
            [](const Effort& effort) {
                const auto values = beyondMarks + std::vector{infinity, -infinity, notANumber};
                Random random(4);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(20000); ++i) {
                    Row row;
                    for (int k = 0; k < 10; ++k)
                        row.push_back(vec4(random.of(values), anyValue(random), random.of(values), 0));
                    rows.push_back(row);
                }
                return Sweep{rows, [](const Row&) { return std::vector{open(3)}; }};
            }};
}

// --- its parts

std::vector<Case> parts() {
    const auto broken = [](const Row& in) {
        return !(std::abs(in[0].x) <= 1e36f && std::abs(in[0].y) <= 1e36f);
    };
    const auto tapRows = [](const Effort& effort) {
        const auto values = beyondMarks + std::vector{0.5f, infinity, -infinity, notANumber};
        Random random(5);
        std::vector<Row> rows;
        for (size_t i = 0; i < effort.of(40000); ++i)
            rows.push_back({vec4(random.of(values), i % 2 == 0 ? random.of(values) : anyValue(random),
                                 random.unit(), random.unit())});
        return rows;
    };
    return {{"values to ±1e30, NaN and infinite",
             {"addTap",
              {header},
              "BilateralSum sum; sum.values = float2(1.0, -1.0); sum.weight = 0.5;\n"
              "addTap(sum, in0.xyz, in0.w); out0.xyz = float3(sum.values, sum.weight);"},
             {Unit::roundings, 2.0, "a product and a sum"},
             [=](const Effort& effort) {
                 return Sweep{tapRows(effort), [=](const Row& in) {
                                  const dvec2 added =
                                      broken(in) ? dvec2(0.0) : xy(in[0]) * static_cast<double>(in[0].w);
                                  return std::vector{
                                      right(dvec3(dvec2(1.0, -1.0) + added, broken(in) ? 0.5 : 0.5 + in[0].w),
                                            dvec3(dvec2(1.0) + glm::abs(added), 2.0))};
                              }};
             }},
            {"values to ±1e30, NaN and infinite",
             {"sumOfCentre",
              {header},
              "BilateralSum sum = sumOfCentre(in0.xyz); out0.xyz = float3(sum.values, sum.weight);"},
             {Unit::roundings, 3.0, "the constant and a product"},
             [=](const Effort& effort) {
                 return Sweep{tapRows(effort), [=](const Row& in) {
                                  const dvec3 value = broken(in)
                                                          ? dvec3(0.0)
                                                          : oracle::bilateralCentre * dvec3(xy(in[0]), 1.0);
                                  return std::vector{right(value, glm::abs(value))};
                              }};
             }},
            {"weights 0, 1e-30 to 16, depth to ±1e30, NaN",
             {"meanOfTaps",
              {header},
              "BilateralSum sum; sum.values = in0.xy * in0.w; sum.weight = in0.w; out0.xyz = meanOfTaps(sum, "
              "in0.z);"},
             {Unit::roundings, 6.0, "a product and a division; open beside the least weight, 1e-30"},
             [](const Effort& effort) {
                 Random random(6);
                 std::vector<Row> rows;
                 for (size_t i = 0; i < effort.of(40000); ++i) {
                     const float weight = i % 4 == 0 ? 0.0f : std::exp2(random.in(-99.0f, 4.0f));
                     const float depth = i % 3 == 0
                                             ? random.of(beyondMarks + std::vector{infinity, notANumber})
                                             : random.in(0.0f, 100.0f);
                     rows.push_back({vec4(random.colourValue(), random.colourValue(), depth, weight)});
                 }
                 return Sweep{rows, [](const Row& in) {
                                  const double weight = in[0].w;
                                  if (weight > 0.0 && weight < 1.01e-30) return std::vector{open(3)};
                                  const dvec3 value(weight > 1e-30 ? xy(in[0]) : dvec2(0.0),
                                                    oracle::held(in[0].z, 0.0, 1e36));
                                  return std::vector{right(value, value)};
                              }};
             }}};
}

// --- reads

oracle::Image twoSurfaces() {
    Random random(7);
    oracle::Image image(16, 9);
    for (dvec4& texel : image.texels)
        texel = dvec4(vec4(random.unit(), random.unit(), 0.0f,
                           5.0f + 3.0f * static_cast<float>(random.below(2)) + 0.01f * random.unit()));
    return image;
}

// in0: uv of a texel's centre, direction; in1: amplitude and smoothing
std::vector<Row> texels(const Effort& effort) {
    Random random(8);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(20000); ++i) {
        const bool across = random.below(2) == 0;
        rows.push_back(
            {vec4((0.5f + static_cast<float>(random.below(16))) / 16.0f,
                  (0.5f + static_cast<float>(random.below(9))) / 9.0f, across, !across),
             vec4(i % 4 == 0 ? 0.0f : std::exp2(random.in(-4.0f, 10.0f)), random.in(0.0f, 16.0f), 0, 0)});
    }
    return rows;
}

glm::ivec2 texelOf(const Row& in) {
    return glm::ivec2(glm::floor(xy(in[0]) * dvec2(16.0, 9.0)));
}

// A linear filter's place is uv, of 24 bits, times at most 16 texels, and moves by that between values that
// differ by 1 and depths that differ by 3 and are rounded at 8 m; a similarity follows a depth by amp.
Case listingOfImage(const std::string& function, bool linear) {
    const oracle::Image image = twoSurfaces();
    return {"two surfaces, amplitude to 1000, smoothing to 16",
            {function,
             {header},
             "out0.xy = " + function +
                 "(TEXTURE_ARGUMENT(gTexture0), 1.0 / float2(16.0, 9.0), in0.xy, in0.zw, in1.x, in1.y);",
             2,
             1,
             {},
             reprise::Stage::compute,
             {{image, linear}}},
            {Unit::roundings, 30.0, "as over given taps; linear taps lie where their place is rounded"},
            [image, linear](const Effort& effort) {
                return Sweep{
                    texels(effort), [image, linear](const Row& in) {
                        const glm::ivec2 texel = texelOf(in);
                        const dvec2 value = oracle::directionalBilateral(image, texel, {in[0].z, in[0].w},
                                                                         in[1].x, in[1].y, linear);
                        const double place = linear ? 32.0 : 0.0,
                                     depthError = linear ? 3.0 * place + 16.0 : 0.0;
                        return std::vector{Right{
                            dvec4(value.x, image.at(texel.x, texel.y).a, 0, 0),
                            dvec4(1.0 + (place + 2.0 * in[1].x * depthError) / 30.0, depthError / 30.0, 0, 0),
                            2}};
                    }};
            }};
}

Case reading(bool linear) {
    const oracle::Image image = twoSurfaces();
    const std::string form = linear ? "Linear" : "Point", last = linear ? "4" : "8";
    return {"two surfaces, along and across",
            {"read" + form + "Taps",
             {header},
             form + "Taps t = read" + form +
                 "Taps(TEXTURE_ARGUMENT(gTexture0), in0.xy, in0.zw / float2(16.0, 9.0));\n"
                 "out0.xyz = t.tap[0]; out1.xyz = t.tap[1]; out2.xyz = t.tap[" +
                 last + "];",
             2,
             3,
             {},
             reprise::Stage::compute,
             {{image, linear}}},
            {Unit::absolute, linear ? 3.0 * 40.0 * roundoff + 16.0 * roundoff : 0.0,
             linear ? "halves between texels, at a place that is rounded, of depths that differ by 3 m"
                    : "point reads copy"},
            [image, linear](const Effort& effort) {
                return Sweep{texels(effort), [image, linear](const Row& in) {
                                 const auto footprint =
                                     linear ? oracle::linearFootprint() : oracle::pointFootprint();
                                 std::vector<Right> all;
                                 for (size_t k : {size_t{0}, size_t{1}, footprint.size() - 1}) {
                                     const dvec2 place = (dvec2(texelOf(in)) + 0.5 +
                                                          footprint[k].first * dvec2(in[0].z, in[0].w)) /
                                                         image.extent();
                                     const dvec4 read = linear ? oracle::sampleLinear(image, place)
                                                               : oracle::samplePoint(image, place);
                                     all.push_back(right(dvec3(read.x, read.y, read.w)));
                                 }
                                 return all;
                             }};
            }};
}

} // namespace

std::vector<Case> directionalBilateralCases() {
    std::vector<Case> all = similarity();
    for (bool broken : {false, true}) {
        all.push_back(filtering("bilateralOfPointTaps", fillPoint, pointOracle, broken));
        all.push_back(filtering("bilateralOfLinearTaps", fillLinear, linearOracle, broken));
        all.push_back(asListed(broken));
    }
    all.push_back(anyTaps("bilateralOfPointTaps", fillPoint));
    all.push_back(anyTaps("bilateralOfLinearTaps", fillLinear));
    for (Case& each : parts())
        all.push_back(std::move(each));
    all.push_back(reading(true));
    all.push_back(reading(false));
    all.push_back(listingOfImage("Bilateral3D5x5", true));
    all.push_back(listingOfImage("Bilateral3D5x5Point", false));
    return all;
}

} // namespace check
