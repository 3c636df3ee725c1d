// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "context.hpp"

namespace harness {

struct Gpu::State {
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State();

    std::shared_ptr<Vulkan> vulkan;
    reprise::Device device;
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence fence = VK_NULL_HANDLE;
    uint64_t submissions = 0;
};

} // namespace harness
