// SPDX-License-Identifier: Apache-2.0
// The directional bilateral filter: Drobot, Listing 7.3. One or two values beside linear depth, filtered
// along one direction; two passes, across and down, make it two-dimensional. The footprint is 9 texels: the
// centre and +-1 to +-4. The listing reads it in 5 linear taps, each halfway between two texels.
//
// Linear taps average depth across an edge, and their values with it. Point taps take the same footprint in 9
// reads, let half as much through at an edge, and never take two surfaces for one between them (figures in
// docs/documents.md). What is packed (occlusion_shadow_packing.hlsli) must not pass a linear filter at all:
// fill PointTaps with values that were unpacked texel by texel.
//
// The listing as printed closes its function after two constants, declares three variables that nothing uses,
// and returns the value without its depth, which the second pass needs (docs/misprints.md).
#ifndef REPRISE_DIRECTIONAL_BILATERAL_HLSLI
#define REPRISE_DIRECTIONAL_BILATERAL_HLSLI

#include "reprise/bounded.hlsli"
#include "reprise/platform.hlsli"

// Listing 7.3, centerWeight and tapWeights; taps at +-1.5 and +-3.5 texels. With both sides they sum to 1 +
// 1e-9. They are a Gaussian of deviation 1 at the distances 0, 1 and 2, though a tap stands for two texels
// here.
static const float BILATERAL_CENTER_WEIGHT = 0.402619947;
static const float BILATERAL_INNER_WEIGHT = 0.244201342;
static const float BILATERAL_OUTER_WEIGHT = 0.054488685;
// Above this a smoothing counts as this: the centre then weighs 4 % of the whole.
static const float MAX_SMOOTHING = 16.0;
// Values and depth differences beyond this count as infinite: all sums below stay finite within it.
static const float LARGEST_TAP = 1e36;

// (value, value, depth) each, in the direction's order. A single value leaves y at 0.
struct LinearTaps {
    float3 tap[5];      // at -3.5, -1.5, 0, 1.5 and 3.5 texels
};

struct PointTaps {
    float3 tap[9];      // at -4 to 4 texels
};

// 1 / (1 + diffAmp abs(depth difference)), in [0,1]; 0 where a depth is NaN or infinite. diffAmp in 1 / unit
// of the depths, >= 0: IN_BilateralFilterAmp of the listing.
float depthSimilarity(float depth, float centreDepth, float diffAmp) {
    float difference = abs(depth - centreDepth);
    return difference <= LARGEST_TAP ? 1.0 / (1.0 + bounded(diffAmp, 0.0, LARGEST_TAP) * difference) : 0.0;
}

struct BilateralSum {
    float2 values;
    float weight;
};

// Adds a tap with its weight, unless it is broken: a NaN would spread over the footprint.
void addTap(inout BilateralSum sum, float3 tap, float weight) {
    bool usable = abs(tap.x) <= LARGEST_TAP && abs(tap.y) <= LARGEST_TAP;
    sum.values += usable ? tap.xy * weight : float2(0.0, 0.0);
    sum.weight += usable ? weight : 0.0;
}

BilateralSum sumOfCentre(float3 centre) {
    BilateralSum sum;
    sum.values = float2(0.0, 0.0);
    sum.weight = 0.0;
    addTap(sum, centre, BILATERAL_CENTER_WEIGHT);
    return sum;
}

// The mean, and the centre's depth carried on; 0 where no tap was usable. No depth is NaN or negative behind
// this.
float3 meanOfTaps(BilateralSum sum, float centreDepth) {
    float2 mean = sum.weight > 1e-30 ? sum.values * (1.0 / sum.weight) : float2(0.0, 0.0);
    return float3(mean, bounded(centreDepth, 0.0, LARGEST_TAP));
}

// How much the neighbours count, for `smoothing` below (the framework's step 6): 1, the listing's filter,
// from `converged` frames on, and growing to maxSmoothing where the history holds nothing. convergence in
// frames.
float smoothingOfConvergence(float convergence, float converged, float maxSmoothing) {
    float missing = 1.0 - bounded(convergence / max(converged, 1.0), 0.0, 1.0);
    return 1.0 + (bounded(maxSmoothing, 1.0, MAX_SMOOTHING) - 1.0) * missing;
}

