// SPDX-License-Identifier: Apache-2.0
// The cubic B-spline texel by texel, the history of 2x2 texels a pixel, and mip levels.
#pragma once

#include "image.hpp"

#include <array>

namespace oracle {

// The uniform cubic B-spline at a distance in texels: the box convolved with itself three times.
inline double bSpline(double distance) {
    const double d = std::abs(distance);
    if (d < 1.0) return 2.0 / 3.0 - d * d + d * d * d / 2.0;
    if (d < 2.0) return (2.0 - d) * (2.0 - d) * (2.0 - d) / 6.0;
    return 0.0;
}

// Weighted sum of the 16 texels around uv.
inline dvec4 sampleBSpline16(const Image& image, dvec2 uv) {
    const dvec2 position = uv * image.extent() - 0.5;
    const ivec2 first(static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y)));
    dvec4 sum(0.0);
    for (int y = first.y - 1; y <= first.y + 2; ++y)
        for (int x = first.x - 1; x <= first.x + 2; ++x)
            sum += bSpline(position.x - x) * bSpline(position.y - y) * texelClamped(image, x, y);
    return sum;
}

// Texel of a history of twice the size in which the sample of a pixel lies, when its centre shows what is at
// -jitter from it. A sample on a border belongs to the right and to the lower texel.
inline ivec2 highResolutionTexel(ivec2 pixel, dvec2 jitter) {
    ivec2 texel;
    for (int axis = 0; axis < 2; ++axis) {
        const double inPixel = 0.5 - jitter[axis];
        texel[axis] = 2 * pixel[axis] + (inPixel >= 0.5 ? 1 : 0);
    }
    return texel;
}

inline double mipLevel(dvec2 ddx, dvec2 ddy) {
    return std::max(0.0, std::log2(std::max(glm::length(ddx), glm::length(ddy))));
}

} // namespace oracle
