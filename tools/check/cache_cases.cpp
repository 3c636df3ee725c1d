// SPDX-License-Identifier: Apache-2.0
// reprojection_cache.hlsli, cache_resampling.hlsli and finite.hlsli.
#include "cases.hpp"
#include "images.hpp"
#include "reprojections.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::filterStep;
using functions::Projection;

const std::string cache = "reprise/reprojection_cache.hlsli", reads = "reprise/cache_resampling.hlsli",
                  finite = "reprise/finite.hlsli";

bool isNumber(double v) {
    return std::abs(v) <= 1e38;
}

// --- what counts as a number

std::vector<Row> numbers(const Effort& effort) {
    const std::vector<float> marks =
        beyondMarks + ofBothSigns({9.9e37f, 1.1e38f, 3.4e38f, infinity, notANumber});
    Random random(1);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(40000); ++i) {
        vec4 value(0.0f);
        for (int c = 0; c < 4; ++c)
            value[c] = random.below(2) == 0 ? random.of(marks) : anyValue(random);
        rows.push_back({value});
    }
    return rows;
}

bool areNumbers(const vec4& v, int components) {
    for (int c = 0; c < components; ++c)
        if (!isNumber(v[c])) return false;
    return true;
}

std::vector<Case> numberCases() {
    const Bound exact{Unit::exact, 0.0, "ordered comparisons and copies"};
    const std::string sweep = "to ±3.4e38, NaN and infinity too";
    return {{sweep,
             {"isNumber", {finite}, "out0.xyz = float3(isNumber(in0.x), isNumber(in0.xy), isNumber(in0));"},
             exact,
             [](const Effort& effort) {
                 return Sweep{numbers(effort), [](const Row& in) {
                                  return std::vector{right(dvec3(areNumbers(in[0], 1), areNumbers(in[0], 2),
                                                                 areNumbers(in[0], 4)))};
                              }};
             }},
            {sweep,
             {"numberMask", {finite}, "out0 = numberMask(in0);"},
             exact,
             [](const Effort& effort) {
                 return Sweep{numbers(effort), [](const Row& in) {
                                  return std::vector{right(dvec4(isNumber(in[0].x), isNumber(in[0].y),
                                                                 isNumber(in[0].z), isNumber(in[0].w)))};
                              }};
             }},
            {sweep,
             {"numberOrZero",
              {finite},
              "out0.x = numberOrZero(in0.x); out1.xy = numberOrZero(in0.xy); out2 = numberOrZero(in0);",
              1,
              3},
             exact,
             [](const Effort& effort) {
                 return Sweep{numbers(effort), [](const Row& in) {
                                  const dvec4 v(in[0]);
                                  return std::vector{right(areNumbers(in[0], 1) ? v.x : 0.0),
                                                     right(areNumbers(in[0], 2) ? dvec2(v) : dvec2(0.0)),
                                                     right(areNumbers(in[0], 4) ? v : dvec4(0.0))};
                              }};
             }}};
}

// --- places

Case centres(bool direct3d9) {
    return {direct3d9 ? "every size to 16384, Direct3D 9" : "every size to 16384",
            {"pixelCentreUv",
             {cache},
             "out0.xy = pixelCentreUv(in0.xy, in0.zw);",
             2,
             1,
             Defines{{"PLATFORM_D3D9", direct3d9}}},
            {Unit::roundings, 2.0, "the texel's size and a product, below 1"},
            [direct3d9](const Effort& effort) {
                Random random(2);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(40000); ++i) {
                    const float size = 1.0f + static_cast<float>(random.below(16384));
                    const vec4 pixel = glm::floor(size * random.in4(0.0f, 0.99999f));
                    const float at = direct3d9 ? 0.0f : 0.5f;
                    rows.push_back({vec4(pixel.x + at, pixel.y + at, 1.0f / size, 1.0f / size),
                                    vec4(pixel.x, pixel.y, size, size)});
                }
                return Sweep{rows, [](const Row& in) {
                                 return std::vector{right((xy(in[1]) + 0.5) / dvec2(in[1].z, in[1].w), 1.0)};
                             }};
            }};
}

