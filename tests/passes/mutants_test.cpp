// SPDX-License-Identifier: Apache-2.0
// Deliberately wrong forms of the passes, each of which the comparison with the oracle or the poison must
// catch. A mutant is a copy of hlsl/ with one text replaced; if the text is no longer there, the mutant has
// to follow.
#include "ambient_occlusion_case.hpp"
#include "bilateral_upsample_case.hpp"
#include "camera_case.hpp"
#include "changed_pack.hpp"
#include "combine_lighting_case.hpp"
#include "depth_hierarchy_case.hpp"
#include "lighting_cache_case.hpp"
#include "object_case.hpp"
#include "reprojection_cache_case.hpp"
#include "scalable_obscurance_case.hpp"
#include "sun_shadow_case.hpp"
#include "temporal_aa_case.hpp"

#include <limits>

namespace passes {
namespace {

struct Mutant {
    std::string_view name;
    std::string_view file, original, wrong;
    Stage stage;
    std::vector<reprise::Condition> switches;
};

void PrintTo(const Mutant& mutant, std::ostream* stream) {
    *stream << mutant.name;
}

constexpr Stage fragment = Stage::fragment, compute = Stage::compute;

const std::vector<Mutant>& temporalAaMutants() {
    static const std::vector<Mutant> mutants = {
        {"quadDerivativesSwapped",
         "reprise/quad_sharing.hlsli",
         "value - ddx_fine(value) * side.x",
         "value - ddy_fine(value) * side.x",
         fragment,
         {{"QUAD_SHARING", "on"}}},
        {"quadSideFlipped",
         "reprise/quad_sharing.hlsli",
         "* 4.0 - 1.0",
         "* -4.0 + 1.0",
         fragment,
         {{"QUAD_SHARING", "on"}}},
        {"quadDepthNotTurned",
         "passes/temporal_aa.hlsl",
         "side.y > 0.0 ? turnedX : turnedX.wzyx",
         "turnedX",
         fragment,
         {{"QUAD_SHARING", "on"}}},
        {"gatherComponentWrong",
         "reprise/closest_fragment.hlsli",
         "d.leftUp = leftUp.w;",
         "d.leftUp = leftUp.x;",
         fragment,
         {}},
        {"gatherComponentWrongInCompute",
         "passes/temporal_aa.hlsl",
         "float3(left.w, left.z, right.z)",
         "float3(left.x, left.z, right.z)",
         compute,
         {}},
        {"farthestFragment", "reprise/depth.hlsli", "return a < b;", "return a > b;", fragment, {}},
        {"jitterSign", "passes/temporal_aa.hlsl", "gJitterPx * side;", "-gJitterPx * side;", fragment, {}},
        {"motionSign",
         "passes/temporal_aa.hlsl",
         "float3 history = readHistory(uv - motion);",
         "float3 history = readHistory(uv + motion);",
         fragment,
         {}},
        {"quadReadsColumnInCompute",
         "reprise/quad_sharing.hlsli",
         "QuadReadAcrossX(value)",
         "QuadReadAcrossY(value)",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"motionNotScaled",
         "passes/temporal_aa.hlsl",
         "SAMPLE(gInVelocity, uv).rg * gMotionToUv",
         "SAMPLE(gInVelocity, uv).rg",
         fragment,
         {}},
        {"cameraMotionReversed",
         "passes/temporal_aa.hlsl",
         "return currUv - reprojectDeviceDepth(currUv, depth, gReprojection);",
         "return reprojectDeviceDepth(currUv, depth, gReprojection) - currUv;",
         fragment,
         {{"MOTION", "camera"}}},
        {"cameraMotionJittered",
         "passes/temporal_aa.hlsl",
         "currUv = uv - gJitterPx * gOutputSize.zw;",
         "currUv = uv;",
         compute,
         {{"MOTION", "camera"}}},
        {"closestBeyondTheEdge",
         "reprise/closest_fragment.hlsli",
         "return isCloser(outer.x, own.x) ? float2(outer.y, outerY)",
         "return !isCloser(own.x, outer.x) ? float2(outer.y, outerY)",
         fragment,
         {{"MOTION", "camera"}, {"CONSTRAINT", "none"}}},
        {"centresDepthForTheClosests",
         "passes/temporal_aa.hlsl",
         "motions[y] = motionOf(uv, depth);",
         "motions[y] = motionOf(uv, depths.centre);",
         compute,
         {{"MOTION", "camera"}}},
        {"centresDepthForTheClosestsInFragment",
         "reprise/closest_fragment.hlsli",
         "depth = isCloser(outer.x, own.x) ? outer.x : own.x;",
         "depth = d.centre;",
         fragment,
         {{"MOTION", "camera"}, {"QUAD_SHARING", "on"}}},
        {"closestsDepthAtTheCentre",
         "passes/temporal_aa.hlsl",
         "motionOf(uv + offset, depth)",
         "motionOf(uv, depth)",
         fragment,
         {{"MOTION", "camera"}, {"CONSTRAINT", "none"}}},
        {"ownDepthOfAnotherTexel",
         "passes/temporal_aa.hlsl",
         "motionOf(uv, SAMPLE(gInDepth, uv).r)",
         "motionOf(uv, SAMPLE(gInDepth, uv + gOutputSize.zw).r)",
         compute,
         {{"MOTION", "camera"}, {"CLOSEST_FRAGMENT", "off"}}},
        {"roundedWithoutPlus",
         "reprise/neighbourhood.hlsli",
         "plus.minimum + square.minimum",
         "2.0 * square.minimum",
         fragment,
         {}},
        {"chromaNotShrunk",
         "reprise/neighbourhood.hlsli",
         "0.125 *",
         "0.5 *",
         fragment,
         {{"COLOUR_SPACE", "ycocg"}}},
        {"fourTapsAtFixedDistance",
         "reprise/neighbourhood.hlsli",
         "lerp(0.666, 0.5,",
         "lerp(0.666, 0.666,",
         fragment,
         {{"NEIGHBOURHOOD", "four_tap"}}},
        {"historyWeightInverted",
         "reprise/feedback.hlsli",
         "current + (history - current) * weight",
         "history + (current - history) * weight",
         fragment,
         {}},
        {"feedbackEndsSwapped",
         "reprise/feedback.hlsli",
         "lerp(weightMin, weightMax,",
         "lerp(weightMax, weightMin,",
         fragment,
         {{"FEEDBACK", "luminance"}}},
        {"rowsSwappedInCompute",
         "passes/temporal_aa.hlsl",
         "neighbourhoodOf(rows[row], rows[row + 1], rows[row + 2])",
         "neighbourhoodOf(rows[row + 2], rows[row + 1], rows[row])",
         compute,
         {}},
        {"halfTexelOff",
         "passes/temporal_aa.hlsl",
         "pxToUv(float2(firstPixel) + 0.5,",
         "pxToUv(float2(firstPixel),",
         compute,
         {}},
        {"halfTexelOffInFragment",
         "passes/temporal_aa.hlsl",
         "pxToUv(positionPx.xy,",
         "pxToUv(positionPx.xy - 0.5,",
         fragment,
         {}},
        {"historyKeptOutsideTheImage",
         "passes/temporal_aa.hlsl",
         "isInsideUv(uv - motion) ? weight * gHistoryValid : 0.0",
         "weight * gHistoryValid",
         fragment,
         {}},
        {"invalidHistoryUsed",
         "passes/temporal_aa.hlsl",
         "weight * gHistoryValid : 0.0",
         "weight : 0.0",
         fragment,
         {}},
        {"motionBlurTrustInverted",
         "reprise/motion_blur.hlsli",
         "(blurToPx - motionPx)",
         "(motionPx - blurFromPx)",
         fragment,
         {}},
        {"motionBlurAtJitteredCentre",
         "passes/temporal_aa.hlsl",
         "uv + gJitterPx * gOutputSize.zw;",
         "uv;",
         compute,
         {}},
        {"cubicLobeSign",
         "reprise/resampling.hlsli",
         "f * f * (-0.5 + 0.5 * f)",
         "f * f * (0.5 - 0.5 * f)",
         fragment,
         {{"HISTORY_FILTER", "bicubic"}}},
        {"gaussianTooWide",
         "reprise/unjitter.hlsli",
         "UNJITTER_SIGMA_PX = 0.47",
         "UNJITTER_SIGMA_PX = 0.48",
         fragment,
         {{"UNJITTER", "gaussian"}}},
        {"expansionSkipped",
         "passes/temporal_aa.hlsl",
         "return expandHdr(colour);",
         "return colour;",
         fragment,
         {{"HDR_WEIGHT", "on"}}},
        {"chromaBeyondTheRange",
         "passes/temporal_aa.hlsl",
         "saturate(ycocgToRgb(colour))",
         "max(ycocgToRgb(colour), 0.0)",
         fragment,
         {{"COLOUR_SPACE", "ycocg"}}},
        {"repairMissing",
         "reprise/colour.hlsli",
         "return saturate(colour * UNIT_PER_COLOUR);",
         "return colour * UNIT_PER_COLOUR;",
         fragment,
         {}},
        {"sharedEndsMissing",
         "reprise/quad_sharing.hlsli",
         "column == 0u || column == last ? end : value",
         "value",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"sharedEndsSwapped",
         "passes/temporal_aa.hlsl",
         "column == 0u ? 1u : 0u",
         "column == 0u ? 0u : 1u",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"sharedRowsNotMirrored",
         "passes/temporal_aa.hlsl",
         "unjitteredColour(n, side);\n        Resolved",
         "unjitteredColour(n, float2(1.0, 1.0));\n        Resolved",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"sharedEndOfAnotherRow",
         "passes/temporal_aa.hlsl",
         "float(index >> 1u) - 1.0",
         "float(index >> 1u)",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"sharedQuadBeyondTheImage",
         "passes/temporal_aa.hlsl",
         "own = min(place, last)",
         "own = place",
         fragment,
         {{"QUAD_SHARING", "on"}}},
        {"sharedTexelBeyondTheImage",
         "passes/temporal_aa.hlsl",
         "clamp(place + int2(side), int2(0, 0), last)",
         "place + int2(side)",
         fragment,
         {{"QUAD_SHARING", "on"}}},
        {"sharedStoresNotExchanged",
         "passes/temporal_aa.hlsl",
         "halfRowSwap(inRightHalf ? upper.history : lower.history",
         "halfRowSwap(inRightHalf ? lower.history : upper.history",
         compute,
         {{"QUAD_SHARING", "on"}}},
        {"sanitizeMissingInCompute",
         "reprise/colour.hlsli",
         "return min(positive, MAX_COLOUR);",
         "return colour;",
         compute,
         {{"HDR_WEIGHT", "on"}}},
    };
    return mutants;
}

const std::vector<Mutant>& cameraMutants() {
    static const std::vector<Mutant> mutants = {
        {"jitterAdded", "passes/camera_velocity.hlsl", "uv - gJitterUv", "uv + gJitterUv", fragment, {}},
        {"motionReversed",
         "passes/camera_velocity.hlsl",
         "return currUv - prevUv;",
         "return prevUv - currUv;",
         compute,
         {}},
        {"yNotFlipped", "reprise/coordinates.hlsli", "float2(0.5, -0.5)", "float2(0.5, 0.5)", fragment, {}},
        {"behindNotGuarded",
         "reprise/reprojection.hlsli",
         "bool inFront = positionCS.w > 0.0;",
         "bool inFront = true;",
         fragment,
         {}},
        {"rayNotScaledByDepth",
         "reprise/reprojection.hlsli",
         "alongRay * linearDepth + originCS",
         "alongRay + originCS",
         compute,
         {{"DEPTH_LINEAR", "on"}}},
        {"matrixTransposed",
         "reprise/conventions.hlsli",
         "return mul(v, m);",
         "return mul(m, v);",
         fragment,
         {}},
    };
    return mutants;
}

constexpr std::string_view addJitter = "output.positionPx.xy += gJitterNdc * output.positionCS.w;";

const std::vector<Mutant>& objectMutants() {
    static const std::vector<Mutant> mutants = {
        {"previousSkinIsCurrent",
         "passes/object_velocity.hlsl",
         "skin(gInPrevJoints,",
         "skin(gInJoints,",
         Stage::vertex,
         {{"SKINNING", "on"}}},
        {"jointWeightsMixed",
         "passes/object_velocity.hlsl",
         "weights.y * transform",
         "weights.z * transform",
         Stage::vertex,
         {{"SKINNING", "on"}}},
        {"notJittered", "passes/object_velocity.hlsl", addJitter, "", Stage::vertex, {}},
        {"motionJittered",
         "passes/object_velocity.hlsl",
         addJitter,
         "output.positionCS.xy += gJitterNdc * output.positionCS.w; output.positionPx = output.positionCS;",
         Stage::vertex,
         {}},
        {"objectMotionReversed",
         "reprise/reprojection.hlsli",
         "clipToUv(positionCS) - clipToUv(prevPositionCS)",
         "clipToUv(prevPositionCS) - clipToUv(positionCS)",
         fragment,
         {}},
    };
    return mutants;
}

ChangedPack changed(const Mutant& mutant) {
    const TextChange change{mutant.file, mutant.original, mutant.wrong};
    return ChangedPack({&change, 1});
}

// The frames of the comparison: as it is, velocity in NDC, and without history; odd, so that quads go beyond.
std::vector<TemporalAaFrame> framesForMutants() {
    TemporalAaFrame plain = randomFrame(39, 37, 31), ndc = plain, first = plain;
    for (size_t i = 0; i < ndc.velocity.values.size(); ++i)
        ndc.velocity.values[i] *= i % 2 == 0 ? 2.0f : -2.0f;
    ndc.parameters.gMotionToUv[0] = 0.5f;
    ndc.parameters.gMotionToUv[1] = -0.5f;
    first.parameters.gHistoryValid = 0.0f;
    return {plain, ndc, first, randomFrame(39, 37, 33, Contrast::saturated)};
}

bool isColour(const std::vector<Pixels>& outputs) {
    for (const Pixels& output : outputs)
        for (const float value : output.values)
            if (!(value >= 0.0f && value <= 65504.0f)) return false;
    return true;
}

// Whether any test of temporal_aa would fail with this pass.
bool isCaught(Pass& pass) {
    const auto frames = framesForMutants();
    for (const TemporalAaFrame& frame : frames)
        if (!compareWithOracle(pass.variant(), frame, run(pass, frame)).holds()) return true;
    // Between texels a filter spreads what is broken, and the oracle has no say.
    const bool readsTexels = reprise::switchValue(pass.variant(), "NEIGHBOURHOOD") != "four_tap";
    for (const float poison : {std::numeric_limits<float>::quiet_NaN(), -3.0f}) {
        TemporalAaFrame poisoned = frames[0];
        for (int c = 0; c < 3; ++c)
            poisoned.colour.at(20, 20, c) = poison;
        const auto outputs = run(pass, poisoned);
        if (!isColour(outputs)) return true;
        if (readsTexels && !compareWithOracle(pass.variant(), poisoned, {outputs[0]}).holds()) return true;
    }
    return false;
}

std::vector<VkFormat> float32Outputs(const Variant& variant) {
    const bool blurs = reprise::switchValue(variant, "MOTION_BLUR_FALLBACK") == "on";
    return std::vector<VkFormat>(blurs ? 2 : 1, rgba32f);
}

// The form without the mistake is not caught; once for each form.
bool rightFormPasses(const Variant& variant, Stage stage) {
    static std::map<std::string, bool> known;
    const std::string name = describe(variant, stage, 0, 0);
    if (const auto found = known.find(name); found != known.end()) return found->second;
    Pass right(variant, stage, float32Outputs(variant));
    return known[name] = !isCaught(right);
}

class TemporalAaMutant : public PassTest, public testing::WithParamInterface<Mutant> {};
INSTANTIATE_TEST_SUITE_P(Mutants, TemporalAaMutant, testing::ValuesIn(temporalAaMutants()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_P(TemporalAaMutant, isCaught) {
    const Mutant& mutant = GetParam();
    const ChangedPack mutated = changed(mutant);
    ASSERT_EQ(mutated.missing(), "");
    const Variant right = variantOf(pack(), "temporal_aa", mutant.switches);
    EXPECT_TRUE(rightFormPasses(right, mutant.stage)) << "the comparison fails without the mistake too";
    const Variant wrong = variantOf(mutated.pack(), "temporal_aa", mutant.switches);
    Pass pass(wrong, mutant.stage, float32Outputs(wrong), mutated.pack());
    EXPECT_TRUE(isCaught(pass));
}

class CameraVelocityMutant : public PassTest, public testing::WithParamInterface<Mutant> {};
INSTANTIATE_TEST_SUITE_P(Mutants, CameraVelocityMutant, testing::ValuesIn(cameraMutants()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_P(CameraVelocityMutant, isCaught) {
    const Mutant& mutant = GetParam();
    const ChangedPack mutated = changed(mutant);
    ASSERT_EQ(mutated.missing(), "");
    const bool depthLinear = !mutant.switches.empty();
    const CameraCase frame = randomCameraCase({}, depthLinear, 64, 64, 32);
    const CameraCase behind = randomCameraCase({}, depthLinear, 64, 64, 32, true);
    auto isCaughtBy = [&](Pass&& pass) {
        return !compareWithOracle(frame, run(pass, frame)[0]).holds() ||
               !compareWithOracle(behind, run(pass, behind)[0]).holds();
    };
    EXPECT_FALSE(
        isCaughtBy(Pass(variantOf(pack(), "camera_velocity", mutant.switches), mutant.stage, {rg32f})));
    EXPECT_TRUE(isCaughtBy(Pass(variantOf(mutated.pack(), "camera_velocity", mutant.switches), mutant.stage,
                                {rg32f}, mutated.pack())));
}

class ObjectVelocityMutant : public PassTest, public testing::WithParamInterface<Mutant> {};
INSTANTIATE_TEST_SUITE_P(Mutants, ObjectVelocityMutant, testing::ValuesIn(objectMutants()),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_P(ObjectVelocityMutant, isCaught) {
    const Mutant& mutant = GetParam();
    const ChangedPack mutated = changed(mutant);
    ASSERT_EQ(mutated.missing(), "");
    ObjectCase object;
    object.skinned = !mutant.switches.empty();
    EXPECT_TRUE(compareWithOracle(object, recordedMotion(object)).holds());
    EXPECT_FALSE(compareWithOracle(object, recordedMotion(object, mutated.pack())).holds());
}

// --- The framework's passes

struct FrameworkMutant {
    std::string_view pass;
    Mutant mutant;
};

void PrintTo(const FrameworkMutant& mutant, std::ostream* stream) {
    *stream << mutant.mutant.name;
}

const std::vector<FrameworkMutant>& frameworkMutants() {
    constexpr std::string_view down = "passes/depth_downsample.hlsl",
                               occlusion = "passes/ambient_occlusion.hlsli",
                               coarse = "passes/coarse_depth.hlsli", cache = "passes/accumulation.hlsli",
                               held = "passes/cached_history.hlsli", merged = "passes/lighting_cache.hlsl",
                               values = "passes/cached_values.hlsli", filter = "passes/bilateral_filter.hlsl",
                               up = "passes/bilateral_upsample.hlsl", sun = "passes/sun_shadow.hlsli",
                               hierarchy = "passes/depth_hierarchy.hlsl",
                               obscurance = "passes/scalable_obscurance.hlsl",
                               blur = "passes/obscurance_filter.hlsl",
                               combine = "passes/combine_lighting.hlsl",
                               digits = "reprise/occlusion_depth_packing.hlsli";
    static const std::vector<FrameworkMutant> mutants = {
        {"depth_downsample",
         {"reversedDepthTakesTheFarthest",
          down,
          "return max(a, b);",
          "return min(a, b);",
          fragment,
          {{"DEPTH_REVERSED", "on"}}}},
        {"depth_downsample",
         {"quarterReadsOneCornerTwice",
          down,
          "centrePx + float2(1.0, -1.0)",
          "centrePx + 1.0",
          compute,
          {{"RATIO", "4"}}}},
        {"depth_downsample",
         {"checkerStartsWithTheFarthest", down, "> 0.25;", "< 0.25;", fragment, {{"CHECKERBOARD", "on"}}}},
        {"depth_downsample",
         {"skyKeepsItsDepth", down, "depth < min(gSkyDepth, SKY_DEPTH)", "depth < SKY_DEPTH", compute, {}}},
        {"ambient_occlusion",
         {"tangentsOfAnotherNormal",
          occlusion,
          "float b = normal.x * normal.y * a;",
          "float b = 0.0;",
          fragment,
          {}}},
        {"ambient_occlusion",
         {"normalFacesAway",
          occlusion,
          "return normalize(normal);",
          "return -normalize(normal);",
          compute,
          {}}},
        {"ambient_occlusion",
         {"normalForgetsTheRay", occlusion, "-1.0 - dot(", "-1.0 + 0.0 * dot(", fragment, {}}},
        {"ambient_occlusion",
         {"fartherSideOfAnEdge",
          coarse,
          "differenceBefore < differenceAfter",
          "differenceBefore >= differenceAfter",
          fragment,
          {}}},
        {"ambient_occlusion", {"oneTapForAll", occlusion, "gTaps[tap]", "gTaps[0]", fragment, {}}},
        {"ambient_occlusion",
         {"patternOfNoPixel",
          occlusion,
          "pixelOffsets(floor(positionPx))",
          "pixelOffsets(0.0)",
          compute,
          {}}},
        {"ambient_occlusion",
         {"samplesBeyondTheImageCount", occlusion, "screen.z > 0.0 && isInsideUv(uv)", "true", compute, {}}},
        {"ambient_occlusion",
         {"farBlockersCount", occlusion, "* saturate(2.0 - inFront * perRadius)", "", fragment, {}}},
        {"ambient_occlusion",
         {"normalAtTheCorner",
          occlusion,
          "(uv - 0.125 * gOutputSize.zw)",
          "(uv)",
          fragment,
          {{"NORMALS", "read"}}}},
        {"ambient_occlusion",
         {"normalOverTheCoarseImage", occlusion, " / gFrameToCoarse)", ")", compute, {{"NORMALS", "read"}}}},
        {"ambient_occlusion",
         {"normalsOfAnyLength",
          occlusion,
          "normal * rsqrt(lengthSquared)",
          "normal",
          compute,
          {{"NORMALS", "read"}}}},
        {"reprojection_cache",
         {"convergenceNotCounted",
          cache,
          "nextConvergence(history.frames, confidence)",
          "history.frames",
          fragment,
          {}}},
        {"reprojection_cache",
         {"depthNotCompared",
          held,
          "cacheHistoryWeight(place, depthOf(texel, state),",
          "cacheHistoryWeight(place, place.lastDepth,",
          compute,
          {}}},
        {"reprojection_cache",
         {"motionAdded",
          "reprise/reprojection_cache.hlsli",
          "float2 prevUv = uv - motion;",
          "float2 prevUv = uv + motion;",
          fragment,
          {{"HISTORY", "motion"}}}},
        {"reprojection_cache",
         {"deviationIsVariance",
          cache,
          "sqrt(dot(squares, weightsX) * perTexel)",
          "dot(squares, weightsX) * perTexel",
          fragment,
          {{"CHANGE_DETECTION", "on"}}}},
        {"reprojection_cache",
         {"changeSeenInThreeByThree",
          "passes/reprojection_cache.hlsl",
          "gatherFresh(pxToUv(texel + 2.0,",
          "gatherFresh(pxToUv(texel + 1.0,",
          compute,
          {{"CHANGE_DETECTION", "on"}}}},
        {"reprojection_cache",
         {"changeSeenBeyondTheTile",
          cache,
          "< 8.0 ? 1.0 : 0.0",
          "< 80.0 ? 1.0 : 0.0",
          fragment,
          {{"CHANGE_DETECTION", "on"}}}},
        {"reprojection_cache",
         {"changeSeenInTheFirstOfFourAlone",
          "passes/reprojection_cache.hlsl",
          "if (channel == 2) texels = GATHER_BLUE(gInFresh, uv);",
          "",
          compute,
          {{"CHANGE_DETECTION", "on"}, {"VALUES", "four"}}}},
        {"reprojection_cache",
         {"depthOfTwoValuesFromTheValues",
          values,
          "return state.g;",
          "return values.g;",
          fragment,
          {{"VALUES", "two"}}}},
        {"reprojection_cache",
         {"coarseUvTakenForTheFrames", cache, "place.prevUv *= gFrameToCoarse;", "", fragment, {}}},
        {"reprojection_cache",
         {"packedPairSwapped",
          values,
          "? unpackShadowInInteger(texel.r) :",
          "? unpackShadowInInteger(texel.r).yx :",
          compute,
          {{"VALUES", "shadow_in_integer"}}}},
        {"reprojection_cache",
         {"packedValuesFiltered",
          held,
          "sumOfPacked(four.packed, shares)",
          "sumOfPacked(dot(four.packed, shares), shares)",
          fragment,
          {{"VALUES", "occlusion_in_integer"}}}},
        {"reprojection_cache",
         {"packedPairsGatheredAcross",
          held,
          "GATHER_RED(gHistoryCache, corner).wzxy",
          "GATHER_RED(gHistoryCache, corner).xyzw",
          compute,
          {{"VALUES", "shadow_in_integer"}}}},
        {"reprojection_cache",
         {"packedTexelsCountByPlaceAlone",
          held,
          "float4 shares = four.shares * confidence;",
          "float4 shares = four.shares;",
          compute,
          {{"VALUES", "occlusion_in_integer"}}}},
        {"reprojection_cache",
         {"confidenceOfAllTexels",
          held,
          "history.confidence = dot(shares, confidence);",
          "history.confidence = dot(four.shares, confidence);",
          fragment,
          {{"VALUES", "with_frames"}}}},
        {"reprojection_cache",
         {"framesOfOtherSurfaces",
          held,
          "history.frames = dot(shares, held.frames);",
          "history.frames = dot(four.shares, held.frames);",
          compute,
          {{"VALUES", "with_frames"}}}},
        {"reprojection_cache",
         {"historyDepthGatheredAcross",
          held,
          "GATHER_RED(gHistoryCoarseDepth, corner).wzxy",
          "GATHER_RED(gHistoryCoarseDepth, corner).xyzw",
          compute,
          {{"VALUES", "with_frames"}}}},
        {"reprojection_cache",
         {"framesForgotten",
          values,
          "packWithFrames(values, frames)",
          "packWithFrames(values, 1.0)",
          fragment,
          {{"VALUES", "with_frames"}, {"HISTORY", "still"}}}},
        {"bilateral_filter",
         {"convergenceHasNoSay",
          filter,
          "smoothingOfConvergence(frames,",
          "smoothingOfConvergence(8.0,",
          fragment,
          {}}},
        {"bilateral_filter",
         {"directionIgnored",
          filter,
          "gDirection * gOutputSize.zw",
          "gOutputSize.zw",
          compute,
          {{"TAPS", "point"}, {"STEP", "any"}}}},
        {"bilateral_filter",
         {"linesOfColumnsAcross",
          filter,
          "gDirection.x > gDirection.y",
          "gDirection.x < gDirection.y",
          compute,
          {}}},
        {"bilateral_filter",
         {"gatheredTapsOfPoints", filter, "int(ceil(OFFSETS[i]))", "int(floor(OFFSETS[i]))", compute, {}}},
        {"bilateral_filter",
         {"pairsAreThatOfTheNearerTexel",
          filter,
          "ceil(offset) * offSize",
          "floor(offset) * offSize",
          fragment,
          {{"VALUES", "shadow_in_integer"}}}},
        {"bilateral_filter",
         {"fourthValueDropped",
          filter,
          "alpha = GATHER_ALPHA(gInCache, uv);",
          "",
          compute,
          {{"VALUES", "four"}}}},
        {"bilateral_filter",
         {"pairNotUnpacked",
          values,
          "? unpackOcclusionInInteger(texel.r) :",
          "? texel.rr :",
          fragment,
          {{"VALUES", "occlusion_in_integer"}}}},
        {"bilateral_upsample",
         {"shadowForOcclusionOfPacked",
          up,
          "float2(four.occlusion[texel], four.shadow[texel])",
          "float2(four.shadow[texel], four.occlusion[texel])",
          compute,
          {{"VALUES", "with_frames"}}}},
        {"bilateral_upsample", {"gatherOrder", up, ".wzxy", ".xyzw", fragment, {}}},
        {"bilateral_upsample",
         {"cornerOffByOne", up, "COARSE_TEXEL_PX - 0.5) + 1.0", "COARSE_TEXEL_PX - 0.5)", compute, {}}},
        {"bilateral_upsample",
         {"weightsOfTheFirstPixelInAll", up, "place + pixel / COARSE_TEXEL_PX", "place", compute, {}}},
        {"bilateral_upsample",
         {"ratioOfTwoTakenForFour",
          up,
          "(first + 0.5) / COARSE_TEXEL_PX - 0.5",
          "0.25",
          compute,
          {{"RATIO", "4"}}}},
        {"bilateral_upsample",
         {"normalsOfTheFirstTexelAlone",
          up,
          "readCoarseNormal(footprint.rightUp)",
          "readCoarseNormal(footprint.leftUp)",
          fragment,
          {{"NORMAL_WEIGHTS", "on"}}}},
        {"bilateral_upsample",
         {"coarseNormalAtTheCorner",
          up,
          "gCoarseSize.xy - 0.125)",
          "gCoarseSize.xy)",
          compute,
          {{"NORMAL_WEIGHTS", "on"}}}},
        {"bilateral_upsample",
         {"coarseNormalOfTheWrongPixel",
          up,
          "gCoarseSize.xy - 0.125)",
          "gCoarseSize.xy - 0.375)",
          fragment,
          {{"NORMAL_WEIGHTS", "on"}, {"RATIO", "4"}}}},
        {"bilateral_upsample",
         {"coarseUvTakenForTheFrame",
          up,
          "SAMPLE(gInNormal, pxToUv(positionPx, gOutputSize.zw))",
          "SAMPLE(gInNormal, coarseUv - 0.125 * gCoarseSize.zw)",
          fragment,
          {{"NORMAL_WEIGHTS", "on"}}}},
        {"sun_shadow",
         {"oneDepthForAllSamples", sun, "place.z + dot(slope, texel - place.xy)", "place.z", fragment, {}}},
        {"sun_shadow",
         {"planeAtThePlaceAndNotAtTheTexel",
          sun,
          "floor(place.xy + radius * sqrt(frac(own.y + areaShift)) * azimuth) + 0.5;",
          "place.xy + radius * sqrt(frac(own.y + areaShift)) * azimuth;",
          compute,
          {}}},
        {"sun_shadow",
         {"slopeOfTheFirstCascadeInAll",
          sun,
          "slope *= cascade.scale.z / cascade.scale.xy;",
          "",
          fragment,
          {}}},
        {"sun_shadow",
         {"biasOfTheFirstCascadeInAll", sun, "* depth) * cascade.scale.z;", "* depth);", compute, {}}},
        {"sun_shadow",
         {"slopeOfAnySteepness",
          sun,
          "clamp(-normal.xy / area, -gShadowBias.z, gShadowBias.z)",
          "-normal.xy / area",
          fragment,
          {}}},
        {"sun_shadow",
         {"shadowPlaneOfTheFartherSide",
          coarse,
          "differenceBefore < differenceAfter",
          "differenceBefore >= differenceAfter",
          compute,
          {}}},
        {"lighting_cache",
         {"rowsOfTheRow",
          merged,
          "gsRow[y[k]].mean",
          "gsRow[x[k]].mean",
          compute,
          {{"CHANGE_DETECTION", "on"}}}},
        {"lighting_cache",
         {"meanNotSquaredAway", merged, " - sum.mean * sum.mean", "", compute, {{"CHANGE_DETECTION", "on"}}}},
        {"lighting_cache",
         {"changeSeenBeyondTheBorder",
          merged,
          "min(float2(thread.xy) + 0.5, gOutputSize.xy - 0.5)",
          "float2(thread.xy) + 0.5",
          compute,
          {{"CHANGE_DETECTION", "on"}}}},
        {"lighting_cache",
         {"shadowForOcclusion",
          merged,
          "float2(occlusion, shadow)",
          "float2(shadow, occlusion)",
          compute,
          {{"FRESH", "both"}, {"VALUES", "two"}}}},
        {"depth_hierarchy",
         {"gridNotRotated", hierarchy, "frac(0.5 * texel.yx)", "frac(0.5 * texel.xy)", fragment, {}}},
        {"depth_hierarchy",
         {"levelsBeginOneRowLate", hierarchy, "fromBelow <= begins.x", "fromBelow < begins.x", compute, {}}},
        {"depth_hierarchy",
         {"brokenDepthKept",
          hierarchy,
          "depth > 0.0 && depth < min(",
          "depth < min(",
          fragment,
          {{"DEPTH_LINEAR", "on"}}}},
        {"scalable_obscurance",
         {"coarseDepthAtThePlaceAskedFor",
          obscurance,
          "pxToUv(tap.placePx, gOutputSize.zw), depth",
          "pxToUv(px, gOutputSize.zw), depth",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"levelsReadAtTheWrongPlace",
          obscurance,
          "gOutputSize.y - floor(2.0 * share * gOutputSize.y)",
          "gOutputSize.y - 2.0 * share * gOutputSize.y",
          compute,
          {}}},
        {"scalable_obscurance",
         {"rotationStandsStill", obscurance, "+ GOLDEN_TURN * rotation)", ")", fragment, {}}},
        {"scalable_obscurance", {"radiiStandStill", obscurance, "(rotation + 0.5) /", "0.5 /", compute, {}}},
        {"scalable_obscurance",
         {"spiralStepOfOneRotation",
          obscurance,
          "frac(GOLDEN_TURN * rotations)",
          "frac(GOLDEN_TURN)",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"pixelsShareOneTurn",
          obscurance,
          "frac(numberOfPixel(floor(positionPx)) + G",
          "frac(G",
          compute,
          {}}},
        {"scalable_obscurance",
         {"tapsBeyondTheImageCount",
          obscurance,
          "isInsideUv(px * gOutputSize.zw) ? float2",
          "true ? float2",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"normalOverTheFartherSide",
          obscurance,
          "differenceBefore < differenceAfter",
          "differenceBefore >= differenceAfter",
          compute,
          {}}},
        {"sun_shadow",
         {"stepWithoutThePerspective",
          sun,
          "uv * change.x + step * change.y",
          "step * change.y",
          fragment,
          {}}},
        {"sun_shadow",
         {"shadowPatternStandsStill",
          sun,
          "float2 shift = subset",
          "float2 shift = 0.0 * subset",
          compute,
          {}}},
        {"sun_shadow", {"samplesOnTheRimAlone", sun, "sqrt(frac(own.y + areaShift))", "1.0", fragment, {}}},
        {"sun_shadow",
         {"samplesInTheNextColumn", sun, "texel = clamp(texel, 0.5, lastTexel);", "", compute, {}}},
        {"sun_shadow", {"lastCascadeWithoutEnd", sun, " && depth <= cascade.farDepth", "", fragment, {}}},
        {"sun_shadow",
         {"placesBesideTheMapAreItsEdges",
          sun,
          "isInsideUv(place.xy / gCascadeSize.xy) && ",
          "",
          compute,
          {}}},
        {"sun_shadow",
         {"fourthCascadeReadsTheThird",
          sun,
          "nearer.index + (hasEnded ? 1.0 : 0.0);",
          "hasEnded ? min(nearer.index + 1.0, 2.0) : nearer.index;",
          fragment,
          {{"CASCADES", "4"}}}},
        {"sun_shadow",
         {"reversedMapComparedAsStandard",
          sun,
          "mapDepth > max(depth, 0.0) + bias",
          "mapDepth < max(depth, 0.0) - bias",
          compute,
          {{"SHADOW_REVERSED", "on"}}}},
        {"sun_shadow",
         {"packedInTheOtherOrder",
          "passes/sun_shadow.hlsl",
          "packShadowInInteger(SAMPLE(",
          "packOcclusionInInteger(SAMPLE(",
          fragment,
          {{"VALUES", "shadow_in_integer"}}}},
        {"scalable_obscurance",
         {"obscuranceMotionAdded",
          obscurance,
          "gInVelocity, uv).rg * gMotionToUv",
          "gInVelocity, uv).rg * -gMotionToUv",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"cameraStandsStillInDepth",
          obscurance,
          "dot(gViewToPreviousDepth, float4(positionVS, 1.0))",
          "positionVS.z",
          compute,
          {}}},
        {"scalable_obscurance",
         {"weightFallsInALine", obscurance, "room * room * (3.0 - 2.0 * room)", "room", fragment, {}}},
        {"scalable_obscurance",
         {"rejectedAtOnce", obscurance, "threshold, 2.0 / threshold)", "threshold, 1e9)", compute, {}}},
        {"scalable_obscurance",
         {"tapWithoutABound", obscurance, "min(term, MOST_OF_A_TAP)", "term", compute, {}}},
        {"scalable_obscurance",
         {"motionHasNoSayInTheWeight",
          obscurance,
          "float maxWeight = maxWeightOf(motion);",
          "float maxWeight = gMaxWeight;",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"weightFallsAtOnceInMotion",
          obscurance,
          "gMaxWeight - least, 0.0, gMovingPx)",
          "gMaxWeight - least, gMovingPx, gMovingPx)",
          compute,
          {}}},
        {"scalable_obscurance",
         {"motionLeavesNoHistory",
          obscurance,
          "float least = min(gMovingWeight, gMaxWeight);",
          "float least = 0.0;",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"speedInUv", obscurance, "length(motion * gOutputSize.xy)", "length(motion)", compute, {}}},
        {"scalable_obscurance",
         {"framesNotCounted",
          obscurance,
          "history.convergence * confidence;",
          "15.0 * confidence;",
          fragment,
          {}}},
        {"scalable_obscurance",
         {"writtenToTheNearestStep",
          obscurance,
          "gFarDepth, noiseOfFrame(positionPx))",
          "gFarDepth, 0.5)",
          compute,
          {}}},
        {"scalable_obscurance",
         {"digitsSwapped",
          digits,
          "packKey16(linearKeyFromDepth(data.linearDepth, 0.0, farM));\n    float4 digits",
          "packKey16(linearKeyFromDepth(data.linearDepth, 0.0, farM)).yx;\n    float4 digits",
          fragment,
          {{"TEMPORAL", "off"}}}},
        {"obscurance_filter",
         {"oneSideAlone", blur, "uv - float(i) * step", "uv + float(i) * step", fragment, {}}},
        {"obscurance_filter", {"depthHasNoSay", blur, "max(1.0 - apart, 0.0)", "1.0", compute, {}}},
        {"obscurance_filter",
         {"depthFiltered",
          blur,
          "centre.occlusion = sum.x / sum.y;",
          "centre.occlusion = sum.x / sum.y; centre.linearDepth *= 0.999;",
          fragment,
          {}}},
        {"obscurance_filter",
         {"boxOfNineTaps",
          blur,
          "0.8824969, 0.6065307, 0.3246525, 0.1353353",
          "1.0, 1.0, 1.0, 1.0",
          compute,
          {}}},
        {"combine_lighting",
         {"sunByTheOcclusion",
          combine,
          "knownVisibility(lighting.g)",
          "knownVisibility(lighting.r)",
          fragment,
          {}}},
        {"combine_lighting",
         {"shadowAloneInGreen",
          combine,
          "gInSunLight, uv).rgb) * knownVisibility(lighting.r)",
          "gInSunLight, uv).rgb) * knownVisibility(lighting.g)",
          compute,
          {{"LIGHTING", "shadow"}}}},
        {"combine_lighting",
         {"otherLightOccluded",
          combine,
          "sanitize(SAMPLE(gInOtherLight, uv).rgb)",
          "sanitize(SAMPLE(gInOtherLight, uv).rgb) * knownVisibility(lighting.r)",
          fragment,
          {{"OTHER_LIGHT", "on"}}}},
        {"combine_lighting",
         {"visibilityBeyondOne", combine, "saturate(visibility)", "visibility", compute, {}}},
        {"combine_lighting",
         {"unknownVisibilityIsNone",
          combine,
          "saturate(visibility) : 1.0",
          "saturate(visibility) : 0.0",
          fragment,
          {}}},
        {"combine_lighting",
         {"sumBeyondTheFormat", combine, "min(colour, MAX_COLOUR)", "colour", compute, {}}},
        {"combine_lighting",
         {"brokenLightKept",
          combine,
          "sanitize(SAMPLE(gInAmbientLight, uv).rgb)",
          "SAMPLE(gInAmbientLight, uv).rgb",
          fragment,
          {{"LIGHTING", "occlusion"}}}},
        {"combine_lighting",
         {"alphaOfTheLights", combine, "MAX_COLOUR), 1.0)", "MAX_COLOUR), 0.0)", compute, {}}},
    };
    return mutants;
}

// At an odd size, in the second frame of a cycle: the comparison that each pass's own test makes.
bool frameworkCatches(const Variant& right, Pass& pass) {
    constexpr int width = 39, height = 27;
    const std::string_view name = right.pass->name;
    const auto fails = [&](const auto& frame) {
        return !compareWithOracle(frame, run(pass, frame)[0]).holds();
    };
    if (name == "depth_downsample") return fails(randomDepthDownsampleCase(right, width, height, 34));
    if (name == "ambient_occlusion")
        return fails(ambientOcclusionCase(right, Surfaces::corner, width, height, 34));
    if (name == "sun_shadow") return fails(sunShadowCase(right, Surfaces::corner, width, height, 34));
    if (name == "reprojection_cache") {
        const auto frame = reprojectionCacheCase(right, width, height, 34);
        return !compareWithOracle(frame, run(pass, frame)).holds();
    }
    if (name == "lighting_cache") {
        const auto frame = lightingCacheCase(right, width, height, 34);
        return !compareWithSeparate(frame, run(pass, frame), SeparatePasses(right)(frame)).holds();
    }
    if (name == "depth_hierarchy") {
        auto frame = depthHierarchyCase(right, width, height, 34);
        frame.depths.depth.at(12, 9, 0) = -3.0f;
        return fails(frame);
    }
    // As in its tests, narrow bounds and depths that differ from texel to texel.
    if (name == "scalable_obscurance")
        return fails(scalableObscuranceCase(right, Surfaces::corner, 64, 47, 34)) ||
               fails(scalableObscuranceCase(right, Surfaces::random, width, height, 34));
    if (name == "obscurance_filter") return fails(obscuranceFilterCase(width, height, {1, 0}, 34));
    if (name == "combine_lighting") {
        auto frame = combineLightingCase(right, width, height, 34);
        for (int c = 0; c < 2; ++c)
            frame.lighting.at(12, 9, c) = std::numeric_limits<float>::infinity();
        for (int c = 0; c < 3; ++c) {
            frame.ambient.at(13, 9, c) = std::numeric_limits<float>::quiet_NaN();
            frame.ambient.at(14, 9, c) = frame.sun.at(14, 9, c) = 65504.0f;
            frame.lighting.at(14, 9, c % 2) = 1.0f;
        }
        return fails(frame);
    }
    if (name == "bilateral_filter") return fails(bilateralFilterCase(right, width, height, {1, 0}, 34));
    return fails(bilateralUpsampleCase(right, width, height, 34));
}

class FrameworkMutants : public PassTest, public testing::WithParamInterface<FrameworkMutant> {};
INSTANTIATE_TEST_SUITE_P(Mutants, FrameworkMutants, testing::ValuesIn(frameworkMutants()),
                         [](const auto& each) { return std::string(each.param.mutant.name); });

TEST_P(FrameworkMutants, areCaught) {
    const Mutant& mutant = GetParam().mutant;
    const ChangedPack mutated = changed(mutant);
    ASSERT_EQ(mutated.missing(), "");
    const Variant right = variantOf(pack(), GetParam().pass, mutant.switches);
    const std::vector<VkFormat> formats = wideFormats(right);
    Pass unchanged(right, mutant.stage, formats);
    EXPECT_FALSE(frameworkCatches(right, unchanged)) << "the comparison fails without the mistake too";
    Pass wrong(variantOf(mutated.pack(), GetParam().pass, mutant.switches), mutant.stage, formats,
               mutated.pack());
    EXPECT_TRUE(frameworkCatches(right, wrong));
}

} // namespace
} // namespace passes
