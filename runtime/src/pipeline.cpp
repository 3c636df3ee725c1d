// SPDX-License-Identifier: Apache-2.0
#include "pipeline.hpp"

#include "reprise/format.hpp"

namespace reprise {
namespace {

VkPipelineVertexInputStateCreateInfo vertexInput(const GraphicsDescription& description) {
    auto info = structure<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    info.vertexBindingDescriptionCount = static_cast<uint32_t>(description.vertexBindings.size());
    info.pVertexBindingDescriptions = description.vertexBindings.data();
    info.vertexAttributeDescriptionCount = static_cast<uint32_t>(description.vertexAttributes.size());
    info.pVertexAttributeDescriptions = description.vertexAttributes.data();
    return info;
}

VkPipelineRasterizationStateCreateInfo rasterization(const GraphicsDescription& description) {
    auto info = structure<VkPipelineRasterizationStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    info.polygonMode = VK_POLYGON_MODE_FILL;
    info.cullMode = VK_CULL_MODE_NONE;
    info.lineWidth = 1.0f;
    info.depthBiasEnable = description.depthBias != 0.0f;
    info.depthBiasConstantFactor = description.depthBias;
    info.depthBiasSlopeFactor = description.depthBiasSlope;
    return info;
}

VkPipelineDepthStencilStateCreateInfo depthTest(const GraphicsDescription& description) {
    auto info = structure<VkPipelineDepthStencilStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    info.depthTestEnable = description.depthFormat != VK_FORMAT_UNDEFINED;
    info.depthCompareOp = description.depthCompare;
    return info;
}

VkPipelineColorBlendAttachmentState writeAll() {
    VkPipelineColorBlendAttachmentState state{};
    state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT |
                           VK_COLOR_COMPONENT_A_BIT;
    return state;
}

Result<Unique<VkPipeline>> finish(const Device& device, VkResult result, VkPipeline pipeline,
                                  std::string_view pass) {
    if (result != VK_SUCCESS) return vulkanError(result, "create the pipeline of " + std::string(pass));
    return Unique<VkPipeline>(device.borrowed.device, pipeline, device.vk->DestroyPipeline);
}

} // namespace

Result<Unique<VkPipeline>> makeGraphicsPipeline(const Device& device, const GraphicsDescription& description,
                                                std::string_view pass) {
    const auto vertices = vertexInput(description);
    const auto raster = rasterization(description);
    const auto depth = depthTest(description);
    auto assembly = structure<VkPipelineInputAssemblyStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    auto viewport =
        structure<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    viewport.viewportCount = viewport.scissorCount = 1;
    auto samples = structure<VkPipelineMultisampleStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> targets(description.colourFormats.size(),
                                                                   writeAll());
    auto blend = structure<VkPipelineColorBlendStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    blend.attachmentCount = static_cast<uint32_t>(targets.size());
    blend.pAttachments = targets.data();
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    auto dynamic =
        structure<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
    dynamic.dynamicStateCount = static_cast<uint32_t>(std::size(states));
    dynamic.pDynamicStates = states;
    auto rendering =
        structure<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = static_cast<uint32_t>(description.colourFormats.size());
    rendering.pColorAttachmentFormats = description.colourFormats.data();
    rendering.depthAttachmentFormat = description.depthFormat;

    auto info = structure<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &rendering;
    info.stageCount = static_cast<uint32_t>(description.stages.size());
    info.pStages = description.stages.data();
    info.pVertexInputState = &vertices;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = description.layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = device.vk->CreateGraphicsPipelines(device.borrowed.device, VK_NULL_HANDLE, 1,
                                                               &info, nullptr, &pipeline);
    return finish(device, result, pipeline, pass);
}

Result<Unique<VkPipeline>> makeComputePipeline(const Device& device,
                                               const VkPipelineShaderStageCreateInfo& stage,
                                               VkPipelineLayout layout, std::string_view pass) {
    auto info = structure<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
    info.stage = stage;
    // SUBGROUP_ROW_WIDTH of hlsl/reprise/quad_sharing.hlsli; a module without it ignores the entry.
    constexpr VkSpecializationMapEntry row{0, 0, sizeof(uint32_t)};
    const VkSpecializationInfo specialization{1, &row, sizeof(uint32_t), &device.subgroupRow};
    info.stage.pSpecializationInfo = &specialization;
    info.layout = layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    const VkResult result = device.vk->CreateComputePipelines(device.borrowed.device, VK_NULL_HANDLE, 1,
                                                              &info, nullptr, &pipeline);
    return finish(device, result, pipeline, pass);
}

Result<void> checkFormat(const Device& device, VkFormat format, VkFormatFeatureFlags needed,
                         std::string_view image) {
    VkFormatProperties properties{};
    device.vk->GetPhysicalDeviceFormatProperties(device.borrowed.physicalDevice, format, &properties);
    if ((properties.optimalTilingFeatures & needed) == needed) return {};
    return Error{ErrorCode::unsupportedFormat, "The device cannot use the format " +
                                                   std::string(formatName(format)) + " (VkFormat " +
                                                   std::to_string(static_cast<int>(format)) + ") for " +
                                                   std::string(image) + "; choose another format."};
}

Result<void> checkFeature(bool enabled, std::string_view feature, std::string_view pass) {
    if (enabled) return {};
    return Error{ErrorCode::missingFeature, "The pass " + std::string(pass) + " needs the feature " +
                                                std::string(feature) +
                                                "; enable it when the device is created and set it in "
                                                "EnabledFeatures."};
}

void setViewport(const Device& device, VkCommandBuffer commands, VkExtent2D extent) {
    const auto width = static_cast<float>(extent.width), height = static_cast<float>(extent.height);
    const VkViewport viewport{0.0f, height, width, -height, 0.0f, 1.0f};
    const VkRect2D scissor{{0, 0}, extent};
    device.vk->CmdSetViewport(commands, 0, 1, &viewport);
    device.vk->CmdSetScissor(commands, 0, 1, &scissor);
}

} // namespace reprise
