// SPDX-License-Identifier: Apache-2.0
#include "cameras.hpp"
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"
#include "printed_forms.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/reprojection_cache.hlsli";

// --- Place

// in0 to in3 the matrix, in4 (uv, depth, row), in5 the view rays, in6 clipToDepth.
struct Places {
    std::vector<CameraPair> cameras;
    std::vector<Row> rows;
};

dvec2 clipToDepth(const Projection& projection) {
    return projection.orthographic ? linearDepthCoefficients(projection) : dvec2(0.0, 1.0);
}

Places placeRows(const Convention& convention) {
    Random random(1);
    Places made;
    for (int i = 0; i < 400; ++i) {
        const CameraPair pair = randomCameras(random, convention.projection);
        made.cameras.push_back(pair);
        Row row;
        push(row,
             pair.previous.viewToClip * pair.previous.worldToView * glm::inverse(pair.current.worldToView));
        row.push_back(vec4(random.unit(), random.unit(), randomDepth(random, convention.projection), i));
        row.push_back(vec4(viewRays(convention)));
        row.push_back(vec4(clipToDepth(convention.projection), 0, 0));
        made.rows.push_back(row);
    }
    return made;
}

Comparison placesByDepth(const Convention& convention) {
    const Places made = placeRows(convention);
    return {{"cachePlaceFromDepth",
             {header},
             "CachePlace p = cachePlaceFromDepth(in4.xy, in4.z, in5, float4x4(in0, in1, in2, in3), in6.xy);\n"
             "out0.xy = p.prevUv; out1.x = p.lastDepth;",
             7,
             2,
             convention.defines()},
            made.rows,
            [made, convention](const Row& in) {
                const CameraPair& pair = made.cameras[static_cast<size_t>(in[4].w)];
                const dvec2 uv = oracle::reprojectLinearDepth(xy(in[4]), in[4].z, pair.current, pair.previous,
                                                              convention.sharesY);
                const double depth = oracle::previousLinearDepth(xy(in[4]), in[4].z, pair.current,
                                                                 pair.previous, convention.sharesY);
                const bool flat = convention.projection.orthographic;
                const dvec4 point = oracle::viewPoint(oracle::uvToNdc(xy(in[4]), convention.sharesY), in[4].z,
                                                      convention.projection.matrix);
                const dvec4 rays = glm::abs(viewRays(convention));
                const double scale = flat ? 1.0 : in[4].z;
                const dvec4 sizes(scale * (rays.x + rays.z), scale * (rays.y + rays.w), point.z, 1.0);
                // As nearClip(): ten roundings at the size of the products; then the two of clipToDepth.
                dvec4 sums(0.0);
                for (int c = 0; c < 4; ++c)
                    sums += glm::abs(matrixOf(in)[c] * sizes[c]);
                const dvec2 toDepth = glm::abs(clipToDepth(convention.projection));
                const double bound = 16.0 * roundoff * (sums.z * toDepth.x + sums.w * toDepth.y);
                return std::vector{nearClip(matrixOf(in), point, sizes, uv), near(depth, bound)};
            }};
}

TEST(ReprojectionCache, placeAndDepthAgreeForEveryDepthKindAndYDirection) {
    for (const Convention& convention : conventions()) {
        SCOPED_TRACE(convention.projection.name + (convention.sharesY ? ", shared y" : ""));
        expectAgrees(placesByDepth(convention));
    }
}

TEST(ReprojectionCache, wrongPlacesAreCaught) {
    const Comparison perspective = placesByDepth(conventions()[0]);
    const Comparison orthographic = placesByDepth(conventions()[10]);
    ASSERT_TRUE(conventions()[10].projection.orthographic);
    // Depth of the current view for that of the previous one.
    expectCaught(perspective, {header, "numberOrZero(dot(prevPositionCS.zw, clipToDepth))",
                               "numberOrZero(prevPositionCS.z)"});
    expectCaught(orthographic, {header, "numberOrZero(dot(prevPositionCS.zw, clipToDepth))",
                                "numberOrZero(prevPositionCS.w)"});
}

