// SPDX-License-Identifier: Apache-2.0
// conventions.hlsli, coordinates.hlsli and half_pixel.hlsli.
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;

const std::string conventions = "reprise/conventions.hlsli", coordinates = "reprise/coordinates.hlsli",
                  halfPixel = "reprise/half_pixel.hlsli";

glm::dmat4 matrixOf(const Row& in) {
    return {dvec4(in[0]), dvec4(in[1]), dvec4(in[2]), dvec4(in[3])};
}

// Of the size that projections and positions have: 1e-11 to 1e11.
std::vector<Row> matricesAndVectors(const Effort& effort) {
    Random random(1);
    const auto value = [&] {
        const float size = random.below(4) == 0 ? 0.0f : std::exp2(random.in(-36.5f, 36.5f));
        return random.below(2) == 0 ? size : -size;
    };
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(100000); ++i) {
        Row row;
        for (int k = 0; k < 5; ++k)
            row.push_back({value(), value(), value(), value()});
        rows.push_back(row);
    }
    return rows;
}

Case transforming(bool rowAfterRow) {
    return {rowAfterRow ? "matrices 1e-11 to 1e11, row after row" : "matrices 1e-11 to 1e11",
            {"transform",
             {conventions},
             "out0 = transform(float4x4(in0, in1, in2, in3), in4);",
             5,
             1,
             Defines{{"MATRIX_ROW_VECTORS", rowAfterRow}}},
            {Unit::roundings, 5.0, "four products and three sums at the sum of the absolute products"},
            [rowAfterRow](const Effort& effort) {
                return Sweep{matricesAndVectors(effort), [rowAfterRow](const Row& in) {
                                 const glm::dmat4 m =
                                     rowAfterRow ? glm::transpose(matrixOf(in)) : matrixOf(in);
                                 const dvec4 v(in[4]);
                                 dvec4 size(0.0);
                                 for (int c = 0; c < 4; ++c)
                                     size += glm::abs(m[c] * v[c]);
                                 return std::vector{Right{m * v, size, 4}};
                             }};
            }};
}

std::vector<Row> places(const Effort& effort, uint32_t seed) {
    const std::vector<float> values = ofBothSigns({0.0f, 1e-40f, 0.25f, 0.5f, 0.99999994f, 1.0f, 1e30f}) +
                                      ofBothSigns(logarithmic(1e-9, 1e9, effort.quick ? 20 : 100));
    std::vector<Row> rows;
    for (float x : values)
        for (float y : values)
            rows.push_back({vec4(x, y, 0, 0)});
    Random random(seed);
    for (size_t i = 0; i < effort.of(40000); ++i)
        rows.push_back({random.in4(-2.0f, 2.0f)});
    return rows;
}

double sizeOf(dvec2 value) {
    return std::max({std::abs(value.x), std::abs(value.y), 1.0});
}

Case toUv(bool shared) {
    return {shared ? "to ±1e30, y shared" : "to ±1e30",
            {"ndcToUv",
             {coordinates},
             "out0.xy = ndcToUv(in0.xy);",
             1,
             1,
             Defines{{"NDC_AND_UV_SHARE_Y", shared}}},
            {Unit::roundings, 2.0, "a sum at the larger of the result and 1, and one of slack"},
            [shared](const Effort& effort) {
                return Sweep{places(effort, 2), [shared](const Row& in) {
                                 const dvec2 uv = oracle::ndcToUv(xy(in[0]), shared);
                                 return std::vector{right(uv, sizeOf(uv))};
                             }};
            }};
}

Case toNdc(bool shared) {
    return {shared ? "to ±1e30, y shared" : "to ±1e30",
            {"uvToNdc",
             {coordinates},
             "out0.xy = uvToNdc(in0.xy);",
             1,
             1,
             Defines{{"NDC_AND_UV_SHARE_Y", shared}}},
            {Unit::roundings, 7.0, "a difference and a division, at the larger of the result and 1"},
            [shared](const Effort& effort) {
                return Sweep{places(effort, 3), [shared](const Row& in) {
                                 const dvec2 ndc = oracle::uvToNdc(xy(in[0]), shared);
                                 return std::vector{right(ndc, sizeOf(ndc))};
                             }};
            }};
}

