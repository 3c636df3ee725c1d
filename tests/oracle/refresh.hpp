// SPDX-License-Identifier: Apache-2.0
// Refresh of a cache in groups, in integers.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace oracle {

// Of the pixels of group i, those are computed anew in frame t for which (t + i) mod n = 0.
inline bool isRefreshed(int64_t group, int64_t frame, int64_t n) {
    return (frame + group) % n == 0;
}

// n bands of rows; the first is due in the frame after one that is a multiple of n.
inline int64_t groupOfBand(int64_t row, int64_t height, int64_t n) {
    return n - 1 - row * n / height;
}

// The place in its tile, row by row.
inline int64_t groupOfTile(glm::ivec2 pixel, glm::ivec2 tile) {
    return pixel.x % tile.x + tile.x * (pixel.y % tile.y);
}

} // namespace oracle
