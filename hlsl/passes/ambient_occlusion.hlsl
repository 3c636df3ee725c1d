// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion of the screen with few samples a frame, for the framework to accumulate. Drobot, 7.3,
// "Screen-Space Ambient Occlusion" (D8): occlusion checks that sample the depth buffer around the point.
//
// gInCoarseDepth   R32F, linear depth in metres of depth_downsample; SKY_DEPTH and beyond, and what is no
//                  depth, is sky
// gInNormal        NORMALS read: view space, towards the camera, of any length but 0; of the whole frame
// gOutOcclusion    RG16F: visibility in [0,1], 1 where nothing occludes and in the sky; linear depth, metres

#include "reprise/platform.hlsli"

BINDING(0) cbuffer AmbientOcclusionParameters {
    float4 gOutputSize;    // width, height, 1 / width, 1 / height
    float4 gViewRay;       // extent and origin of the view rays over this image, see viewPosition()
    float2 gOcclusionBias; // metres, and metres per metre of depth, by which a surface must lie in front
    float2 gFrameToCoarse; // NORMALS read: frame / (ratio * coarse extent), of UV
    float gRadius;         // metres, above 0
    float4 gTaps[32];      // of this frame, SAMPLES of them: reprise::occlusionTaps()
};

TEXTURE_POINT(gInCoarseDepth, 1);
#if NORMALS_READ
TEXTURE_POINT(gInNormal, 2);
#endif

#include "passes/ambient_occlusion.hlsli"

// Visibility and linear depth.
float2 ambientOcclusion(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
#if NORMALS_READ
    DepthPlus depths = depthAlone(readDepth(uv));
#else
    DepthPlus depths = readDepthPlus(uv);
#endif
    return float2(ambientVisibility(uv, depths, positionPx), depths.centre);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutOcclusion;

// Wide groups: samples lie up to gRadius away, and more of them in what the group has read.
[numthreads(32, 32, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutOcclusion[thread.xy] = float4(ambientOcclusion(float2(thread.xy) + 0.5), 0.0, 0.0);
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(ambientOcclusion(positionPx.xy), 0.0, 0.0);
}

#endif
