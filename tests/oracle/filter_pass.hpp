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
};

// Up to four values, NaN where none can be, with frames and depth beside them, as the filter takes them.
struct Unpacked {
    Image values, state; // frames, depth
};

inline Unpacked unpackedCache(const Image& cache, const Image& state, CachePass::Values values) {
    Unpacked unpacked{cache, state};
    for (size_t i = 0; i < cache.texels.size(); ++i) {
        dvec4 each = unpackedValues(values, cache.texels[i]);
        if (!isCacheable(each)) each = dvec4(std::nan(""));
        unpacked.values.texels[i] = each;
        const double depth = isDepthApart(values) ? state.texels[i].y : cache.texels[i].y;
        unpacked.state.texels[i] = {state.texels[i].x, depth, 0.0, 0.0};
    }
    return unpacked;
}

// Each tap is read `away` texels off its place, where that is given.
inline dvec4 filteredValues(const FilterPass& pass, const Unpacked& unpacked, int x, int y,
                            const std::vector<dvec2>& away = {}) {
    const dvec4 centre = unpacked.state.at(x, y);
    const double missing = 1.0 - std::clamp(held(centre.x, 0.0, 255.0) / pass.converged, 0.0, 1.0);
    const double smoothing = pass.minSmoothing + (pass.maxSmoothing - 1.0) * missing;
    const double amplitude = pass.depthAmplitude.x + pass.depthAmplitude.y / held(centre.y, 1e-3, skyDepth);
    dvec4 result(0.0);
    // Two values at a time, as the listing has them. A tap that is broken in any value is left out of all.
    for (int pair = 0; pair < 4; pair += 2) {
        std::vector<BilateralTap> taps;
        for (const auto& [offset, weight] : pass.linear ? linearFootprint() : pointFootprint()) {
            const dvec2 moved = away.empty() ? dvec2(0.0) : away[taps.size()];
            const dvec2 place = offset * dvec2(pass.direction) + moved;
            const dvec2 uv = (dvec2(x, y) + 0.5 + place) / unpacked.values.extent();
            const auto read = [&](const Image& image) {
                return pass.linear && offset != 0.0 ? sampleLinear(image, uv) : samplePoint(image, uv);
            };
            const dvec4 values = read(unpacked.values);
            const dvec2 two =
                isCacheable(values) ? dvec2(values[pair], values[pair + 1]) : dvec2(std::nan(""));
            taps.push_back({two, read(unpacked.state).y, weight, offset == 0.0});
        }
        const dvec2 mean = bilateralMean(taps, amplitude, smoothing);
        result[pair] = mean.x;
        result[pair + 1] = mean.y;
    }
    return result;
}

struct UpsamplePass {
    CachePass::Values values = CachePass::Values::one;
    int ratio = 2;
    bool normalWeights = false;
    double contrast = 8.0;
    const Image* filtered = nullptr;    // values of unpackedCache()
    const Image* coarseDepth = nullptr; // metres
    const Image* normal = nullptr;      // of the frame
};

struct Upsampled {
    dvec4 values{0.0};
    double totalWeight = 0.0; // before it is divided by
};

inline Upsampled upsampledValues(const UpsamplePass& pass, int x, int y, double depth) {
    dvec4 bilinear(0.0), normal(1.0), depths(0.0);
    std::array<bool, 4> usable{};
    std::array<dvec4, 4> values{};
    const auto taps = coarseTaps({x, y}, pass.ratio, {pass.filtered->width, pass.filtered->height});
    for (size_t i = 0; i < 4; ++i) {
        const int c = static_cast<int>(i);
        const ivec2 at = taps[i].texel;
        bilinear[c] = taps[i].bilinear;
        const double coarse = pass.coarseDepth->at(at.x, at.y).x;
        depths[c] = coarse > 0.0 ? std::min(coarse, skyDepth) : skyDepth;
        values[i] = pass.filtered->at(at.x, at.y);
        usable[i] = isCacheable(values[i]);
        const ivec2 pixel = pixelOfCoarseTexel(at, pass.ratio);
        if (pass.normalWeights)
            normal[c] = normalWeight(dvec3(texelClamped(*pass.normal, pixel.x, pixel.y)),
                                     dvec3(pass.normal->at(x, y)), pass.contrast);
    }
    const BilateralShares shares = bilateralShares(bilinear, normal, depths, depth, usable);
    dvec4 sum(0.0);
    for (size_t i = 0; i < 4; ++i)
        if (shares.of[i] > 0.0) sum += shares.of[i] * values[i];
    return {sum, shares.totalWeight};
}

} // namespace oracle
