// SPDX-License-Identifier: Apache-2.0
// Products of matrices are made in double precision: in single precision a camera far from the origin
// jitters.
#include "frame_parameters.hpp"

#include "plan_images.hpp"
#include "reprise/ambient_occlusion.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace reprise {
namespace {

template <size_t count> void store(float (&target)[count], const glm::mat4& matrix) {
    static_assert(sizeof(target) == sizeof(matrix));
    std::memcpy(target, &matrix, sizeof(matrix));
}

template <size_t count, class Vector> void store(float (&target)[count], const Vector& vector) {
    static_assert(count == static_cast<size_t>(Vector::length()));
    for (size_t i = 0; i < count; ++i)
        target[i] = static_cast<float>(vector[static_cast<int>(i)]);
}

glm::dvec4 sizeOf(VkExtent2D extent) {
    return {extent.width, extent.height, 1.0 / extent.width, 1.0 / extent.height};
}

VkExtent2D coarseExtent(const CacheFrame& frame) {
    return {(frame.extent.width + frame.cache.ratio - 1) / frame.cache.ratio,
            (frame.extent.height + frame.cache.ratio - 1) / frame.cache.ratio};
}

// UV over the frame to UV over the coarse image, whose last texels reach beyond a frame of odd size.
glm::dvec2 frameToCoarse(const CacheFrame& frame) {
    const VkExtent2D coarse = coarseExtent(frame);
    return glm::dvec2(frame.extent.width, frame.extent.height) /
           (double(frame.cache.ratio) * glm::dvec2(coarse.width, coarse.height));
}

glm::dvec4 coarseViewRay(const FrameInput& input, const CacheFrame& frame) {
    const glm::dvec4 ray = viewRay(input.camera.viewToClip);
    const glm::dvec2 extent = glm::dvec2(ray) / frameToCoarse(frame);
    return {extent, ray.z, ray.w};
}

// As in hlsl/reprise/depth.hlsli.
constexpr double skyDepth = 65504.0;

// A little less than the far plane, where what a far plane has cut off lies.
double skyFrom(const FrameInput& input, const CacheFrame& frame) {
    const glm::dvec2 c = linearDepthCoefficients(input.camera.viewToClip);
    const double affine = (frame.reversedDepth ? 0.0 : 1.0) * c.x + c.y;
    const double farPlane = isOrthographic(input.camera.viewToClip) ? affine : 1.0 / affine;
    return farPlane > 0.0 && farPlane < skyDepth ? 0.9999 * farPlane : skyDepth;
}

DepthDownsampleParameters downsampleParameters(const FrameInput& input, const CacheFrame& frame) {
    DepthDownsampleParameters p{};
    store(p.gInputSize, sizeOf(frame.extent));
    store(p.gOutputSize, sizeOf(coarseExtent(frame)));
    store(p.gLinearDepth, linearDepthCoefficients(input.camera.viewToClip));
    p.gSkyDepth = static_cast<float>(skyFrom(input, frame));
    return p;
}

// Of a pass without the switch 0.
uint32_t samplesOf(const Variant& variant) {
    const std::string_view text = switchValue(variant, "SAMPLES");
    uint32_t samples = 0;
    std::from_chars(text.data(), text.data() + text.size(), samples);
    return samples;
}

// Whole and small: the patterns repeat after `subsets` frames, and so may the count.
float patternFrame(const FrameInput& input) {
    return static_cast<float>(input.frameIndex % std::max(1u, input.cache.subsets));
}

AmbientOcclusionParameters occlusionParameters(const FrameInput& input, const CacheFrame& frame,
                                               uint32_t samples) {
    AmbientOcclusionParameters p{};
    store(p.gOutputSize, sizeOf(coarseExtent(frame)));
    store(p.gViewRay, coarseViewRay(input, frame));
    p.gRadius = input.cache.radius;
    store(p.gOcclusionBias, input.cache.bias);
    store(p.gFrameToCoarse, frameToCoarse(frame));
    const auto taps = occlusionTaps(samples, input.frameIndex, input.cache.subsets);
    static_assert(sizeof(taps) == sizeof(p.gTaps));
    std::memcpy(p.gTaps, taps.data(), sizeof(taps));
    return p;
}

Result<SunShadowParameters> shadowParameters(const FrameInput& input, const CacheFrame& frame) {
    const VkExtent2D map = input.shadowMap ? input.shadowMap->extent : VkExtent2D{};
    auto p = sunShadowParameters(input.camera, frameToCoarse(frame), input.cascades, map.width, map.height,
                                 input.cache.shadow);
    if (!p) return p;
    store(p->gOutputSize, sizeOf(coarseExtent(frame)));
    p->gFrameIndex = patternFrame(input);
    p->gSubsetCount = static_cast<float>(input.cache.subsets);
    return p;
}

ReprojectionCacheParameters historyParameters(const FrameInput& input, const CacheFrame& frame) {
    const CacheTuning& tuning = input.cache;
    const glm::dmat4& before = frame.previous.viewToClip;
    ReprojectionCacheParameters p{};
    store(p.gViewToPreviousClip, glm::mat4(viewToPreviousClip(input.camera, frame.previous)));
    store(p.gOutputSize, sizeOf(coarseExtent(frame)));
    store(p.gViewRay, coarseViewRay(input, frame));
    store(p.gFrameToCoarse, frameToCoarse(frame));
    store(p.gMotionToUv, frame.engineMotion && input.tuning ? input.tuning->motionToUv : glm::vec2(1.0f));
    store(p.gClipToDepth, isOrthographic(before) ? linearDepthCoefficients(before) : glm::dvec2(0.0, 1.0));
    store(p.gMissThreshold, tuning.missThreshold);
    p.gConvergenceTime = tuning.convergenceTime;
    p.gMaxWeight = tuning.maxWeight;
    store(p.gSpeedPx, tuning.speedPx);
    p.gHistoryValid = frame.historyValid ? 1.0f : 0.0f;
    store(p.gChange, tuning.change);
    return p;
}

template <class Field> void copy(Field& to, const Field& from) {
    std::memcpy(&to, &from, sizeof(to));
}

// What the three passes have that it does the work of.
Result<LightingCacheParameters> lightingCacheParameters(const Variant& variant, const FrameInput& input,
                                                        const CacheFrame& frame) {
    LightingCacheParameters p{};
    if (switchValue(variant, "FRESH") != "occlusion") {
        const auto shadow = shadowParameters(input, frame);
        if (!shadow) return shadow.error();
        copy(p.gToShadowX, shadow->gToShadowX);
        copy(p.gToShadowY, shadow->gToShadowY);
        copy(p.gToShadowZ, shadow->gToShadowZ);
        copy(p.gCascadeScale1, shadow->gCascadeScale1);
        copy(p.gCascadeOffset1, shadow->gCascadeOffset1);
        copy(p.gCascadeScale2, shadow->gCascadeScale2);
        copy(p.gCascadeOffset2, shadow->gCascadeOffset2);
        copy(p.gCascadeScale3, shadow->gCascadeScale3);
        copy(p.gCascadeOffset3, shadow->gCascadeOffset3);
        copy(p.gCascadeFar, shadow->gCascadeFar);
        copy(p.gCascadeSize, shadow->gCascadeSize);
        copy(p.gDisc, shadow->gDisc);
        copy(p.gShadowBias, shadow->gShadowBias);
    }
    const AmbientOcclusionParameters occlusion = occlusionParameters(input, frame, samplesOf(variant));
    p.gRadius = occlusion.gRadius;
    p.gFrameIndex = patternFrame(input);
    p.gSubsetCount = static_cast<float>(input.cache.subsets);
    copy(p.gOcclusionBias, occlusion.gOcclusionBias);
    copy(p.gTaps, occlusion.gTaps);
    const ReprojectionCacheParameters history = historyParameters(input, frame);
    copy(p.gViewToPreviousClip, history.gViewToPreviousClip);
    copy(p.gOutputSize, history.gOutputSize);
    copy(p.gViewRay, history.gViewRay);
    copy(p.gFrameToCoarse, history.gFrameToCoarse);
    copy(p.gMotionToUv, history.gMotionToUv);
    copy(p.gClipToDepth, history.gClipToDepth);
    copy(p.gMissThreshold, history.gMissThreshold);
    copy(p.gSpeedPx, history.gSpeedPx);
    copy(p.gChange, history.gChange);
    p.gConvergenceTime = history.gConvergenceTime;
    p.gMaxWeight = history.gMaxWeight;
    p.gHistoryValid = history.gHistoryValid;
    return p;
}

BilateralFilterParameters filterParameters(std::string_view run, const FrameInput& input,
                                           const CacheFrame& frame) {
    const CacheTuning& tuning = input.cache;
    BilateralFilterParameters p{};
    store(p.gOutputSize, sizeOf(coarseExtent(frame)));
    store(p.gDirection,
          frame.cache.filterStep * (run == "across" ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.0f, 1.0f)));
    store(p.gDepthAmplitude, tuning.depthAmplitude);
    p.gConverged = tuning.converged;
    p.gMaxSmoothing = tuning.maxSmoothing;
    p.gMinSmoothing = tuning.minSmoothing;
    return p;
}

