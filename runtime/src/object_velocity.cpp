// SPDX-License-Identifier: Apache-2.0
#include "object_velocity.hpp"

#include "frame_parameters.hpp"
#include "plan_images.hpp"

namespace reprise {
namespace {

// What the engine drew may be rounded otherwise than here: by some units of depth in the product of matrices,
// and by a sixteenth of a pixel, the coarsest snapping that Vulkan allows. Without a bias the object would
// fight with itself.
constexpr float depthBiasUnits = 8.0f, depthBiasPixels = 1.0f / 16.0f;

constexpr VkVertexInputBindingDescription vertexBindings[] = {
    {0, 3 * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX},
    {1, 4 * sizeof(uint8_t), VK_VERTEX_INPUT_RATE_VERTEX},
    {2, 4 * sizeof(float), VK_VERTEX_INPUT_RATE_VERTEX},
};
constexpr VkVertexInputAttributeDescription vertexAttributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {1, 1, VK_FORMAT_R8G8B8A8_UINT, 0},
    {2, 2, VK_FORMAT_R32G32B32A32_SFLOAT, 0},
};

Result<void> build(const Device& device, std::span<const SpirvModule> modules, const ObjectFormats& formats,
                   ObjectPipeline& made) {
    const std::string_view name = made.variant.pass->name;
    auto interface = makeInterface(device, *made.variant.pass, modules,
                                   VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT);
    if (!interface) return interface.error();
    auto vertex = makeStage(device, modules[0]);
    if (!vertex) return vertex.error();
    auto fragment = makeStage(device, modules[1]);
    if (!fragment) return fragment.error();
    const VkPipelineShaderStageCreateInfo stages[] = {vertex->info, fragment->info};
    const float towardsCamera = formats.reversedDepth ? 1.0f : -1.0f;
    const size_t streams = made.skinned ? 3 : 1;
    GraphicsDescription description;
    description.stages = stages;
    description.layout = interface->layout.get();
    description.colourFormats = {&formats.velocity, 1};
    description.depthFormat = formats.depth;
    description.depthCompare =
        formats.reversedDepth ? VK_COMPARE_OP_GREATER_OR_EQUAL : VK_COMPARE_OP_LESS_OR_EQUAL;
    description.depthBias = towardsCamera * depthBiasUnits;
    description.depthBiasSlope = towardsCamera * depthBiasPixels;
    description.vertexBindings = std::span(vertexBindings).first(streams);
    description.vertexAttributes = std::span(vertexAttributes).first(streams);
    auto pipeline = makeGraphicsPipeline(device, description, name);
    if (!pipeline) return pipeline.error();
    made.interface = std::move(*interface);
    made.pipeline = std::move(*pipeline);
    return {};
}

Result<void> checkFormats(const Device& device, const ObjectFormats& formats, std::string_view pass) {
    auto checked = checkFeature(device.borrowed.features.dynamicRendering, "dynamicRendering", pass);
    if (checked)
        checked =
            checkFormat(device, formats.velocity, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, velocityImage);
    if (checked)
        checked = checkFormat(device, formats.depth, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT,
                              "FrameInput::depthAttachment");
    return checked;
}

Result<void> checkDraw(const ObjectDraw& object) {
    const auto missing = [](std::string_view buffer) { return missingInput("object_velocity", buffer); };
    if (object.positions == VK_NULL_HANDLE) return missing("ObjectDraw::positions");
    if (object.indices == VK_NULL_HANDLE) return missing("ObjectDraw::indices");
    if (object.palette == VK_NULL_HANDLE) return {};
    if (object.prevPalette == VK_NULL_HANDLE) return missing("ObjectDraw::prevPalette");
    if (object.joints == VK_NULL_HANDLE) return missing("ObjectDraw::joints");
    if (object.weights == VK_NULL_HANDLE) return missing("ObjectDraw::weights");
    return {};
}

void bindStreams(const DeviceFunctions& vk, VkCommandBuffer commands, const ObjectDraw& object,
                 bool skinned) {
    const VkBuffer buffers[] = {object.positions, object.joints, object.weights};
    const VkDeviceSize offsets[] = {object.positionsOffset, object.jointsOffset, object.weightsOffset};
    vk.CmdBindVertexBuffers(commands, 0, skinned ? 3 : 1, buffers, offsets);
    vk.CmdBindIndexBuffer(commands, object.indices, object.indicesOffset, object.indexType);
}

void beginRendering(const Device& device, VkCommandBuffer commands, const ImageRef& velocity,
                    const ImageRef& depth) {
    auto colour = structure<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    colour.imageView = velocity.view;
    colour.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    auto test = structure<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    test.imageView = depth.view;
    test.imageLayout = VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL;
    test.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    test.storeOp = VK_ATTACHMENT_STORE_OP_NONE; // storing would count as a write
    auto rendering = structure<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    rendering.renderArea.extent = velocity.extent;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &colour;
    rendering.pDepthAttachment = &test;
    device.vk->CmdBeginRendering(commands, &rendering);
    setViewport(device, commands, velocity.extent);
}

} // namespace

