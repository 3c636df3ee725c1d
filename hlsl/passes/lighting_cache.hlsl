// SPDX-License-Identifier: Apache-2.0
// Steps 3 to 5 of the framework in one dispatch: occlusion, shadow of the sun or both computed for a texel
// and accumulated at once. Drobot, 7.3 (D7 to D10). What ambient_occlusion, sun_shadow and reprojection_cache
// do one after the other, without storing what is fresh; change detection reads it from the group's memory.
//
// gInCoarseDepth      linear depth in metres of depth_downsample
// gInHalfDepth        HALF_DEPTH: the same in R16F, which points are checked against: they lie far apart, and
//                     their reads are what the pass waits for
// gInNormal           NORMALS read: of the frame, as ambient_occlusion takes it
// gInShadowMap        FRESH other than occlusion: as sun_shadow takes it
// gInVelocity and the history of values, state and depth: as reprojection_cache has them
// gOutCache           visibilities in [0,1], by VALUES: cached_values.hlsli
// gOutCacheState      frames that the history holds; beside two values depth; with_frames none

#define HAS_OCCLUSION (!FRESH_SHADOW)
#define HAS_SHADOW (!FRESH_OCCLUSION)

#include "reprise/platform.hlsli"

// As the three passes have them, where there is more to say.
BINDING(0) cbuffer LightingCacheParameters {
    row_major float4x4 gViewToPreviousClip;   // reprise::viewToPreviousClip()
    float4 gOutputSize;      // width, height, 1 / width, 1 / height
    float4 gViewRay;         // extent and origin of the view rays over this image, see viewPosition()
    float4 gToShadowX;       // to x in texels of the first cascade's column
    float4 gToShadowY;       // to y in texels, down
    float4 gToShadowZ;       // to depth as the shadow map holds it
    float4 gCascadeScale1;   // xyz: from the first cascade to the second, times this,
    float4 gCascadeOffset1;  //      plus this
    float4 gCascadeScale2;   // to the third
    float4 gCascadeOffset2;
    float4 gCascadeScale3;   // to the fourth
    float4 gCascadeOffset3;
    float4 gCascadeFar;      // linear depth in metres at which each cascade ends, ascending
    float4 gCascadeSize;     // width and height of a column in texels; 1 / width and 1 / height of the map
    float3 gDisc;            // radius in texels of the first cascade, x and y; at least z texels in any
    float gFrameIndex;       // whole, see subsetOfFrame()
    float3 gShadowBias;      // depth of the first cascade, that a metre of linear depth; steepest plane that
                             // is followed, in depth a texel of the first cascade
    float gSubsetCount;      // frames after which the pattern repeats, 1 to 16
    float2 gOcclusionBias;   // metres, and metres per metre of depth, by which a surface must lie in front
    float2 gFrameToCoarse;   // UV over the frame to UV over this image: frame / (ratio * coarse extent)
    float2 gMotionToUv;      // (1, 1) for currUv - prevUv in UV
    float2 gClipToDepth;     // (0, 1), or linearDepthCoefficients() of an orthographic previous projection
    float2 gMissThreshold;   // metres, and metres per metre of depth, from which on depths are two surfaces
    float2 gSpeedPx;         // pixels of this image a frame, from which on history fades, and is none
    float2 gChange;          // CHANGE_DETECTION: deviations, plus a difference, that history may differ by
    float gRadius;           // metres, above 0
    float gConvergenceTime;  // confidence of equal depths, above 0: 2 keeps it whole up to half the threshold
    float gMaxWeight;        // most weight of history, [0, 1)
    float gHistoryValid;     // 0 on the first frame, after a cut, a gap or a resize
    float4 gTaps[32];        // of this frame, SAMPLES of them: reprise::occlusionTaps()
};

TEXTURE_POINT(gInCoarseDepth, 1);
#if HALF_DEPTH && HAS_OCCLUSION
TEXTURE_POINT(gInHalfDepth, 9);
#endif
#if NORMALS_READ && HAS_OCCLUSION
TEXTURE_POINT(gInNormal, 7);
#endif
#if HAS_SHADOW
TEXTURE_POINT(gInShadowMap, 8);
#endif

