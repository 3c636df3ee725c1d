// SPDX-License-Identifier: Apache-2.0
// Soft shadows of the sun from a cascaded shadow map with few samples a frame, for the framework to
// accumulate. Drobot, 7.3, "Soft Shadows" (D9): a percentage closer filter that takes "a different sample
// from a well-distributed sample set" each frame. Packed with occlusion: "Shadows and Ambient Occlusion
// Combined" (D10).
//
// gInCoarseDepth  linear depth in metres of depth_downsample; SKY_DEPTH and beyond, and what is no depth, is
//                 sky. At full resolution: the frame's own
// gInShadowMap    R32F or D32F, depth from the sun in [0,1], the cascades side by side in CASCADES equal
//                 columns. NaN shadows nothing
// gInOcclusion    VALUES packed: gOutOcclusion of ambient_occlusion, at the same texels
// gOutShadow      RG16F: visibility of the sun in [0,1], 1 in the sky and beyond the last cascade; or packed
//                 with occlusion; linear depth, metres
//
// A sample is a shadow texel within a disc around the point. Compared with it is the plane of the surface,
// taken at the centre of that texel: a plane does not shadow itself whatever its tilt, and what stands over
// it by more than gBias shadows it. One depth for all samples would take a bias that grows with the disc.
// Longer than 250 lines: four cascades, and the plane of the surface from depth alone.

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/occlusion_shadow_packing.hlsli"
#include "reprise/platform.hlsli"

// Every cascade looks along the sun's direction, so each is the first one scaled and moved: six numbers of a
// further cascade in place of twelve. The rows take (u d, v d, d, 1) of a texel's uv and depth d there, and
// with ORTHOGRAPHIC (u, v, d, 1): the view rays and the matrix in one.
BINDING(0) cbuffer SunShadowParameters {
    float4 gOutputSize;      // width, height, 1 / width, 1 / height
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
    float3 gBias;            // depth of the first cascade, that a metre of linear depth; steepest plane that
                             // is followed, in depth a texel of the first cascade
    float gSubsetCount;      // frames after which the pattern repeats, 1 to 16
};

TEXTURE_POINT(gInCoarseDepth, 1);
TEXTURE_POINT(gInShadowMap, 2);
#if !VALUES_ONE
TEXTURE_POINT(gInOcclusion, 3);
#endif

#if SAMPLES_1
static const int SAMPLE_COUNT = 1;
#elif SAMPLES_2
static const int SAMPLE_COUNT = 2;
#elif SAMPLES_4
static const int SAMPLE_COUNT = 4;
#elif SAMPLES_8
static const int SAMPLE_COUNT = 8;
#elif SAMPLES_12
static const int SAMPLE_COUNT = 12;
#elif SAMPLES_16
static const int SAMPLE_COUNT = 16;
#else
static const int SAMPLE_COUNT = 32;
#endif

// The additive sequence frac(1/2 + k SEQUENCE), k = 0, 1, ...: inverse powers of the root of x^3 = x + 1.
// Every run of it is spread evenly over the square: the samples of a frame, and those of all frames together.
static const float2 SEQUENCE = float2(0.7548776662, 0.5698402910);
static const float TWO_PI = 6.2831853;
// Texels squared; below it the surface is seen or lit along itself, and its plane is gBias.z steep.
static const float SMALLEST_AREA = 1e-20;

float knownDepth(float depth) {
    float positive = depth > 0.0 ? depth : SKY_DEPTH;
    return positive < SKY_DEPTH ? positive : SKY_DEPTH;
}

// Depths at the texel and beside it.
struct DepthPlus {
    float centre, left, right, up, down;
};

