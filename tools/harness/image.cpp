// SPDX-License-Identifier: Apache-2.0
// Images and buffers, each with memory of its own.
#include "gpu_state.hpp"

namespace harness {
namespace {

struct ImageMemory {
    explicit ImageMemory(std::shared_ptr<Vulkan> owner) : vulkan(std::move(owner)) {}
    ImageMemory(const ImageMemory&) = delete;
    ImageMemory& operator=(const ImageMemory&) = delete;
    ~ImageMemory() {
        vkDestroyImageView(vulkan->device, view, nullptr);
        vkDestroyImage(vulkan->device, image, nullptr);
        vkFreeMemory(vulkan->device, memory, nullptr);
    }

    std::shared_ptr<Vulkan> vulkan;
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

struct BufferMemory {
    explicit BufferMemory(std::shared_ptr<Vulkan> owner) : vulkan(std::move(owner)) {}
    BufferMemory(const BufferMemory&) = delete;
    BufferMemory& operator=(const BufferMemory&) = delete;
    ~BufferMemory() {
        vkDestroyBuffer(vulkan->device, buffer, nullptr);
        vkFreeMemory(vulkan->device, memory, nullptr);
    }

    std::shared_ptr<Vulkan> vulkan;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
};

VkImageUsageFlags everyUsage(const Vulkan& vulkan, VkFormat format, uint32_t samples) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(vulkan.physicalDevice, format, &properties);
    const VkFormatFeatureFlags has = properties.optimalTilingFeatures;
    VkImageUsageFlags usage = 0;
    if (has & VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT) usage |= VK_IMAGE_USAGE_SAMPLED_BIT;
    if (has & VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT && samples == 1) usage |= VK_IMAGE_USAGE_STORAGE_BIT;
    if (has & VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT) usage |= VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    if (has & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT)
        usage |= VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
    if (has & VK_FORMAT_FEATURE_TRANSFER_SRC_BIT) usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
    if (has & VK_FORMAT_FEATURE_TRANSFER_DST_BIT) usage |= VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    return usage;
}

bool isDepth(VkFormat format) {
    return format == VK_FORMAT_D32_SFLOAT;
}

VkImageCreateInfo describe(VkFormat format, uint32_t width, uint32_t height, uint32_t samples,
                           VkImageUsageFlags usage) {
    auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {width, height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = static_cast<VkSampleCountFlagBits>(samples);
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    return info;
}

void checkSupport(const Vulkan& vulkan, const VkImageCreateInfo& info) {
    const std::string size = std::to_string(info.extent.width) + "x" + std::to_string(info.extent.height);
    if (info.extent.width == 0 || info.extent.height == 0)
        throw std::runtime_error("An image of " + size + " has no texels; give it a width and a height.");
    VkImageFormatProperties limits{};
    const VkResult result = vkGetPhysicalDeviceImageFormatProperties(
        vulkan.physicalDevice, info.format, info.imageType, info.tiling, info.usage, 0, &limits);
    const std::string what = "The device " + std::string(vulkan.properties.deviceName) +
                             " has no image of format " + std::string(formatInfo(info.format).name);
    if (result != VK_SUCCESS || info.usage == 0) throw std::runtime_error(what + " for this use.");
    if ((limits.sampleCounts & static_cast<uint32_t>(info.samples)) == 0)
        throw std::runtime_error(what + " with " + std::to_string(info.samples) + " samples.");
    if (info.extent.width > limits.maxExtent.width || info.extent.height > limits.maxExtent.height)
        throw std::runtime_error(what + " as large as " + size + ".");
}

void makeView(ImageMemory& memory, const VkImageCreateInfo& image, VkImageAspectFlags aspect) {
    auto info = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = memory.image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = image.format;
    info.subresourceRange = {aspect, 0, 1, 0, 1};
    check(vkCreateImageView(memory.vulkan->device, &info, nullptr, &memory.view), "create an image view");
}

} // namespace

VkDeviceMemory allocate(const Vulkan& vulkan, const VkMemoryRequirements& requirements,
                        std::span<const VkMemoryPropertyFlags> preferences, const std::string& what) {
    for (const VkMemoryPropertyFlags wanted : preferences) {
        for (uint32_t type = 0; type < vulkan.memory.memoryTypeCount; ++type) {
            const bool suits = (vulkan.memory.memoryTypes[type].propertyFlags & wanted) == wanted;
            if ((requirements.memoryTypeBits >> type & 1u) == 0 || !suits) continue;
            auto info = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
            info.allocationSize = requirements.size;
            info.memoryTypeIndex = type;
            VkDeviceMemory memory = VK_NULL_HANDLE;
            if (vkAllocateMemory(vulkan.device, &info, nullptr, &memory) == VK_SUCCESS) return memory;
        }
    }
    throw std::runtime_error("The device " + std::string(vulkan.properties.deviceName) +
                             " has no memory left for " + what + "; ask for a smaller size.");
}

Image Gpu::image(VkFormat format, uint32_t width, uint32_t height, uint32_t samples,
                 VkImageUsageFlags usage) {
    const Vulkan& vulkan = *state_->vulkan;
    if (usage == 0) usage = everyUsage(vulkan, format, samples);
    const VkImageCreateInfo info = describe(format, width, height, samples, usage);
    checkSupport(vulkan, info);
    const VkImageAspectFlags aspect = isDepth(format) ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
    auto memory = std::make_shared<ImageMemory>(state_->vulkan);
    check(vkCreateImage(vulkan.device, &info, nullptr, &memory->image), "create an image");
    VkMemoryRequirements requirements{};
    vkGetImageMemoryRequirements(vulkan.device, memory->image, &requirements);
    const VkMemoryPropertyFlags preferences[] = {VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0};
    memory->memory = allocate(vulkan, requirements, preferences, "an image");
    check(vkBindImageMemory(vulkan.device, memory->image, memory->memory, 0), "bind an image");
    makeView(*memory, info, aspect);
    Image image;
    image.ref = {memory->image, memory->view, format, {width, height}, aspect};
    image.samples = samples;
    image.state = reprise::undefinedState;
    image.memory = std::move(memory);
    return image;
}

Buffer Gpu::buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) {
    const Vulkan& vulkan = *state_->vulkan;
    auto memory = std::make_shared<BufferMemory>(state_->vulkan);
    auto info = structure<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes;
    info.usage = usage;
    check(vkCreateBuffer(vulkan.device, &info, nullptr, &memory->buffer), "create a buffer");
    VkMemoryRequirements requirements{};
    vkGetBufferMemoryRequirements(vulkan.device, memory->buffer, &requirements);
    constexpr VkMemoryPropertyFlags host =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    // What the CPU reads should be cached by it; what the GPU reads should lie near the GPU.
    const bool readBack = (usage & VK_BUFFER_USAGE_TRANSFER_DST_BIT) != 0;
    const VkMemoryPropertyFlags preferences[] = {
        host | (readBack ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), host};
    memory->memory = allocate(vulkan, requirements, preferences, "a buffer");
    check(vkBindBufferMemory(vulkan.device, memory->buffer, memory->memory, 0), "bind a buffer");
    void* mapped = nullptr;
    check(vkMapMemory(vulkan.device, memory->memory, 0, VK_WHOLE_SIZE, 0, &mapped), "map a buffer");
    Buffer buffer;
    buffer.buffer = memory->buffer;
    buffer.bytes = bytes;
    buffer.mapped = static_cast<std::byte*>(mapped);
    buffer.memory = std::move(memory);
    return buffer;
}

} // namespace harness
