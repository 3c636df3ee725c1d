// SPDX-License-Identifier: Apache-2.0
// Draws the motion of moving objects over the camera's.
#pragma once

#include "pipeline.hpp"
#include "reprise/frame.hpp"

namespace reprise {

struct ObjectPipeline {
    Variant variant;
    bool skinned = false;
    ShaderInterface interface;
    Unique<VkPipeline> pipeline;
};

struct ObjectFormats {
    VkFormat velocity = VK_FORMAT_UNDEFINED, depth = VK_FORMAT_UNDEFINED;
    bool reversedDepth = false;
};
Result<ObjectPipeline> makeObjectPipeline(const Device& device, const Variant& variant,
                                          const SpirvSource& spirv, const ObjectFormats& formats);

struct PreparedDraw {
    VkDescriptorSet set = VK_NULL_HANDLE;
    const ObjectDraw* object = nullptr;
};
// The draws that this pipeline is for, those with a palette or those without.
Result<std::vector<PreparedDraw>> prepareDraws(const Device& device, const ObjectPipeline& pipeline,
                                               FrameArena& arena, const FrameInput& input,
                                               const CameraFrame& previous, VkExtent2D extent);
// `velocity` in COLOR_ATTACHMENT_OPTIMAL, `depth` in DEPTH_READ_ONLY_OPTIMAL.
void emitDraws(const Device& device, const ObjectPipeline& pipeline, VkCommandBuffer commands,
               std::span<const PreparedDraw> draws, const ImageRef& velocity, const ImageRef& depth);

} // namespace reprise