std::vector<Row> clipPositions(const Effort& effort) {
    const auto ws = ofBothSigns(std::vector{0.0f, 1e-40f, 1e-30f, 1e30f} +
                                logarithmic(1e-11, 1e7, effort.quick ? 20 : 200));
    Random random(3);
    std::vector<Row> rows;
    for (float w : ws)
        for (int i = 0; i < 100; ++i)
            rows.push_back({vec4(std::abs(w) * random.in(-1.5f, 1.5f), std::abs(w) * random.in(-1.5f, 1.5f),
                                 anyValue(random), w),
                            vec4(i % 2 == 0 ? 0.0f : random.in(-1.0f, 1.0f), 1.0f, 0, 0)});
    return rows;
}

std::vector<Right> clipOracle(const Row& in) {
    const double z = static_cast<double>(in[0].z) * in[1].x, w = static_cast<double>(in[0].w) * in[1].y;
    return {clipRight(dvec4(in[0]), false), right(z + w, std::abs(z) + std::abs(w))};
}

const std::string placeOut = "out0.xy = p.prevUv; out1.x = p.lastDepth;";

Case fromClip() {
    Case made{
        "w through 0 and negative, to ±1e30",
        {"cachePlaceFromClip", {cache}, "CachePlace p = cachePlaceFromClip(in0, in1.xy);\n" + placeOut, 2, 2},
        {Unit::roundings, clipRoundings, "as clipToUv; two products and a sum of depth"},
        [](const Effort& effort) {
            return Sweep{clipPositions(effort), clipOracle};
        }};
    made.printed = {"Listing 7.2, LastClipSpacePos",
                    "float4 last = in0 / in0.w; last.xy *= float2(0.5, -0.5); last.xy *= float2(0.5, 0.5);\n"
                    "out0.xy = last.xy; out1.x = in0.z * in1.x + in0.w * in1.y;",
                    ""};
    return made;
}

dvec2 clipToDepth(const Projection& projection) {
    return projection.orthographic ? linearDepthCoefficients(projection) : dvec2(0.0, 1.0);
}

Case fromDepth(const std::string& kind, const std::vector<Projection>& projections) {
    return {
        kind + ", 1e-4 to 1e7 m, cuts too",
        {"cachePlaceFromDepth",
         {cache},
         "CachePlace p = cachePlaceFromDepth(in4.xy, in4.z, in5, float4x4(in0, in1, in2, in3), in6.xy);\n" +
             placeOut,
         7,
         2,
         Defines{{"ORTHOGRAPHIC", projections.front().orthographic}}},
        {Unit::roundings, matrixRoundings,
         "a matrix of binary32 and its product at the sums of the absolute products, over w; open where w is "
         "not clear of that"},
        [projections](const Effort& effort) {
            const auto made = reprojections(projections, effort, false);
            for (Row& row : made->rows)
                row.push_back(
                    vec4(clipToDepth(made->cameras[static_cast<size_t>(row[4].w)].projection), 0, 0));
            return Sweep{
                made->rows, [made](const Row& in) {
                    const MovedCamera& camera = made->cameras[static_cast<size_t>(in[4].w)];
                    const double depth =
                        oracle::previousLinearDepth(xy(in[4]), in[4].z, camera.current, camera.previous);
                    const dvec2 factor = clipToDepth(camera.projection);
                    const dvec4 sizes = clipSizes(in, camera);
                    const double size = sizes.z * std::abs(factor.x) + sizes.w * std::abs(factor.y);
                    return std::vector{placeFromLinear(in, camera),
                                       right(depth, 1.5 * (size + std::abs(factor.y) + std::abs(depth)))};
                }};
        }};
}

