// SPDX-License-Identifier: Apache-2.0
// The bilateral filter and the bilateral upsampling as passes over a cache's texels.
#pragma once

#include "bilateral_upsampling.hpp"
#include "cache_pass.hpp"
#include "directional_bilateral.hpp"

namespace oracle {

struct FilterPass {
    CachePass::Values values = CachePass::Values::one;
    bool linear = true; // taps between texels
    ivec2 direction{1, 0};
    dvec2 depthAmplitude{1.0, 4.0};
    double converged = 8.0, maxSmoothing = 4.0, minSmoothing = 0.7;
    const Image* cache = nullptr; // value or packed pair, 0, frames, depth
};

// Values in r and g, NaN where none can be, depth in a.
inline Image unpackedImage(const Image& cache, CachePass::Values values) {
    CachePass pass;
    pass.values = values;
    Image unpacked = cache;
    for (dvec4& texel : unpacked.texels) {
        dvec2 both = unpackedValues(pass, texel.x);
        if (!isCacheable(both)) both = dvec2(std::nan(""));
        texel = {both, texel.z, texel.w};
    }
    return unpacked;
}

// Each tap is read `away` texels off its place, where that is given.
inline dvec2 filteredValues(const FilterPass& pass, const Image& unpacked, int x, int y,
                            const std::vector<dvec2>& away = {}) {
    const dvec4 centre = unpacked.at(x, y);
    const double missing = 1.0 - std::clamp(held(centre.z, 0.0, 255.0) / pass.converged, 0.0, 1.0);
    const double smoothing = pass.minSmoothing + (pass.maxSmoothing - 1.0) * missing;
    const double amplitude = pass.depthAmplitude.x + pass.depthAmplitude.y / held(centre.w, 1e-3, skyDepth);
    std::vector<BilateralTap> taps;
    for (const auto& [offset, weight] : pass.linear ? linearFootprint() : pointFootprint()) {
        const dvec2 moved = away.empty() ? dvec2(0.0) : away[taps.size()];
        const dvec2 place = offset * dvec2(pass.direction) + moved;
        const dvec2 uv = (dvec2(x, y) + 0.5 + place) / unpacked.extent();
        const dvec4 read = pass.linear ? sampleLinear(unpacked, uv) : samplePoint(unpacked, uv);
        taps.push_back({dvec2(read), read.w, weight, offset == 0.0});
    }
    return bilateralMean(taps, amplitude, smoothing);
}

struct UpsamplePass {
    CachePass::Values values = CachePass::Values::one;
    int ratio = 2;
    bool normalWeights = false;
    double contrast = 8.0;
    const Image* filtered = nullptr;    // unpackedImage()
    const Image* coarseDepth = nullptr; // metres
    const Image* normal = nullptr;      // of the frame
};

struct Upsampled {
    dvec2 values{0.0};
    double totalWeight = 0.0; // before it is divided by
};

inline Upsampled upsampledValues(const UpsamplePass& pass, int x, int y, double depth) {
    dvec4 bilinear(0.0), normal(1.0), depths(0.0);
    std::array<bool, 4> usable{};
    std::array<dvec2, 4> values{};
    const auto taps = coarseTaps({x, y}, pass.ratio, {pass.filtered->width, pass.filtered->height});
    for (size_t i = 0; i < 4; ++i) {
        const int c = static_cast<int>(i);
        const ivec2 at = taps[i].texel;
        bilinear[c] = taps[i].bilinear;
        depths[c] = pass.coarseDepth->at(at.x, at.y).x;
        values[i] = dvec2(pass.filtered->at(at.x, at.y));
        usable[i] = isCacheable(values[i]);
        const ivec2 pixel = pixelOfCoarseTexel(at, pass.ratio);
        if (pass.normalWeights)
            normal[c] = normalWeight(dvec3(texelClamped(*pass.normal, pixel.x, pixel.y)),
                                     dvec3(pass.normal->at(x, y)), pass.contrast);
    }
    const BilateralShares shares = bilateralShares(bilinear, normal, depths, depth, usable);
    dvec2 sum(0.0);
    for (size_t i = 0; i < 4; ++i)
        if (shares.of[i] > 0.0) sum += shares.of[i] * values[i];
    return {sum, shares.totalWeight};
}

} // namespace oracle
