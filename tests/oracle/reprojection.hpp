// SPDX-License-Identifier: Apache-2.0
// Coordinates, depth, the closest of nine fragments, and where a surface was under the previous camera.
#pragma once

#include "image.hpp"

#include <array>

namespace oracle {

// NDC y up and UV y down, unless sharesY.
inline dvec2 ndcToUv(dvec2 ndc, bool sharesY = false) {
    return {(ndc.x + 1.0) / 2.0, sharesY ? (ndc.y + 1.0) / 2.0 : (1.0 - ndc.y) / 2.0};
}

inline dvec2 uvToNdc(dvec2 uv, bool sharesY = false) {
    return {2.0 * uv.x - 1.0, sharesY ? 2.0 * uv.y - 1.0 : 1.0 - 2.0 * uv.y};
}

// -0 is outside, as what a place left of the image may be rounded to.
inline bool isInsideUv(dvec2 uv) {
    const auto inside = [](double place) { return !std::signbit(place) && place <= 1.0; };
    return inside(uv.x) && inside(uv.y);
}

// Both a projection of any depth kind, perspective or orthographic, unjittered, symmetric or not.
struct Camera {
    dmat4 worldToView{1.0};
    dmat4 viewToClip{1.0};
};

inline bool isOrthographic(const dmat4& viewToClip) {
    return viewToClip[2][3] == 0.0;
}

// View z of a device depth, from device = (a z + b) / (c z + d). Infinite where the far plane is.
inline double linearDepth(double device, const dmat4& p) {
    return (p[3][2] - device * p[3][3]) / (device * p[2][3] - p[2][2]);
}

inline double deviceDepth(double linear, const dmat4& p) {
    return (p[2][2] * linear + p[3][2]) / (p[2][3] * linear + p[3][3]);
}

// The point of view depth z that projects to ndc, homogeneous; of infinite depth, the direction to it.
inline dvec4 viewPoint(dvec2 ndc, double z, const dmat4& p) {
    bool infinite = std::isinf(z);
    double depth = infinite ? 1.0 : z, one = infinite ? 0.0 : 1.0;
    double w = p[2][3] * depth + p[3][3] * one;
    return {(ndc.x * w - p[2][0] * depth - p[3][0] * one) / p[0][0],
            (ndc.y * w - p[2][1] * depth - p[3][1] * one) / p[1][1], depth, one};
}

// What stands for a place on or behind the camera plane, or eight images away: outside of every image.
inline const dvec2 behindCameraUv{-8.0, -8.0};

inline dvec2 clipToUv(dvec4 clip, bool sharesY = false) {
    if (!(clip.w > 0.0)) return behindCameraUv;
    dvec2 uv = ndcToUv(dvec2(clip) / clip.w, sharesY);
    return glm::all(glm::lessThanEqual(glm::abs(uv), dvec2(8.0))) ? uv : behindCameraUv;
}

// q_uv of "Reprojection of static scenes". uv is unjittered; linear is view z of the current camera.
inline dvec2 reprojectLinearDepth(dvec2 uv, double linear, const Camera& current, const Camera& previous,
                                  bool sharesY = false) {
    dvec4 view = viewPoint(uvToNdc(uv, sharesY), linear, current.viewToClip);
    dvec4 world = glm::inverse(current.worldToView) * view;
    return clipToUv(previous.viewToClip * (previous.worldToView * world), sharesY);
}

inline dvec2 reprojectDeviceDepth(dvec2 uv, double device, const Camera& current, const Camera& previous,
                                  bool sharesY = false) {
    return reprojectLinearDepth(uv, linearDepth(device, current.viewToClip), current, previous, sharesY);
}

// v = p_uv - q_uv of one surface point from its clip positions in both frames.
inline dvec2 motionFromClip(dvec4 clip, dvec4 previousClip, bool sharesY = false) {
    return clipToUv(clip, sharesY) - clipToUv(previousClip, sharesY);
}

inline bool isCloser(double a, double b, bool reversed) {
    return reversed ? a > b : a < b;
}

using DepthSquare = std::array<double, 9>; // rows from the upper left

inline DepthSquare depthSquareAt(const Image& depth, int x, int y) {
    DepthSquare square;
    for (int i = 0; i < 9; ++i)
        square[static_cast<size_t>(i)] = texelClamped(depth, x + i % 3 - 1, y + i / 3 - 1).x;
    return square;
}

// Offset of the closest of nine. The centre wins against equals; among equal others the order is free, here
// the first. A NaN neighbour is passed over, a NaN centre stays.
inline ivec2 closestFragment(const DepthSquare& square, bool reversed) {
    size_t closest = 4;
    for (size_t i = 0; i < 9; ++i)
        if (isCloser(square[i], square[closest], reversed)) closest = i;
    return {static_cast<int>(closest % 3) - 1, static_cast<int>(closest / 3) - 1};
}

} // namespace oracle
