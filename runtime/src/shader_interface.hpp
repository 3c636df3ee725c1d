// SPDX-License-Identifier: Apache-2.0
// Descriptor set 0 of a pipeline: what its modules declare, joined with what the table says those bindings
// hold.
#pragma once

#include "arena.hpp"
#include "spirv_module.hpp"

namespace reprise {

struct ShaderInterface {
    std::vector<BindingInfo> bindings; // ascending
    std::vector<Unique<VkSampler>> samplers;
    Unique<VkDescriptorSetLayout> setLayout;
    Unique<VkPipelineLayout> layout;
};

struct Resources {
    std::span<const NamedImage> images;
    std::span<const NamedBuffer> buffers;
    std::span<const std::byte> parameters;
};

Result<ShaderInterface> makeInterface(const Device& device, const PassInfo& pass,
                                      std::span<const SpirvModule> modules, VkShaderStageFlags stages);

// Checks that every binding has its resource, then takes a set from the arena and writes it.
Result<VkDescriptorSet> writeSet(const Device& device, const PassInfo& pass, const ShaderInterface& interface,
                                 FrameArena& arena, const Resources& resources);

// Null when there is none of that name.
const ImageRef* findImage(std::span<const NamedImage> images, std::string_view name);
Error missingInput(std::string_view pass, std::string_view resource);

struct StageModule {
    Unique<VkShaderModule> module;
    VkPipelineShaderStageCreateInfo info{}; // its entry name points into the SpirvModule
};
Result<StageModule> makeStage(const Device& device, const SpirvModule& module);

} // namespace reprise