Comparison placesByMotion() {
    Random random(2);
    std::vector<Row> rows;
    const float hostile[] = {0.0f, 1e-9f, 1.0f, -1.0f, 1e6f, -1e30f, 3.4e38f, infinity, notANumber};
    for (int i = 0; i < 1000; ++i) {
        const bool plain = i % 2 == 0;
        rows.push_back(
            {vec4(random.unit(), random.unit(), plain ? random.in(-0.2f, 0.2f) : random.of(hostile),
                  plain ? random.in(-0.2f, 0.2f) : random.of(hostile)),
             vec4(plain ? random.in(0.1f, 100.0f) : random.of(hostile))});
    }
    return {{"cachePlaceFromMotion",
             {header},
             "CachePlace p = cachePlaceFromMotion(in0.xy, in0.zw, in1.x); out0.xyz = float3(p.prevUv, "
             "p.lastDepth);",
             2},
            rows,
            [](const Row& in) {
                const dvec2 uv = xy(in[0]) - dvec2(in[0].z, in[0].w);
                const bool known = std::abs(uv.x) <= 8.0 && std::abs(uv.y) <= 8.0;
                const double depth = std::abs(in[1].x) <= 1e38f ? in[1].x : 0.0;
                // One difference, of numbers below 2.
                return std::vector{near(dvec3(known ? uv : oracle::behindCameraUv, depth),
                                        dvec3(2.0 * roundoff, 2.0 * roundoff, 0.0))};
            }};
}

TEST(ReprojectionCache, motionLeadsToThePreviousPlace) {
    expectAgrees(placesByMotion());
}

TEST(ReprojectionCache, motionOfTheOtherSignOrWithoutItsLimitIsCaught) {
    expectCaught(placesByMotion(), {header, "uv - motion", "uv + motion"});
    expectCaught(placesByMotion(), {header, "all(abs(prevUv) <= 8.0) ? prevUv : BEHIND_CAMERA_UV", "prevUv"});
}

TEST(ReprojectionCache, clipPositionsOfAnyKindGiveNumbers) {
    Random random(3);
    std::vector<float> values(std::begin(hostileFinite), std::end(hostileFinite));
    values.insert(values.end(), {3.4e38f, -3.4e38f, notANumber, infinity});
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.of(values), random.of(values), random.of(values), random.of(values)),
                        vec4(random.of(values), random.of(values), 0, 0)});
    expectAgrees(
        {{"cachePlaceFromClip",
          {header},
          "CachePlace p = cachePlaceFromClip(in0, in1.xy); out0 = float4(p.prevUv, p.lastDepth, 0.0);",
          2},
         rows,
         [](const Row&) { return std::vector{finite()}; }});
}

// --- Weight

// in0 is (uv, last depth, cache depth), in1 (threshold, convergence).
std::vector<Row> weightRows() {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 3000; ++i) {
        const float last = random.in(0.1f, 50.0f), threshold = random.of(std::vector{0.01f, 0.1f, 1.0f});
        const float cache = last + threshold * random.in(-2.0f, 2.0f);
        rows.push_back({vec4(random.in(-0.1f, 1.1f), random.in(-0.1f, 1.1f), last, i % 9 == 0 ? last : cache),
                        vec4(threshold, random.of(std::vector{0.5f, 0.9f, 1.0f, 20.0f}) / threshold, 0, 0)});
    }
    const float hostile[] = {0.0f, 1.0f, -1.0f, 1e30f, 3.4e38f, -3.4e38f, infinity, -infinity, notANumber};
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.of(std::vector{0.0f, 0.5f, 1.0f, -8.0f, notANumber}), 0.5f,
                             random.of(hostile), random.of(hostile)),
                        vec4(random.of(hostile), random.of(hostile), 0, 0)});
    return rows;
}

