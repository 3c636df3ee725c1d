// SPDX-License-Identifier: Apache-2.0
// The reprojection cache: fresh values accumulated into their history, where the history shows the same
// surface. Drobot, 7.2, "Reprojection Caching", Listing 7.2 (D2), with the running convergence of 7.3 (D8).
// What the images hold by VALUES: cached_values.hlsli.
//
// gInFresh            values of this frame; beside one or a packed pair linear depth in metres
// gInCoarseDepth      VALUES two, four, with_frames: linear depth of depth_downsample
// gInVelocity         HISTORY motion: motion times gMotionToUv = currUv - prevUv without jitter, of the frame
// gHistoryCache       gOutCache of the frame before, or what bilateral_filter made of it; any content where
//                     gHistoryValid is 0. gHistoryCacheFiltered is the same image under a linear filter
// gHistoryCacheState  gOutCacheState of the frame before, and gHistoryCacheStateFiltered the same so
// gHistoryCoarseDepth VALUES with_frames, which has no state: gInCoarseDepth of the frame before
// gOutCache           values
// gOutCacheState      frames that the history holds; beside two and four values depth; with_frames none
// A value beyond MAX_COLOUR or NaN counts as 0, in history as none. SKY_DEPTH takes part like a surface.

#include "passes/cached_values.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer ReprojectionCacheParameters {
    row_major float4x4 gViewToPreviousClip;   // reprise::viewToPreviousClip()
    float4 gOutputSize;     // width, height, 1 / width, 1 / height
    float4 gViewRay;        // extent and origin of the view rays over this image, see viewPosition()
    float2 gFrameToCoarse;  // UV over the frame to UV over this image: frame / (ratio * coarse extent)
    float2 gMotionToUv;     // (1, 1) for currUv - prevUv in UV
    float2 gClipToDepth;    // (0, 1), or linearDepthCoefficients() of an orthographic previous projection
    float2 gMissThreshold;  // metres, and metres per metre of depth, from which on depths are two surfaces
    float2 gSpeedPx;        // pixels of this image a frame, from which on history fades, and is none
    float2 gChange;         // CHANGE_DETECTION: deviations, plus a difference, that history may differ by
    float gConvergenceTime; // confidence of equal depths, above 0: 2 keeps it whole up to half the threshold
    float gMaxWeight;       // most weight of history, [0, 1)
    float gHistoryValid;    // 0 on the first frame, after a cut, a gap or a resize
};

TEXTURE_POINT(gInFresh, 1);
#if DEPTH_APART
TEXTURE_POINT(gInCoarseDepth, 7);
#endif

#include "passes/accumulation.hlsli"

#if CHANGE_DETECTION && !HISTORY_NONE

#if HAS_GATHER

// Of four texels around a corner what the channel holds, or one of two packed values.
float4 gatherFresh(float2 uv, int channel) {
    float4 texels = GATHER_RED(gInFresh, uv);
#if VALUES_PACKED
    [unroll] for (int i = 0; i < 4; ++i)
        texels[i] = channel == 0 ? unpackValues(texels[i].xxxx).x : unpackValues(texels[i].xxxx).y;
#endif
#if DEPTH_APART
    if (channel == 1) texels = GATHER_GREEN(gInFresh, uv);
#endif
#if VALUES_FOUR
    if (channel == 2) texels = GATHER_BLUE(gInFresh, uv);
    if (channel == 3) texels = GATHER_ALPHA(gInFresh, uv);
#endif
    return abs(texels) <= MAX_COLOUR ? texels : 0.0;
}

#endif

// texel: whole.
Surroundings readSurroundings(float2 texel) {
    float4 weightsX = isInTile(texel.x), weightsY = isInTile(texel.y);
    Surroundings around;
#if HAS_GATHER
    [unroll] for (int channel = 0; channel < VALUE_COUNT; ++channel) {
        float4 a = gatherFresh(pxToUv(texel, gOutputSize.zw), channel);
        float4 b = gatherFresh(pxToUv(texel + float2(2.0, 0.0), gOutputSize.zw), channel);
        float4 c = gatherFresh(pxToUv(texel + float2(0.0, 2.0), gOutputSize.zw), channel);
        float4 d = gatherFresh(pxToUv(texel + 2.0, gOutputSize.zw), channel);
        float4 rows[4];
        rows[0] = float4(a.wz, b.wz);
        rows[1] = float4(a.xy, b.xy);
        rows[2] = float4(c.wz, d.wz);
        rows[3] = float4(c.xy, d.xy);
        setChannel(around, channel, meanAndDeviation(rows, weightsX, weightsY));
    }
#else
    CachedValues texels[16];
    [unroll] for (int i = 0; i < 16; ++i) {
        float2 position = texel + float2(float(i % 4) - 0.5, float(i / 4) - 0.5);
        texels[i] = knownValues(SAMPLE(gInFresh, pxToUv(position, gOutputSize.zw)));
    }
    [unroll] for (int channel = 0; channel < VALUE_COUNT; ++channel) {
        float4 rows[4];
        [unroll] for (int k = 0; k < 16; ++k)
            rows[k / 4][k % 4] = channelOf(texels[k], channel);
        setChannel(around, channel, meanAndDeviation(rows, weightsX, weightsY));
    }
#endif
    return around;
}

#endif

FreshTexel readFresh(float2 uv) {
    float4 values = SAMPLE(gInFresh, uv);
#if DEPTH_APART
    float depth = SAMPLE(gInCoarseDepth, uv).r;
#else
    float depth = values.g;
#endif
    FreshTexel fresh;
    fresh.values = knownValues(values);
    fresh.depth = depth > 0.0 && depth < SKY_DEPTH ? depth : SKY_DEPTH;
    return fresh;
}

CacheTexel cachedTexel(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
    FreshTexel fresh = readFresh(uv);
#if CHANGE_DETECTION && !HISTORY_NONE
    fresh.around = readSurroundings(floor(positionPx));
#endif
    return cachedTexel(uv, fresh);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutCache;
#if !VALUES_WITH_FRAMES
BINDING(17) RWTexture2D<float4> gOutCacheState;
#endif

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    CacheTexel texel = cachedTexel(float2(thread.xy) + 0.5);
    gOutCache[thread.xy] = texel.values;
#if !VALUES_WITH_FRAMES
    gOutCacheState[thread.xy] = texel.state;
#endif
}

#else

CacheTexel mainFragment(float4 positionPx : POSITION_PX) {
    return cachedTexel(positionPx.xy);
}

#endif
