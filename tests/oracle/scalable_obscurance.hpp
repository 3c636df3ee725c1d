// SPDX-License-Identifier: Apache-2.0
// Scalable ambient obscurance over a hierarchy of depths, its history, and its blur; and by how much float32
// may move them.
#pragma once

#include "ambient_occlusion.hpp"
#include "packing.hpp"

#include <optional>

namespace oracle {

// --- The hierarchy

inline constexpr int levelCount = 5;

inline ivec2 levelExtent(ivec2 frame, int level) {
    return {frame.x >> level, frame.y >> level};
}

// First texel of a level in the image that holds all of them.
inline ivec2 levelBegin(ivec2 frame, int level) {
    if (level == 0) return {0, 0};
    return {frame.x, frame.y - (frame.y >> (level - 1))};
}

// The texel of the frame that a texel of a level shows: a quarter of the square in from either of its sides,
// which one by whether the other coordinate is even.
inline ivec2 shownTexel(ivec2 texel, int level) {
    const int side = 1 << level, quarter = side / 4;
    return {texel.x * side + (texel.y % 2 != 0 ? quarter : side - 1 - quarter),
            texel.y * side + (texel.x % 2 != 0 ? quarter : side - 1 - quarter)};
}

// Where each texel of the hierarchy comes from; of no level: nothing.
inline std::optional<ivec2> hierarchySource(ivec2 frame, ivec2 texel) {
    for (int level = 0; level < levelCount; ++level) {
        const ivec2 local = texel - levelBegin(frame, level), extent = levelExtent(frame, level);
        if (local.x >= 0 && local.y >= 0 && local.x < extent.x && local.y < extent.y)
            return shownTexel(local, level);
    }
    return {};
}

// --- Digits

// 256 levels, and as many of depth in two digits; the fourth has sixteenths of a level and frames.
struct ObscuranceTexel {
    double value = 1.0, depth = 0.0, frames = 0.0;
};

inline dvec4 packedObscurance(const ObscuranceTexel& texel, double farM, double noise = 0.5) {
    const int step = static_cast<int>(std::floor(held(texel.value, 0.0, 1.0) * 4080.0 + noise));
    const int level = (step + 8) / 16, rest = step + 8 - 16 * level, code = key16Code(texel.depth / farM);
    const int frames = static_cast<int>(std::floor(held(texel.frames, 0.0, 15.0) + 0.5));
    return dvec4(level, code / 256, code % 256, 16 * frames + rest) / 255.0;
}

inline ObscuranceTexel unpackedObscurance(dvec4 texel, double farM) {
    std::array<int, 4> digit{};
    for (int c = 0; c < 4; ++c)
        digit[static_cast<size_t>(c)] = static_cast<int>(std::floor(held(texel[c], 0.0, 1.0) * 255.0 + 0.5));
    const int step = 16 * digit[0] + digit[3] % 16 - 8;
    return {std::clamp(step / 4080.0, 0.0, 1.0), (256 * digit[1] + digit[2]) / 65535.0 * farM,
            double(digit[3] / 16)};
}

// --- Obscurance

struct ScalableObscurance {
    int samples = 7, rotations = 3, frame = 0;
    bool temporal = true, motion = true, orthographic = false;
    dvec4 viewRay{0.0};
    double radius = 1.5, intensity = 1.0;
    dvec2 bias{0.0};
    double farM = 100.0, maxWeight = 0.9, movingWeight = 0.6, movingPx = 0.25;
    dvec2 missThreshold{0.05, 0.02};
    dvec2 motionToUv{1.0, 1.0};
    dvec4 toPreviousDepth{0.0, 0.0, 1.0, 0.0};
    double historyValid = 1.0;
    const Image* depth = nullptr;    // metres, of the frame
    const Image* velocity = nullptr; // of the frame
    const Image* history = nullptr;  // packed
};

inline double numberOfPixel(int x, int y) {
    return (193 * x + 146 * y) % 256 / 256.0;
}

struct SpiralTap {
    dvec2 offset{0.0}; // in radii of the screen
    double share = 0.0;
};

// Tap m of a spiral of `count`, whole turns given by `turn`: its share of the radius grows evenly, and it
// turns on by the golden angle.
inline SpiralTap spiralTap(int m, int count, double turn) {
    const double share = (m + 0.5) / count, golden = (3.0 - std::sqrt(5.0)) / 2.0;
    const double angle = 2.0 * 3.14159265358979323846 * (turn + m * golden);
    return {share * dvec2(std::cos(angle), std::sin(angle)), share};
}

inline AmbientOcclusion surfaceOf(const ScalableObscurance& pass) {
    AmbientOcclusion surface;
    surface.orthographic = pass.orthographic;
    surface.viewRay = pass.viewRay;
    surface.depth = pass.depth;
    return surface;
}

// The point that a tap finds, level by its distance.
inline dvec3 tapPoint(const ScalableObscurance& pass, dvec2 px, double distancePx) {
    int level = 0;
    while (level + 1 < levelCount && distancePx >= double(8 << (level + 1)))
        ++level;
    const ivec2 frame(pass.depth->width, pass.depth->height), extent = levelExtent(frame, level);
    const ivec2 texel = glm::min(ivec2(glm::floor(px / double(1 << level))), glm::max(extent, ivec2(1)) - 1);
    const ivec2 shown = shownTexel(glm::max(texel, ivec2(0)), level);
    const AmbientOcclusion surface = surfaceOf(pass);
    return viewPointOf(surface, dvec2(shown) + 0.5, surfaceDepth(surface, shown.x, shown.y));
}

inline constexpr double nearLimit = 0.01, mostOfATap = 0.6;

inline double tapObscurance(dvec3 inRadii, dvec3 normal, double bias) {
    const double square = glm::dot(inRadii, inRadii), near = 1.0 - square;
    if (!(square < 1.0)) return 0.0;
    const double term =
        near * near * near * std::max(glm::dot(inRadii, normal) - bias, 0.0) / (square + nearLimit);
    return std::min(term, mostOfATap);
}

// What roundings of the normal and of the two points may change of a tap's share; both in radii. A share is
// at most 1 / (2 sqrt(nearLimit)) = 5.
inline double tapError(dvec3 inRadii, double normalError, double pointError) {
    const double square = glm::dot(inRadii, inRadii), apart = std::sqrt(square);
    if (square > 1.0 + 4.0 * pointError) return 0.0;
    const double slope = (normalError * apart + 2.0 * pointError + 10.0 * apart * pointError);
    return slope / (square + nearLimit) + 30.0 * apart * pointError + 1e-6;
}

inline dvec2 radiusPx(const ScalableObscurance& pass, double depth) {
    const dvec2 extent = pass.depth->extent();
    const dvec2 perMetre = extent / glm::abs(dvec2(pass.viewRay)) / (pass.orthographic ? 1.0 : depth);
    return glm::min(pass.radius * perMetre, std::min(extent.x, extent.y));
}

inline Visibility obscuranceWith(const ScalableObscurance& pass, int x, int y, dvec3 point,
                                 const SurfaceNormal& normal) {
    const double bias = (pass.bias.x + pass.bias.y * point.z) / pass.radius;
    const dvec2 centre(x + 0.5, y + 0.5), extent = pass.depth->extent(), reach = radiusPx(pass, point.z);
    const double longest = std::max(reach.x, reach.y);
    double sum = 0.0, count = 0.0, sumError = 0.0, countError = 0.0;
    for (int i = 0; i < pass.samples; ++i) {
        const int m = pass.rotations * i + pass.frame % pass.rotations;
        const SpiralTap tap = spiralTap(m, pass.rotations * pass.samples, numberOfPixel(x, y));
        const dvec2 px = centre + reach * tap.offset;
        const double distance = longest * tap.share;
        const auto share = [&](dvec2 at, double away) {
            return tapObscurance((tapPoint(pass, at, away) - point) / pass.radius, normal.value, bias);
        };
        const bool known = isInsideUv(px / extent);
        const double own = known ? share(px, distance) : 0.0;
        sum += own;
        count += known;
        // Sine, cosine and their i-fold rotation; the sum of place and offset.
        const double error = 1e-6 * (i + 1) * distance + 0x1p-21 * std::max(extent.x, extent.y);
        double most = 0.0;
        bool border = false;
        for (int corner = 0; corner < 27; ++corner) {
            const dvec2 moved = px + error * dvec2(corner % 3 - 1, corner / 3 % 3 - 1);
            const double away = distance * (1.0 + 1e-6 * (corner / 9 - 1));
            border = border || isInsideUv(moved / extent) != known;
            if (!known && !border) continue;
            const dvec3 found = (tapPoint(pass, moved, away) - point) / pass.radius;
            const double pointError = 8.0 * 0x1p-24 * glm::length(point) / pass.radius;
            most = std::max(most,
                            std::abs(share(moved, away) - own) + tapError(found, normal.error, pointError));
        }
        sumError += border ? std::max(most, own) : most; // a tap beyond the border takes its share with it
        countError += border;
    }
    const double darkness = 5.0 * pass.intensity, least = std::max(count - countError, 1.0);
    const double value = 1.0 - darkness * sum / std::max(count, 1.0);
    const double error = darkness * (sumError + countError * sum / least) / least + 1e-6;
    return {std::clamp(value, 0.0, 1.0), std::min(error, 1.0)};
}

inline Visibility obscuranceAt(const ScalableObscurance& pass, int x, int y) {
    const AmbientOcclusion surface = surfaceOf(pass);
    const double depth = surfaceDepth(surface, x, y);
    if (depth >= skyDepth) return {};
    const dvec3 point = viewPointOf(surface, dvec2(x + 0.5, y + 0.5), depth);
    Visibility result;
    bool first = true;
    for (const SurfaceNormal& normal : surfaceNormals(surface, {x, y}, point)) {
        const Visibility each = obscuranceWith(pass, x, y, point, normal);
        if (first)
            result = each;
        else
            result.error = std::max(result.error, std::abs(each.value - result.value) + each.error);
        first = false;
    }
    return result;
}

// --- The history

// Most weight of history at a speed in pixels a frame. A speed that is no number has no history anyway.
inline double mostWeight(const ScalableObscurance& pass, double speedPx) {
    const double least = std::min(pass.movingWeight, pass.maxWeight);
    const double share = speedPx < pass.movingPx ? 1.0 - speedPx / pass.movingPx : 0.0;
    return least + (pass.maxWeight - least) * share * share * (3.0 - 2.0 * share);
}

// `away` in texels of the history, `deeper` in metres: what roundings may do.
inline ObscuranceTexel accumulatedAt(const ScalableObscurance& pass, int x, int y, double visibility,
                                     dvec2 away = dvec2(0.0), double deeper = 0.0) {
    const AmbientOcclusion surface = surfaceOf(pass);
    const double depth = surfaceDepth(surface, x, y);
    ObscuranceTexel result{visibility, depth, 1.0};
    if (!pass.temporal) return result;
    const dvec3 point = viewPointOf(surface, dvec2(x + 0.5, y + 0.5), depth);
    const dvec2 extent = pass.depth->extent();
    dvec2 uv = dvec2(x + 0.5, y + 0.5) / extent;
    double expected = depth, maxWeight = pass.maxWeight;
    if (pass.motion) {
        const dvec2 motion = dvec2(pass.velocity->at(x, y)) * pass.motionToUv;
        uv -= motion;
        maxWeight = mostWeight(pass, glm::length(motion * extent));
        expected = glm::dot(pass.toPreviousDepth, dvec4(point, 1.0));
    }
    uv += away / extent;
    expected = std::min(expected, pass.farM);
    if (!isInsideUv(uv) || pass.historyValid < 0.5) return result;
    const ObscuranceTexel history = unpackedObscurance(samplePoint(*pass.history, uv), pass.farM);
    const double threshold = std::max(pass.missThreshold.x + pass.missThreshold.y * expected, 1e-6);
    const double apart = std::abs(expected + deeper - history.depth) / threshold;
    const double room = std::clamp(2.0 * (1.0 - apart), 0.0, 1.0);
    const double confidence = room * room * (3.0 - 2.0 * room), held = history.frames * confidence;
    const double weight = std::min(held / (held + 1.0), maxWeight);
    result.value = visibility + (history.value - visibility) * weight;
    result.frames = held + 1.0;
    return result;
}

// Of the writing of a pixel in a frame.
inline double writeNoise(const ScalableObscurance& pass, int x, int y) {
    if (!pass.temporal) return 0.5;
    return glm::fract(numberOfPixel(x, y) + 159 * pass.frame % 256 / 256.0) + 1.0 / 512.0;
}

// --- The blur

struct ObscuranceFilter {
    ivec2 direction{1, 0};
    dvec2 depthRange{0.05, 0.01};
    double farM = 100.0;
    const Image* source = nullptr;
};

inline ObscuranceTexel filteredObscurance(const ObscuranceFilter& pass, int x, int y) {
    const auto at = [&](int i) {
        return unpackedObscurance(
            texelClamped(*pass.source, x + i * pass.direction.x, y + i * pass.direction.y), pass.farM);
    };
    ObscuranceTexel centre = at(0);
    const double range = std::max(pass.depthRange.x + pass.depthRange.y * centre.depth, 1e-6);
    double sum = 0.0, weights = 0.0;
    for (int i = -4; i <= 4; ++i) {
        const ObscuranceTexel tap = at(i);
        const double near = std::max(1.0 - std::abs(tap.depth - centre.depth) / range, 0.0);
        const double weight = std::exp(-i * i / 8.0) * near;
        sum += weight * tap.value;
        weights += weight;
    }
    centre.value = sum / weights;
    return centre;
}

} // namespace oracle
