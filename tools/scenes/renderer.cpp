// SPDX-License-Identifier: Apache-2.0
#include "renderer.hpp"

#include "descriptors.hpp"
#include "frame_data.hpp"
#include "pipelines.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>

namespace scenes {
namespace {

// Temporal anti-aliasing resolves more than a pixel's worth of texture detail; the ground truth needs no
// help.
constexpr float lodBias = -0.5f; // as temporal anti-aliasing wants; the truth integrates the same texture

struct PaletteBuffers {
    harness::Buffer current, previous;
};

// Everything of one frame on the GPU; taken over by another frame when framesInFlight others came after it.
struct FrameSlot {
    int frame = -1;
    uint64_t lastUse = 0;
    FrameContent content;
    harness::Buffer uniforms, instances, palette, prevPalette;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::map<uint32_t, PaletteBuffers> palettes; // by instance, for movingObjects alone
};

struct TruthTargets {
    harness::Image colour, depth, sum;
    VkDescriptorSet set = VK_NULL_HANDLE;
};

template <class T> void write(harness::Buffer& buffer, const std::vector<T>& data) {
    if (!data.empty()) std::memcpy(buffer.mapped, data.data(), data.size() * sizeof(T));
}

VkRenderingAttachmentInfo attachment(const harness::Image& image, VkAttachmentLoadOp load,
                                     float clear = 0.0f) {
    auto info = structure<VkRenderingAttachmentInfo>(VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO);
    info.imageView = image.ref.view;
    info.imageLayout = image.state.layout;
    info.loadOp = load;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    if (image.ref.aspect == VK_IMAGE_ASPECT_DEPTH_BIT) info.clearValue.depthStencil.depth = clear;
    return info;
}

void beginRendering(VkCommandBuffer commands, VkExtent2D extent,
                    std::span<const VkRenderingAttachmentInfo> colours,
                    const VkRenderingAttachmentInfo* depth) {
    auto info = structure<VkRenderingInfo>(VK_STRUCTURE_TYPE_RENDERING_INFO);
    info.renderArea.extent = extent;
    info.layerCount = 1;
    info.colorAttachmentCount = uint32_t(colours.size());
    info.pColorAttachments = colours.data();
    info.pDepthAttachment = depth;
    vkCmdBeginRendering(commands, &info);
}

// NDC y points up, as in Direct3D: a viewport of negative height.
void setViewport(VkCommandBuffer commands, float x, float width, float height) {
    const VkViewport viewport{x, height, width, -height, 0.0f, 1.0f};
    const VkRect2D scissor{{int32_t(x), 0}, {uint32_t(width), uint32_t(height)}};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

// Points of the Hammersley set: stratified in every elementary interval of the pixel, for any count.
glm::dvec2 truthJitter(uint32_t index, uint32_t count) {
    double inverse = 0.0, digit = 0.5;
    for (uint32_t bits = index; bits != 0; bits >>= 1, digit *= 0.5)
        if (bits & 1) inverse += digit;
    const double centre = 0.5 / count; // the points lie in the middle of their strata
    return {index / double(count) + centre - 0.5, inverse + centre - 0.5};
}

} // namespace

struct Renderer::State {
    harness::Gpu& gpu;
    Scene scene;
    uint32_t width, height;
    DepthKind depth;
    Cleanup cleanup;
    SceneData data;
    Bounds bounds;
    harness::Image shadows;
    VkDescriptorSetLayout frameLayout = VK_NULL_HANDLE, accumulateLayout = VK_NULL_HANDLE;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    std::optional<Pipelines> pipelines;
    std::vector<FrameSlot> slots;
    uint64_t uses = 0;
    std::optional<TruthTargets> truth;

    State(harness::Gpu& owner, const Scene& what, uint32_t w, uint32_t h, DepthKind kind)
        : gpu(owner), scene(what), width(w), height(h), depth(kind),
          data(makeSceneData(owner, what, cleanup)), bounds(sceneBounds(what, data, 0.0)) {}

