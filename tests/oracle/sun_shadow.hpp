// SPDX-License-Identifier: Apache-2.0
// Shadows of parallel light by comparisons around a point with the plane of its surface, and by how much
// float32 may move them.
#pragma once

#include "ambient_occlusion.hpp"
#include "packing.hpp"

namespace oracle {

struct ShadowColumn {
    dmat4 viewToTexels{1.0}; // x and y in texels of the column, y down; depth as the map holds it
    double farDepth = 0.0;   // linear depth at which it ends
};

struct SunShadow {
    int samples = 4, subsets = 4, frame = 0;
    bool reversed = false;
    AmbientOcclusion surface; // view rays, projection and coarse depth
    std::vector<ShadowColumn> columns;
    dvec2 columnSize{1.0}; // texels
    double radius = 0.1;   // metres
    double leastTexels = 1.0;
    dvec2 bias{0.01, 0.001}; // metres, and metres a metre of linear depth
    double steepest = 8.0;   // metres of depth a metre across, of the larger texel
    const Image* map = nullptr;
};

inline dvec3 rowOf(const dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i]};
}

// frac(1/2 + k / p^i), p the root of p^3 = p + 1.
inline dvec2 discSequencePoint(int k) {
    const double p = 1.3247179572447460;
    return glm::fract(0.5 + double(k) * dvec2(1.0 / p, 1.0 / (p * p)));
}

// A place in a column and the plane through it, with their errors.
struct ShadowReceiver {
    const ShadowColumn* column = nullptr;
    int index = 0;
    dvec3 place{0.0}, placeError{0.0};
    dvec2 slope{0.0}, slopeError{0.0}; // depth a texel
};

// What eight roundings make of the products of a transform, in the first column and then in this one.
inline dvec3 transformError(const SunShadow& pass, const dmat4& m, double depth, bool isPoint) {
    const AmbientOcclusion& surface = pass.surface;
    const dvec4 ray = glm::abs(surface.viewRay) * (surface.orthographic ? 1.0 : depth);
    const dvec3 reach(ray.x + ray.z, ray.y + ray.w, depth);
    dvec3 error(0.0);
    for (int i = 0; i < 3; ++i)
        error[i] =
            8.0 * 0x1p-24 * (glm::dot(glm::abs(rowOf(m, i)), reach) + (isPoint ? std::abs(m[3][i]) : 0.0));
    return error;
}

inline void addPlane(const SunShadow& pass, ShadowReceiver& receiver, dvec3 across, dvec3 down) {
    const dmat4& m = receiver.column->viewToTexels;
    const auto inColumn = [&](dvec3 step) {
        return dvec3(glm::dot(rowOf(m, 0), step), glm::dot(rowOf(m, 1), step), glm::dot(rowOf(m, 2), step));
    };
    const dvec3 a = inColumn(across), b = inColumn(down), normal = glm::cross(a, b);
    // A step is computed from the change of depth and from one texel's ray, four roundings of each.
    const auto stepError = [&](dvec3 step) {
        dvec3 error(0.0);
        for (int i = 0; i < 3; ++i)
            error[i] =
                16.0 * 0x1p-24 * glm::dot(glm::abs(rowOf(m, i)), glm::abs(step) + dvec3(std::abs(step.z)));
        return error;
    };
    const dvec3 ea = stepError(across), eb = stepError(down);
    const auto product = [&](int i, int j) {
        return ea[i] * std::abs(b[j]) + std::abs(a[i]) * eb[j] + ea[j] * std::abs(b[i]) +
               std::abs(a[j]) * eb[i] + 0x1p-22 * (std::abs(a[i] * b[j]) + std::abs(a[j] * b[i]));
    };
    const dvec3 normalError(product(1, 2), product(2, 0), product(0, 1));
    const dmat4& first = pass.columns[0].viewToTexels;
    const double texelsAMetre = std::min(glm::length(rowOf(first, 0)), glm::length(rowOf(first, 1)));
    for (int c = 0; c < 2; ++c) {
        const double scale = glm::length(rowOf(m, c)) / glm::length(rowOf(first, c));
        const double limit = pass.steepest * glm::length(rowOf(m, 2)) / texelsAMetre / scale;
        const double area = std::abs(normal.z) - normalError.z;
        const double slope = normal.z == 0.0 ? 0.0 : -normal[c] / normal.z;
        receiver.slope[c] = std::clamp(slope, -limit, limit);
        receiver.slopeError[c] = 2.0 * limit;
        if (area <= 0.0) continue;
        const double error = (normalError[c] + std::abs(slope) * normalError.z) / area;
        // Far beyond the limit both are held to it.
        receiver.slopeError[c] =
            std::abs(slope) - error > limit ? 1e-6 * limit : std::min(error, 2.0 * limit);
    }
}

