// SPDX-License-Identifier: Apache-2.0
// How much of the history is kept. INSIDE, "Final blend, weighing constrained history" (I8).
#ifndef REPRISE_FEEDBACK_HLSLI
#define REPRISE_FEEDBACK_HLSLI

// Differences of luminance below this count less: it is the floor of the denominator. Empirical, from the
// published implementation's behaviour on dark pixels.
static const float FEEDBACK_LUMINANCE_FLOOR = 0.2;

// Weight of history in [weightMin, weightMax]: high where the luminance of input and constrained history
// agree, low where they differ. Luminances are >= 0; of a negative one the weight is weightMin, where the
// square alone would grow without end.
float luminanceFeedback(float currentLuminance, float historyLuminance, float weightMin, float weightMax) {
    float largest = max(max(currentLuminance, historyLuminance), FEEDBACK_LUMINANCE_FLOOR);
    float agreement = saturate(1.0 - abs(currentLuminance - historyLuminance) / largest);
    return lerp(weightMin, weightMax, agreement * agreement);
}

// lerp(current, history, weight), exact at weight 0 whatever finite value history has.
float3 blendHistory(float3 current, float3 history, float weight) {
    return current + (history - current) * weight;
}

#endif
