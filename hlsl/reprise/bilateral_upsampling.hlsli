// SPDX-License-Identifier: Apache-2.0
// Bilateral upsampling: Drobot, "Bilateral Upsampling", Listing 7.1 and figure 7.2. A fine pixel takes the
// mean of the four coarse samples around it, each weighted by its place, the likeness of its normal and the
// closeness of its depth. As printed the listing does not compile, and what it means divides 0 by 0.
//
// The coarse image is ceil(fine size / ratio) texels large, and texel i stands for the fine pixels from
// ratio * i on. Of an odd size the last texel reaches beyond the image, so coarse UV is not fine UV.
#ifndef REPRISE_BILATERAL_UPSAMPLING_HLSLI
#define REPRISE_BILATERAL_UPSAMPLING_HLSLI

#include "reprise/finite.hlsli"

// Smallest denominator of a depth weight, in the unit of the depths (metres): 0.0001f of Listing 7.1.
static const float DEPTH_WEIGHT_FLOOR = 0.0001;
// Largest exponent of a normal weight; a larger one counts as this.
static const float MAX_CONTRAST = 256.0;
// Weights that sum to less have lost too much to underflow to say anything.
static const float MIN_TOTAL_WEIGHT = 1e-30;

// The four coarse texels around a fine pixel. The listing's index i is x, y, z, w here: left and right above,
// left and right below.
struct CoarseFootprint {
    float2 leftUp, rightUp, leftDown, rightDown;   // UV of their centres, for a point filter
    float4 bilinearWeights;                        // in [0,1], sum 1
};

// right: how far right of the left texels, and below the upper ones, in coarse texels, [0,1].
float4 bilinearWeightsAt(float2 right) {
    float2 left = 1.0 - right;
    return float4(left.x, right.x, left.x, right.x) * float4(left.y, left.y, right.y, right.y);
}

// positionPx: centre of the fine pixel, at halves. ratio: fine pixels per coarse texel along an axis, 2 or 4,
// any from 1 on. coarseSize: in texels. The weights are bilinearWeights[texelNo] of the listing, for ratio 2
// 9/16, 3/16, 3/16 and 1/16 turned by the place in the 2x2 tile (figure 7.2), for ratio 4 products of 1/8,
// 3/8, 5/8 and 7/8. Beyond the border stands the border's own texel again.
CoarseFootprint coarseFootprint(float2 positionPx, float ratio, float2 coarseSize) {
    float2 positionTexels = positionPx / max(ratio, 1.0) - 0.5;   // whole at the centres of coarse texels
    float2 first = floor(positionTexels);
    float2 size = max(coarseSize, 1.0);
    float2 low = (clamp(first, 0.0, size - 1.0) + 0.5) / size;
    float2 high = (clamp(first + 1.0, 0.0, size - 1.0) + 0.5) / size;

    CoarseFootprint footprint;
    footprint.leftUp = low;
    footprint.rightUp = float2(high.x, low.y);
    footprint.leftDown = float2(low.x, high.y);
    footprint.rightDown = high;
    footprint.bilinearWeights = bilinearWeightsAt(positionTexels - first);
    return footprint;
}

// Likeness of two unit normals: cosine ^ contrastCoef, in [0,1]. Printed is dot(a + b), and pow of a negative
// cosine, which is NaN: here normals that face away weigh 0, and so do broken ones. A contrast of 0 or less
// leaves normals out.
float normalWeight(float3 normalLow, float3 normalHi, float contrastCoef) {
    float similarity = dot(normalLow, normalHi);
    float weight = similarity > 0.0 ? pow(min(abs(similarity), 1.0), min(contrastCoef, MAX_CONTRAST)) : 0.0;
    return contrastCoef > 0.0 ? weight : 1.0;
}

// Of four coarse normals, in the order of the footprint.
float4 normalWeightsOf(float3 leftUp, float3 rightUp, float3 leftDown, float3 rightDown, float3 normalHi,
                       float contrastCoef) {
    return float4(normalWeight(leftUp, normalHi, contrastCoef), normalWeight(rightUp, normalHi, contrastCoef),
                  normalWeight(leftDown, normalHi, contrastCoef),
                  normalWeight(rightDown, normalHi, contrastCoef));
}

