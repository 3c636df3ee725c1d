// SPDX-License-Identifier: Apache-2.0
// Motion of static geometry: where each fragment was under the previous camera, from depth alone.
// INSIDE I2 and I3, "Reprojection of static scenes"; Drobot, 7.3. Objects that move are drawn over it by
// object_velocity.
//
// gInDepth      R32F or D32F, device depth in [0,1] (any depth kind), or metres with DEPTH_LINEAR; rendered
//               with the jitter gJitterUv
// gOutVelocity  RG16F, UV, currUv - prevUv without jitter; at least 4 where the previous camera did not see
//               the point, so that the history lookup leaves the image

#include "reprise/conventions.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection.hlsli"

BINDING(0) cbuffer CameraVelocityParameters {
    row_major float4x4 gReprojection;  // NDC and device depth, or view space (DEPTH_LINEAR), to prev clip
    float4 gViewRay;                   // DEPTH_LINEAR: extent and origin of the view rays, see viewPosition()
    float4 gOutputSize;                // width, height, 1 / width, 1 / height
    float2 gJitterUv;                  // of this frame
};

TEXTURE_POINT(gInDepth, 1);

float2 cameraMotion(float2 uv, float depth) {
    float2 currUv = uv - gJitterUv;
#if DEPTH_LINEAR
    float2 prevUv = reprojectLinearDepth(currUv, depth, gViewRay, gReprojection);
#else
    float2 prevUv = reprojectDeviceDepth(currUv, depth, gReprojection);
#endif
    return currUv - prevUv;
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutVelocity;

[numthreads(16, 16, 1)]   // 8x8 take a GPU almost twice as long
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    float2 uv = pxToUv(float2(thread.xy) + 0.5, gOutputSize.zw);
    gOutVelocity[thread.xy] = float4(cameraMotion(uv, SAMPLE(gInDepth, uv).r), 0.0, 0.0);
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    float2 uv = pxToUv(positionPx.xy, gOutputSize.zw);
    return float4(cameraMotion(uv, SAMPLE(gInDepth, uv).r), 0.0, 0.0);
}

#endif
