// SPDX-License-Identifier: Apache-2.0
// Linear depth in few bits: a key in [0,1], linear or logarithmic in depth, and a key in two to four 8-bit
// channels, as targets of shader model 3 hold it. In float arithmetic alone; every split is exact, digit for
// digit, so that unorm8 targets give it back bit for bit. Digits must not be read through a linear filter.
//
//   key in            error of the key     of depth: linear key      logarithmic key, relative
//   unorm16, 2 x 8    1/131070             (far - near) / 131070     ln(far / near) / 131070
//   3 x 8             2^-25 below 1/2, else 0, and 2^-24 at 1
//   4 x 8             2^-32 below 2^-9, else 0, and 2^-24 at 1
#ifndef REPRISE_DEPTH_ENCODING_HLSLI
#define REPRISE_DEPTH_ENCODING_HLSLI

#include "reprise/bounded.hlsli"

// Largest binary32 below 1: the key that stands for 1 where the codes end below it.
static const float LARGEST_KEY = 0.99999994;
// The ends that near and far are held to, in metres, so that their ratio stays a number.
static const float MIN_NEAR_M = 1e-10;
static const float MAX_FAR_M = 1e20;

// Linear depth in metres to a key that is 0 at nearM and 1 at farM and beyond. 0 <= nearM < farM. NaN gives
// 0.
float linearKeyFromDepth(float linearDepth, float nearM, float farM) {
    float range = max(farM - nearM, MIN_NEAR_M);
    return min(bounded(linearDepth - nearM, 0.0, range) / range, 1.0);
}

float depthFromLinearKey(float key, float nearM, float farM) {
    return nearM + bounded(key, 0.0, 1.0) * max(farM - nearM, MIN_NEAR_M);
}

// The logarithmic key is as fine in relation to depth everywhere: log(z / near) / log(far / near). nearM
// above 0; far at least 1.001 times as far. Beside the table: 2^-21 of log2(z / near) in binary32.
float2 logarithmicEnds(float nearM, float farM) {
    float near = bounded(nearM, MIN_NEAR_M, 1e10);
    return float2(near, log2(bounded(farM, 1.001 * near, MAX_FAR_M) / near));
}

float logarithmicKeyFromDepth(float linearDepth, float nearM, float farM) {
    float2 ends = logarithmicEnds(nearM, farM);
    return bounded(log2(bounded(linearDepth, ends.x, MAX_FAR_M) / ends.x) / ends.y, 0.0, 1.0);
}

float depthFromLogarithmicKey(float key, float nearM, float farM) {
    float2 ends = logarithmicEnds(nearM, farM);
    return ends.x * exp2(bounded(key, 0.0, 1.0) * ends.y);
}

// Whole numbers from 0 to 255 to unorm8 channels, which round to nearest, and back.
float4 channelsFromDigits(float4 digits) {
    return digits / 255.0;
}

float4 digitsFromChannels(float4 channels) {
    return floor(bounded(channels, 0.0, 1.0) * 255.0 + 0.5);
}

// A key in two channels, the higher digit first: 65536 codes, code / 65535, to the nearest.
float2 packKey16(float key) {
    float code = floor(bounded(key, 0.0, 1.0) * 65535.0 + 0.5);
    float high = floor(code / 256.0);
    return channelsFromDigits(float4(high, code - 256.0 * high, 0.0, 0.0)).xy;
}

float unpackKey16(float2 channels) {
    float2 digits = digitsFromChannels(float4(channels, 0.0, 0.0)).xy;
    return min((digits.x * 256.0 + digits.y) / 65535.0, 1.0);
}

// A key in three channels: 2^24 codes, code / 2^24, to the nearest. From 2^23 on the scaled key is whole
// already, and adding a half would round it to an even one: so the fraction decides.
float3 packKey24(float key) {
    float scaled = bounded(key, 0.0, LARGEST_KEY) * 16777216.0;
    float whole = floor(scaled);
    float code = whole + (scaled - whole >= 0.5 ? 1.0 : 0.0);
    float high = floor(code / 65536.0);
    float rest = code - 65536.0 * high;
    float middle = floor(rest / 256.0);
    return channelsFromDigits(float4(high, middle, rest - 256.0 * middle, 0.0)).xyz;
}

float unpackKey24(float3 channels) {
    float3 digits = digitsFromChannels(float4(channels, 0.0)).xyz;
    return (digits.x * 65536.0 + digits.y * 256.0 + digits.z) / 16777216.0;
}

// A key in four channels: 2^32 codes, code / 2^32, rounded down. A key of 2^-9 and above has no bit that is
// lost: it suits reversed device depth, whose far plane is at 0.
float4 packKey32(float key) {
    float4 digits;
    float rest = bounded(key, 0.0, LARGEST_KEY) * 256.0;
    digits.x = floor(rest);
    rest = (rest - digits.x) * 256.0;
    digits.y = floor(rest);
    rest = (rest - digits.y) * 256.0;
    digits.z = floor(rest);
    digits.w = floor((rest - digits.z) * 256.0);
    return channelsFromDigits(digits);
}

float unpackKey32(float4 channels) {
    float4 digits = digitsFromChannels(channels);
    float low = (digits.w / 256.0 + digits.z) / 256.0;
    return min(((low + digits.y) / 256.0 + digits.x) / 256.0, LARGEST_KEY);
}

#endif
