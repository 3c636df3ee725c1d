// SPDX-License-Identifier: Apache-2.0
// Resampling of history. Repeated bilinear resampling blurs (Scherzer, slides on resampling); a cubic keeps
// detail.
#ifndef REPRISE_RESAMPLING_HLSLI
#define REPRISE_RESAMPLING_HLSLI

#include "reprise/colour.hlsli"
#include "reprise/platform.hlsli"

// Catmull-Rom at uv from five bilinear reads of a texture with a linear filter: the 4x4 footprint's middle
// row and column, whose inner taps share one read each. The four corner reads, together at most 1/64 of the
// weight, are left out and the rest is normalised. Negative results of the outer lobes become 0.
float3 sampleCatmullRom5(TEXTURE_PARAMETER(colour), float2 uv, float4 size) {
    float2 positionPx = uv * size.xy;
    float2 centrePx = floor(positionPx - 0.5) + 0.5;
    float2 f = positionPx - centrePx;

    float2 w0 = f * (-0.5 + f * (1.0 - 0.5 * f));
    float2 w1 = 1.0 + f * f * (-2.5 + 1.5 * f);
    float2 w3 = f * f * (-0.5 + 0.5 * f);
    float2 w12 = 1.0 - w0 - w3;
    float2 w2 = w12 - w1;

    float2 uv0 = (centrePx - 1.0) * size.zw;
    float2 uv12 = (centrePx + w2 / w12) * size.zw;
    float2 uv3 = (centrePx + 2.0) * size.zw;

    float3 up = sanitize(SAMPLE(colour, float2(uv12.x, uv0.y)).rgb);
    float3 left = sanitize(SAMPLE(colour, float2(uv0.x, uv12.y)).rgb);
    float3 middle = sanitize(SAMPLE(colour, uv12).rgb);
    float3 right = sanitize(SAMPLE(colour, float2(uv3.x, uv12.y)).rgb);
    float3 down = sanitize(SAMPLE(colour, float2(uv12.x, uv3.y)).rgb);

    float cross = w12.x * (w0.y + w3.y) + w12.y * (w0.x + w3.x) + w12.x * w12.y;
    float3 sum = w12.x * (up * w0.y + down * w3.y) + w12.y * (left * w0.x + right * w3.x) +
                 middle * (w12.x * w12.y);
    return sanitize(sum / cross);
}

#endif
