// SPDX-License-Identifier: Apache-2.0
// Adds one rendering to the sum of the ground truth, after the tone curve of the report: blending sums.
[[vk::binding(0, 0)]] Texture2D<float4> gColour;

struct Varyings {
    float4 positionPx : SV_Position;
};

Varyings mainVertex(uint vertex : SV_VertexID) {
    Varyings output;
    output.positionPx = float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);
    return output;
}

float4 mainFragment(Varyings input) : SV_Target0 {
    float3 colour = max(gColour.Load(int3(input.positionPx.xy, 0)).rgb, 0.0);
    return float4(colour / (1.0 + colour), 1.0);
}
