// SPDX-License-Identifier: Apache-2.0
// Reads of gInCoarseDepth, which the pass declares beside gOutputSize: linear depth in metres. SKY_DEPTH and
// beyond, and what is no depth, is sky.
#ifndef REPRISE_COARSE_DEPTH_HLSLI
#define REPRISE_COARSE_DEPTH_HLSLI

#include "reprise/depth.hlsli"
#include "reprise/platform.hlsli"

float knownDepth(float depth) {
    return depth > 0.0 ? min(depth, SKY_DEPTH) : SKY_DEPTH;
}

float readDepth(float2 uv) {
    return knownDepth(SAMPLE(gInCoarseDepth, uv).r);
}

// Depths at the texel and beside it.
struct DepthPlus {
    float centre, left, right, up, down;
};

// Where nothing asks for the texels beside.
DepthPlus depthAlone(float depth) {
    DepthPlus d;
    d.centre = d.left = d.right = d.up = d.down = depth;
    return d;
}

DepthPlus readDepthPlus(float2 uv) {
    DepthPlus d;
#if HAS_GATHER
    float4 leftUp = GATHER_RED(gInCoarseDepth, uv - 0.5 * gOutputSize.zw);
    float4 rightDown = GATHER_RED(gInCoarseDepth, uv + 0.5 * gOutputSize.zw);
    d.centre = knownDepth(leftUp.y);
    d.left = knownDepth(leftUp.x);
    d.up = knownDepth(leftUp.z);
    d.right = knownDepth(rightDown.z);
    d.down = knownDepth(rightDown.x);
#else
    d.centre = readDepth(uv);
    d.left = readDepth(uv - float2(gOutputSize.z, 0.0));
    d.up = readDepth(uv - float2(0.0, gOutputSize.w));
    d.right = readDepth(uv + float2(gOutputSize.z, 0.0));
    d.down = readDepth(uv + float2(0.0, gOutputSize.w));
#endif
    return d;
}

// How far depth changes to the next texel, and the depth on the farther side: from the side whose depth is
// nearer to the centre's, for the other one may lie on another surface. Beyond a border there is no side; an
// image of one texel has the texel itself there.
float2 changeOfDepth(float before, float centre, float after, bool hasBefore, bool hasAfter) {
    float differenceBefore = hasBefore ? abs(before - centre) : 2.0 * SKY_DEPTH;
    float differenceAfter = hasAfter ? abs(after - centre) : SKY_DEPTH;
    return differenceBefore < differenceAfter ? float2(centre - before, before)
                                              : float2(after - centre, after);
}

// Whether there is a texel before this one, and behind it, along either axis.
bool2 hasTexelBefore(float2 uv) {
    return uv > gOutputSize.zw;
}

bool2 hasTexelAfter(float2 uv) {
    return uv < 1.0 - gOutputSize.zw;
}

#endif
