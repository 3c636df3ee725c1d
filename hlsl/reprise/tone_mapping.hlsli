// SPDX-License-Identifier: Apache-2.0
// Tone mapping that is taken back: "HDR inverse tone mapping MSAA resolve" (T4). Samples are tone mapped,
// averaged and mapped back, so that an edge beside a bright light stays smooth.
//
// A tone mapped value near its limit has lost what the way back needs, so two numbers are kept: the value,
// and what it lacks to the limit (1 for Reinhard, 1 - E/F = 14/15 for Hable), each from its own formula
// without a difference. Both are linear, so that means of them belong together.
//
// The printed inverses: the first takes the other root of the quadratic and is negative throughout; the
// second keeps 1 - value, which does not go to 0 at Hable's limit, and has lost 3 digits at 65504
// (docs/misprints.md).
#ifndef REPRISE_TONE_MAPPING_HLSLI
#define REPRISE_TONE_MAPPING_HLSLI

#include "reprise/bounded.hlsli"
#include "reprise/colour.hlsli"

// Hable's A 0.15, B 0.5, C 0.1, D 0.2, E 0.02, F 0.3, as printed. The value is
//   (x (A x + C B) + D E) / (x (A x + B) + D F) - E/F
//     = x (A (F-E) x + B (C F-E)) / (F (x (A x + B) + D F))
// and what it lacks
//   1 - E/F - value  =  (B (1-C) x + D (F-E)) / (x (A x + B) + D F).
static const float HABLE_A = 0.15;
static const float HABLE_B = 0.5;
static const float HABLE_F = 0.3;
static const float HABLE_DF = 0.06;             // D F
static const float HABLE_AFE = 0.042;           // A (F - E)
static const float HABLE_BCFE = 0.005;          // B (C F - E)
static const float HABLE_BC = 0.45;             // B (1 - C)
static const float HABLE_DFE = 0.056;           // D (F - E)
static const float HABLE_TURN = 0.033333333;    // (C F - E) / F: where the quadratic's middle term is 0
// Just below what 65504 lacks, Hable 4.58e-5 and Reinhard 1.527e-5: less comes from rounding alone.
static const float HABLE_LEAST_COMPLEMENT = 4.5e-5;
static const float REINHARD_LEAST_COMPLEMENT = 1.5e-5;

// Per channel: the tone mapped value, and what it lacks to the limit.
struct ToneMapped {
    float3 value, complement;
};

// x / (1 + x) and 1 / (1 + x). Colours are linear, 0 to 65504; others are repaired by sanitize().
ToneMapped toneMapReinhard(float3 colour) {
    ToneMapped mapped;
    mapped.complement = 1.0 / (1.0 + sanitize(colour));
    mapped.value = sanitize(colour) * mapped.complement;
    return mapped;
}

// value / complement: relative error 3e-7, at 0 exactly 0. Of sums as of means, as the count cancels.
float3 inverseToneMapReinhard(ToneMapped mapped) {
    float3 complement = bounded(mapped.complement, REINHARD_LEAST_COMPLEMENT, MAX_COLOUR);
    return sanitize(mapped.value / complement);
}

ToneMapped toneMapHable(float3 colour) {
    float3 x = sanitize(colour);
    float3 denominator = x * (HABLE_A * x + HABLE_B) + HABLE_DF;
    ToneMapped mapped;
    mapped.value = x * (HABLE_AFE * x + HABLE_BCFE) / (HABLE_F * denominator);
    mapped.complement = (HABLE_BC * x + HABLE_DFE) / denominator;
    return mapped;
}

// Solves A c x^2 - m x - D F t = 0 for the positive x; t value, c complement, m = B (1-C) - B c. Written with
// t, as B (t - TURN), m loses nothing. The root's sign follows that of m, so that two numbers of one sign are
// added, and the other form of the root is taken below the turn. Relative error at most 4e-6 (5.4e-7
// measured), at 0 exactly 0.
float3 inverseToneMapHable(ToneMapped mapped) {
    float3 t = bounded(mapped.value, 0.0, 1.0);
    float3 c = bounded(mapped.complement, HABLE_LEAST_COMPLEMENT, 1.0);
    float3 m = HABLE_B * (t - HABLE_TURN);
    float3 both = sqrt(m * m + 4.0 * HABLE_A * HABLE_DF * c * t) + abs(m);
    float3 above = both / (2.0 * HABLE_A * c);
    float3 below = 2.0 * HABLE_DF * t / both;
    return sanitize(float3(m.x > 0.0 ? above.x : below.x, m.y > 0.0 ? above.y : below.y,
                           m.z > 0.0 ? above.z : below.z));
}

// A resolve of n samples: start with noSamples(), add each, then resolve. n in [1, 4096].
ToneMapped noSamples() {
    ToneMapped sum;
    sum.value = float3(0.0, 0.0, 0.0);
    sum.complement = float3(0.0, 0.0, 0.0);
    return sum;
}

void addToneMapped(inout ToneMapped sum, ToneMapped mapped) {
    sum.value += mapped.value;
    sum.complement += mapped.complement;
}

// The plain mean, for comparison: one bright sample outshines the others.
void addBox(inout ToneMapped sum, float3 colour) {
    sum.value += sanitize(colour);
}

float3 resolveBox(ToneMapped sum, float count) {
    return sanitize(sum.value / max(count, 1.0));
}

// The inverse of the mean of x / (1 + x) is the mean of x weighted by w = 1 / (1 + x), sum(x w) / sum(w),
// exactly.
void addReinhard(inout ToneMapped sum, float3 colour) {
    addToneMapped(sum, toneMapReinhard(colour));
}

float3 resolveReinhard(ToneMapped sum) {
    return inverseToneMapReinhard(sum);
}

// The inverse of the mean of both numbers.
void addHable(inout ToneMapped sum, float3 colour) {
    addToneMapped(sum, toneMapHable(colour));
}

float3 resolveHable(ToneMapped sum, float count) {
    ToneMapped mean;
    mean.value = sum.value / max(count, 1.0);
    mean.complement = sum.complement / max(count, 1.0);
    return inverseToneMapHable(mean);
}

#endif
