// SPDX-License-Identifier: Apache-2.0
// An image of doubles and the two filters that the passes read with, both clamped to the edge, one mip level.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

namespace oracle {

using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;

struct Image {
    int width = 0, height = 0;
    std::vector<dvec4> texels; // rows top to bottom

    Image() = default;
    Image(int w, int h, dvec4 fill = dvec4(0.0))
        : width(w), height(h), texels(static_cast<size_t>(w) * static_cast<size_t>(h), fill) {}
    dvec2 extent() const { return {width, height}; }
    dvec4& at(int x, int y) { return texels[static_cast<size_t>(y) * width + x]; }
    const dvec4& at(int x, int y) const { return texels[static_cast<size_t>(y) * width + x]; }
};

inline const dvec4& texelClamped(const Image& image, int x, int y) {
    return image.at(std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
}

// Texel index of a coordinate in texels; far coordinates stay in the range of int, NaN gives the first texel.
inline int texelIndex(double coordinate, int size) {
    double bounded = coordinate >= -2.0 ? std::min(coordinate, size + 2.0) : -2.0;
    return static_cast<int>(std::floor(bounded));
}

// The texel whose square holds uv.
inline dvec4 samplePoint(const Image& image, dvec2 uv) {
    dvec2 texel = uv * image.extent();
    return texelClamped(image, texelIndex(texel.x, image.width), texelIndex(texel.y, image.height));
}

// The four texels whose centres surround uv, by the areas opposite to them. A texel of weight 0 takes no
// part, so that a NaN beside an exactly hit centre does not reach the result; hardware may let it.
inline dvec4 sampleLinear(const Image& image, dvec2 uv) {
    dvec2 position = uv * image.extent() - 0.5;
    ivec2 first(texelIndex(position.x, image.width), texelIndex(position.y, image.height));
    dvec2 share = glm::clamp(position - dvec2(first), 0.0, 1.0);
    dvec4 sum(0.0);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) {
            double weight = (x == 1 ? share.x : 1.0 - share.x) * (y == 1 ? share.y : 1.0 - share.y);
            if (weight > 0.0) sum += weight * texelClamped(image, first.x + x, first.y + y);
        }
    }
    return sum;
}

} // namespace oracle