// in0 is (uv, motion), in1 the depth.
Case fromMotion() {
    return {"motion 0, 1e-12 to 1e6 px, NaN and infinite",
            {"cachePlaceFromMotion",
             {cache},
             "CachePlace p = cachePlaceFromMotion(in0.xy, in0.zw, in1.x);\n" + placeOut,
             2,
             2},
            {Unit::roundings, 1.0, "a difference"},
            [](const Effort& effort) {
                const auto motions = ofBothSigns(std::vector{0.0f, 1e-40f, 1e30f, infinity, notANumber} +
                                                 logarithmic(1e-15, 520.0, effort.of(5000)));
                Random random(4);
                std::vector<Row> rows;
                for (float motion : motions)
                    for (int i = 0; i < 4; ++i)
                        rows.push_back(
                            {vec4(random.unit(), random.unit(), motion, random.in(-1.0f, 1.0f) * motion),
                             vec4(i == 0 ? random.of(std::vector{notANumber, infinity, 1e30f})
                                         : anyValue(random))});
                return Sweep{rows, [](const Row& in) {
                                 const dvec2 uv = xy(in[0]) - dvec2(in[0].z, in[0].w), size = glm::abs(uv);
                                 const bool known = size.x <= 8.0 && size.y <= 8.0;
                                 const bool atLimit = std::abs(std::max(size.x, size.y) - 8.0) < 1e-6;
                                 return std::vector{atLimit
                                                        ? open(2)
                                                        : right(known ? uv : oracle::behindCameraUv,
                                                                largest(dvec3(known ? uv : dvec2(8.0), 0.0))),
                                                    right(isNumber(in[1].x) ? in[1].x : 0.0)};
                             }};
            }};
}

// --- weight and blend

// in0 is (uv, last depth, cache depth), in1 (threshold, convergence).
std::vector<Row> weightRows(const Effort& effort) {
    Random random(5);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float last = std::exp2(random.in(-13.3f, 23.2f)),
                    threshold = last * std::exp2(random.in(-20.0f, 1.0f));
        const float cached = i % 9 == 0 ? last : last + threshold * random.in(-2.0f, 2.0f);
        rows.push_back({vec4(random.in(-0.1f, 1.1f), random.in(-0.1f, 1.1f), last, cached),
                        vec4(threshold, std::exp2(random.in(-1.0f, 5.0f)) / threshold, 0, 0)});
    }
    return rows;
}

std::vector<Right> weightOracle(const Row& in) {
    for (int axis = 0; axis < 2; ++axis)
        for (const double edge : {0.0, 1.0})
            if (std::abs(static_cast<double>(in[0][axis]) - edge) <= 0x1p-25) return {open(1)};
    const double difference = std::abs(static_cast<double>(in[0].z) - in[0].w);
    return {right(oracle::cacheHistoryWeight(xy(in[0]), in[0].z, in[0].w, in[1].x, in[1].y),
                  1.0 + (difference + in[1].x) * in[1].y)};
}

const std::string weightBody = "CachePlace p; p.prevUv = in0.xy; p.lastDepth = in0.z;\n"
                               "out0.x = cacheHistoryWeight(p, in0.w, in1.x, in1.y);";

std::vector<Case> weights() {
    Case stiff{"depth 1e-4 to 1e7 m, thresholds 1e-6 to 2 of it",
               {"cacheHistoryWeight", {cache}, weightBody, 2},
               {Unit::roundings, 4.0, "two differences and a product, at depth difference and threshold"},
               [](const Effort& effort) {
                   return Sweep{weightRows(effort), weightOracle};
               }};
    stiff.printed = {"Listing 7.2, missRate",
                     "float missRate = abs(in0.z - in0.w) - in1.x;\n"
                     "if (in0.x < 0.0 || in0.x > 1.0 || in0.y < 0.0 || in0.y > 1.0) missRate = 0.0;\n"
                     "out0.x = saturate(missRate * in1.y);",
                     ""};
    Case broken{"all to ±1e30, NaN and infinite: outside of [0, 1]",
                {"cacheHistoryWeight",
                 {cache},
                 weightBody + "\nout0.x = out0.x >= 0.0 && out0.x <= 1.0 ? 0.0 : 1.0;",
                 2},
                {Unit::exact, 0.0, "a weight, whichever"},
                [](const Effort& effort) {
                    Random random(6);
                    const std::vector<float> values =
                        beyondMarks + std::vector{0.5f, infinity, -infinity, notANumber};
                    std::vector<Row> rows;
                    for (size_t i = 0; i < effort.of(40000); ++i)
                        rows.push_back({vec4(random.of(values), 0.5f, random.of(values), random.of(values)),
                                        vec4(random.of(values), random.of(values), 0, 0)});
                    return Sweep{rows, [](const Row&) { return std::vector{right(0.0)}; }};
                }};
    return {stiff, broken};
}

