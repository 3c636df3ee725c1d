// SPDX-License-Identifier: Apache-2.0
// Reads of a cache of any value at a place between its texels: Scherzer, "Cache resampling and filtering"
// (S3), and Drobot, "Reprojection Caching" (D3). Nearest, bilinear, a cubic in four reads, and a history of
// 2x2 texels a pixel, which needs no filter. The cubic that keeps detail, for colours, is in
// resampling.hlsli; forced misses under magnification are in miss_detection.hlsli.
#ifndef REPRISE_CACHE_RESAMPLING_HLSLI
#define REPRISE_CACHE_RESAMPLING_HLSLI

#include "reprise/finite.hlsli"
#include "reprise/platform.hlsli"

// In all of these: uv in [0,1]², clamped to the edge beyond; size is (width, height, 1 / width, 1 / height).

// The weighted mean of those of four that are numbers, 0 without any. Weights in [0,1], sum 1.
float4 meanOfNumbers(float4 a, float4 b, float4 c, float4 d, float4 weights) {
    weights *= float4(isNumber(a), isNumber(b), isNumber(c), isNumber(d));
    float4 sum = weights.x * numberOrZero(a) + weights.y * numberOrZero(b) + weights.z * numberOrZero(c) +
                 weights.w * numberOrZero(d);
    float total = dot(weights, 1.0);
    return total > 1e-6 ? sum / total : 0.0;
}

// The centre of the texel that holds uv: there every filter gives that texel.
float2 nearestTexelUv(float2 uv, float4 size) {
    return (floor(uv * size.xy) + 0.5) * size.zw;
}

float4 sampleNearest(TEXTURE_PARAMETER(history), float2 uv, float4 size) {
    return numberOrZero(SAMPLE(history, nearestTexelUv(uv, size)));
}

// Four reads of texel centres, without the filter's steps of 1/256 and for textures that have no linear
// filter. Under one, a texel that is no number spoils the reads beside it too.
float4 sampleBilinear(TEXTURE_PARAMETER(history), float2 uv, float4 size) {
    float2 position = uv * size.xy - 0.5;
    float2 first = floor(position);
    float2 right = position - first;
    float2 left = 1.0 - right;
    float2 low = (first + 0.5) * size.zw;
    float2 high = (first + 1.5) * size.zw;
    return meanOfNumbers(SAMPLE(history, low), SAMPLE(history, float2(high.x, low.y)),
                         SAMPLE(history, float2(low.x, high.y)), SAMPLE(history, high),
                         float4(left.x, right.x, left.x, right.x) * float4(left.y, left.y, right.y, right.y));
}

// The cubic B-spline's 16 texels in four reads of a texture with a linear filter (GPU Gems 2, chapter 20):
// its weights are positive, so that each pair is one read between the two. It is smooth and does not ring,
// but it blurs more than bilinear reads at any motion, by 1/3 of a squared texel on each axis to at most 1/4:
// "less blur" of the slide does not hold for it, but for sampleCatmullRom5().
float4 sampleBSpline4(TEXTURE_PARAMETER(history), float2 uv, float4 size) {
    float2 position = uv * size.xy - 0.5;
    float2 first = floor(position);
    float2 f = position - first;

    float2 w0 = (1.0 - f) * (1.0 - f) * (1.0 - f) / 6.0;
    float2 w1 = (4.0 + f * f * (3.0 * f - 6.0)) / 6.0;
    float2 w3 = f * f * f / 6.0;
    float2 low = w0 + w1;
    float2 high = 1.0 - low;

    float2 uvLow = (first - 0.5 + w1 / low) * size.zw;
    float2 uvHigh = (first + 1.5 + w3 / high) * size.zw;
    return meanOfNumbers(SAMPLE(history, uvLow), SAMPLE(history, float2(uvHigh.x, uvLow.y)),
                         SAMPLE(history, float2(uvLow.x, uvHigh.y)), SAMPLE(history, uvHigh),
                         float4(low.x, high.x, low.x, high.x) * float4(low.y, low.y, high.y, high.y));
}

// A history of 2x2 texels a pixel ("a higher-resolution history buffer and nearest-neighbor sampling at a
// subpixel level"): read it by sampleNearest() with its own size, at the previous place of the texel's
// centre. Which of a pixel's four texels, each coordinate 0 or 1, this frame's sample lies in: jitter moved
// the image by +jitterPx, so the pixel's centre shows what lay at -jitterPx from it. The uniform4 helix meets
// all four.
float2 subpixelOfJitter(float2 jitterPx) {
    return jitterPx <= 0.0 ? 1.0 : 0.0;
}

// The texel of that history that the pixel writes in this frame, both as whole indices.
float2 highResolutionTexel(float2 pixel, float2 jitterPx) {
    return 2.0 * pixel + subpixelOfJitter(jitterPx);
}

// Whether a texel of that history, given by its position (centres at halves), takes this frame's sample of
// its pixel, floor(positionPx / 2), or else its own history.
bool isFreshTexel(float2 positionPx, float2 jitterPx) {
    float2 subpixel = floor(positionPx) - 2.0 * floor(0.5 * positionPx);
    return all(abs(subpixel - subpixelOfJitter(jitterPx)) < 0.5);
}

// Mip level for a minified history, "read appropriate mip": 0 where a pixel's step is at most a texel. ddxPx
// and ddyPx: change of the place, in texels of level 0, to the next pixel in x and y.
float minificationLevel(float2 ddxPx, float2 ddyPx) {
    float longest = max(dot(ddxPx, ddxPx), dot(ddyPx, ddyPx));
    return longest > 1.0 ? 0.5 * log2(min(longest, LARGEST_NUMBER)) : 0.0;
}

#endif
