// SPDX-License-Identifier: Apache-2.0
// A coarse value at full resolution, along the edges of the full depth. Drobot, "Bilateral Upsampling",
// Listing 7.1 and figure 7.2 (D1), step 7 of the framework (D7).
//
// gInFiltered      RGBA16F, of which the first is read: the value. VALUES other than one: occlusion and
//                  shadow packed in it, see occlusion_shadow_packing.hlsli
// gInCoarseDepth   R32F, metres, of depth_downsample: a binary16 is coarser than the depth weights are sharp
// gInDepth         R32F or D32F, device depth in [0,1] (any depth kind), or metres with DEPTH_LINEAR
// gInNormal        NORMAL_WEIGHTS: view space, unit, of the frame. A coarse texel has the normal of one of
//                  its pixels, the same as ambient_occlusion takes
// gOutUpsampled    RG16F: the value and 0, or occlusion and shadow
// A coarse sample that is NaN or beyond MAX_COLOUR has no share; of four such 0 remains. A pixel whose depth
// is none counts as sky.

#include "reprise/bilateral_upsampling.hlsli"
#include "reprise/conventions.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/occlusion_shadow_packing.hlsli"
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

// Red of the four texels of the footprint, left and right above, left and right below.
float4 readRed(TEXTURE_PARAMETER(coarse), CoarseFootprint footprint, float2 positionPx) {
#if HAS_GATHER
    float2 corner = floor(positionPx / COARSE_TEXEL_PX - 0.5) + 1.0;
    return GATHER_RED(coarse, pxToUv(corner, gCoarseSize.zw)).wzxy;
#else
    return float4(SAMPLE(coarse, footprint.leftUp).r, SAMPLE(coarse, footprint.rightUp).r,
                  SAMPLE(coarse, footprint.leftDown).r, SAMPLE(coarse, footprint.rightDown).r);
#endif
}

#if NORMAL_WEIGHTS
// Of a coarse texel, by the UV of its centre, which lies on a corner of the frame's texels: an eighth of the
// coarse one before it a texel is met for either ratio.
float3 readCoarseNormal(float2 coarseUv) {
    float2 positionPx = COARSE_TEXEL_PX * (coarseUv * gCoarseSize.xy - 0.125);
    return SAMPLE(gInNormal, pxToUv(positionPx, gOutputSize.zw)).xyz;
}
#endif

#if !VALUES_ONE
// What is no number stays none.
float2 unpackValues(float value) {
#if VALUES_OCCLUSION_IN_INTEGER
    return isNumber(value) ? unpackOcclusionInInteger(value) : value;
#else
    return isNumber(value) ? unpackShadowInInteger(value) : value;
#endif
}
#endif

// What the four coarse texels of a footprint hold, which several pixels share.
struct CoarseTexels {
    float4 values, depths;
#if NORMAL_WEIGHTS
    float3 normals[4];
#endif
};

CoarseTexels readCoarse(CoarseFootprint footprint, float2 positionPx) {
    CoarseTexels coarse;
    float4 values = readRed(TEXTURE_ARGUMENT(gInFiltered), footprint, positionPx);
    coarse.values = abs(values) <= MAX_COLOUR ? values : 2.0 * LARGEST_NUMBER;   // no number, no share
    coarse.depths = readRed(TEXTURE_ARGUMENT(gInCoarseDepth), footprint, positionPx);
#if NORMAL_WEIGHTS
    coarse.normals[0] = readCoarseNormal(footprint.leftUp);
    coarse.normals[1] = readCoarseNormal(footprint.rightUp);
    coarse.normals[2] = readCoarseNormal(footprint.leftDown);
    coarse.normals[3] = readCoarseNormal(footprint.rightDown);
#endif
    return coarse;
}

float2 upsampledValues(CoarseTexels coarse, float4 bilinearWeights, float2 positionPx, float depth) {
#if NORMAL_WEIGHTS
    float3 normal = SAMPLE(gInNormal, pxToUv(positionPx, gOutputSize.zw)).xyz;
    float4 normalWeights = normalWeightsOf(coarse.normals[0], coarse.normals[1], coarse.normals[2],
                                           coarse.normals[3], normal, gContrast);
#else
    float4 normalWeights = float4(1.0, 1.0, 1.0, 1.0);
#endif
    float4 values = coarse.values;
#if VALUES_ONE
    return float2(bilateralUpsample(values, bilinearWeights, normalWeights, coarse.depths, depth), 0.0);
#else
    return bilateralUpsample(unpackValues(values.x), unpackValues(values.y), unpackValues(values.z),
                             unpackValues(values.w), bilinearWeights, normalWeights, coarse.depths, depth);
#endif
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutUpsampled;

void storePixel(CoarseTexels coarse, float2 positionPx, float depth) {
    CoarseFootprint footprint = coarseFootprint(positionPx, COARSE_TEXEL_PX, gCoarseSize.xy);
    float2 values = upsampledValues(coarse, footprint.bilinearWeights, positionPx, depth);
    gOutUpsampled[uint2(positionPx)] = float4(values, 0.0, 0.0);
}

// Four pixels between the centres of the same coarse texels: one gather for each of three images. Of a ratio
// of 2 such pixels begin one before a multiple of two, so that groups cover a pixel more than the image has;
// what lies outside is not stored.
[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
#if RATIO_4
    float2 first = 2.0 * float2(thread.xy);
#else
    float2 first = 2.0 * float2(thread.xy) - 1.0;
#endif
    if (any(first >= gOutputSize.xy)) return;
    CoarseFootprint footprint = coarseFootprint(first + 1.0, COARSE_TEXEL_PX, gCoarseSize.xy);
    CoarseTexels coarse = readCoarse(footprint, first + 0.5);
    float4 depths = GATHER_RED(gInDepth, pxToUv(first + 1.0, gOutputSize.zw)).wzxy;
    bool2 low = first >= 0.0, high = first + 1.0 < gOutputSize.xy;
    if (low.x && low.y) storePixel(coarse, first + 0.5, linearDepth(depths.x));
    if (high.x && low.y) storePixel(coarse, first + float2(1.5, 0.5), linearDepth(depths.y));
    if (low.x && high.y) storePixel(coarse, first + float2(0.5, 1.5), linearDepth(depths.z));
    if (high.x && high.y) storePixel(coarse, first + 1.5, linearDepth(depths.w));
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    CoarseFootprint footprint = coarseFootprint(positionPx.xy, COARSE_TEXEL_PX, gCoarseSize.xy);
    CoarseTexels coarse = readCoarse(footprint, positionPx.xy);
    float depth = linearDepth(SAMPLE(gInDepth, pxToUv(positionPx.xy, gOutputSize.zw)).r);
    return float4(upsampledValues(coarse, footprint.bilinearWeights, positionPx.xy, depth), 0.0, 0.0);
}

#endif