Comparison weights() {
    return {{"cacheHistoryWeight",
             {header},
             "CachePlace p; p.prevUv = in0.xy; p.lastDepth = in0.z;\n"
             "out0 = cacheHistoryWeight(p, in0.w, in1.x, in1.y);",
             2},
            weightRows(),
            [](const Row& in) {
                const double threshold = in[1].x, convergence = in[1].y;
                const double difference = std::abs(static_cast<double>(in[0].z) - in[0].w);
                const double sizes = difference + std::abs(threshold);
                const double error = 2.0 * roundoff * sizes * convergence + 4.0 * roundoff;
                // Infinite and NaN: what must hold is that the weight is one.
                if (!(sizes < 1e30) || !(std::abs(convergence) < 1e30)) {
                    Expected some;
                    some.value = dvec4(0.5);
                    some.bound = dvec4(0.5);
                    return std::vector{some};
                }
                // uv within a rounding of the border may count as inside: |uv - 1/2| is rounded.
                const dvec2 border = glm::abs(xy(in[0]) - 0.5) - 0.5;
                if (std::abs(border.x) < 1e-7 || std::abs(border.y) < 1e-7) {
                    const double inside =
                        oracle::cacheHistoryWeight(dvec2(0.5), in[0].z, in[0].w, threshold, convergence);
                    if (border.x <= 0.0 && border.y <= 0.0) return std::vector{near(inside, error)};
                }
                return std::vector{near(
                    oracle::cacheHistoryWeight(xy(in[0]), in[0].z, in[0].w, threshold, convergence), error)};
            }};
}

TEST(ReprojectionCache, historyWeighsNothingBeyondTheThresholdAndOutOfBounds) {
    expectAgrees(weights());
}

// Of four texels what it is of each.
TEST(ReprojectionCache, fourHistoriesWeighAsEachAlone) {
    const Comparison four{{"cacheHistoryWeight of four",
                           {header},
                           "CachePlace p; p.prevUv = in0.xy; p.lastDepth = in0.z;\n"
                           "float4 depths = in0.w + float4(0.0, 0.02, -0.5, in0.w);\n"
                           "float4 each = float4(cacheHistoryWeight(p, depths.x, in1.x, in1.y),\n"
                           "                     cacheHistoryWeight(p, depths.y, in1.x, in1.y),\n"
                           "                     cacheHistoryWeight(p, depths.z, in1.x, in1.y),\n"
                           "                     cacheHistoryWeight(p, depths.w, in1.x, in1.y));\n"
                           "out0 = cacheHistoryWeight(p, depths, in1.x, in1.y) - each;",
                           2},
                          weightRows(),
                          [](const Row&) { return std::vector{near(dvec4(0.0), 0.0)}; }};
    expectAgrees(four);
    expectCaught(four, {header, "float4 room = missThreshold - abs(place.lastDepth - cacheDepths);",
                        "float4 room = missThreshold - abs(place.lastDepth - cacheDepths.x);"});
}

TEST(ReprojectionCache, thePrintedSignOfMissRateIsCaught) {
    expectCaught(weights(), {header, "missThreshold - abs(place.lastDepth - cacheDepth)",
                             "abs(place.lastDepth - cacheDepth) - missThreshold"});
}

TEST(ReprojectionCache, wrongWeightsAreCaught) {
    expectCaught(weights(), {header, "abs(place.lastDepth - cacheDepth)", "(place.lastDepth - cacheDepth)"});
    expectCaught(weights(), {header, "missRate > 0.0 && isInsideUv(place.prevUv)", "missRate > 0.0"});
    expectCaught(weights(), {header, "room > 0.0 ? room * convergenceTime : 0.0", "room * convergenceTime"});
}

// --- Blend

// in0 fresh, in1 history, in2.x weight.
std::vector<Row> blendRows() {
    Random random(5);
    std::vector<Row> rows;
    const float broken[] = {notANumber, infinity, -infinity, 3e38f};
    for (int i = 0; i < 3000; ++i) {
        Row row = {random.in4(-2.0f, 10.0f), random.in4(-2.0f, 10.0f),
                   vec4(random.of(std::vector{0.0f, 0.25f, 0.9f, 1.0f}))};
        if (i % 3 == 1) row[1][static_cast<int>(random.below(4))] = random.of(broken);
        if (i % 6 == 2) row[0][static_cast<int>(random.below(4))] = random.of(broken);
        rows.push_back(row);
    }
    return rows;
}