std::vector<Row> pixels(const Effort& effort, bool inverse) {
    Random random(4);
    std::vector<Row> rows;
    for (const float width : {1.0f, 2.0f, 7.0f, 641.0f, 1920.0f, 3840.0f, 16384.0f})
        for (size_t i = 0; i < effort.of(10000); ++i) {
            const float x = i % 4 == 0 ? anyValue(random) : random.in(-0.5f, 1.5f);
            rows.push_back({inverse
                                ? vec4(x * std::min(width, 1e7f), random.unit() * width, 1 / width, 1 / width)
                                : vec4(x, random.in(-0.5f, 1.5f), width, width)});
        }
    return rows;
}

std::vector<Right> productOracle(const Row& in) {
    const dvec2 value = xy(in[0]) * dvec2(in[0].z, in[0].w);
    return {{dvec4(value, 0.0, 0.0), dvec4(glm::abs(value), 0.0, 0.0), 2}};
}

std::vector<Right> insideOracle(const Row& in) {
    return {right(oracle::isInsideUv(xy(in[0])) ? 1.0 : 0.0)};
}

std::vector<Row> edges(const Effort& effort) {
    std::vector<float> values = {infinity, -infinity, notANumber};
    for (float edge : {0.0f, 1.0f})
        for (float distance : ofBothSigns(logarithmic(1e-9, 10.0, effort.quick ? 40 : 120)))
            values.push_back(edge + distance);
    std::vector<Row> rows;
    for (float x : values)
        for (float y : values)
            rows.push_back({vec4(x, y, 0, 0)});
    return rows;
}

// In Direct3D 9 half a pixel of 2 / extent to the left and up, times w; elsewhere nothing.
Case offsets(bool direct3d9) {
    return {
        direct3d9 ? "clip positions 1e-11 to 1e11, targets to 16384, Direct3D 9"
                  : "clip positions 1e-11 to 1e11, targets to 16384",
        {"halfPixelOffset",
         {halfPixel},
         "out0 = halfPixelOffset(in0, in1.xy);",
         5,
         1,
         Defines{{"PLATFORM_D3D9", direct3d9}}},
        {Unit::roundings, direct3d9 ? 2.0 : 0.0, "a product and a sum at the sum of both; elsewhere a copy"},
        [direct3d9](const Effort& effort) {
            std::vector<Row> rows = matricesAndVectors(effort);
            Random random(2);
            for (Row& row : rows)
                row[1] = 1.0f / (1.0f + vec4(random.below(16384), random.below(16384), 0, 0));
            return Sweep{rows, [direct3d9](const Row& in) {
                             const dvec4 clip(in[0]);
                             const dvec2 texel(in[1].x, in[1].y);
                             dvec4 moved = clip, size = glm::abs(clip);
                             if (direct3d9) {
                                 moved += dvec4(-texel.x * clip.w, texel.y * clip.w, 0.0, 0.0);
                                 size += dvec4(texel * std::abs(clip.w), 0.0, 0.0);
                             }
                             return std::vector{Right{moved, size, 4}};
                         }};
        }};
}

} // namespace

std::vector<Case> coordinateCases() {
    return {offsets(false),
            offsets(true),
            transforming(false),
            transforming(true),
            toUv(false),
            toUv(true),
            toNdc(false),
            toNdc(true),
            {"images of 1 to 16384 pixels, to ±1e30",
             {"uvToPx", {coordinates}, "out0.xy = uvToPx(in0.xy, in0.zw);"},
             {Unit::roundings, 1.0, "a product"},
             [](const Effort& effort) {
                 return Sweep{pixels(effort, false), productOracle};
             }},
            {"images of 1 to 16384 pixels, to ±1e30",
             {"pxToUv", {coordinates}, "out0.xy = pxToUv(in0.xy, in0.zw);"},
             {Unit::roundings, 1.0, "a product"},
             [](const Effort& effort) {
                 return Sweep{pixels(effort, true), productOracle};
             }},
            {"1e-9 to 10 beside the edges, NaN, infinity",
             {"isInsideUv", {coordinates}, "out0.x = isInsideUv(in0.xy) ? 1.0 : 0.0;"},
             {Unit::exact, 0.0, "a decision"},
             [](const Effort& effort) {
                 return Sweep{edges(effort), insideOracle};
             }}};
}

} // namespace check
