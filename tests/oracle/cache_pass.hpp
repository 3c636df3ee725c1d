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
    enum class Values { one, two, four, occlusionInInteger, shadowInInteger, withFrames };
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
    const Image* coarseDepth = nullptr; // of two and four values, and with frames
    const Image* velocity = nullptr;    // at the frame's extent
    const Image* history = nullptr;     // values, beside one or a packed pair depth
    const Image* state = nullptr;       // frames, beside two and four values depth; with frames depth alone
};

inline bool isNumber(double value, double largest = 1e38) {
    return std::abs(value) <= largest;
}

inline bool isPacked(CachePass::Values values) {
    return values == CachePass::Values::occlusionInInteger || values == CachePass::Values::shadowInInteger;
}

// Of two and four values depth lies beside the frames, and with frames in an image of its own.
inline bool isDepthApart(CachePass::Values values) {
    return values == CachePass::Values::two || values == CachePass::Values::four ||
           values == CachePass::Values::withFrames;
}

// Occlusion, shadow and frames, all NaN in what no packing wrote.
inline dvec3 unpackedWithFrames(double packed) {
    if (!(packed >= 0.0 && packed < 0x1p24)) return dvec3(std::nan(""));
    const double frames = std::floor(packed / 0x1p20), both = packed - frames * 0x1p20;
    const double level = std::floor(both / 1024.0);
    return {level / 1023.0, std::min((both - 1024.0 * level) / 1023.0, 1.0), frames};
}

inline double packedWithFrames(dvec2 values, double frames) {
    const auto nearest = [](double value, double most) {
        return std::floor(std::clamp(value, 0.0, 1.0) * most + 0.5);
    };
    return nearest(frames / 15.0, 15.0) * 0x1p20 + nearest(values.x, 1023.0) * 1024.0 +
           nearest(values.y, 1023.0);
}

inline int valueCount(CachePass::Values values) {
    return values == CachePass::Values::one ? 1 : values == CachePass::Values::four ? 4 : 2;
}

// What a history can hold: the finite values of a binary16.
inline bool isCacheable(dvec4 values) {
    return isNumber(values.x, 65504.0) && isNumber(values.y, 65504.0) && isNumber(values.z, 65504.0) &&
           isNumber(values.w, 65504.0);
}

// What a texel of values holds, 0 in the rest; (occlusion, shadow) of a packed channel, NaN where it holds no
// number.
inline dvec4 unpackedValues(CachePass::Values values, dvec4 texel) {
    if (values == CachePass::Values::one) return {texel.x, 0.0, 0.0, 0.0};
    if (values == CachePass::Values::two) return {texel.x, texel.y, 0.0, 0.0};
    if (values == CachePass::Values::four) return texel;
    if (values == CachePass::Values::withFrames) return {dvec2(unpackedWithFrames(texel.x)), 0.0, 0.0};
    if (!isNumber(texel.x, 65504.0)) return dvec4(std::nan(""));
    const double last = 1.0 - fractionStep(31), known = std::clamp(texel.x, 0.0, 31.0 + last);
    const double whole = std::floor(known) / 31.0, part = std::min((known - std::floor(known)) / last, 1.0);
    return values == CachePass::Values::occlusionInInteger ? dvec4(whole, part, 0.0, 0.0)
                                                           : dvec4(part, whole, 0.0, 0.0);
}

