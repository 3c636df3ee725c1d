// SPDX-License-Identifier: Apache-2.0
// What counts as a number. Ordered comparisons are false for NaN on every target; GLSL's isnan may be
// compiled away, and max(v, 0) is no guard.
#ifndef REPRISE_FINITE_HLSLI
#define REPRISE_FINITE_HLSLI

// Beyond this magnitude a value counts as infinite, so that the difference of two numbers and the sum of
// three stay below the largest binary32, 3.4e38.
static const float LARGEST_NUMBER = 1e38;

// Neither NaN nor infinite, in every component.
bool isNumber(float v) {
    return abs(v) <= LARGEST_NUMBER;
}

bool isNumber(float2 v) {
    return all(abs(v) <= LARGEST_NUMBER);
}

bool isNumber(float4 v) {
    return all(abs(v) <= LARGEST_NUMBER);
}

// Per component 1 for a number, else 0.
float4 numberMask(float4 v) {
    return abs(v) <= LARGEST_NUMBER ? 1.0 : 0.0;
}

// The value if every component is a number, else 0: half of a broken value is no value.
float numberOrZero(float v) {
    return isNumber(v) ? v : 0.0;
}

float2 numberOrZero(float2 v) {
    return isNumber(v) ? v : 0.0;
}

float4 numberOrZero(float4 v) {
    return isNumber(v) ? v : 0.0;
}

#endif
