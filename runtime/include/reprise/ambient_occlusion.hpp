// SPDX-License-Identifier: Apache-2.0
// What ambient_occlusion and lighting_cache sample in a frame.
#pragma once

#include <array>
#include <cstdint>

#include <glm/glm.hpp>

namespace reprise {

// gTaps of a frame: `samples` points (to 32; more are 32) of the half ball of radius 1 over a surface, the
// rest 0. x, y and z: direction, distributed as the cosine to z; w in [0,1): number whose root is the
// distance, before the pixel shifts it. Frames take one of `subsets` (1 to 16, held to it) sets after the
// other, which together are one run of an additive sequence, that of the inverse powers of the root of x^4 =
// x + 1. Drobot, 7.3 (D8).
std::array<glm::vec4, 32> occlusionTaps(uint32_t samples, uint64_t frameIndex, uint32_t subsets);

} // namespace reprise
