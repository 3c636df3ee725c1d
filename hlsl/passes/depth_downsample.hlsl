// SPDX-License-Identifier: Apache-2.0
// Linear depth at half or quarter resolution, or at the whole, which the framework computes at. Drobot,
// "Shadows and Ambient Occlusion Combined": "the minimum depth of the four underlying pixels", the nearest in
// metres whichever way device depth runs.
//
// gInDepth        R32F or D32F, device depth in [0,1] (any depth kind), or metres with DEPTH_LINEAR
// gOutCoarseDepth R32F, metres, in (0, SKY_DEPTH]; ceil(extent / RATIO) texels: of an odd size the last ones
//                 reach beyond the image, whose edge texels are repeated there
// gOutHalfDepth   HALF_DEPTH: the same in R16F, of which more fits into a cache; at most a 2048th nearer,
//                 whichever way the device rounds, and a 1024th farther
// What lies at gSkyDepth or beyond is SKY_DEPTH, and so is what is no depth: NaN, infinity, outside of [0,1],
// or not in front of the camera.

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer DepthDownsampleParameters {
    float4 gInputSize;    // width, height, 1 / width, 1 / height
    float4 gOutputSize;   // of the coarse image
    float2 gLinearDepth;  // linearDepthCoefficients() of the projection; unused with DEPTH_LINEAR
    float gSkyDepth;      // metres, a little below the far plane
};

TEXTURE_POINT(gInDepth, 1);

#if DEPTH_LINEAR
static const float FAR_DEPTH = SKY_DEPTH;
#elif DEPTH_REVERSED
static const float FAR_DEPTH = 0.0;
#else
static const float FAR_DEPTH = 1.0;
#endif

// What is no depth counts as the farthest; a comparison with NaN is false.
float4 knownDepths(float4 depths) {
#if DEPTH_LINEAR
    depths = depths > 0.0 ? depths : FAR_DEPTH;
    return depths < FAR_DEPTH ? depths : FAR_DEPTH;
#else
    return abs(depths - 0.5) <= 0.5 ? depths : FAR_DEPTH;
#endif
}

// Four texels around a corner that they share, in any order.
float4 readFour(float2 cornerPx) {
    float2 uv = pxToUv(cornerPx, gInputSize.zw);
#if HAS_GATHER
    float4 depths = GATHER_RED(gInDepth, uv);
#else
    float2 halfTexel = 0.5 * gInputSize.zw;
    float4 depths = float4(SAMPLE(gInDepth, uv - halfTexel).r, SAMPLE(gInDepth, uv + halfTexel).r,
                           SAMPLE(gInDepth, uv + float2(halfTexel.x, -halfTexel.y)).r,
                           SAMPLE(gInDepth, uv + float2(-halfTexel.x, halfTexel.y)).r);
#endif
    return knownDepths(depths);
}

float4 closest(float4 a, float4 b) {
#if DEPTH_REVERSED && !DEPTH_LINEAR
    return max(a, b);
#else
    return min(a, b);
#endif
}

float4 farthest(float4 a, float4 b) {
#if DEPTH_REVERSED && !DEPTH_LINEAR
    return min(a, b);
#else
    return max(a, b);
#endif
}

float closestOf(float4 d) {
    float2 pair = closest(d, d.zwxy).xy;
    return closest(pair.xxxx, pair.yyyy).x;
}

float farthestOf(float4 d) {
    float2 pair = farthest(d, d.zwxy).xy;
    return farthest(pair.xxxx, pair.yyyy).x;
}

// Every other texel shows the farthest, so that both sides of an edge are in any 2x2 of the coarse image.
bool showsFarthest(float2 positionPx) {
    float2 pixel = floor(positionPx);
    return frac(0.5 * (pixel.x + pixel.y)) > 0.25;
}

// positionPx: centre of the coarse texel.
float chosenDepth(float2 positionPx) {
#if RATIO_4
    float2 centrePx = 4.0 * positionPx;
    float4 leftUp = readFour(centrePx - 1.0);
    float4 rightUp = readFour(centrePx + float2(1.0, -1.0));
    float4 leftDown = readFour(centrePx + float2(-1.0, 1.0));
    float4 rightDown = readFour(centrePx + 1.0);
    float4 near = closest(closest(leftUp, rightUp), closest(leftDown, rightDown));
    float4 far = farthest(farthest(leftUp, rightUp), farthest(leftDown, rightDown));
#elif RATIO_2
    float4 near = readFour(2.0 * positionPx);
    float4 far = near;
#else
    float4 near = knownDepths(SAMPLE(gInDepth, pxToUv(positionPx, gInputSize.zw)).rrrr);
    float4 far = near;
#endif
#if CHECKERBOARD
    return showsFarthest(positionPx) ? farthestOf(far) : closestOf(near);
#else
    return closestOf(near);
#endif
}

float coarseDepth(float2 positionPx) {
#if DEPTH_LINEAR
    float depth = chosenDepth(positionPx);
#else
    float depth = linearDepthFromDevice(chosenDepth(positionPx), gLinearDepth);
#endif
    return depth > 0.0 && depth < min(gSkyDepth, SKY_DEPTH) ? depth : SKY_DEPTH;
}

#if HALF_DEPTH
// Where a device truncates 16 bits, what is written lies up to a 1024th nearer: half of that is added.
float halfDepthOf(float depth) {
    return min(depth * (1.0 + 1.0 / 2048.0), SKY_DEPTH);
}
#endif

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutCoarseDepth;
#if HALF_DEPTH
BINDING(17) RWTexture2D<float4> gOutHalfDepth;
#endif

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    float4 depth = float4(coarseDepth(float2(thread.xy) + 0.5), 0.0, 0.0, 0.0);
    gOutCoarseDepth[thread.xy] = depth;
#if HALF_DEPTH
    gOutHalfDepth[thread.xy] = float4(halfDepthOf(depth.r), 0.0, 0.0, 0.0);
#endif
}

#else

// Four components, for shader model 3 takes no fewer.
struct Outputs {
    float4 depth : SV_Target0;
#if HALF_DEPTH
    float4 halfDepth : SV_Target1;
#endif
};

Outputs mainFragment(float4 positionPx : POSITION_PX) {
    Outputs outputs;
    outputs.depth = float4(coarseDepth(positionPx.xy), 0.0, 0.0, 0.0);
#if HALF_DEPTH
    outputs.halfDepth = float4(halfDepthOf(outputs.depth.r), 0.0, 0.0, 0.0);
#endif
    return outputs;
}

#endif
