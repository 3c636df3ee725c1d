// SPDX-License-Identifier: Apache-2.0
#include "experiment.hpp"
#include "parallel.hpp"
#include "rotations.hpp"

#include "reprise/frame.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Stage;

// What a row's pictures are measured against, and where its input comes from.
struct SceneData {
    const GroundTruth& truth;
    std::vector<RenderedFrame>& frames; // of the row's sample sequence
    int cutFrame;
};

reprise::Settings settingsOf(const reprise::Variant& variant, Stage stage, std::string_view preset) {
    // Every switch is set by hand: a report runs exactly the variant that its row names.
    reprise::Settings settings;
    settings.stage = stage;
    settings.preset = preset;
    for (size_t i = 0; i < variant.pass->switches.size(); ++i) {
        const auto& info = variant.pass->switches[i];
        settings.overrides.push_back({info.name, info.values[variant.values[i]]});
    }
    return settings;
}

reprise::SceneNeeds needsOfReport() {
    reprise::SceneNeeds needs;
    needs.engineWritesMotion = true; // the renderer's exact motion: this measures temporal_aa alone
    needs.fastMotion = true;
    return needs;
}

std::vector<Picture> runVariant(Experiment& e, const RowSpec& spec, Stage stage, SceneData& data) {
    reprise::FrameRecorder recorder =
        makeRecorder(e, needsOfReport(), settingsOf(*spec.variant, stage, spec.preset));
    std::vector<Picture> pictures;
    for (uint32_t index = 0; index < data.frames.size(); ++index) {
        RenderedFrame& frame = data.frames[index];
        reprise::FrameInput input;
        input.frameIndex = index;
        input.camera = frame.camera;
        input.jitterPx = frame.jitterPx;
        input.colour = frame.colour.ref;
        input.depth = frame.depth.ref;
        input.motion = frame.motion.ref;
        input.resetHistory = spec.cutIsTold && static_cast<int>(index) == data.cutFrame;
        reprise::ImageRef output;
        e.gpu.run([&](VkCommandBuffer commands) {
            auto recorded = recorder.record(commands, input);
            if (!recorded) throw std::runtime_error(recorded.error().message);
            output = recorded->colour;
        });
        harness::Image image = borrowed(output);
        pictures.push_back(displayPicture(e.gpu, image));
    }
    return pictures;
}

std::vector<Picture> runNone(Experiment& e, SceneData& data) {
    std::vector<Picture> pictures;
    for (RenderedFrame& frame : data.frames)
        pictures.push_back(displayPicture(e.gpu, frame.colour));
    return pictures;
}

double meanAfterWarmUp(const std::vector<double>& values) {
    const size_t first = std::min<size_t>(warmUpFrames, values.size() - 1);
    return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(first), values.end(), 0.0) /
           static_cast<double>(values.size() - first);
}

void addErrors(Row& row, const std::vector<Picture>& pictures, const GroundTruth& truth) {
    for (const Picture& picture : pictures)
        row.notFinite += countNotFinite(picture.rgb);
    if (row.notFinite > 0) return; // a mean over NaN would be a number that says nothing
    const size_t n = pictures.size(), first = std::min<size_t>(warmUpFrames, n - 1);
    row.flipPerFrame.resize(n);
    row.rmsePerFrame.resize(n);
    std::vector<double> max(n);
    parallelFor(n, [&](size_t i) {
        row.flipPerFrame[i] = flipMean(truth.flipSides[i], flipSide(pictures[i]));
        const Difference d = difference(truth.pictures[i].rgb, pictures[i].rgb);
        row.rmsePerFrame[i] = d.rmse;
        max[i] = d.max;
    });
    Flicker flicker;
    for (size_t i = first + 1; i < n; ++i)
        flicker.add(truth.pictures[i - 1].rgb, truth.pictures[i].rgb, pictures[i - 1].rgb, pictures[i].rgb);
    row.error.flip = meanAfterWarmUp(row.flipPerFrame);
    row.error.rmse = meanAfterWarmUp(row.rmsePerFrame);
    row.error.max = *std::max_element(max.begin() + static_cast<std::ptrdiff_t>(first), max.end());
    if (n > first + 1) row.error.flicker = flicker.value();
}

uint64_t memoryOf(Experiment& e, const reprise::Variant& variant, Stage stage) {
    const auto& pack = e.shaders.pack();
    const auto plan = reprise::plan(pack.passes(), pack.presets("temporal_aa"), needsOfReport(),
                                    settingsOf(variant, stage, "inside"),
                                    {e.plan.timingSize.width, e.plan.timingSize.height});
    if (!plan) throw std::runtime_error(plan.error().message);
    return plan->bytes;
}

Row rowFor(Experiment& e, const RowSpec& spec, Stage stage, const std::string& scene) {
    Row row;
    row.technique = "temporal_aa";
    row.variant = spec.label;
    row.scene = scene;
    row.jitter = jitterName(spec.jitter);
    row.frames = e.plan.timingOnly ? 0 : e.plan.frames;
    row.width = e.plan.timingSize.width;
    row.height = e.plan.timingSize.height;
    row.errorWidth = e.plan.errorSize.width;
    row.errorHeight = e.plan.errorSize.height;
    row.errorUnit = "display";
    row.reference = fmt::format("{} jittered samples per pixel of the same frame", e.plan.truthSamples);
    if (spec.variant) {
        row.stage = stageText(stage);
        row.file = reprise::spirvFileName(*spec.variant, stage);
        row.memoryBytes = memoryOf(e, *spec.variant, stage);
    } else {
        row.memoryBytes = 0;
        row.readsPerPixel = 0.0;
    }
    return row;
}

