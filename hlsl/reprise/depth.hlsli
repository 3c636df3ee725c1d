// SPDX-License-Identifier: Apache-2.0
// Device depth and linear depth, and which of two depths is closer.
#ifndef REPRISE_DEPTH_HLSLI
#define REPRISE_DEPTH_HLSLI

// Linear depth in metres that stands for no surface: the largest binary16, so that every format of a history
// holds it.
static const float SKY_DEPTH = 65504.0;

// Device depth in [0,1] to linear depth in metres. coefficients come from reprise::linearDepthCoefficients:
// perspective, any depth kind:  linear = 1 / (device · x + y);  orthographic: linear = device · x + y.
// The far plane of an infinite projection gives infinity in exact arithmetic; here it gives 1e30.
float linearDepthFromDevice(float deviceDepth, float2 coefficients) {
    float affine = deviceDepth * coefficients.x + coefficients.y;
#if ORTHOGRAPHIC
    return affine;
#else
    return 1.0 / max(affine, 1e-30);
#endif
}

// The inverse; linearDepth in metres, above 0 in perspective.
float deviceDepthFromLinear(float linearDepth, float2 coefficients) {
#if ORTHOGRAPHIC
    return (linearDepth - coefficients.y) / coefficients.x;
#else
    return (1.0 / max(linearDepth, 1e-30) - coefficients.y) / coefficients.x;
#endif
}

// Whether device depth a is strictly closer to the camera than b; false if either is NaN.
bool isCloser(float a, float b) {
#if DEPTH_REVERSED
    return a > b;
#else
    return a < b;
#endif
}

#endif
