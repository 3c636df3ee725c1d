// SPDX-License-Identifier: Apache-2.0
// The reprojection cache as a pass: where history lies, how far it is believed, and what is kept.
#pragma once

#include "coarse_depth.hpp"
#include "exponential_history.hpp"
#include "packing.hpp"
#include "reprojection_cache.hpp"

#include <array>

namespace oracle {

struct CachePass {
    enum class Values { one, occlusionInInteger, shadowInInteger };
    Values values = Values::one;
    enum class History { camera, motion, still, none };
    History where = History::camera;
    bool bilinear = true, detectsChange = false;
    Camera current, previous;
    ivec2 frameExtent{1}; // of the whole frame
    int ratio = 2;
    dvec2 motionToUv{1.0}, missThreshold{0.1, 0.01}, speedPx{8.0, 32.0};
    dvec2 change{1.2, 0.1}; // deviations, and a difference, that history may differ by
    double convergenceTime = 2.0, maxWeight = 0.9, historyValid = 1.0;
    const Image* fresh = nullptr;
    const Image* velocity = nullptr; // at the frame's extent
    const Image* history = nullptr;
};

inline bool isNumber(double value, double largest = 1e38) {
    return std::abs(value) <= largest;
}

// What a history can hold: the finite values of a binary16.
inline bool isCacheable(dvec2 values) {
    return isNumber(values.x, 65504.0) && isNumber(values.y, 65504.0);
}

// (occlusion, shadow) of a packed channel, NaN where it holds no number; or the value and 0.
inline dvec2 unpackedValues(const CachePass& pass, double channel) {
    if (pass.values == CachePass::Values::one) return {channel, 0.0};
    if (!isNumber(channel, 65504.0)) return dvec2(std::nan(""));
    const double last = 1.0 - fractionStep(31), known = std::clamp(channel, 0.0, 31.0 + last);
    const double whole = std::floor(known) / 31.0, part = std::min((known - std::floor(known)) / last, 1.0);
    return pass.values == CachePass::Values::occlusionInInteger ? dvec2(whole, part) : dvec2(part, whole);
}

inline double packedValues(const CachePass& pass, dvec2 values) {
    switch (pass.values) {
    case CachePass::Values::occlusionInInteger:
        return packPair(values.x, values.y);
    case CachePass::Values::shadowInInteger:
        return packPair(values.y, values.x);
    case CachePass::Values::one:
        break;
    }
    return values.x;
}

// A place of the image in texels and the linear depth that is expected there.
struct CachePoint {
    dvec2 texel{0.0}, travelled{0.0};
    bool inside = false;
    double depth = 0.0;
};

// A texel of the coarse image is `ratio` pixels of the frame wide, its centre at ratio (i + 1/2).
inline CachePoint cachePoint(const CachePass& pass, ivec2 texel, double depth) {
    const dvec2 framePx = double(pass.ratio) * (dvec2(texel) + 0.5);
    const dvec2 uv = framePx / dvec2(pass.frameExtent);
    CachePoint point;
    dvec2 previousUv = reprojectLinearDepth(uv, depth, pass.current, pass.previous);
    point.depth = previousLinearDepth(uv, depth, pass.current, pass.previous);
    if (pass.where == CachePass::History::motion) {
        const ivec2 from(glm::floor(framePx - double(pass.ratio) / 8.0));
        const dvec2 motion = dvec2(texelClamped(*pass.velocity, from.x, from.y)) * pass.motionToUv;
        previousUv = uv - motion;
        if (!glm::all(glm::lessThanEqual(glm::abs(previousUv), dvec2(8.0)))) previousUv = behindCameraUv;
    }
    point.texel = previousUv * dvec2(pass.frameExtent) / double(pass.ratio);
    if (pass.where == CachePass::History::still) {
        point.texel = dvec2(texel) + 0.5;
        point.depth = depth;
    }
    point.travelled = dvec2(texel) + 0.5 - point.texel;
    point.inside = isInsideUv(point.texel / pass.history->extent());
    return point;
}

// Both values, frames and depth. Of a linear filter one broken texel breaks all; of unpacked ones it is left
// out.
struct CacheRead {
    dvec2 values{0.0};
    double frames = 0.0, depth = 0.0;
    bool usable = true;
};

inline CacheRead readCache(const CachePass& pass, dvec2 texel) {
    const dvec2 position = texel - 0.5;
    const ivec2 first(texelIndex(position.x, pass.history->width),
                      texelIndex(position.y, pass.history->height));
    const dvec2 share = glm::clamp(position - dvec2(first), 0.0, 1.0);
    CacheRead sum;
    double total = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = pass.bilinear ? first + ivec2(i % 2, i / 2)
                                       : ivec2(texelIndex(texel.x, pass.history->width),
                                               texelIndex(texel.y, pass.history->height));
        double weight = (i % 2 == 1 ? share.x : 1.0 - share.x) * (i / 2 == 1 ? share.y : 1.0 - share.y);
        if (!pass.bilinear) weight = i == 0 ? 1.0 : 0.0;
        if (weight == 0.0) continue;
        const dvec4 read = texelClamped(*pass.history, at.x, at.y);
        const dvec2 values = unpackedValues(pass, read.x);
        const bool number = isCacheable(values) && isNumber(read.z) && isNumber(read.w);
        if (!number && pass.values != CachePass::Values::one && pass.bilinear) continue;
        sum.values += weight * values;
        sum.frames += weight * read.z;
        sum.depth += weight * read.w;
        total += weight;
    }
    if (total > 1e-6) sum = {sum.values / total, sum.frames / total, sum.depth / total};
    sum.usable = total > 1e-6 && isCacheable(sum.values) && isNumber(sum.depth);
    return sum;
}

