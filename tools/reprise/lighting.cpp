// SPDX-License-Identifier: Apache-2.0
// Errors of the framework on the scenes made for it, against ray casting and against what the technique
// itself converges to.
#include "experiment.hpp"
#include "lighting_rows.hpp"
#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Stage;

// One channel of a frame, a value per pixel.
using Values = std::vector<float>;

// What is true of a frame. A frame that looks like the one before shares it.
struct TrueFrame {
    std::shared_ptr<const Values> values;
    std::shared_ptr<const std::vector<uint8_t>> counts; // pixels that are compared
    std::shared_ptr<const Values> depth;                // linear, metres
};

// A scene that stands still but for its event changes there alone.
bool looksLikeTheFrameBefore(const scenes::Scene& scene, uint32_t frame) {
    if (frame == 0 || scene.cameraMoves) return false;
    return scene.eventFrame >= 0 ? static_cast<int>(frame) != scene.eventFrame : !objectsMove(scene);
}

// An event needs frames after it for what it leaves to fade.
constexpr uint32_t framesAfterEvent = 28;

uint32_t framesOf(const scenes::Scene& scene, const Plan& plan) {
    return scene.eventFrame < 0
               ? plan.frames
               : std::max(plan.frames, static_cast<uint32_t>(scene.eventFrame) + framesAfterEvent);
}

// Frames that are compared: all where truth is cheap, else the last few.
std::vector<uint32_t> comparedFrames(const scenes::Scene& scene, const Plan& plan) {
    std::vector<uint32_t> frames;
    const uint32_t count = framesOf(scene, plan),
                   last = count > plan.truthFrames ? count - plan.truthFrames : 0;
    for (uint32_t frame = 0; frame < count; ++frame)
        if (frame >= last || (!scene.cameraMoves && (scene.eventFrame >= 0 || !objectsMove(scene))))
            frames.push_back(frame);
    return frames;
}

using Truth = std::vector<std::optional<TrueFrame>>;

TrueFrame trueFrame(RayTruth& rays, Cached cached, int frame, PixelGrid grid, const Plan& plan) {
    TrueFrame made;
    const Values depth = rays.linearDepth(frame, grid);
    std::vector<uint8_t> counts(depth.size());
    for (size_t i = 0; i < depth.size(); ++i)
        counts[i] = depth[i] < skyLinearDepth ? 1 : 0;
    if (cached == Cached::occlusion) {
        made.values = std::make_shared<Values>(rays.occlusion(
            frame, grid,
            {.radius = double(occlusionRadius), .rays = plan.truthRays, .falloff = Falloff::quadratic}));
    } else {
        SunTruth sun = rays.sun(frame, grid, {.discRadians = sunDiscRadians, .rays = plan.truthRays});
        for (size_t i = 0; i < counts.size(); ++i)
            counts[i] = counts[i] && sun.facesSun[i] ? 1 : 0;
        made.values = std::make_shared<Values>(std::move(sun.visibility));
    }
    made.counts = std::make_shared<std::vector<uint8_t>>(std::move(counts));
    made.depth = std::make_shared<Values>(depth);
    return made;
}

Truth castTruth(Experiment& e, const scenes::Scene& scene, Cached cached) {
    RayTruth rays(scene);
    Truth truth(framesOf(scene, e.plan));
    const PixelGrid grid{e.plan.errorSize.width, e.plan.errorSize.height};
    for (const uint32_t frame : comparedFrames(scene, e.plan)) {
        const bool same = looksLikeTheFrameBefore(scene, frame) && truth[frame - 1];
        truth[frame] = same ? truth[frame - 1]
                            : std::optional(trueFrame(rays, cached, static_cast<int>(frame), grid, e.plan));
        e.progress.step(same ? 0.0 : workPerTruth, scene.name + ", ground truth by rays");
    }
    return truth;
}

// --- Rows

Values channelOf(const std::vector<float>& texels, size_t channel, uint32_t channels) {
    Values values;
    for (size_t i = channel; i < texels.size(); i += channels)
        values.push_back(texels[i]);
    return values;
}

// A row in the making: its recorder, and a channel's values frame by frame.
struct Run {
    LightingSpec spec;
    Stage stage;
    reprise::FrameRecorder recorder;
    std::vector<std::vector<Values>> channels; // by technique, by frame
};

