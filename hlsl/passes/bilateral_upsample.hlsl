// SPDX-License-Identifier: Apache-2.0
// A coarse value at full resolution, along the edges of the full depth. Drobot, "Bilateral Upsampling",
// Listing 7.1 and figure 7.2 (D1), step 7 of the framework (D7).
//
// gInFiltered      values, of gOutFiltered or gOutCache; what they are by VALUES: cached_values.hlsli
// gInCoarseDepth   R32F, metres, of depth_downsample: a binary16 is coarser than the depth weights are sharp
// gInDepth         R32F or D32F, device depth in [0,1] (any depth kind), or metres with DEPTH_LINEAR
// gInNormal        NORMAL_WEIGHTS: view space, unit, of the frame. A coarse texel has the normal of one of
//                  its pixels, the same as ambient_occlusion takes
// gOutUpsampled    the value, both or all four; of packed ones occlusion and shadow
// A coarse sample that is NaN or beyond MAX_COLOUR has no share; of four such 0 remains. A depth that is none
// counts as sky.

#include "passes/cached_values.hlsli"
#include "reprise/bilateral_upsampling.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer BilateralUpsampleParameters {
    float4 gOutputSize;    // width, height, 1 / width, 1 / height
    float4 gCoarseSize;    // of the coarse images
    float2 gLinearDepth;   // linearDepthCoefficients() of the projection; unused with DEPTH_LINEAR
    float gSkyDepth;       // metres, as depth_downsample had it
    float gContrast;       // NORMAL_WEIGHTS: exponent of the cosine, up to 256
};

TEXTURE_POINT(gInFiltered, 1);
TEXTURE_POINT(gInCoarseDepth, 2);
TEXTURE_POINT(gInDepth, 3);
#if NORMAL_WEIGHTS
TEXTURE_POINT(gInNormal, 4);
#endif

#if RATIO_4
static const float COARSE_TEXEL_PX = 4.0;
#else
static const float COARSE_TEXEL_PX = 2.0;
#endif

float knownDepth(float depth) {
    return depth > 0.0 && depth < min(gSkyDepth, SKY_DEPTH) ? depth : SKY_DEPTH;
}

float linearDepth(float depth) {
#if DEPTH_LINEAR
    return knownDepth(depth);
#else
    return abs(depth - 0.5) <= 0.5 ? knownDepth(linearDepthFromDevice(depth, gLinearDepth)) : SKY_DEPTH;
#endif
}

// What the four coarse texels of a footprint hold, which several pixels share. Values that are no numbers are
// 0, and not usable.
struct CoarseTexels {
    CachedValues values[4];
    float4 usable, depths;
#if NORMAL_WEIGHTS
    float3 normals[4];
#endif
};

#if NORMAL_WEIGHTS
// Of a coarse texel, by the UV of its centre, which lies on a corner of the frame's texels: an eighth of the
// coarse one before it a texel is met for either ratio.
float3 readCoarseNormal(float2 coarseUv) {
    float2 positionPx = COARSE_TEXEL_PX * (coarseUv * gCoarseSize.xy - 0.125);
    return SAMPLE(gInNormal, pxToUv(positionPx, gOutputSize.zw)).xyz;
}
#endif

// The four texels, left and right above, left and right below. Depth first: an H200 takes a tenth longer for
// two values before it.
CoarseTexels readCoarse(CoarseFootprint footprint, float2 positionPx) {
    CoarseTexels coarse;
#if HAS_GATHER
    float2 corner = pxToUv(floor(positionPx / COARSE_TEXEL_PX - 0.5) + 1.0, gCoarseSize.zw);
    float4 depths = GATHER_RED(gInCoarseDepth, corner).wzxy;
#else
    float4 depths =
        float4(SAMPLE(gInCoarseDepth, footprint.leftUp).r, SAMPLE(gInCoarseDepth, footprint.rightUp).r,
               SAMPLE(gInCoarseDepth, footprint.leftDown).r, SAMPLE(gInCoarseDepth, footprint.rightDown).r);
#endif
    coarse.depths = depths > 0.0 ? min(depths, SKY_DEPTH) : SKY_DEPTH;
#if HAS_GATHER && VALUES_WITH_FRAMES
    VisibilitiesOfFour four = unpackWithFrames(GATHER_RED(gInFiltered, corner).wzxy);
    [unroll] for (int texel = 0; texel < 4; ++texel)
        coarse.values[texel] = float2(four.occlusion[texel], four.shadow[texel]);
    coarse.usable = four.usable;
#else
#if HAS_GATHER && !VALUES_FOUR
    float4 red = GATHER_RED(gInFiltered, corner).wzxy, green = 0.0;
#if VALUES_TWO
    green = GATHER_GREEN(gInFiltered, corner).wzxy;
#endif
    [unroll] for (int texel = 0; texel < 4; ++texel)
        coarse.values[texel] = unpackValues(float4(red[texel], green[texel], 0.0, 0.0));
#else
    coarse.values[0] = unpackValues(SAMPLE(gInFiltered, footprint.leftUp));
    coarse.values[1] = unpackValues(SAMPLE(gInFiltered, footprint.rightUp));
    coarse.values[2] = unpackValues(SAMPLE(gInFiltered, footprint.leftDown));
    coarse.values[3] = unpackValues(SAMPLE(gInFiltered, footprint.rightDown));
#endif
    [unroll] for (int i = 0; i < 4; ++i) {
        coarse.usable[i] = areCacheable(coarse.values[i]) ? 1.0 : 0.0;
        coarse.values[i] = coarse.usable[i] > 0.5 ? coarse.values[i] : 0.0;
    }
#endif
#if NORMAL_WEIGHTS
    coarse.normals[0] = readCoarseNormal(footprint.leftUp);
    coarse.normals[1] = readCoarseNormal(footprint.rightUp);
    coarse.normals[2] = readCoarseNormal(footprint.leftDown);
    coarse.normals[3] = readCoarseNormal(footprint.rightDown);
#endif
    return coarse;
}

