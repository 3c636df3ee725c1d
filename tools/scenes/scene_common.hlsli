// SPDX-License-Identifier: Apache-2.0
// Bindings that every shader of the scene renderer shares, and the light of the scene.
// Matrices are declared row_major and hold what GLM stores, so vectors stand on their left.
#ifndef SCENE_COMMON_HLSLI
#define SCENE_COMMON_HLSLI

static const uint NO_PALETTE = 0xffffffff;
static const float PI = 3.14159265;

[[vk::binding(0, 0)]] cbuffer FrameUniforms {
    row_major float4x4 gWorldToLightClip[3];   // of each cascade
    float4 gCascadeFar;                        // linear depth at which each cascade ends
    float4 gCascadeTexel;                      // side of a shadow texel in metres
    float4 gCameraWS;
    float4 gForwardWS;
    float4 gSunDirection;                      // towards the sun
    float4 gSunRadiance;                       // of a white diffuse surface that faces the sun
    float4 gSkyRadiance;
    float4 gGroundRadiance;
    float4 gRayWS[3];                          // ray = x * [0] + y * [1] + [2] of unjittered NDC
    float4 gSkyToPrevClip[3];                  // rows: (x, y, 1) of NDC to previous clip x, y, w at infinity
    float4 gLightPosition[4];
    float4 gLightIntensity[4];
    float4 gSize;                              // width, height and their inverses
    float4 gSkyDepth;                          // x: device depth at infinity
};

// One draw's part of the instances, at a dynamic offset: uniform, so it is read once and not per pixel.
[[vk::binding(1, 0)]] cbuffer InstanceData {
    row_major float4x4 gObjectToWorld;
    row_major float4x4 gObjectToClip;      // unjittered, as the next
    row_major float4x4 gPrevObjectToClip;
    float4 gNormalToWorld[3];              // columns
    float4 gBaseColour;
    float4 gEmission;                      // rgb; a is roughness
    float4 gAlphaCutoff;                   // x; y above 0: both sides are seen
    uint4 gIdentity;                       // instance + 1, first joint or NO_PALETTE
};

struct Joint {
    row_major float4x4 toWorld;
};
[[vk::binding(2, 0)]] StructuredBuffer<Joint> gJoints;
[[vk::binding(3, 0)]] StructuredBuffer<Joint> gPrevJoints;

[[vk::binding(6, 1)]] Texture2D gAlbedo;
[[vk::binding(7, 1)]] SamplerState gAlbedo_sampler;
// The same texels without sRGB decoding and from one mip, for alpha tests: cheaper on a CPU rasteriser.
[[vk::binding(8, 1)]] Texture2D gAlpha;
[[vk::binding(9, 1)]] SamplerState gAlpha_sampler;

struct RenderConstants {
    float2 jitterNdc;    // what the jittered projection adds to NDC
    float2 jitterPx;
    float lodBias;
    uint cascade;
};
[[vk::push_constant]] ConstantBuffer<RenderConstants> gRender;

struct VertexInput {
    [[vk::location(0)]] float3 position : POSITION;
    [[vk::location(1)]] float3 normal : NORMAL;
    [[vk::location(2)]] float2 uv : TEXCOORD0;
#if SKINNED
    [[vk::location(3)]] uint4 joints : BLENDINDICES;
    [[vk::location(4)]] float4 weights : BLENDWEIGHT;
#endif
};

#if SKINNED
// Two functions and not one with the buffer as parameter: glslang 12.0 crashes on that one.
float4x4 skinMatrix(uint first, uint4 joints, float4 weights) {
    return gJoints[first + joints.x].toWorld * weights.x + gJoints[first + joints.y].toWorld * weights.y +
           gJoints[first + joints.z].toWorld * weights.z + gJoints[first + joints.w].toWorld * weights.w;
}

float4x4 prevSkinMatrix(uint first, uint4 joints, float4 weights) {
    return gPrevJoints[first + joints.x].toWorld * weights.x +
           gPrevJoints[first + joints.y].toWorld * weights.y +
           gPrevJoints[first + joints.z].toWorld * weights.z +
           gPrevJoints[first + joints.w].toWorld * weights.w;
}
#endif

float3 skyColour(float3 direction) {
    float3 zenith = gSkyRadiance.rgb * float3(0.55, 0.75, 1.0);
    float3 horizon = gSkyRadiance.rgb * 1.5 + dot(gSkyRadiance.rgb, float3(0.2, 0.2, 0.2));
    float up = direction.y;
    float3 above = lerp(horizon, zenith, sqrt(saturate(up)));
    return lerp(gGroundRadiance.rgb, above, smoothstep(-0.08, 0.0, up));
}

#endif
