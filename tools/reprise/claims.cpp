// SPDX-License-Identifier: Apache-2.0
// What the documents claim, held against the rows. A claim that the rows contradict says so.
#include "experiment.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace report {
namespace {

using Figure = std::optional<double> Errors::*;

class Judge {
public:
    Judge(const Report& report, const Plan& plan)
        : report_(report), stage_(stageText(plan.stages.front())), plan_(plan) {}

    const Row* row(std::string_view technique, std::string_view variant, std::string_view scene) const {
        for (const Row& r : report_.rows)
            if (r.technique == technique && r.variant == variant && r.scene == scene &&
                (r.stage.empty() || r.stage == stage_))
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

private:
    const Report& report_;
    std::string stage_;
    const Plan& plan_;
};

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

// The issue's own bar: better in both measures and no slower on at least four scenes of five.
Claim bestAgainstInside(const Judge& judge) {
    Claim claim{
        "best",
        "Reprise",
        "The best preset has less FLIP and less flicker than the document's at no more time, on four of five "
        "scenes",
        {},
        nullptr,
        {}};
    int better = 0, scenes = 0;
    std::string lost;
    for (const auto& scene : judge.plan().scenes) {
        const Row *best = judge.row("temporal_aa", "best", scene.name),
                  *inside = judge.row("temporal_aa", "inside", scene.name);
        if (!best || !inside || !best->error.flip || !inside->error.flip || !best->gpu || !inside->gpu)
            continue;
        ++scenes;
        const bool wins = *best->error.flip < *inside->error.flip &&
                          best->error.flicker.value_or(0.0) <= inside->error.flicker.value_or(0.0) &&
                          best->gpu->median <= inside->gpu->median;
        if (wins)
            ++better;
        else
            lost += (lost.empty() ? "" : ", ") + scene.name;
    }
    if (scenes == 0) return claim;
    claim.measured = {{"scenes won", better}, {"of", scenes}, {"stage", judge.stage()}};
    if (!lost.empty()) claim.measured["not on"] = lost;
    claim.holds = 5 * better >= 4 * scenes;
    return claim;
}

Claim ratio(const Judge& judge, std::string id, std::string text, std::optional<double> Row::*figure,
            double bound, std::string_view measure) {
    Claim claim{std::move(id), "Reprise", std::move(text), {}, nullptr, {}};
    const Row* lean = judge.row("temporal_aa", "lean", judge.plan().scenes.front().name);
    if (!lean || !(lean->*figure)) return claim;
    claim.measured = {{std::string(measure), *(lean->*figure)}, {"bound", bound}, {"stage", judge.stage()}};
    claim.holds = *(lean->*figure) <= bound;
    return claim;
}

Claim efficiency(const Report& report) {
    Claim claim{"efficiency", "Reprise", "Every pass reaches 0.7 of the floor with its own reads and writes",
                {},           nullptr,   {}};
    const Row* worst = nullptr;
    for (const Row& row : report.rows)
        if (row.efficiency && (!worst || *row.efficiency < *worst->efficiency)) worst = &row;
    if (!worst) return claim;
    claim.measured = {{"least efficiency", *worst->efficiency},
                      {"pass", fmt::format("{}, {}, {}", worst->technique, worst->variant, worst->stage)}};
    claim.holds = *worst->efficiency >= 0.7;
    return claim;
}

} // namespace

std::vector<Claim> judgeClaims(const Report& report, const Plan& plan) {
    const Judge judge(report, plan);
    const Figure flip = &Errors::flip, flicker = &Errors::flicker;
    std::vector<Claim> claims;
    claims.push_back(judge.lowers("I1", "Jittering the frustum lowers the error of edges", "",
                                  "thin_geometry", "inside", "inside, jitter none", flip, "FLIP"));
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
    claims.push_back(ratio(judge, "speed, nine taps",
                           "The lean preset takes at most 1.7 times nine point taps", &Row::perNineTaps, 1.7,
                           "times nine taps"));
    claims.push_back(ratio(judge, "speed, copy",
                           "The lean preset takes at most 2.1 times a copy (a GPU, compute form)",
                           &Row::perCopy, 2.1, "times a copy"));
    claims.push_back(efficiency(report));
    for (Claim& claim : claims)
        if (claim.published && claim.published->empty()) claim.published.reset();
    return claims;
}

} // namespace report
