// SPDX-License-Identifier: Apache-2.0
// One direction of the bilateral blur: across, then down, each a run of this pass. Wronski, "two passes of
// bilateral blur" (W4): value and depth come in one texel, so a tap is one read.
//
// gInObscurance          RGBA8, gOutObscurance, or gOutFilteredObscurance of the other direction. Read texel
//                        by texel: a linear filter would mix digits
// gOutFilteredObscurance RGBA8, the same four: the value filtered, depth and frames of the texel itself
// A Gaussian of nine taps, each times a weight that falls from 1 at equal depths to 0 at gDepthRange, which
// leaves the other side of an edge out altogether.

#include "reprise/coordinates.hlsli"
#include "reprise/occlusion_depth_packing.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer ObscuranceFilterParameters {
    float4 gOutputSize;    // width, height, 1 / width, 1 / height
    float2 gDirection;     // from a tap to the next, texels: (1, 0) then (0, 1), or (2, 0) then (0, 2)
    float2 gDepthRange;    // metres, and metres per metre of depth, from which on a tap has no weight
    float gFarDepth;       // metres, as scalable_obscurance had it
};

TEXTURE_POINT(gInObscurance, 1);

static const int RADIUS = 4;
// exp(-i i / 8): a standard deviation of two taps, which a radius of four holds 98 % of.
static const float GAUSSIAN[RADIUS + 1] = { 1.0, 0.8824969, 0.6065307, 0.3246525, 0.1353353 };

// Weighted value and weight of the texel i taps off.
float2 weighted(OcclusionDepth centre, float2 uv, float perRange, int i) {
    OcclusionDepth tap = unpackFineOcclusionDepth(SAMPLE(gInObscurance, uv), gFarDepth);
    float apart = abs(tap.linearDepth - centre.linearDepth) * perRange;
    float weight = GAUSSIAN[i] * max(1.0 - apart, 0.0);
    return float2(weight * tap.occlusion, weight);
}

float4 filteredTexel(float2 uv) {
    float2 step = gDirection * gOutputSize.zw;
    OcclusionDepth centre = unpackFineOcclusionDepth(SAMPLE(gInObscurance, uv), gFarDepth);
    float perRange = 1.0 / max(gDepthRange.x + gDepthRange.y * centre.linearDepth, 1e-6);

    float2 sum = float2(centre.occlusion, 1.0) * GAUSSIAN[0];
    [unroll] for (int i = 1; i <= RADIUS; ++i) {
        sum += weighted(centre, uv - float(i) * step, perRange, i);
        sum += weighted(centre, uv + float(i) * step, perRange, i);
    }
    centre.occlusion = sum.x / sum.y;
    return packFineOcclusionDepth(centre, gFarDepth, 0.5);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutFilteredObscurance;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutFilteredObscurance[thread.xy] = filteredTexel(pxToUv(float2(thread.xy) + 0.5, gOutputSize.zw));
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return filteredTexel(pxToUv(positionPx.xy, gOutputSize.zw));
}

#endif
