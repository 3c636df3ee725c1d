// SPDX-License-Identifier: Apache-2.0
// Images of random and broken texels, and places in them.
#pragma once

#include "hlsl_functions.hpp"
#include "inputs.hpp"

namespace functions {

// As binary32 stores them, so that the oracle reads what the GPU reads.
inline Image randomImage(int width, int height, uint32_t seed, float low = 0.0f, float high = 1.0f) {
    Random random(seed);
    Image image(width, height);
    for (dvec4& texel : image.texels)
        texel = dvec4(random.in4(low, high));
    return image;
}

inline Image brokenImage(int width, int height, uint32_t seed) {
    Random random(seed);
    Image image = randomImage(width, height, seed);
    for (dvec4& texel : image.texels)
        if (random.below(5) == 0)
            texel = dvec4(vec4(random.of(hostileAny), random.of(hostileAny), random.of(hostileAny), 1.0f));
    return image;
}

inline const glm::ivec2 imageSizes[] = {{1, 1}, {2, 2}, {7, 5}, {16, 9}};

// in0 is (uv, size); a little outside of the image on every side.
inline std::vector<Row> randomPlaces(glm::ivec2 size, uint32_t seed, int count = 1000) {
    Random random(seed);
    std::vector<Row> rows;
    for (int i = 0; i < count; ++i)
        rows.push_back({vec4(random.in(-0.2f, 1.2f), random.in(-0.2f, 1.2f), glm::vec2(size)), vec4(0.0f)});
    return rows;
}

// A GPU may place a sample between texels in steps of 1/256 (lavapipe's and most devices'
// subTexelPrecisionBits is 8): on each axis the result is off by as much of the difference between two
// texels.
inline constexpr double filterStep = 1.0 / 256.0;

} // namespace functions
