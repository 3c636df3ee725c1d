// SPDX-License-Identifier: Apache-2.0
// Catmull-Rom resampling, whole and without the four corners of its footprint.
#pragma once

#include "colour.hpp"
#include "image.hpp"

#include <array>

namespace oracle {

// The cardinal cubic of tension 1/2 at a distance in texels: 1 at 0, 0 at 1 and 2, and beyond.
inline double catmullRom(double distance) {
    double d = std::abs(distance);
    if (d < 1.0) return 1.0 + d * d * (1.5 * d - 2.5);
    if (d < 2.0) return 2.0 + d * (-4.0 + d * (2.5 - 0.5 * d));
    return 0.0;
}

struct CubicAxis {
    double first = 0.0;              // texel index of the second tap, whose centre is at or before the place
    std::array<double, 4> weights{}; // of first - 1 ... first + 2
};

inline CubicAxis cubicAxis(double uv, double size) {
    double position = uv * size - 0.5;
    CubicAxis axis{std::floor(position), {}};
    for (int tap = 0; tap < 4; ++tap)
        axis.weights[static_cast<size_t>(tap)] = catmullRom(position - (axis.first + tap - 1));
    return axis;
}

// Weighted sum over the 12 texels of the footprint that are no corners, texel by texel; no repair.
inline dvec3 sampleCatmullRom12(const Image& image, dvec2 uv) {
    CubicAxis x = cubicAxis(uv.x, image.width), y = cubicAxis(uv.y, image.height);
    dvec3 sum(0.0);
    double weights = 0.0;
    for (int i = 0; i < 16; ++i) {
        int column = i % 4, row = i / 4;
        if ((column == 0 || column == 3) && (row == 0 || row == 3)) continue;
        double weight = x.weights[static_cast<size_t>(column)] * y.weights[static_cast<size_t>(row)];
        int tx = texelIndex(x.first, image.width) + column - 1,
            ty = texelIndex(y.first, image.height) + row - 1;
        sum += weight * dvec3(texelClamped(image, tx, ty));
        weights += weight;
    }
    return sum / weights;
}

// The same with the inner pair of each axis merged into one bilinear read, so that broken texels are repaired
// after the read, as the hardware allows: five reads, negative results to 0.
inline dvec3 sampleCatmullRom5(const Image& image, dvec2 uv) {
    CubicAxis x = cubicAxis(uv.x, image.width), y = cubicAxis(uv.y, image.height);
    auto places = [](const CubicAxis& axis) {
        double inner = axis.weights[1] + axis.weights[2];
        return dvec3(axis.first - 0.5, axis.first + 0.5 + axis.weights[2] / inner, axis.first + 2.5);
    };
    auto weights = [](const CubicAxis& axis) {
        return dvec3(axis.weights[0], axis.weights[1] + axis.weights[2], axis.weights[3]);
    };
    dvec3 px = places(x), py = places(y), wx = weights(x), wy = weights(y);
    dvec3 sum(0.0);
    double total = 0.0;
    for (ivec2 tap : {ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(2, 1), ivec2(1, 2)}) {
        double weight = wx[tap.x] * wy[tap.y];
        dvec2 place = dvec2(px[tap.x], py[tap.y]) / image.extent();
        sum += weight * sanitize(dvec3(sampleLinear(image, place)));
        total += weight;
    }
    return sanitize(sum / total);
}

} // namespace oracle
