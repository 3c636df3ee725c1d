// SPDX-License-Identifier: Apache-2.0
// Depth from the sun, one cascade a draw. Switches: SKINNED, ALPHA_TEST.
#include "scene_common.hlsli"

struct Varyings {
    float4 positionPx : SV_Position;
#if ALPHA_TEST
    [[vk::location(0)]] float2 uv : TEXCOORD0;
#endif
};

Varyings mainVertex(VertexInput input) {
    float4 position = float4(input.position, 1.0);
#if SKINNED
    position = mul(position, skinMatrix(gIdentity.y, input.joints, input.weights));
#endif
    Varyings output;
    output.positionPx = mul(mul(position, gObjectToWorld), gWorldToLightClip[gRender.cascade]);
#if ALPHA_TEST
    output.uv = input.uv;
#endif
    return output;
}

#if ALPHA_TEST
void mainFragment(Varyings input) {
    if (gAlpha.Sample(gAlpha_sampler, input.uv).a * gBaseColour.a < gAlphaCutoff.x) discard;
}
#endif
