// SPDX-License-Identifier: Apache-2.0
// Visibility of the sun at a texel, for sun_shadow and lighting_cache, which declare gInCoarseDepth,
// gInShadowMap and the parameters. Drobot, 7.3, "Soft Shadows" (D9): a percentage closer filter that takes "a
// different sample from a well-distributed sample set" each frame.
//
// Every cascade looks along the sun's direction, so each is the first one scaled and moved: six numbers of a
// further cascade in place of twelve. The rows of gToShadow take (u d, v d, d, 1) of a texel's uv and depth d
// there, and with ORTHOGRAPHIC (u, v, d, 1): the view rays and the matrix in one.
//
// A sample is a shadow texel within a disc around the point. Compared with it is the plane of the surface,
// taken at the centre of that texel: a plane does not shadow itself whatever its tilt, and what stands over
// it by more than gShadowBias shadows it. One depth for all samples would take a bias that grows with the
// disc.
#ifndef REPRISE_SUN_SHADOW_HLSLI
#define REPRISE_SUN_SHADOW_HLSLI

#include "passes/coarse_depth.hlsli"
#include "passes/sample_count.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/sample_pattern.hlsli"

// The additive sequence frac(1/2 + k SHADOW_SEQUENCE), k = 0, 1, ...: inverse powers of the root of x^3 = x +
// 1. Every run of it is spread evenly over the square: the samples of a frame, and those of all frames
// together.
static const float2 SHADOW_SEQUENCE = float2(0.7548776662, 0.5698402910);
// Texels squared; below it the surface is seen or lit along itself, and its plane is gShadowBias.z steep.
static const float SMALLEST_AREA = 1e-20;

// What the rows of gToShadow take, its constant apart.
float3 screenPosition(float2 uv, float depth) {
#if ORTHOGRAPHIC
    return float3(uv, depth);
#else
    return float3(uv * depth, depth);
#endif
}

// The way over the surface to the next texel along step, as the rows take it. Taken from the change of depth
// and the depth it leads to, not from two positions, which are far larger than their difference.
float3 surfaceStep(float2 uv, float2 step, float2 change) {
#if ORTHOGRAPHIC
    return float3(step, change.x);
#else
    return float3(uv * change.x + step * change.y, change.x);
#endif
}

float3 toFirstCascade(float3 screen) {
    return float3(dot(gToShadowX.xyz, screen), dot(gToShadowY.xyz, screen), dot(gToShadowZ.xyz, screen));
}

// Depth from the sun that the plane of the surface gains a texel of the first cascade, in x and y.
float2 surfaceSlope(float2 uv, DepthPlus d) {
    bool2 hasBefore = hasTexelBefore(uv), hasAfter = hasTexelAfter(uv);
    float2 changeX = changeOfDepth(d.left, d.centre, d.right, hasBefore.x, hasAfter.x);
    float2 changeY = changeOfDepth(d.up, d.centre, d.down, hasBefore.y, hasAfter.y);
    float3 across = toFirstCascade(surfaceStep(uv, float2(gOutputSize.z, 0.0), changeX));
    float3 down = toFirstCascade(surfaceStep(uv, float2(0.0, gOutputSize.w), changeY));
    float3 normal = cross(across, down);
    float area = abs(normal.z) > SMALLEST_AREA ? normal.z : SMALLEST_AREA;
    return clamp(-normal.xy / area, -gShadowBias.z, gShadowBias.z);
}

struct Cascade {
    float3 scale, offset;   // from the first
    float index, farDepth;  // of the last one
};

// The cascade behind `nearer` where that one has ended. All are read and one is taken: a read at an index of
// its own for each pixel costs more where it exists.
Cascade following(Cascade nearer, float depth, float3 scale, float3 offset, float farDepth) {
    bool hasEnded = depth > nearer.farDepth;
    Cascade cascade;
    cascade.scale = hasEnded ? scale : nearer.scale;
    cascade.offset = hasEnded ? offset : nearer.offset;
    cascade.index = nearer.index + (hasEnded ? 1.0 : 0.0);
    cascade.farDepth = farDepth;
    return cascade;
}