// One broken component breaks the value, so that all of it comes from the other frame.
Comparison blends() {
    return {{"reproCache",
             {header},
             "out0.x = reproCache(in0.x, in1.x, in2.x); out0.yz = reproCache(in0.xy, in1.xy, in2.x);\n"
             "out1 = reproCache(in0, in1, in2.x);",
             3,
             2},
            blendRows(),
            [](const Row& in) {
                const auto blend = [&](int components, int c) {
                    const auto whole = [&](const vec4& v) {
                        double value = v[c];
                        for (int each = 0; each < components; ++each)
                            if (!(std::abs(v[each]) <= 1e38f)) value = HUGE_VAL;
                        return value;
                    };
                    return oracle::cacheBlend(whole(in[0]), whole(in[1]), in[2].x);
                };
                // A difference, a product and a sum of numbers up to 12.
                const double bound = 3.0 * 16.0 * roundoff;
                return std::vector{near(dvec3(blend(1, 0), blend(2, 0), blend(2, 1)), bound),
                                   near(dvec4(blend(4, 0), blend(4, 1), blend(4, 2), blend(4, 3)), bound)};
            }};
}

TEST(ReprojectionCache, brokenHistoryIsLeftOutWhateverItsWeight) {
    expectAgrees(blends());
}

TEST(ReprojectionCache, wrongBlendsAreCaught) {
    const std::string right = "isNumber(reproData) ? fresh + (reproData - fresh) * saturate(weight) : fresh";
    expectCaught(blends(), {header, right, "fresh + (reproData - fresh) * saturate(weight)"});
    expectCaught(blends(), {header, right, "isNumber(reproData) ? lerp(reproData, fresh, weight) : fresh"});
    expectCaught(blends(), {header, "float fresh = numberOrZero(freshData);", "float fresh = freshData;"});
}

TEST(ReprojectionCache, hostileValuesAndWeightsGiveNumbers) {
    Random random(6);
    std::vector<float> values(std::begin(hostileAny), std::end(hostileAny));
    values.insert(values.end(), {1e38f, -1e38f, 3.4e38f, -3.4e38f});
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.of(values), random.of(values), random.of(values), random.of(values)),
                        vec4(random.of(values), random.of(values), random.of(values), random.of(values)),
                        vec4(random.of(hostileFinite))});
    expectAgrees({blends().function, rows, [](const Row&) { return std::vector(2, finite()); }});
}

// --- Listing 7.2 itself

// in0 (uv, fresh data, depth), in1 view rays, in2 to in5 from the current to the previous view, in6 to in9
// the previous projection, in10 to in13 their product, in14 (threshold, convergence). The history is
// gTexture0.
struct CacheRows {
    std::vector<Row> rows;
    std::vector<CameraPair> cameras;
    Texture history;
};

Row cacheRow(const CameraPair& pair, vec4 pixel, vec4 settings) {
    Row row = {pixel, vec4(viewRays(conventions()[0]))};
    push(row, pair.previous.worldToView);
    push(row, pair.previous.viewToClip);
    push(row, pair.previous.viewToClip * pair.previous.worldToView);
    row.push_back(settings);
    return row;
}

// The listing's eye rays start at the origin: the current camera stands there.
CacheRows cacheRows() {
    Random random(7);
    CacheRows made{{}, {}, {randomImage(16, 9, 8), false}};
    const double depths[] = {5.0, 10.0, 20.0};
    for (dvec4& texel : made.history.image.texels)
        texel.w = depths[random.below(3)];
    for (int i = 0; i < 2000; ++i) {
        CameraPair pair = randomCameras(random, conventions()[0].projection);
        pair.current.worldToView = glm::dmat4(1.0);
        pair.previous.worldToView = randomView(random, i % 8 == 0 ? 3.0 : 0.05, i % 8 == 0 ? 20.0 : 0.3);
        const float depth = static_cast<float>(random.of(depths)) + random.in(-0.5f, 0.5f);
        made.cameras.push_back(pair);
        made.rows.push_back(cacheRow(pair, vec4(random.unit(), random.unit(), random.unit(), depth),
                                     vec4(1.0f, 0.9f, 0.0f, i)));
    }
    return made;
}

