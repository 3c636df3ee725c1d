// SPDX-License-Identifier: Apache-2.0
// The engine's Vulkan device, borrowed. Nothing here is created or destroyed by the runtime.
#pragma once

#include "reprise/result.hpp"

#include <cstdint>
#include <memory>

#include <vulkan/vulkan.h>

namespace reprise {

// What the engine enabled when it created its device; Vulkan offers no way to ask.
struct EnabledFeatures {
    bool synchronization2 = false;                     // always needed
    bool dynamicRendering = false;                     // needed by fragment passes
    bool shaderStorageImageWriteWithoutFormat = false; // needed by compute passes
};

struct BorrowedDevice {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamilyIndex = 0;
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    EnabledFeatures features;
};

struct DeviceFunctions; // loaded through getInstanceProcAddr; see src/device_functions.hpp

// Cheap to copy; the engine's device must outlive every copy.
struct Device {
    BorrowedDevice borrowed;
    VkPhysicalDeviceMemoryProperties memory{};
    VkPhysicalDeviceLimits limits{};
    // Quad and shuffle operations in compute, in subgroups of at least 8: QUAD_SHARING uses them there.
    bool quadOperations = false;
    uint32_t subgroupRow = 8; // invocations of a subgroup that such a pass takes as one row: 8, 16 or 32
    std::shared_ptr<const DeviceFunctions> vk;
};

// Fails with missingFeature when synchronization2 is off or Vulkan is older than 1.3, invalidArgument on a
// null handle.
Result<Device> borrow(const BorrowedDevice& borrowed);

// An image the caller owns: one mip, one layer, one sample.
struct ImageRef {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{};
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

} // namespace reprise