#include "passes/accumulation.hlsli"
#if HAS_OCCLUSION
#include "passes/ambient_occlusion.hlsli"
#endif
#if HAS_SHADOW
#include "passes/sun_shadow.hlsli"
#endif

BINDING(16) RWTexture2D<float4> gOutCache;
#if !VALUES_WITH_FRAMES
BINDING(17) RWTexture2D<float4> gOutCacheState;
#endif

FreshTexel computeFresh(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
#if HAS_OCCLUSION && NORMALS_READ && !HAS_SHADOW
    DepthPlus depths = depthAlone(readDepth(uv));
#else
    DepthPlus depths = readDepthPlus(uv);
#endif
    FreshTexel fresh;
    fresh.depth = depths.centre;
    float occlusion = 1.0, shadow = 1.0;
#if HAS_OCCLUSION
    occlusion = ambientVisibility(uv, depths, positionPx);
#endif
#if HAS_SHADOW
    shadow = sunVisibility(uv, depths, positionPx);
#endif
#if VALUES_ONE
    fresh.values = occlusion * shadow;
#else
    fresh.values = float2(occlusion, shadow);
#endif
    return fresh;
}

#if CHANGE_DETECTION && !HISTORY_NONE

// A value and its square: of visibilities they tell the deviation.
struct Moments {
    CachedValues mean, square;
};

groupshared CachedValues gsFresh[16 * 16];
groupshared Moments gsRow[16 * 16];

// By the texel's place in the group, which is its tile: sums along rows, then of four rows.
Surroundings surroundingsOf(int2 local, CachedValues fresh) {
    int own = 16 * local.y + local.x;
    // Beyond the tile any texel of it, without weight.
    int4 x = 16 * local.y + clamp(local.x + int4(-1, 0, 1, 2), 0, 15);
    int4 y = local.x + 16 * clamp(local.y + int4(-1, 0, 1, 2), 0, 15);
    float4 weightsX = isInTile(float(local.x)), weightsY = isInTile(float(local.y));
    weightsX /= dot(weightsX, 1.0);
    weightsY /= dot(weightsY, 1.0);

    gsFresh[own] = fresh;
    GroupMemoryBarrierWithGroupSync();
    Moments row;
    row.mean = row.square = 0.0;
    [unroll] for (int i = 0; i < 4; ++i) {
        CachedValues value = gsFresh[x[i]];
        row.mean += weightsX[i] * value;
        row.square += weightsX[i] * value * value;
    }
    gsRow[own] = row;
    GroupMemoryBarrierWithGroupSync();
    Moments sum;
    sum.mean = sum.square = 0.0;
    [unroll] for (int k = 0; k < 4; ++k) {
        sum.mean += weightsY[k] * gsRow[y[k]].mean;
        sum.square += weightsY[k] * gsRow[y[k]].square;
    }
    Surroundings around;
    around.mean = sum.mean;
    around.deviation = sqrt(max(sum.square - sum.mean * sum.mean, 0.0));
    return around;
}

#endif

// Of change detection the group is the tile; else wide rows, which a CPU stores a tenth faster.
#if CHANGE_DETECTION
[numthreads(16, 16, 1)]
#else
[numthreads(32, 8, 1)]
#endif
void mainCompute(uint3 thread : SV_DispatchThreadID, uint3 local : SV_GroupThreadID) {
    // Beyond the image stands its border again, as a sampler has it.
    float2 positionPx = min(float2(thread.xy) + 0.5, gOutputSize.xy - 0.5);
    FreshTexel fresh = computeFresh(positionPx);
#if CHANGE_DETECTION && !HISTORY_NONE
    fresh.around = surroundingsOf(int2(local.xy), fresh.values);
#endif
    CacheTexel texel = cachedTexel(pxToUv(positionPx, gOutputSize.zw), fresh);
    gOutCache[thread.xy] = texel.values;
#if !VALUES_WITH_FRAMES
    gOutCacheState[thread.xy] = texel.state;
#endif
}
