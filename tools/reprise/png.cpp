// SPDX-License-Identifier: Apache-2.0
#include "sequence.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace report {
namespace {

uint8_t srgbByte(float linear) {
    if (!std::isfinite(linear)) return 255;
    const float v = std::clamp(linear, 0.0f, 1.0f);
    const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1.0f / 2.4f) - 0.055f;
    return static_cast<uint8_t>(encoded * 255.0f + 0.5f);
}

void append(void* context, void* data, int size) {
    auto& bytes = *static_cast<std::vector<uint8_t>*>(context);
    const auto* first = static_cast<const uint8_t*>(data);
    bytes.insert(bytes.end(), first, first + size);
}

} // namespace

std::vector<uint8_t> pngOf(const Picture& picture) {
    std::vector<uint8_t> texels(picture.rgb.size()), png;
    std::transform(picture.rgb.begin(), picture.rgb.end(), texels.begin(), srgbByte);
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    if (!stbi_write_png_to_func(append, &png, width, height, 3, texels.data(), 3 * width))
        throw std::runtime_error("A picture could not be encoded as PNG; is there memory left?");
    return png;
}

} // namespace report
