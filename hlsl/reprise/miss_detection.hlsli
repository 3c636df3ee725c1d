// SPDX-License-Identifier: Apache-2.0
// Whether the cache holds the surface of a pixel: Scherzer, "Detecting cache misses" (S2), and magnification
// (S3). The slides compare In.PosPrev.z, device depth, with cache_val.w and leave open what that is. A
// constant threshold in device depth takes all that is far for one surface, so here both are linear, in
// metres. Read the cache's depth through a linear filter where you can: between two surfaces it fits neither,
// and misses.
#ifndef REPRISE_MISS_DETECTION_HLSLI
#define REPRISE_MISS_DETECTION_HLSLI

#include "reprise/coordinates.hlsli"
#include "reprise/depth.hlsli"
#include "reprise/finite.hlsli"

// How far a device depth in [0,1] may be off as stored, half a step: x times itself plus y.
static const float2 DEPTH_ROUNDING_FLOAT32 = float2(5.9604645e-8, 0.0);    // 2^-24
static const float2 DEPTH_ROUNDING_UNORM24 = float2(0.0, 2.9802324e-8);    // 1 / (2 (2^24 - 1))
static const float2 DEPTH_ROUNDING_UNORM16 = float2(0.0, 7.6295109e-6);    // 1 / (2 (2^16 - 1))
// What making it linear adds: three roundings of the device depth, and seven of the linear, each 2^-24.
static const float AFFINE_ROUNDING = 2.4e-7;
static const float DIVISION_ROUNDING = 4.8e-7;

// By how many metres a linear depth (metres, above 0) is off that was stored as device depth: with the square
// of the distance for a standard depth, with the distance for a reversed float ("complementary Z buffer").
// LARGEST_NUMBER where the format cannot tell the depth from infinity.
float linearDepthError(float linearDepth, float2 coefficients, float2 depthRounding) {
    float deviceDepth = abs(deviceDepthFromLinear(linearDepth, coefficients));
    float affineError = abs(coefficients.x) *
                        (deviceDepth * (depthRounding.x + AFFINE_ROUNDING) + depthRounding.y);
#if ORTHOGRAPHIC
    float error = affineError + abs(linearDepth) * DIVISION_ROUNDING;
#else
    // Linear is 1 / affine; a share off in the one is share / (1 - share) in the other.
    float share = linearDepth * affineError + DIVISION_ROUNDING;
    float error = share < 1.0 ? linearDepth * share / (1.0 - share) : LARGEST_NUMBER;
#endif
    return isNumber(error) ? error : LARGEST_NUMBER;
}

// A threshold "> depth buffer accuracy", in metres: one surface, stored twice, stays below it.
// leastThreshold: what is closer than this is one surface anyway.
float depthThreshold(float linearDepth, float2 coefficients, float2 depthRounding, float leastThreshold) {
    return max(2.0 * linearDepthError(linearDepth, coefficients, depthRounding), leastThreshold);
}

// "Depth as an ID". False for NaN.
bool isSameDepth(float lastDepth, float cacheDepth, float zThreshold) {
    return abs(lastDepth - cacheDepth) < zThreshold;
}

// For surfaces that touch. IDs are whole, up to 2^23, through a point filter: the mean of two is a third.
bool isSameObject(float objectId, float cacheObjectId) {
    return abs(objectId - cacheObjectId) < 0.5;
}

// bHit of the slides: in the viewport, and of the same depth within g_fZThres. False for NaN.
bool isCacheHit(float2 prevUv, float lastDepth, float cacheDepth, float zThreshold) {
    return isInsideUv(prevUv) && isSameDepth(lastDepth, cacheDepth, zThreshold);
}

bool isCacheHit(float2 prevUv, float lastDepth, float cacheDepth, float zThreshold, float objectId,
                float cacheObjectId) {
    return isCacheHit(prevUv, lastDepth, cacheDepth, zThreshold) && isSameObject(objectId, cacheObjectId);
}

// By as much a place in pixels is off: UV of binary32 times 16384 pixels, and the difference of two.
static const float PLACE_ERROR_PX = 1.0 / 256.0;
// An area that is less of the products it is the difference of may be their rounding.
static const float AREA_ROUNDING = 1e-6;

// Whether the pixel, as it lay in the previous image, covers the centre of one there; if not, history is
// magnified too much, and misses. prevPx: its place, centres at halves; ddxPx and ddyPx: the way to the next
// pixel in x and y, which span the parallelogram. The slide's PixR = max(|ddx|, |ddy|) / 2 per axis is that
// only without roll: at 45 degrees, where nothing is magnified, it misses half of all pixels, and at half a
// pixel's motion the rounding of ddx decides. Without area nothing is covered; false for NaN.
bool coversPixelCentre(float2 prevPx, float2 ddxPx, float2 ddyPx) {
    float2 f = frac(prevPx - 0.5);    // from the centre up and left; the other three lie 1 on
    float4 x = float4(f.x, f.x - 1.0, f.x, f.x - 1.0);
    float4 y = float4(f.y, f.y, f.y - 1.0, f.y - 1.0);
    float2 products = float2(ddxPx.x * ddyPx.y, ddxPx.y * ddyPx.x);
    float area = abs(products.x - products.y);
    float2 slack = PLACE_ERROR_PX * float2(abs(ddyPx.x) + abs(ddyPx.y), abs(ddxPx.x) + abs(ddxPx.y));
    float4 acrossDdx = abs(x * ddyPx.y - y * ddyPx.x) - slack.x;
    float4 acrossDdy = abs(x * ddxPx.y - y * ddxPx.x) - slack.y;
    float4 farther = max(acrossDdx, acrossDdy);
    float nearest = min(min(farther.x, farther.y), min(farther.z, farther.w));
    return area > AREA_ROUNDING * (abs(products.x) + abs(products.y)) && nearest <= 0.5 * area;
}

#if !STAGE_COMPUTE
// By the hardware's derivatives, outside of branches. size in pixels.
bool coversPixelCentre(float2 prevUv, float2 size) {
    float2 prevPx = uvToPx(prevUv, size);
    return coversPixelCentre(prevPx, ddx(prevPx), ddy(prevPx));
}
#endif

#endif
