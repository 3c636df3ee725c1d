// SPDX-License-Identifier: Apache-2.0
// Offsets of a sample pattern from pixel to pixel: Drobot, 7.3, which takes "a different sample from a
// well-distributed sample set" each frame and leaves the rest to the neighbours and to the filter.
#ifndef REPRISE_SAMPLE_PATTERN_HLSLI
#define REPRISE_SAMPLE_PATTERN_HLSLI

// Two of the 16 numbers k / 16, each once over aligned 4x4 pixels: an ordered dither, no two of whose aligned
// 2x2 are closer than a quarter, and that of the pixel with x and y exchanged, a row below. pixel: whole, [0,
// 2^22]. Exact.
float2 pixelOffsets(float2 pixel) {
    float2 halves = floor(0.5 * pixel);
    float2 fine = pixel - 2.0 * halves;
    float2 coarse = halves - 2.0 * floor(0.5 * halves);
    float isUnlike = abs(fine.x - fine.y);
    float below = abs(coarse.y - fine.y);
    return float2(8.0 * isUnlike + 4.0 * fine.y + 2.0 * abs(coarse.x - coarse.y) + coarse.y,
                  8.0 - 8.0 * isUnlike + 4.0 * fine.x + 2.0 * abs(below - coarse.x) + coarse.x) / 16.0;
}

#endif