bool isPictured(const RowSpec& spec, const reprisec::Pack& pack) {
    if (!spec.variant) return true;
    const auto presets = pack.presets("temporal_aa");
    return std::any_of(presets.begin(), presets.end(), [&](const auto& p) { return p.name == spec.label; });
}

void measureRow(Experiment& e, const RowSpec& spec, Stage stage, const std::string& scene, SceneData& data) {
    Row row = rowFor(e, spec, stage, scene);
    const auto pictures = spec.variant ? runVariant(e, spec, stage, data) : runNone(e, data);
    addErrors(row, pictures, data.truth);
    if (isPictured(spec, e.shaders.pack()))
        keepPicture(e.report, scene, spec.label, pictures.back(), static_cast<uint32_t>(pictures.size() - 1));
    e.progress.step(static_cast<double>(pictures.size()), scene + ", " + spec.label);
    e.report.rows.push_back(std::move(row));
}

// "none" has no stage and stands once.
std::vector<std::pair<RowSpec, Stage>> rowsOf(const Plan& plan, const Shaders& shaders,
                                              const scenes::Scene& scene) {
    std::vector<std::pair<RowSpec, Stage>> rows;
    for (Stage stage : plan.stages)
        for (RowSpec& spec : temporalRows(shaders.pack(), stage, plan.flipped)) {
            const bool again = !spec.variant && stage != plan.stages.front();
            const bool noCut =
                !spec.cutIsTold && (scene.cutFrame < 0 || scene.cutFrame >= static_cast<int>(plan.frames));
            const bool otherScene = spec.cameraAlone && !cameraMovesAlone(scene);
            if (!again && !noCut && !otherScene) rows.emplace_back(std::move(spec), stage);
        }
    return rows;
}

} // namespace

// The first picture of a name is the one that is kept.
void keepPicture(Report& report, const std::string& scene, const std::string& name, const Picture& picture,
                 uint32_t frame) {
    auto found = std::find_if(report.pictures.begin(), report.pictures.end(),
                              [&](const Pictures& p) { return p.scene == scene; });
    if (found == report.pictures.end()) {
        report.pictures.push_back({.scene = scene, .frame = frame, .png = {}});
        found = std::prev(report.pictures.end());
    }
    if (!found->png.contains(name)) found->png[name] = pngOf(picture);
}

bool Plan::has(std::string_view technique) const {
    return std::find(techniques.begin(), techniques.end(), technique) != techniques.end();
}

bool Plan::hasLighting() const {
    return has("occlusion") || has("shadow");
}

reprise::FrameRecorder makeRecorder(Experiment& e, const reprise::SceneNeeds& needs,
                                    const reprise::Settings& settings) {
    auto recorder = reprise::FrameRecorder::create(
        e.gpu.device(), e.shaders.pack().passes(), e.shaders.source(),
        {.needs = needs, .settings = settings, .extent = {e.plan.errorSize.width, e.plan.errorSize.height}});
    if (!recorder) throw std::runtime_error(recorder.error().message);
    return std::move(*recorder);
}

double plannedWork(const Plan& plan, const Shaders& shaders) {
    const double timing = workPerTimingRound * (plan.rounds + 1);
    if (plan.timingOnly) return timing;
    double work = timing;
    for (const scenes::Scene& scene : plan.scenes) {
        if (plan.has("temporal_aa"))
            work += static_cast<double>(plan.frames) *
                    (plan.truthSamples + static_cast<double>(rowsOf(plan, shaders, scene).size()));
        if (plan.has("camera_velocity") || plan.has("object_velocity")) work += plan.frames;
    }
    return work + lightingWork(plan) + rotationsWork(plan);
}

void measureTemporal(Experiment& e, scenes::Renderer& renderer) {
    const scenes::Scene& scene = renderer.scene();
    const auto rows = rowsOf(e.plan, e.shaders, scene);
    if (e.plan.timingOnly) {
        for (const auto& [spec, stage] : rows)
            e.report.rows.push_back(rowFor(e, spec, stage, scene.name));
        return;
    }
    const GroundTruth truth = renderGroundTruth(renderer, e.plan.errorSize.width, e.plan.errorSize.height,
                                                e.plan.frames, e.plan.truthSamples, e.progress);
    keepPicture(e.report, scene.name, "truth", truth.pictures.back(), e.plan.frames - 1);
    const size_t firstRow = e.report.rows.size();
    std::map<reprise::JitterSequence, std::vector<const std::pair<RowSpec, Stage>*>> bySequence;
    for (const auto& row : rows)
        bySequence[row.first.jitter].push_back(&row);
    for (const auto& [jitter, members] : bySequence) {
        std::vector<RenderedFrame> frames = renderFrames(e.gpu, renderer, 0, e.plan.frames, jitter);
        SceneData data{truth, frames, scene.cutFrame};
        for (const auto* row : members)
            measureRow(e, row->first, row->second, scene.name, data);
    }
    // Measured by sequence, shown in the order of the table.
    const auto place = [&](const Row& row) {
        return std::find_if(rows.begin(), rows.end(), [&](const auto& r) {
            return r.first.label == row.variant && (row.stage.empty() || row.stage == stageText(r.second));
        });
    };
    std::stable_sort(e.report.rows.begin() + static_cast<std::ptrdiff_t>(firstRow), e.report.rows.end(),
                     [&](const Row& a, const Row& b) { return place(a) < place(b); });
}

} // namespace report
