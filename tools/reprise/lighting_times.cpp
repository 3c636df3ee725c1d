// SPDX-License-Identifier: Apache-2.0
// It includes the runtime's own headers: a pass alone is then given the very parameters of a frame.
#include "lighting_times.hpp"

#include "commands.hpp"
#include "frame_parameters.hpp"
#include "plan_images.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::PlannedPass;
using reprise::Stage;

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

// Two frames that take turns, so that history is reprojected. They are kept for as long as sections run.
struct TimedInput {
    std::unique_ptr<scenes::Renderer> renderer; // its shadow map is that of the last frame
    std::vector<RenderedFrame> rendered;
    scenes::ShadowMap shadows;
    std::array<reprise::FrameInput, 2> frames;
    Size size;
};

std::string floorOf(const std::string& section) {
    return "floor of " + section;
}

// The images of a plan, of history both, and the engine's.
struct PlanImages {
    std::vector<std::array<harness::Image, 2>> images;
};

const reprise::ImageRef& engineImage(const reprise::FrameInput& input, std::string_view name) {
    if (name == "gInDepth") return input.depth;
    if (name == "gInColour") return input.colour;
    if (name == "gInVelocity" && input.motion) return *input.motion;
    if (name == "gInShadowMap" && input.shadowMap) return *input.shadowMap;
    if (name == "gInAmbientLight" && input.ambientLight) return *input.ambientLight;
    if (name == "gInSunLight" && input.sunLight) return *input.sunLight;
    throw std::runtime_error(fmt::format("The report has no image for {}", name));
}

std::shared_ptr<PlanImages> makeImages(harness::Gpu& gpu, const reprise::FramePlan& plan,
                                       const reprise::FrameInput& input) {
    auto made = std::make_shared<PlanImages>();
    for (const reprise::PlannedImage& image : plan.images) {
        auto& copies = made->images.emplace_back();
        for (harness::Image& copy : copies) {
            if (image.external)
                copy = borrowed(engineImage(input, image.name));
            else
                copy =
                    gpu.image(harness::formatByName(image.format), image.extent.width, image.extent.height);
        }
    }
    return made;
}

struct BoundPass {
    std::vector<harness::PassRunner::Binding> bindings;
    std::vector<VkFormat> formats;
    VkExtent2D extent{};
};

bool readsHistory(const PlannedPass& pass, std::string_view name) {
    for (const auto& input : pass.variant.pass->inputs)
        if (input.name == name) return reprise::isHistory(input);
    return false;
}

// `written`: which copy of a history the frame writes; it reads the other.
BoundPass bind(const PlannedPass& pass, PlanImages& images, size_t written) {
    const auto imageAt = [&](int index, size_t copy) {
        return &images.images[static_cast<size_t>(index)][copy];
    };
    BoundPass bound;
    for (size_t i = 0; i < pass.reads.size(); ++i)
        if (pass.readImages[i] >= 0)
            bound.bindings.push_back(
                {pass.reads[i],
                 imageAt(pass.readImages[i], readsHistory(pass, pass.reads[i]) ? 1 - written : written)});
    for (size_t i = 0; i < pass.writes.size(); ++i) {
        harness::Image* image = imageAt(pass.writeImages[i], written);
        bound.bindings.push_back({pass.writes[i], image});
        bound.formats.push_back(image->ref.format);
        bound.extent = image->ref.extent;
    }
    return bound;
}

// Runs the pass twice, so that the images and the history hold what a frame leaves, and adds it and its
// floor, which writes to images of its own; without a section it only runs.
void addPass(Experiment& e, Stopwatch& watch, const std::string& section, const PlannedPass& pass,
             const std::shared_ptr<PlanImages>& images, const std::vector<std::byte>& parameters) {
    const reprisec::Compiled& compiled = e.shaders.get(pass.variant, pass.stage);
    BoundPass bound = bind(pass, *images, 0);
    const auto runnerOf = [&](const std::vector<uint32_t>& spirv) {
        return harness::PassRunner(e.gpu, pass.variant, pass.stage, spirv, e.shaders.fullscreenVertex(),
                                   bound.formats);
    };
    harness::PassRunner runner = runnerOf(compiled.spirv);
    for (const size_t written : {size_t{1}, size_t{0}})
        e.gpu.run([&](VkCommandBuffer commands) {
            runner.record(commands, bind(pass, *images, written).bindings, parameters);
        });
    if (section.empty()) return;
    watch.addSection(section, [runner, bound, parameters, images](VkCommandBuffer commands) mutable {
        runner.record(commands, bound.bindings, parameters);
    });
    const auto floor = compileText(
        floorOf(section),
        floorSource(pass.variant, pass.stage, compiled.reflection, bound.extent.width, bound.extent.height),
        pass.stage);
    auto targets = std::make_shared<std::vector<harness::Image>>();
    for (const VkFormat format : bound.formats)
        targets->push_back(e.gpu.image(format, bound.extent.width, bound.extent.height));
    for (size_t i = 0; i < targets->size(); ++i)
        bound.bindings[bound.bindings.size() - targets->size() + i].image = &(*targets)[i];
    watch.addSection(floorOf(section), [runner = runnerOf(floor.spirv), bound, parameters, images,
                                        targets](VkCommandBuffer commands) mutable {
        runner.record(commands, bound.bindings, parameters);
    });
}

