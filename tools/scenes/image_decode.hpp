// SPDX-License-Identifier: Apache-2.0
// PNG, JPEG and the other formats of stb_image to a texture.
#pragma once

#include "scenes.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace scenes {

// Throws Refusal. Pictures larger than 4096 a side are halved until they fit.
Texture decodeImage(std::span<const std::byte> file);

} // namespace scenes
