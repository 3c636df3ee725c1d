// SPDX-License-Identifier: Apache-2.0
// What the parts of the harness share.
#pragma once

#include "harness.hpp"

#include <mutex>
#include <stdexcept>

namespace harness {

// A Vulkan structure of which all but the type is zero.
template <class T> T structure(VkStructureType type) {
    T info{};
    info.sType = type;
    return info;
}

// Throws "Vulkan could not WHAT (VkResult N)." unless the call succeeded.
void check(VkResult result, const std::string& what);

// Instance and device; images and buffers hold a share, so that they may outlive the Gpu.
struct Vulkan {
    Vulkan() = default;
    Vulkan(const Vulkan&) = delete;
    Vulkan& operator=(const Vulkan&) = delete;
    ~Vulkan();

    VkInstance instance = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    VkQueue queue = VK_NULL_HANDLE;
    uint32_t queueFamily = 0, timestampBits = 0;
    VkPhysicalDeviceProperties properties{};
    VkPhysicalDeviceMemoryProperties memory{};
    std::string driver;
    reprise::EnabledFeatures enabled;
    std::mutex mutex; // of messages: layers may report from any thread
    std::vector<std::string> messages;
};

std::shared_ptr<Vulkan> openVulkan(const DeviceOptions& options);

// The first memory type of `types` that has all of the flags of the earliest possible entry of `preferences`.
VkDeviceMemory allocate(const Vulkan& vulkan, const VkMemoryRequirements& requirements,
                        std::span<const VkMemoryPropertyFlags> preferences, const std::string& what);

struct FormatInfo {
    enum class Kind { unorm8, half, single, other };
    std::string_view name;
    VkFormat format;
    uint32_t channels, texelBytes;
    Kind kind;
};
const FormatInfo& formatInfo(VkFormat format);

} // namespace harness
