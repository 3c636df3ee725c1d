// SPDX-License-Identifier: Apache-2.0
#include "reprise/ambient_occlusion.hpp"

#include <algorithm>

#include <glm/gtc/constants.hpp>

namespace reprise {

std::array<glm::vec4, 32> occlusionTaps(uint32_t samples, uint64_t frameIndex, uint32_t subsets) {
    const double root = 1.2207440846057596;
    const glm::dvec3 sequence = 1.0 / glm::dvec3(root, root * root, root * root * root);
    const uint32_t count = std::min(samples, 32u);
    const uint64_t subset = frameIndex % std::clamp(subsets, 1u, 16u);
    std::array<glm::vec4, 32> taps{};
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 point = glm::fract(0.5 + double(subset * count + i) * sequence);
        const double azimuth = glm::two_pi<double>() * point.x, radius = std::sqrt(point.y);
        taps[i] = glm::dvec4(radius * std::cos(azimuth), radius * std::sin(azimuth), std::sqrt(1.0 - point.y),
                             point.z);
    }
    return taps;
}

} // namespace reprise
