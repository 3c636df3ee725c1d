// SPDX-License-Identifier: Apache-2.0
// Colour: repair, luminance, YCoCg, and the weighting that keeps HDR emitters from flickering.
#ifndef REPRISE_COLOUR_HLSLI
#define REPRISE_COLOUR_HLSLI

#include "reprise/conventions.hlsli"

// Makes a colour safe to keep: NaN and negative become 0, infinity and above become MAX_COLOUR. The
// comparison is false for NaN; max(c, 0) would be undefined for it.
float3 sanitize(float3 colour) {
    float3 positive = float3(colour.r > 0.0 ? colour.r : 0.0, colour.g > 0.0 ? colour.g : 0.0,
                             colour.b > 0.0 ? colour.b : 0.0);
    return min(positive, MAX_COLOUR);
}

// The binary32 above 1 / MAX_COLOUR: with it no binary16 comes back smaller, of which a store that cuts off
// digits would make the next smaller one.
static const float UNIT_PER_COLOUR = 1.52662451e-5;

// The same repair in the range of saturate, which GPUs do at no cost: a share of MAX_COLOUR, NaN and negative
// to 0, infinity and above to 1. saturate(NaN) is 0 in Direct3D; reprisec gives SPIR-V the clamp that says
// so.
float3 toUnitColour(float3 colour) {
    return saturate(colour * UNIT_PER_COLOUR);
}

// The inverse, of [0, 1] or a rounding above. There and back costs four roundings of binary32.
float3 fromUnitColour(float3 unit) {
    return unit * MAX_COLOUR;
}

// Of linear Rec. 709 colour.
static const float3 LUMINANCE_WEIGHTS = float3(0.2126, 0.7152, 0.0722);

// Relative luminance.
float luminance(float3 colour) {
    return dot(colour, LUMINANCE_WEIGHTS);
}

// Y in [0,1], Co and Cg in [-0.5,0.5] for colour in [0,1]. INSIDE bonus slide, "Clipping in YCoCg".
float3 rgbToYcocg(float3 rgb) {
    return float3(0.25 * rgb.r + 0.5 * rgb.g + 0.25 * rgb.b, 0.5 * rgb.r - 0.5 * rgb.b,
                  -0.25 * rgb.r + 0.5 * rgb.g - 0.25 * rgb.b);
}

float3 ycocgToRgb(float3 ycocg) {
    float base = ycocg.x - ycocg.z;
    return float3(base + ycocg.y, ycocg.x + ycocg.z, base - ycocg.y);
}

float maxComponent(float3 colour) {
    return max(colour.r, max(colour.g, colour.b));
}

// [0, MAX_COLOUR] to [0, 1): Reinhard on the largest component, so that hue is kept and averages weigh each
// sample by 1 / (1 + max). HDR resolve, T4; Karis for temporal anti-aliasing. Without the inner maximum a
// colour of -1 would be divided by 0.
float3 compressHdr(float3 colour) {
    return colour / (1.0 + max(maxComponent(colour), 0.0));
}

// The inverse. A maximum of 1 and above, which rounding can bring, gives MAX_COLOUR and no infinity.
float3 expandHdr(float3 compressed) {
    return min(compressed / max(1.0 - maxComponent(compressed), 1.0 / (1.0 + MAX_COLOUR)), MAX_COLOUR);
}

#endif