// in0 fresh, in1 history, in2.x weight. One broken component breaks the value.
std::vector<Row> blendRows(const Effort& effort) {
    Random random(7);
    std::vector<float> shares{0.0f, 1.0f, -1.0f, 2.0f};
    for (float share : powersOfHalf(1, 24)) {
        shares.push_back(share);
        shares.push_back(1.0f - share);
    }
    const auto values = colourMarks + beyondMarks + std::vector{infinity, -infinity, notANumber};
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        Row row{random.colour(), random.colour(), vec4(random.of(shares))};
        row[0].w = random.colourValue();
        row[1].w = random.colourValue();
        for (size_t input : {0, 1})
            if (random.below(2) == 0) row[input][static_cast<int>(random.below(4))] = random.of(values);
        rows.push_back(row);
    }
    return rows;
}

Right blendRight(const Row& in, int components) {
    const bool fresh = areNumbers(in[0], components), history = areNumbers(in[1], components);
    Right made;
    made.components = components;
    for (int c = 0; c < components; ++c) {
        const double a = fresh ? in[0][c] : 0.0, b = history ? in[1][c] : 0.0;
        const double weight = history ? std::clamp(static_cast<double>(in[2].x), 0.0, 1.0) : 0.0;
        made.value[c] = a * (1.0 - weight) + b * weight;
        made.size[c] = std::max(std::abs(a), std::abs(b));
    }
    return made;
}

Case blends() {
    Case made{"to ±1e30, NaN and infinite, weights 0, 1, 2^-k, 1 - 2^-k",
              {"reproCache",
               {cache},
               "out0.x = reproCache(in0.x, in1.x, in2.x); out1.xy = reproCache(in0.xy, in1.xy, in2.x);\n"
               "out2 = reproCache(in0, in1, in2.x);",
               3,
               3},
              {Unit::roundings, 6.0, "a difference, of up to twice the larger, a product and a sum"},
              [](const Effort& effort) {
                  return Sweep{
                      blendRows(effort), [](const Row& in) {
                          return std::vector{blendRight(in, 1), blendRight(in, 2), blendRight(in, 4)};
                      }};
              }};
    made.printed = {"Listing 7.2, freshData",
                    "float w = saturate(in2.x); out0.x = in0.x + (in1.x - in0.x) * w;\n"
                    "out1.xy = in0.xy + (in1.xy - in0.xy) * w; out2 = in0 + (in1 - in0) * w;",
                    ""};
    return made;
}

// --- reads of the cache

Case meanOf() {
    return {"values to ±1e30, NaN and infinite",
            {"meanOfNumbers", {reads}, "out0 = meanOfNumbers(in0, in1, in2, in3, in4);", 5},
            {Unit::roundings, 16.0, "products, three sums and a division at the sum of the absolute terms"},
            [](const Effort& effort) {
                Random random(8);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(40000); ++i) {
                    Row row;
                    for (int k = 0; k < 4; ++k)
                        row.push_back(i % 2 == 0 ? random.colour() : anyColour(random));
                    if (i % 3 == 0)
                        row[random.below(4)].y = random.of(std::vector{notANumber, infinity, -infinity});
                    const float x = random.unit(), y = random.unit();
                    row.push_back(vec4((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y));
                    rows.push_back(row);
                }
                return Sweep{rows, [](const Row& in) {
                                 dvec4 sum(0.0), size(0.0);
                                 double total = 0.0;
                                 for (size_t k = 0; k < 4; ++k) {
                                     if (!areNumbers(in[k], 4)) continue;
                                     const double weight = in[4][static_cast<int>(k)];
                                     total += weight;
                                     sum += weight * dvec4(in[k]);
                                     size += weight * glm::abs(dvec4(in[k]));
                                 }
                                 if (std::abs(total - 1e-6) < 1e-8) return std::vector{open(4)};
                                 return std::vector{total > 1e-6 ? Right{sum / total, size / total, 4}
                                                                 : right(dvec4(0.0))};
                             }};
            }};
}

