// SPDX-License-Identifier: Apache-2.0
// Depth from the sun, one cascade a draw. Switches: SKINNED, ALPHA_TEST.
#include "scene_common.hlsli"

struct Varyings {
    float4 positionPx : SV_Position;
#if ALPHA_TEST
    [[vk::location(0)]] float2 uv : TEXCOORD0;
    [[vk::location(1)]] nointerpolation uint instance : TEXCOORD1;
#endif
};

Varyings mainVertex(VertexInput input) {
    InstanceData instance = gInstances[input.instance];
    float4 position = float4(input.position, 1.0);
#if SKINNED
    position = mul(position, skinMatrix(instance.identity.y, input.joints, input.weights));
#endif
    Varyings output;
    output.positionPx = mul(mul(position, instance.objectToWorld), gWorldToLightClip[gRender.cascade]);
#if ALPHA_TEST
    output.uv = input.uv;
    output.instance = input.instance;
#endif
    return output;
}

#if ALPHA_TEST
void mainFragment(Varyings input) {
    InstanceData instance = gInstances[input.instance];
    if (gAlbedo.Sample(gAlbedo_sampler, input.uv).a * instance.baseColour.a < instance.alphaCutoff.x) discard;
}
#endif
