// SPDX-License-Identifier: Apache-2.0
#include "experiment.hpp"

#include "reprise/frame.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <stdexcept>

namespace report {
namespace {

using reprise::Stage;

// Errors in pixels, gathered over frames.
struct MotionError {
    double sum = 0.0, max = 0.0;
    uint64_t count = 0, notFinite = 0;
    std::vector<double> rmsePerFrame;

    double frameSum = 0.0;
    uint64_t frameCount = 0;

    void add(double errorPx) {
        if (!std::isfinite(errorPx)) {
            ++notFinite;
            return;
        }
        frameSum += errorPx * errorPx;
        ++frameCount;
        max = std::max(max, errorPx);
    }
    void endFrame() {
        rmsePerFrame.push_back(frameCount == 0 ? 0.0 : std::sqrt(frameSum / static_cast<double>(frameCount)));
        sum += frameSum;
        count += frameCount;
        frameSum = 0.0;
        frameCount = 0;
    }
};

// Instance IDs as the renderer writes them: + 1, 0 is the sky.
std::set<uint32_t> movingIds(const scenes::Scene& scene) {
    std::set<uint32_t> ids;
    for (const auto& instance : scene.instances)
        if (instance.moves) ids.insert(instance.id + 1);
    return ids;
}

struct StaticAndMoving {
    MotionError fixed, moving;
};

void compareMotion(harness::Gpu& gpu, RenderedFrame& frame, harness::Image& motion,
                   const std::set<uint32_t>& ids, StaticAndMoving& errors) {
    const std::vector<float> expected = gpu.downloadFloats(frame.motion),
                             measured = gpu.downloadFloats(motion);
    const std::vector<std::byte> bytes = gpu.download(frame.ids);
    const double width = motion.ref.extent.width, height = motion.ref.extent.height;
    for (size_t i = 0; i < expected.size() / 2; ++i) {
        uint32_t id = 0;
        std::memcpy(&id, bytes.data() + 8 * i, sizeof id);
        // Both say "the previous camera did not see it" by a motion of more than the image: then its size is
        // free.
        const auto outside = [](float x, float y) { return std::abs(x) > 2.0f || std::abs(y) > 2.0f; };
        if (outside(expected[2 * i], expected[2 * i + 1]) && outside(measured[2 * i], measured[2 * i + 1]))
            continue;
        const double dx =
            (static_cast<double>(measured[2 * i]) - static_cast<double>(expected[2 * i])) * width;
        const double dy =
            (static_cast<double>(measured[2 * i + 1]) - static_cast<double>(expected[2 * i + 1])) * height;
        (ids.contains(id) ? errors.moving : errors.fixed).add(std::hypot(dx, dy));
    }
    errors.fixed.endFrame();
    errors.moving.endFrame();
}

reprise::SceneNeeds needsOf(const scenes::Scene& scene) {
    reprise::SceneNeeds needs;
    needs.cameraMoves = true;
    needs.objectsMove = !movingIds(scene).empty();
    needs.skinnedMeshes = std::any_of(scene.instances.begin(), scene.instances.end(),
                                      [](const auto& instance) { return instance.palette != nullptr; });
    return needs;
}

StaticAndMoving runVelocity(Experiment& e, scenes::Renderer& renderer, Stage stage) {
    const scenes::Scene& scene = renderer.scene();
    reprise::Settings settings;
    settings.stage = stage;
    settings.preset = "inside";
    settings.overrides = {{"MOTION", "vectors"}}; // which a camera alone would do without
    auto recorder = makeRecorder(e, needsOf(scene), settings);
    auto frames = renderFrames(e.gpu, renderer, 0, e.plan.frames, reprise::JitterSequence::halton16, true);
    const auto ids = movingIds(scene);
    StaticAndMoving errors;
    for (uint32_t index = 0; index < frames.size(); ++index) {
        RenderedFrame& frame = frames[index];
        const auto objects = renderer.movingObjects(static_cast<int>(index));
        reprise::FrameInput input;
        input.frameIndex = index;
        input.camera = frame.camera;
        input.jitterPx = frame.jitterPx;
        input.colour = frame.colour.ref;
        input.depth = frame.depth.ref;
        input.depthAttachment = frame.depthTest.ref;
        input.movingObjects = objects;
        reprise::ImageRef motion;
        e.gpu.run([&](VkCommandBuffer commands) {
            auto recorded = recorder.record(commands, input);
            if (!recorded) throw std::runtime_error(recorded.error().message);
            if (!recorded->motion)
                throw std::runtime_error("The frame plan wrote no motion for the report to measure");
            motion = *recorded->motion;
        });
        // The first frame has no previous camera, and a cut's previous camera is no motion.
        if (index == 0 || static_cast<int>(index) == scene.cutFrame) continue;
        harness::Image image = borrowed(motion);
        compareMotion(e.gpu, frame, image, ids, errors);
    }
    return errors;
}

std::string fileOf(const reprisec::Pack& pack, std::string_view technique, Stage stage) {
    const auto variant = reprise::makeVariant(pack.passes(), technique);
    if (!variant) throw std::runtime_error(variant.error().message);
    return reprise::spirvFileName(*variant, stage);
}

Row velocityRow(Experiment& e, std::string_view technique, const std::string& scene, Stage stage,
                const MotionError& error) {
    Row row;
    row.technique = technique;
    row.variant = "default";
    row.scene = scene;
    row.stage = stageText(stage);
    row.file = fileOf(e.shaders.pack(), technique, stage);
    row.jitter = "halton16";
    row.width = e.plan.timingSize.width;
    row.height = e.plan.timingSize.height;
    row.errorWidth = e.plan.errorSize.width;
    row.errorHeight = e.plan.errorSize.height;
    row.frames = e.plan.frames;
    row.errorUnit = "pixels";
    row.reference = "motion that the renderer computes per vertex";
    row.notFinite = error.notFinite;
    row.rmsePerFrame = error.rmsePerFrame;
    if (error.count > 0 && error.notFinite == 0) {
        row.error.rmse = std::sqrt(error.sum / static_cast<double>(error.count));
        row.error.max = error.max;
    }
    return row;
}

} // namespace

void measureVelocity(Experiment& e, scenes::Renderer& renderer) {
    if (e.plan.timingOnly || e.plan.frames < 2) return;
    const scenes::Scene& scene = renderer.scene();
    for (Stage stage : e.plan.stages) {
        const StaticAndMoving errors = runVelocity(e, renderer, stage);
        if (e.plan.has("camera_velocity"))
            e.report.rows.push_back(velocityRow(e, "camera_velocity", scene.name, stage, errors.fixed));
        if (e.plan.has("object_velocity") && !movingIds(scene).empty() && stage == e.plan.stages.front())
            e.report.rows.push_back(
                velocityRow(e, "object_velocity", scene.name, Stage::fragment, errors.moving));
    }
    e.progress.step(e.plan.frames, scene.name + ", motion");
}

} // namespace report
