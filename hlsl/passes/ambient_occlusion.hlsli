// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of a texel, for ambient_occlusion and lighting_cache, which declare gInCoarseDepth,
// gInNormal and the parameters.
//
// A sample is a point within gRadius over the surface, directions distributed as the cosine to the normal and
// distances as the root of a uniform number: a blocker at distance d counts 1 - (d / gRadius)^2 in the mean.
// It is occluded where the depth buffer lies in front of it, by gOcclusionBias and not by more than twice the
// radius. Each of 4x4 pixels turns the directions and shifts the distances of gTaps, the same for all pixels
// of a frame.
#ifndef REPRISE_AMBIENT_OCCLUSION_HLSLI
#define REPRISE_AMBIENT_OCCLUSION_HLSLI

#include "passes/coarse_depth.hlsli"
#include "passes/sample_count.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/sample_pattern.hlsli"

#if !NORMALS_READ

// With the ray r = (x, y, 1) of the texel, a step of e along x to depth z changes the place by r dz plus
// (e z, 0, 0), one along y alike. What is at right angles to both, towards the camera, is (gx, gy, -1 - rx gx
// - ry gy) of g = dz / (e z); of parallel rays (gx, gy, -1) of g = dz / e.
float3 reconstructedNormal(float2 uv, DepthPlus d) {
    bool2 hasBefore = hasTexelBefore(uv), hasAfter = hasTexelAfter(uv);
    float2 across = changeOfDepth(d.left, d.centre, d.right, hasBefore.x, hasAfter.x);
    float2 down = changeOfDepth(d.up, d.centre, d.down, hasBefore.y, hasAfter.y);
    float2 step = gViewRay.xy * gOutputSize.zw;
#if ORTHOGRAPHIC
    float3 normal = float3(float2(across.x, down.x) / step, -1.0);
#else
    float2 slope = float2(across.x, down.x) / (step * float2(across.y, down.y));
    float3 normal = float3(slope, -1.0 - dot(uv * gViewRay.xy + gViewRay.zw, slope));
#endif
    return normalize(normal);
}

#else

// Of one pixel of the texel: its centre lies on a corner of the frame's texels, and an eighth before it a
// texel is met for any ratio. A normal that is none faces the camera.
float3 readNormal(float2 uv) {
    float3 normal = SAMPLE(gInNormal, (uv - 0.125 * gOutputSize.zw) / gFrameToCoarse).xyz;
    float lengthSquared = dot(normal, normal);
    return lengthSquared > 1e-6 && lengthSquared < 1e6 ? normal * rsqrt(lengthSquared)
                                                       : float3(0.0, 0.0, -1.0);
}

#endif

struct Frame {
    float3 tangent, bitangent;
};

Frame frameOf(float3 normal) {
    float side = normal.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + normal.z);
    float b = normal.x * normal.y * a;
    Frame frame;
    frame.tangent = float3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x);
    frame.bitangent = float3(b, side + normal.y * normal.y * a, -normal.y);
    return frame;
}

// A way in view space, as it changes (u z, v z, z) of a place with the UV (u, v) and depth z, or (u, v, z) of
// parallel rays: so a sample's UV takes one division.
float3 toScreen(float3 way, float2 perRay) {
#if ORTHOGRAPHIC
    return float3(way.xy * perRay, way.z);
#else
    return float3((way.xy - gViewRay.zw * way.z) * perRay, way.z);
#endif
}

// How far the sample is occluded, in [0,1], and 1; or 0 and 0 where the image knows nothing of its place.
float2 checkSample(float3 screen, float perBias, float perRadius) {
#if ORTHOGRAPHIC
    float2 uv = screen.xy;
#else
    float2 uv = screen.xy * (1.0 / screen.z);
#endif
    bool isKnown = screen.z > 0.0 && isInsideUv(uv);
#if HALF_DEPTH
    float inFront = screen.z - knownDepth(SAMPLE(gInHalfDepth, uv).r);
#else
    float inFront = screen.z - readDepth(uv);
#endif
    float occluded = saturate(inFront * perBias - 1.0) * saturate(2.0 - inFront * perRadius);
    return isKnown ? float2(occluded, 1.0) : float2(0.0, 0.0);
}

float visibilityAround(float2 uv, float depth, float3 normal, float2 positionPx) {
    float2 offsets = pixelOffsets(floor(positionPx));
    float2 turned = float2(cos(FULL_TURN * offsets.x), sin(FULL_TURN * offsets.x));
    float perBias = 1.0 / max(gOcclusionBias.x + gOcclusionBias.y * depth, 1e-6);
    float2 perRay = 1.0 / gViewRay.xy;
#if ORTHOGRAPHIC
    float3 centre = float3(uv, depth);
#else
    float3 centre = float3(uv * depth, depth);
#endif
    Frame frame = frameOf(normal);
    float3 tangent = toScreen(gRadius * (turned.x * frame.tangent + turned.y * frame.bitangent), perRay);
    float3 bitangent = toScreen(gRadius * (turned.x * frame.bitangent - turned.y * frame.tangent), perRay);
    float3 up = toScreen(gRadius * normal, perRay);

    float2 sum = float2(0.0, 0.0);
    [unroll] for (int tap = 0; tap < SAMPLE_COUNT; ++tap) {
        float4 sampled = gTaps[tap];
        float3 way = sampled.x * tangent + sampled.y * bitangent + sampled.z * up;
        sum += checkSample(centre + sqrt(frac(sampled.w + offsets.y)) * way, perBias, 1.0 / gRadius);
    }
    return 1.0 - sum.x / max(sum.y, 1.0);
}

// Visibility in [0,1] at a texel, 1 where nothing occludes and in the sky. NORMALS read: of the depths the
// centre's alone counts.
float ambientVisibility(float2 uv, DepthPlus depths, float2 positionPx) {
#if NORMALS_READ
    float3 normal = readNormal(uv);
#else
    float3 normal = reconstructedNormal(uv, depths);
#endif
    float visibility = visibilityAround(uv, depths.centre, normal, positionPx);
    return depths.centre < SKY_DEPTH ? visibility : 1.0;
}

#endif
