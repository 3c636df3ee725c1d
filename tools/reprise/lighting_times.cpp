// SPDX-License-Identifier: Apache-2.0
// It includes the runtime's own headers: a pass alone is then given the very parameters of a frame.
#include "lighting_times.hpp"

#include "floors.hpp"
#include "frame_parameters.hpp"
#include "plan_images.hpp"

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

// The images of a plan, of history both, and the engine's.
struct PlanImages {
    std::vector<std::array<harness::Image, 2>> images;
};

const reprise::ImageRef& engineImage(const reprise::FrameInput& input, std::string_view name) {
    if (name == "gInDepth") return input.depth;
    if (name == "gInColour") return input.colour;
    if (name == "gInVelocity" && input.motion) return *input.motion;
    if (name == "gInFresh" && input.fresh) return *input.fresh;
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
// floor, which writes to images of its own.
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
    const std::string_view name = pass.variant.pass->name;
    const VkExtent2D extent{input.size.width, input.size.height};
    const reprise::CacheFrame frame{
        input.frames[0].camera,  extent, plan.cache.ratio, true, needs.reversedDepth, needs.linearDepth,
        needs.engineWritesMotion};
    return reprise::cacheParameters(name, pass.run, input.frames[1], frame);
}

} // namespace

std::string floorOf(const std::string& section) {
    return "floor of " + section;
}

TimedPlan addPlan(Experiment& e, Stopwatch& watch, const std::string& label, const reprise::SceneNeeds& needs,
                  const reprise::Settings& settings, const TimedInput& input) {
    reprise::FrameRecorder::CreateInfo info;
    info.needs = needs;
    info.settings = settings;
    info.extent = {input.size.width, input.size.height};
    auto recorder = std::make_shared<reprise::FrameRecorder>(orThrow(
        reprise::FrameRecorder::create(e.gpu.device(), e.shaders.pack().passes(), e.shaders.source(), info)));
    TimedPlan timed;
    timed.section = label;
    timed.plan = recorder->plan();
    auto index = std::make_shared<uint64_t>(0);
    watch.addSection(label, [recorder, index, input](VkCommandBuffer commands) {
        reprise::FrameInput frame = input.frames[*index % 2];
        frame.frameIndex = (*index)++;
        auto recorded = recorder->record(commands, frame);
        if (!recorded) throw std::runtime_error(recorded.error().message);
    });
    const auto images = makeImages(e.gpu, timed.plan, input.frames[1]);
    for (const PlannedPass& pass : timed.plan.passes) {
        const std::string run = pass.run.empty() ? "" : " " + std::string(pass.run);
        timed.passes.push_back(fmt::format("{}: {}{}", label, pass.variant.pass->name, run));
        addPass(e, watch, timed.passes.back(), pass, images, parametersOf(pass, timed.plan, needs, input));
    }
    return timed;
}

} // namespace report
