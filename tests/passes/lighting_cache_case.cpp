// SPDX-License-Identifier: Apache-2.0
#include "lighting_cache_case.hpp"

#include <cmath>
#include <cstring>

namespace passes {

namespace {

template <class Field> void copy(Field& to, const Field& from) {
    std::memcpy(&to, &from, sizeof(to));
}

Variant with(std::string_view pass, const Variant& from, std::initializer_list<std::string_view> names) {
    std::vector<reprise::Condition> switches;
    for (const std::string_view name : names)
        switches.push_back({name, reprise::switchValue(from, name)});
    return variantOf(pack(), pass, switches);
}

Variant cacheVariant(const Variant& variant) {
    return with("reprojection_cache", variant,
                {"VALUES", "HISTORY", "RESAMPLING", "CHANGE_DETECTION", "ORTHOGRAPHIC"});
}

Variant occlusionVariant(const Variant& variant) {
    return with("ambient_occlusion", variant, {"SAMPLES", "NORMALS", "ORTHOGRAPHIC"});
}

Variant shadowVariant(const Variant& variant) {
    return with("sun_shadow", variant, {"SAMPLES", "CASCADES", "SHADOW_REVERSED", "ORTHOGRAPHIC"});
}

void setParameters(LightingCacheCase& frame) {
    reprise::LightingCacheParameters& p = frame.parameters;
    const auto& shadow = frame.shadow.parameters;
    copy(p.gToShadowX, shadow.gToShadowX);
    copy(p.gToShadowY, shadow.gToShadowY);
    copy(p.gToShadowZ, shadow.gToShadowZ);
    copy(p.gCascadeScale1, shadow.gCascadeScale1);
    copy(p.gCascadeOffset1, shadow.gCascadeOffset1);
    copy(p.gCascadeScale2, shadow.gCascadeScale2);
    copy(p.gCascadeOffset2, shadow.gCascadeOffset2);
    copy(p.gCascadeScale3, shadow.gCascadeScale3);
    copy(p.gCascadeOffset3, shadow.gCascadeOffset3);
    copy(p.gCascadeFar, shadow.gCascadeFar);
    copy(p.gCascadeSize, shadow.gCascadeSize);
    copy(p.gDisc, shadow.gDisc);
    copy(p.gShadowBias, shadow.gShadowBias);
    p.gFrameIndex = shadow.gFrameIndex;
    p.gSubsetCount = shadow.gSubsetCount;
    const auto& occlusion = frame.occlusion.parameters;
    p.gRadius = occlusion.gRadius;
    copy(p.gOcclusionBias, occlusion.gOcclusionBias);
    copy(p.gTaps, occlusion.gTaps);
    const auto& cache = frame.cache.parameters;
    copy(p.gViewToPreviousClip, cache.gViewToPreviousClip);
    copy(p.gOutputSize, cache.gOutputSize);
    copy(p.gViewRay, cache.gViewRay);
    copy(p.gFrameToCoarse, cache.gFrameToCoarse);
    copy(p.gMotionToUv, cache.gMotionToUv);
    copy(p.gClipToDepth, cache.gClipToDepth);
    copy(p.gMissThreshold, cache.gMissThreshold);
    copy(p.gSpeedPx, cache.gSpeedPx);
    copy(p.gChange, cache.gChange);
    p.gConvergenceTime = cache.gConvergenceTime;
    p.gMaxWeight = cache.gMaxWeight;
    p.gHistoryValid = cache.gHistoryValid;
}

bool isSame(const LightingCacheCase& frame, VkFormat format, float got, float expected) {
    const double difference = std::max(std::abs(double{got} - expected) - storeError(format, expected), 0.0);
    return difference < 1e-3 ||
           (oracle::isPacked(frame.cache.pass.values) && std::abs(difference - 1.0) < 3e-3);
}

// To a level more or less, and to a frame.
bool isSameWithFrames(float got, float expected) {
    const glm::dvec3 mine = oracle::unpackedWithFrames(got), others = oracle::unpackedWithFrames(expected);
    return glm::all(glm::lessThan(glm::abs(mine - others), glm::dvec3(2e-3, 2e-3, 1.5)));
}

} // namespace

LightingCacheCase lightingCacheCase(const Variant& variant, int width, int height, uint64_t seed) {
    LightingCacheCase frame{
        ambientOcclusionCase(occlusionVariant(variant), Surfaces::corner, width, height, seed),
        sunShadowCase(shadowVariant(variant), Surfaces::corner, width, height, seed),
        reprojectionCacheCase(cacheVariant(variant), width, height, seed),
        {},
        {}};
    Pixels& depth = frame.occlusion.depth;
    for (float& value : depth.values)
        value = value >= 65504.0f ? value : std::round(value * 128.0f) / 128.0f;
    setRatio(frame.occlusion, 1, seed);
    frame.shadow.depth = frame.halfDepth = frame.cache.coarseDepth = depth;
    ReprojectionCacheCase& cache = frame.cache;
    cache.pass.ratio = 1;
    cache.pass.previous = cache.pass.current;
    cache.fresh = cache.history = makePixels(rgba32f, width, height, [](int, int) { return Texel{}; });
    const auto random = [&](int x, int y, uint64_t what) {
        return unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), what);
    };
    const auto historyDepth = [&](int x, int y) {
        return depth.at(x, y, 0) + (random(x / 5, y / 5, 40) < 0.2 ? 1.0 : 0.02 * random(x, y, 41));
    };
    cache.history = makePixels(rgba32f, width, height, [&](int x, int y) {
        const glm::dvec4 values(random(x, y, 42), random(x, y, 43), 0.0, 0.0);
        const double frames = 1.0 + std::floor(15.0 * random(x, y, 47));
        const glm::vec4 texel(oracle::packedValues(cache.pass.values, values, historyDepth(x, y), frames));
        return Texel{texel.x, texel.y, texel.z, texel.w};
    });
    cache.state = makePixels(rg32f, width, height, [&](int x, int y) {
        return Texel{static_cast<float>(1.0 + std::floor(9.0 * random(x, y, 44))),
                     static_cast<float>(historyDepth(x, y))};
    });
    cache.historyDepth = depthsOf(cache.state);
    cache.velocity = makePixels(rg32f, width, height, [&](int x, int y) {
        return Texel{static_cast<float>(6.0 * (random(x, y, 45) - 0.5) / width),
                     static_cast<float>(6.0 * (random(x, y, 46) - 0.5) / height)};
    });
    cache.pass.change = {1.0, 0.2};
    setParameters(cache);
    copy(cache.parameters.gViewRay, frame.occlusion.parameters.gViewRay);
    setParameters(frame);
    return frame;
}