Result<ObjectPipeline> makeObjectPipeline(const Device& device, const Variant& variant,
                                          const SpirvSource& spirv, const ObjectFormats& formats) {
    if (auto checked = checkFormats(device, formats, variant.pass->name); !checked) return checked.error();
    std::vector<uint32_t> words[2];
    SpirvModule modules[2];
    constexpr Stage stages[] = {Stage::vertex, Stage::fragment};
    for (size_t i = 0; i < 2; ++i) {
        auto loaded = spirv(variant, stages[i]);
        if (!loaded) return loaded.error();
        words[i] = std::move(*loaded);
        auto module = readModule(words[i]);
        if (!module) return module.error();
        modules[i] = std::move(*module);
    }
    ObjectPipeline made;
    made.variant = variant;
    made.skinned = switchValue(variant, "SKINNING") == "on";
    if (auto built = build(device, modules, formats, made); !built) return built.error();
    return made;
}

Result<std::vector<PreparedDraw>> prepareDraws(const Device& device, const ObjectPipeline& pipeline,
                                               FrameArena& arena, const FrameInput& input,
                                               const CameraFrame& previous, VkExtent2D extent) {
    std::vector<PreparedDraw> draws;
    for (const ObjectDraw& object : input.movingObjects) {
        if ((object.palette != VK_NULL_HANDLE) != pipeline.skinned) continue;
        if (auto checked = checkDraw(object); !checked) return checked.error();
        const auto parameters = objectParameters(object, input, previous, extent);
        const NamedBuffer palettes[] = {{"gInJoints", object.palette}, {"gInPrevJoints", object.prevPalette}};
        auto set = writeSet(device, *pipeline.variant.pass, pipeline.interface, arena,
                            {{}, palettes, std::as_bytes(std::span(&parameters, 1))});
        if (!set) return set.error();
        draws.push_back({*set, &object});
    }
    return draws;
}

void emitDraws(const Device& device, const ObjectPipeline& pipeline, VkCommandBuffer commands,
               std::span<const PreparedDraw> draws, const ImageRef& velocity, const ImageRef& depth) {
    if (draws.empty()) return;
    const DeviceFunctions& vk = *device.vk;
    beginRendering(device, commands, velocity, depth);
    vk.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.pipeline.get());
    for (const PreparedDraw& draw : draws) {
        vk.CmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline.interface.layout.get(),
                                 0, 1, &draw.set, 0, nullptr);
        bindStreams(vk, commands, *draw.object, pipeline.skinned);
        vk.CmdDrawIndexed(commands, draw.object->indexCount, 1, 0, 0, 0);
    }
    vk.CmdEndRendering(commands);
}

} // namespace reprise
