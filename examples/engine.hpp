// SPDX-License-Identifier: Apache-2.0
// What an engine has anyway: a device, images, a way to fill and to read them. Errors end the program.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <vulkan/vulkan.h>

#include "reprise/device.hpp"

inline void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    std::fprintf(stderr, "could not %s (VkResult %d)\n", what, static_cast<int>(result));
    std::exit(1);
}

template <class T> T vk(VkStructureType type) {
    T info{};
    info.sType = type;
    return info;
}

struct Engine {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physicalDevice = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    uint32_t queueFamily = 0;
    VkQueue queue = VK_NULL_HANDLE;
    VkCommandPool pool = VK_NULL_HANDLE;
};

// The first family that computes.
inline uint32_t queueFamilyOf(VkPhysicalDevice device) {
    VkQueueFamilyProperties families[16];
    uint32_t count = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families);
    for (uint32_t i = 0; i < count; ++i)
        if (families[i].queueFlags & VK_QUEUE_COMPUTE_BIT) return i;
    return 0;
}

inline void openDevice(Engine& engine) {
    auto features13 =
        vk<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
    features13.synchronization2 = VK_TRUE;
    auto features = vk<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
    features.pNext = &features13;
    features.features.shaderStorageImageWriteWithoutFormat = VK_TRUE;
    const float priority = 1.0f;
    auto queue = vk<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
    queue.queueFamilyIndex = engine.queueFamily;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    auto info = vk<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
    info.pNext = &features;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue;
    check(vkCreateDevice(engine.physicalDevice, &info, nullptr, &engine.device), "create a device");
}

inline Engine startEngine() {
    Engine engine;
    auto application = vk<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
    application.apiVersion = VK_API_VERSION_1_3;
    auto info = vk<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
    info.pApplicationInfo = &application;
    check(vkCreateInstance(&info, nullptr, &engine.instance), "find a Vulkan driver");
    uint32_t one = 1;
    const VkResult found = vkEnumeratePhysicalDevices(engine.instance, &one, &engine.physicalDevice);
    check(one == 1 && found == VK_INCOMPLETE ? VK_SUCCESS : found, "find a Vulkan device");
    if (one == 0) check(VK_ERROR_INITIALIZATION_FAILED, "find a Vulkan device");
    engine.queueFamily = queueFamilyOf(engine.physicalDevice);
    openDevice(engine);
    vkGetDeviceQueue(engine.device, engine.queueFamily, 0, &engine.queue);
    auto pool = vk<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
    pool.queueFamilyIndex = engine.queueFamily;
    check(vkCreateCommandPool(engine.device, &pool, nullptr, &engine.pool), "create a command pool");
    return engine;
}

inline VkDeviceMemory allocate(const Engine& engine, const VkMemoryRequirements& needs,
                               VkMemoryPropertyFlags flags) {
    VkPhysicalDeviceMemoryProperties memory;
    vkGetPhysicalDeviceMemoryProperties(engine.physicalDevice, &memory);
    auto info = vk<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    info.allocationSize = needs.size;
    for (uint32_t i = memory.memoryTypeCount; i-- > 0;)
        if ((needs.memoryTypeBits >> i & 1) && (memory.memoryTypes[i].propertyFlags & flags) == flags)
            info.memoryTypeIndex = i;
    VkDeviceMemory made = VK_NULL_HANDLE;
    check(vkAllocateMemory(engine.device, &info, nullptr, &made), "allocate memory");
    return made;
}

// Memory that both sides see: texels on their way in or out.
struct Staging {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    void* texels = nullptr;
};

inline Staging makeStaging(const Engine& engine, VkDeviceSize bytes) {
    Staging staging;
    auto info = vk<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    check(vkCreateBuffer(engine.device, &info, nullptr, &staging.buffer), "create a buffer");
    VkMemoryRequirements needs;
    vkGetBufferMemoryRequirements(engine.device, staging.buffer, &needs);
    staging.memory =
        allocate(engine, needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    check(vkBindBufferMemory(engine.device, staging.buffer, staging.memory, 0), "bind a buffer");
    check(vkMapMemory(engine.device, staging.memory, 0, bytes, 0, &staging.texels), "map a buffer");
    return staging;
}

struct Texture {
    reprise::ImageRef ref;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

inline Texture makeTexture(const Engine& engine, VkFormat format, uint32_t width, uint32_t height) {
    Texture texture;
    auto info = vk<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    check(vkCreateImage(engine.device, &info, nullptr, &texture.ref.image), "create an image");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(engine.device, texture.ref.image, &needs);
    texture.memory = allocate(engine, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    check(vkBindImageMemory(engine.device, texture.ref.image, texture.memory, 0), "bind an image");
    auto view = vk<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    view.image = texture.ref.image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    check(vkCreateImageView(engine.device, &view, nullptr, &texture.ref.view), "create an image view");
    texture.ref.format = format;
    texture.ref.extent = {width, height};
    return texture;
}

inline void moveTo(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to) {
    auto barrier = vk<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    auto dependency = vk<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

inline VkBufferImageCopy wholeImage(VkExtent2D extent) {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    return region;
}

// Leaves the image as passes take it.
inline void upload(VkCommandBuffer commands, const Staging& from, const Texture& to) {
    moveTo(commands, to.ref.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    const VkBufferImageCopy region = wholeImage(to.ref.extent);
    vkCmdCopyBufferToImage(commands, from.buffer, to.ref.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    moveTo(commands, to.ref.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

// The image comes and goes in SHADER_READ_ONLY_OPTIMAL, as the runtime hands it over.
inline void download(VkCommandBuffer commands, const reprise::ImageRef& from, const Staging& to) {
    moveTo(commands, from.image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
           VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    const VkBufferImageCopy region = wholeImage(from.extent);
    vkCmdCopyImageToBuffer(commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to.buffer, 1, &region);
    moveTo(commands, from.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

inline VkCommandBuffer beginCommands(const Engine& engine) {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    auto info = vk<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
    info.commandPool = engine.pool;
    info.commandBufferCount = 1;
    check(vkAllocateCommandBuffers(engine.device, &info, &commands), "allocate a command buffer");
    auto begin = vk<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
    check(vkBeginCommandBuffer(commands, &begin), "begin a command buffer");
    return commands;
}

// Waits for the GPU, so that one slot of everything is enough.
inline void submit(const Engine& engine, VkCommandBuffer commands) {
    check(vkEndCommandBuffer(commands), "end a command buffer");
    auto info = vk<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands;
    check(vkQueueSubmit(engine.queue, 1, &info, VK_NULL_HANDLE), "submit");
    check(vkQueueWaitIdle(engine.queue), "wait for the queue");
    vkFreeCommandBuffers(engine.device, engine.pool, 1, &commands);
}

inline void destroy(const Engine& engine, const Texture& texture) {
    vkDestroyImageView(engine.device, texture.ref.view, nullptr);
    vkDestroyImage(engine.device, texture.ref.image, nullptr);
    vkFreeMemory(engine.device, texture.memory, nullptr);
}

inline void destroy(const Engine& engine, const Staging& staging) {
    vkDestroyBuffer(engine.device, staging.buffer, nullptr);
    vkFreeMemory(engine.device, staging.memory, nullptr);
}

inline void stopEngine(const Engine& engine) {
    vkDestroyCommandPool(engine.device, engine.pool, nullptr);
    vkDestroyDevice(engine.device, nullptr);
    vkDestroyInstance(engine.instance, nullptr);
}
