// SPDX-License-Identifier: Apache-2.0
// Occlusion and 16-bit depth in one RGBA8 texture: Wronski, "Algorithm overview", so that neither the
// bilateral blur nor the rejection of history fetches a depth of its own. Red is occlusion in 256 levels,
// green and blue the depth in two digits, alpha the convergence in frames (exponential_history.hlsli). Point
// filter only.
#ifndef REPRISE_OCCLUSION_DEPTH_PACKING_HLSLI
#define REPRISE_OCCLUSION_DEPTH_PACKING_HLSLI

#include "reprise/depth_encoding.hlsli"
#include "reprise/exponential_history.hlsli"

struct OcclusionDepth {
    float occlusion;        // [0,1], error 1/510
    float linearDepth;      // metres, error farM / 131070 up to farM; farM beyond it
    float convergence;      // frames, whole, [0, MAX_CONVERGENCE]
};

// linearDepth in metres, farM above 0: the depth from which on all is as far. What lies outside is clamped;
// NaN gives 0, a depth that no surface has, so that it is rejected in the next frame.
float4 packOcclusionDepth(OcclusionDepth data, float farM) {
    float2 depth = packKey16(linearKeyFromDepth(data.linearDepth, 0.0, farM));
    return float4(bounded(data.occlusion, 0.0, 1.0), depth, convergenceToUnorm8(data.convergence));
}

OcclusionDepth unpackOcclusionDepth(float4 texel, float farM) {
    OcclusionDepth data;
    data.occlusion = bounded(texel.r, 0.0, 1.0);
    data.linearDepth = depthFromLinearKey(unpackKey16(texel.gb), 0.0, farM);
    data.convergence = convergenceFromUnorm8(texel.a);
    return data;
}

#endif
