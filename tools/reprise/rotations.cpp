// SPDX-License-Identifier: Apache-2.0
#include "rotations.hpp"

#include "converged.hpp"
#include "lighting_rows.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Stage;

// In front of the far plane, where what it has cut off lies.
double skyDepthOf(const scenes::Scene& scene) {
    return 0.9999 * scene.farPlane;
}

LightingSpec specOf(uint32_t taps, float intensity, bool history) {
    LightingSpec spec;
    spec.cache.occlusion = "scalable_obscurance";
    spec.cache.samples = taps;
    spec.cache.filter = false; // it would take most of what the samples lack
    spec.cache.history = history;
    spec.tuning.radius = occlusionRadius;
    spec.tuning.obscurance.intensity = intensity;
    spec.tuning.obscurance.rotations = rotations;
    return spec;
}

// A frame of the scene, and what its pixels converge to.
struct Still {
    const scenes::Scene& scene;
    RenderedFrame& frame;
    Converged converged;
};

// Root mean square over the pixels of surfaces; red, in 255 levels, is the visibility.
double rmseOf(Experiment& e, const Still& still, const reprise::ImageRef& lighting) {
    harness::Image image = borrowed(lighting);
    const auto texels = e.gpu.downloadFloats(image);
    const uint32_t channels = harness::channelCount(lighting.format);
    const double sky = skyDepthOf(still.scene);
    double sum = 0.0;
    size_t count = 0;
    for (size_t i = 0; i < still.converged.visibility.size(); ++i) {
        if (!(still.converged.linearDepth[i] < sky)) continue;
        const double error = double(texels[i * channels]) - double(still.converged.visibility[i]);
        sum += error * error;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0;
}

// The same frame again and again; the error after each.
std::vector<double> errorsOf(Experiment& e, const Still& still, const LightingSpec& spec, Stage stage,
                             uint32_t frames) {
    reprise::FrameRecorder recorder = makeRecorder(e, needsOf(spec, still.scene), settingsOf(spec, stage));
    reprise::FrameInput input;
    input.camera = still.frame.camera;
    input.depth = still.frame.depth.ref;
    input.motion = still.frame.motion.ref;
    input.cache = spec.tuning;
    std::vector<double> errors;
    for (uint32_t index = 0; index < frames; ++index) {
        input.frameIndex = index;
        reprise::ImageRef lighting;
        e.gpu.run([&](VkCommandBuffer commands) {
            auto recorded = recorder.record(commands, input);
            if (!recorded) throw std::runtime_error(recorded.error().message);
            lighting = recorded->lighting.value();
        });
        errors.push_back(rmseOf(e, still, lighting));
        e.progress.step(1.0, still.scene.name + ", rotations");
    }
    return errors;
}

// The error is the mean of the last whole turn of the rotations, or of all there are.
void addRow(Experiment& e, const Still& still, const std::string& variant, Stage stage,
            std::vector<double> errors) {
    Row row = lightingRow(e, {}, Cached::occlusion, stage, still.scene.name);
    row.technique = "scalable_obscurance";
    row.variant = variant;
    row.frames = static_cast<uint32_t>(errors.size());
    row.reference = "the mean of 16 rotations of 33 taps";
    const size_t counted = std::min<size_t>(errors.size(), rotations);
    double sum = 0.0;
    for (size_t i = errors.size() - counted; i < errors.size(); ++i)
        sum += errors[i];
    row.error.rmse = sum / static_cast<double>(counted);
    row.rmsePerFrame = std::move(errors);
    e.report.rows.push_back(std::move(row));
}

std::string intensityText(const RotationCase& of) {
    return of.intensity == 1.0f ? "" : fmt::format(", intensity {}", of.intensity);
}

void addRows(Experiment& e, const scenes::Scene& scene, RenderedFrame& frame, const RotationCase& of,
             Stage stage) {
    Still still{scene, frame,
                convergedObscurance(e.gpu, e.shaders, frame,
                                    {.radius = double(occlusionRadius),
                                     .intensity = double(of.intensity),
                                     .bias = glm::dvec2(reprise::ObscuranceTuning{}.bias),
                                     .skyDepth = skyDepthOf(scene),
                                     .stage = stage})};
    addRow(e, still, oneFrameName(of.few, of), stage,
           errorsOf(e, still, specOf(of.few, of.intensity, false), stage, rotations));
    addRow(e, still, rotationsName(of), stage,
           errorsOf(e, still, specOf(of.few, of.intensity, true), stage, settledFrames));
    LightingSpec whole = specOf(of.many, of.intensity, false);
    whole.tuning.obscurance.rotations = 1;
    addRow(e, still, oneFrameName(of.many, of), stage, errorsOf(e, still, whole, stage, 1));
}

} // namespace

const scenes::Scene* stillScene(const Plan& plan) {
    const auto found = std::ranges::find_if(plan.lightingScenes, [](const scenes::Scene& scene) {
        return !scene.cameraMoves && !objectsMove(scene) && scene.eventFrame < 0;
    });
    return found == plan.lightingScenes.end() ? nullptr : &*found;
}

std::vector<RotationCase> rotationCases(const Plan& plan) {
    if (plan.quick) return {{7, 21, 1.0f}, {7, 21, 2.0f}};
    return {{5, 15, 1.0f}, {7, 21, 1.0f}, {11, 33, 1.0f}, {7, 21, 2.0f}};
}

std::string oneFrameName(uint32_t taps, const RotationCase& of) {
    return fmt::format("{} taps, one frame{}", taps, intensityText(of));
}

std::string rotationsName(const RotationCase& of) {
    return fmt::format("{} taps, three rotations{}", of.few, intensityText(of));
}

void measureRotations(Experiment& e) {
    const scenes::Scene* scene = stillScene(e.plan);
    if (e.plan.timingOnly || !scene || !e.plan.has("occlusion")) return;
    scenes::Renderer renderer(e.gpu, *scene, e.plan.errorSize.width, e.plan.errorSize.height);
    auto frames = renderFrames(e.gpu, renderer, 0, 1, reprise::JitterSequence::none);
    for (const Stage stage : e.plan.stages)
        for (const RotationCase& each : rotationCases(e.plan))
            addRows(e, *scene, frames.front(), each, stage);
}

double rotationsWork(const Plan& plan) {
    if (plan.timingOnly || !stillScene(plan) || !plan.has("occlusion")) return 0.0;
    return static_cast<double>(plan.stages.size() * rotationCases(plan).size() *
                               (rotations + settledFrames + 1));
}

} // namespace report