    // Instances lie in their buffer as far apart as dynamic offsets must.
    VkDeviceSize instanceStride() const {
        const VkDeviceSize step =
            std::max<VkDeviceSize>(1, gpu.device().limits.minUniformBufferOffsetAlignment);
        return (sizeof(InstanceData) + step - 1) / step * step;
    }
    FrameSlot& slot(int frame);
    void fill(FrameSlot& slot, int frame);
    RenderConstants constants(int frame, glm::dvec2 jitterPx, float lodBias) const;
    void bind(VkCommandBuffer commands, const FrameSlot& slot, const RenderConstants& constants);
    void drawInstances(VkCommandBuffer commands, const FrameSlot& slot, std::span<const uint32_t> instances,
                       Draw draw, bool gbuffer);
    void drawShadows(VkCommandBuffer commands, const FrameSlot& slot);
    void drawView(VkCommandBuffer commands, const FrameSlot& slot, std::span<harness::Image* const> colours,
                  harness::Image& depthImage, const RenderConstants& constants);
    void makeTruth();
    void accumulate(VkCommandBuffer commands, bool first);
};

void Renderer::State::fill(FrameSlot& slot, int frame) {
    slot.frame = frame;
    slot.palettes.clear();
    slot.content = frameContent(scene, data, bounds, frame, width, height, depth);
    std::memcpy(slot.uniforms.mapped, &slot.content.uniforms, sizeof(FrameUniforms));
    for (size_t i = 0; i < slot.content.instances.size(); ++i)
        std::memcpy(slot.instances.mapped + i * instanceStride(), &slot.content.instances[i],
                    sizeof(InstanceData));
    write(slot.palette, slot.content.palette);
    write(slot.prevPalette, slot.content.prevPalette);
}

FrameSlot& Renderer::State::slot(int frame) {
    auto found = std::ranges::find(slots, frame, &FrameSlot::frame);
    if (found == slots.end()) {
        found = std::ranges::min_element(slots, {}, &FrameSlot::lastUse);
        if (found->set == VK_NULL_HANDLE) {
            VkDeviceSize joints = 1;
            for (const Instance& instance : scene.instances)
                joints += data.meshes[instance.mesh].jointCount;
            const VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
            found->uniforms = gpu.buffer(sizeof(FrameUniforms), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
            found->instances = gpu.buffer(instanceStride() * std::max<size_t>(1, scene.instances.size()),
                                          VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
            found->palette = gpu.buffer(sizeof(glm::mat4) * joints, storage);
            found->prevPalette = gpu.buffer(sizeof(glm::mat4) * joints, storage);
            found->set = allocateSet(gpu.handle(), pool, frameLayout);
            const VkDescriptorType uniform = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
            const VkDescriptorType dynamic = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC;
            writeBuffer(gpu.handle(), found->set, 0, uniform, found->uniforms);
            writeBuffer(gpu.handle(), found->set, 1, dynamic, found->instances, sizeof(InstanceData));
            writeBuffer(gpu.handle(), found->set, 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, found->palette);
            writeBuffer(gpu.handle(), found->set, 3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, found->prevPalette);
            writeImage(gpu.handle(), found->set, 4, shadows.ref.view);
        }
        fill(*found, frame);
    }
    found->lastUse = ++uses;
    return *found;
}

RenderConstants Renderer::State::constants(int frame, glm::dvec2 jitterPx, float lodBias) const {
    const glm::dmat4 projection = cameraAt(scene, frame, double(width) / double(height), depth).viewToClip;
    // What the jittered projection does to a point in clip space: it adds these multiples of w to x and y.
    const glm::dmat4 shear =
        reprise::jitteredProjection(projection, jitterPx, width, height) * glm::inverse(projection);
    RenderConstants constants;
    constants.jitterNdc = glm::vec2(shear[3]);
    constants.jitterPx = glm::vec2(jitterPx);
    constants.lodBias = lodBias;
    return constants;
}

void Renderer::State::bind(VkCommandBuffer commands, const FrameSlot& slot,
                           const RenderConstants& constants) {
    const VkPipelineLayout layout = pipelines->layout(Draw::scene);
    const uint32_t firstInstance = 0;
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &slot.set, 1,
                            &firstInstance);
    vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(constants), &constants);
}

void Renderer::State::drawInstances(VkCommandBuffer commands, const FrameSlot& slot,
                                    std::span<const uint32_t> instances, Draw draw, bool gbuffer) {
    VkPipeline bound = VK_NULL_HANDLE;
    VkDescriptorSet boundTexture = VK_NULL_HANDLE;
    for (uint32_t index : instances) {
        const Instance& instance = scene.instances[index];
        const Material& material = scene.materials[instance.material];
        const MeshRange& mesh = data.meshes[instance.mesh];
        const bool alphaTest = material.alphaCutoff > 0.0f;
        const bool textured = alphaTest || (draw == Draw::scene && material.texture >= 0);
        const VkPipeline pipeline = pipelines->get({draw, mesh.skinned, textured, alphaTest, gbuffer});
        if (pipeline != bound) vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, bound = pipeline);
        const VkDescriptorSet texture = data.textureSets[size_t(material.texture + 1)];
        if (textured && texture != boundTexture) {
            boundTexture = texture;
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines->layout(draw), 1, 1,
                                    &texture, 0, nullptr);
        }
        const auto offset = uint32_t(index * instanceStride());
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines->layout(draw), 0, 1,
                                &slot.set, 1, &offset);
        const bool mirrored = glm::determinant(glm::mat3(slot.content.instances[index].objectToWorld)) < 0.0f;
        const bool bothSides = material.twoSided || draw == Draw::shadow;
        vkCmdSetCullMode(commands, bothSides  ? VK_CULL_MODE_NONE
                                   : mirrored ? VK_CULL_MODE_FRONT_BIT
                                              : VK_CULL_MODE_BACK_BIT);
        const VkBuffer buffers[] = {data.positions.buffer, data.attributes.buffer, data.joints.buffer,
                                    data.weights.buffer};
        const VkDeviceSize offsets[] = {mesh.positions, mesh.attributes, mesh.joints, mesh.weights};
        vkCmdBindVertexBuffers(commands, 0, mesh.skinned ? 4 : 2, buffers, offsets);
        vkCmdBindIndexBuffer(commands, data.indices.buffer, mesh.indices, VK_INDEX_TYPE_UINT32);
        vkCmdDrawIndexed(commands, mesh.indexCount, 1, 0, 0, 0);
    }
}

