// SPDX-License-Identifier: Apache-2.0
// Bilateral upsampling: four coarse samples weighed by place, normal and depth.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

namespace oracle {

using glm::dvec3;
using glm::dvec4;
using glm::ivec2;

// Coarse texel i stands for the fine pixels [ratio i, ratio (i + 1)), so its centre is ratio (i + 1/2); that
// of pixel x is x + 1/2. The share of a texel is the tent of one coarse texel's half width over the distance.
struct CoarseTap {
    ivec2 texel{0}; // inside of the image
    double bilinear = 0.0;
};

inline double tent(double distance, double halfWidth) {
    return std::max(0.0, 1.0 - std::abs(distance) / halfWidth);
}

// Left and right above, left and right below.
inline std::array<CoarseTap, 4> coarseTaps(ivec2 pixel, int ratio, ivec2 coarseSize) {
    const auto centre = [&](int texel) { return ratio * (texel + 0.5); };
    ivec2 first;
    for (int axis = 0; axis < 2; ++axis) {
        first[axis] = -1;
        while (centre(first[axis] + 1) <= pixel[axis] + 0.5)
            ++first[axis];
    }
    std::array<CoarseTap, 4> taps;
    for (int i = 0; i < 4; ++i) {
        const ivec2 texel = first + ivec2(i % 2, i / 2);
        const double x = tent(pixel.x + 0.5 - centre(texel.x), ratio);
        const double y = tent(pixel.y + 0.5 - centre(texel.y), ratio);
        taps[static_cast<size_t>(i)] = {glm::clamp(texel, ivec2(0), coarseSize - 1), x * y};
    }
    return taps;
}

inline double normalWeight(dvec3 normalLow, dvec3 normalHi, double contrast) {
    if (!(contrast > 0.0)) return 1.0;
    const double cosine = std::min(glm::dot(normalLow, normalHi), 1.0);
    return cosine > 0.0 ? std::pow(cosine, std::min(contrast, 256.0)) : 0.0;
}

struct BilateralShares {
    std::array<double, 4> of{};
    double totalWeight = 0.0; // before it is divided by
};

// Shares of four samples, sum 1. A sample takes part if it is `usable` and its depth difference is a number.
// Without weight the nearest in depth, without depth every usable one.
inline BilateralShares bilateralShares(dvec4 bilinear, dvec4 normal, dvec4 depthLow, double depthHi,
                                       std::array<bool, 4> usable) {
    const double least = 1e-30, infinite = 1e38;
    std::array<double, 4> difference{};
    BilateralShares shares;
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < 4; ++i) {
        const int c = static_cast<int>(i);
        difference[i] = std::abs(depthHi - depthLow[c]);
        if (!usable[i] || !(difference[i] <= infinite)) {
            difference[i] = HUGE_VAL;
            continue;
        }
        nearest = std::min(nearest, difference[i]);
        shares.of[i] = bilinear[c] * normal[c] / (0.0001 + difference[i]);
        shares.totalWeight += shares.of[i];
    }
    double total = shares.totalWeight;
    if (total < least) {
        total = 0.0;
        for (size_t i = 0; i < 4; ++i) {
            shares.of[i] = usable[i] && difference[i] <= nearest ? 1.0 : 0.0;
            total += shares.of[i];
        }
    }
    for (double& share : shares.of)
        share = total > 0.0 ? share / total : 0.0;
    return shares;
}

} // namespace oracle