Cascade cascadeAt(float depth) {
    Cascade cascade;
    cascade.scale = float3(1.0, 1.0, 1.0);
    cascade.offset = float3(0.0, 0.0, 0.0);
    cascade.index = 0.0;
    cascade.farDepth = gCascadeFar.x;
#if !CASCADES_1
    cascade = following(cascade, depth, gCascadeScale1.xyz, gCascadeOffset1.xyz, gCascadeFar.y);
#endif
#if CASCADES_3 || CASCADES_4
    cascade = following(cascade, depth, gCascadeScale2.xyz, gCascadeOffset2.xyz, gCascadeFar.z);
#endif
#if CASCADES_4
    cascade = following(cascade, depth, gCascadeScale3.xyz, gCascadeOffset3.xyz, gCascadeFar.w);
#endif
    return cascade;
}

// Whether the shadow map stands before `depth` by more than the bias. What lies beyond the map's range is
// compared with its end, where nothing was drawn.
float isOccluded(float mapDepth, float depth, float bias) {
#if SHADOW_REVERSED
    return mapDepth > max(depth, 0.0) + bias ? 1.0 : 0.0;
#else
    return mapDepth < min(depth, 1.0) - bias ? 1.0 : 0.0;
#endif
}

// place and slope: of the surface in the first cascade.
float shadowVisibility(float3 place, float2 slope, float depth, float2 positionPx) {
    Cascade cascade = cascadeAt(depth);
    place = place * cascade.scale + cascade.offset;
    slope *= cascade.scale.z / cascade.scale.xy;
    float2 radius = max(gDisc.xy * cascade.scale.xy, gDisc.z);
    float bias = (gShadowBias.x + gShadowBias.y * depth) * cascade.scale.z;
    float2 lastTexel = gCascadeSize.xy - 0.5;
    float column = cascade.index * gCascadeSize.x;

    float2 offsets = pixelOffsets(floor(positionPx));
    float2 shift = subsetOfFrame(gFrameIndex, gSubsetCount) * frac(float(SAMPLE_COUNT) * SHADOW_SEQUENCE);
    float turn = FULL_TURN * (shift.x + offsets.x);
    float2 turned = float2(cos(turn), sin(turn));
    float areaShift = shift.y + offsets.y;

    float occluded = 0.0;
    [unroll] for (int tap = 0; tap < SAMPLE_COUNT; ++tap) {
        float2 own = frac(0.5 + float(tap) * SHADOW_SEQUENCE);
        float2 azimuth = float2(cos(FULL_TURN * own.x), sin(FULL_TURN * own.x));
        azimuth = float2(azimuth.x * turned.x - azimuth.y * turned.y,
                         azimuth.x * turned.y + azimuth.y * turned.x);
        float2 texel = floor(place.xy + radius * sqrt(frac(own.y + areaShift)) * azimuth) + 0.5;
        // Not into another cascade's column.
        texel = clamp(texel, 0.5, lastTexel);
        float mapDepth = SAMPLE(gInShadowMap, float2(texel.x + column, texel.y) * gCascadeSize.zw).r;
        occluded += isOccluded(mapDepth, place.z + dot(slope, texel - place.xy), bias);
    }
    bool isCovered = isInsideUv(place.xy / gCascadeSize.xy) && depth <= cascade.farDepth;
    return isCovered ? 1.0 - occluded / float(SAMPLE_COUNT) : 1.0;
}

// Visibility of the sun in [0,1] at a texel, 1 in the sky and beyond the last cascade.
float sunVisibility(float2 uv, DepthPlus depths, float2 positionPx) {
    float depth = depths.centre;
    float3 place = toFirstCascade(screenPosition(uv, depth)) +
                   float3(gToShadowX.w, gToShadowY.w, gToShadowZ.w);
    float visibility = shadowVisibility(place, surfaceSlope(uv, depths), depth, positionPx);
    return depth < SKY_DEPTH ? visibility : 1.0;
}

#endif
