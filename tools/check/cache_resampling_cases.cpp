// SPDX-License-Identifier: Apache-2.0
// cache_resampling.hlsli and finite.hlsli.
#include "cases.hpp"
#include "images.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using functions::filterStep;

const std::string reads = "reprise/cache_resampling.hlsli", finite = "reprise/finite.hlsli";

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

std::vector<Case> cacheResamplingCases() {
    std::vector<Case> all = numberCases();
    for (const auto& more : {std::vector{meanOf()}, readCases(), placeCases(), subpixelCases()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
