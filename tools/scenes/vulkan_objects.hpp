// SPDX-License-Identifier: Apache-2.0
// What the renderer needs of Vulkan beside the harness: objects that are destroyed together, and checked
// calls.
#pragma once

#include "harness.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace scenes {

template <class T> T structure(VkStructureType type) {
    T value{};
    value.sType = type;
    return value;
}

inline void check(VkResult result, const char* what) {
    if (result == VK_SUCCESS) return;
    throw std::runtime_error(std::string("The scene renderer could not ") + what + ": Vulkan error " +
                             std::to_string(int(result)) + "; try a smaller size or another device.");
}

// Destroys what it was given, newest first.
class Cleanup {
public:
    Cleanup() = default;
    Cleanup(const Cleanup&) = delete;
    Cleanup& operator=(const Cleanup&) = delete;
    ~Cleanup() {
        for (auto action = actions_.rbegin(); action != actions_.rend(); ++action)
            (*action)();
    }
    void add(std::function<void()> action) { actions_.push_back(std::move(action)); }

private:
    std::vector<std::function<void()>> actions_;
};

// States of depth images beside the runtime's four.
inline constexpr VkPipelineStageFlags2 depthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
inline constexpr reprise::ImageState depthWriteState{depthStages,
                                                     VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                                         VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                                                     VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
inline constexpr reprise::ImageState depthReadState{depthStages | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
                                                    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                                        VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                                    VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};

} // namespace scenes