std::vector<std::byte> parametersOf(const PlannedPass& pass, const reprise::FramePlan& plan,
                                    const reprise::SceneNeeds& needs, const TimedInput& input) {
    const VkExtent2D extent{input.size.width, input.size.height};
    const reprise::CacheFrame frame{
        input.frames[0].camera,  extent, plan.cache, true, needs.reversedDepth, needs.linearDepth,
        needs.engineWritesMotion};
    return orThrow(reprise::cacheParameters(pass, input.frames[1], frame));
}

// Which passes of a plan are timed alone, beside the frame as the recorder records it.
bool timesPasses(const LightingSpec& spec) {
    return spec.combines || spec.cached == Cached::both || isChiefLighting(spec.label);
}
bool timesPass(const LightingSpec& spec, const PlannedPass& pass) {
    return !spec.combines || pass.variant.pass->name == reprise::combinePass;
}

// Sections for the frame and for passes alone. label: unique.
TimedPlan addPlan(Experiment& e, Stopwatch& watch, const std::string& label, const LightingSpec& spec,
                  const reprise::SceneNeeds& needs, Stage stage, const std::shared_ptr<TimedInput>& input) {
    const reprise::Settings settings = settingsOf(spec, stage);
    const reprise::CacheTuning& tuning = spec.tuning;
    auto recorder = std::make_shared<reprise::FrameRecorder>(
        orThrow(reprise::FrameRecorder::create(e.gpu.device(), e.shaders.pack().passes(), e.shaders.source(),
                                               {.needs = needs,
                                                .settings = settings,
                                                .extent = {input->size.width, input->size.height},
                                                .framesInFlight = Stopwatch::mostTurns})));
    TimedPlan timed{label, {}, recorder->plan()};
    auto index = std::make_shared<uint64_t>(0);
    watch.addSection(label, [recorder, index, input, tuning](VkCommandBuffer commands) {
        reprise::FrameInput frame = input->frames[*index % 2];
        frame.cache = tuning;
        frame.frameIndex = (*index)++;
        auto recorded = recorder->record(commands, frame);
        if (!recorded) throw std::runtime_error(recorded.error().message);
    });
    if (!timesPasses(spec)) return timed;
    const auto images = makeImages(e.gpu, timed.plan, input->frames[1]);
    TimedInput own{nullptr, {}, {}, input->frames, input->size};
    for (reprise::FrameInput& frame : own.frames)
        frame.cache = tuning;
    for (const PlannedPass& pass : timed.plan.passes) {
        const std::string run = pass.run.empty() ? "" : ", " + std::string(pass.run);
        timed.passes.push_back(
            timesPass(spec, pass) ? fmt::format("{}: {}{}", label, pass.variant.pass->name, run) : "");
        addPass(e, watch, timed.passes.back(), pass, images, parametersOf(pass, timed.plan, needs, own));
    }
    return timed;
}

constexpr uint32_t timedFrame = 8;

std::shared_ptr<TimedInput> renderInput(Experiment& e, const scenes::Scene& scene) {
    auto input = std::make_shared<TimedInput>();
    input->size = e.plan.timingSize;
    input->renderer = std::make_unique<scenes::Renderer>(e.gpu, scene, input->size.width, input->size.height);
    input->rendered = renderFrames(e.gpu, *input->renderer, timedFrame - 1, 2, reprise::JitterSequence::none);
    input->shadows = input->renderer->shadowMap(timedFrame);
    for (size_t i = 0; i < 2; ++i) {
        RenderedFrame& frame = input->rendered[i];
        input->frames[i].camera = frame.camera;
        input->frames[i].depth = frame.depth.ref;
        input->frames[i].motion = frame.motion.ref;
        input->frames[i].shadowMap = input->shadows.image->ref;
        input->frames[i].cascades = input->shadows.cascades;
        // Two images that stand for light in parts: what they hold does not change the time.
        input->frames[i].ambientLight = frame.colour.ref;
        input->frames[i].sunLight = input->rendered[1 - i].colour.ref;
    }
    return input;
}

