// SPDX-License-Identifier: Apache-2.0
// Storage of depth, the hit of a cache, and whether a footprint covers a pixel's centre.
#pragma once

#include "reprojection.hpp"

namespace oracle {

enum class DepthFormat { float32, unorm24, unorm16 };

// The nearest value that the format holds.
inline double storedDepth(double device, DepthFormat format) {
    if (format == DepthFormat::float32) return static_cast<float>(device);
    const double steps = format == DepthFormat::unorm24 ? 16777215.0 : 65535.0;
    return std::round(device * steps) / steps;
}

// Half a step of the format at this depth.
inline double depthRounding(double device, DepthFormat format) {
    switch (format) {
    case DepthFormat::float32:
        return std::abs(device) * 0x1p-24;
    case DepthFormat::unorm24:
        return 0.5 / 16777215.0;
    case DepthFormat::unorm16:
        break;
    }
    return 0.5 / 65535.0;
}

// How far linear depth is off, at most, if device depth is by `deviceError`; infinite where the sign of the
// clip depth could change.
inline double linearDepthError(double linear, double deviceError, const dmat4& p) {
    double error = 0.0;
    for (const double sign : {-1.0, 1.0}) {
        const double other = linearDepth(deviceDepth(linear, p) + sign * deviceError, p);
        error = std::max(error, other > 0.0 ? std::abs(other - linear) : HUGE_VAL);
    }
    return error;
}

inline bool isCacheHit(dvec2 prevUv, double lastDepth, double cacheDepth, double threshold) {
    return isInsideUv(prevUv) && std::abs(lastDepth - cacheDepth) < threshold;
}

// How far from the footprint, in shares of its edges, the best pixel centre lies: at most 1/2 is covered. The
// footprint is the parallelogram of ddx and ddy around `place` (centres at halves); centres up to `reach`
// pixels away are tried. Infinite where there is no area.
inline double centreDistance(dvec2 place, dvec2 ddx, dvec2 ddy, int reach) {
    const glm::dmat2 edges(ddx, ddy);
    if (glm::determinant(edges) == 0.0) return HUGE_VAL;
    const glm::dmat2 toEdges = glm::inverse(edges);
    double best = HUGE_VAL;
    for (int y = -reach; y <= reach; ++y)
        for (int x = -reach; x <= reach; ++x) {
            const dvec2 centre = glm::floor(place) + 0.5 + dvec2(x, y);
            const dvec2 share = glm::abs(toEdges * (centre - place));
            best = std::min(best, std::max(share.x, share.y));
        }
    return best;
}

} // namespace oracle
