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
    // Of doubling size, for a submission may record any number of passes.
    std::vector<reprise::FrameArena> arenas;
    uint32_t arenasBegun = 0; // in the submission that is being recorded
    uint32_t recordsLeft = 0; // in the last of these
};

} // namespace harness