void recordFrame(Experiment& e, Run& run, const reprise::FrameInput& frame) {
    reprise::FrameInput input = frame;
    input.cache = run.spec.tuning;
    reprise::ImageRef lighting;
    e.gpu.run([&](VkCommandBuffer commands) {
        auto recorded = run.recorder.record(commands, input);
        if (!recorded) throw std::runtime_error(recorded.error().message);
        lighting = recorded->lighting.value();
    });
    harness::Image image = borrowed(lighting);
    const auto texels = e.gpu.downloadFloats(image);
    for (size_t channel = 0; channel < run.channels.size(); ++channel)
        run.channels[channel].push_back(channelOf(texels, channel, harness::channelCount(lighting.format)));
}

std::vector<Run> makeRuns(Experiment& e, const scenes::Scene& scene) {
    std::vector<Run> runs;
    for (const Cached cached : cachedOf(e.plan))
        for (const Stage stage : e.plan.stages)
            for (const LightingSpec& spec : lightingRows(cached, e.plan.quick))
                runs.push_back({spec, stage, makeRecorder(e, needsOf(spec, scene), settingsOf(spec, stage)),
                                std::vector<std::vector<Values>>(measuredBy(spec).size())});
    return runs;
}

// Frame by frame, because the renderer has one shadow map.
void recordFrames(Experiment& e, const scenes::Scene& scene, std::vector<Run>& runs) {
    scenes::Renderer renderer(e.gpu, scene, e.plan.errorSize.width, e.plan.errorSize.height);
    for (uint32_t index = 0; index < framesOf(scene, e.plan); ++index) {
        auto rendered = renderFrames(e.gpu, renderer, index, 1, reprise::JitterSequence::none);
        const scenes::ShadowMap shadows = renderer.shadowMap(static_cast<int>(index));
        reprise::FrameInput input;
        input.frameIndex = index;
        input.camera = rendered.front().camera;
        input.depth = rendered.front().depth.ref;
        input.motion = rendered.front().motion.ref;
        input.shadowMap = shadows.image->ref;
        input.cascades = shadows.cascades;
        for (Run& run : runs)
            recordFrame(e, run, input);
        e.progress.step(static_cast<double>(runs.size()), scene.name + ", lighting");
    }
}

// Of the pixels that count.
Values picked(const Values& values, const std::vector<uint8_t>& counts) {
    Values result;
    for (size_t i = 0; i < values.size(); ++i)
        if (counts[i]) result.push_back(values[i]);
    return result;
}

std::vector<uint8_t> shared(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b) {
    std::vector<uint8_t> result(a.size());
    std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::bit_and<>());
    return result;
}

// Frames until what the event changed has come to within a tenth of where it ends, in the mean over the
// pixels whose truth changed by more than a tenth, of those whose depth changed too or of the others; nothing
// where there are none.
std::optional<double> trailingFrames(const scenes::Scene& scene, const Truth& truth,
                                     const std::vector<Values>& frames, bool depthChanges) {
    const auto event = static_cast<size_t>(scene.eventFrame);
    if (scene.eventFrame < 1 || event + 1 >= frames.size() || !truth[event - 1] || !truth[event]) return {};
    const Values &before = *truth[event - 1]->values, &after = *truth[event]->values;
    const Values &near = *truth[event - 1]->depth, &far = *truth[event]->depth;
    double start = 0.0;
    std::vector<double> left(frames.size() - event);
    for (size_t i = 0; i < before.size(); ++i) {
        if (!(*truth[event]->counts)[i] || std::abs(after[i] - before[i]) <= 0.1f) continue;
        if ((std::abs(far[i] - near[i]) > 0.01f * far[i]) != depthChanges) continue;
        const double sign = after[i] > before[i] ? 1.0 : -1.0, end = frames.back()[i];
        start += sign * (end - double(frames[event - 1][i]));
        for (size_t k = 0; k < left.size(); ++k)
            left[k] += sign * (end - double(frames[event + k][i]));
    }
    if (start <= 0.0) return {};
    size_t last = 0; // the last frame that is still farther away
    for (size_t k = 0; k < left.size(); ++k)
        if (std::abs(left[k]) > 0.1 * start) last = k + 1;
    return static_cast<double>(last);
}

