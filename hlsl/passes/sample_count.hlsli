// SPDX-License-Identifier: Apache-2.0
// The switch SAMPLES as a number: occlusion checks, and shadow texels, of a texel and frame. Loops over them
// are unrolled.
#ifndef REPRISE_SAMPLE_COUNT_HLSLI
#define REPRISE_SAMPLE_COUNT_HLSLI

#if SAMPLES_1
static const int SAMPLE_COUNT = 1;
#elif SAMPLES_2
static const int SAMPLE_COUNT = 2;
#elif SAMPLES_4
static const int SAMPLE_COUNT = 4;
#elif SAMPLES_8
static const int SAMPLE_COUNT = 8;
#elif SAMPLES_12
static const int SAMPLE_COUNT = 12;
#elif SAMPLES_16
static const int SAMPLE_COUNT = 16;
#else   // SAMPLES_32
static const int SAMPLE_COUNT = 32;
#endif

// Radians, that patterns of samples are turned by.
static const float FULL_TURN = 6.2831853;

#endif
