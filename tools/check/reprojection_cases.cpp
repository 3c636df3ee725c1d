// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "reprojections.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::Projection;

const std::string header = "reprise/reprojection.hlsli";

// --- clip coordinates

std::vector<Row> clipPositions(const Effort& effort) {
    const std::vector<float> ws = ofBothSigns(std::vector{0.0f, 1e-40f, 1.17549435e-38f, 1e-30f, 1e30f} +
                                              logarithmic(1e-11, 1e7, effort.quick ? 10 : 40));
    const std::vector<float> ratios =
        ofBothSigns({0.0f, 1e-30f, 1e-7f, 0.5f, 0.99999994f, 1.0f, 14.9f, 15.1f, 16.9f, 17.1f, 1e3f, 1e11f});
    std::vector<Row> rows;
    for (float w : ws)
        for (float x : ratios)
            for (float y : ratios) {
                const vec4 clip(x * std::abs(w), y * std::abs(w), 0.5f * w, w);
                if (std::isfinite(clip.x) && std::isfinite(clip.y)) rows.push_back({clip});
                rows.push_back({vec4(x, y, 0.5f, w)});
            }
    Random random(1);
    for (size_t i = 0; i < effort.of(50000); ++i)
        rows.push_back({vec4(anyValue(random), anyValue(random), anyValue(random), anyValue(random))});
    return rows;
}

// In the slide y runs up in UV too.
const std::string slideDivision = "out0.xy = 0.5 * (in0.xy / in0.w) + 0.5;";

Case clipping(bool sharesY) {
    Case made{
        sharesY ? "w through 0 and negative, to ±1e30, y shared" : "w through 0 and negative, to ±1e30",
        {"clipToUv", {header}, "out0.xy = clipToUv(in0);", 1, 1, Defines{{"NDC_AND_UV_SHARE_Y", sharesY}}},
        {Unit::roundings, clipRoundings, "a reciprocal, two products and a sum at the size of NDC or 1"},
        [sharesY](const Effort& effort) {
            return Sweep{clipPositions(effort),
                         [sharesY](const Row& in) { return std::vector{clipRight(dvec4(in[0]), sharesY)}; }};
        }};
    if (sharesY) made.printed = {"INSIDE, q_uv of static scenes", slideDivision, ""};
    return made;
}

Case brokenClipping() {
    return {"NaN and infinity",
            {"clipToUv", {header}, "out0.xy = clipToUv(in0);"},
            {Unit::exact, 0.0, "behind the camera; open where w is infinite"},
            [](const Effort&) {
                const float values[] = {0.0f, -1.0f, 0.5f, 1e30f, infinity, -infinity, notANumber};
                std::vector<Row> rows;
                for (Row& row : triples(values))
                    for (float broken : {infinity, -infinity, notANumber})
                        rows.push_back({vec4(row[0].x, broken, 0.0f, row[0].y)});
                return Sweep{rows, [](const Row& in) {
                                 const bool open2 = std::isinf(in[0].w) && in[0].w > 0.0f;
                                 return std::vector{open2 ? open(2) : right(oracle::behindCameraUv)};
                             }};
            }};
}

std::vector<Right> motionOracle(const Row& in) {
    const dvec4 current(in[0]), previous(in[1]);
    const Right a = clipRight(current, false), b = clipRight(previous, false);
    return {{dvec4(oracle::motionFromClip(current, previous), 0.0, 0.0), a.size + b.size, 2}};
}

// Between the frames a point moves by nothing, by less than a step, by up to a million pixels of 3840.
std::vector<Row> movedPoints(const Effort& effort) {
    const auto motions = ofBothSigns(std::vector{0.0f} + logarithmic(1e-12, 520.0, effort.quick ? 20 : 60));
    Random random(2);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(500); ++i)
        for (float motion : motions) {
            vec4 current = random.in4(-1.5f, 1.5f), previous(0.0f);
            current.w = std::exp2(random.in(-13.0f, 23.0f));
            current.x *= current.w;
            current.y *= current.w;
            previous = current + vec4(motion * current.w, 0.5f * motion * current.w, 0.0f, 0.0f);
            if (i % 10 == 0) previous.w = -current.w;
            rows.push_back({current, previous});
        }
    return rows;
}

std::vector<Case> motions() {
    const functions::Function motion{"motionFromClip", {header}, "out0.xy = motionFromClip(in0, in1);", 2};
    return {{"motion from 1e-12 to 1e6 pixels, w < 0 too",
             motion,
             {Unit::roundings, clipRoundings + 1.0, "both places and their difference"},
             [](const Effort& effort) {
                 return Sweep{movedPoints(effort), motionOracle};
             }},
            {"no motion", motion, {Unit::exact, 0.0, "equal places"}, [](const Effort& effort) {
                 std::vector<Row> rows = clipPositions(effort);
                 for (Row& row : rows)
                     row.push_back(row.front());
                 return Sweep{rows, [](const Row&) { return std::vector{right(dvec2(0.0))}; }};
             }}};
}

