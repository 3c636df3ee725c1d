// SPDX-License-Identifier: Apache-2.0
// What the documents claim, held against the rows. A claim that the rows contradict says so.
#include "lighting_claims.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

namespace report {
namespace {

using Figure = std::optional<double> Errors::*;

class Judge {
public:
    Judge(const Report& report, const Plan& plan)
        : report_(report), stage_(stageText(plan.stages.front())), plan_(plan) {}

    const Row* row(std::string_view technique, std::string_view variant, std::string_view scene) const {
        return row(technique, variant, scene, technique == "object_velocity" ? "fragment" : stage_);
    }
    const Row* row(std::string_view technique, std::string_view variant, std::string_view scene,
                   std::string_view stage) const {
        for (const Row& r : report_.rows)
            if (r.technique == technique && r.variant == variant && r.scene == scene &&
                (r.stage.empty() || r.stage == stage))
                return &r;
        return nullptr;
    }

    std::optional<double> error(std::string_view variant, std::string_view scene, Figure figure) const {
        const Row* found = row("temporal_aa", variant, scene);
        return found ? found->error.*figure : std::nullopt;
    }

    // `with` has less error than `without` on `scene`, or on the user's own where that is not in the report.
    Claim lowers(std::string id, std::string text, std::string published, std::string_view scene,
                 std::string_view with, std::string_view without, Figure figure,
                 std::string_view unit) const {
        Claim claim{std::move(id), "INSIDE", std::move(text), std::move(published), nullptr, {}};
        const std::string where = hasScene(scene) ? std::string(scene) : plan_.scenes.front().name;
        const auto a = error(with, where, figure), b = error(without, where, figure);
        if (!a || !b) return claim;
        claim.measured = {
            {"scene", where}, {"measure", unit}, {std::string(with), *a}, {std::string(without), *b}};
        claim.holds = *a < *b;
        return claim;
    }

    bool hasScene(std::string_view name) const {
        return std::any_of(plan_.scenes.begin(), plan_.scenes.end(),
                           [&](const auto& s) { return s.name == name; });
    }