std::vector<Pixels> run(Pass& pass, const LightingCacheCase& frame) {
    const NamedPixels inputs[] = {
        {"gInCoarseDepth", &frame.occlusion.depth},      {"gInHalfDepth", &frame.halfDepth},
        {"gInNormal", &frame.occlusion.normal},          {"gInShadowMap", &frame.shadow.map},
        {"gInVelocity", &frame.cache.velocity},          {"gHistoryCache", &frame.cache.history},
        {"gHistoryCacheFiltered", &frame.cache.history}, {"gHistoryCoarseDepth", &frame.cache.historyDepth},
        {"gHistoryCacheState", &frame.cache.state},      {"gHistoryCacheStateFiltered", &frame.cache.state}};
    return pass(inputs, frame.parameters, frame.halfDepth.width, frame.halfDepth.height);
}

SeparatePasses::SeparatePasses(const Variant& variant)
    : fresh_(reprise::switchValue(variant, "FRESH")),
      occlusion_(occlusionVariant(variant), Stage::compute, {rg32f}),
      shadow_(shadowVariant(variant), Stage::compute, {rg32f}),
      cache_(cacheVariant(variant), Stage::compute, cacheFormats(variant)) {}

std::vector<Pixels> SeparatePasses::operator()(LightingCacheCase frame) {
    const Pixels occlusion = run(occlusion_, frame.occlusion)[0], shadow = run(shadow_, frame.shadow)[0];
    const auto values = frame.cache.pass.values;
    frame.cache.fresh = makePixels(rgba32f, occlusion.width, occlusion.height, [&](int x, int y) {
        glm::dvec4 pair(fresh_ == "shadow" ? 1.0f : occlusion.at(x, y, 0),
                        fresh_ == "occlusion" ? 1.0f : shadow.at(x, y, 0), 0.0, 0.0);
        if (values == oracle::CachePass::Values::one) pair.x *= pair.y;
        const bool framed = values == oracle::CachePass::Values::withFrames; // what is fresh is not packed
        const glm::vec4 texel(framed ? pair : oracle::packedValues(values, pair, occlusion.at(x, y, 1)));
        return Texel{texel.x, texel.y, texel.z, texel.w};
    });
    return run(cache_, frame.cache);
}

Comparison compareWithSeparate(const LightingCacheCase& frame, const std::vector<Pixels>& got,
                               const std::vector<Pixels>& separate) {
    Comparison comparison;
    const bool isFramed = frame.cache.pass.values == oracle::CachePass::Values::withFrames;
    comparison.pixels =
        static_cast<size_t>(frame.halfDepth.width) * static_cast<size_t>(frame.halfDepth.height);
    for (size_t image = 0; image < separate.size(); ++image)
        for (int y = 0; y < frame.halfDepth.height; ++y)
            for (int x = 0; x < frame.halfDepth.width; ++x)
                for (int c = 0; c < std::min(got[image].channels, separate[image].channels); ++c) {
                    const float mine = got[image].at(x, y, c), others = separate[image].at(x, y, c);
                    if (isFramed ? isSameWithFrames(mine, others)
                                 : isSame(frame, got[image].format, mine, others))
                        continue;
                    ++comparison.outside;
                    comparison.worst = "image " + std::to_string(image) + ", pixel (" + std::to_string(x) +
                                       ", " + std::to_string(y) + "), channel " + std::to_string(c) + " is " +
                                       std::to_string(mine) + ", of separate passes " +
                                       std::to_string(others);
                }
    return comparison;
}

} // namespace passes