// The places that are as right as each other: the nearer side of a texel may be either.
inline std::vector<ShadowReceiver> receiversAt(const SunShadow& pass, ivec2 texel, double depth) {
    ShadowReceiver receiver;
    for (const ShadowColumn& column : pass.columns) {
        receiver.column = &column;
        if (depth <= column.farDepth || &column == &pass.columns.back()) break;
        ++receiver.index;
    }
    const dmat4& m = receiver.column->viewToTexels;
    const dvec3 point = viewPointOf(pass.surface, dvec2(texel) + 0.5, depth);
    receiver.place = dvec3(m * dvec4(point, 1.0));
    const dmat4& first = pass.columns[0].viewToTexels;
    const dvec3 firstError = transformError(pass, first, depth, true);
    for (int i = 0; i < 3; ++i) {
        const double scale = glm::length(rowOf(m, i)) / glm::length(rowOf(first, i));
        // Times the scale, and plus an offset of the size of the place in the first column.
        receiver.placeError[i] = 2.0 * firstError[i] * scale + transformError(pass, m, depth, true)[i];
    }
    std::vector<ShadowReceiver> found;
    for (const dvec3& across : surfaceSteps(pass.surface, texel, {1, 0}))
        for (const dvec3& down : surfaceSteps(pass.surface, texel, {0, 1})) {
            addPlane(pass, receiver, across, down);
            found.push_back(receiver);
        }
    return found;
}

// 1 where the texel shadows the plane; with `error` moved either way, 1 where that changes it.
struct Shadowed {
    double value = 0.0, error = 0.0;
};

inline Shadowed shadowedBy(const SunShadow& pass, const ShadowReceiver& receiver, double depth, ivec2 texel) {
    const dmat4 &m = receiver.column->viewToTexels, &first = pass.columns[0].viewToTexels;
    const double scale = glm::length(rowOf(m, 2)) / glm::length(rowOf(first, 2));
    const double bias = (pass.bias.x + pass.bias.y * depth) * glm::length(rowOf(first, 2)) * scale;
    const dvec2 away = dvec2(texel) + 0.5 - dvec2(receiver.place);
    const double plane = receiver.place.z + glm::dot(receiver.slope, away);
    const double error =
        receiver.placeError.z + glm::dot(receiver.slopeError, glm::abs(away)) +
        glm::dot(glm::abs(receiver.slope), dvec2(receiver.placeError)) +
        0x1p-22 * (std::abs(plane) + glm::dot(glm::abs(receiver.slope), glm::abs(away)) + bias);
    const double stored =
        texelClamped(*pass.map, texel.x + int(pass.columnSize.x) * receiver.index, texel.y).x;
    // Depth from the sun; a map's end is 1 or, reversed, 0.
    const double margin =
        pass.reversed ? stored - std::max(plane, 0.0) - bias : std::min(plane, 1.0) - bias - stored;
    return {margin > 0.0 ? 1.0 : 0.0, std::abs(margin) <= error ? 1.0 : 0.0};
}

inline Visibility visibilityOfSun(const SunShadow& pass, ivec2 pixel, double depth,
                                  const ShadowReceiver& receiver) {
    const dvec2 outside = glm::abs(dvec2(receiver.place) / pass.columnSize - 0.5) - 0.5;
    const dvec2 slack = dvec2(receiver.placeError) / pass.columnSize + 0x1p-22;
    if (std::max(outside.x - slack.x, outside.y - slack.y) > 0.0) return {1.0, 0.0};
    const bool atBorder = outside.x > -slack.x || outside.y > -slack.y;
    double sum = 0.0, error = 0.0;
    for (int tap = 0; tap < pass.samples; ++tap) {
        const int k = pass.frame % pass.subsets * pass.samples + tap;
        dvec2 u = discSequencePoint(k);
        u.x += orderedOffset(pixel.x, pixel.y);
        u.y = glm::fract(u.y + orderedOffset(pixel.y + 1, pixel.x));
        const double uError = 3e-7 * (2 + k);
        if (std::min(u.y, 1.0 - u.y) < uError) return {1.0, 1.0};
        const double angle = 2.0 * 3.14159265358979323846 * u.x, root = std::sqrt(u.y);
        ivec2 low, high, middle;
        for (int c = 0; c < 2; ++c) {
            const double texelsAMetre = glm::length(rowOf(receiver.column->viewToTexels, c));
            const double radius = std::max(pass.radius * texelsAMetre, pass.leastTexels);
            const double at =
                receiver.place[c] + radius * root * (c == 0 ? std::cos(angle) : std::sin(angle));
            const double off = receiver.placeError[c] + radius * (7.0 * uError + uError / root + 1e-6) +
                               0x1p-22 * std::abs(at);
            const auto texelAt = [&](double x) {
                return texelIndex(std::clamp(x, 0.0, pass.columnSize[c] - 0.5), 1 << 20);
            };
            low[c] = texelAt(at - off);
            middle[c] = texelAt(at);
            high[c] = texelAt(at + off);
        }
        const double shadowed = shadowedBy(pass, receiver, depth, middle).value;
        double mayDiffer = 0.0;
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const Shadowed each = shadowedBy(pass, receiver, depth, {x, y});
                mayDiffer = std::max({mayDiffer, each.error, std::abs(each.value - shadowed)});
            }
        sum += shadowed / pass.samples;
        error += mayDiffer / pass.samples;
    }
    return {1.0 - sum, atBorder ? 1.0 : std::min(1.0, error + 4e-7)};
}

inline Visibility sunVisibilityAt(const SunShadow& pass, int x, int y) {
    const double depth = surfaceDepth(pass.surface, x, y);
    if (depth >= skyDepth || depth > pass.columns.back().farDepth) return {};
    Visibility result;
    bool first = true;
    for (const ShadowReceiver& receiver : receiversAt(pass, {x, y}, depth)) {
        const Visibility each = visibilityOfSun(pass, {x, y}, depth, receiver);
        if (first)
            result = each;
        else
            result.error = std::max(result.error, std::abs(each.value - result.value) + each.error);
        first = false;
    }
    return result;
}

} // namespace oracle