void Renderer::State::drawShadows(VkCommandBuffer commands, const FrameSlot& slot) {
    gpu.use(commands, shadows, depthWriteState);
    const VkRenderingAttachmentInfo depthInfo = attachment(shadows, VK_ATTACHMENT_LOAD_OP_CLEAR, 1.0f);
    beginRendering(commands, shadows.ref.extent, {}, &depthInfo);
    for (uint32_t cascade = 0; cascade < cascadeCount; ++cascade) {
        RenderConstants constants;
        constants.cascade = cascade;
        bind(commands, slot, constants);
        setViewport(commands, float(cascade * cascadeSize), cascadeSize, cascadeSize);
        drawInstances(commands, slot, slot.content.casters[cascade], Draw::shadow, false);
    }
    vkCmdEndRendering(commands);
    gpu.use(commands, shadows, reprise::sampledState);
}

void Renderer::State::drawView(VkCommandBuffer commands, const FrameSlot& slot,
                               std::span<harness::Image* const> colours, harness::Image& depthImage,
                               const RenderConstants& constants) {
    std::vector<VkRenderingAttachmentInfo> colourInfos;
    for (harness::Image* image : colours) {
        gpu.use(commands, *image, reprise::attachmentState);
        // The sky is drawn wherever nothing else is, so nothing needs clearing.
        colourInfos.push_back(attachment(*image, VK_ATTACHMENT_LOAD_OP_DONT_CARE));
    }
    gpu.use(commands, depthImage, depthWriteState);
    const float farDepth = depth == DepthKind::standard ? 1.0f : 0.0f;
    const VkRenderingAttachmentInfo depthInfo = attachment(depthImage, VK_ATTACHMENT_LOAD_OP_CLEAR, farDepth);
    beginRendering(commands, {width, height}, colourInfos, &depthInfo);
    bind(commands, slot, constants);
    setViewport(commands, 0.0f, float(width), float(height));
    const bool gbuffer = colours.size() > 1;
    const std::span<const uint32_t> order = slot.content.order;
    const auto opaque = order.first(slot.content.opaqueCount), tested = order.subspan(opaque.size());
    drawInstances(commands, slot, opaque, Draw::scene, gbuffer);
    drawInstances(commands, slot, tested, Draw::depth, gbuffer);
    drawInstances(commands, slot, tested, Draw::scene, gbuffer);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      pipelines->get({.draw = Draw::sky, .gbuffer = gbuffer}));
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

