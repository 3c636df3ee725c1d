// SPDX-License-Identifier: Apache-2.0
// Scalable ambient obscurance, accumulated over frames before it is blurred: Wronski, "Algorithm overview"
// (W1 to W3). Taps on a spiral that each pixel turns its own way, of which each frame takes every third; the
// history, fetched along the motion vector, weighs 0.9 where its depth is the pixel's and falls smoothly to
// 0. Its depth comes in the same texel, so that rejection costs no fetch. In motion it weighs less than the
// document's 0.9: neighbours bring other taps, and what is stale does not stay.
//
// gInDepthHierarchy  R32F, metres, of depth_hierarchy
// gInVelocity        MOTION: motion; times gMotionToUv it is currUv - prevUv
// gHistoryObscurance TEMPORAL: gOutObscurance of the frame before
// gOutObscurance     RGBA8, the fine form of occlusion_depth_packing.hlsli: visibility in [0,1], 1 where
//                    nothing occludes and in the sky; depth up to gFarDepth; frames held, up to 15. In 8 bits
//                    alone a history of weight 0.9 would stop five levels short of its target
//
// The document leaves the estimator to McGuire et al., "Scalable Ambient Obscurance": with v from the point
// to a tap's, in radii, a tap counts (1 - v.v)^3 max(v.n - bias, 0) / (v.v + 0.01), here at most 0.6. Theirs
// takes a tap's depth for that of the place asked for; here it lies where its texel lies, so that slopes do
// not occlude themselves.
// Longer than 250 lines: eight sample counts, and the document blends in this very pass.

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/exponential_history.hlsli"
#include "reprise/occlusion_depth_packing.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/reprojection.hlsli"
#include "reprise/reprojection_cache.hlsli"

BINDING(0) cbuffer ScalableObscuranceParameters {
    float4 gOutputSize;           // width, height, 1 / width, 1 / height
    float4 gViewRay;              // extent and origin of the view rays, see viewPosition()
    float gRadius;                // metres, above 0; the document's reaches 1.5
    float gIntensity;             // 1, more is darker
    float2 gBias;                 // metres, and metres per metre of depth, that a tap must stand out by
    float gFrameIndex;            // whole, see subsetOfFrame()
    float gRotationCount;         // frames after which the pattern repeats, 1 to 16; the document has 3
    float gFarDepth;              // metres, from which on all is as far for the history and the blur
    float gMaxWeight;             // most weight of history, up to 15/16; the document has 0.9
    float2 gMissThreshold;        // metres, and metres a metre of depth, from which on history has no weight
    float2 gMotionToUv;           // (1, 1) for currUv - prevUv in UV
    float4 gViewToPreviousDepth;  // dot with (view position, 1) is linear depth in the previous view
    float gHistoryValid;          // 0 on the first frame, after a cut, a gap or a resize
    float gMovingWeight;          // MOTION: most weight of history in motion, up to gMaxWeight
    float gMovingPx;              // MOTION: pixels a frame, above 0, from which on gMovingWeight holds
};

TEXTURE_POINT(gInDepthHierarchy, 1);
#if TEMPORAL && MOTION
TEXTURE_POINT(gInVelocity, 2);
#endif
#if TEMPORAL
TEXTURE_POINT(gHistoryObscurance, 3);
#endif

#if SAMPLES_3
static const int SAMPLE_COUNT = 3;
#elif SAMPLES_5
static const int SAMPLE_COUNT = 5;
#elif SAMPLES_7
static const int SAMPLE_COUNT = 7;
#elif SAMPLES_9
static const int SAMPLE_COUNT = 9;
#elif SAMPLES_11
static const int SAMPLE_COUNT = 11;
#elif SAMPLES_15
static const int SAMPLE_COUNT = 15;
#elif SAMPLES_21
static const int SAMPLE_COUNT = 21;
#else
static const int SAMPLE_COUNT = 33;
#endif

