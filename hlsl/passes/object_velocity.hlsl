// SPDX-License-Identifier: Apache-2.0
// Motion of moving objects, drawn over the motion of the camera. INSIDE I2, "Reprojection of dynamic scenes".
//
// position      object space, metres, float3; with SKINNING the bind pose
// joints        SKINNING: four indices into the palettes; weights: their weights, which sum to 1
// gInJoints     SKINNING: bind pose to world, this frame; gInPrevJoints the frame before. In Direct3D 9 they
//               are constants, 30 joints each
// gOutVelocity  RG16F, UV, currUv - prevUv without jitter
// Depth is tested against the scene's, which was drawn with the same jittered projection.

#include "reprise/conventions.hlsli"
#include "reprise/half_pixel.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection.hlsli"

BINDING(0) cbuffer ObjectVelocityParameters {
    row_major float4x4 gObjectToClip;          // this frame, unjittered; with SKINNING world to clip
    row_major float4x4 gPrevObjectToClip;      // the frame before, unjittered
    float2 gJitterNdc;                         // of this frame: what the jittered projection adds in NDC
};

TARGET_SIZE(gOutputSize);

#if SKINNING
struct Joint {
    row_major float4x4 toWorld;
};
PALETTE(gInJoints, Joint, 2);
PALETTE(gInPrevJoints, Joint, 3);
#endif

struct VertexInput {
    LOCATION(0) float3 position : POSITION;
#if SKINNING
    LOCATION(1) uint4 joints : BLENDINDICES;
    LOCATION(2) float4 weights : BLENDWEIGHT;
#endif
};

struct Varyings {
    float4 positionPx : SV_Position;
    LOCATION(0) float4 positionCS : TEXCOORD0;
    LOCATION(1) float4 prevPositionCS : TEXCOORD1;
};

#if SKINNING
float4 skin(PALETTE_PARAMETER(palette, Joint), uint4 joints, float4 weights, float4 position) {
    return weights.x * transform(palette[joints.x].toWorld, position) +
           weights.y * transform(palette[joints.y].toWorld, position) +
           weights.z * transform(palette[joints.z].toWorld, position) +
           weights.w * transform(palette[joints.w].toWorld, position);
}
#endif

Varyings mainVertex(VertexInput input) {
    float4 position = float4(input.position, 1.0);
    float4 prevPosition = position;
#if SKINNING
    position = skin(gInJoints, input.joints, input.weights, position);
    prevPosition = skin(gInPrevJoints, input.joints, input.weights, prevPosition);
#endif
    Varyings output;
    output.positionCS = transform(gObjectToClip, position);
    output.prevPositionCS = transform(gPrevObjectToClip, prevPosition);
    output.positionPx = output.positionCS;
    output.positionPx.xy += gJitterNdc * output.positionCS.w;
    output.positionPx = halfPixelOffset(output.positionPx, gOutputSize.zw);
    return output;
}

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(Varyings input) : SV_Target0 {
    return float4(motionFromClip(input.positionCS, input.prevPositionCS), 0.0, 0.0);
}
