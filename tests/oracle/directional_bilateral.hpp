// SPDX-License-Identifier: Apache-2.0
// A bilateral filter along one direction over any taps, and the two footprints of Drobot's Listing 7.3.
#pragma once

#include "image.hpp"

#include <vector>

namespace oracle {

struct BilateralTap {
    dvec2 values{0.0};
    double depth = 0.0;
    double weight = 0.0; // by place
    bool centre = false;
};

// Mean of the values, weighted by place and by 1 / (1 + amp |depth difference|). What is no number takes no
// part.
inline dvec2 bilateralMean(const std::vector<BilateralTap>& taps, double amp, double smoothing) {
    double centreDepth = 0.0;
    for (const BilateralTap& tap : taps)
        if (tap.centre) centreDepth = tap.depth;
    dvec2 sum(0.0);
    double total = 0.0;
    for (const BilateralTap& tap : taps) {
        if (!std::isfinite(tap.values.x) || !std::isfinite(tap.values.y)) continue;
        const double difference = std::abs(tap.depth - centreDepth);
        const double side = std::isfinite(difference) ? smoothing / (1.0 + amp * difference) : 0.0;
        const double weight = tap.weight * (tap.centre ? 1.0 : side);
        if (weight == 0.0) continue;
        sum += weight * tap.values;
        total += weight;
    }
    return total > 0.0 ? sum / total : dvec2(0.0);
}

inline constexpr double bilateralCentre = 0.402619947, bilateralInner = 0.244201342,
                        bilateralOuter = 0.054488685;

// The listing's five places, in texels.
inline std::vector<std::pair<double, double>> linearFootprint() {
    return {{-3.5, bilateralOuter},
            {-1.5, bilateralInner},
            {0.0, bilateralCentre},
            {1.5, bilateralInner},
            {3.5, bilateralOuter}};
}

// Nine texels; those between which a tap of the listing lies share its weight.
inline std::vector<std::pair<double, double>> pointFootprint() {
    std::vector<std::pair<double, double>> places;
    for (const auto& [offset, weight] : linearFootprint()) {
        if (offset == 0.0)
            places.emplace_back(0.0, weight);
        else
            for (double side : {-0.5, 0.5})
                places.emplace_back(offset + side, weight / 2.0);
    }
    return places;
}

// At a texel of an image with values in r and g, depth in a.
inline dvec2 directionalBilateral(const Image& image, ivec2 texel, dvec2 direction, double amp,
                                  double smoothing, bool linear) {
    std::vector<BilateralTap> taps;
    for (const auto& [offset, weight] : linear ? linearFootprint() : pointFootprint()) {
        const dvec2 place = (dvec2(texel) + 0.5 + offset * direction) / image.extent();
        const dvec4 read = linear ? sampleLinear(image, place) : samplePoint(image, place);
        taps.push_back({dvec2(read), read.a, weight, offset == 0.0});
    }
    return bilateralMean(taps, amp, smoothing);
}

} // namespace oracle
