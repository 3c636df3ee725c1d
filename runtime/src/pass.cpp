// SPDX-License-Identifier: Apache-2.0
#include "pass_access.hpp"

#include <algorithm>
#include <cmath>

namespace reprise {

struct PassPipeline::State {
    Device device;
    Variant variant;
    Stage stage = Stage::compute;
    ShaderInterface interface;
    Unique<VkPipeline> pipeline;
};

namespace {

std::vector<const ImageInfo*> existing(const Variant& variant, std::span<const ImageInfo> images) {
    std::vector<const ImageInfo*> found;
    for (const ImageInfo& image : images)
        if (exists(variant, image)) found.push_back(&image);
    return found;
}

Result<SpirvModule> readStage(std::span<const uint32_t> spirv, Stage stage, std::string_view pass) {
    auto module = readModule(spirv);
    if (!module || module->stage == stage) return module;
    return Error{ErrorCode::badShader, "The shader given for " + std::string(pass) + " is of another stage."};
}

Result<void> checkOutputs(const Device& device, const Variant& variant, std::span<const VkFormat> formats) {
    const auto outputs = existing(variant, variant.pass->outputs);
    if (outputs.size() != formats.size())
        return Error{ErrorCode::invalidArgument, "The pass " + std::string(variant.pass->name) + " has " +
                                                     std::to_string(outputs.size()) + " outputs, but " +
                                                     std::to_string(formats.size()) + " formats were given."};
    for (size_t i = 0; i < formats.size(); ++i) {
        const auto checked =
            checkFormat(device, formats[i], VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT, outputs[i]->name);
        if (!checked) return checked;
    }
    return {};
}

Result<void> buildFragment(PassAccess::State& state, const SpirvModule& fragment,
                           std::span<const uint32_t> vertexWords, std::span<const VkFormat> formats) {
    const std::string_view name = state.variant.pass->name;
    auto enabled = checkFeature(state.device.borrowed.features.dynamicRendering, "dynamicRendering", name);
    if (!enabled) return enabled;
    if (auto checked = checkOutputs(state.device, state.variant, formats); !checked) return checked;
    auto vertex = readStage(vertexWords, Stage::vertex, "the full-screen triangle");
    if (!vertex) return vertex.error();
    auto vertexStage = makeStage(state.device, *vertex);
    if (!vertexStage) return vertexStage.error();
    auto fragmentStage = makeStage(state.device, fragment);
    if (!fragmentStage) return fragmentStage.error();
    const VkPipelineShaderStageCreateInfo stages[] = {vertexStage->info, fragmentStage->info};
    GraphicsDescription description;
    description.stages = stages;
    description.layout = state.interface.layout.get();
    description.colourFormats = formats;
    auto pipeline = makeGraphicsPipeline(state.device, description, name);
    if (!pipeline) return pipeline.error();
    state.pipeline = std::move(*pipeline);
    return {};
}

Result<void> buildCompute(PassAccess::State& state, const SpirvModule& module) {
    const std::string_view name = state.variant.pass->name;
    auto enabled = checkFeature(state.device.borrowed.features.shaderStorageImageWriteWithoutFormat,
                                "shaderStorageImageWriteWithoutFormat", name);
    if (!enabled) return enabled;
    if (module.usesQuadOperations && !state.device.quadOperations)
        return Error{ErrorCode::missingFeature, "The device has no quad and shuffle operations in compute, "
                                                "or subgroups of fewer than 8, which this form of " +
                                                    std::string(name) + " uses; switch QUAD_SHARING off."};
    auto stage = makeStage(state.device, module);
    if (!stage) return stage.error();
    auto pipeline = makeComputePipeline(state.device, stage->info, state.interface.layout.get(), name);
    if (!pipeline) return pipeline.error();
    state.pipeline = std::move(*pipeline);
    return {};
}

// Extents may round either way: within a texel of the coarser of the two images.
bool fits(uint32_t texels, double scale, uint32_t reference, double referenceScale) {
    const double difference = std::abs(texels / scale - reference / referenceScale);
    return difference * std::min(scale, referenceScale) < 1.0;
}

Error extentsDiffer(std::string_view pass, std::string_view image, VkExtent2D extent, VkExtent2D output) {
    const auto text = [](VkExtent2D e) { return std::to_string(e.width) + "x" + std::to_string(e.height); };
    return {ErrorCode::invalidArgument, "In the pass " + std::string(pass) + " the image " +
                                            std::string(image) + " is " + text(extent) +
                                            ", which does not fit the output of " + text(output) + "."};
}

Result<void> checkExtents(const Variant& variant, std::span<const ImageInfo> infos, const ImageInfo& output,
                          VkExtent2D extent, std::span<const NamedImage> images) {
    const double outputScale = scaleOf(variant, output);
    for (const ImageInfo* info : existing(variant, infos)) {
        const ImageRef* image = findImage(images, info->name);
        if (image == nullptr) continue; // a buffer, or not used by the module
        const double scale = scaleOf(variant, *info);
        if (scale == 0.0) continue; // an extent of its own
        const auto agree = [&](double coarse) {
            const double own = scale < 1.0 ? coarse : scale, first = outputScale < 1.0 ? coarse : outputScale;
            return fits(image->extent.width, own * info->widthScale, extent.width,
                        first * output.widthScale) &&
                   fits(image->extent.height, own, extent.height, first);
        };
        // A pass that need not know its ratio takes any.
        const bool knows = !switchValue(variant, "RATIO").empty();
        if (!agree(std::min(scale, outputScale)) && (knows || (!agree(0.25) && !agree(1.0))))
            return extentsDiffer(variant.pass->name, info->name, image->extent, extent);
    }
    return {};
}

// An image that a pass reads under two filters has two names; the caller gives it once.
std::vector<NamedImage> withAliases(const PassInfo& pass, std::span<const NamedImage> images) {
    std::vector<NamedImage> all(images.begin(), images.end());
    for (const ImageInfo& input : pass.inputs) {
        const ImageRef* original = input.sameAs.empty() ? nullptr : findImage(images, input.sameAs);
        if (original != nullptr && findImage(images, input.name) == nullptr)
            all.push_back({input.name, *original});
    }
    return all;
}

// The extent of the first output, once all images are there and agree with it.
Result<PreparedPass> prepareTargets(const Variant& variant, Stage stage, std::span<const NamedImage> images) {
    const PassInfo& pass = *variant.pass;
    const auto outputs = existing(variant, pass.outputs);
    PreparedPass prepared;
    for (const ImageInfo* output : outputs) {
        const ImageRef* image = findImage(images, output->name);
        if (image == nullptr || image->view == VK_NULL_HANDLE) return missingInput(pass.name, output->name);
        if (image->extent.width == 0 || image->extent.height == 0)
            return Error{ErrorCode::zeroExtent, "The image " + std::string(output->name) +
                                                    " has no texels; give it a width and a height."};
        if (output == outputs.front()) prepared.extent = image->extent;
        if (stage == Stage::fragment) prepared.attachments.push_back(image->view);
    }
    if (outputs.empty())
        return Error{ErrorCode::invalidArgument, "The pass " + std::string(pass.name) + " has no output."};
    for (const auto infos : {pass.inputs, pass.outputs})
        if (auto checked = checkExtents(variant, infos, *outputs.front(), prepared.extent, images); !checked)
            return checked.error();
    return prepared;
}

void draw(const Device& device, VkCommandBuffer commands, const PreparedPass& prepared) {
    std::vector<VkRenderingAttachmentInfo> targets;
    for (const VkImageView view : prepared.attachments) {
        auto target = structure<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
        target.imageView = view;
        target.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        target.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE; // every pixel is written
        target.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        targets.push_back(target);
    }
    auto rendering = structure<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    rendering.renderArea.extent = prepared.extent;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<uint32_t>(targets.size());
    rendering.pColorAttachments = targets.data();
    device.vk->CmdBeginRendering(commands, &rendering);
    setViewport(device, commands, prepared.extent);
    device.vk->CmdDraw(commands, 3, 1, 0, 0);
    device.vk->CmdEndRendering(commands);
}

void dispatch(const Device& device, VkCommandBuffer commands, const Variant& variant, VkExtent2D extent) {
    const PassInfo& pass = *variant.pass;
    const auto threads = threadsOf(variant);
    const uint32_t tileX = threads[0] * pass.pixelsPerThread[0];
    const uint32_t tileY = threads[1] * pass.pixelsPerThread[1];
    const uint32_t width = extent.width + pass.overhang[0], height = extent.height + pass.overhang[1];
    device.vk->CmdDispatch(commands, (width + tileX - 1) / tileX, (height + tileY - 1) / tileY, 1);
}

} // namespace

PassPipeline::PassPipeline(std::unique_ptr<State> state) : state_(std::move(state)) {}
PassPipeline::PassPipeline(PassPipeline&&) noexcept = default;
PassPipeline& PassPipeline::operator=(PassPipeline&&) noexcept = default;
PassPipeline::~PassPipeline() = default;

Stage PassPipeline::stage() const {
    return state_->stage;
}
const Variant& PassPipeline::variant() const {
    return state_->variant;
}
std::span<const BindingInfo> PassPipeline::bindings() const {
    return state_->interface.bindings;
}

Result<PassPipeline> PassPipeline::create(const Device& device, const Variant& variant, Stage stage,
                                          std::span<const uint32_t> spirv,
                                          std::span<const uint32_t> fullscreenVertex,
                                          std::span<const VkFormat> outputFormats) {
    return guarded([&]() -> Result<PassPipeline> {
        if (variant.pass == nullptr || stage == Stage::vertex)
            return Error{ErrorCode::invalidArgument,
                         "A PassPipeline needs a variant of a pass, and the stage fragment or compute."};
        auto module = readStage(spirv, stage, variant.pass->name);
        if (!module) return module.error();
        auto state = std::make_unique<State>();
        state->device = device;
        state->variant = variant;
        state->stage = stage;
        const bool fragment = stage == Stage::fragment;
        auto interface = makeInterface(device, *variant.pass, {&*module, 1},
                                       fragment ? VK_SHADER_STAGE_FRAGMENT_BIT : VK_SHADER_STAGE_COMPUTE_BIT);
        if (!interface) return interface.error();
        state->interface = std::move(*interface);
        auto built = fragment ? buildFragment(*state, *module, fullscreenVertex, outputFormats)
                              : buildCompute(*state, *module);
        if (!built) return built.error();
        return PassPipeline(std::move(state));
    });
}

Result<void> PassPipeline::record(VkCommandBuffer commands, FrameArena& arena,
                                  std::span<const NamedImage> images, std::span<const NamedBuffer> buffers,
                                  std::span<const std::byte> parameters) const {
    return guarded([&]() -> Result<void> {
        auto prepared = PassAccess::prepare(*this, arena, {images, buffers, parameters});
        if (!prepared) return prepared.error();
        PassAccess::emit(*this, commands, *prepared);
        return {};
    });
}

Result<PreparedPass> PassAccess::prepare(const PassPipeline& pass, FrameArena& arena,
                                         const Resources& given) {
    const State& state = *pass.state_;
    const auto images = withAliases(*state.variant.pass, given.images);
    const Resources resources{images, given.buffers, given.parameters};
    auto prepared = prepareTargets(state.variant, state.stage, resources.images);
    if (!prepared) return prepared;
    auto set = writeSet(state.device, *state.variant.pass, state.interface, arena, resources);
    if (!set) return set.error();
    prepared->set = *set;
    return prepared;
}

void PassAccess::emit(const PassPipeline& pass, VkCommandBuffer commands, const PreparedPass& prepared) {
    const State& state = *pass.state_;
    const bool compute = state.stage == Stage::compute;
    const VkPipelineBindPoint point =
        compute ? VK_PIPELINE_BIND_POINT_COMPUTE : VK_PIPELINE_BIND_POINT_GRAPHICS;
    const DeviceFunctions& vk = *state.device.vk;
    vk.CmdBindPipeline(commands, point, state.pipeline.get());
    vk.CmdBindDescriptorSets(commands, point, state.interface.layout.get(), 0, 1, &prepared.set, 0, nullptr);
    if (compute)
        dispatch(state.device, commands, state.variant, prepared.extent);
    else
        draw(state.device, commands, prepared);
}

} // namespace reprise