// The texel of values, depth beside them where it has its place there, or the frames.
inline dvec4 packedValues(CachePass::Values values, dvec4 unpacked, double depth, double frames = 1.0) {
    switch (values) {
    case CachePass::Values::occlusionInInteger:
        return {packPair(unpacked.x, unpacked.y), depth, 0.0, 0.0};
    case CachePass::Values::shadowInInteger:
        return {packPair(unpacked.y, unpacked.x), depth, 0.0, 0.0};
    case CachePass::Values::one:
        return {unpacked.x, depth, 0.0, 0.0};
    case CachePass::Values::withFrames:
        return {packedWithFrames(dvec2(unpacked), frames), 0.0, 0.0, 0.0};
    case CachePass::Values::two:
    case CachePass::Values::four:
        break;
    }
    return unpacked;
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

struct CacheRead {
    dvec4 values{0.0};
    double frames = 0.0, confidence = 0.0;
};

// How far a history of that depth is believed where another is expected.
inline double depthConfidence(const CachePass& pass, double expected, double depth, double threshold) {
    const double room = 1.0 - std::abs(expected - depth) / threshold;
    return isNumber(depth) ? std::clamp(room * pass.convergenceTime, 0.0, 1.0) : 0.0;
}

// Packed texels are read one by one: each counts by its own depth, and those that count tell how far all are
// believed. Of a linear filter the mean's depth counts, and one broken texel breaks all.
inline CacheRead readCache(const CachePass& pass, dvec2 texel, double expectedDepth, double threshold) {
    const dvec2 position = texel - 0.5;
    const ivec2 first(texelIndex(position.x, pass.history->width),
                      texelIndex(position.y, pass.history->height));
    const dvec2 share = glm::clamp(position - dvec2(first), 0.0, 1.0);
    const bool framed = pass.values == CachePass::Values::withFrames;
    const bool apart = framed || (isPacked(pass.values) && pass.bilinear);
    CacheRead sum;
    double depthSum = 0.0, total = 0.0;
    for (int i = 0; i < 4; ++i) {
        const ivec2 at = pass.bilinear ? first + ivec2(i % 2, i / 2)
                                       : ivec2(texelIndex(texel.x, pass.history->width),
                                               texelIndex(texel.y, pass.history->height));
        double weight = (i % 2 == 1 ? share.x : 1.0 - share.x) * (i / 2 == 1 ? share.y : 1.0 - share.y);
        if (!pass.bilinear) weight = i == 0 ? 1.0 : 0.0;
        if (weight == 0.0) continue;
        const dvec4 read = texelClamped(*pass.history, at.x, at.y);
        const dvec4 state = texelClamped(*pass.state, at.x, at.y);
        const dvec4 values = unpackedValues(pass.values, read);
        const double depth = isDepthApart(pass.values) ? state.y : read.y;
        if (!framed) sum.frames += weight * state.x;
        if (apart) {
            const double confidence = depthConfidence(pass, expectedDepth, depth, threshold);
            weight *= isCacheable(values) ? confidence : 0.0;
            if (weight == 0.0) continue;
            sum.confidence += weight * confidence;
            if (framed) sum.frames += weight * unpackedWithFrames(read.x).z;
        }
        sum.values += weight * values;
        depthSum += weight * depth;
        total += weight;
    }
    if (apart) {
        const double per = 1.0 / std::max(total, 1e-6);
        sum = {sum.values * per, framed ? sum.frames * per : sum.frames, sum.confidence * per};
    } else if (isCacheable(sum.values)) {
        sum.confidence = depthConfidence(pass, expectedDepth, depthSum, threshold);
    }
    sum.frames = held(sum.frames, 0.0, 255.0);
    return sum;
}

// What a texel of this frame counts as: what is no number is 0. Where frames are packed too, it has none.
inline dvec4 freshValues(const CachePass& pass, int x, int y) {
    const bool framed = pass.values == CachePass::Values::withFrames;
    dvec4 values = unpackedValues(framed ? CachePass::Values::two : pass.values,
                                  texelClamped(*pass.fresh, x, y));
    for (int i = 0; i < 4; ++i)
        if (!isNumber(values[i], 65504.0)) values[i] = 0.0;
    return values;
}

// The 4x4 fresh texels from one before to two behind, within the tile of 16x16: the part of the history's
// distance to their mean that is beyond what they scatter.
inline double likeness(const CachePass& pass, ivec2 texel, dvec4 values) {
    const ivec2 tile = texel / 16 * 16;
    double count = 0.0;
    const auto each = [&](auto&& take) {
        for (int i = 0; i < 16; ++i) {
            const ivec2 at = texel - 1 + ivec2(i % 4, i / 4);
            const ivec2 inTile = at - tile;
            if (std::min(inTile.x, inTile.y) < 0 || std::max(inTile.x, inTile.y) > 15) continue;
            take(freshValues(pass, at.x, at.y));
        }
    };
    dvec4 mean(0.0), variance(0.0);
    each([&](dvec4 value) {
        mean += value;
        count += 1.0;
    });
    mean /= count;
    each([&](dvec4 value) { variance += (value - mean) * (value - mean) / count; });
    double least = 1.0;
    for (int i = 0; i < valueCount(pass.values); ++i) {
        const double allowed = std::max(pass.change.x * std::sqrt(variance[i]) + pass.change.y, 1e-4);
        least = std::min(least, std::clamp(2.0 - std::abs(values[i] - mean[i]) / allowed, 0.0, 1.0));
    }
    return least;
}

struct CacheTexel {
    dvec4 values{0.0}; // as the image holds them
    double frames = 1.0, depth = 0.0;
    dvec4 unpacked{0.0};
};

// With the place moved by `away` texels, and the depth expected there by `awayDepth` metres.
inline CacheTexel cacheTexel(const CachePass& pass, int x, int y, dvec2 away = dvec2(0.0),
                             double awayDepth = 0.0) {
    const double depth = isDepthApart(pass.values) ? texelClamped(*pass.coarseDepth, x, y).x
                                                   : texelClamped(*pass.fresh, x, y).y;
    const dvec4 current = freshValues(pass, x, y);
    CacheTexel result;
    result.depth = depth > 0.0 && depth < skyDepth ? depth : skyDepth;
    result.unpacked = current;
    if (pass.where != CachePass::History::none) {
        CachePoint point = cachePoint(pass, {x, y}, result.depth);
        if (pass.where == CachePass::History::still) away = dvec2(0.0), awayDepth = 0.0;
        point.texel += away;
        const double threshold = pass.missThreshold.x + pass.missThreshold.y * result.depth;
        const CacheRead history = readCache(pass, point.texel, point.depth + awayDepth, threshold);
        const bool known = pass.historyValid > 0.5 && isInsideUv(point.texel / pass.history->extent());
        double confidence = known ? history.confidence : 0.0;
        if (pass.detectsChange && confidence > 0.0) confidence *= likeness(pass, {x, y}, history.values);
        const double moving = velocityWeight(glm::length(point.travelled - away), pass.maxWeight,
                                             pass.speedPx.x, pass.speedPx.y);
        const double weight =
            std::min(convergenceWeight(history.frames * confidence, pass.maxWeight), moving);
        for (int i = 0; i < 4; ++i)
            result.unpacked[i] =
                weight > 0.0 ? exponentialHistory(history.values[i], current[i], weight) : current[i];
        result.frames = nextConvergence(history.frames, confidence);
    }
    result.values = packedValues(pass.values, result.unpacked, result.depth, result.frames);
    return result;
}

} // namespace oracle
