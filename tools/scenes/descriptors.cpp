// SPDX-License-Identifier: Apache-2.0
#include "descriptors.hpp"

namespace scenes {

VkDescriptorSetLayoutBinding binding(uint32_t index, VkDescriptorType type, const VkSampler* sampler) {
    return {index, type, 1, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, sampler};
}

VkDescriptorSetLayout makeSetLayout(VkDevice device, std::span<const VkDescriptorSetLayoutBinding> bindings,
                                    Cleanup& cleanup) {
    auto info =
        structure<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = uint32_t(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout;
    check(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout), "create a descriptor layout");
    cleanup.add([=] { vkDestroyDescriptorSetLayout(device, layout, nullptr); });
    return layout;
}

VkPipelineLayout makePipelineLayout(VkDevice device, std::span<const VkDescriptorSetLayout> sets,
                                    Cleanup& cleanup) {
    const VkPushConstantRange constants{VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                                        sizeof(RenderConstants)};
    auto info = structure<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = uint32_t(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &constants;
    VkPipelineLayout layout;
    check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "create a pipeline layout");
    cleanup.add([=] { vkDestroyPipelineLayout(device, layout, nullptr); });
    return layout;
}

VkSampler makeShadowSampler(VkDevice device, Cleanup& cleanup) {
    auto info = structure<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    info.compareEnable = VK_TRUE;
    info.compareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkSampler sampler;
    check(vkCreateSampler(device, &info, nullptr, &sampler), "create the shadow sampler");
    cleanup.add([=] { vkDestroySampler(device, sampler, nullptr); });
    return sampler;
}

VkDescriptorPool makePool(VkDevice device, uint32_t sets, Cleanup& cleanup) {
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets},
                                          {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC, sets},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, sets * 2},
                                          {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, sets},
                                          {VK_DESCRIPTOR_TYPE_SAMPLER, sets}};
    auto info = structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = sets;
    info.poolSizeCount = 5;
    info.pPoolSizes = sizes;
    VkDescriptorPool pool;
    check(vkCreateDescriptorPool(device, &info, nullptr, &pool), "create a descriptor pool");
    cleanup.add([=] { vkDestroyDescriptorPool(device, pool, nullptr); });
    return pool;
}

VkDescriptorSet allocateSet(VkDevice device, VkDescriptorPool pool, VkDescriptorSetLayout layout) {
    auto info = structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    VkDescriptorSet set;
    check(vkAllocateDescriptorSets(device, &info, &set), "allocate a descriptor set");
    return set;
}

void writeImage(VkDevice device, VkDescriptorSet set, uint32_t index, VkImageView view) {
    const VkDescriptorImageInfo image{VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    auto change = structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    change.dstSet = set;
    change.dstBinding = index;
    change.descriptorCount = 1;
    change.descriptorType = VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    change.pImageInfo = &image;
    vkUpdateDescriptorSets(device, 1, &change, 0, nullptr);
}

void writeBuffer(VkDevice device, VkDescriptorSet set, uint32_t index, VkDescriptorType type,
                 const harness::Buffer& buffer, VkDeviceSize bytes) {
    const VkDescriptorBufferInfo range{buffer.buffer, 0, bytes};
    auto change = structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
    change.dstSet = set;
    change.dstBinding = index;
    change.descriptorCount = 1;
    change.descriptorType = type;
    change.pBufferInfo = &range;
    vkUpdateDescriptorSets(device, 1, &change, 0, nullptr);
}

} // namespace scenes