BilateralUpsampleParameters upsampleParameters(const FrameInput& input, const CacheFrame& frame) {
    BilateralUpsampleParameters p{};
    store(p.gOutputSize, sizeOf(frame.extent));
    store(p.gCoarseSize, sizeOf(coarseExtent(frame)));
    store(p.gLinearDepth, linearDepthCoefficients(input.camera.viewToClip));
    p.gSkyDepth = static_cast<float>(skyFrom(input, frame));
    p.gContrast = input.cache.normalContrast;
    return p;
}

CombineLightingParameters combineParameters(const CacheFrame& frame) {
    CombineLightingParameters p{};
    store(p.gOutputSize, sizeOf(frame.extent));
    return p;
}

// Across the width of the frame and half of it more, which is where the levels are.
VkExtent2D hierarchyExtent(const CacheFrame& frame) {
    return {(3 * frame.extent.width + 1) / 2, frame.extent.height};
}

DepthHierarchyParameters hierarchyParameters(const FrameInput& input, const CacheFrame& frame) {
    DepthHierarchyParameters p{};
    store(p.gInputSize, sizeOf(frame.extent));
    store(p.gOutputSize, sizeOf(hierarchyExtent(frame)));
    store(p.gLinearDepth, linearDepthCoefficients(input.camera.viewToClip));
    p.gSkyDepth = static_cast<float>(skyFrom(input, frame));
    return p;
}

