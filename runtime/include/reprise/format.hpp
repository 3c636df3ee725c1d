// SPDX-License-Identifier: Apache-2.0
// The image formats that the table of passes names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <vulkan/vulkan.h>

namespace reprise {

// r8, rg8, rgba8, r16f, rg16f, rgba16f, r11g11b10f, r32f, rg32f, rgba32f, r32ui, rg32ui.
std::optional<VkFormat> formatByName(std::string_view name);
// The table's name, or "VkFormat" when it has none.
std::string_view formatName(VkFormat format);
// 0 for a name that formatByName() does not know.
uint32_t texelBytes(std::string_view name);

} // namespace reprise
