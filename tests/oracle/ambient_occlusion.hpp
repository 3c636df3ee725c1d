// SPDX-License-Identifier: Apache-2.0
// Screen-space ambient occlusion by checks of points over the surface, and by how much float32 may move it.
#pragma once

#include "coarse_depth.hpp"

#include <array>
#include <vector>

namespace oracle {

struct AmbientOcclusion {
    int samples = 4, subsets = 4, frame = 0;
    bool readNormals = false, orthographic = false;
    dvec4 viewRay{0.0}; // view x and y are xy * uv + zw, times depth in perspective
    double radius = 1.0;
    dvec2 bias{0.01, 0.001}; // metres, and metres a metre of depth
    const Image* depth = nullptr;
    const Image* normal = nullptr; // of the frame
    int ratio = 2;                 // of its texels a texel of the depth, along an axis
};

// Visibility, and the most that roundings may move it by. A pixel that they may move anywhere has an error
// of 1.
struct Visibility {
    double value = 1.0, error = 0.0;
};

inline double surfaceDepth(const AmbientOcclusion& pass, int x, int y) {
    const double depth = texelClamped(*pass.depth, x, y).x;
    return depth > 0.0 && depth < skyDepth ? depth : skyDepth;
}

inline dvec3 viewPointOf(const AmbientOcclusion& pass, dvec2 texel, double depth) {
    const dvec2 ray = texel / pass.depth->extent() * dvec2(pass.viewRay.x, pass.viewRay.y) +
                      dvec2(pass.viewRay.z, pass.viewRay.w);
    return {pass.orthographic ? ray : ray * depth, depth};
}

inline dvec2 texelOfPoint(const AmbientOcclusion& pass, dvec3 point) {
    const dvec2 ray = pass.orthographic ? dvec2(point) : dvec2(point) / point.z;
    return (ray - dvec2(pass.viewRay.z, pass.viewRay.w)) / dvec2(pass.viewRay.x, pass.viewRay.y) *
           pass.depth->extent();
}

// frac(1/2 + k / g^i), g the root of g^4 = g + 1.
inline dvec3 sequencePoint(int k) {
    const double g = 1.2207440846057596;
    return glm::fract(0.5 + double(k) * dvec3(1.0 / g, 1.0 / (g * g), 1.0 / (g * g * g)));
}

// A 4x4 ordered dither: the bits of x ^ y and y from the finest up, the finest counting most.
inline double orderedOffset(int x, int y) {
    const int fine = 2 * ((x ^ y) & 1) + (y & 1), coarse = 2 * ((x ^ y) >> 1 & 1) + (y >> 1 & 1);
    return (4 * fine + coarse) / 16.0;
}

// Two steps over the surface, each to the side with the smaller difference of depth; all choices that are as
// good within `slack` of it.
inline std::vector<dvec3> surfaceSteps(const AmbientOcclusion& pass, ivec2 texel, ivec2 step) {
    const auto point = [&](ivec2 at) {
        return viewPointOf(pass, dvec2(at) + 0.5, surfaceDepth(pass, at.x, at.y));
    };
    const auto inside = [&](ivec2 at) {
        return at.x >= 0 && at.y >= 0 && at.x < pass.depth->width && at.y < pass.depth->height;
    };
    const dvec3 here = point(texel), before = here - point(texel - step), after = point(texel + step) - here;
    if (!inside(texel - step)) return {after};
    if (!inside(texel + step)) return {before};
    const double difference = std::abs(before.z) - std::abs(after.z), slack = 0x1p-22 * here.z;
    if (std::abs(difference) <= slack) return {after, before};
    return {difference < 0.0 ? before : after};
}

struct SurfaceNormal {
    dvec3 value{0.0, 0.0, -1.0};
    double error = 0.0;
};

inline std::vector<SurfaceNormal> surfaceNormals(const AmbientOcclusion& pass, ivec2 texel, dvec3 point) {
    if (pass.readNormals) {
        const ivec2 pixel = pixelOfCoarseTexel(texel, pass.ratio);
        const dvec3 read(texelClamped(*pass.normal, pixel.x, pixel.y));
        const double square = glm::dot(read, read);
        if (square > 1e-6 && square < 1e6) return {{read / std::sqrt(square), 0x1p-21}};
        return {{}};
    }
    std::vector<SurfaceNormal> normals;
    for (const dvec3& across : surfaceSteps(pass, texel, {1, 0}))
        for (const dvec3& down : surfaceSteps(pass, texel, {0, 1})) {
            dvec3 normal = glm::cross(across, down);
            const double area = glm::length(normal), towards = pass.orthographic ? 1.0 : point.z;
            const dvec3 view = pass.orthographic ? dvec3(0.0, 0.0, towards) : point;
            if (glm::dot(normal, view) > 0.0) normal = -normal;
            // Each step is the difference of two points, each rounded four times.
            const double stepError = 8.0 * 0x1p-24 * (glm::length(point) + glm::length(across + down));
            normals.push_back({normal / area, stepError * (glm::length(across) + glm::length(down)) / area});
        }
    return normals;
}

inline double contribution(const AmbientOcclusion& pass, dvec3 sample, double bias, bool& known) {
    const dvec2 texel = texelOfPoint(pass, sample);
    known = sample.z > 0.0 && isInsideUv(texel / pass.depth->extent());
    if (!known) return 0.0;
    const ivec2 at(texelIndex(texel.x, pass.depth->width), texelIndex(texel.y, pass.depth->height));
    const double inFront = sample.z - surfaceDepth(pass, at.x, at.y);
    return std::clamp(inFront / bias - 1.0, 0.0, 1.0) * std::clamp(2.0 - inFront / pass.radius, 0.0, 1.0);
}

// Point over the surface of sample k and how far off it may be.
struct CheckedPoint {
    dvec3 place{0.0};
    double error = 0.0;
};

inline CheckedPoint checkedPoint(const AmbientOcclusion& pass, dvec3 point, const SurfaceNormal& normal,
                                 ivec2 texel, int k) {
    dvec3 u = sequencePoint(k);
    u.x += orderedOffset(texel.x, texel.y);
    u.z = glm::fract(u.z + orderedOffset(texel.y + 1, texel.x));
    const double uError = 3e-7 * (2 + k), root = std::sqrt(uError);
    // A tangent frame without a discontinuity but at n = +z.
    const dvec3 n = normal.value;
    const double side = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (side + n.z);
    const dvec3 tangent(1.0 + side * n.x * n.x * a, side * n.x * n.y * a, -side * n.x);
    const dvec3 bitangent = glm::cross(n, tangent);
    const double angle = 2.0 * 3.14159265358979323846 * u.x;
    const dvec3 direction =
        std::sqrt(u.y) * (std::cos(angle) * tangent + std::sin(angle) * bitangent) + std::sqrt(1.0 - u.y) * n;
    const auto rootError = [&](double of) { return uError / std::max(std::sqrt(of), root); };
    double error = 7.0 * uError + rootError(u.y) + rootError(1.0 - u.y) + rootError(u.z);
    error += 6.0 * normal.error + 1e-6;
    const bool wraps = std::min(u.y, 1.0 - u.y) < uError || std::min(u.z, 1.0 - u.z) < uError;
    if (wraps || std::abs(n.z) < 4.0 * normal.error + 1e-6) error = HUGE_VAL;
    return {point + pass.radius * std::sqrt(u.z) * direction,
            pass.radius * error + 0x1p-21 * glm::length(point)};
}

inline Visibility visibilityWith(const AmbientOcclusion& pass, ivec2 texel, dvec3 point,
                                 const SurfaceNormal& normal) {
    const double bias = std::max(pass.bias.x + pass.bias.y * point.z, 1e-6);
    double sum = 0.0, count = 0.0, sumError = 0.0, countError = 0.0;
    for (int tap = 0; tap < pass.samples; ++tap) {
        const int subset = pass.frame % pass.subsets;
        const CheckedPoint checked = checkedPoint(pass, point, normal, texel, subset * pass.samples + tap);
        if (std::isinf(checked.error)) return {1.0, 1.0};
        bool known = false;
        const double occluded = contribution(pass, checked.place, bias, known);
        sum += occluded;
        count += known ? 1.0 : 0.0;
        double most = 0.0;
        bool border = false;
        for (int corner = 0; corner < 27; ++corner) {
            const dvec3 away(corner % 3 - 1, corner / 3 % 3 - 1, corner / 9 - 1);
            bool other = false;
            const double moved = contribution(pass, checked.place + checked.error * away, bias, other);
            most = std::max(most, std::abs(moved - occluded));
            border = border || other != known;
        }
        sumError += most;
        countError += border ? 1.0 : 0.0;
    }
    const double least = std::max(count - countError, 1.0);
    return {1.0 - sum / std::max(count, 1.0), std::min((sumError + countError) / least + 4e-7, 1.0)};
}

inline Visibility visibilityAt(const AmbientOcclusion& pass, int x, int y) {
    const ivec2 texel(x, y);
    const double depth = surfaceDepth(pass, x, y);
    if (depth >= skyDepth) return {};
    const dvec3 point = viewPointOf(pass, dvec2(texel) + 0.5, depth);
    Visibility result;
    bool first = true;
    for (const SurfaceNormal& normal : surfaceNormals(pass, texel, point)) {
        const Visibility each = visibilityWith(pass, texel, point, normal);
        if (first)
            result = each;
        else
            result.error = std::max(result.error, std::abs(each.value - result.value) + each.error);
        first = false;
    }
    return result;
}

} // namespace oracle
