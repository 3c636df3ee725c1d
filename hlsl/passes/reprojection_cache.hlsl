// SPDX-License-Identifier: Apache-2.0
// The reprojection cache: a fresh value accumulated into its history, where the history shows the same
// surface. Drobot, 7.2, "Reprojection Caching", Listing 7.2 (D2), with the running convergence of 7.3 (D8).
//
// gInFresh       RG16F: value of this frame, linear depth in metres. VALUES other than one: occlusion and
//                shadow in one, see occlusion_shadow_packing.hlsli
// gInVelocity    HISTORY motion: motion times gMotionToUv = currUv - prevUv without jitter, of the frame
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
    float2 gSpeedPx;        // pixels of this image a frame, from which on history fades, and is none
    float2 gChange;         // CHANGE_DETECTION: deviations, plus a difference, that history may differ by
    float gConvergenceTime; // confidence of equal depths, above 0: 2 keeps it whole up to half the threshold
    float gMaxWeight;       // most weight of history, [0, 1)
    float gHistoryValid;    // 0 on the first frame, after a cut, a gap or a resize
};

TEXTURE_POINT(gInFresh, 1);
#if HISTORY_MOTION
TEXTURE_POINT(gInVelocity, 2);
#endif
#define PACKED (!VALUES_ONE)
// A history that stands still lies texel on texel: there is nothing to filter.
#if HISTORY_NONE
#elif RESAMPLING_NEAREST || PACKED || HISTORY_STILL
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

#if !HISTORY_NONE

Cached readHistory(float2 uv) {
#if PACKED && RESAMPLING_BILINEAR && !HISTORY_STILL
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
#elif PACKED || RESAMPLING_NEAREST || HISTORY_STILL
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
#if HISTORY_STILL
    CachePlace place;
    place.prevUv = uv;
    place.lastDepth = depth;
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

// Red of the four texels around a corner; what is no number counts as 0, as it does in the cache.
float4 readFour(float2 uv) {
#if HAS_GATHER
    float4 texels = GATHER_RED(gInFresh, uv);
#else
    float2 halfTexel = 0.5 * gOutputSize.zw;
    float4 texels = float4(SAMPLE(gInFresh, uv - halfTexel).r, SAMPLE(gInFresh, uv + halfTexel).r,
                           SAMPLE(gInFresh, uv + float2(halfTexel.x, -halfTexel.y)).r,
                           SAMPLE(gInFresh, uv + float2(-halfTexel.x, halfTexel.y)).r);
#endif
    return abs(texels) <= MAX_COLOUR ? texels : 0.0;
}

// Whether `value` may be what sixteen fresh values are samples of, 1, or is not, 0.
float likenessOf(float value, float4 a, float4 b, float4 c, float4 d) {
    float mean = dot(a + b + c + d, 1.0 / 16.0);
    a -= mean;
    b -= mean;
    c -= mean;
    d -= mean;
    float deviation = sqrt(dot(a * a + b * b + c * c + d * d, 1.0 / 16.0));
    return saturate(2.0 - abs(value - mean) / max(gChange.x * deviation + gChange.y, 1e-4));
}

#if PACKED
// One of the two values of four packed texels.
float4 unpackFour(float4 texels, bool second) {
    float4 first = float4(unpackValues(texels.x).x, unpackValues(texels.y).x,
                          unpackValues(texels.z).x, unpackValues(texels.w).x);
    float4 other = float4(unpackValues(texels.x).y, unpackValues(texels.y).y,
                          unpackValues(texels.z).y, unpackValues(texels.w).y);
    return second ? other : first;
}
#endif

// An occluder that has gone leaves the depth as it was: the fresh values of 4x4 texels tell. Patterns repeat
// after 4x4 pixels, so that their mean is a good one.
float likeness(float2 uv, float2 values) {
    float4 a = readFour(uv - 0.5 * gOutputSize.zw);
    float4 b = readFour(uv + float2(1.5, -0.5) * gOutputSize.zw);
    float4 c = readFour(uv + float2(-0.5, 1.5) * gOutputSize.zw);
    float4 d = readFour(uv + 1.5 * gOutputSize.zw);
#if PACKED
    return min(likenessOf(values.x, unpackFour(a, false), unpackFour(b, false), unpackFour(c, false),
                          unpackFour(d, false)),
               likenessOf(values.y, unpackFour(a, true), unpackFour(b, true), unpackFour(c, true),
                          unpackFour(d, true)));
#else
    return likenessOf(values.x, a, b, c, d);
#endif
}

#endif

#endif // !HISTORY_NONE

// Value, 0, convergence and depth.
float4 cachedTexel(float2 uv) {
    float4 fresh = SAMPLE(gInFresh, uv);
    float depth = fresh.g > 0.0 && fresh.g < SKY_DEPTH ? fresh.g : SKY_DEPTH;
    float2 current = abs(fresh.r) <= MAX_COLOUR ? unpackValues(fresh.r) : 0.0;
#if HISTORY_NONE
    return float4(packValues(current), 0.0, 1.0, depth);
#else
    CachePlace place = findPlace(uv, depth);
    Cached history = readHistory(place.prevUv);

    float threshold = max(gMissThreshold.x + gMissThreshold.y * depth, 1e-6);
    float confidence = cacheHistoryWeight(place, history.depth, threshold, gConvergenceTime / threshold);
    confidence = gHistoryValid > 0.5 && all(abs(history.values) <= MAX_COLOUR) ? confidence : 0.0;
#if CHANGE_DETECTION
    confidence = confidence > 0.0 ? confidence * likeness(uv, history.values) : 0.0;
#endif

    float2 speed = (uv - place.prevUv) * gOutputSize.xy;
    float moving = velocityWeight(length(speed), gMaxWeight, gSpeedPx.x, gSpeedPx.y);
    float held = bounded(history.convergence, 0.0, MAX_CONVERGENCE) * confidence;
    float weight = min(convergenceWeight(held, gMaxWeight), moving);

    float2 values = exponentialHistory(history.values, current, weight);
    values = weight > 0.0 ? values : current;   // a history without weight may be anything
    return float4(packValues(values), 0.0, nextConvergence(history.convergence, confidence), depth);
#endif
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
