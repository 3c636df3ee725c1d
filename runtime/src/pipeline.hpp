// SPDX-License-Identifier: Apache-2.0
// Pipelines for dynamic rendering, and the checks that come before them.
#pragma once

#include "shader_interface.hpp"

namespace reprise {

struct GraphicsDescription {
    std::span<const VkPipelineShaderStageCreateInfo> stages;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    std::span<const VkFormat> colourFormats;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED; // undefined: no depth test
    VkCompareOp depthCompare = VK_COMPARE_OP_ALWAYS;
    float depthBias = 0.0f, depthBiasSlope = 0.0f;
    std::span<const VkVertexInputBindingDescription> vertexBindings;
    std::span<const VkVertexInputAttributeDescription> vertexAttributes;
};
Result<Unique<VkPipeline>> makeGraphicsPipeline(const Device& device, const GraphicsDescription& description,
                                                std::string_view pass);
Result<Unique<VkPipeline>> makeComputePipeline(const Device& device,
                                               const VkPipelineShaderStageCreateInfo& stage,
                                               VkPipelineLayout layout, std::string_view pass);

// unsupportedFormat, naming the image and the format, when optimal tiling lacks one of `needed`.
Result<void> checkFormat(const Device& device, VkFormat format, VkFormatFeatureFlags needed,
                         std::string_view image);
Result<void> checkFeature(bool enabled, std::string_view feature, std::string_view pass);

// Viewport of negative height: NDC y points up, as in Direct3D.
void setViewport(const Device& device, VkCommandBuffer commands, VkExtent2D extent);

} // namespace reprise
