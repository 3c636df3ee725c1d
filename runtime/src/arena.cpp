// SPDX-License-Identifier: Apache-2.0
#include "arena.hpp"

#include <algorithm>
#include <cstring>

namespace reprise {

struct FrameArena::State {
    Device device;
    std::vector<Unique<VkDescriptorPool>> pools; // one a slot
    Unique<VkDeviceMemory> memory;
    Unique<VkBuffer> buffer; // all slots, one after the other
    std::byte* mapped = nullptr;
    VkDeviceSize slotBytes = 0, used = 0;
    uint32_t slot = 0;
};

namespace {

// Descriptors of each type that one pass may use, on average over the passes of a slot.
constexpr uint32_t imagesPerPass = 8, storageImagesPerPass = 4, storageBuffersPerPass = 4;

VkDeviceSize alignUp(VkDeviceSize bytes, VkDeviceSize alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
}

Result<Unique<VkDescriptorPool>> makePool(const Device& device, uint32_t passes) {
    const VkDescriptorPoolSize sizes[] = {
        {VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE, passes * imagesPerPass},
        {VK_DESCRIPTOR_TYPE_SAMPLER, passes * imagesPerPass},
        {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, passes * storageImagesPerPass},
        {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, passes * storageBuffersPerPass},
        {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, passes},
    };
    auto info = structure<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
    info.maxSets = passes;
    info.poolSizeCount = static_cast<uint32_t>(std::size(sizes));
    info.pPoolSizes = sizes;
    return make(device, device.vk->CreateDescriptorPool, device.vk->DestroyDescriptorPool, info,
                "create a descriptor pool");
}

Result<void> makeBuffer(ArenaAccess::State& state, VkDeviceSize bytes) {
    const Device& device = state.device;
    const DeviceFunctions& vk = *device.vk;
    auto info = structure<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    auto buffer = make(device, vk.CreateBuffer, vk.DestroyBuffer, info, "create the parameter buffer");
    if (!buffer) return buffer.error();
    VkMemoryRequirements requirements{};
    vk.GetBufferMemoryRequirements(device.borrowed.device, buffer->get(), &requirements);
    // In the device's own memory where the host can write it: every pass begins by reading its parameters,
    // and from the host's memory that takes an H200 about a microsecond longer.
    constexpr VkMemoryPropertyFlags written =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    const char* const what = "allocate the parameter buffer";
    auto memory = allocate(device, requirements, written | VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, what);
    if (!memory) memory = allocate(device, requirements, written, what);
    if (!memory) return memory.error();
    VkResult result = vk.BindBufferMemory(device.borrowed.device, buffer->get(), memory->get(), 0);
    void* mapped = nullptr;
    if (result == VK_SUCCESS)
        result = vk.MapMemory(device.borrowed.device, memory->get(), 0, VK_WHOLE_SIZE, 0, &mapped);
    if (result != VK_SUCCESS) return vulkanError(result, "map the parameter buffer");
    state.buffer = std::move(*buffer);
    state.memory = std::move(*memory);
    state.mapped = static_cast<std::byte*>(mapped);
    return {};
}

} // namespace

FrameArena::FrameArena(std::unique_ptr<State> state) : state_(std::move(state)) {}
FrameArena::FrameArena(FrameArena&&) noexcept = default;
FrameArena& FrameArena::operator=(FrameArena&&) noexcept = default;
FrameArena::~FrameArena() = default;

Result<FrameArena> FrameArena::create(const Device& device, uint32_t slots, uint32_t passes,
                                      uint32_t parameterBytes) {
    return guarded([&]() -> Result<FrameArena> {
        if (slots == 0 || passes == 0)
            return Error{ErrorCode::invalidArgument, "A FrameArena needs at least one slot and one pass."};
        auto state = std::make_unique<State>();
        state->device = device;
        // Each pass may lose up to one alignment; an empty buffer is not allowed.
        const VkDeviceSize alignment =
            std::max<VkDeviceSize>(device.limits.minUniformBufferOffsetAlignment, 16);
        state->slotBytes = alignUp(parameterBytes + VkDeviceSize(passes) * alignment, alignment);
        if (auto made = makeBuffer(*state, state->slotBytes * slots); !made) return made.error();
        for (uint32_t slot = 0; slot < slots; ++slot) {
            auto pool = makePool(device, passes);
            if (!pool) return pool.error();
            state->pools.push_back(std::move(*pool));
        }
        return FrameArena(std::move(state));
    });
}

Result<void> FrameArena::begin(uint32_t slot) {
    if (slot >= state_->pools.size())
        return Error{ErrorCode::invalidArgument,
                     "The arena has no such slot; pass the frame index mod slots."};
    const Device& device = state_->device;
    const VkResult result =
        device.vk->ResetDescriptorPool(device.borrowed.device, state_->pools[slot].get(), 0);
    if (result != VK_SUCCESS) return vulkanError(result, "reset a descriptor pool");
    state_->slot = slot;
    state_->used = 0;
    return {};
}

Result<ParameterSlice> ArenaAccess::parameters(FrameArena& arena, std::span<const std::byte> bytes) {
    State& state = *arena.state_;
    const VkDeviceSize alignment =
        std::max<VkDeviceSize>(state.device.limits.minUniformBufferOffsetAlignment, 16);
    const VkDeviceSize start = alignUp(state.used, alignment);
    if (start + bytes.size() > state.slotBytes)
        return Error{
            ErrorCode::outOfMemory,
            "The arena's parameter memory is used up; create it with more passes or parameterBytes."};
    state.used = start + bytes.size();
    const VkDeviceSize offset = state.slot * state.slotBytes + start;
    std::memcpy(state.mapped + offset, bytes.data(), bytes.size());
    return ParameterSlice{state.buffer.get(), offset, bytes.size()};
}

Result<VkDescriptorSet> ArenaAccess::set(FrameArena& arena, VkDescriptorSetLayout layout) {
    State& state = *arena.state_;
    auto info = structure<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
    info.descriptorPool = state.pools[state.slot].get();
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    const Device& device = state.device;
    const VkResult result = device.vk->AllocateDescriptorSets(device.borrowed.device, &info, &set);
    if (result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL)
        return Error{ErrorCode::outOfMemory,
                     "The arena's descriptors are used up; create it with more passes."};
    if (result != VK_SUCCESS) return vulkanError(result, "allocate a descriptor set");
    return set;
}

} // namespace reprise
