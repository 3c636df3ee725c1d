// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::Projection;

const std::string header = "reprise/reprojection.hlsli";

// --- clip coordinates

// Whether a place may come out on either side of the limit of eight images; y may run either way.
bool isAtLimit(dvec2 ndc, double bound) {
    for (const double extent : {std::abs(ndc.x), std::abs(ndc.y)})
        for (const double shift : {-0.5, 0.5})
            if (std::abs(0.5 * extent + shift - 8.0) <= bound) return true;
    return false;
}

constexpr double clipRoundings = 8.0;

// Three roundings and a reciprocal at the size of NDC or of 1. Denormals may be taken for 0, which matters
// where they are divided by each other.
Right clipRight(dvec4 clip, bool sharesY) {
    const bool denormal =
        (clip.w != 0.0 && std::abs(clip.w) < smallestNormal) ||
        (std::abs(clip.w) < 1e-25 && glm::any(glm::lessThan(glm::abs(dvec2(clip)), dvec2(1e-37))));
    if (denormal) return open(2);
    const dvec2 uv = oracle::clipToUv(clip, sharesY);
    if (!(clip.w > 0.0)) return right(uv);
    const dvec2 ndc = dvec2(clip) / clip.w;
    const double size = 1.0 + std::max(std::abs(ndc.x), std::abs(ndc.y));
    return isAtLimit(ndc, clipRoundings * roundoff * std::min(size, 32.0)) ? open(2) : right(uv, size);
}

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

struct Cameras {
    Projection projection;
    oracle::Camera current, previous;
};

glm::dmat4 randomView(Random& random, double angle, double distance) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(random.in(-1, 1), 2.0, random.in(-1, 1)));
    const glm::dvec3 move(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    return glm::rotate(glm::dmat4(1.0), angle * random.in(-1, 1), axis) *
           glm::translate(glm::dmat4(1.0), distance * move);
}

// Between the frames the camera stands still, turns and moves a little, zooms, or is cut to elsewhere, the
// place behind it included. Worlds away from the origin are moved there: views hold no more than 100 m.
Cameras randomCameras(Random& random, const Projection& projection) {
    const size_t kind = random.below(4);
    Cameras made{projection, {randomView(random, 3.0, 100.0), projection.matrix}, {}};
    made.previous = made.current;
    if (kind > 0)
        made.previous.worldToView =
            randomView(random, kind == 3 ? 3.0 : 0.05, kind == 3 ? 20.0 : 0.3) * made.current.worldToView;
    if (kind == 2) {
        made.previous.viewToClip[0][0] *= 1.1;
        made.previous.viewToClip[1][1] *= 1.1;
    }
    return made;
}

glm::dmat4 matrixOf(const Row& in) {
    return {dvec4(in[0]), dvec4(in[1]), dvec4(in[2]), dvec4(in[3])};
}

constexpr double matrixRoundings = 12.0;

// The matrix is stored in binary32 and multiplied there: each component of the clip position errs by some ten
// roundings at the sum of its absolute products; `sizes` are what the point's coordinates were rounded at.
// Divided by w, that is what uv errs by. Where w is not clear of its own error, any place is right.
Right nearClip(const glm::dmat4& m, dvec4 point, dvec4 sizes, dvec2 uv) {
    dvec4 sums(0.0);
    for (int c = 0; c < 4; ++c)
        sums += glm::abs(m[c] * sizes[c]);
    const dvec4 clip = m * point, error = matrixRoundings * roundoff * sums;
    if (std::abs(clip.w) <= 2.0 * error.w) return open(2);
    if (clip.w < 0.0) return right(uv);
    const double ndc = std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w;
    const double bound = (std::max(error.x, error.y) + ndc * error.w) / (clip.w - error.w) +
                         (divisionError + 4.0 * roundoff) * (1.0 + ndc);
    if (isAtLimit(dvec2(clip) / clip.w, bound)) return open(2);
    return right(uv, bound / (matrixRoundings * roundoff));
}

void push(Row& row, const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        row.push_back(vec4(m[column]));
}

struct Reprojections {
    std::vector<Cameras> cameras;
    std::vector<Row> rows; // matrix, (uv, depth, number of the cameras), view rays if the depth is linear
};

dvec4 viewRays(const Projection& projection) {
    const auto ray = [&](dvec2 uv) {
        return dvec2(oracle::viewPoint(oracle::uvToNdc(uv), 1.0, projection.matrix));
    };
    return {ray({1, 1}) - ray({0, 0}), ray({0, 0})};
}

std::shared_ptr<Reprojections> reprojections(const std::vector<Projection>& projections, const Effort& effort,
                                             bool device) {
    auto made = std::make_shared<Reprojections>();
    Random random(3);
    const std::vector<float> oddDepths{0.0f, 1.0f, 1e-40f, 1e-30f, 0.99999994f};
    for (size_t i = 0; i < effort.of(4000); ++i) {
        const Projection& projection = projections[i % projections.size()];
        const Cameras cameras = randomCameras(random, projection);
        Row start;
        glm::dmat4 m = cameras.previous.viewToClip * cameras.previous.worldToView *
                       glm::inverse(cameras.current.worldToView);
        push(start, device ? m * glm::inverse(cameras.current.viewToClip) : m);
        const std::vector<double> depths = depthsOf(projection, 25);
        for (size_t k = 0; k < depths.size(); ++k) {
            Row row = start;
            float depth =
                static_cast<float>(device ? oracle::deviceDepth(depths[k], projection.matrix) : depths[k]);
            if (device && k % 5 == 0) depth = oddDepths[k / 5];
            row.push_back(vec4(random.unit(), random.unit(), depth, made->cameras.size()));
            if (!device) row.push_back(vec4(viewRays(projection)));
            made->rows.push_back(row);
        }
        made->cameras.push_back(cameras);
    }
    return made;
}

Right deviceRight(const Row& in, const Cameras& cameras) {
    const dvec2 uv = oracle::reprojectDeviceDepth(xy(in[4]), in[4].z, cameras.current, cameras.previous);
    const dvec4 point(oracle::uvToNdc(xy(in[4])), in[4].z, 1.0);
    // uv - 1/2 is rounded at 1/2, so NDC at 1.
    return nearClip(matrixOf(in), point, glm::max(glm::abs(point), dvec4(1, 1, 0, 1)), uv);
}

Right linearRight(const Row& in, const Cameras& cameras) {
    const dvec2 uv = oracle::reprojectLinearDepth(xy(in[4]), in[4].z, cameras.current, cameras.previous);
    const dvec4 point = oracle::viewPoint(oracle::uvToNdc(xy(in[4])), in[4].z, cameras.projection.matrix);
    // The ray is rounded at the size of its extent and its origin, not at its own.
    const dvec4 rays = glm::abs(viewRays(cameras.projection));
    const double scale = cameras.projection.orthographic ? 1.0 : point.z;
    return nearClip(matrixOf(in), point,
                    dvec4(scale * (rays.x + rays.z), scale * (rays.y + rays.w), point.z, 1.0), uv);
}

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
                             const Cameras& cameras = made->cameras[static_cast<size_t>(in[4].w)];
                             return std::vector{device ? deviceRight(in, cameras) : linearRight(in, cameras)};
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
