// SPDX-License-Identifier: Apache-2.0
// Linear depth of a coarse texel: the nearest, or the farthest, of the depths under it.
#pragma once

#include "reprojection.hpp"

#include <functional>

namespace oracle {

// What stands for no surface: the largest binary16.
inline constexpr double skyDepth = 65504.0;

inline ivec2 coarseExtent(ivec2 extent, int ratio) {
    return {(extent.x + ratio - 1) / ratio, (extent.y + ratio - 1) / ratio};
}

// The pixel whose normal a coarse texel has: of those under it the last that is not behind the middle, along
// both axes.
inline ivec2 pixelOfCoarseTexel(ivec2 texel, int ratio) {
    return ratio * texel + (ratio - 1) / 2;
}

struct CoarseDepth {
    int ratio = 2;
    bool checkerboard = false;
    double skyFromM = skyDepth;                // as far as this or farther is sky
    std::function<double(double)> linearDepth; // of what the image holds, in metres; NaN for what is no depth
};

// A depth that is none, behind the camera, or of the sky.
inline double knownDepth(const CoarseDepth& pass, double stored) {
    const double linear = pass.linearDepth(stored);
    return linear > 0.0 && linear < std::min(pass.skyFromM, skyDepth) ? linear : skyDepth;
}

// Texels beyond the image are those of its edge, which changes neither the nearest nor the farthest.
inline double coarseDepth(const CoarseDepth& pass, const Image& depth, int x, int y) {
    const bool farthest = pass.checkerboard && (x + y) % 2 != 0;
    double chosen = farthest ? 0.0 : skyDepth;
    for (int dy = 0; dy < pass.ratio; ++dy)
        for (int dx = 0; dx < pass.ratio; ++dx) {
            const double stored = texelClamped(depth, x * pass.ratio + dx, y * pass.ratio + dy).x;
            const double known = knownDepth(pass, stored);
            chosen = farthest ? std::max(chosen, known) : std::min(chosen, known);
        }
    return chosen;
}

} // namespace oracle
