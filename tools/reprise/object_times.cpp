// SPDX-License-Identifier: Apache-2.0
// The one source here that includes the runtime's own headers: what is timed is then the very pipeline and
// the very draws of a frame, and the floor differs in its two modules alone.
#include "object_times.hpp"

#include "object_velocity.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Stage;
using reprise::Variant;

constexpr VkFormat velocityFormat = VK_FORMAT_R16G16_SFLOAT;

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

// A frame's draws and what they draw to; the sections share it.
struct ObjectFrame {
    ObjectFrame(Experiment& e, const scenes::Scene& scene)
        : gpu(e.gpu), renderer(e.gpu, scene, e.plan.timingSize.width, e.plan.timingSize.height),
          velocity(e.gpu.image(velocityFormat, e.plan.timingSize.width, e.plan.timingSize.height)) {}

    harness::Gpu& gpu;
    scenes::Renderer renderer;
    harness::Image velocity;
    RenderedFrame previous, current;
    std::vector<reprise::ObjectDraw> objects;
    reprise::FrameInput input;
};

std::shared_ptr<ObjectFrame> makeFrame(Experiment& e, const scenes::Scene& scene, uint32_t index) {
    auto frame = std::make_shared<ObjectFrame>(e, scene);
    auto frames = renderFrames(e.gpu, frame->renderer, index - 1, 2, reprise::JitterSequence::halton16, true);
    frame->previous = std::move(frames[0]);
    frame->current = std::move(frames[1]);
    frame->objects = frame->renderer.movingObjects(static_cast<int>(index));
    frame->input.camera = frame->current.camera;
    frame->input.jitterPx = frame->current.jitterPx;
    frame->input.movingObjects = frame->objects;
    e.gpu.run(
        [&](VkCommandBuffer commands) { e.gpu.use(commands, frame->velocity, reprise::attachmentState); });
    return frame;
}

// Pipeline and descriptors of one section. Sets are written once: every round draws the same.
struct Draws {
    reprise::ObjectPipeline pipeline;
    reprise::FrameArena arena;
    std::vector<reprise::PreparedDraw> prepared;
};

std::shared_ptr<Draws> makeDraws(ObjectFrame& frame, const Variant& variant,
                                 const reprise::SpirvSource& spirv) {
    const reprise::Device& device = frame.gpu.device();
    const auto count = static_cast<uint32_t>(std::max<size_t>(1, frame.objects.size()));
    auto pipeline = orThrow(reprise::makeObjectPipeline(
        device, variant, spirv, {.velocity = velocityFormat, .depth = frame.current.depthTest.ref.format}));
    auto arena = orThrow(reprise::FrameArena::create(device, 1, count, count * variant.pass->parameterBytes));
    if (auto begun = arena.begin(0); !begun) throw std::runtime_error(begun.error().message);
    auto draws = std::make_shared<Draws>(std::move(pipeline), std::move(arena));
    draws->prepared = orThrow(reprise::prepareDraws(device, draws->pipeline, draws->arena, frame.input,
                                                    frame.previous.camera, frame.velocity.ref.extent));
    return draws;
}

reprise::SpirvSource floorModules(bool skinned) {
    return [text = objectFloorSource(skinned)](const Variant&,
                                               Stage stage) -> reprise::Result<std::vector<uint32_t>> {
        return compileText("floor of object_velocity", text, stage).spirv;
    };
}

void addSection(Stopwatch& watch, const std::string& name, std::shared_ptr<ObjectFrame> frame,
                std::shared_ptr<Draws> draws) {
    watch.addSection(name, [frame, draws](VkCommandBuffer commands) {
        reprise::emitDraws(frame->gpu.device(), draws->pipeline, commands, draws->prepared,
                           frame->velocity.ref, frame->current.depthTest.ref);
    });
}

bool hasMovingObjects(const scenes::Scene& scene) {
    return std::any_of(scene.instances.begin(), scene.instances.end(),
                       [](const auto& instance) { return instance.moves; });
}

// One section and its floor per variant that has draws.
void addScene(Experiment& e, Stopwatch& watch, const scenes::Scene& scene, uint32_t index,
              std::vector<ObjectSection>& sections) {
    const auto frame = makeFrame(e, scene, index);
    for (bool skinned : {false, true}) {
        Variant variant = orThrow(reprise::makeVariant(e.shaders.pack().passes(), "object_velocity"));
        if (skinned && !reprise::setSwitch(variant, "SKINNING", "on")) continue;
        const auto pass = makeDraws(*frame, variant, e.shaders.source());
        if (pass->prepared.empty()) continue;
        const std::string name =
            fmt::format("{}, {}", scene.name, reprise::spirvFileName(variant, Stage::fragment));
        addSection(watch, name, frame, pass);
        addSection(watch, "floor of " + name, frame, makeDraws(*frame, variant, floorModules(skinned)));
        sections.push_back({variant, scene.name, name, "floor of " + name});
    }
}

} // namespace

std::string objectFloorSource(bool skinned) {
    std::string text = skinned ? "#define SKINNING 1\n" : "#define SKINNING 0\n";
    // Row vectors, as everywhere in the pack. Where a matrix is only read, its rows are added.
    text += R"(
[[vk::binding(0)]] cbuffer Parameters {
    row_major float4x4 gObjectToClip;
    row_major float4x4 gPrevObjectToClip;
    float2 gJitterNdc;
};
float2 sumOf(float4x4 m) {
    float4 rows = m[0] + m[1] + m[2] + m[3];
    return rows.xy + rows.zw;
}
struct VertexInput {
    [[vk::location(0)]] float3 position : POSITION;
#if SKINNING
    [[vk::location(1)]] uint4 joints : BLENDINDICES;
    [[vk::location(2)]] float4 weights : BLENDWEIGHT;
#endif
};
struct Varyings {
    float4 positionPx : SV_Position;
    [[vk::location(0)]] float2 value : TEXCOORD0;
};
#if SKINNING
struct Joint {
    row_major float4x4 toWorld;
};
[[vk::binding(2)]] StructuredBuffer<Joint> gInJoints;
[[vk::binding(3)]] StructuredBuffer<Joint> gInPrevJoints;
#endif
Varyings mainVertex(VertexInput input) {
    float4 position = float4(input.position, 1.0);
    Varyings output;
    output.value = sumOf(gPrevObjectToClip);
#if SKINNING
    float4 bound = position;
    position = 0.0;
    for (uint i = 0; i < 4; ++i) {
        position += input.weights[i] * mul(bound, gInJoints[input.joints[i]].toWorld);
        output.value += sumOf(gInPrevJoints[input.joints[i]].toWorld);
    }
#endif
    output.positionPx = mul(position, gObjectToClip);
    output.positionPx.xy += gJitterNdc * output.positionPx.w;
    return output;
}
float2 mainFragment(Varyings input) : SV_Target0 {
    return input.value;
}
)";
    return text;
}

std::vector<ObjectSection> addObjectSections(Experiment& e, Stopwatch& watch, uint32_t index) {
    std::vector<ObjectSection> sections;
    if (!e.plan.has("object_velocity")) return sections;
    for (const scenes::Scene& scene : e.plan.scenes)
        if (hasMovingObjects(scene)) addScene(e, watch, scene, index, sections);
    return sections;
}

} // namespace report