static const float TWO_PI = 6.2831853;
// Turns from a tap to the next, of the spiral that all rotations make together: the golden angle, by which
// the taps of any run are spread evenly.
static const float GOLDEN_TURN = 0.38196601;
// Of the mean tap, so that gIntensity is about 1: the factor in use with this estimator.
static const float NORMALISATION = 5.0;
// Radii squared: keeps a tap at the point itself finite.
static const float NEAR_LIMIT = 0.01;
// Of one tap, whose formula reaches 5: few taps with one of those are darker than black, what is beyond black
// is lost, and frames no longer average to what all their taps together show. Empirical, by the error against
// rays: docs/scalable_obscurance.md, "The bound of a tap".
static const float MOST_OF_A_TAP = 0.6;

// Texel of the hierarchy, and the place in the frame whose depth it holds.
struct Tap {
    float2 hierarchyUv;
    float2 placePx;
};

float2 hierarchyTexelSize() {
    return float2(1.0 / ceil(1.5 * gOutputSize.x), gOutputSize.w);
}

// Two texels of the level per eighth of the distance: a level k from 2^(k+3) px on. As no tap is farther away
// than the lesser extent, every level that is met has 8 texels or more along either axis.
Tap tapAt(float2 px, float distancePx) {
    float share = distancePx < 16.0    ? 1.0
                  : distancePx < 32.0  ? 0.5
                  : distancePx < 64.0  ? 0.25
                  : distancePx < 128.0 ? 0.125
                                       : 0.0625;
    float stride = 1.0 / share;
    float2 texel = min(floor(px * share), floor(gOutputSize.xy * share) - 1.0);
    float quarter = floor(0.25 * stride);
    float2 isOdd = 2.0 * frac(0.5 * texel.yx);
    float2 begin = float2(share < 1.0 ? gOutputSize.x : 0.0,
                          max(gOutputSize.y - floor(2.0 * share * gOutputSize.y), 0.0));
    Tap tap;
    tap.placePx = texel * stride + lerp(stride - 1.0 - quarter, quarter, isOdd) + 0.5;
    tap.hierarchyUv = pxToUv(begin + texel + 0.5, hierarchyTexelSize());
    return tap;
}

float knownDepth(float depth) {
    float positive = depth > 0.0 ? depth : SKY_DEPTH;
    return positive < SKY_DEPTH ? positive : SKY_DEPTH;
}

// Depths at the texel and beside it.
struct DepthPlus {
    float centre, left, right, up, down;
};

DepthPlus readDepthPlus(float2 positionPx) {
    float2 texelSize = hierarchyTexelSize();
    float2 uv = pxToUv(positionPx, texelSize);
    DepthPlus d;
#if HAS_GATHER
    float4 leftUp = GATHER_RED(gInDepthHierarchy, uv - 0.5 * texelSize);
    float4 rightDown = GATHER_RED(gInDepthHierarchy, uv + 0.5 * texelSize);
    d.centre = knownDepth(leftUp.y);
    d.left = knownDepth(leftUp.x);
    d.up = knownDepth(leftUp.z);
    d.right = knownDepth(rightDown.z);
    d.down = knownDepth(rightDown.x);
#else
    d.centre = knownDepth(SAMPLE(gInDepthHierarchy, uv).r);
    d.left = knownDepth(SAMPLE(gInDepthHierarchy, uv - float2(texelSize.x, 0.0)).r);
    d.up = knownDepth(SAMPLE(gInDepthHierarchy, uv - float2(0.0, texelSize.y)).r);
    d.right = knownDepth(SAMPLE(gInDepthHierarchy, uv + float2(texelSize.x, 0.0)).r);
    d.down = knownDepth(SAMPLE(gInDepthHierarchy, uv + float2(0.0, texelSize.y)).r);
#endif
    return d;
}

