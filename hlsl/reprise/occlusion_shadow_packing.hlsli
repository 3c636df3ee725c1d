// SPDX-License-Identifier: Apache-2.0
// Two values of [0,1] in one binary16: Drobot, Listing 7.4; and in one binary32, with the frames of their
// history (the end of this file). In the binary16 one becomes a whole number from 0 to 31, the
// other the fraction. Never to be read through a linear filter. Text and listing disagree on which is which:
// both are here. A binary16 has 11 significant bits, (range + 1) levels of the fraction <= 2^11: 31 leaves it
// 64 (docs/documents.md).
#ifndef REPRISE_OCCLUSION_SHADOW_PACKING_HLSLI
#define REPRISE_OCCLUSION_SHADOW_PACKING_HLSLI

#include "reprise/bounded.hlsli"

// Largest integer part, and what the printed form keeps the fraction from 0 and 1; Listing 7.4.
static const float PACK_RANGE = 31.0;
static const float MIN_FLT = 0.01;
// The fraction that stands for 1: the largest that binary16 holds beside PACK_RANGE. No rounding lifts it.
static const float PACK_FRACTION = 0.984375;

// `whole` to the nearest of 32 levels (error 1/62), `part` in the fraction (error 1/126 where the store
// rounds to nearest, 1/63 where it truncates; half of it for each halving of the integer). NaN is 0.
float packUnitPair(float whole, float part) {
    float integer = floor(bounded(whole, 0.0, 1.0) * PACK_RANGE + 0.5);
    return integer + bounded(part, 0.0, 1.0) * PACK_FRACTION;
}

// The inverse, (whole, part) in [0,1] for whatever the channel holds, NaN and infinity among it.
float2 unpackUnitPair(float packed) {
    float known = bounded(packed, 0.0, PACK_RANGE + PACK_FRACTION);
    float integer = floor(known);
    return float2(integer * (1.0 / PACK_RANGE), min((known - integer) * (1.0 / PACK_FRACTION), 1.0));
}

// Of four channels the sum of what unpackUnitPair() makes of each, times its share: a filter between them.
float2 sumOfUnitPairs(float4 packed, float4 shares) {
    float4 known = bounded(packed, 0.0, PACK_RANGE + PACK_FRACTION);
    float4 integers = floor(known);
    float4 fractions = min(known - integers, PACK_FRACTION);
    return float2(dot(shares, integers) * (1.0 / PACK_RANGE), dot(shares, fractions) * (1.0 / PACK_FRACTION));
}

// The listing's order: occlusion in the integer part, shadow in the fraction.
float packOcclusionInInteger(float occlusion, float shadow) {
    return packUnitPair(occlusion, shadow);
}

// (occlusion, shadow)
float2 unpackOcclusionInInteger(float packed) {
    return unpackUnitPair(packed);
}

// The text's order: shadow in the integer part, occlusion, which "requires more variety", in the fraction.
float packShadowInInteger(float occlusion, float shadow) {
    return packUnitPair(shadow, occlusion);
}

// (occlusion, shadow)
float2 unpackShadowInInteger(float packed) {
    return unpackUnitPair(packed).yx;
}

// As printed: occlusion loses half a level on average, shadow 0 and 1 come back as 0.01 and 0.99. For data of
// others.
float PackOccShadow(float Occ, float Shadow) {
    float integer = floor(bounded(Occ, 0.0, 1.0) * PACK_RANGE);
    return integer + bounded(Shadow, MIN_FLT, 1.0 - MIN_FLT);
}

// (occlusion, shadow). Printed without the bound: NaN, infinity and more than 1 for what no packing wrote.
float2 UnpackOccShadow(float OccShadow) {
    float known = bounded(OccShadow, 0.0, PACK_RANGE + 1.0 - MIN_FLT);
    float integer = floor(known);
    return float2(min(integer / PACK_RANGE, 1.0), known - integer);
}

// --- With the frames of their history

// In no document. A whole number below 2^24, which a binary32 holds: frames in the highest 4 bits, occlusion
// in 10, shadow in the lowest 10.
static const float UNIT_STEPS = 1023.0;
static const float MAX_PACKED_FRAMES = 15.0;

// values: (occlusion, shadow), to the nearest of 1024 levels (error 1/2046). frames: to the nearest whole
// number up to MAX_PACKED_FRAMES. NaN is 0.
float packWithFrames(float2 values, float frames) {
    float2 levels = floor(bounded(values, 0.0, 1.0) * UNIT_STEPS + 0.5);
    return (floor(bounded(frames, 0.0, MAX_PACKED_FRAMES) + 0.5) * 1024.0 + levels.x) * 1024.0 + levels.y;
}

struct VisibilitiesOfFour {
    float4 occlusion, shadow;   // [0,1]
    float4 frames;              // [0, MAX_PACKED_FRAMES]
    float4 usable;              // 1; or 0 for a number below 0 or from 2^24 on and NaN, which hold 0
};

// Of four texels, for what reads several reads them by a gather.
VisibilitiesOfFour unpackWithFrames(float4 packed) {
    VisibilitiesOfFour four;
    four.usable = packed >= 0.0 && packed < 16777216.0 ? 1.0 : 0.0;
    float4 known = four.usable > 0.5 ? packed : 0.0;
    four.frames = floor(known * (1.0 / 1048576.0));
    float4 both = known - four.frames * 1048576.0;
    float4 level = floor(both * (1.0 / 1024.0));
    four.occlusion = level * (1.0 / UNIT_STEPS);
    four.shadow = min((both - level * 1024.0) * (1.0 / UNIT_STEPS), 1.0);
    return four;
}

#endif
