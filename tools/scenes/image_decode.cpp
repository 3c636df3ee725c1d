// SPDX-License-Identifier: Apache-2.0
#include "image_decode.hpp"

#include "model_check.hpp"
#include "scene_data.hpp"

#include <climits>
#include <memory>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace scenes {

Texture decodeImage(std::span<const std::byte> file) {
    constexpr uint32_t maxSide = 4096;
    constexpr int64_t maxTexels = int64_t(1) << 26;
    const auto* data = reinterpret_cast<const stbi_uc*>(file.data());
    int width = 0, height = 0, channels = 0;
    if (file.empty() || file.size() > INT_MAX ||
        stbi_info_from_memory(data, int(file.size()), &width, &height, &channels) == 0)
        throw Refusal{"it is not a picture that can be read; use PNG or JPEG"};
    if (width <= 0 || height <= 0 || int64_t(width) * height > maxTexels)
        throw Refusal{"it has more than 64 million texels; scale it down"};
    const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
        stbi_load_from_memory(data, int(file.size()), &width, &height, &channels, 4), stbi_image_free);
    if (!texels) throw Refusal{"its picture data is damaged; save it again"};
    Texture texture{uint32_t(width), uint32_t(height), {}};
    texture.texels.assign(texels.get(), texels.get() + size_t(width) * size_t(height) * 4);
    while (std::max(texture.width, texture.height) > maxSide)
        texture = halfSize(texture);
    return texture;
}

} // namespace scenes
