// SPDX-License-Identifier: Apache-2.0
// Direct3D 9's half pixel. Drobot, 7.3, asks for it; Listings 7.1 and 7.2 are printed without it.
#ifndef REPRISE_HALF_PIXEL_HLSLI
#define REPRISE_HALF_PIXEL_HLSLI

// Direct3D 9 puts pixel centres at whole numbers of the viewport and texel centres at halves, so whatever is
// interpolated over the screen arrives half a pixel short: the texture coordinate of the pixel's upper left
// corner. Every vertex stage passes its clip position through this last; what is moved by half a pixel to the
// left and up is sampled at the centres again. texelSize is 1 / extent of the render target. Elsewhere
// centres agree, and the position is returned as it came.
float4 halfPixelOffset(float4 positionCS, float2 texelSize) {
#if PLATFORM_D3D9
    // One pixel is 2 / extent of NDC, whose y runs up.
    positionCS.xy += float2(-texelSize.x, texelSize.y) * positionCS.w;
#endif
    return positionCS;
}

#endif
