// SPDX-License-Identifier: Apache-2.0
#include "scene_data.hpp"

#include "descriptors.hpp"

#include <algorithm>
#include <cstring>

namespace scenes {
namespace {

template <class T>
harness::Buffer upload(harness::Gpu& gpu, const std::vector<T>& data, VkBufferUsageFlags usage) {
    harness::Buffer buffer = gpu.buffer(std::max<VkDeviceSize>(16, data.size() * sizeof(T)), usage);
    if (!data.empty()) std::memcpy(buffer.mapped, data.data(), data.size() * sizeof(T));
    return buffer;
}

struct Attributes {
    glm::vec3 normal;
    glm::vec2 uv;
};

void boundingSphere(const Mesh& mesh, MeshRange& range) {
    glm::dvec3 low(1e300), high(-1e300);
    for (const Vertex& vertex : mesh.vertices) {
        low = glm::min(low, glm::dvec3(vertex.position));
        high = glm::max(high, glm::dvec3(vertex.position));
    }
    range.centre = (low + high) * 0.5;
    range.radius = glm::length(high - low) * 0.5;
}

void makeMeshes(harness::Gpu& gpu, const Scene& scene, SceneData& data) {
    std::vector<glm::vec3> positions;
    std::vector<Attributes> attributes;
    std::vector<glm::u8vec4> joints;
    std::vector<glm::vec4> weights;
    std::vector<uint32_t> indices;
    for (const Mesh& mesh : scene.meshes) {
        MeshRange range{.positions = positions.size() * sizeof(glm::vec3),
                        .attributes = attributes.size() * sizeof(Attributes),
                        .joints = joints.size() * sizeof(glm::u8vec4),
                        .weights = weights.size() * sizeof(glm::vec4),
                        .indices = indices.size() * sizeof(uint32_t),
                        .indexCount = uint32_t(mesh.indices.size()),
                        .skinned = !mesh.joints.empty()};
        boundingSphere(mesh, range);
        for (const Vertex& vertex : mesh.vertices) {
            positions.push_back(vertex.position);
            attributes.push_back({vertex.normal, vertex.uv});
        }
        for (const glm::u8vec4& joint : mesh.joints)
            for (int i = 0; i < 4; ++i)
                range.jointCount = std::max(range.jointCount, uint32_t(joint[i]) + 1);
        joints.insert(joints.end(), mesh.joints.begin(), mesh.joints.end());
        weights.insert(weights.end(), mesh.weights.begin(), mesh.weights.end());
        indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
        data.meshes.push_back(range);
    }
    data.positions = upload(gpu, positions, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    data.attributes = upload(gpu, attributes, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    data.joints = upload(gpu, joints, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    data.weights = upload(gpu, weights, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    data.indices = upload(gpu, indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

uint32_t memoryType(const reprise::Device& device, uint32_t allowed) {
    for (uint32_t i = 0; i < device.memory.memoryTypeCount; ++i)
        if (allowed >> i & 1 &&
            device.memory.memoryTypes[i].propertyFlags & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT)
            return i;
    throw std::runtime_error("The device has no local memory for textures; choose another with --device.");
}

VkImage makeImage(harness::Gpu& gpu, const Texture& base, uint32_t mips, Cleanup& cleanup) {
    const VkDevice device = gpu.handle();
    auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.flags = VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT; // also seen without sRGB decoding
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = VK_FORMAT_R8G8B8A8_SRGB;
    info.extent = {base.width, base.height, 1};
    info.mipLevels = mips;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkImage image;
    check(vkCreateImage(device, &info, nullptr, &image), "create a texture");
    cleanup.add([=] { vkDestroyImage(device, image, nullptr); });
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device, image, &needs);
    auto allocation = structure<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
    allocation.allocationSize = needs.size;
    allocation.memoryTypeIndex = memoryType(gpu.device(), needs.memoryTypeBits);
    VkDeviceMemory memory;
    check(vkAllocateMemory(device, &allocation, nullptr, &memory), "allocate a texture");
    cleanup.add([=] { vkFreeMemory(device, memory, nullptr); });
    check(vkBindImageMemory(device, image, memory, 0), "bind a texture");
    return image;
}

void barrier(VkCommandBuffer commands, VkImage image, uint32_t mips, const reprise::ImageState& from,
             const reprise::ImageState& to) {
    auto change = structure<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    change.srcStageMask = from.stage;
    change.srcAccessMask = from.access;
    change.oldLayout = from.layout;
    change.dstStageMask = to.stage;
    change.dstAccessMask = to.access;
    change.newLayout = to.layout;
    change.srcQueueFamilyIndex = change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    change.image = image;
    change.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, mips, 0, 1};
    auto dependency = structure<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &change;
    vkCmdPipelineBarrier2(commands, &dependency);
}

void copyMips(harness::Gpu& gpu, VkImage image, const std::vector<Texture>& mips) {
    std::vector<VkBufferImageCopy> copies;
    VkDeviceSize bytes = 0;
    for (uint32_t level = 0; level < mips.size(); ++level) {
        VkBufferImageCopy copy{};
        copy.bufferOffset = bytes;
        copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
        copy.imageExtent = {mips[level].width, mips[level].height, 1};
        copies.push_back(copy);
        bytes += mips[level].texels.size();
    }
    const harness::Buffer staging = gpu.buffer(bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    for (size_t level = 0; level < mips.size(); ++level)
        std::memcpy(staging.mapped + copies[level].bufferOffset, mips[level].texels.data(),
                    mips[level].texels.size());
    const reprise::ImageState writing{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
    gpu.run([&](VkCommandBuffer commands) {
        barrier(commands, image, uint32_t(mips.size()), reprise::undefinedState, writing);
        vkCmdCopyBufferToImage(commands, staging.buffer, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                               uint32_t(copies.size()), copies.data());
        barrier(commands, image, uint32_t(mips.size()), writing, reprise::sampledState);
    });
}

VkImageView makeView(VkDevice device, VkImage image, VkFormat format, size_t mips, Cleanup& cleanup) {
    auto info = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = format;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, uint32_t(mips), 0, 1};
    VkImageView view;
    check(vkCreateImageView(device, &info, nullptr, &view), "view a texture");
    cleanup.add([=] { vkDestroyImageView(device, view, nullptr); });
    return view;
}

struct TextureViews {
    VkImageView albedo, alpha;
};

TextureViews makeTexture(harness::Gpu& gpu, const Texture& texture, float alphaCutoff, Cleanup& cleanup) {
    const std::vector<Texture> mips = mipChain(texture, alphaCutoff);
    const VkImage image = makeImage(gpu, texture, uint32_t(mips.size()), cleanup);
    copyMips(gpu, image, mips);
    return {makeView(gpu.handle(), image, VK_FORMAT_R8G8B8A8_SRGB, mips.size(), cleanup),
            makeView(gpu.handle(), image, VK_FORMAT_R8G8B8A8_UNORM, mips.size(), cleanup)};
}

VkSampler makeSampler(VkDevice device, VkSamplerMipmapMode mips, Cleanup& cleanup) {
    auto info = structure<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.mipmapMode = mips;
    info.maxLod = VK_LOD_CLAMP_NONE;
    VkSampler sampler;
    check(vkCreateSampler(device, &info, nullptr, &sampler), "create a sampler");
    cleanup.add([=] { vkDestroySampler(device, sampler, nullptr); });
    return sampler;
}

VkDescriptorSetLayout makeLayout(VkDevice device, Cleanup& cleanup) {
    const VkSampler albedo = makeSampler(device, VK_SAMPLER_MIPMAP_MODE_LINEAR, cleanup);
    const VkSampler alpha = makeSampler(device, VK_SAMPLER_MIPMAP_MODE_NEAREST, cleanup);
    const VkShaderStageFlags fragment = VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorSetLayoutBinding bindings[] = {
        {6, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 1, fragment, nullptr},
        {7, VK_DESCRIPTOR_TYPE_SAMPLER, 1, fragment, &albedo},
        {8, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, 1, fragment, nullptr},
        {9, VK_DESCRIPTOR_TYPE_SAMPLER, 1, fragment, &alpha}};
    auto info =
        structure<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = 4;
    info.pBindings = bindings;
    VkDescriptorSetLayout layout;
    check(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout), "create a descriptor layout");
    cleanup.add([=] { vkDestroyDescriptorSetLayout(device, layout, nullptr); });
    return layout;
}

void makeTextureSets(VkDevice device, const std::vector<TextureViews>& views, SceneData& data,
                     Cleanup& cleanup) {
    const auto count = uint32_t(views.size());
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, count * 2},
                                          {VK_DESCRIPTOR_TYPE_SAMPLER, count * 2}};
    auto info = structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = count;
    info.poolSizeCount = 2;
    info.pPoolSizes = sizes;
    VkDescriptorPool pool;
    check(vkCreateDescriptorPool(device, &info, nullptr, &pool), "create a descriptor pool");
    cleanup.add([=] { vkDestroyDescriptorPool(device, pool, nullptr); });
    const std::vector<VkDescriptorSetLayout> layouts(count, data.textureLayout);
    auto allocation = structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    allocation.descriptorPool = pool;
    allocation.descriptorSetCount = count;
    allocation.pSetLayouts = layouts.data();
    data.textureSets.resize(count);
    check(vkAllocateDescriptorSets(device, &allocation, data.textureSets.data()), "allocate descriptor sets");
    for (uint32_t i = 0; i < count; ++i) {
        writeImage(device, data.textureSets[i], 6, views[i].albedo);
        writeImage(device, data.textureSets[i], 8, views[i].alpha);
    }
}

float cutoffOf(const Scene& scene, int texture) {
    for (const Material& material : scene.materials)
        if (material.texture == texture && material.alphaCutoff > 0.0f) return material.alphaCutoff;
    return 0.0f;
}

} // namespace

SceneData makeSceneData(harness::Gpu& gpu, const Scene& scene, Cleanup& cleanup) {
    SceneData data;
    makeMeshes(gpu, scene, data);
    data.textureLayout = makeLayout(gpu.handle(), cleanup);
    std::vector<TextureViews> views{makeTexture(gpu, {1, 1, {255, 255, 255, 255}}, 0.0f, cleanup)};
    for (size_t i = 0; i < scene.textures.size(); ++i)
        views.push_back(makeTexture(gpu, scene.textures[i], cutoffOf(scene, int(i)), cleanup));
    makeTextureSets(gpu.handle(), views, data, cleanup);
    return data;
}

} // namespace scenes
