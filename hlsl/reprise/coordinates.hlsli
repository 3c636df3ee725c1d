// SPDX-License-Identifier: Apache-2.0
// Between NDC, UV and pixels. Each converter stands beside its inverse.
#ifndef REPRISE_COORDINATES_HLSLI
#define REPRISE_COORDINATES_HLSLI

// NDC y runs up and UV y down (Direct3D; Vulkan with a negative viewport height). Where both run the same way
// (OpenGL; Vulkan without it) the engine sets NDC_AND_UV_SHARE_Y.
#if NDC_AND_UV_SHARE_Y
static const float2 NDC_TO_UV_SCALE = float2(0.5, 0.5);
static const float2 UV_TO_NDC_SCALE = float2(2.0, 2.0);
#else
static const float2 NDC_TO_UV_SCALE = float2(0.5, -0.5);
static const float2 UV_TO_NDC_SCALE = float2(2.0, -2.0);
#endif

// [-1,1]² to [0,1]².
float2 ndcToUv(float2 ndc) {
    return ndc * NDC_TO_UV_SCALE + 0.5;
}

// [0,1]² to [-1,1]².
float2 uvToNdc(float2 uv) {
    return uv * UV_TO_NDC_SCALE - 0.5 * UV_TO_NDC_SCALE;
}

// Pixel coordinates (centres at halves) to UV; texelSize is 1 / extent.
float2 pxToUv(float2 px, float2 texelSize) {
    return px * texelSize;
}

// UV to pixel coordinates; extent in pixels.
float2 uvToPx(float2 uv, float2 extent) {
    return uv * extent;
}

// True inside the image, edges included; false for NaN. -0 is outside, which no difference that cancels is;
// under Direct3D 9 it is inside, as is what rounding takes onto an edge.
bool isInsideUv(float2 uv) {
#if PLATFORM_D3D9
    return all(abs(uv - 0.5) <= 0.5);
#else
    return all(asuint(uv) <= asuint(1.0));   // bits order as the floats >= 0 do, others after
#endif
}

#endif