DepthPlus readDepthPlus(float2 uv) {
    DepthPlus d;
#if HAS_GATHER
    float4 leftUp = GATHER_RED(gInCoarseDepth, uv - 0.5 * gOutputSize.zw);
    float4 rightDown = GATHER_RED(gInCoarseDepth, uv + 0.5 * gOutputSize.zw);
    d.centre = knownDepth(leftUp.y);
    d.left = knownDepth(leftUp.x);
    d.up = knownDepth(leftUp.z);
    d.right = knownDepth(rightDown.z);
    d.down = knownDepth(rightDown.x);
#else
    d.centre = knownDepth(SAMPLE(gInCoarseDepth, uv).r);
    d.left = knownDepth(SAMPLE(gInCoarseDepth, uv - float2(gOutputSize.z, 0.0)).r);
    d.up = knownDepth(SAMPLE(gInCoarseDepth, uv - float2(0.0, gOutputSize.w)).r);
    d.right = knownDepth(SAMPLE(gInCoarseDepth, uv + float2(gOutputSize.z, 0.0)).r);
    d.down = knownDepth(SAMPLE(gInCoarseDepth, uv + float2(0.0, gOutputSize.w)).r);
#endif
    return d;
}

// What the rows of gToShadow take, its constant apart.
float3 screenPosition(float2 uv, float depth) {
#if ORTHOGRAPHIC
    return float3(uv, depth);
#else
    return float3(uv * depth, depth);
#endif
}

// The way over the surface to the next texel along step, as the rows take it: from the side whose depth is
// nearer to the centre's, for the other one may lie on another surface. Taken from the change of depth, not
// from two positions, which are far larger than their difference.
float3 surfaceStep(float2 uv, float2 step, float before, float centre, float after) {
    float differenceBefore = isInsideUv(uv - step) ? abs(before - centre) : 2.0 * SKY_DEPTH;
    float differenceAfter = isInsideUv(uv + step) ? abs(after - centre) : SKY_DEPTH;
    float2 change = differenceBefore < differenceAfter ? float2(centre - before, before)
                                                       : float2(after - centre, after);
#if ORTHOGRAPHIC
    return float3(step, change.x);
#else
    return float3(uv * change.x + step * change.y, change.x);
#endif
}

float3 toFirstCascade(float3 screen) {
    return float3(dot(gToShadowX.xyz, screen), dot(gToShadowY.xyz, screen), dot(gToShadowZ.xyz, screen));
}

// Depth from the sun that the plane of the surface gains a texel of the first cascade, in x and y.
float2 surfaceSlope(float2 uv, DepthPlus d) {
    float3 across = toFirstCascade(surfaceStep(uv, float2(gOutputSize.z, 0.0), d.left, d.centre, d.right));
    float3 down = toFirstCascade(surfaceStep(uv, float2(0.0, gOutputSize.w), d.up, d.centre, d.down));
    float3 normal = cross(across, down);
    float area = abs(normal.z) > SMALLEST_AREA ? normal.z : SMALLEST_AREA;
    return clamp(-normal.xy / area, -gBias.z, gBias.z);
}

struct Cascade {
    float3 scale, offset;   // from the first
    float index, farDepth;  // of the last one
};

// The cascade behind `nearer` where that one has ended. All are read and one is taken: a read at an index of
// its own for each pixel costs more where it exists.
Cascade following(Cascade nearer, float depth, float3 scale, float3 offset, float farDepth) {
    bool hasEnded = depth > nearer.farDepth;
    Cascade cascade;
    cascade.scale = hasEnded ? scale : nearer.scale;
    cascade.offset = hasEnded ? offset : nearer.offset;
    cascade.index = nearer.index + (hasEnded ? 1.0 : 0.0);
    cascade.farDepth = farDepth;
    return cascade;
}

Cascade cascadeAt(float depth) {
    Cascade cascade;
    cascade.scale = float3(1.0, 1.0, 1.0);
    cascade.offset = float3(0.0, 0.0, 0.0);
    cascade.index = 0.0;
    cascade.farDepth = gCascadeFar.x;
#if !CASCADES_1
    cascade = following(cascade, depth, gCascadeScale1.xyz, gCascadeOffset1.xyz, gCascadeFar.y);
#endif
#if CASCADES_3 || CASCADES_4
    cascade = following(cascade, depth, gCascadeScale2.xyz, gCascadeOffset2.xyz, gCascadeFar.z);
#endif
#if CASCADES_4
    cascade = following(cascade, depth, gCascadeScale3.xyz, gCascadeOffset3.xyz, gCascadeFar.w);
#endif
    return cascade;
}