// What a scene's needs make different.
std::pair<bool, bool> kindOf(const scenes::Scene& scene) {
    return {scene.cameraMoves, objectsMove(scene)};
}

void fill(Row& row, Experiment& e, const Stopwatch& watch, const TimedLighting& each) {
    row.gpu = watch.timing(each.timed.section);
    row.perNineTaps = row.gpu->median / watch.floorOf("nine taps", each.stage).median;
    row.perCopy = row.gpu->median / watch.floorOf("copy", each.stage).median;
    row.memoryBytes = each.timed.plan.bytes;
    row.readsPerPixel = costOf(e.shaders, each.timed.plan, e.plan.timingSize).readsPerPixel;
    for (const std::string& pass : each.timed.passes)
        if (!pass.empty())
            row.passes.push_back({pass.substr(pass.rfind(": ") + 2), watch.timing(pass).median});
}

Row passRow(Experiment& e, const Stopwatch& watch, const TimedLighting& each, size_t index) {
    const PlannedPass& pass = each.timed.plan.passes[index];
    const std::string& section = each.timed.passes[index];
    Row row;
    row.technique = pass.variant.pass->name;
    row.variant = reprise::variantName(pass.variant).substr(row.technique.size());
    row.variant =
        fmt::format("{}{}{}", each.spec.label, row.variant.empty() ? "" : ", " + row.variant.substr(2),
                    pass.run.empty() ? "" : ", " + std::string(pass.run));
    row.scene = e.plan.lightingScenes[each.scene].name;
    row.stage = stageText(pass.stage);
    row.file = reprise::spirvFileName(pass.variant, pass.stage);
    row.width = e.plan.timingSize.width;
    row.height = e.plan.timingSize.height;
    row.errorWidth = e.plan.errorSize.width;
    row.errorHeight = e.plan.errorSize.height;
    row.errorUnit = "visibility";
    row.gpu = watch.timing(section);
    row.floorMs = watch.timing(floorOf(section)).min;
    row.efficiency = *row.floorMs / row.gpu->min;
    row.perNineTaps = row.gpu->median / watch.floorOf("nine taps", each.stage).median;
    row.perCopy = row.gpu->median / watch.floorOf("copy", each.stage).median;
    row.passes = {{row.technique, row.gpu->median}};
    row.readsPerPixel =
        readsPerPixel(pass.variant, pass.stage, e.shaders.get(pass.variant, pass.stage).reflection);
    return row;
}

} // namespace

std::vector<TimedLighting> addLighting(Experiment& e, Stopwatch& watch) {
    std::vector<TimedLighting> all;
    std::vector<std::pair<bool, bool>> kinds;
    for (size_t index = 0; index < e.plan.lightingScenes.size(); ++index) {
        const scenes::Scene& scene = e.plan.lightingScenes[index];
        if (std::ranges::find(kinds, kindOf(scene)) != kinds.end()) continue;
        kinds.push_back(kindOf(scene));
        const auto input = renderInput(e, scene);
        const auto add = [&](const std::vector<LightingSpec>& specs, Stage stage) {
            for (const LightingSpec& spec : specs) {
                const std::string label = fmt::format("{}, {}, {}, {}", cachedName(spec.cached), spec.label,
                                                      scene.name, stageText(stage));
                all.push_back(
                    {spec, stage, index, addPlan(e, watch, label, spec, needsOf(spec, scene), stage, input)});
            }
        };
        for (const Cached cached : cachedOf(e.plan))
            for (const Stage stage : e.plan.stages) {
                add(lightingRows(cached, e.plan.quick), stage);
                add(combinedRows(cached, e.plan.quick), stage);
            }
    }
    return all;
}

void fillLighting(Experiment& e, const Stopwatch& watch, const std::vector<TimedLighting>& timed) {
    for (const TimedLighting& each : timed) {
        const scenes::Scene& scene = e.plan.lightingScenes[each.scene];
        for (const Cached measured : measuredBy(each.spec)) {
            if (e.plan.timingOnly || each.spec.combines)
                e.report.rows.push_back(lightingRow(e, each.spec, measured, each.stage, scene.name));
            for (const scenes::Scene& other : e.plan.lightingScenes)
                for (Row& row : e.report.rows)
                    if (kindOf(other) == kindOf(scene) && row.scene == other.name &&
                        row.technique == cachedName(measured) && row.variant == each.spec.label &&
                        row.stage == stageText(each.stage))
                        fill(row, e, watch, each);
        }
        for (size_t pass = 0; pass < each.timed.passes.size(); ++pass)
            if (!each.timed.passes[pass].empty()) e.report.rows.push_back(passRow(e, watch, each, pass));
    }
}

} // namespace report
