// SPDX-License-Identifier: Apache-2.0
// A shader of an engine's own, as the listings are written: a texture coordinate interpolated over the screen
// and a linear filter. It copies the image, texel by texel, where the half-pixel offset is right.

#include "reprise/coordinates.hlsli"
#include "reprise/half_pixel.hlsli"
#include "reprise/platform.hlsli"

cbuffer ScreenCopyParameters {
    float4 gOutputSize;   // width, height, 1 / width, 1 / height
};

TEXTURE_LINEAR(gInColour, 0);

struct Varyings {
    float4 positionCS : SV_Position;
    float2 uv : TEXCOORD0;
};

Varyings mainVertex(float2 corner : POSITION) {
    Varyings output;
    output.positionCS = halfPixelOffset(float4(corner, 0.0, 1.0), gOutputSize.zw);
    output.uv = ndcToUv(corner);
    return output;
}

float4 mainFragment(Varyings input) : SV_Target0 {
    return SAMPLE(gInColour, input.uv);
}
