// SPDX-License-Identifier: Apache-2.0
#include "experiment.hpp"
#include "lighting_times.hpp"
#include "object_times.hpp"

#include "reprise/camera.hpp"

#include <algorithm>
#include <functional>

namespace report {
namespace {

using reprise::Stage;
using reprise::Variant;

// A frame of the first scene that moves: what a pass reads decides which texels it touches.
struct TimedFrame {
    std::vector<RenderedFrame> frames; // two; the earlier one's colour stands for the history
    PassData data;
};

constexpr uint32_t timedFrame = 8;

const scenes::Scene& sceneToTime(const Plan& plan) {
    const auto moving = std::find_if(plan.scenes.begin(), plan.scenes.end(),
                                     [](const scenes::Scene& scene) { return scene.cameraMoves; });
    return moving == plan.scenes.end() ? plan.scenes.front() : *moving;
}

std::vector<float> floats(const glm::dmat4& m) {
    std::vector<float> values;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            values.push_back(static_cast<float>(m[c][r]));
    return values;
}

void setParameters(TimedFrame& timed, Size size) {
    const RenderedFrame &previous = timed.frames[0], &current = timed.frames[1];
    const auto width = static_cast<float>(size.width), height = static_cast<float>(size.height);
    const glm::vec2 jitter(current.jitterPx);
    auto& p = timed.data.parameters;
    p["gOutputSize"] = {width, height, 1.0f / width, 1.0f / height};
    p["gJitterPx"] = {jitter.x, jitter.y};
    p["gJitterUv"] = {jitter.x / width, jitter.y / height};
    p["gMotionToUv"] = {1.0f, 1.0f};
    p["gHistoryValid"] = {1.0f};
    p["gFeedbackMin"] = {0.88f};
    p["gFeedbackMax"] = {0.97f};
    p["gBlurFromPx"] = {2.0f};
    p["gBlurToPx"] = {15.0f};
    p["gReprojection"] = floats(reprise::reprojection(current.camera, previous.camera));
    p["gViewRay"] = {1.0f, 1.0f, 0.0f, 0.0f};
}

TimedFrame renderTimedFrame(Experiment& e) {
    scenes::Renderer renderer(e.gpu, sceneToTime(e.plan), e.plan.timingSize.width, e.plan.timingSize.height);
    TimedFrame timed;
    timed.frames = renderFrames(e.gpu, renderer, timedFrame - 1, 2, reprise::JitterSequence::halton16);
    setParameters(timed, e.plan.timingSize);
    return timed;
}

void bindImages(TimedFrame& timed) {
    timed.data.images = {{"gInColour", &timed.frames[1].colour},
                         {"gInDepth", &timed.frames[1].depth},
                         {"gInVelocity", &timed.frames[1].motion},
                         {"gHistoryColour", &timed.frames[0].colour}};
}

// Every full-screen pass of the plan: temporal_aa in the variants of its rows, the others in all committed
// ones.
std::vector<Shaders::Request> variantsOf(const Plan& plan, const reprisec::Pack& pack) {
    const bool cameraAlone = std::ranges::any_of(plan.scenes, cameraMovesAlone);
    std::vector<Shaders::Request> result;
    for (const auto& pass : pack.passes()) {
        if (!pass.fullscreen || !plan.has(pass.name)) continue;
        for (Stage stage : plan.stages) {
            if (pass.name == "temporal_aa") {
                for (RowSpec& spec : temporalRows(pack, stage, plan.flipped))
                    if (spec.variant && (cameraAlone || !spec.cameraAlone))
                        result.emplace_back(std::move(*spec.variant), stage);
            } else {
                for (const Variant& variant : pack.committedVariants(pass))
                    result.emplace_back(variant, stage);
            }
        }
    }
    return result;
}

// Efficiency is that of the fastest runs, which other work on the machine disturbs least.
void addTimes(Row& row, const Timing& pass, const Timing& floor) {
    row.gpu = pass;
    row.floorMs = floor.min;
    row.efficiency = floor.min / pass.min;
    row.passes = {{row.technique, pass.median}};
}

void addTimes(Row& row, const Stopwatch& watch, const PassTiming& timing, Stage stage) {
    addTimes(row, timing.gpu, timing.floor);
    row.perNineTaps = timing.gpu.median / watch.floorOf("nine taps", stage).median;
    row.perCopy = timing.gpu.median / watch.floorOf("copy", stage).median;
    row.readsPerPixel = timing.readsPerPixel;
}

std::string lowerSwitches(const Variant& variant) {
    std::string text = "default";
    for (size_t i = 0; i < variant.pass->switches.size(); ++i) {
        const auto& info = variant.pass->switches[i];
        if (variant.values[i] != info.defaultValue) text += " + " + switchText(info, variant.values[i]);
    }
    return text;
}

// A variant of a velocity pass without a row, because its data is of another kind than the scene's or because
// it shares the error of another: it is timed only.
Row timeOnlyRow(const Plan& plan, const Variant& variant, Stage stage, const std::string& scene) {
    Row row;
    row.technique = variant.pass->name;
    row.variant = lowerSwitches(variant);
    row.scene = scene;
    row.file = reprise::spirvFileName(variant, stage);
    row.stage = stageText(stage);
    row.width = plan.timingSize.width;
    row.height = plan.timingSize.height;
    row.errorWidth = plan.errorSize.width;
    row.errorHeight = plan.errorSize.height;
    row.errorUnit = "pixels";
    return row;
}

// Times go into every row of the variant, in `scene` alone if `ofScene`; a variant without a row gets one.
void fillRows(Experiment& e, const Variant& variant, Stage stage, const std::string& scene, bool ofScene,
              const std::function<void(Row&)>& fill) {
    const std::string file = reprise::spirvFileName(variant, stage);
    bool found = false;
    for (Row& row : e.report.rows) {
        const bool same =
            row.file == file && row.stage == stageText(stage) && (!ofScene || row.scene == scene);
        if (same) fill(row);
        found = found || same;
    }
    if (found) return;
    e.report.rows.push_back(timeOnlyRow(e.plan, variant, stage, scene));
    fill(e.report.rows.back());
}

} // namespace

void measureTimes(Experiment& e) {
    const auto requests = variantsOf(e.plan, e.shaders.pack());
    e.shaders.prepare(requests);
    TimedFrame timed = renderTimedFrame(e);
    bindImages(timed);
    Stopwatch watch(e.gpu, e.shaders, e.plan.timingSize.width, e.plan.timingSize.height);
    for (Stage stage : e.plan.stages)
        watch.addFloors(stage, timed.frames[1].colour);
    for (const auto& [variant, stage] : requests)
        watch.addPass(variant, stage, timed.data);
    const auto objects = addObjectSections(e, watch, timedFrame);
    const auto lighting = addLighting(e, watch);
    watch.run(e.plan.rounds, e.progress, workPerTimingRound);
    e.report.floors = watch.floors();
    const std::string scene = sceneToTime(e.plan).name;
    for (const auto& [variant, stage] : requests)
        fillRows(e, variant, stage, scene, false,
                 [&](Row& row) { addTimes(row, watch, watch.passOf(variant, stage), stage); });
    for (const ObjectSection& section : objects)
        fillRows(e, section.variant, Stage::fragment, section.scene, true, [&](Row& row) {
            addTimes(row, watch.timing(section.name), watch.timing(section.floorName));
        });
    fillLighting(e, watch, lighting);
}

} // namespace report
