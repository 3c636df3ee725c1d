// SPDX-License-Identifier: Apache-2.0
// Formats by name, and half precision.
#include "context.hpp"

#include <bit>
#include <cmath>

namespace harness {
namespace {

using Kind = FormatInfo::Kind;

constexpr FormatInfo formats[] = {
    {"r8", VK_FORMAT_R8_UNORM, 1, 1, Kind::unorm8},
    {"rg8", VK_FORMAT_R8G8_UNORM, 2, 2, Kind::unorm8},
    {"rgba8", VK_FORMAT_R8G8B8A8_UNORM, 4, 4, Kind::unorm8},
    {"rgba8srgb", VK_FORMAT_R8G8B8A8_SRGB, 4, 4, Kind::other},
    {"r16f", VK_FORMAT_R16_SFLOAT, 1, 2, Kind::half},
    {"rg16f", VK_FORMAT_R16G16_SFLOAT, 2, 4, Kind::half},
    {"rgba16f", VK_FORMAT_R16G16B16A16_SFLOAT, 4, 8, Kind::half},
    {"r11g11b10f", VK_FORMAT_B10G11R11_UFLOAT_PACK32, 3, 4, Kind::other},
    {"r32f", VK_FORMAT_R32_SFLOAT, 1, 4, Kind::single},
    {"rg32f", VK_FORMAT_R32G32_SFLOAT, 2, 8, Kind::single},
    {"rgba32f", VK_FORMAT_R32G32B32A32_SFLOAT, 4, 16, Kind::single},
    {"d32f", VK_FORMAT_D32_SFLOAT, 1, 4, Kind::single},
    {"r32ui", VK_FORMAT_R32_UINT, 1, 4, Kind::other},
    {"rg32ui", VK_FORMAT_R32G32_UINT, 2, 8, Kind::other},
    {"rgba32ui", VK_FORMAT_R32G32B32A32_UINT, 4, 16, Kind::other},
};

// Right shift that rounds to nearest, ties to even. shift is 1 to 31.
uint32_t shiftRounded(uint32_t value, uint32_t shift) {
    const uint32_t half = (1u << (shift - 1)) - 1u, odd = value >> shift & 1u;
    return (value + half + odd) >> shift;
}

} // namespace

const FormatInfo& formatInfo(VkFormat format) {
    for (const FormatInfo& info : formats)
        if (info.format == format) return info;
    throw std::runtime_error("The harness does not know VkFormat " +
                             std::to_string(static_cast<int>(format)) + "; add it to convert.cpp.");
}

uint32_t channelCount(VkFormat format) {
    return formatInfo(format).channels;
}

VkFormat formatByName(std::string_view name) {
    for (const FormatInfo& info : formats)
        if (info.name == name) return info.format;
    throw std::runtime_error("There is no format named " + std::string(name) + ".");
}

uint16_t floatToHalf(float value) {
    const auto bits = std::bit_cast<uint32_t>(value);
    const uint32_t sign = bits >> 16 & 0x8000u, magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) // NaN: keep the upper payload, stay quiet
        return static_cast<uint16_t>(sign | 0x7e00u | (magnitude >> 13 & 0x3ffu));
    if (magnitude >= 0x47800000u) return static_cast<uint16_t>(sign | 0x7c00u); // 65536 and above
    if (magnitude >= 0x38800000u) // normal in half; rounding up from 65520 carries into infinity
        return static_cast<uint16_t>(sign | shiftRounded(magnitude - 0x38000000u, 13));
    const uint32_t exponent = magnitude >> 23;
    if (exponent < 102) return static_cast<uint16_t>(sign); // below half the smallest subnormal
    const uint32_t mantissa = (magnitude & 0x7fffffu) | 0x800000u;
    return static_cast<uint16_t>(sign | shiftRounded(mantissa, 126 - exponent));
}

float halfToFloat(uint16_t bits) {
    const uint32_t exponent = bits >> 10 & 0x1fu, mantissa = bits & 0x3ffu;
    const uint32_t sign = static_cast<uint32_t>(bits & 0x8000u) << 16;
    if (exponent == 0) {
        const float magnitude = std::ldexp(static_cast<float>(mantissa), -24);
        return sign != 0 ? -magnitude : magnitude;
    }
    const uint32_t wide = exponent == 31 ? 255u : exponent + 112u;
    return std::bit_cast<float>(sign | wide << 23 | mantissa << 13);
}

} // namespace harness