std::vector<Row> placesIn(const oracle::Image& image, const Effort& effort, bool broken) {
    Random random(9);
    std::vector<Row> rows =
        functions::randomPlaces({image.width, image.height}, 10, static_cast<int>(effort.of(40000)));
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i].pop_back();
        if (broken && i % 4 == 0) rows[i][0].x = i % 8 == 0 ? notANumber : anyValue(random);
    }
    return rows;
}

// uv times the size is rounded at 20 texels, which moves a place by some 4e-6 of a texel.
constexpr double placeError = 8e-6;

struct Read {
    std::string name;
    bool linear;
    Bound bound;
    std::function<dvec4(const oracle::Image&, dvec2)> oracle;
};

std::vector<Read> cacheReads() {
    return {
        {"sampleNearest",
         false,
         {Unit::absolute, 0.0, "a copy; open beside a border of two texels"},
         oracle::samplePoint},
        {"sampleBilinear",
         false,
         {Unit::absolute, 4.0 * placeError, "the place, to 4e-6 of a texel, and some roundings"},
         oracle::sampleLinear},
        {"sampleBSpline4",
         true,
         {Unit::absolute, 2.0 * filterStep + 4.0 * placeError, "a step of the filter (1/256) on each axis"},
         oracle::sampleBSpline16}};
}

functions::Function reading(const Read& read, const oracle::Image& image) {
    return {read.name,
            {reads},
            "out0 = " + read.name + "(TEXTURE_ARGUMENT(gTexture0), in0.xy, float4(in0.zw, 1.0 / in0.zw));",
            1,
            1,
            {},
            reprise::Stage::compute,
            {{image, read.linear}}};
}

std::vector<Case> readCases() {
    const oracle::Image whole = functions::randomImage(16, 9, 11), broken = functions::brokenImage(16, 9, 12);
    std::vector<Case> all;
    for (const Read& read : cacheReads()) {
        all.push_back({"in and around 16x9, texels 0 to 1", reading(read, whole), read.bound,
                       [whole, read](const Effort& effort) {
                           return Sweep{placesIn(whole, effort, false), [whole, read](const Row& in) {
                                            const dvec2 texel = xy(in[0]) * whole.extent();
                                            const dvec2 off = glm::abs(texel - glm::round(texel));
                                            if (read.name == "sampleNearest" &&
                                                std::min(off.x, off.y) < placeError)
                                                return std::vector{open(4)};
                                            return std::vector{right(read.oracle(whole, xy(in[0])))};
                                        }};
                       }});
        all.push_back({"texels NaN and infinite, places to ±1e30, NaN",
                       reading(read, broken),
                       {Unit::finite, 0.0, "what is no number is left out"},
                       [broken](const Effort& effort) {
                           return Sweep{placesIn(broken, effort, true),
                                        [](const Row&) { return std::vector{open(4)}; }};
                       }});
    }
    return all;
}

