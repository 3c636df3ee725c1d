// SPDX-License-Identifier: Apache-2.0
// Soft shadows of the sun with few samples a frame, for the framework to accumulate. Drobot, 7.3 (D9, D10).
// gInCoarseDepth  linear depth in metres: coarse_depth.hlsli; at full resolution the frame's own
// gInShadowMap    R32F or D32F, depth from the sun in [0,1], in CASCADES equal columns. NaN shadows nothing
// gInOcclusion    VALUES other than one: gOutOcclusion of ambient_occlusion, at the same texels
// gOutShadow      RG16F: visibility [0,1] or packed pair; linear depth, metres. VALUES two: occlusion, shadow

#include "reprise/occlusion_shadow_packing.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer SunShadowParameters {
    float4 gOutputSize;      // width, height, 1 / width, 1 / height
    float4 gToShadowX;       // to x in texels of the first cascade's column
    float4 gToShadowY;       // to y in texels, down
    float4 gToShadowZ;       // to depth as the shadow map holds it
    float4 gCascadeScale1;   // xyz: from the first cascade to the second, times this,
    float4 gCascadeOffset1;  //      plus this
    float4 gCascadeScale2;   // to the third
    float4 gCascadeOffset2;
    float4 gCascadeScale3;   // to the fourth
    float4 gCascadeOffset3;
    float4 gCascadeFar;      // linear depth in metres at which each cascade ends, ascending
    float4 gCascadeSize;     // width and height of a column in texels; 1 / width and 1 / height of the map
    float3 gDisc;            // radius in texels of the first cascade, x and y; at least z texels in any
    float gFrameIndex;       // whole, see subsetOfFrame()
    float3 gShadowBias;      // depth of the first cascade, that a metre; steepest plane, in depth a texel
    float gSubsetCount;      // frames after which the pattern repeats, 1 to 16
};

TEXTURE_POINT(gInCoarseDepth, 1);
TEXTURE_POINT(gInShadowMap, 2);
#if !VALUES_ONE
TEXTURE_POINT(gInOcclusion, 3);
#endif

#include "passes/sun_shadow.hlsli"

float2 sunShadow(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
    DepthPlus depths = readDepthPlus(uv);
    float visibility = sunVisibility(uv, depths, positionPx);
#if VALUES_TWO
    return float2(SAMPLE(gInOcclusion, uv).r, visibility);
#elif VALUES_OCCLUSION_IN_INTEGER
    return float2(packOcclusionInInteger(SAMPLE(gInOcclusion, uv).r, visibility), depths.centre);
#elif VALUES_SHADOW_IN_INTEGER
    return float2(packShadowInInteger(SAMPLE(gInOcclusion, uv).r, visibility), depths.centre);
#else
    return float2(visibility, depths.centre);
#endif
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutShadow;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutShadow[thread.xy] = float4(sunShadow(float2(thread.xy) + 0.5), 0.0, 0.0);
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(sunShadow(positionPx.xy), 0.0, 0.0);
}

#endif