// The filter of the listing over taps that a linear filter read. smoothing in [0, MAX_SMOOTHING] multiplies
// the weights of all taps but the centre: 1 is the listing, 0 gives the centre back. Returns both values and
// the centre's depth. A tap with a NaN counts for nothing, a centre with one is filled from its neighbours.
float3 bilateralOfLinearTaps(LinearTaps taps, float diffAmp, float smoothing) {
    float3 centre = taps.tap[2];
    float amount = bounded(smoothing, 0.0, MAX_SMOOTHING);
    BilateralSum sum = sumOfCentre(centre);
    [unroll] for (int i = 0; i < 5; i += 4) {
        float outer = depthSimilarity(taps.tap[i].z, centre.z, diffAmp) * BILATERAL_OUTER_WEIGHT;
        addTap(sum, taps.tap[i], amount * outer);
    }
    [unroll] for (int j = 1; j < 5; j += 2) {
        float inner = depthSimilarity(taps.tap[j].z, centre.z, diffAmp) * BILATERAL_INNER_WEIGHT;
        addTap(sum, taps.tap[j], amount * inner);
    }
    return meanOfTaps(sum, centre.z);
}

// The same over single texels: a linear tap's weight, half to each of its two texels. Where depth is constant
// both are the same filter.
float3 bilateralOfPointTaps(PointTaps taps, float diffAmp, float smoothing) {
    float3 centre = taps.tap[4];
    float amount = bounded(smoothing, 0.0, MAX_SMOOTHING);
    BilateralSum sum = sumOfCentre(centre);
    [unroll] for (int i = 1; i <= 4; ++i) {
        float weight = amount * 0.5 * (i <= 2 ? BILATERAL_INNER_WEIGHT : BILATERAL_OUTER_WEIGHT);
        addTap(sum, taps.tap[4 - i], weight * depthSimilarity(taps.tap[4 - i].z, centre.z, diffAmp));
        addTap(sum, taps.tap[4 + i], weight * depthSimilarity(taps.tap[4 + i].z, centre.z, diffAmp));
    }
    return meanOfTaps(sum, centre.z);
}

// The footprint of a texture with a linear filter; values in r and g, linear depth in a. offSize = Dir *
// texelSize.
LinearTaps readLinearTaps(TEXTURE_PARAMETER(inSampler), float2 UV, float2 offSize) {
    LinearTaps taps;
    taps.tap[0] = SAMPLE(inSampler, UV - 3.5 * offSize).rga;
    taps.tap[1] = SAMPLE(inSampler, UV - 1.5 * offSize).rga;
    taps.tap[2] = SAMPLE(inSampler, UV).rga;
    taps.tap[3] = SAMPLE(inSampler, UV + 1.5 * offSize).rga;
    taps.tap[4] = SAMPLE(inSampler, UV + 3.5 * offSize).rga;
    return taps;
}

// The footprint of a texture with a point filter.
PointTaps readPointTaps(TEXTURE_PARAMETER(inSampler), float2 UV, float2 offSize) {
    PointTaps taps;
    [unroll] for (int i = 0; i < 9; ++i) {
        taps.tap[i] = SAMPLE(inSampler, UV + float(i - 4) * offSize).rga;
    }
    return taps;
}

// Listing 7.3 over r and a of a texture with a linear filter. texelSize is 1 / extent, UV the texel's centre,
// Dir (1,0) or (0,1). Returns the value and its depth, for r and a of the target.
float2 Bilateral3D5x5(TEXTURE_PARAMETER(inSampler), float2 texelSize, float2 UV, float2 Dir, float diffAmp,
                      float smoothing) {
    LinearTaps taps = readLinearTaps(TEXTURE_ARGUMENT(inSampler), UV, Dir * texelSize);
    return bilateralOfLinearTaps(taps, diffAmp, smoothing).xz;
}

// The same of a texture with a point filter.
float2 Bilateral3D5x5Point(TEXTURE_PARAMETER(inSampler), float2 texelSize, float2 UV, float2 Dir,
                           float diffAmp, float smoothing) {
    PointTaps taps = readPointTaps(TEXTURE_ARGUMENT(inSampler), UV, Dir * texelSize);
    return bilateralOfPointTaps(taps, diffAmp, smoothing).xz;
}

#endif