void addErrors(Row& row, const scenes::Scene& scene, const Truth& truth, const std::vector<Values>& frames) {
    double sum = 0.0, largest = 0.0;
    size_t count = 0;
    Flicker flicker;
    const size_t first = std::min<size_t>(warmUpFrames, frames.size() - 1);
    for (size_t frame = 0; frame < frames.size(); ++frame) {
        row.notFinite += countNotFinite(frames[frame]);
        if (!truth[frame]) continue;
        const Values test = picked(frames[frame], *truth[frame]->counts);
        const Values reference = picked(*truth[frame]->values, *truth[frame]->counts);
        const Difference d = difference(reference, test);
        row.rmsePerFrame.push_back(d.rmse);
        const bool settled = frame >= first;
        if (settled) {
            sum += d.rmse;
            largest = std::max(largest, d.max);
            ++count;
        }
        if (!settled || frame == 0 || !truth[frame - 1]) continue;
        const auto both = shared(*truth[frame - 1]->counts, *truth[frame]->counts);
        flicker.add(picked(*truth[frame - 1]->values, both), picked(*truth[frame]->values, both),
                    picked(frames[frame - 1], both), picked(frames[frame], both));
    }
    if (row.notFinite > 0 || count == 0) return;
    row.error.rmse = sum / static_cast<double>(count);
    row.error.max = largest;
    if (frames.size() > first + 1) row.error.flicker = flicker.value();
    row.trailingFrames = trailingFrames(scene, truth, frames, false);
    row.rejectedFrames = trailingFrames(scene, truth, frames, true);
}

// Visibility as grey: the eye sees it as evenly as the numbers run.
Picture greyPicture(const Values& values, Size size) {
    Picture picture{size.width, size.height, {}};
    for (const float value : values)
        picture.rgb.insert(picture.rgb.end(), 3, std::pow(std::clamp(value, 0.0f, 1.0f), 2.2f));
    return picture;
}

} // namespace

Row lightingRow(Experiment& e, const LightingSpec& spec, Cached measured, Stage stage,
                const std::string& scene) {
    Row row;
    row.technique = cachedName(measured);
    row.variant = spec.label;
    row.scene = scene;
    row.stage = stageText(stage);
    row.jitter = "none";
    row.width = e.plan.timingSize.width;
    row.height = e.plan.timingSize.height;
    row.errorWidth = e.plan.errorSize.width;
    row.errorHeight = e.plan.errorSize.height;
    row.frames = e.plan.frames;
    row.errorUnit = "visibility";
    row.reference = fmt::format("{} rays a pixel", e.plan.truthRays);
    return row;
}

double lightingWork(const Plan& plan) {
    if (plan.timingOnly || !plan.hasLighting()) return 0.0;
    double work = 0.0;
    for (const scenes::Scene& scene : plan.lightingScenes)
        for (const Cached cached : cachedOf(plan)) {
            work += static_cast<double>(lightingRows(cached, plan.quick).size() * plan.stages.size()) *
                    framesOf(scene, plan);
            if (cached == Cached::both) continue;
            for (const uint32_t frame : comparedFrames(scene, plan))
                work += looksLikeTheFrameBefore(scene, frame) ? 0.0 : workPerTruth;
        }
    return work;
}

void measureLighting(Experiment& e, const scenes::Scene& scene) {
    if (e.plan.timingOnly) return;
    auto runs = makeRuns(e, scene);
    recordFrames(e, scene, runs);
    const uint32_t last = framesOf(scene, e.plan) - 1;
    for (const Cached measured : {Cached::occlusion, Cached::shadow}) {
        if (!e.plan.has(cachedName(measured))) continue;
        const Truth truth = castTruth(e, scene, measured);
        const auto keep = [&](const std::string& name, const Values& values) {
            keepPicture(e.report, scene.name, cachedName(measured) + ", " + name,
                        greyPicture(values, e.plan.errorSize), last);
        };
        keep("truth", *truth.back()->values);
        for (const Run& run : runs) {
            const auto techniques = measuredBy(run.spec);
            const auto found = std::ranges::find(techniques, measured);
            if (found == techniques.end()) continue;
            const auto& frames = run.channels[static_cast<size_t>(found - techniques.begin())];
            Row row = lightingRow(e, run.spec, measured, run.stage, scene.name);
            row.frames = last + 1;
            addErrors(row, scene, truth, frames);
            if (isChiefLighting(run.spec.label)) keep(run.spec.label, frames.back());
            e.report.rows.push_back(std::move(row));
        }
    }
}

} // namespace report
