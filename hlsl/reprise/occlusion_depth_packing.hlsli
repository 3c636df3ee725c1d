// SPDX-License-Identifier: Apache-2.0
// Occlusion and 16-bit depth in one RGBA8 texture: Wronski, "Algorithm overview", so that neither the
// bilateral blur nor the rejection of history fetches a depth of its own. Red is occlusion in 256 levels,
// green and blue the depth in two digits, alpha the convergence in frames (exponential_history.hlsli); of the
// fine form, frames and more bits of occlusion. Point filter only.
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

// The same texel for a history of weight w: 8 bits of occlusion stop at 1 / (2 (1-w)) levels from their
// target (history_write.hlsli), five at 0.9. Here alpha holds sixteenths of a level beside red's nearest one,
// and frames up to 15: what n / (n + 1) needs for weights up to 15/16.
static const float MAX_FINE_CONVERGENCE = 15.0;
// Steps of the fine occlusion: 16 a level.
static const float FINE_OCCLUSION_STEPS = 4080.0;

// noise in [0,1): 0.5 writes the nearest step; uniform, and different in each frame and pixel, the mean of
// what is written is data.occlusion. A step comes back exactly whatever the noise, which is held to
// [0.002, 0.998]. Error of occlusion 1/8160 at noise 0.5, else 1/4080. NaN is 0, as above; frames are whole,
// [0, 15].
float4 packFineOcclusionDepth(OcclusionDepth data, float farM, float noise) {
    float step = floor(bounded(data.occlusion, 0.0, 1.0) * FINE_OCCLUSION_STEPS +
                       bounded(noise, 0.002, 0.998));
    float level = floor((step + 8.0) / 16.0);
    float sixteenths = step + 8.0 - 16.0 * level;
    float frames = floor(bounded(data.convergence, 0.0, MAX_FINE_CONVERGENCE) + 0.5);
    float2 depth = packKey16(linearKeyFromDepth(data.linearDepth, 0.0, farM));
    float4 digits = channelsFromDigits(float4(level, 16.0 * frames + sixteenths, 0.0, 0.0));
    return float4(digits.x, depth, digits.y);
}

OcclusionDepth unpackFineOcclusionDepth(float4 texel, float farM) {
    float4 digits = digitsFromChannels(texel.raaa);
    OcclusionDepth data;
    data.convergence = floor(digits.y / 16.0);
    float step = 16.0 * (digits.x - data.convergence) + digits.y - 8.0;
    data.occlusion = bounded(step / FINE_OCCLUSION_STEPS, 0.0, 1.0);
    data.linearDepth = depthFromLinearKey(unpackKey16(texel.gb), 0.0, farM);
    return data;
}

#endif