// --- whole reprojections

const std::string byDevice = "out0.xy = reprojectDeviceDepth(in4.xy, in4.z, float4x4(in0, in1, in2, in3));";
const std::string byLinear =
    "out0.xy = reprojectLinearDepth(in4.xy, in4.z, in5, float4x4(in0, in1, in2, in3));";

std::vector<Case> ofKind(const std::string& kind, const std::vector<Projection>& projections) {
    const Defines defines{{"ORTHOGRAPHIC", projections.front().orthographic}};
    const Bound bound{
        Unit::roundings, matrixRoundings,
        "a matrix of binary32 and its product at the sums of the absolute products, over w; open where "
        "w is not clear of that"};
    const auto make = [=](bool device) {
        return [=](const Effort& effort) {
            const auto made = reprojections(projections, effort, device);
            return Sweep{made->rows, [made, device](const Row& in) {
                             const MovedCamera& camera = made->cameras[static_cast<size_t>(in[4].w)];
                             return std::vector{device ? placeFromDevice(in, camera)
                                                       : placeFromLinear(in, camera)};
                         }};
        };
    };
    return {{kind + ", 1e-4 to 1e7 m, cuts too",
             {"reprojectDeviceDepth", {header}, byDevice, 5, 1, defines},
             bound,
             make(true)},
            {kind + ", 1e-4 to 1e7 m, cuts too",
             {"reprojectLinearDepth", {header}, byLinear, 6, 1, defines},
             bound,
             make(false)}};
}

// Depths that no surface has, NaN among them, seen by cameras that moved.
Case brokenDepth(bool device) {
    return {device ? "depth NaN, infinite, outside of [0, 1]" : "depth NaN, infinite, 0, negative, 1e30",
            {device ? "reprojectDeviceDepth" : "reprojectLinearDepth",
             {header},
             device ? byDevice : byLinear,
             device ? 5 : 6},
            {Unit::finite, 0.0, "a place or behind the camera, none of them NaN"},
            [device](const Effort& effort) {
                const auto made = reprojections(infiniteDepth(), effort, device);
                const float values[] = {notANumber, infinity, -infinity, 0.0f,  -0.0f,
                                        1e30f,      -1e30f,   -1.0f,     1e-40f};
                for (size_t i = 0; i < made->rows.size(); ++i)
                    made->rows[i][4].z = values[i % std::size(values)];
                return Sweep{made->rows, [](const Row&) { return std::vector{open(2)}; }};
            }};
}

// --- positions

Case position(bool orthographic) {
    return {orthographic ? "orthographic, depth 1e-4 to 1e7 m" : "perspective, depth 0, 1e-4 to 1e7 m, 1e30",
            {"viewPosition",
             {header},
             "out0.xyz = viewPosition(in0.xy, in0.z, in1);",
             2,
             1,
             Defines{{"ORTHOGRAPHIC", orthographic}}},
            {Unit::roundings, 3.0, "two products and a sum at the extent of the rays and their origin"},
            [orthographic](const Effort& effort) {
                const auto depths =
                    std::vector{0.0f, 1e-30f, 1e30f} + logarithmic(1e-4, 1e7, effort.quick ? 100 : 1000);
                Random random(4);
                std::vector<Row> rows;
                for (float depth : depths)
                    for (int i = 0; i < 50; ++i) {
                        const float extent = std::exp2(random.in(-7.0f, 7.0f));
                        rows.push_back(
                            {vec4(random.in(-0.5f, 1.5f), random.unit(), depth, 0.0f),
                             vec4(extent, -extent, -0.5f * extent, random.in(-1.0f, 1.0f) * extent)});
                    }
                return Sweep{rows, [orthographic](const Row& in) {
                                 const dvec2 uv = xy(in[0]), extent = xy(in[1]), origin(in[1].z, in[1].w);
                                 const double scale = orthographic ? 1.0 : in[0].z;
                                 const dvec2 size = (glm::abs(uv * extent) + glm::abs(origin)) * scale;
                                 return std::vector{
                                     right(dvec3((uv * extent + origin) * scale, in[0].z), dvec3(size, 0.0))};
                             }};
            }};
}

} // namespace

std::vector<Case> reprojectionCases() {
    std::vector<Case> all{clipping(false), clipping(true), brokenClipping()};
    for (const auto& more :
         {ofKind("standard", standardDepth()), ofKind("reversed", reversedDepth()),
          ofKind("reversed infinite", infiniteDepth()), ofKind("orthographic", parallelDepth()), motions()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(brokenDepth(true));
    all.push_back(brokenDepth(false));
    all.push_back(position(false));
    all.push_back(position(true));
    return all;
}

} // namespace check
