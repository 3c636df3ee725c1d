// SPDX-License-Identifier: Apache-2.0
#include "commands.hpp"
#include "lighting_rows.hpp"
#include "page.hpp"
#include "rotations.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

Json deviceJson(const harness::Gpu& gpu) {
    return {{"name", gpu.name()}, {"driver", gpu.driver()}, {"type", gpu.type()}};
}

std::string sizeText(Size size) {
    return fmt::format("{}x{}", size.width, size.height);
}

Json settingsJson(const Plan& plan, const reprisec::Pack& pack, bool quick) {
    Json scenes = Json::array(), stages = Json::array();
    std::set<std::string> named;
    for (const auto* list : {&plan.scenes, &plan.lightingScenes})
        for (const scenes::Scene& scene : *list)
            if (named.insert(scene.name).second)
                scenes.push_back({{"name", scene.name},
                                  {"shows", scene.shows},
                                  {"cut_frame", scene.cutFrame},
                                  {"event_frame", scene.eventFrame},
                                  {"notes", scene.notes}});
    for (reprise::Stage stage : plan.stages)
        stages.push_back(stageText(stage));
    return {{"quick", quick},
            {"timing_only", plan.timingOnly},
            {"scenes", scenes},
            {"techniques", plan.techniques},
            {"presets", presetLabels(pack)},
            {"chief_lighting", plan.hasLighting() ? Json(std::vector<std::string>(chiefLighting().begin(),
                                                                                  chiefLighting().end()))
                                                  : Json::array()},
            {"stages", stages},
            {"error_size", sizeText(plan.errorSize)},
            {"timing_size", sizeText(plan.timingSize)},
            {"frames", plan.frames},
            {"warm_up_frames", warmUpFrames},
            {"truth_samples", plan.truthSamples},
            {"truth_rays", plan.truthRays},
            {"occlusion_radius_metres", occlusionRadius},
            {"timing_rounds", plan.rounds},
            {"flip_pixels_per_degree", flipPixelsPerDegree},
            {"display", "x / (1 + x) per channel of linear colour; FLIP of its sRGB encoding"}};
}

std::string cell(const std::optional<double>& value, int digits) {
    return value ? fmt::format("{:.{}f}", *value, digits) : std::string("-");
}

void printRow(const Row& r) {
    const std::optional<double> ms = r.gpu ? std::optional(r.gpu->median) : std::nullopt;
    fmt::print("{:<15} {:<38} {:<9} {:>9} {:>6} {:>5} {:>8} {:>8} {:>8}{}\n", r.scene.substr(0, 15),
               (r.technique == "temporal_aa" ? "" : r.technique + " ") + r.variant, r.stage, cell(ms, 3),
               cell(r.perNineTaps, 2), cell(r.efficiency, 2), cell(r.error.flip, 4), cell(r.error.rmse, 4),
               cell(r.error.flicker, 4), r.pareto.value_or(false) ? "  front" : "");
}

// What a reader of the terminal wants first; the files always have all.
bool isChief(const Row& row, const reprisec::Pack& pack) {
    if (row.errorUnit == "visibility") return isChiefLighting(row.variant);
    if (row.pareto.value_or(false) || row.variant == "none" || row.technique != "temporal_aa") return true;
    const auto presets = presetLabels(pack);
    return std::find(presets.begin(), presets.end(), row.variant) != presets.end();
}

void printRows(const Report& report, const reprisec::Pack& pack, bool all) {
    fmt::print("{:<15} {:<38} {:<9} {:>9} {:>6} {:>5} {:>8} {:>8} {:>8}\n", "scene", "variant", "stage", "ms",
               "/nine", "eff.", "FLIP", "RMSE", "flicker");
    size_t left = 0;
    for (const Row& row : report.rows) {
        if (all || isChief(row, pack))
            printRow(row);
        else
            ++left;
    }
    if (left > 0) fmt::print("{} more rows: --all-rows prints them, the files have them\n", left);
}

std::string_view verdict(const Claim& claim) {
    if (claim.holds) return *claim.holds ? "holds" : "does not hold";
    return claim.measured.is_object() && claim.measured.contains("not applicable") ? "not applicable"
                                                                                   : "not measured";
}

void printReport(const Report& report) {
    fmt::print("\n");
    for (const Floor& floor : report.floors)
        fmt::print("floor {:<22} {:>9.3f} ms {:>8.2f} ns/pixel\n", floor.name, floor.gpu.median,
                   floor.nsPerPixel);
    fmt::print("\n");
    for (const Claim& claim : report.claims)
        fmt::print("{:<16} {:<14} {}\n", claim.id, verdict(claim), claim.claim);
}

void measure(Experiment& e) {
    for (const scenes::Scene& scene : e.plan.scenes) {
        scenes::Renderer renderer(e.gpu, scene, e.plan.errorSize.width, e.plan.errorSize.height);
        if (e.plan.has("temporal_aa")) measureTemporal(e, renderer);
        if (e.plan.has("camera_velocity") || e.plan.has("object_velocity")) measureVelocity(e, renderer);
    }
    if (e.plan.hasLighting())
        for (const scenes::Scene& scene : e.plan.lightingScenes)
            measureLighting(e, scene);
    measureRotations(e);
    measureTimes(e);
}

uint64_t countNotFinite(const Report& report) {
    uint64_t count = 0;
    for (const Row& row : report.rows)
        count += row.notFinite;
    return count;
}

} // namespace

void reportCommand(const ReportOptions& options) {
    checkWritable(options.out);
    Shaders shaders(findAssets(), options.fresh);
    const Plan plan = makePlan(options, shaders.pack());
    harness::Gpu gpu({.device = options.device});
    Report report;
    report.device = deviceJson(gpu);
    report.settings = settingsJson(plan, shaders.pack(), options.quick);
    for (const scenes::Scene& scene : plan.scenes)
        printNotes(scene);
    Progress progress(plannedWork(plan, shaders));
    Experiment experiment{gpu, shaders, plan, progress, report};
    measure(experiment);
    progress.finish();
    markPareto(report.rows);
    report.claims = judgeClaims(report, plan);
    writeReport(report, options.out);
    printRows(report, shaders.pack(), options.allRows);
    printReport(report);
    fmt::print("\n{}\n", (std::filesystem::absolute(options.out) / "index.html").lexically_normal().string());
    if (const uint64_t bad = countNotFinite(report); bad > 0)
        throw std::runtime_error(fmt::format("{} values of the output are NaN or infinite: rows with "
                                             "not_finite above 0 in the report name the passes",
                                             bad));
}

} // namespace report