// Up to which the 16 bits of the history tell depths apart: their step is 1.5 cm.
constexpr float obscuranceFarDepth = 1000.0f;

ScalableObscuranceParameters obscuranceParameters(const FrameInput& input, const CacheFrame& frame) {
    const CacheTuning& tuning = input.cache;
    ScalableObscuranceParameters p{};
    store(p.gOutputSize, sizeOf(frame.extent));
    store(p.gViewRay, viewRay(input.camera.viewToClip));
    p.gRadius = tuning.radius;
    p.gIntensity = tuning.obscurance.intensity;
    store(p.gBias, tuning.obscurance.bias);
    p.gFrameIndex = static_cast<float>(input.frameIndex % std::max(1u, tuning.obscurance.rotations));
    p.gRotationCount = static_cast<float>(tuning.obscurance.rotations);
    p.gFarDepth = obscuranceFarDepth;
    p.gMaxWeight = tuning.obscurance.maxWeight;
    store(p.gMissThreshold, tuning.missThreshold);
    store(p.gMotionToUv, frame.engineMotion && input.tuning ? input.tuning->motionToUv : glm::vec2(1.0f));
    const glm::dmat4 toPrevious = frame.previous.worldToView * glm::inverse(input.camera.worldToView);
    store(p.gViewToPreviousDepth,
          glm::dvec4(toPrevious[0].z, toPrevious[1].z, toPrevious[2].z, toPrevious[3].z));
    p.gHistoryValid = frame.historyValid ? 1.0f : 0.0f;
    p.gMovingWeight = tuning.obscurance.movingWeight;
    p.gMovingPx = tuning.obscurance.movingPx;
    return p;
}

ObscuranceFilterParameters obscuranceFilterParameters(std::string_view run, const FrameInput& input,
                                                      const CacheFrame& frame) {
    ObscuranceFilterParameters p{};
    store(p.gOutputSize, sizeOf(frame.extent));
    store(p.gDirection,
          frame.cache.filterStep * (run == "across" ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.0f, 1.0f)));
    store(p.gDepthRange, input.cache.obscurance.depthRange);
    p.gFarDepth = obscuranceFarDepth;
    return p;
}

template <class Parameters> std::vector<std::byte> bytesOf(const Parameters& parameters) {
    const auto bytes = std::as_bytes(std::span(&parameters, 1));
    return {bytes.begin(), bytes.end()};
}

} // namespace

