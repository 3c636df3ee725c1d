// SPDX-License-Identifier: Apache-2.0
// Fresh values of a texel accumulated into their history, for reprojection_cache and lighting_cache, which
// declare the parameters.
#ifndef REPRISE_ACCUMULATION_HLSLI
#define REPRISE_ACCUMULATION_HLSLI

#include "passes/cached_history.hlsli"
#include "passes/cached_values.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/finite.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection_cache.hlsli"

#if HISTORY_MOTION
TEXTURE_POINT(gInVelocity, 2);
#endif

#if !HISTORY_NONE

// Where the history lies, over this image. Motion vectors carry no depth: the camera's is taken.
CachePlace findPlace(float2 uv, float depth) {
#if HISTORY_STILL
    CachePlace place = {uv, depth};
#else
    float2 frameUv = uv / gFrameToCoarse;
    float4 positionVS = float4(viewPosition(uv, depth, gViewRay), 1.0);
    CachePlace place = cachePlaceFromClip(transform(gViewToPreviousClip, positionVS), gClipToDepth);
#if HISTORY_MOTION
    // The centre lies on a corner of the frame's texels: an eighth before it a texel is met for any ratio.
    float2 motionUv = frameUv - 0.125 * gOutputSize.zw / gFrameToCoarse;
    float2 motion = SAMPLE(gInVelocity, motionUv).rg * gMotionToUv;
    place = cachePlaceFromMotion(frameUv, motion, place.lastDepth);
#endif
    place.prevUv *= gFrameToCoarse;
#endif
    return place;
}

#if CHANGE_DETECTION

// What the fresh values of the 4x4 texels from one before a texel to two behind are samples of, but of those
// only within its tile of 16x16, which lighting_cache computes in one group of threads. An occluder that has
// gone leaves the depth as it was: the values tell. Patterns repeat after 4x4 texels, so that their mean is a
// good one.
struct Surroundings {
    CachedValues mean, deviation;
};

// 1 for those of four rows or columns that lie in the tile of the second, else 0.
float4 isInTile(float second) {
    float4 four = second + float4(-1.0, 0.0, 1.0, 2.0);
    float tile = 16.0 * floor(second / 16.0);
    return abs(four - (tile + 7.5)) < 8.0 ? 1.0 : 0.0;
}

// Mean and deviation of those of sixteen whose weight is 1.
float2 meanAndDeviation(float4 rows[4], float4 weightsX, float4 weightsY) {
    float4 sum = rows[0] * weightsY.x + rows[1] * weightsY.y + rows[2] * weightsY.z + rows[3] * weightsY.w;
    float perTexel = 1.0 / (dot(weightsX, 1.0) * dot(weightsY, 1.0));
    float mean = dot(sum, weightsX) * perTexel;
    float4 squares = 0.0;
    [unroll] for (int i = 0; i < 4; ++i)
        squares += (rows[i] - mean) * (rows[i] - mean) * weightsY[i];
    return float2(mean, sqrt(dot(squares, weightsX) * perTexel));
}

void setChannel(inout Surroundings around, int channel, float2 meanAndDeviation) {
#if VALUES_ONE
    around.mean = meanAndDeviation.x;
    around.deviation = meanAndDeviation.y;
#else
    around.mean[channel] = meanAndDeviation.x;
    around.deviation[channel] = meanAndDeviation.y;
#endif
}

// Whether all values may be among those around, 1, or one of them is not, 0.
float likeness(CachedValues values, Surroundings around) {
    CachedValues allowed = max(gChange.x * around.deviation + gChange.y, 1e-4);
    return smallest(saturate(2.0 - abs(values - around.mean) / allowed));
}

#endif

#endif // !HISTORY_NONE

struct CacheTexel {
    float4 values : SV_Target0;   // four components, for shader model 3 takes no fewer
#if !VALUES_WITH_FRAMES
    float4 state : SV_Target1;
#endif
};

CacheTexel cacheTexel(CachedValues values, float frames, float depth) {
    CacheTexel texel;
    texel.values = packValues(values, frames, depth);
#if !VALUES_WITH_FRAMES
    texel.state = packState(frames, depth);
#endif
    return texel;
}

// What a texel is made from, beside its history.
struct FreshTexel {
    CachedValues values;
    float depth;
#if CHANGE_DETECTION && !HISTORY_NONE
    Surroundings around;
#endif
};

CacheTexel cachedTexel(float2 uv, FreshTexel fresh) {
#if HISTORY_NONE
    return cacheTexel(fresh.values, 1.0, fresh.depth);
#else
    CachePlace place = findPlace(uv, fresh.depth);
    float threshold = max(gMissThreshold.x + gMissThreshold.y * fresh.depth, 1e-6);
    Cached history = readHistory(place, threshold);
    float confidence = gHistoryValid > 0.5 && areCacheable(history.values) ? history.confidence : 0.0;
#if CHANGE_DETECTION
    confidence = confidence > 0.0 ? confidence * likeness(history.values, fresh.around) : 0.0;
#endif

    float2 speed = (uv - place.prevUv) * gOutputSize.xy;
    float moving = velocityWeight(length(speed), gMaxWeight, gSpeedPx.x, gSpeedPx.y);
    float weight = min(convergenceWeight(history.frames * confidence, gMaxWeight), moving);

    CachedValues values = reproCache(fresh.values, history.values, weight);
    values = weight > 0.0 ? values : fresh.values;   // a history without weight may be anything
    return cacheTexel(values, nextConvergence(history.frames, confidence), fresh.depth);
#endif
}

#endif
