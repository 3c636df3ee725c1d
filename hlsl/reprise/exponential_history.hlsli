// SPDX-License-Identifier: Apache-2.0
// The exponential history and what steers it. Drobot, "Reprojection Caching": h(t) = h(t-1) w + r (1-w), the
// running convergence of the SSAO section, and the sample set of figure 7.6, of which each frame takes a
// part.
//
//   held   = frames * confidence                    frames from the history, confidence from the miss test
//   weight = min(convergenceWeight(held, maxWeight), velocityWeight(speedPx, maxWeight, slowPx, fastPx))
//   value  = exponentialHistory(history, current, weight)
//   frames = nextConvergence(frames, confidence)    stored beside the value
#ifndef REPRISE_EXPONENTIAL_HISTORY_HLSLI
#define REPRISE_EXPONENTIAL_HISTORY_HLSLI

#include "reprise/bounded.hlsli"

// Frames that the convergence counts up to: 8 bits hold every count as count / 255, binary16 as it is.
static const float MAX_CONVERGENCE = 255.0;
// Subsets that a sample set may have; the loops below are unrolled to it.
static const int MAX_SUBSETS = 16;
// Frames that subsetOfFrame counts to. Up to here a division that errs by 2.5 ULP cannot reach the next whole
// number, so that the subset is exact on any device.
static const float MAX_FRAME = 1048576.0;
// History beyond this counts as infinite. The products below stay finite for all that is within it.
static const float LARGEST_HISTORY = 1e38;

// h(t-1) w + r (1-w). weight in [0,1], what lies outside is clamped and NaN is 0. A history that is NaN or
// infinite is not used: it would be there for ever, as the printed form multiplies it even by 0.
float exponentialHistory(float history, float current, float weight) {
    float w = bounded(weight, 0.0, 1.0);
    return abs(history) <= LARGEST_HISTORY ? history * w + current * (1.0 - w) : current;
}

// Two values of one texel, as occlusion and shadow: one broken value does not take the other with it.
float2 exponentialHistory(float2 history, float2 current, float weight) {
    return float2(exponentialHistory(history.x, current.x, weight),
                  exponentialHistory(history.y, current.y, weight));
}

// The weight by per-pixel velocity: `weight` up to slowPx, 0 from fastPx on, smooth at both ends. Speeds in
// pixels a frame, 0 <= slowPx <= fastPx; where they are equal it is a step. NaN gives 0: no history.
float velocityWeight(float speedPx, float weight, float slowPx, float fastPx) {
    float range = max(fastPx - slowPx, 1e-6);
    float room = bounded(fastPx - abs(speedPx), 0.0, range) / range;
    return bounded(weight, 0.0, 1.0) * room * room * (3.0 - 2.0 * room);
}

// How many frames the history holds once this one is in it, in [1, MAX_CONVERGENCE]. frames: how many it
// held, read from the history at the reprojected place. confidence in [0,1]: 0 on a miss, which leaves this
// frame alone; between, the frames count by that share. NaN in either is a miss.
float nextConvergence(float frames, float confidence) {
    float held = bounded(frames, 0.0, MAX_CONVERGENCE) * bounded(confidence, 0.0, 1.0);
    return min(held + 1.0, MAX_CONVERGENCE);
}

// The weight of a history of that many frames: n / (n + 1) makes it the mean of all of them, up to maxWeight,
// from where on it is exponential. 0 frames give 0.
float convergenceWeight(float frames, float maxWeight) {
    float held = bounded(frames, 0.0, MAX_CONVERGENCE);
    return min(held / (held + 1.0), bounded(maxWeight, 0.0, 1.0));
}

// A convergence as an 8-bit channel holds it, and back: exact for whole frames, else off by half a frame.
float convergenceToUnorm8(float frames) {
    return bounded(frames, 0.0, MAX_CONVERGENCE) / MAX_CONVERGENCE;
}

float convergenceFromUnorm8(float channel) {
    return floor(bounded(channel, 0.0, 1.0) * MAX_CONVERGENCE + 0.5);
}

// A number of subsets as the functions below take it: whole, in [1, MAX_SUBSETS].
float wholeSubsets(float subsetCount) {
    return bounded(floor(subsetCount), 1.0, float(MAX_SUBSETS));
}

// Which of subsetCount subsets a frame takes: one after the other, repeating after that many frames (figure
// 7.6). frameIndex is whole, in [0, MAX_FRAME]; an engine that runs longer wraps it at a multiple of
// subsetCount.
float subsetOfFrame(float frameIndex, float subsetCount) {
    float count = wholeSubsets(subsetCount);
    float frame = floor(bounded(frameIndex, 0.0, MAX_FRAME));
    return frame - count * floor((frame + 0.5) / count);
}

// Index in the whole set of the tap-th sample of a subset. Subsets interleave, so that each is spread over
// the set.
float sampleOfSubset(float tap, float subset, float subsetCount) {
    return tap * wholeSubsets(subsetCount) + subset;
}

// The share of the subset taken `age` frames ago, age in [0, subsetCount), in a history that has run for
// long: w^age (1-w) / (1-w^N), which is w^age over the sum of the powers. That form has no 0/0 at weight 1.
float subsetShare(float age, float weight, float subsetCount) {
    float count = wholeSubsets(subsetCount);
    float w = bounded(weight, 0.0, 1.0);
    float power = 1.0, own = 0.0, sum = 0.0;
    [unroll] for (int k = 0; k < MAX_SUBSETS; ++k) {
        sum += float(k) < count ? power : 0.0;
        own = abs(float(k) - age) < 0.5 && float(k) < count ? power : own;
        power *= w;
    }
    return own / sum;
}

// The error that the cycle leaves against the whole set: its standard deviation, over that of the subsets'
// means, sqrt(sum of (share - 1/N)^2). 0 at weight 1, sqrt(1 - 1/N) at weight 0, where one subset is all
// there is.
float cycleError(float weight, float subsetCount) {
    float count = wholeSubsets(subsetCount);
    float squares = 0.0;
    [unroll] for (int age = 0; age < MAX_SUBSETS; ++age) {
        float difference = subsetShare(float(age), weight, count) - 1.0 / count;
        squares += float(age) < count ? difference * difference : 0.0;
    }
    return sqrt(squares);
}

#endif