std::vector<Case> placeCases() {
    return {{"images of 1 to 16384 pixels",
             {"nearestTexelUv", {reads}, "out0.xy = nearestTexelUv(in0.xy, float4(in0.zw, 1.0 / in0.zw));"},
             {Unit::roundings, 8.0, "a product and a reciprocal below 1; open beside a border of two texels"},
             [](const Effort& effort) {
                 Random random(13);
                 std::vector<Row> rows;
                 for (size_t i = 0; i < effort.of(40000); ++i) {
                     const float size = std::floor(std::exp2(random.in(0.0f, 14.0f)));
                     rows.push_back({vec4(random.unit(), random.unit(), size, size)});
                 }
                 return Sweep{rows, [](const Row& in) {
                                  const dvec2 size(in[0].z, in[0].w), texel = xy(in[0]) * size;
                                  const dvec2 off = glm::abs(texel - glm::round(texel));
                                  if (std::min(off.x, off.y) <= 2.0 * roundoff * size.x)
                                      return std::vector{open(2)};
                                  return std::vector{right((glm::floor(texel) + 0.5) / size, 1.0)};
                              }};
             }},
            {"steps 1e-12 to 1e6 texels",
             {"minificationLevel", {reads}, "out0.x = minificationLevel(in0.xy, in0.zw);"},
             {Unit::absolute, 26.0 * 8.0 * roundoff + 0x1p-20,
              "what Vulkan allows log2, of a level up to 40, halved"},
             [](const Effort& effort) {
                 Random random(14);
                 std::vector<Row> rows;
                 for (float scale : logarithmic(1e-12, 1e6, effort.of(40000)))
                     rows.push_back({scale * random.in4(-1.0f, 1.0f)});
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{
                                      right(oracle::mipLevel(xy(in[0]), dvec2(in[0].z, in[0].w)))};
                              }};
             }},
            {"steps to ±1e30, NaN and infinite",
             {"minificationLevel", {reads}, "out0.x = minificationLevel(in0.xy, in0.zw);"},
             {Unit::finite, 0.0, "a level, whichever"},
             [](const Effort& effort) {
                 return Sweep{numbers(effort), [](const Row&) { return std::vector{open(1)}; }};
             }}};
}

// in0 is (pixel, jitter).
std::vector<Case> subpixelCases() {
    const auto rows = [](const Effort& effort) {
        const auto jitters = ofBothSigns(std::vector{0.0f, 1e-40f, 0.49999997f} +
                                         logarithmic(1e-12, 0.5, effort.quick ? 10 : 50));
        std::vector<Row> all;
        Random random(15);
        for (float x : jitters)
            for (float y : jitters)
                all.push_back({vec4(random.below(16384), random.below(16384), x, y)});
        return all;
    };
    const auto texelOf = [](const Row& in) {
        // A denormal may count as 0, which is on the border.
        return oracle::highResolutionTexel(glm::ivec2(xy(in[0])), dvec2(in[0].z, in[0].w));
    };
    const auto isOpen = [](const Row& in) { return std::min(std::abs(in[0].z), std::abs(in[0].w)) < 1e-38f; };
    const Bound whole{Unit::exact, 0.0, "whole numbers; open for denormal jitters"};
    const std::string sweep = "jitters ±0, 1e-12 to 0.5 px, images to 16384";
    return {{sweep,
             {"subpixelOfJitter", {reads}, "out0.xy = subpixelOfJitter(in0.zw);"},
             whole,
             [=](const Effort& effort) {
                 return Sweep{rows(effort), [=](const Row& in) {
                                  return std::vector{
                                      isOpen(in) ? open(2) : right(dvec2(texelOf(in)) - 2.0 * xy(in[0]))};
                              }};
             }},
            {sweep,
             {"highResolutionTexel", {reads}, "out0.xy = highResolutionTexel(in0.xy, in0.zw);"},
             whole,
             [=](const Effort& effort) {
                 return Sweep{rows(effort), [=](const Row& in) {
                                  return std::vector{isOpen(in) ? open(2) : right(dvec2(texelOf(in)))};
                              }};
             }},
            {sweep,
             {"isFreshTexel",
              {reads},
              "float2 texel = highResolutionTexel(in0.xy, in0.zw);\n"
              "out0.xy = float2(isFreshTexel(texel + 0.5, in0.zw), isFreshTexel(texel + float2(1.5, 0.5), "
              "in0.zw));"},
             whole,
             [=](const Effort& effort) {
                 return Sweep{rows(effort), [=](const Row&) { return std::vector{right(dvec2(1.0, 0.0))}; }};
             }}};
}

} // namespace

std::vector<Case> cacheCases() {
    std::vector<Case> all = numberCases();
    all.push_back(centres(false));
    all.push_back(centres(true));
    all.push_back(fromClip());
    all.push_back(fromDepth("standard", standardDepth()));
    all.push_back(fromDepth("reversed infinite", infiniteDepth()));
    all.push_back(fromDepth("orthographic", parallelDepth()));
    all.push_back(fromMotion());
    for (const auto& more :
         {weights(), std::vector{blends(), meanOf()}, readCases(), placeCases(), subpixelCases()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