Result<std::vector<std::byte>> cacheParameters(const PlannedPass& planned, const FrameInput& input,
                                               const CacheFrame& frame) {
    const std::string_view pass = planned.variant.pass->name, run = planned.run;
    if (pass == "depth_downsample") return bytesOf(downsampleParameters(input, frame));
    if (pass == "ambient_occlusion")
        return bytesOf(occlusionParameters(input, frame, samplesOf(planned.variant)));
    if (pass == "sun_shadow") {
        auto parameters = shadowParameters(input, frame);
        if (!parameters) return parameters.error();
        return bytesOf(*parameters);
    }
    if (pass == lightingCachePass) {
        auto parameters = lightingCacheParameters(planned.variant, input, frame);
        if (!parameters) return parameters.error();
        return bytesOf(*parameters);
    }
    if (pass == "depth_hierarchy") return bytesOf(hierarchyParameters(input, frame));
    if (pass == obscurancePass) return bytesOf(obscuranceParameters(input, frame));
    if (pass == obscuranceFilterPass) return bytesOf(obscuranceFilterParameters(run, input, frame));
    if (pass == "reprojection_cache") return bytesOf(historyParameters(input, frame));
    if (pass == "bilateral_filter") return bytesOf(filterParameters(run, input, frame));
    if (pass == combinePass) return bytesOf(combineParameters(frame));
    return bytesOf(upsampleParameters(input, frame));
}

CameraVelocityParameters cameraParameters(const FrameInput& input, const CameraFrame& previous,
                                          VkExtent2D extent, bool linearDepth) {
    CameraVelocityParameters parameters{};
    const auto toPrevious =
        linearDepth ? viewToPreviousClip(input.camera, previous) : reprojection(input.camera, previous);
    store(parameters.gReprojection, glm::mat4(toPrevious));
    store(parameters.gViewRay, viewRay(input.camera.viewToClip));
    store(parameters.gOutputSize, sizeOf(extent));
    store(parameters.gJitterUv, input.jitterPx / glm::dvec2(extent.width, extent.height));
    return parameters;
}

ObjectVelocityParameters objectParameters(const ObjectDraw& object, const FrameInput& input,
                                          const CameraFrame& previous, VkExtent2D extent) {
    ObjectVelocityParameters parameters{};
    const auto toClip = [](const CameraFrame& camera, const glm::mat4& toWorld) {
        return glm::mat4(camera.viewToClip * camera.worldToView * glm::dmat4(toWorld));
    };
    store(parameters.gObjectToClip, toClip(input.camera, object.objectToWorld));
    store(parameters.gPrevObjectToClip, toClip(previous, object.prevObjectToWorld));
    store(parameters.gJitterNdc, input.jitterPx * glm::dvec2(2.0 / extent.width, -2.0 / extent.height));
    return parameters;
}

TaaTuning tuningOf(const PresetInfo& preset) {
    TaaTuning tuning;
    tuning.feedbackMin = preset.feedbackMin;
    tuning.feedbackMax = preset.feedbackMax;
    tuning.rampFeedback = preset.rampFeedback;
    return tuning;
}

TemporalAaParameters temporalParameters(const FrameInput& input, const CameraFrame& previous,
                                        const TaaTuning& tuning, VkExtent2D extent, uint64_t historyFrames,
                                        bool engineMotion) {
    const auto frames = static_cast<float>(historyFrames);
    const float most = tuning.rampFeedback ? frames / (frames + 1.0f) : 1.0f;
    TemporalAaParameters parameters{};
    store(parameters.gOutputSize, sizeOf(extent));
    store(parameters.gJitterPx, input.jitterPx);
    store(parameters.gMotionToUv, engineMotion ? tuning.motionToUv : glm::vec2(1.0f));
    parameters.gHistoryValid = historyFrames > 0 ? 1.0f : 0.0f;
    parameters.gFeedbackMin = std::min(tuning.feedbackMin, most);
    parameters.gFeedbackMax = std::min(tuning.feedbackMax, most);
    parameters.gBlurFromPx = tuning.blurFromPx;
    parameters.gBlurToPx = tuning.blurToPx;
    store(parameters.gReprojection, glm::mat4(reprojection(input.camera, previous)));
    return parameters;
}

} // namespace reprise
