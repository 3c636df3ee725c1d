// SPDX-License-Identifier: Apache-2.0
// The reprojection cache: a fresh value accumulated into its history, where the history shows the same
// surface. Drobot, 7.2, "Reprojection Caching", Listing 7.2 (D2), with the running convergence of 7.3 (D8).
//
// gInFresh       RG16F: value of this frame, linear depth in metres. VALUES other than one: occlusion and
//                shadow in one, see occlusion_shadow_packing.hlsli
// gInVelocity    MOTION: motion times gMotionToUv = currUv - prevUv without jitter, at the frame's extent
// gHistoryCache  gOutCache of the frame before, or what bilateral_filter made of it; any content where
//                gHistoryValid is 0. gHistoryCacheFiltered is the same image under a linear filter
// gOutCache      RGBA16F: value, 0, convergence in frames, linear depth in metres
// A value beyond MAX_COLOUR or NaN counts as 0, in history as none. SKY_DEPTH takes part like a surface.

#include "reprise/cache_resampling.hlsli"
#include "reprise/conventions.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/occlusion_shadow_packing.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection_cache.hlsli"

BINDING(0) cbuffer ReprojectionCacheParameters {
    row_major float4x4 gViewToPreviousClip;   // reprise::viewToPreviousClip()
    float4 gOutputSize;     // width, height, 1 / width, 1 / height
    float4 gViewRay;        // extent and origin of the view rays over this image, see viewPosition()
    float2 gFrameToCoarse;  // UV over the frame to UV over this image: frame / (ratio * coarse extent)
    float2 gMotionToUv;     // (1, 1) for currUv - prevUv in UV
    float2 gClipToDepth;    // (0, 1), or linearDepthCoefficients() of an orthographic previous projection
    float2 gMissThreshold;  // metres, and metres per metre of depth, from which on depths are two surfaces
    float gConvergenceTime; // confidence of equal depths, above 0: 2 keeps it whole up to half the threshold
    float gMaxWeight;       // most weight of history, [0, 1)
    float2 gSpeedPx;        // pixels of this image a frame, from which on history fades, and is none
    float gHistoryValid;    // 0 on the first frame, after a cut, a gap or a resize
};

TEXTURE_POINT(gInFresh, 1);
#if MOTION
TEXTURE_POINT(gInVelocity, 2);
#endif
#define PACKED (!VALUES_ONE)
#if RESAMPLING_NEAREST || PACKED
TEXTURE_POINT(gHistoryCache, 3);
#else
TEXTURE_LINEAR(gHistoryCacheFiltered, 4);
#endif

// Both values of a cache; of one value the second is 0.
struct Cached {
    float2 values;
    float convergence, depth;
};

#if PACKED
float2 unpackValues(float value) {
#if VALUES_OCCLUSION_IN_INTEGER
    return unpackOcclusionInInteger(value);
#else
    return unpackShadowInInteger(value);
#endif
}

float packValues(float2 values) {
#if VALUES_OCCLUSION_IN_INTEGER
    return packOcclusionInInteger(values.x, values.y);
#else
    return packShadowInInteger(values.x, values.y);
#endif
}
#else
float2 unpackValues(float value) {
    return float2(value, 0.0);
}

float packValues(float2 values) {
    return values.x;
}
#endif

// Two values, convergence and depth of a texel. What a history cannot hold becomes no number.
float4 unpackTexel(float4 texel) {
    float2 values = abs(texel.r) <= MAX_COLOUR ? unpackValues(texel.r) : 2.0 * LARGEST_NUMBER;
    return float4(values, texel.ba);
}

Cached readHistory(float2 uv) {
#if PACKED && RESAMPLING_BILINEAR
    // Unpacked one by one: between two packed values a filter makes a third, which neither of them is.
    float2 position = uv * gOutputSize.xy - 0.5;
    float2 low = (floor(position) + 0.5) * gOutputSize.zw;
    float2 high = low + gOutputSize.zw;
    float2 right = frac(position);
    float2 left = 1.0 - right;
    float4 texel = meanOfNumbers(unpackTexel(SAMPLE(gHistoryCache, low)),
                                 unpackTexel(SAMPLE(gHistoryCache, float2(high.x, low.y))),
                                 unpackTexel(SAMPLE(gHistoryCache, float2(low.x, high.y))),
                                 unpackTexel(SAMPLE(gHistoryCache, high)),
                                 float4(left.x, right.x, left.x, right.x) *
                                     float4(left.y, left.y, right.y, right.y));
#elif PACKED || RESAMPLING_NEAREST
    float4 texel = unpackTexel(SAMPLE(gHistoryCache, uv));
#else
    float4 texel = unpackTexel(SAMPLE(gHistoryCacheFiltered, uv));
#endif
    Cached history;
    history.values = texel.xy;
    history.convergence = texel.z;
    history.depth = texel.w;
    return history;
}

// Where the history lies, over this image. Motion vectors carry no depth: the camera's is taken.
CachePlace findPlace(float2 uv, float depth) {
    float2 frameUv = uv / gFrameToCoarse;
    float4 positionVS = float4(viewPosition(uv, depth, gViewRay), 1.0);
    CachePlace place = cachePlaceFromClip(transform(gViewToPreviousClip, positionVS), gClipToDepth);
#if MOTION
    // The centre lies on a corner of the frame's texels: an eighth before it a texel is met for any ratio.
    float2 motionUv = frameUv - 0.125 * gOutputSize.zw / gFrameToCoarse;
    float2 motion = SAMPLE(gInVelocity, motionUv).rg * gMotionToUv;
    place = cachePlaceFromMotion(frameUv, motion, place.lastDepth);
#endif
    place.prevUv *= gFrameToCoarse;
    return place;
}

// Value, 0, convergence and depth.
float4 cachedTexel(float2 uv) {
    float4 fresh = SAMPLE(gInFresh, uv);
    float depth = fresh.g > 0.0 && fresh.g < SKY_DEPTH ? fresh.g : SKY_DEPTH;
    float2 current = abs(fresh.r) <= MAX_COLOUR ? unpackValues(fresh.r) : 0.0;

    CachePlace place = findPlace(uv, depth);
    Cached history = readHistory(place.prevUv);

    float threshold = max(gMissThreshold.x + gMissThreshold.y * depth, 1e-6);
    float confidence = cacheHistoryWeight(place, history.depth, threshold, gConvergenceTime / threshold);
    confidence = gHistoryValid > 0.5 && all(abs(history.values) <= MAX_COLOUR) ? confidence : 0.0;

    float2 speed = (uv - place.prevUv) * gOutputSize.xy;
    float moving = velocityWeight(length(speed), gMaxWeight, gSpeedPx.x, gSpeedPx.y);
    float held = bounded(history.convergence, 0.0, MAX_CONVERGENCE) * confidence;
    float weight = min(convergenceWeight(held, gMaxWeight), moving);

    float2 values = exponentialHistory(history.values, current, weight);
    values = weight > 0.0 ? values : current;   // a history without weight may be anything
    return float4(packValues(values), 0.0, nextConvergence(history.convergence, confidence), depth);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutCache;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    gOutCache[thread.xy] = cachedTexel(pxToUv(float2(thread.xy) + 0.5, gOutputSize.zw));
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return cachedTexel(pxToUv(positionPx.xy, gOutputSize.zw));
}

#endif
