// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "reprojections.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::Projection;

const std::string cache = "reprise/reprojection_cache.hlsli";

// --- places

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

std::vector<Case> weighing() {
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
    const std::vector<float> shares = weights() + std::vector{-1.0f, 2.0f};
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

} // namespace

std::vector<Case> reprojectionCacheCases() {
    std::vector<Case> all{fromClip()};
    all.push_back(fromDepth("standard", standardDepth()));
    all.push_back(fromDepth("reversed infinite", infiniteDepth()));
    all.push_back(fromDepth("orthographic", parallelDepth()));
    all.push_back(fromMotion());
    for (Case& each : weighing())
        all.push_back(std::move(each));
    all.push_back(blends());
    return all;
}

} // namespace check