// The way over the surface to the next texel along step, from the side whose depth is nearer to the centre's:
// the other one may lie on another surface. At a border there is one side alone; where there is none, the
// surface faces the camera.
float3 surfaceStep(float3 positionVS, float2 uv, float2 step, float before, float after) {
    float differenceBefore = isInsideUv(uv - step) ? abs(before - positionVS.z) : 2.0 * SKY_DEPTH;
    float differenceAfter = isInsideUv(uv + step) ? abs(after - positionVS.z) : SKY_DEPTH;
    after = differenceAfter < SKY_DEPTH ? after : positionVS.z;
    return differenceBefore < differenceAfter ? positionVS - viewPosition(uv - step, before, gViewRay)
                                              : viewPosition(uv + step, after, gViewRay) - positionVS;
}

float3 reconstructedNormal(float3 positionVS, float2 uv, DepthPlus d) {
    float3 across = surfaceStep(positionVS, uv, float2(gOutputSize.z, 0.0), d.left, d.right);
    float3 down = surfaceStep(positionVS, uv, float2(0.0, gOutputSize.w), d.up, d.down);
    // Towards the camera, whichever way the rays run over the image.
    float3 normal = cross(across, down) * (gViewRay.x * gViewRay.y < 0.0 ? 1.0 : -1.0);
    float lengthSquared = dot(normal, normal);
    return lengthSquared > 1e-36 ? normal * rsqrt(lengthSquared) : float3(0.0, 0.0, -1.0);
}

// 256 numbers in [0,1), exact: a lattice by the powers of 1/1.3247, which spreads those of any few
// neighbouring pixels evenly, so that the blur averages turns of all directions.
float numberOfPixel(float2 pixel) {
    return frac(dot(pixel, float2(193.0, 146.0)) / 256.0);
}

// What a tap adds; toTap in radii. False for NaN: a tap without depth adds nothing.
float obscuranceOf(float3 toTap, float3 normal, float bias) {
    float square = dot(toTap, toTap);
    float near = 1.0 - square;
    float term = near * near * near * max(dot(toTap, normal) - bias, 0.0) / (square + NEAR_LIMIT);
    return square < 1.0 ? min(term, MOST_OF_A_TAP) : 0.0;
}

// The radius in pixels of the image, at most its lesser extent.
float2 radiusInPx(float depth) {
    float2 pxPerMetre = gOutputSize.xy / abs(gViewRay.xy);
#if !ORTHOGRAPHIC
    pxPerMetre = pxPerMetre / depth;
#endif
    return min(gRadius * pxPerMetre, min(gOutputSize.x, gOutputSize.y));
}

// Tap i of rotation f of n is tap n i + f of a spiral of n times as many: together they are that spiral.
float visibilityAt(float3 positionVS, float3 normal, float2 positionPx) {
    float rotations = wholeSubsets(gRotationCount);
    float rotation = subsetOfFrame(gFrameIndex, gRotationCount);
    float turn = TWO_PI * frac(numberOfPixel(floor(positionPx)) + GOLDEN_TURN * rotation);
    float turnStep = TWO_PI * frac(GOLDEN_TURN * rotations);
    float2 direction = float2(cos(turn), sin(turn));
    float2 directionStep = float2(cos(turnStep), sin(turnStep));
    float firstShare = (rotation + 0.5) / (float(SAMPLE_COUNT) * rotations);
    float2 radiusPx = radiusInPx(positionVS.z);
    float largestPx = max(radiusPx.x, radiusPx.y);
    float perRadius = 1.0 / gRadius;
    float bias = (gBias.x + gBias.y * positionVS.z) * perRadius;

    float2 sum = float2(0.0, 0.0);
    [unroll] for (int i = 0; i < SAMPLE_COUNT; ++i) {
        float radiusShare = float(i) / float(SAMPLE_COUNT) + firstShare;
        float2 px = positionPx + radiusShare * radiusPx * direction;
        Tap tap = tapAt(px, radiusShare * largestPx);
        float depth = SAMPLE(gInDepthHierarchy, tap.hierarchyUv).r;
        float3 tapVS = viewPosition(pxToUv(tap.placePx, gOutputSize.zw), depth, gViewRay);
        float obscurance = obscuranceOf((tapVS - positionVS) * perRadius, normal, bias);
        sum += isInsideUv(px * gOutputSize.zw) ? float2(obscurance, 1.0) : float2(0.0, 0.0);
        direction = float2(direction.x * directionStep.x - direction.y * directionStep.y,
                           direction.x * directionStep.y + direction.y * directionStep.x);
    }
    return bounded(1.0 - NORMALISATION * gIntensity * sum.x / max(sum.y, 1.0), 0.0, 1.0);
}

