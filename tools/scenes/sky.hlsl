// SPDX-License-Identifier: Apache-2.0
// The sky behind everything: a triangle over the whole picture at the depth of infinity.
// Its motion is that of points infinitely far away: the rotation of the camera alone moves them.
#include "scene_common.hlsli"

struct Varyings {
    float4 positionPx : SV_Position;
};

Varyings mainVertex(uint vertex : SV_VertexID) {
    Varyings output;
    float2 corner = float2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0);
    output.positionPx = float4(corner, gSkyDepth.x, 1.0);
    return output;
}

struct Targets {
    float4 colour : SV_Target0;
#if GBUFFER
    float depth : SV_Target1;
    float4 normal : SV_Target2;
    float2 motion : SV_Target3;
    uint2 ids : SV_Target4;
#endif
};

Targets mainFragment(Varyings input) {
    float2 uv = (input.positionPx.xy - gRender.jitterPx) * gSize.zw;
    float3 ndc = float3(uv.x * 2.0 - 1.0, 1.0 - uv.y * 2.0, 1.0);
    float3 ray = gRayWS[0].xyz * ndc.x + gRayWS[1].xyz * ndc.y + gRayWS[2].xyz;
    Targets output;
    output.colour = float4(skyColour(normalize(ray)), 1.0);
#if GBUFFER
    float3 prev = float3(dot(gSkyToPrevClip[0].xyz, ndc), dot(gSkyToPrevClip[1].xyz, ndc),
                         dot(gSkyToPrevClip[2].xyz, ndc));
    float2 prevUv = float2(prev.x / prev.z * 0.5 + 0.5, 0.5 - prev.y / prev.z * 0.5);
    output.depth = gSkyDepth.x;
    output.normal = float4(0.0, 0.0, 0.0, 0.0);
    output.motion = prev.z > 1e-6 ? clamp(uv - prevUv, -4.0, 4.0) : float2(4.0, 4.0);
    output.ids = uint2(0, 0);
#endif
    return output;
}
