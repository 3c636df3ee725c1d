// SPDX-License-Identifier: Apache-2.0
#include "handles.hpp"

#include <algorithm>

namespace reprise {
namespace {

Error missingFunction(std::string_view name) {
    return {ErrorCode::missingFeature, "The Vulkan driver has no " + std::string(name) +
                                           "; create the instance and the device with Vulkan 1.3."};
}

Result<void> loadInstanceFunctions(const BorrowedDevice& from, DeviceFunctions& vk) {
#define REPRISE_LOAD(name)                                                                                   \
    vk.name = reinterpret_cast<PFN_vk##name>(from.getInstanceProcAddr(from.instance, "vk" #name));           \
    if (vk.name == nullptr) return missingFunction("vk" #name);
    REPRISE_INSTANCE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
    return {};
}

Result<void> loadDeviceFunctions(const BorrowedDevice& from, DeviceFunctions& vk) {
#define REPRISE_LOAD(name)                                                                                   \
    vk.name = reinterpret_cast<PFN_vk##name>(vk.GetDeviceProcAddr(from.device, "vk" #name));                 \
    if (vk.name == nullptr) return missingFunction("vk" #name);
    REPRISE_DEVICE_FUNCTIONS(REPRISE_LOAD)
#undef REPRISE_LOAD
    return {};
}

Result<void> checkHandles(const BorrowedDevice& borrowed) {
    const auto null = [](std::string_view name) {
        return Error{ErrorCode::invalidArgument,
                     "BorrowedDevice::" + std::string(name) + " is null; set it."};
    };
    if (borrowed.instance == VK_NULL_HANDLE) return null("instance");
    if (borrowed.physicalDevice == VK_NULL_HANDLE) return null("physicalDevice");
    if (borrowed.device == VK_NULL_HANDLE) return null("device");
    if (borrowed.getInstanceProcAddr == nullptr) return null("getInstanceProcAddr");
    return {};
}

void readSubgroups(Device& device, const DeviceFunctions& vk) {
    constexpr VkSubgroupFeatureFlags needed = VK_SUBGROUP_FEATURE_QUAD_BIT | VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
    constexpr uint32_t leastRow = 8, mostRow = 32;
    auto sizes = structure<VkPhysicalDeviceSubgroupSizeControlProperties>(
        VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_SIZE_CONTROL_PROPERTIES);
    auto subgroup =
        structure<VkPhysicalDeviceSubgroupProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
    subgroup.pNext = &sizes;
    auto properties = structure<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
    properties.pNext = &subgroup;
    vk.GetPhysicalDeviceProperties2(device.borrowed.physicalDevice, &properties);
    device.quadOperations = (subgroup.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) != 0 &&
                            (subgroup.supportedOperations & needed) == needed &&
                            sizes.minSubgroupSize >= leastRow;
    device.subgroupRow = std::clamp(sizes.minSubgroupSize, leastRow, mostRow);
}

Result<Device> load(const BorrowedDevice& borrowed) {
    if (auto checked = checkHandles(borrowed); !checked) return checked.error();
    if (!borrowed.features.synchronization2)
        return Error{
            ErrorCode::missingFeature,
            "The runtime needs the feature synchronization2; enable it when the device is created and "
            "set EnabledFeatures::synchronization2."};
    auto vk = std::make_shared<DeviceFunctions>();
    if (auto loaded = loadInstanceFunctions(borrowed, *vk); !loaded) return loaded.error();
    VkPhysicalDeviceProperties properties{};
    vk->GetPhysicalDeviceProperties(borrowed.physicalDevice, &properties);
    if (properties.apiVersion < VK_API_VERSION_1_3)
        return Error{ErrorCode::missingFeature, "The device " + std::string(properties.deviceName) +
                                                    " offers less than Vulkan 1.3; choose another device."};
    if (auto loaded = loadDeviceFunctions(borrowed, *vk); !loaded) return loaded.error();
    Device device;
    device.borrowed = borrowed;
    device.limits = properties.limits;
    readSubgroups(device, *vk);
    vk->GetPhysicalDeviceMemoryProperties(borrowed.physicalDevice, &device.memory);
    device.vk = std::move(vk);
    return device;
}

ErrorCode codeOf(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
    case VK_ERROR_TOO_MANY_OBJECTS:
        return ErrorCode::outOfMemory;
    case VK_ERROR_DEVICE_LOST:
        return ErrorCode::deviceLost;
    case VK_ERROR_FORMAT_NOT_SUPPORTED:
        return ErrorCode::unsupportedFormat;
    case VK_ERROR_INVALID_SHADER_NV:
        return ErrorCode::badShader;
    default:
        return ErrorCode::invalidArgument;
    }
}

std::string_view reasonOf(ErrorCode code) {
    switch (code) {
    case ErrorCode::outOfMemory:
        return "out of memory; free some or ask for a smaller extent";
    case ErrorCode::deviceLost:
        return "the device is lost; create it anew";
    case ErrorCode::unsupportedFormat:
        return "the device does not support the format";
    case ErrorCode::badShader:
        return "the driver refused the shader";
    default:
        return "the driver refused the call";
    }
}

} // namespace

Result<Device> borrow(const BorrowedDevice& borrowed) {
    return guarded([&] { return load(borrowed); });
}

Error vulkanError(VkResult result, std::string_view what) {
    const ErrorCode code = codeOf(result);
    return {code, "Vulkan could not " + std::string(what) + ": " + std::string(reasonOf(code)) +
                      " (VkResult " + std::to_string(static_cast<int>(result)) + ")."};
}

Result<Unique<VkDeviceMemory>> allocate(const Device& device, const VkMemoryRequirements& requirements,
                                        VkMemoryPropertyFlags wanted, std::string_view what) {
    for (uint32_t type = 0; type < device.memory.memoryTypeCount; ++type) {
        const bool allowed = (requirements.memoryTypeBits >> type & 1u) != 0;
        const bool suits = (device.memory.memoryTypes[type].propertyFlags & wanted) == wanted;
        if (!allowed || !suits) continue;
        auto info = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
        info.allocationSize = requirements.size;
        info.memoryTypeIndex = type;
        return make(device, device.vk->AllocateMemory, device.vk->FreeMemory, info, what);
    }
    return vulkanError(VK_ERROR_OUT_OF_DEVICE_MEMORY, what);
}

} // namespace reprise
