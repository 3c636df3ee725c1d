// SPDX-License-Identifier: Apache-2.0
// Descriptor sets of the renderer: set 0 belongs to a frame or to the ground truth, set 1 to a texture.
#pragma once

#include "pipelines.hpp"

#include <span>

namespace scenes {

VkDescriptorSetLayoutBinding binding(uint32_t index, VkDescriptorType type,
                                     const VkSampler* sampler = nullptr);
VkDescriptorSetLayout makeSetLayout(VkDevice device, std::span<const VkDescriptorSetLayoutBinding> bindings,
                                    Cleanup& cleanup);
VkPipelineLayout makePipelineLayout(VkDevice device, std::span<const VkDescriptorSetLayout> sets,
                                    Cleanup& cleanup);
VkSampler makeShadowSampler(VkDevice device, Cleanup& cleanup);
// Of the sets of `sets` frames.
VkDescriptorPool makePool(VkDevice device, uint32_t sets, Cleanup& cleanup);
VkDescriptorSet allocateSet(VkDevice device, VkDescriptorPool pool, VkDescriptorSetLayout layout);
void writeImage(VkDevice device, VkDescriptorSet set, uint32_t index, VkImageView view);
void writeBuffer(VkDevice device, VkDescriptorSet set, uint32_t index, VkDescriptorType type,
                 const harness::Buffer& buffer, VkDeviceSize bytes = VK_WHOLE_SIZE);

} // namespace scenes
