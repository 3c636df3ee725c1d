// SPDX-License-Identifier: Apache-2.0
// One direction of the bilateral filter: across, then down, each a run of this pass. Drobot, "Bilateral
// Filtering", Listing 7.3 (D6); stronger where the history holds few frames, step 6 of the framework (D7).
//
// gInCache          RGBA16F: value, 0, convergence in frames, linear depth in metres. VALUES other than one:
//                   occlusion and shadow in the first, see occlusion_shadow_packing.hlsli
// gInCacheFiltered  the same image under a linear filter, for the taps (TAPS linear, one value)
// gOutFiltered      RGBA16F: the same four, the value filtered. Depth and convergence are the texel's own, so
//                   that the next direction, the upsampling and the next frame's cache find them
// What is packed never passes a linear filter: it is read texel by texel, whatever TAPS says. A value that is
// NaN or beyond MAX_COLOUR is filled from its neighbours.

#include "reprise/conventions.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/directional_bilateral.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/occlusion_shadow_packing.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer BilateralFilterParameters {
    float4 gOutputSize;      // width, height, 1 / width, 1 / height
    float2 gDirection;       // (1, 0) or (0, 1)
    float2 gDepthAmplitude;  // of depth differences: 1 / metres, and per share of the depth
    float gConverged;        // frames from which on the history is converged
    float gMaxSmoothing;     // times the listing's weight of the neighbours, 1 to 16, without history
    float gMinSmoothing;     // the same with a converged history, 0 to 1: 1 is the listing, 0 no filter
};

#if VALUES_ONE && TAPS_LINEAR
#define READS_TEXELS 0
#else
#define READS_TEXELS 1
#endif

TEXTURE_POINT(gInCache, 1);
#if !READS_TEXELS
TEXTURE_LINEAR(gInCacheFiltered, 2);
#endif

float2 unpackValues(float value) {
#if VALUES_OCCLUSION_IN_INTEGER
    return unpackOcclusionInInteger(value);
#elif VALUES_SHADOW_IN_INTEGER
    return unpackShadowInInteger(value);
#else
    return float2(value, 0.0);
#endif
}

float packValues(float2 values) {
#if VALUES_OCCLUSION_IN_INTEGER
    return packOcclusionInInteger(values.x, values.y);
#elif VALUES_SHADOW_IN_INTEGER
    return packShadowInInteger(values.x, values.y);
#else
    return values.x;
#endif
}

// What a history cannot hold becomes infinite, and is left out.
float3 tapOf(float4 texel) {
    float2 values = abs(texel.r) <= MAX_COLOUR ? unpackValues(texel.r) : 2.0 * LARGEST_TAP;
    return float3(values, texel.a);
}

// Stronger where the history is short, and depth compared by the metre and by the share of the distance.
float smoothingOf(float4 centre) {
    return smoothingOfConvergence(centre.b, gConverged, gMaxSmoothing) - 1.0 + gMinSmoothing;
}

float amplitudeOf(float4 centre) {
    return gDepthAmplitude.x + gDepthAmplitude.y / bounded(centre.a, 1e-3, SKY_DEPTH);
}

float4 filteredTexel(float2 uv) {
    float2 offSize = gDirection * gOutputSize.zw;
    // Of the texel alone: a filter's rounding would mix in its neighbours' frames and depths.
    float4 centre = SAMPLE(gInCache, uv);
#if READS_TEXELS
    PointTaps taps;
    taps.tap[4] = tapOf(centre);
    [unroll] for (int i = 1; i <= 4; ++i) {
        taps.tap[4 - i] = tapOf(SAMPLE(gInCache, uv - float(i) * offSize));
        taps.tap[4 + i] = tapOf(SAMPLE(gInCache, uv + float(i) * offSize));
    }
    float3 filtered = bilateralOfPointTaps(taps, amplitudeOf(centre), smoothingOf(centre));
#else
    LinearTaps taps;
    taps.tap[0] = tapOf(SAMPLE(gInCacheFiltered, uv - 3.5 * offSize));
    taps.tap[1] = tapOf(SAMPLE(gInCacheFiltered, uv - 1.5 * offSize));
    taps.tap[2] = tapOf(centre);
    taps.tap[3] = tapOf(SAMPLE(gInCacheFiltered, uv + 1.5 * offSize));
    taps.tap[4] = tapOf(SAMPLE(gInCacheFiltered, uv + 3.5 * offSize));
    float3 filtered = bilateralOfLinearTaps(taps, amplitudeOf(centre), smoothingOf(centre));
#endif
    return float4(packValues(filtered.xy), 0.0, bounded(centre.b, 0.0, MAX_CONVERGENCE),
                  min(filtered.z, SKY_DEPTH));
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutFiltered;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    gOutFiltered[thread.xy] = filteredTexel(pxToUv(float2(thread.xy) + 0.5, gOutputSize.zw));
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return filteredTexel(pxToUv(positionPx.xy, gOutputSize.zw));
}

#endif