// The 16 numbers k / 16 over 4x4 pixels, no two of a 2x2 closer than a quarter.
float pixelOffset(float2 pixel) {
    float2 fine = pixel - 2.0 * floor(0.5 * pixel);
    float2 coarse = floor(0.5 * pixel) - 2.0 * floor(0.25 * pixel);
    float2 both = 2.0 * abs(float2(fine.x - fine.y, coarse.x - coarse.y)) + float2(fine.y, coarse.y);
    return (4.0 * both.x + both.y) / 16.0;
}

// Whether the shadow map stands before `depth` by more than the bias. What lies beyond the map's range is
// compared with its end, where nothing was drawn.
float isOccluded(float mapDepth, float depth, float bias) {
#if SHADOW_REVERSED
    return mapDepth > max(depth, 0.0) + bias ? 1.0 : 0.0;
#else
    return mapDepth < min(depth, 1.0) - bias ? 1.0 : 0.0;
#endif
}

// place and slope: of the surface in the first cascade.
float visibilityAt(float3 place, float2 slope, float depth, float2 positionPx) {
    Cascade cascade = cascadeAt(depth);
    place = place * cascade.scale + cascade.offset;
    slope *= cascade.scale.z / cascade.scale.xy;
    float2 radius = max(gDisc.xy * cascade.scale.xy, gDisc.z);
    float bias = (gBias.x + gBias.y * depth) * cascade.scale.z;
    float2 lastTexel = gCascadeSize.xy - 0.5;
    float column = cascade.index * gCascadeSize.x;

    float2 pixel = floor(positionPx);
    float2 shift = subsetOfFrame(gFrameIndex, gSubsetCount) * frac(float(SAMPLE_COUNT) * SEQUENCE);
    float turn = TWO_PI * (shift.x + pixelOffset(pixel));
    float2 turned = float2(cos(turn), sin(turn));
    float areaShift = shift.y + pixelOffset(float2(pixel.y + 1.0, pixel.x));

    float occluded = 0.0;
    [unroll] for (int tap = 0; tap < SAMPLE_COUNT; ++tap) {
        float2 own = frac(0.5 + float(tap) * SEQUENCE);
        float2 azimuth = float2(cos(TWO_PI * own.x), sin(TWO_PI * own.x));
        azimuth = float2(azimuth.x * turned.x - azimuth.y * turned.y,
                         azimuth.x * turned.y + azimuth.y * turned.x);
        float2 texel = floor(place.xy + radius * sqrt(frac(own.y + areaShift)) * azimuth) + 0.5;
        // Not into another cascade's column.
        texel = clamp(texel, 0.5, lastTexel);
        float mapDepth = SAMPLE(gInShadowMap, float2(texel.x + column, texel.y) * gCascadeSize.zw).r;
        occluded += isOccluded(mapDepth, place.z + dot(slope, texel - place.xy), bias);
    }
    bool isCovered = isInsideUv(place.xy / gCascadeSize.xy) && depth <= cascade.farDepth;
    return isCovered ? 1.0 - occluded / float(SAMPLE_COUNT) : 1.0;
}

// Visibility, or visibility and occlusion packed, and linear depth.
float2 sunShadow(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
    DepthPlus depths = readDepthPlus(uv);
    float depth = depths.centre;
    float3 place = toFirstCascade(screenPosition(uv, depth)) +
                   float3(gToShadowX.w, gToShadowY.w, gToShadowZ.w);
    float visibility = visibilityAt(place, surfaceSlope(uv, depths), depth, positionPx);
    visibility = depth < SKY_DEPTH ? visibility : 1.0;
#if VALUES_OCCLUSION_IN_INTEGER
    return float2(packOcclusionInInteger(SAMPLE(gInOcclusion, uv).r, visibility), depth);
#elif VALUES_SHADOW_IN_INTEGER
    return float2(packShadowInInteger(SAMPLE(gInOcclusion, uv).r, visibility), depth);
#else
    return float2(visibility, depth);
#endif
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutShadow;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    gOutShadow[thread.xy] = float4(sunShadow(float2(thread.xy) + 0.5), 0.0, 0.0);
}

#else

// Four components, for shader model 3 takes no fewer.
float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(sunShadow(positionPx.xy), 0.0, 0.0);
}

#endif
