// SPDX-License-Identifier: Apache-2.0
// One direction of the bilateral filter: across, then down, each a run of this pass. Drobot, "Bilateral
// Filtering", Listing 7.3 (D6); stronger where the history holds few frames, step 6 of the framework (D7).
//
// What the images hold by VALUES: cached_values.hlsli.
//
// gInCache           values of gOutCache, or gOutFiltered of the other direction
// gInCacheState      gOutCacheState: frames, which both directions leave be
// gInCacheFiltered, gInCacheStateFiltered   the same under a linear filter, for the taps (TAPS linear);
//                    unused where the compute form gathers them
// gOutFiltered       values, filtered. Depth beside them is the texel's own, so that the next direction and
//                    the next frame's cache find it
// What is packed never passes a linear filter: between two texels lies the mean of what both hold. A value
// that is NaN or beyond MAX_COLOUR is filled from its neighbours.

#include "passes/cached_values.hlsli"
#include "reprise/conventions.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/directional_bilateral.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer BilateralFilterParameters {
    float4 gOutputSize;      // width, height, 1 / width, 1 / height
    float2 gDirection;       // (1, 0) or (0, 1); in the fragment form and STEP any times any step
    float2 gDepthAmplitude;  // of depth differences: 1 / metres, and per share of the depth
    float gConverged;        // frames from which on the history is converged
    float gMaxSmoothing;     // times the listing's weight of the neighbours, 1 to 16, without history
    float gMinSmoothing;     // the same with a converged history, 0 to 1: 1 is the listing, 0 no filter
};

// Steps of one texel: four texels a thread, whose taps come by gathers, four texels a read.
#define GATHERS (STAGE_COMPUTE && STEP_ONE)
#define TAPS_FILTERED (TAPS_LINEAR && !VALUES_PACKED && !GATHERS)

TEXTURE_POINT(gInCache, 1);
#if TAPS_FILTERED
TEXTURE_LINEAR(gInCacheFiltered, 2);
#endif
TEXTURE_POINT(gInCacheState, 3);
#if TAPS_FILTERED && DEPTH_APART
TEXTURE_LINEAR(gInCacheStateFiltered, 4);
#endif

// Of a texel, or of a place between two.
struct Tap {
    CachedValues values;
    float depth;
};

Tap tapOf(float4 values, float4 state) {
    Tap tap;
    tap.values = unpackValues(values);
    tap.depth = depthOf(values, state);
    return tap;
}

Tap meanOf(Tap a, Tap b) {
    Tap tap;
    tap.values = 0.5 * (a.values + b.values);
    tap.depth = 0.5 * (a.depth + b.depth);
    return tap;
}

// Taps of Listing 7.3 halfway between two texels; or single texels, each with half of a tap's weight.
#if TAPS_LINEAR
static const int TAP_COUNT = 5;
static const float OFFSETS[TAP_COUNT] = { -3.5, -1.5, 0.0, 1.5, 3.5 };
static const float WEIGHTS[TAP_COUNT] = {
    BILATERAL_OUTER_WEIGHT, BILATERAL_INNER_WEIGHT, BILATERAL_CENTER_WEIGHT, BILATERAL_INNER_WEIGHT,
    BILATERAL_OUTER_WEIGHT
};
#else
static const int TAP_COUNT = 9;
static const float OFFSETS[TAP_COUNT] = { -4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0 };
static const float WEIGHTS[TAP_COUNT] = {
    0.5 * BILATERAL_OUTER_WEIGHT, 0.5 * BILATERAL_OUTER_WEIGHT, 0.5 * BILATERAL_INNER_WEIGHT,
    0.5 * BILATERAL_INNER_WEIGHT, BILATERAL_CENTER_WEIGHT,      0.5 * BILATERAL_INNER_WEIGHT,
    0.5 * BILATERAL_INNER_WEIGHT, 0.5 * BILATERAL_OUTER_WEIGHT, 0.5 * BILATERAL_OUTER_WEIGHT
};
#endif

// What gOutFiltered takes: the filter of directional_bilateral.hlsli, for any number of values.
// Stronger where the history is short, and depth compared by the metre and by the share of the distance. A
// tap that holds what no cache can is left out.
float4 filteredTexel(Tap taps[TAP_COUNT], float frames) {
    float centreDepth = taps[TAP_COUNT / 2].depth;
    float smoothing = smoothingOfConvergence(frames, gConverged, gMaxSmoothing) - 1.0 + gMinSmoothing;
    float amount = bounded(smoothing, 0.0, MAX_SMOOTHING);
    float amplitude = gDepthAmplitude.x + gDepthAmplitude.y / bounded(centreDepth, 1e-3, SKY_DEPTH);
    CachedValues sum = 0.0;
    float total = 0.0;
    [unroll] for (int i = 0; i < TAP_COUNT; ++i) {
        float weight = WEIGHTS[i];
        if (i != TAP_COUNT / 2) weight *= amount * depthSimilarity(taps[i].depth, centreDepth, amplitude);
        bool isUsable = areCacheable(taps[i].values);
        sum += isUsable ? weight * taps[i].values : 0.0;
        total += isUsable ? weight : 0.0;
    }
    CachedValues mean = total > 1e-30 ? sum * (1.0 / total) : 0.0;
    return packValues(mean, 0.0, bounded(centreDepth, 0.0, SKY_DEPTH));
}

