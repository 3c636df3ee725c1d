// SPDX-License-Identifier: Apache-2.0
// Blend of current colour and history, colour at the unjittered centre, and motion blur. INSIDE I8, I9.
#pragma once

#include "colour.hpp"
#include "image.hpp"
#include "neighbourhood.hpp"

#include <array>

namespace oracle {

// Between the weights by the square of the agreement of the luminances, relative to the larger of the two, at
// least 0.2.
inline double luminanceFeedback(double current, double history, double weightMin, double weightMax) {
    double difference = std::abs(current - history) / std::max({current, history, 0.2});
    double share = (1.0 - difference) * (1.0 - difference);
    return weightMin * (1.0 - share) + weightMax * share;
}

// c_feedback = lerp(c_in', c_hist', k_feedback)
inline dvec3 blendHistory(dvec3 current, dvec3 history, double weight) {
    return weight == 0.0 ? current : current * (1.0 - weight) + history * weight;
}

using AxisWeights = std::array<double, 3>; // of the texels at -1, 0, +1

// The image was moved by +jitter, so the pixel's centre is found at +jitter: a tent of half width 1 around
// it.
inline AxisWeights unjitterWeightsBilinear(double jitterPx) {
    AxisWeights weights;
    for (int i = 0; i < 3; ++i)
        weights[static_cast<size_t>(i)] = std::max(0.0, 1.0 - std::abs(i - 1 - jitterPx));
    return weights;
}

// A normal distribution around the same place, of which only the three texels count.
inline AxisWeights unjitterWeightsGaussian(double jitterPx, double sigmaPx = 0.47) {
    AxisWeights weights;
    double sum = 0.0;
    for (int i = 0; i < 3; ++i) {
        double distance = (i - 1 - jitterPx) / sigmaPx;
        sum += weights[static_cast<size_t>(i)] = std::exp(-0.5 * distance * distance);
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

inline dvec3 weighSquare(const Square& square, const AxisWeights& x, const AxisWeights& y) {
    dvec3 sum(0.0);
    for (size_t i = 0; i < 9; ++i)
        sum += x[i % 3] * y[i / 3] * square[i];
    return sum;
}

// invlerp(15, 2, |v|) held to [0, 1].
inline double motionBlurTrust(double motionPx, double blurFromPx, double blurToPx) {
    return std::clamp((motionPx - blurToPx) / (blurFromPx - blurToPx), 0.0, 1.0);
}

// Mean of 2 × taps + 1 bilinear reads, evenly over the way that the point goes while the shutter is open,
// centred on uv. Broken texels count as their repaired colours.
inline dvec3 sampleMotion(const Image& image, dvec2 uv, dvec2 motionUv, int taps = 3, double shutter = 0.5) {
    dvec3 sum(0.0);
    for (int tap = -taps; tap <= taps; ++tap) {
        dvec2 place = uv + motionUv * (shutter * tap / (2.0 * taps));
        sum += sanitize(dvec3(sampleLinear(image, place)));
    }
    return sum / (2.0 * taps + 1.0);
}

} // namespace oracle
