// SPDX-License-Identifier: Apache-2.0
// The exponential history of Drobot, its steering, and what a cycle of subsets leaves against the whole set.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace oracle {

// Outside goes to the nearer end, NaN to the lower one.
inline double held(double value, double low, double high) {
    return std::isnan(value) ? low : std::clamp(value, low, high);
}

// h(t) = h(t-1) w + r (1 - w); a history that is no number is none.
inline double exponentialHistory(double history, double current, double weight) {
    const double w = held(weight, 0.0, 1.0);
    return std::isfinite(history) ? current + (history - current) * w : current;
}

// Hermite's cubic from the weight at the slow speed down to 0 at the fast one.
inline double velocityWeight(double speedPx, double weight, double slowPx, double fastPx) {
    const double w = held(weight, 0.0, 1.0), speed = std::abs(speedPx);
    if (std::isnan(speedPx) || speed >= fastPx) return 0.0;
    if (speed <= slowPx) return w;
    const double t = (speed - slowPx) / (fastPx - slowPx);
    return w * (1.0 - t * t * (3.0 - 2.0 * t));
}

inline double nextConvergence(double frames, double confidence) {
    return std::min(held(frames, 0.0, 255.0) * held(confidence, 0.0, 1.0) + 1.0, 255.0);
}

inline double convergenceWeight(double frames, double maxWeight) {
    const double n = held(frames, 0.0, 255.0);
    return std::min(1.0 - 1.0 / (n + 1.0), held(maxWeight, 0.0, 1.0));
}

// Geometric series over the frames that showed one subset, `age`, age + N, age + 2N ... frames ago.
inline double subsetShare(int age, double w, int subsets) {
    return w == 1.0 ? 1.0 / subsets : (1.0 - w) * std::pow(w, age) / (1.0 - std::pow(w, subsets));
}

// sqrt(sum of (share - 1/N)^2): the shares sum to 1, so it is the sum of squares less 1/N, a geometric series
// again.
inline double cycleError(double w, int subsets) {
    if (w == 1.0) return 0.0;
    const double power = std::pow(w, subsets);
    const double squares = (1.0 - w) * (1.0 + power) / ((1.0 + w) * (1.0 - power));
    return std::sqrt(std::max(squares - 1.0 / subsets, 0.0));
}

// The formula of the history, frame after frame; frame t takes subset t mod N.
inline double historyOfCycle(const std::vector<double>& subsetMeans, double w, int frames) {
    double history = 0.0;
    for (int t = 0; t < frames; ++t)
        history = history * w + subsetMeans[static_cast<size_t>(t) % subsetMeans.size()] * (1.0 - w);
    return history;
}

} // namespace oracle