// The share of each of four samples, sum 1. Depths are linear, in metres; a sky without end needs a finite
// one, as linearDepthFromDevice() gives. usable: 1 for a sample that is a number, else 0. What is not, or has
// no depth to compare, has no share. Where the weights are all 0 or underflow the sample nearest in depth has
// all of it (several equally near the same each); where no depth can be compared, all usable ones the same.
// Without a usable sample every share is 0.
float4 bilateralShares(float4 bilinearWeights, float4 normalWeights, float4 depthLow, float depthHi,
                       float4 usable) {
    float4 depthDiff = abs(depthHi - depthLow);
    float4 comparable = usable * numberMask(depthDiff);
    float4 weights = bilinearWeights * normalWeights / (DEPTH_WEIGHT_FLOOR + depthDiff);
    weights = comparable > 0.5 ? weights : 0.0;
    weights = weights > 0.0 ? weights : 0.0;
    float totalWeight = dot(weights, 1.0);

    float4 distance = comparable > 0.5 ? depthDiff : 2.0 * LARGEST_NUMBER;
    float nearest = min(min(distance.x, distance.y), min(distance.z, distance.w));
    float4 fallback = distance <= nearest ? usable : 0.0;

    bool isWeighed = totalWeight >= MIN_TOTAL_WEIGHT && totalWeight <= LARGEST_NUMBER;
    return isWeighed ? weights / totalWeight : fallback / max(dot(fallback, 1.0), 1.0);
}

// The same by depth alone, of depths that are numbers in [0, SKY_DEPTH], and of weights above 0: nothing
// underflows, and what is usable has a share. Over their common denominator the weights are products of the
// others' denominators, with one division for five. usable: 1 or 0.
float4 bilateralSharesOfDepths(float4 bilinearWeights, float4 depthLow, float depthHi, float4 usable) {
    float4 denominators = DEPTH_WEIGHT_FLOOR + abs(depthHi - depthLow);
    float4 weights = bilinearWeights * usable * denominators.yxxx * denominators.zzyy * denominators.wwwz;
    return weights * (1.0 / max(dot(weights, 1.0), MIN_TOTAL_WEIGHT));
}

// upsampledResult of the listing. Of samples that are no numbers 0 remains, if there is no other.
float bilateralUpsample(float4 sampleLow, float4 bilinearWeights, float4 normalWeights, float4 depthLow,
                        float depthHi) {
    float4 usable = numberMask(sampleLow);
    float4 shares = bilateralShares(bilinearWeights, normalWeights, depthLow, depthHi, usable);
    return dot(usable > 0.5 ? sampleLow : 0.0, shares);
}

float2 bilateralUpsample(float2 leftUp, float2 rightUp, float2 leftDown, float2 rightDown,
                         float4 bilinearWeights, float4 normalWeights, float4 depthLow, float depthHi) {
    float4 usable = float4(isNumber(leftUp), isNumber(rightUp), isNumber(leftDown), isNumber(rightDown));
    float4 shares = bilateralShares(bilinearWeights, normalWeights, depthLow, depthHi, usable);
    return shares.x * numberOrZero(leftUp) + shares.y * numberOrZero(rightUp) +
           shares.z * numberOrZero(leftDown) + shares.w * numberOrZero(rightDown);
}

float4 bilateralUpsample(float4 leftUp, float4 rightUp, float4 leftDown, float4 rightDown,
                         float4 bilinearWeights, float4 normalWeights, float4 depthLow, float depthHi) {
    float4 usable = float4(isNumber(leftUp), isNumber(rightUp), isNumber(leftDown), isNumber(rightDown));
    float4 shares = bilateralShares(bilinearWeights, normalWeights, depthLow, depthHi, usable);
    return shares.x * numberOrZero(leftUp) + shares.y * numberOrZero(rightUp) +
           shares.z * numberOrZero(leftDown) + shares.w * numberOrZero(rightDown);
}

// The same by depth alone, where coarse normals are not at hand ("we can simplify ...").
float bilateralUpsample(float4 sampleLow, float4 bilinearWeights, float4 depthLow, float depthHi) {
    return bilateralUpsample(sampleLow, bilinearWeights, float4(1.0, 1.0, 1.0, 1.0), depthLow, depthHi);
}

float2 bilateralUpsample(float2 leftUp, float2 rightUp, float2 leftDown, float2 rightDown,
                         float4 bilinearWeights, float4 depthLow, float depthHi) {
    return bilateralUpsample(leftUp, rightUp, leftDown, rightDown, bilinearWeights,
                             float4(1.0, 1.0, 1.0, 1.0), depthLow, depthHi);
}

float4 bilateralUpsample(float4 leftUp, float4 rightUp, float4 leftDown, float4 rightDown,
                         float4 bilinearWeights, float4 depthLow, float depthHi) {
    return bilateralUpsample(leftUp, rightUp, leftDown, rightDown, bilinearWeights,
                             float4(1.0, 1.0, 1.0, 1.0), depthLow, depthHi);
}

#endif
