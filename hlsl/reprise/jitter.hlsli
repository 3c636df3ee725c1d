// SPDX-License-Identifier: Apache-2.0
// Sample sequences for the jitter of the frustum, INSIDE I1, in pixels within [-0.5, 0.5), x right, y down.
// reprise::jitterPx gives the same on the CPU.
#ifndef REPRISE_JITTER_HLSLI
#define REPRISE_JITTER_HLSLI

// Radical inverse of index (>= 0) in base 2 or 3, in [0, 1). Float arithmetic, for shader model 3 too: exact
// digits up to index 4095.
float radicalInverse(float index, float base) {
    float result = 0.0;
    float digitValue = 1.0 / base;
    [unroll] for (int digit = 0; digit < 12; ++digit) {
        float quotient = floor((index + 0.5) / base);
        result += (index - quotient * base) * digitValue;
        index = quotient;
        digitValue /= base;
    }
    return result;
}

// Halton (2,3), starting at its first index, repeating after `period` frames (8 or 16). Frames are whole and
// below 2^23: from there on frame + 1/2 is no number of binary32.
float2 haltonJitterPx(float frame, float period) {
    float index = frame - period * floor((frame + 0.5) / period) + 1.0;
    return float2(radicalInverse(index, 2.0), radicalInverse(index, 3.0)) - 0.5;
}

// "Uniform 4 helix": four points of a regular 2x2 grid, ordered so that every step crosses the horizontal
// centre line.
float2 uniform4HelixJitterPx(float frame) {
    float index = frame - 4.0 * floor((frame + 0.5) / 4.0);
    float x = (index > 0.5 && index < 2.5) ? 0.25 : -0.25;
    float y = (index - 2.0 * floor((index + 0.5) / 2.0)) > 0.5 ? 0.25 : -0.25;
    return float2(x, y);
}

#endif