#if TEMPORAL && MOTION

// gMaxWeight for what stands still, gMovingWeight from gMovingPx on, smooth between.
float maxWeightOf(float2 motion) {
    float least = min(gMovingWeight, gMaxWeight);
    return least + velocityWeight(length(motion * gOutputSize.xy), gMaxWeight - least, 0.0, gMovingPx);
}

#endif

#if TEMPORAL

// The history where the surface was, how far it is the same surface, and the blend.
OcclusionDepth accumulated(OcclusionDepth current, float2 uv, float3 positionVS) {
#if MOTION
    float2 motion = SAMPLE(gInVelocity, uv).rg * gMotionToUv;
    float lastDepth = dot(gViewToPreviousDepth, float4(positionVS, 1.0));
    float maxWeight = maxWeightOf(motion);
#else
    float2 motion = float2(0.0, 0.0);
    float lastDepth = positionVS.z;
    float maxWeight = gMaxWeight;
#endif
    CachePlace place = cachePlaceFromMotion(uv, motion, min(lastDepth, gFarDepth));
    OcclusionDepth history = unpackFineOcclusionDepth(SAMPLE(gHistoryObscurance, place.prevUv), gFarDepth);

    // Whole up to half the threshold, from there on smoothly down.
    float threshold = max(gMissThreshold.x + gMissThreshold.y * place.lastDepth, 1e-6);
    float room = cacheHistoryWeight(place, history.linearDepth, threshold, 2.0 / threshold) * gHistoryValid;
    float confidence = room * room * (3.0 - 2.0 * room);

    float held = history.convergence * confidence;
    float weight = convergenceWeight(held, maxWeight);
    current.occlusion = exponentialHistory(history.occlusion, current.occlusion, weight);
    current.convergence = nextConvergence(history.convergence, confidence);
    return current;
}

// Of pixel and frame, in (0,1): consecutive frames of a pixel differ by the golden ratio, so that few of them
// have a mean of about a half.
float noiseOfFrame(float2 positionPx) {
    float number = numberOfPixel(floor(positionPx)) + 159.0 * frac(gFrameIndex / 256.0);
    return frac(number) + 1.0 / 512.0;
}

#endif

float4 obscurance(float2 positionPx) {
    float2 uv = pxToUv(positionPx, gOutputSize.zw);
    DepthPlus depths = readDepthPlus(positionPx);
    float3 positionVS = viewPosition(uv, depths.centre, gViewRay);
    float3 normal = reconstructedNormal(positionVS, uv, depths);

    OcclusionDepth result;
    float visibility = visibilityAt(positionVS, normal, positionPx);
    result.occlusion = depths.centre < SKY_DEPTH ? visibility : 1.0;
    result.linearDepth = depths.centre;
    result.convergence = 1.0;
#if TEMPORAL
    result = accumulated(result, uv, positionVS);
    return packFineOcclusionDepth(result, gFarDepth, noiseOfFrame(positionPx));
#else
    return packFineOcclusionDepth(result, gFarDepth, 0.5);
#endif
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutObscurance;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutObscurance[thread.xy] = obscurance(float2(thread.xy) + 0.5);
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return obscurance(positionPx.xy);
}

#endif
