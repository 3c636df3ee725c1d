// SPDX-License-Identifier: Apache-2.0
#include "scene_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace scenes {
namespace {

float toLinear(uint8_t value) {
    static const auto table = [] {
        std::array<float, 256> values{};
        for (size_t i = 0; i < 256; ++i) {
            const float c = float(i) / 255.0f;
            values[i] = c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
        }
        return values;
    }();
    return table[value];
}

uint8_t toSrgb(float linear) {
    const float c = linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return uint8_t(std::lround(std::clamp(c, 0.0f, 1.0f) * 255.0f));
}

double coverage(const Texture& texture, float scale, float cutoff) {
    size_t passing = 0;
    for (size_t i = 3; i < texture.texels.size(); i += 4)
        passing += float(texture.texels[i]) / 255.0f * scale >= cutoff;
    return double(passing) / double(texture.texels.size() / 4);
}

// The factor on alpha at which as many texels pass as did in the finest mip.
void keepCoverage(Texture& texture, double wanted, float cutoff) {
    float low = 0.25f, high = 8.0f;
    for (int step = 0; step < 12; ++step) {
        const float middle = 0.5f * (low + high);
        (coverage(texture, middle, cutoff) < wanted ? low : high) = middle;
    }
    for (size_t i = 3; i < texture.texels.size(); i += 4)
        texture.texels[i] = uint8_t(std::min(255.0f, float(texture.texels[i]) * high));
}

} // namespace

Texture halfSize(const Texture& fine) {
    Texture coarse{std::max(1u, fine.width / 2), std::max(1u, fine.height / 2), {}};
    coarse.texels.resize(size_t(coarse.width) * coarse.height * 4);
    for (uint32_t y = 0; y < coarse.height; ++y) {
        for (uint32_t x = 0; x < coarse.width; ++x) {
            for (size_t channel = 0; channel < 4; ++channel) {
                float sum = 0.0f;
                for (uint32_t tap = 0; tap < 4; ++tap) {
                    const uint32_t fromX = std::min(x * 2 + (tap & 1), fine.width - 1);
                    const uint32_t fromY = std::min(y * 2 + (tap >> 1), fine.height - 1);
                    const uint8_t value = fine.texels[(size_t(fromY) * fine.width + fromX) * 4 + channel];
                    sum += channel == 3 ? float(value) / 255.0f : toLinear(value);
                }
                const float mean = sum * 0.25f;
                coarse.texels[(size_t(y) * coarse.width + x) * 4 + channel] =
                    channel == 3 ? uint8_t(std::lround(mean * 255.0f)) : toSrgb(mean);
            }
        }
    }
    return coarse;
}

std::vector<Texture> mipChain(const Texture& texture, float alphaCutoff) {
    std::vector<Texture> chain{texture}, result{texture};
    while (chain.back().width > 1 || chain.back().height > 1)
        chain.push_back(halfSize(chain.back()));
    const double wanted = alphaCutoff > 0.0f ? coverage(texture, 1.0f, alphaCutoff) : 0.0;
    for (size_t level = 1; level < chain.size(); ++level) {
        result.push_back(chain[level]);
        if (alphaCutoff > 0.0f) keepCoverage(result.back(), wanted, alphaCutoff);
    }
    return result;
}

} // namespace scenes
