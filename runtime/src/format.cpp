// SPDX-License-Identifier: Apache-2.0
#include "reprise/format.hpp"

namespace reprise {
namespace {

struct Format {
    std::string_view name;
    VkFormat format;
    uint32_t texelBytes;
};

constexpr Format formats[] = {
    {"r8", VK_FORMAT_R8_UNORM, 1},
    {"rg8", VK_FORMAT_R8G8_UNORM, 2},
    {"rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4},
    {"r16f", VK_FORMAT_R16_SFLOAT, 2},
    {"rg16f", VK_FORMAT_R16G16_SFLOAT, 4},
    {"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 8},
    {"r11g11b10f", VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4},
    {"r32f", VK_FORMAT_R32_SFLOAT, 4},
    {"rg32f", VK_FORMAT_R32G32_SFLOAT, 8},
    {"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT, 16},
    {"r32ui", VK_FORMAT_R32_UINT, 4},
    {"rg32ui", VK_FORMAT_R32G32_UINT, 8},
};

} // namespace

std::optional<VkFormat> formatByName(std::string_view name) {
    for (const Format& format : formats)
        if (format.name == name) return format.format;
    return std::nullopt;
}

std::string_view formatName(VkFormat wanted) {
    for (const Format& format : formats)
        if (format.format == wanted) return format.name;
    return "VkFormat";
}

uint32_t texelBytes(std::string_view name) {
    for (const Format& format : formats)
        if (format.name == name) return format.texelBytes;
    return 0;
}

} // namespace reprise
