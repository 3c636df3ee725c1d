// SPDX-License-Identifier: Apache-2.0
#include "shader_interface.hpp"

#include <algorithm>
#include <deque>

namespace reprise {
namespace {

VkDescriptorType descriptorType(BindingKind kind) {
    switch (kind) {
    case BindingKind::sampledImage:
        return VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
    case BindingKind::pointSampler:
    case BindingKind::linearSampler:
        return VK_DESCRIPTOR_TYPE_SAMPLER;
    case BindingKind::storageImage:
        return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingKind::uniformBuffer:
        return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::storageBuffer:
        return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    }
    return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

bool isSampler(BindingKind kind) {
    return kind == BindingKind::pointSampler || kind == BindingKind::linearSampler;
}

VkShaderStageFlagBits stageBit(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return VK_SHADER_STAGE_VERTEX_BIT;
    case Stage::fragment:
        return VK_SHADER_STAGE_FRAGMENT_BIT;
    case Stage::compute:
        break;
    }
    return VK_SHADER_STAGE_COMPUTE_BIT;
}

Result<std::vector<BindingInfo>> joinBindings(const PassInfo& pass, std::span<const SpirvModule> modules) {
    std::vector<uint32_t> numbers;
    for (const SpirvModule& module : modules)
        numbers.insert(numbers.end(), module.bindings.begin(), module.bindings.end());
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    std::vector<BindingInfo> bindings;
    for (const uint32_t number : numbers) {
        const auto found = std::find_if(pass.bindings.begin(), pass.bindings.end(),
                                        [&](const BindingInfo& info) { return info.binding == number; });
        if (found == pass.bindings.end())
            return Error{ErrorCode::badShader, "The shader of " + std::string(pass.name) + " uses binding " +
                                                   std::to_string(number) +
                                                   ", which the table of passes does not list."};
        bindings.push_back(*found);
    }
    return bindings;
}

// One filter for minification and magnification and a single mip: drivers take their shortest path for it.
Result<Unique<VkSampler>> makeSampler(const Device& device, BindingKind kind) {
    const VkFilter filter = kind == BindingKind::linearSampler ? VK_FILTER_LINEAR : VK_FILTER_NEAREST;
    auto info = structure<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
    info.magFilter = info.minFilter = filter;
    info.mipmapMode = VK_SAMPLER_MIPMAP_MODE_NEAREST;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    return make(device, device.vk->CreateSampler, device.vk->DestroySampler, info, "create a sampler");
}

Result<void> makeSetLayout(const Device& device, VkShaderStageFlags stages, ShaderInterface& interface) {
    std::vector<VkDescriptorSetLayoutBinding> layoutBindings;
    std::deque<VkSampler> immutable; // keeps its addresses while it grows
    for (const BindingInfo& binding : interface.bindings) {
        layoutBindings.push_back({binding.binding, descriptorType(binding.kind), 1, stages, nullptr});
        if (!isSampler(binding.kind)) continue;
        auto sampler = makeSampler(device, binding.kind);
        if (!sampler) return sampler.error();
        immutable.push_back(sampler->get());
        interface.samplers.push_back(std::move(*sampler));
        layoutBindings.back().pImmutableSamplers = &immutable.back();
    }
    auto info =
        structure<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
    info.bindingCount = static_cast<uint32_t>(layoutBindings.size());
    info.pBindings = layoutBindings.data();
    auto layout = make(device, device.vk->CreateDescriptorSetLayout, device.vk->DestroyDescriptorSetLayout,
                       info, "create a descriptor set layout");
    if (!layout) return layout.error();
    interface.setLayout = std::move(*layout);
    return {};
}

Result<void> makePipelineLayout(const Device& device, ShaderInterface& interface) {
    const VkDescriptorSetLayout setLayout = interface.setLayout.get();
    auto info = structure<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
    info.setLayoutCount = 1;
    info.pSetLayouts = &setLayout;
    auto layout = make(device, device.vk->CreatePipelineLayout, device.vk->DestroyPipelineLayout, info,
                       "create a pipeline layout");
    if (!layout) return layout.error();
    interface.layout = std::move(*layout);
    return {};
}

// The descriptor of one binding; only the member of its kind is set.
struct Descriptor {
    VkDescriptorImageInfo image{};
    VkDescriptorBufferInfo buffer{};
};

Result<Descriptor> imageDescriptor(const PassInfo& pass, const BindingInfo& binding,
                                   const Resources& resources) {
    const ImageRef* image = findImage(resources.images, binding.name);
    if (image == nullptr || image->view == VK_NULL_HANDLE) return missingInput(pass.name, binding.name);
    const bool storage = binding.kind == BindingKind::storageImage;
    Descriptor descriptor;
    descriptor.image.imageView = image->view;
    descriptor.image.imageLayout =
        storage ? VK_IMAGE_LAYOUT_GENERAL : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    return descriptor;
}

Result<Descriptor> bufferDescriptor(const PassInfo& pass, const BindingInfo& binding,
                                    const Resources& resources) {
    const auto found = std::find_if(resources.buffers.begin(), resources.buffers.end(),
                                    [&](const NamedBuffer& buffer) { return buffer.name == binding.name; });
    if (found == resources.buffers.end() || found->buffer == VK_NULL_HANDLE)
        return missingInput(pass.name, binding.name);
    Descriptor descriptor;
    descriptor.buffer = {found->buffer, found->offset, found->bytes};
    return descriptor;
}

Result<Descriptor> parameterDescriptor(const PassInfo& pass, FrameArena& arena, const Resources& resources) {
    if (resources.parameters.size() != pass.parameterBytes)
        return Error{ErrorCode::invalidArgument, "The parameters of " + std::string(pass.name) + " are " +
                                                     std::to_string(pass.parameterBytes) + " bytes, but " +
                                                     std::to_string(resources.parameters.size()) +
                                                     " were given."};
    auto slice = ArenaAccess::parameters(arena, resources.parameters);
    if (!slice) return slice.error();
    Descriptor descriptor;
    descriptor.buffer = {slice->buffer, slice->offset, slice->bytes};
    return descriptor;
}

Result<Descriptor> describe(const PassInfo& pass, const BindingInfo& binding, const Resources& resources) {
    switch (binding.kind) {
    case BindingKind::sampledImage:
    case BindingKind::storageImage:
        return imageDescriptor(pass, binding, resources);
    case BindingKind::storageBuffer:
        return bufferDescriptor(pass, binding, resources);
    case BindingKind::uniformBuffer: // filled last
    case BindingKind::pointSampler:
    case BindingKind::linearSampler:
        break;
    }
    return Descriptor{};
}

// Parameters come last, so that a call that lacks an image takes nothing from the arena.
Result<std::vector<Descriptor>> describeAll(const PassInfo& pass, const ShaderInterface& interface,
                                            FrameArena& arena, const Resources& resources) {
    std::vector<Descriptor> descriptors;
    for (const BindingInfo& binding : interface.bindings) {
        auto descriptor = describe(pass, binding, resources);
        if (!descriptor) return descriptor.error();
        descriptors.push_back(*descriptor);
    }
    for (size_t i = 0; i < descriptors.size(); ++i) {
        if (interface.bindings[i].kind != BindingKind::uniformBuffer) continue;
        auto parameters = parameterDescriptor(pass, arena, resources);
        if (!parameters) return parameters.error();
        descriptors[i] = *parameters;
    }
    return descriptors;
}

} // namespace

const ImageRef* findImage(std::span<const NamedImage> images, std::string_view name) {
    const auto found = std::find_if(images.begin(), images.end(),
                                    [&](const NamedImage& image) { return image.name == name; });
    return found == images.end() ? nullptr : &found->image;
}

Error missingInput(std::string_view pass, std::string_view resource) {
    return {ErrorCode::missingInput,
            "The pass " + std::string(pass) + " needs " + std::string(resource) + ", which was not given."};
}

Result<ShaderInterface> makeInterface(const Device& device, const PassInfo& pass,
                                      std::span<const SpirvModule> modules, VkShaderStageFlags stages) {
    ShaderInterface interface;
    auto bindings = joinBindings(pass, modules);
    if (!bindings) return bindings.error();
    interface.bindings = std::move(*bindings);
    if (auto made = makeSetLayout(device, stages, interface); !made) return made.error();
    if (auto made = makePipelineLayout(device, interface); !made) return made.error();
    return interface;
}

Result<VkDescriptorSet> writeSet(const Device& device, const PassInfo& pass, const ShaderInterface& interface,
                                 FrameArena& arena, const Resources& resources) {
    auto descriptors = describeAll(pass, interface, arena, resources);
    if (!descriptors) return descriptors.error();
    auto set = ArenaAccess::set(arena, interface.setLayout.get());
    if (!set) return set.error();
    std::vector<VkWriteDescriptorSet> writes;
    for (size_t i = 0; i < descriptors->size(); ++i) {
        const BindingInfo& binding = interface.bindings[i];
        if (isSampler(binding.kind)) continue; // immutable
        auto write = structure<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
        write.dstSet = *set;
        write.dstBinding = binding.binding;
        write.descriptorCount = 1;
        write.descriptorType = descriptorType(binding.kind);
        write.pImageInfo = &(*descriptors)[i].image;
        write.pBufferInfo = &(*descriptors)[i].buffer;
        writes.push_back(write);
    }
    device.vk->UpdateDescriptorSets(device.borrowed.device, static_cast<uint32_t>(writes.size()),
                                    writes.data(), 0, nullptr);
    return *set;
}

Result<StageModule> makeStage(const Device& device, const SpirvModule& module) {
    auto info = structure<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = module.words.size_bytes();
    info.pCode = module.words.data();
    auto made = make(device, device.vk->CreateShaderModule, device.vk->DestroyShaderModule, info,
                     "create the shader module " + module.entry);
    if (!made) return made.error();
    StageModule stage;
    stage.info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    stage.info.stage = stageBit(module.stage);
    stage.info.module = made->get();
    stage.info.pName = module.entry.c_str();
    stage.module = std::move(*made);
    return stage;
}

} // namespace reprise
