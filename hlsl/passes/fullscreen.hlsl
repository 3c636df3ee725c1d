// SPDX-License-Identifier: Apache-2.0
// The triangle that covers the viewport. Passes take their coordinates from POSITION_PX, which rasterisation
// gives; in Direct3D 9 it is interpolated, and the corners, for want of a vertex number, come from a vertex
// buffer: float2 (-1,-1), (3,-1), (-1,3).

#include "reprise/coordinates.hlsli"
#include "reprise/half_pixel.hlsli"
#include "reprise/platform.hlsli"

#if PLATFORM_D3D9

TARGET_SIZE(gOutputSize);

struct Varyings {
    float4 positionCS : SV_Position;
    float4 positionPx : POSITION_PX;
};

Varyings mainVertex(float2 corner : POSITION) {
    Varyings output;
    output.positionCS = halfPixelOffset(float4(corner, 0.0, 1.0), gOutputSize.zw);
    output.positionPx = float4(uvToPx(ndcToUv(corner), gOutputSize.xy), 0.0, 1.0);
    return output;
}

#else

float4 mainVertex(uint vertex : SV_VertexID) : SV_Position {
    return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);
}

#endif
