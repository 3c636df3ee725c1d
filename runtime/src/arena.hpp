// SPDX-License-Identifier: Apache-2.0
// What the recording code takes from a FrameArena.
#pragma once

#include "handles.hpp"
#include "reprise/pass.hpp"

namespace reprise {

struct ParameterSlice {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize bytes = 0;
};

struct ArenaAccess {
    using State = FrameArena::State;
    // Copies the parameters to where a uniform buffer descriptor may start.
    static Result<ParameterSlice> parameters(FrameArena& arena, std::span<const std::byte> bytes);
    static Result<VkDescriptorSet> set(FrameArena& arena, VkDescriptorSetLayout layout);
};

} // namespace reprise