// What gOutUpsampled takes.
float4 upsampledValues(CoarseTexels coarse, float4 bilinearWeights, float2 positionPx, float depth) {
#if NORMAL_WEIGHTS
    float3 normal = SAMPLE(gInNormal, pxToUv(positionPx, gOutputSize.zw)).xyz;
    float4 normalWeights = normalWeightsOf(coarse.normals[0], coarse.normals[1], coarse.normals[2],
                                           coarse.normals[3], normal, gContrast);
    float4 shares = bilateralShares(bilinearWeights, normalWeights, coarse.depths, depth, coarse.usable);
#else
    float4 shares = bilateralSharesOfDepths(bilinearWeights, coarse.depths, depth, coarse.usable);
#endif
    CachedValues values = shares.x * coarse.values[0] + shares.y * coarse.values[1] +
                          shares.z * coarse.values[2] + shares.w * coarse.values[3];
#if VALUES_FOUR
    return values;
#elif VALUES_ONE
    return float4(values, 0.0, 0.0, 0.0);
#else
    return float4(values, 0.0, 0.0);
#endif
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutUpsampled;

// Four pixels between the centres of the same coarse texels: one gather for each of three images. Of a ratio
// of 2 such pixels begin one before a multiple of two, so that groups cover a pixel more than the image has.
// Groups of 32x8: in 16x16 the cores of a CPU share the lines that they write, and take half as long again.
// Each 32 threads of a group are 16x2: rows of 32 take a GPU a fifth longer for two values.
[numthreads(32, 8, 1)]
void mainCompute(uint3 group : SV_GroupID, uint index : SV_GroupIndex) {
    uint2 local = uint2((index & 15u) + ((index >> 1u) & 16u), ((index >> 4u) & 1u) + 2u * (index >> 6u));
    uint2 thread = group.xy * uint2(32, 8) + local;
#if RATIO_4
    float2 first = 2.0 * float2(thread.xy);
#else
    float2 first = 2.0 * float2(thread.xy) - 1.0;
#endif
    CoarseFootprint footprint = coarseFootprint(first + 1.0, COARSE_TEXEL_PX, gCoarseSize.xy);
    CoarseTexels coarse = readCoarse(footprint, first + 0.5);
    float4 depths = GATHER_RED(gInDepth, pxToUv(first + 1.0, gOutputSize.zw)).wzxy;
    // How far right of the left coarse texel, and below the upper, the first pixel's centre lies.
#if RATIO_4
    float2 place = frac((first + 0.5) / COARSE_TEXEL_PX - 0.5);
#else
    float2 place = float2(0.25, 0.25);
#endif
    float4 values[4];
    [unroll] for (int i = 0; i < 4; ++i) {
        float2 pixel = float2(float(i % 2), float(i / 2));
        float4 weights = bilinearWeightsAt(place + pixel / COARSE_TEXEL_PX);
        values[i] = upsampledValues(coarse, weights, first + pixel + 0.5, linearDepth(depths[i]));
    }
    int2 pixel = int2(first);
    gOutUpsampled[pixel] = values[0];
    gOutUpsampled[pixel + int2(1, 0)] = values[1];
    gOutUpsampled[pixel + int2(0, 1)] = values[2];
    gOutUpsampled[pixel + int2(1, 1)] = values[3];
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    CoarseFootprint footprint = coarseFootprint(positionPx.xy, COARSE_TEXEL_PX, gCoarseSize.xy);
    CoarseTexels coarse = readCoarse(footprint, positionPx.xy);
    float depth = linearDepth(SAMPLE(gInDepth, pxToUv(positionPx.xy, gOutputSize.zw)).r);
    return upsampledValues(coarse, footprint.bilinearWeights, positionPx.xy, depth);
}

#endif