void Renderer::State::makeTruth() {
    if (truth) return;
    truth.emplace();
    truth->colour = gpu.image(VK_FORMAT_R16G16B16A16_SFLOAT, width, height);
    truth->depth = gpu.image(VK_FORMAT_D32_SFLOAT, width, height);
    truth->sum = gpu.image(VK_FORMAT_R32G32B32A32_SFLOAT, width, height);
    truth->set = allocateSet(gpu.handle(), pool, accumulateLayout);
    writeImage(gpu.handle(), truth->set, 0, truth->colour.ref.view);
}

void Renderer::State::accumulate(VkCommandBuffer commands, bool first) {
    gpu.use(commands, truth->colour, reprise::sampledState);
    gpu.use(commands, truth->sum, reprise::attachmentState);
    const VkRenderingAttachmentInfo sum =
        attachment(truth->sum, first ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD);
    beginRendering(commands, {width, height}, {&sum, 1}, nullptr);
    setViewport(commands, 0.0f, float(width), float(height));
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines->get({.draw = Draw::accumulate}));
    vkCmdSetCullMode(commands, VK_CULL_MODE_NONE);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines->layout(Draw::accumulate), 0,
                            1, &truth->set, 0, nullptr);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRendering(commands);
}

Renderer::Renderer(harness::Gpu& gpu, const Scene& scene, uint32_t width, uint32_t height, DepthKind depth) {
    if (width == 0 || height == 0)
        throw std::runtime_error(
            "The scene renderer was asked for an empty picture; give a width and height above 0.");
    state_ = std::make_unique<State>(gpu, scene, width, height, depth);
    State& state = *state_;
    const VkDevice device = gpu.handle();
    const VkSampler sampler = makeShadowSampler(device, state.cleanup);
    const VkDescriptorSetLayoutBinding frame[] = {
        binding(0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER), binding(1, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER_DYNAMIC),
        binding(2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER), binding(3, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER),
        binding(4, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE),  binding(5, VK_DESCRIPTOR_TYPE_SAMPLER, &sampler)};
    const VkDescriptorSetLayoutBinding accumulate[] = {binding(0, VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE)};
    state.frameLayout = makeSetLayout(device, frame, state.cleanup);
    state.accumulateLayout = makeSetLayout(device, accumulate, state.cleanup);
    const VkDescriptorSetLayout sceneSets[] = {state.frameLayout, state.data.textureLayout};
    state.pool = makePool(device, framesInFlight + 1, state.cleanup);
    state.pipelines.emplace(device, makePipelineLayout(device, sceneSets, state.cleanup),
                            makePipelineLayout(device, {&state.accumulateLayout, 1}, state.cleanup), depth,
                            uint32_t(std::min(scene.lights.size(), maxLights)));
    state.shadows = gpu.image(VK_FORMAT_D32_SFLOAT, cascadeSize * cascadeCount, cascadeSize);
    state.slots.resize(framesInFlight);
}

Renderer::~Renderer() = default;

const Scene& Renderer::scene() const {
    return state_->scene;
}

FrameTargets Renderer::targets() const {
    State& s = *state_;
    return {s.gpu.image(VK_FORMAT_R16G16B16A16_SFLOAT, s.width, s.height),
            s.gpu.image(VK_FORMAT_R32_SFLOAT, s.width, s.height),
            s.gpu.image(VK_FORMAT_D32_SFLOAT, s.width, s.height),
            s.gpu.image(VK_FORMAT_R16G16B16A16_SFLOAT, s.width, s.height),
            s.gpu.image(VK_FORMAT_R16G16_SFLOAT, s.width, s.height),
            s.gpu.image(VK_FORMAT_R32G32_UINT, s.width, s.height)};
}

