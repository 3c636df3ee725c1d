// SPDX-License-Identifier: Apache-2.0
// Recording a pass in two steps, so that the frame recorder can prepare every pass before it records the
// first.
#pragma once

#include "pipeline.hpp"

namespace reprise {

struct PreparedPass {
    VkDescriptorSet set = VK_NULL_HANDLE;
    VkExtent2D extent{};
    std::vector<VkImageView> attachments; // fragment form
};

struct PassAccess {
    using State = PassPipeline::State;
    static Result<PreparedPass> prepare(const PassPipeline& pass, FrameArena& arena,
                                        const Resources& resources);
    static void emit(const PassPipeline& pass, VkCommandBuffer commands, const PreparedPass& prepared);
};

} // namespace reprise