// Values of the 4x4 fresh texels from one before to two behind: the part of the history's distance to their
// mean that is beyond what they scatter.
inline double likeness(const CachePass& pass, ivec2 texel, dvec2 values) {
    const auto each = [&](auto&& take) {
        for (int i = 0; i < 16; ++i) {
            const double channel = texelClamped(*pass.fresh, texel.x - 1 + i % 4, texel.y - 1 + i / 4).x;
            take(unpackedValues(pass, isNumber(channel, 65504.0) ? channel : 0.0));
        }
    };
    dvec2 mean(0.0), variance(0.0);
    each([&](dvec2 value) { mean += value / 16.0; });
    each([&](dvec2 value) { variance += (value - mean) * (value - mean) / 16.0; });
    double least = 1.0;
    for (int i = 0; i < 2; ++i) {
        const double allowed = std::max(pass.change.x * std::sqrt(variance[i]) + pass.change.y, 1e-4);
        least = std::min(least, std::clamp(2.0 - std::abs(values[i] - mean[i]) / allowed, 0.0, 1.0));
    }
    return least;
}

struct CacheTexel {
    double packed = 0.0, frames = 1.0, depth = 0.0;
    dvec2 values{0.0}; // before they were packed
};

// With the place moved by `away` texels, and the depth expected there by `awayDepth` metres.
inline CacheTexel cacheTexel(const CachePass& pass, int x, int y, dvec2 away = dvec2(0.0),
                             double awayDepth = 0.0) {
    const dvec4 fresh = texelClamped(*pass.fresh, x, y);
    CacheTexel result;
    result.depth = fresh.y > 0.0 && fresh.y < skyDepth ? fresh.y : skyDepth;
    dvec2 current = unpackedValues(pass, fresh.x);
    if (!isCacheable(current)) current = dvec2(0.0);

    if (pass.where == CachePass::History::none) {
        result.values = current;
        result.packed = packedValues(pass, current);
        return result;
    }
    CachePoint point = cachePoint(pass, {x, y}, result.depth);
    if (pass.where == CachePass::History::still) away = dvec2(0.0), awayDepth = 0.0;
    point.texel += away;
    const CacheRead history = readCache(pass, point.texel);
    const double threshold = pass.missThreshold.x + pass.missThreshold.y * result.depth;
    double confidence = 0.0;
    if (pass.historyValid > 0.5 && history.usable && isInsideUv(point.texel / pass.history->extent())) {
        const double difference = std::abs(point.depth + awayDepth - history.depth);
        confidence = std::clamp((1.0 - difference / threshold) * pass.convergenceTime, 0.0, 1.0);
    }
    if (pass.detectsChange && confidence > 0.0) confidence *= likeness(pass, {x, y}, history.values);
    const double moving =
        velocityWeight(glm::length(point.travelled - away), pass.maxWeight, pass.speedPx.x, pass.speedPx.y);
    const double kept = held(history.frames, 0.0, 255.0) * confidence;
    const double weight = std::min(convergenceWeight(kept, pass.maxWeight), moving);
    for (int i = 0; i < 2; ++i)
        result.values[i] =
            weight > 0.0 ? exponentialHistory(history.values[i], current[i], weight) : current[i];
    result.packed = packedValues(pass, result.values);
    result.frames = nextConvergence(history.frames, confidence);
    return result;
}

} // namespace oracle