void Renderer::render(VkCommandBuffer commands, int frame, glm::dvec2 jitterPx, FrameTargets& targets) {
    FrameSlot& slot = state_->slot(frame);
    state_->drawShadows(commands, slot);
    harness::Image* const colours[] = {&targets.colour, &targets.depth, &targets.normal, &targets.motion,
                                       &targets.ids};
    state_->drawView(commands, slot, colours, targets.depthTest, state_->constants(frame, jitterPx, lodBias));
    for (harness::Image* image : colours)
        state_->gpu.use(commands, *image, reprise::sampledState);
    state_->gpu.use(commands, targets.depthTest, depthReadState);
}

std::vector<float> Renderer::groundTruth(int frame, uint32_t samples) {
    State& state = *state_;
    state.makeTruth();
    // Shadows are drawn once for all samples; submissions are kept short for the sake of watchdogs.
    constexpr uint32_t samplesPerSubmission = 16;
    FrameSlot& slot = state.slot(frame);
    harness::Image* const colours[] = {&state.truth->colour};
    for (uint32_t first = 0; first < samples; first += samplesPerSubmission) {
        state.gpu.run([&](VkCommandBuffer commands) {
            if (first == 0) state.drawShadows(commands, slot);
            for (uint32_t i = first; i < std::min(first + samplesPerSubmission, samples); ++i) {
                const RenderConstants constants = state.constants(frame, truthJitter(i, samples), lodBias);
                state.drawView(commands, slot, colours, state.truth->depth, constants);
                state.accumulate(commands, i == 0);
            }
        });
    }
    const std::vector<float> sum = state.gpu.downloadFloats(state.truth->sum);
    std::vector<float> mean;
    mean.reserve(sum.size() / 4 * 3);
    for (size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) mean.push_back(sum[i] / float(samples));
    return mean;
}

std::vector<reprise::ObjectDraw> Renderer::movingObjects(int frame) {
    State& state = *state_;
    FrameSlot& slot = state.slot(frame);
    std::vector<reprise::ObjectDraw> draws;
    for (uint32_t index : slot.content.order) {
        const Instance& instance = state.scene.instances[index];
        if (!instance.moves) continue;
        const MeshRange& mesh = state.data.meshes[instance.mesh];
        const double fps = state.scene.framesPerSecond;
        reprise::ObjectDraw draw;
        draw.objectToWorld = slot.content.instances[index].objectToWorld;
        const glm::dmat4 before = instance.objectToWorld(std::max(frame - 1, 0) / fps);
        draw.prevObjectToWorld = isPresent(before) ? glm::mat4(before) : draw.objectToWorld;
        draw.positions = state.data.positions.buffer;
        draw.positionsOffset = mesh.positions;
        draw.indices = state.data.indices.buffer;
        draw.indicesOffset = mesh.indices;
        draw.indexCount = mesh.indexCount;
        if (mesh.skinned) {
            PaletteBuffers& buffers = slot.palettes[index];
            const uint32_t first = slot.content.instances[index].identity.y;
            const VkDeviceSize bytes = mesh.jointCount * sizeof(glm::mat4);
            buffers = {state.gpu.buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT),
                       state.gpu.buffer(bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)};
            std::memcpy(buffers.current.mapped, slot.content.palette.data() + first, bytes);
            std::memcpy(buffers.previous.mapped, slot.content.prevPalette.data() + first, bytes);
            draw.palette = buffers.current.buffer;
            draw.prevPalette = buffers.previous.buffer;
            draw.joints = state.data.joints.buffer;
            draw.jointsOffset = mesh.joints;
            draw.weights = state.data.weights.buffer;
            draw.weightsOffset = mesh.weights;
        }
        draws.push_back(draw);
    }
    return draws;
}

ShadowMap Renderer::shadowMap(int frame) {
    const Cascades& cascades = state_->slot(frame).content.cascades;
    ShadowMap map{&state_->shadows, {}, {}};
    for (uint32_t i = 0; i < cascadeCount; ++i) {
        map.cascades.push_back({cascades.worldToLightClip[i], cascades.farDepth[i]});
        map.texelMetres.push_back(cascades.texel[i]);
    }
    return map;
}

} // namespace scenes
