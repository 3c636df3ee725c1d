// SPDX-License-Identifier: Apache-2.0
// Motion blur in place of history where motion is fast, for the output alone. INSIDE I9.
#ifndef REPRISE_MOTION_BLUR_HLSLI
#define REPRISE_MOTION_BLUR_HLSLI

#include "reprise/colour.hlsli"
#include "reprise/platform.hlsli"

// Taps on each side of the pixel. Two sides and the centre give 7 reads.
static const int MOTION_BLUR_TAPS = 3;
// Share of the frame that the shutter is open: the blur spans this share of the motion.
static const float MOTION_BLUR_SHUTTER = 0.5;

// 1 where history is shown, 0 where motion blur is: k_trust = invlerp(to, from, |v|), 1 at 2 px and 0 at 15
// px. blurToPx > blurFromPx >= 0; where they are equal or swapped, a step at blurToPx and no 0/0.
float motionBlurTrust(float motionPx, float blurFromPx, float blurToPx) {
    return saturate((blurToPx - motionPx) / max(blurToPx - blurFromPx, 1e-6));
}

// Mean of the colour along the motion through uv; motion in UV, colour sampled bilinearly.
float3 sampleMotion(TEXTURE_PARAMETER(colour), float2 uv, float2 motionUv) {
    float2 stepUv = motionUv * (0.5 * MOTION_BLUR_SHUTTER / float(MOTION_BLUR_TAPS));
    float3 sum = sanitize(SAMPLE(colour, uv).rgb);
    [unroll] for (int tap = 1; tap <= MOTION_BLUR_TAPS; ++tap) {
        sum += sanitize(SAMPLE(colour, uv + stepUv * float(tap)).rgb);
        sum += sanitize(SAMPLE(colour, uv - stepUv * float(tap)).rgb);
    }
    return min(sum / float(2 * MOTION_BLUR_TAPS + 1), MAX_COLOUR);
}

#endif