#if !GATHERS

Tap readPlace(float2 uv) {
#if TAPS_FILTERED && DEPTH_APART
    return tapOf(SAMPLE(gInCacheFiltered, uv), SAMPLE(gInCacheStateFiltered, uv));
#elif TAPS_FILTERED
    return tapOf(SAMPLE(gInCacheFiltered, uv), 0.0);
#elif DEPTH_APART
    return tapOf(SAMPLE(gInCache, uv), SAMPLE(gInCacheState, uv));
#else
    return tapOf(SAMPLE(gInCache, uv), 0.0);
#endif
}

Tap readTap(float2 uv, float offset, float2 offSize) {
#if TAPS_LINEAR && VALUES_PACKED
    return meanOf(readPlace(uv + floor(offset) * offSize), readPlace(uv + ceil(offset) * offSize));
#else
    return readPlace(uv + offset * offSize);
#endif
}

float4 filteredTexel(float2 uv) {
    float2 offSize = gDirection * gOutputSize.zw;
    float4 state = SAMPLE(gInCacheState, uv);
    Tap taps[TAP_COUNT];
    // Of the texel alone: a filter's rounding would mix in its neighbours' frames and depths.
    taps[TAP_COUNT / 2] = tapOf(SAMPLE(gInCache, uv), state);
    [unroll] for (int i = 0; i < TAP_COUNT; ++i)
        if (i != TAP_COUNT / 2) taps[i] = readTap(uv, OFFSETS[i], offSize);
    return filteredTexel(taps, state.r);
}

#else

// The four texels around a corner: left and right below, right and left above.
void gatherTaps(float2 uv, out Tap taps[4]) {
    float4 red = GATHER_RED(gInCache, uv), green = GATHER_GREEN(gInCache, uv), blue = 0.0, alpha = 0.0;
    float4 depth = 0.0;
#if VALUES_FOUR
    blue = GATHER_BLUE(gInCache, uv);
    alpha = GATHER_ALPHA(gInCache, uv);
#endif
#if DEPTH_APART
    depth = GATHER_GREEN(gInCacheState, uv);
#endif
    [unroll] for (int i = 0; i < 4; ++i)
        taps[i] = tapOf(float4(red[i], green[i], blue[i], alpha[i]), float4(0.0, depth[i], 0.0, 0.0));
}

// Of ten texels in a row the taps of that with the index `centre`, 4 or 5.
float4 filteredOfLine(Tap texels[10], int centre, float frames) {
    Tap taps[TAP_COUNT];
    [unroll] for (int i = 0; i < TAP_COUNT; ++i) {
#if TAPS_LINEAR
        taps[i] = meanOf(texels[centre + int(floor(OFFSETS[i]))], texels[centre + int(ceil(OFFSETS[i]))]);
        if (i == TAP_COUNT / 2) taps[i] = texels[centre];
#else
        taps[i] = texels[centre + i - TAP_COUNT / 2];
#endif
    }
    return filteredTexel(taps, frames);
}

#endif

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutFiltered;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    int2 first = 2 * int2(thread.xy);
#if GATHERS
    // Two lines of ten texels: rows where the direction is across, else columns.
    bool isAcross = gDirection.x > gDirection.y;
    Tap near[10], far[10];
    [unroll] for (int i = 0; i < 5; ++i) {
        Tap taps[4];
        gatherTaps(pxToUv(float2(first) + 1.0 + float(2 * i - 4) * gDirection, gOutputSize.zw), taps);
        near[2 * i] = taps[3];
        far[2 * i + 1] = taps[1];
        if (isAcross) {
            near[2 * i + 1] = taps[2];
            far[2 * i] = taps[0];
        } else {
            near[2 * i + 1] = taps[0];
            far[2 * i] = taps[2];
        }
    }
    float4 frames = GATHER_RED(gInCacheState, pxToUv(float2(first) + 1.0, gOutputSize.zw));
    int2 along = isAcross ? int2(1, 0) : int2(0, 1);
    gOutFiltered[first] = filteredOfLine(near, 4, frames.w);
    gOutFiltered[first + along] = filteredOfLine(near, 5, isAcross ? frames.z : frames.x);
    gOutFiltered[first + along.yx] = filteredOfLine(far, 4, isAcross ? frames.x : frames.z);
    gOutFiltered[first + 1] = filteredOfLine(far, 5, frames.y);
#else
    [unroll] for (int i = 0; i < 4; ++i) {
        int2 texel = first + int2(i % 2, i / 2);
        gOutFiltered[texel] = filteredTexel(pxToUv(float2(texel) + 0.5, gOutputSize.zw));
    }
#endif
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return filteredTexel(pxToUv(positionPx.xy, gOutputSize.zw));
}

#endif