    const Plan& plan() const { return plan_; }
    const std::string& stage() const { return stage_; }
    const Report& report() const { return report_; }
    bool onCpu() const { return report_.device.value("type", "") == "cpu"; }

private:
    const Report& report_;
    std::string stage_;
    const Plan& plan_;
};

// Judged without motion alone: a camera that moves samples other places by itself.
Claim jitter(const Judge& judge) {
    const auto& scenes = judge.plan().scenes;
    const auto still =
        std::find_if(scenes.begin(), scenes.end(), [](const auto& scene) { return !scene.cameraMoves; });
    const std::string where = still == scenes.end() ? std::string() : still->name;
    Claim claim =
        judge.lowers("I1", "With a camera that stands still, jittering the frustum lowers the error", "",
                     judge.hasScene("static_camera") ? "static_camera" : where, "inside",
                     "inside, jitter none", &Errors::flip, "FLIP");
    if (still != scenes.end()) return claim;
    claim.holds.reset();
    claim.measured = {{"not applicable", "needs a scene whose camera stands still"}};
    return claim;
}

Claim sequences(const Judge& judge) {
    Claim claim{
        "I10",
        "INSIDE",
        "Of the sample sequences, 16 points of Halton (2,3) have the least error with 3x3 and clipping",
        "chosen by eye over uniform4 helix and 8 points",
        nullptr,
        {}};
    const std::string scene =
        judge.hasScene("thin_geometry") ? "thin_geometry" : judge.plan().scenes.front().name;
    const auto best = judge.error("inside", scene, &Errors::flip);
    if (!best) return claim;
    claim.measured = {{"scene", scene}, {"measure", "FLIP"}, {"halton16", *best}};
    claim.holds = true;
    for (const char* name : {"uniform4_helix", "halton8", "none"}) {
        const auto other = judge.error(fmt::format("inside, jitter {}", name), scene, &Errors::flip);
        if (!other) continue;
        claim.measured[name] = *other;
        claim.holds = *claim.holds && *best <= *other;
    }
    return claim;
}

Claim motion(const Judge& judge, std::string id, std::string_view technique, std::string text,
             double boundPx) {
    Claim claim{std::move(id), "INSIDE", std::move(text), fmt::format("RMSE at most {} pixel", boundPx),
                nullptr,       {}};
    double worst = -1.0;
    std::string where;
    for (const auto& scene : judge.plan().scenes) {
        const Row* row = judge.row(technique, "default", scene.name);
        if (!row || !row->error.rmse || *row->error.rmse <= worst) continue;
        worst = *row->error.rmse;
        where = scene.name;
    }
    claim.published.reset(); // the document gives no figure; the bound is the report's
    if (worst < 0.0) return claim;
    claim.measured = {{"worst scene", where}, {"RMSE in pixels", worst}, {"bound", boundPx}};
    claim.holds = worst <= boundPx;
    return claim;
}

// Better in both measures and no slower on at least four scenes of five; a scene with a cut is named apart.
Claim bestAgainstInside(const Judge& judge) {
    Claim claim{
        "best",
        "Reprise",
        "The best preset has less FLIP and less flicker than the document's at no more time, on four of five "
        "scenes (one with a camera cut is named apart)",
        {},
        nullptr,
        {}};
    int better = 0, scenes = 0;
    std::string lost, cut;
    for (const auto& scene : judge.plan().scenes) {
        const Row *best = judge.row("temporal_aa", "best", scene.name),
                  *inside = judge.row("temporal_aa", "inside", scene.name);
        const auto measured = [](const Row* row) {
            return row && row->error.flip && row->error.flicker && row->gpu;
        };
        if (!measured(best) || !measured(inside)) continue;
        const bool wins = *best->error.flip < *inside->error.flip &&
                          *best->error.flicker < *inside->error.flicker &&
                          best->gpu->median <= inside->gpu->median;
        if (scene.cutFrame >= 0) {
            cut += scene.name + (wins ? ": yes" : ": no");
            continue;
        }
        ++scenes;
        if (wins)
            ++better;
        else
            lost += (lost.empty() ? "" : ", ") + scene.name;
    }
    if (scenes == 0) return claim;
    claim.measured = {{"scenes won", better}, {"of", scenes}, {"stage", judge.stage()}};
    if (!cut.empty()) claim.measured["with a camera cut"] = cut;
    if (!lost.empty()) claim.measured["not on"] = lost;
    claim.holds = 5 * better >= 4 * scenes;
    return claim;
}

// A bound on the time of a setting, stated for one kind of device and one form.
struct Bar {
    std::string id, claim, measure;
    std::optional<double> Row::*figure;
    double most;
    bool forCpu;
    std::string stage, variant = "lean";
};

Claim within(const Judge& judge, const Bar& bar) {
    Claim claim{bar.id, "Reprise", bar.claim, {}, nullptr, {}};
    if (judge.onCpu() != bar.forCpu) {
        claim.measured = {{"not applicable", bar.forCpu ? "needs a CPU driver" : "needs a GPU"}};
        return claim;
    }
    // A variant is timed once, whatever the scene.
    for (const scenes::Scene& scene : judge.plan().scenes) {
        const Row* row = judge.row("temporal_aa", bar.variant, scene.name, bar.stage);
        if (!row || !(row->*bar.figure)) continue;
        claim.measured = {{bar.measure, *(row->*bar.figure)},
                          {"bound", bar.most},
                          {"stage", bar.stage},
                          {"size", fmt::format("{}x{}", row->width, row->height)}};
        claim.holds = *(row->*bar.figure) <= bar.most;
        break;
    }
    return claim;
}

constexpr double leastEfficiency = 0.7;

// Rows of the same variant share a time, but what draws geometry has one per scene.
std::string timedName(const Row& row) {
    const std::string scene = row.technique == "object_velocity" ? ", " + row.scene : "";
    return fmt::format("{} {}, {}{}", row.technique, row.variant, row.stage, scene);
}

// lighting: of the passes of the framework and of scalable obscurance, of which some compute more than they
// read; else of all others.
Claim efficiency(const Judge& judge, bool lighting) {
    Claim claim{
        lighting ? "efficiency, lighting" : "efficiency",
        "Reprise",
        lighting
            ? "Every pass of lighting reaches 0.7 of the floor with its own reads and writes"
            : "Every pass of anti-aliasing and motion reaches 0.7 of the floor with its own reads and writes",
        {},
        nullptr,
        {}};
    const Row* worst = nullptr;
    std::set<std::string> timed;
    std::map<std::string, double> below; // the least of a variant that is timed in several scenes
    for (const Row& row : judge.report().rows) {
        if (!row.efficiency || (row.errorUnit == "visibility") != lighting) continue;
        if (!worst || *row.efficiency < *worst->efficiency) worst = &row;
        if (!timed.insert(row.file + row.scene + (lighting ? row.variant : "")).second ||
            *row.efficiency >= leastEfficiency)
            continue;
        double& least = below.emplace(timedName(row), *row.efficiency).first->second;
        least = std::min(least, *row.efficiency);
    }
    if (!worst) return claim;
    claim.measured = {{"least efficiency", *worst->efficiency}, {"of", timedName(*worst)}};
    for (const auto& [name, least] : below)
        claim.measured["below 0.7"][name] = least;
    claim.holds = below.empty();
    return claim;
}

// What a row's errors may differ by in its two forms: they round the same steps in another order.
constexpr double formsDiffer = 1e-3;

double largestDifference(const Errors& a, const Errors& b) {
    double largest = 0.0;
    for (const Figure figure : {&Errors::flip, &Errors::rmse, &Errors::flicker})
        if ((a.*figure).has_value() && (b.*figure).has_value())
            largest = std::max(largest, std::abs(*(a.*figure) - *(b.*figure)));
    return largest;
}

Claim formsAgree(const Judge& judge) {
    Claim claim{
        "forms", "Reprise", "The compute form of every row has the errors of the fragment form, within 0.001",
        {},      nullptr,   {}};
    double largest = 0.0;
    std::string where;
    size_t compared = 0;
    for (const Row& compute : judge.report().rows) {
        if (compute.stage != "compute" || !compute.error.rmse) continue;
        const Row* fragment = judge.row(compute.technique, compute.variant, compute.scene, "fragment");
        if (!fragment || !fragment->error.rmse) continue;
        ++compared;
        const double difference = largestDifference(compute.error, fragment->error);
        if (where.empty() || difference > largest) {
            largest = difference;
            where = fmt::format("{} {}, {}", compute.technique, compute.variant, compute.scene);
        }
    }
    if (compared == 0) return claim;
    claim.measured = {{"rows compared", compared}, {"largest difference", largest}, {"of", where}};
    claim.holds = largest <= formsDiffer;
    return claim;
}

} // namespace

std::vector<Claim> judgeClaims(const Report& report, const Plan& plan) {
    const Judge judge(report, plan);
    const Figure flip = &Errors::flip, flicker = &Errors::flicker;
    std::vector<Claim> claims;
    claims.push_back(jitter(judge));
    claims.push_back(
        motion(judge, "I2", "object_velocity",
               "Motion of moving objects is drawn over that of the camera and equals the renderer's", 0.1));
    claims.push_back(motion(judge, "I3", "camera_velocity",
                            "Depth and the previous camera give the motion of all that stands still", 0.1));
    claims.push_back(
        judge.lowers("I4", "Motion of the closest fragment in 3x3 lowers the error at moving edges", "",
                     "fast_object", "inside", "inside + closest_fragment off", flip, "FLIP"));
    claims.push_back(judge.lowers("I5",
                                  "Holding history to the neighbourhood lowers the error of disocclusions",
                                  "big improvement in stability", "fast_object", "inside + constraint clamp",
                                  "inside + constraint none", flip, "FLIP"));
    claims.push_back(judge.lowers("I6 neighbourhood", "The rounded 3x3 has less error than four taps",
                                  "better image quality", "thin_geometry", "inside",
                                  "inside + neighbourhood four_tap", flip, "FLIP"));
    claims.push_back(judge.lowers("I6 clip", "Clipping towards the centre has less error than clamping",
                                  "clip > clamp", "hdr_emitters", "inside", "inside + constraint clamp", flip,
                                  "FLIP"));
    claims.push_back(judge.lowers("I7", "A box in YCoCg holds history closer than one in RGB", "",
                                  "fast_object", "inside + colour_space ycocg", "inside", flip, "FLIP"));
    claims.push_back(judge.lowers("I8 unjitter", "Reading the current colour unjittered lowers flicker", "",
                                  "static_camera", "inside", "inside + unjitter off", flicker, "flicker"));
    claims.push_back(judge.lowers("I8 feedback", "Weighing history by luminance difference lowers the error",
                                  "", "foliage", "inside + feedback luminance", "inside", flip, "FLIP"));
    claims.push_back(
        judge.lowers("I9",
                     "The motion blur fallback lowers the error where motion is fast (against a truth "
                     "without motion blur: it conceals trails by blur, which this counts as error)",
                     "", "fast_object", "inside", "inside + motion_blur_fallback off", flip, "FLIP"));
    claims.push_back(sequences(judge));
    claims.push_back(bestAgainstInside(judge));
    claims.push_back(within(
        judge, {"speed, nine taps",
                "The lean preset takes at most 1.7 times nine point taps (a CPU driver, fragment form)",
                "times nine taps", &Row::perNineTaps, 1.7, true, "fragment"}));
    claims.push_back(
        within(judge, {"speed, copy", "The lean preset takes at most 2.1 times a copy (a GPU, compute form)",
                       "times a copy", &Row::perCopy, 2.1, false, "compute"}));
    claims.push_back(within(
        judge,
        {"speed, camera",
         "As the plan has it where only the camera moves, MOTION camera, the lean preset takes at most 2.1 "
         "times a copy (a GPU, compute form)",
         "times a copy", &Row::perCopy, 2.1, false, "compute", "lean, camera"}));
    claims.push_back(efficiency(judge, false));
    if (plan.hasLighting()) claims.push_back(efficiency(judge, true));
    claims.push_back(formsAgree(judge));
    std::ranges::move(judgeLighting(report, plan), std::back_inserter(claims));
    for (Claim& claim : claims)
        if (claim.published && claim.published->empty()) claim.published.reset();
    return claims;
}

} // namespace report
