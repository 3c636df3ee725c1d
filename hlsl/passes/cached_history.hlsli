// SPDX-License-Identifier: Apache-2.0
// What the history holds at a place, for accumulation.hlsli: values, the frames behind them, and how far they
// are believed to be of the surface that is looked for. Images by VALUES: cached_values.hlsli.
#ifndef REPRISE_CACHED_HISTORY_HLSLI
#define REPRISE_CACHED_HISTORY_HLSLI

#include "passes/cached_values.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection_cache.hlsli"

// A history that stands still lies texel on texel: there is nothing to filter.
#define READS_BETWEEN (RESAMPLING_BILINEAR && !HISTORY_STILL && !HISTORY_NONE)
// A filter between two packed numbers makes a third, which neither of them is: their texels are read one by
// one, and each is tested by its own depth.
#define READS_TEXELS (!HISTORY_NONE && (VALUES_WITH_FRAMES || (VALUES_PACKED && READS_BETWEEN)))
#if READS_TEXELS
TEXTURE_POINT(gHistoryCache, 3);
#if VALUES_WITH_FRAMES
TEXTURE_POINT(gHistoryCoarseDepth, 10);
#else
TEXTURE_LINEAR(gHistoryCacheStateFiltered, 6);
#endif
#elif READS_BETWEEN
TEXTURE_LINEAR(gHistoryCacheFiltered, 4);
TEXTURE_LINEAR(gHistoryCacheStateFiltered, 6);
#elif !HISTORY_NONE
TEXTURE_POINT(gHistoryCache, 3);
TEXTURE_POINT(gHistoryCacheState, 5);
#endif

struct Cached {
    CachedValues values;
    float frames;
    float confidence;   // that they are of the same surface, [0,1]
};

#if READS_TEXELS

struct FourTexels {
    float4 packed, depths, shares;   // shares: sum 1
};

// Those around the place, each with its share of a bilinear mean; or the one that it lies in, with all of it.
FourTexels readTexels(float2 uv) {
    FourTexels four;
#if READS_BETWEEN
    float2 position = uv * gOutputSize.xy - 0.5;
    float2 low = floor(position);
    float2 right = position - low, left = 1.0 - right;
    four.shares = float4(left.x, right.x, left.x, right.x) * float4(left.y, left.y, right.y, right.y);
#if HAS_GATHER
    float2 corner = (low + 1.0) * gOutputSize.zw;
    four.packed = GATHER_RED(gHistoryCache, corner).wzxy;
#if VALUES_WITH_FRAMES
    four.depths = GATHER_RED(gHistoryCoarseDepth, corner).wzxy;
#else
    four.depths = GATHER_GREEN(gHistoryCache, corner).wzxy;
#endif
#else
    [unroll] for (int i = 0; i < 4; ++i) {
        float2 texelUv = (low + float2(float(i % 2), float(i / 2)) + 0.5) * gOutputSize.zw;
        four.packed[i] = SAMPLE(gHistoryCache, texelUv).r;
#if VALUES_WITH_FRAMES
        four.depths[i] = SAMPLE(gHistoryCoarseDepth, texelUv).r;
#else
        four.depths[i] = SAMPLE(gHistoryCache, texelUv).g;
#endif
    }
#endif
#else
    four.packed = SAMPLE(gHistoryCache, uv).r;
    four.depths = SAMPLE(gHistoryCoarseDepth, uv).r;
    four.shares = float4(1.0, 0.0, 0.0, 0.0);
#endif
    return four;
}

// The mean of the texels that show the surface: one of another beside it takes nothing from their frames.
Cached readHistory(CachePlace place, float threshold) {
    FourTexels four = readTexels(place.prevUv);
    float4 confidence = cacheHistoryWeight(place, four.depths, threshold, gConvergenceTime / threshold);
#if VALUES_WITH_FRAMES
    VisibilitiesOfFour held = unpackWithFrames(four.packed);
    confidence *= held.usable;
#else
    confidence = abs(four.packed) <= MAX_COLOUR ? confidence : 0.0;
#endif
    float4 shares = four.shares * confidence;
    shares *= 1.0 / max(dot(shares, 1.0), 1e-6);
    Cached history;
    history.confidence = dot(shares, confidence);
#if VALUES_WITH_FRAMES
    history.values = float2(dot(shares, held.occlusion), dot(shares, held.shadow));
    history.frames = dot(shares, held.frames);
#else
    history.values = sumOfPacked(four.packed, shares);
    history.frames = bounded(SAMPLE(gHistoryCacheStateFiltered, place.prevUv).r, 0.0, MAX_CONVERGENCE);
#endif
    return history;
}

#elif !HISTORY_NONE

// The filtered mean of all four, as of one surface if their mean depth is.
Cached readHistory(CachePlace place, float threshold) {
#if READS_BETWEEN
    float4 texel = SAMPLE(gHistoryCacheFiltered, place.prevUv);
    float4 state = SAMPLE(gHistoryCacheStateFiltered, place.prevUv);
#else
    float4 texel = SAMPLE(gHistoryCache, place.prevUv);
    float4 state = SAMPLE(gHistoryCacheState, place.prevUv);
#endif
    Cached history;
    history.values = unpackValues(texel);
    history.frames = bounded(state.r, 0.0, MAX_CONVERGENCE);
    history.confidence =
        cacheHistoryWeight(place, depthOf(texel, state), threshold, gConvergenceTime / threshold);
    return history;
}

#endif

#endif
