// SPDX-License-Identifier: Apache-2.0
// Linear depth in levels 0 to 4, all in one image, for effects that read far from their pixel: Wronski,
// "Scalable Ambient Obscurance" (W1). A tap whose level depends on its pixel is one read of one image.
//
// gInDepth           R32F or D32F, device depth in [0,1] (any depth kind), or metres with DEPTH_LINEAR
// gOutDepthHierarchy R32F, metres, in (0, SKY_DEPTH]; ceil(1.5 width) x height texels: the frame, and right
//                    of it the levels 1 to 4 below each other. Level k has floor(width / 2^k) x floor(height
//                    / 2^k) texels and begins in row height - floor(2 height / 2^k), wherever it has texels
// Every texel is one texel of the frame, not a mean of them: of two surfaces the mean is neither. Which one
// of the 2^k x 2^k turns with the texel (a rotated grid), so that no row or column is left out as a whole.
// What lies at gSkyDepth or beyond is SKY_DEPTH, and so is what is no depth: NaN, infinity, outside of [0,1],
// or not in front of the camera. Texels that belong to no level repeat some texel of the frame.

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer DepthHierarchyParameters {
    float4 gInputSize;    // of the frame: width, height, 1 / width, 1 / height
    float4 gOutputSize;   // of the hierarchy: width, height, 1 / width, 1 / height
    float2 gLinearDepth;  // linearDepthCoefficients() of the projection; unused with DEPTH_LINEAR
    float gSkyDepth;      // metres, a little below the far plane
};

TEXTURE_POINT(gInDepth, 1);

// Texels of the frame per texel, along an axis: of the level that a row of the right part belongs to.
float strideOfRow(float row) {
    float3 begins = floor(gInputSize.y * float3(0.5, 0.25, 0.125));
    float fromBelow = gInputSize.y - row;
    return fromBelow <= begins.z ? 16.0 : fromBelow <= begins.y ? 8.0 : fromBelow <= begins.x ? 4.0 : 2.0;
}

// Centre of the texel of the frame that a texel of the hierarchy shows.
float2 shownPx(float2 positionPx) {
    float2 texel = floor(positionPx);
    float stride = 1.0;
    if (texel.x >= gInputSize.x) {
        stride = strideOfRow(texel.y);
        texel -= float2(gInputSize.x, gInputSize.y - floor(2.0 * gInputSize.y / stride));
    }
    float quarter = floor(0.25 * stride);
    float2 isOdd = 2.0 * frac(0.5 * texel.yx);
    return texel * stride + lerp(stride - 1.0 - quarter, quarter, isOdd) + 0.5;
}

float metresOf(float stored) {
#if DEPTH_LINEAR
    float depth = stored;
#else
    float depth = abs(stored - 0.5) <= 0.5 ? linearDepthFromDevice(stored, gLinearDepth) : SKY_DEPTH;
#endif
    return depth > 0.0 && depth < min(gSkyDepth, SKY_DEPTH) ? depth : SKY_DEPTH;
}

float depthAt(float2 positionPx) {
    return metresOf(SAMPLE(gInDepth, pxToUv(shownPx(positionPx), gInputSize.zw)).r);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutDepthHierarchy;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutDepthHierarchy[thread.xy] = float4(depthAt(float2(thread.xy) + 0.5), 0.0, 0.0, 0.0);
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(depthAt(positionPx.xy), 0.0, 0.0, 0.0);
}

#endif
