// SPDX-License-Identifier: Apache-2.0
// Writing a history that few bits hold. The stiff case of feedback: h = h w + r (1-w) moves by (r - h) (1-w),
// and when that is less than the format can express, the stored value stops short of its target. It stays at
// a distance of up to
//   step / 2 / (1 - w)   where the store rounds to nearest,
//   step / (1 - w)       where it truncates, below the target only,
// for ever: at w = 0.97 in 8 bits, 17 levels. Two remedies: noise before rounding, so that the mean over
// frames is right, or the rounding error kept beside the value.
//
// Vulkan and Direct3D leave it to the device how it rounds to binary16. What these functions return, binary16
// holds exactly, so the store changes nothing.
#ifndef REPRISE_HISTORY_WRITE_HLSLI
#define REPRISE_HISTORY_WRITE_HLSLI

#include "reprise/bounded.hlsli"
#include "reprise/conventions.hlsli"

// Distance of neighbouring values of an 8-bit unorm channel.
static const float UNORM8_STEP = 1.0 / 255.0;
// With more noise than this, the sum of a value of 11 bits and the noise could round up to the next step.
static const float LARGEST_NOISE = 0.9998;

// Distance of neighbouring binary16 around a value: 2^-10 of the largest power of two that is not above its
// magnitude, 2^-24 below 2^-14 (0.000061); from 65504 on that of 65504. By comparisons, so that no logarithm
// rounds it.
float binary16Step(float value) {
    float magnitude = bounded(abs(value), 0.0, MAX_COLOUR);
    float power = 0.00006103515625;
    power *= magnitude >= power * 65536.0 ? 65536.0 : 1.0;
    power *= magnitude >= power * 256.0 ? 256.0 : 1.0;
    power *= magnitude >= power * 16.0 ? 16.0 : 1.0;
    power *= magnitude >= power * 4.0 ? 4.0 : 1.0;
    power *= magnitude >= power * 2.0 ? 2.0 : 1.0;
    return power / 1024.0;
}

// How far from its target a history of that step may stop; weight in [0,1].
float feedbackResidual(float stepSize, float weight) {
    return 0.5 * stepSize / bounded(1.0 - weight, 1e-7, 1.0);
}

float feedbackResidualTruncated(float stepSize, float weight) {
    return stepSize / bounded(1.0 - weight, 1e-7, 1.0);
}

// value to a binary16 that is not above value + noise steps: with a noise that is uniform in [0,1), different
// in each frame and pixel, the mean of what is written is value. noise 0.5 rounds to nearest, 0 down. Values
// end at +-65504, NaN gives 0.
float ditheredHalf(float value, float noise) {
    float known = bounded(abs(value), 0.0, MAX_COLOUR) * (value < 0.0 ? -1.0 : 1.0);
    float stepSize = binary16Step(known);
    return floor(known / stepSize + bounded(noise, 0.0, LARGEST_NOISE)) * stepSize;
}

// The same for an 8-bit unorm channel; value in [0,1], what lies outside is clamped.
float ditheredUnorm8(float value, float noise) {
    return floor(bounded(value, 0.0, 1.0) * 255.0 + bounded(noise, 0.0, LARGEST_NOISE)) / 255.0;
}

// (stored, error): value to the nearest binary16, and what that leaves, in [-1/2, 1/2] steps, for a second
// binary16 channel. Together they are the history that the next frame blends with, to 2^-12 of a step.
float2 errorCarryingHalf(float value) {
    float known = bounded(abs(value), 0.0, MAX_COLOUR) * (value < 0.0 ? -1.0 : 1.0);
    float stored = ditheredHalf(known, 0.5);
    return float2(stored, (known - stored) / binary16Step(stored));
}

// The history that both channels hold; NaN counts as 0.
float errorCarriedHalf(float2 channels) {
    float stored = bounded(abs(channels.x), 0.0, MAX_COLOUR) * (channels.x < 0.0 ? -1.0 : 1.0);
    return stored + bounded(channels.y + 0.5, 0.0, 1.0) * binary16Step(stored) - 0.5 * binary16Step(stored);
}

// (stored, error) for two 8-bit unorm channels. Code 127 of the second is no error, a code 1/254 of a step,
// so that a value that the first holds exactly comes back exactly.
float2 errorCarryingUnorm8(float value) {
    float known = bounded(value, 0.0, 1.0);
    float stored = ditheredUnorm8(known, 0.5);
    float errorSteps = (known - stored) * 255.0;
    return float2(stored, floor(bounded(errorSteps * 254.0 + 127.0, 0.0, 254.0) + 0.5) / 255.0);
}

float errorCarriedUnorm8(float2 channels) {
    float2 codes = bounded(channels, 0.0, 1.0) * 255.0;
    return bounded((codes.x + (floor(codes.y + 0.5) - 127.0) / 254.0) / 255.0, 0.0, 1.0);
}

#endif
