// SPDX-License-Identifier: Apache-2.0
// The reprojection cache: the depth a surface had, the weight of history and the blend.
#pragma once

#include "reprojection.hpp"

namespace oracle {

// View z under the previous camera of what stands still at uv with linear depth `linear`.
inline double previousLinearDepth(dvec2 uv, double linear, const Camera& current, const Camera& previous,
                                  bool sharesY = false) {
    const dvec4 view = viewPoint(uvToNdc(uv, sharesY), linear, current.viewToClip);
    return (previous.worldToView * (glm::inverse(current.worldToView) * view)).z;
}

// A miss at a difference of depths of `threshold` and above, and out of bounds; a straight line below it.
inline double cacheHistoryWeight(dvec2 prevUv, double lastDepth, double cacheDepth, double threshold,
                                 double convergence) {
    if (!isInsideUv(prevUv)) return 0.0;
    const double room = threshold - std::abs(lastDepth - cacheDepth);
    return room > 0.0 && convergence > 0.0 ? std::min(room * convergence, 1.0) : 0.0;
}

// h(t) = h(t-1) w + r (1 - w), where both are numbers.
inline double cacheBlend(double fresh, double history, double weight) {
    const auto isNumber = [](double v) { return std::abs(v) <= 1e38; };
    const double w = isNumber(history) ? weight : 0.0;
    return (isNumber(fresh) ? fresh * (1.0 - w) : 0.0) + (w > 0.0 ? history * w : 0.0);
}

} // namespace oracle