struct Listing {
    std::string name = "WorldSpacePos";
    std::string offset = "LastClipSpacePos.xy += float2(0.5, 0.5);";
    std::string missRate = "IN_MissThreshold - abs(lastDepth - reproCache.w)";
    std::string freshData = "freshData";
    std::string result = "result";
    std::string divisor = "LastClipSpacePos.w";
    std::string behind = "LastClipSpacePos.w <= 0.0 || ";
};

std::string listing72(const Listing& text) {
    return "float4 ActiveFrame = float4(in0.z, 0.0, 0.0, in0.w);\n"
           "float4x4 IN_CameraMatrixPrev = float4x4(in2, in3, in4, in5);\n"
           "float4x4 IN_ProjectionMatrixPrev = float4x4(in6, in7, in8, in9);\n"
           "float IN_MissThreshold = in14.x; float IN_ConvergenceTime = in14.y;\n"
           "float freshData = ActiveFrame.x;\n"
           "float3 " +
           text.name +
           " = float3(in0.xy * in1.xy + in1.zw, 1.0) * ActiveFrame.w;\n"
           "float4 LastClipSpacePos = transform(IN_CameraMatrixPrev, float4(WorldSpacePos.xyz, 1.0));\n"
           "float lastDepth = LastClipSpacePos.z;\n"
           "LastClipSpacePos = transform(IN_ProjectionMatrixPrev, float4(LastClipSpacePos.xyz, 1.0));\n"
           "bool miss = " +
           text.behind +
           "false;\n"
           "LastClipSpacePos /= " +
           text.divisor +
           ";\n"
           "LastClipSpacePos.xy *= float2(0.5, -0.5);\n" +
           text.offset +
           "\n"
           "float4 reproCache = SAMPLE(gTexture0, LastClipSpacePos.xy);\n"
           "float reproData = reproCache.x;\n"
           "float missRate = " +
           text.missRate +
           ";\n"
           "if (miss || LastClipSpacePos.x < 0.0 || LastClipSpacePos.x > 1.0 || LastClipSpacePos.y < 0.0 ||"
           " LastClipSpacePos.y > 1.0) missRate = 0.0;\n"
           "missRate = saturate(missRate * IN_ConvergenceTime);\n"
           "freshData += (reproData - " +
           text.freshData +
           ") * missRate;\n"
           "float4 " +
           text.result +
           " = freshData;\n"
           "out0.x = " +
           text.result + ".x;";
}

const std::string packCache =
    "CachePlace place = cachePlaceFromDepth(in0.xy, in0.w, in1, float4x4(in10, in11, in12, in13), "
    "float2(0.0, "
    "1.0));\n"
    "float4 cached = SAMPLE(gTexture0, place.prevUv);\n"
    "out0.x = reproCache(in0.z, cached.x, cacheHistoryWeight(place, cached.w, in14.x, in14.y));";

Comparison cache(const std::string& body, const CacheRows& made = cacheRows()) {
    return {{"reprojection cache", {header}, body, 15, 1, {}, reprise::Stage::compute, {made.history}},
            made.rows,
            [made](const Row& in) {
                const CameraPair& pair = made.cameras[static_cast<size_t>(in[14].w)];
                const dvec2 uv =
                    oracle::reprojectLinearDepth(xy(in[0]), in[0].w, pair.current, pair.previous);
                const double last =
                    oracle::previousLinearDepth(xy(in[0]), in[0].w, pair.current, pair.previous);
                // A place within 1e-3 of a border may fall into either texel, or out of the image.
                const dvec2 texel = uv * made.history.image.extent();
                const dvec2 toBorder = glm::abs(texel - glm::round(texel));
                if (std::min(toBorder.x, toBorder.y) < 1e-3 && uv != oracle::behindCameraUv)
                    return std::vector{finite()};
                const dvec4 cached = oracle::samplePoint(made.history.image, uv);
                const double weight = oracle::cacheHistoryWeight(uv, last, cached.w, in[14].x, in[14].y);
                // Depths up to 40 are off by some twelve roundings, which the convergence scales; values are
                // in [0, 1].
                return std::vector{near(oracle::cacheBlend(in[0].z, cached.x, weight),
                                        0.9 * 12.0 * 64.0 * roundoff + 4.0 * roundoff)};
            }};
}

TEST(ReprojectionCache, theFunctionsAreTheCorrectedListing) {
    expectAgrees(cache(packCache));
    expectAgrees(cache(listing72({})));
}

TEST(ReprojectionCache, thePrintedWSpacePosIsCaught) {
    Listing printed;
    printed.name = "WSpacePos";
    expectDoesNotCompile(cache(listing72(printed)).function, "WorldSpacePos");
}

TEST(ReprojectionCache, thePrintedSecondScaleIsCaught) {
    Listing printed;
    printed.offset = "LastClipSpacePos.xy *= float2(0.5, 0.5);";
    EXPECT_NE(mismatches(cache(listing72(printed))), "");
    expectCaught(cache(packCache),
                 {"reprise/coordinates.hlsli", "ndc * NDC_TO_UV_SCALE + 0.5", "ndc * NDC_TO_UV_SCALE * 0.5"});
}

TEST(ReprojectionCache, thePrintedReservedWordIsCaught) {
    Listing printed;
    printed.result = "out"; // with another name it compiles, above
    expectDoesNotCompile(cache(listing72(printed)).function, "Expected");
}

TEST(ReprojectionCache, thePrintedSwizzleOfAFloatIsCaught) {
    Listing printed;
    printed.freshData = "freshData.xy";
    expectDoesNotCompile(cache(listing72(printed)).function, "xy");
}

TEST(ReprojectionCache, thePrintedListingWithItsSignOfMissRateIsCaught) {
    Listing printed;
    printed.missRate = "abs(lastDepth - reproCache.w) - IN_MissThreshold";
    EXPECT_NE(mismatches(cache(listing72(printed))), "");
}

// What the camera has just passed lies on the far side of its plane, and the division mirrors it into the
// image. Its depth, just below 0, is within the threshold of a near cached one.
TEST(ReprojectionCache, thePrintedDivisionByWBehindTheCameraIsCaught) {
    CacheRows passed = cacheRows();
    Random random(9);
    for (dvec4& texel : passed.history.image.texels)
        texel.w = 0.5;
    for (size_t i = 0; i < passed.rows.size(); ++i) {
        const double beyond = i % 10 == 0 ? 0.0 : random.in(0.2f, 0.4f);
        vec4 pixel = passed.rows[i][0];
        pixel.w = random.in(0.2f, 0.5f);
        passed.cameras[i].previous.worldToView =
            glm::translate(glm::dmat4(1.0), dvec3(0.0, 0.0, -pixel.w - beyond));
        passed.rows[i] = cacheRow(passed.cameras[i], pixel, Row(passed.rows[i])[14]);
    }
    Listing printed;
    printed.behind = "";
    EXPECT_EQ(mismatches(cache(packCache, passed)), "");
    EXPECT_EQ(mismatches(cache(listing72({}), passed)), "");
    EXPECT_NE(mismatches(cache(listing72(printed), passed)), "");
    expectCaught(cache(packCache, passed),
                 {"reprise/reprojection.hlsli", "return inFront && all(abs(uv) <= 8.0)",
                  "return all(abs(uv) <= 8.0)"});
}

TEST(ReprojectionCache, aNanInHistoryDoesNotSurvive) {
    Comparison broken = cache(packCache);
    for (dvec4& texel : broken.function.textures[0].image.texels)
        texel.x = notANumber;
    broken.oracle = [](const Row& in) { return std::vector{near(static_cast<double>(in[0].z), 0.0)}; };
    expectAgrees(broken);
    for (dvec4& texel : broken.function.textures[0].image.texels)
        texel = dvec4(0.5, 0.0, 0.0, notANumber); // the depth
    expectAgrees(broken);
    Listing right;
    broken.function.body = listing72(right);
    for (dvec4& texel : broken.function.textures[0].image.texels)
        texel = dvec4(notANumber, 0.0, 0.0, 10.0);
    EXPECT_NE(mismatches(broken), "") << "the listing keeps a NaN";
}

} // namespace
} // namespace functions
