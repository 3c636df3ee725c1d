// SPDX-License-Identifier: Apache-2.0
#include "lighting_rows.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

namespace report {
namespace {

using Change = std::function<void(LightingSpec&)>;

LightingSpec changed(Cached cached, const std::string& what, const Change& change) {
    LightingSpec spec;
    spec.cached = cached;
    spec.label = what.empty() ? "framework" : "framework + " + what;
    spec.tuning.radius = occlusionRadius;
    spec.tuning.shadow.radius = shadowRadius;
    change(spec);
    return spec;
}

// Drobot, Table 7.1: twelve samples of occlusion without anything but upsampling, and 2x2 jittered samples of
// the shadow map at full resolution.
void addReferences(std::vector<LightingSpec>& rows, Cached cached) {
    LightingSpec spec =
        changed(cached, "", [](LightingSpec& s) { s.cache.history = s.cache.filter = false; });
    spec.label = "reference";
    if (cached == Cached::occlusion) {
        spec.cache.samples = 12;
        rows.push_back(spec);
        return;
    }
    spec.cache.ratio = 1;
    spec.tuning.subsets = 1;
    LightingSpec disc = spec; // the framework's
    spec.tuning.shadow.radius = 0.0;
    spec.tuning.shadow.leastTexels = 1.128; // the area of 2x2 texels
    rows.push_back(spec);
    disc.label = "reference, the framework's disc";
    rows.push_back(disc);
}

// Wronski: three rotations in turn against as many samples, and against three times as many, without history.
void addObscurance(std::vector<LightingSpec>& rows) {
    const auto add = [&](const std::string& what, const Change& change) {
        LightingSpec spec = changed(Cached::occlusion, "", [](LightingSpec& s) {
            s.cache.occlusion = "scalable_obscurance";
            s.cache.samples = 7;
        });
        spec.label = what.empty() ? "obscurance" : "obscurance + " + what;
        change(spec);
        rows.push_back(spec);
    };
    add("", [](LightingSpec&) {});
    add("history off", [](LightingSpec& s) { s.cache.history = false; });
    add("history off, samples 21", [](LightingSpec& s) {
        s.cache.history = false;
        s.cache.samples = 21;
    });
}

// Both in one cache: packed in one number, in either order, and as two.
std::vector<LightingSpec> packedRows(bool quick) {
    std::vector<LightingSpec> rows;
    for (const std::string_view packing : {"shadow_in_integer", "two", "occlusion_in_integer"}) {
        if (quick && packing == "occlusion_in_integer") continue;
        LightingSpec spec = changed(Cached::both, "", [](LightingSpec&) {});
        spec.label = packing == "two" ? "two values" : fmt::format("packed, {}", packing);
        spec.cache.packing = packing;
        rows.push_back(spec);
    }
    // The least that errs less than the reference: without what costs more than it gains there, and the
    // patterns of more frames in place of samples.
    LightingSpec lean = changed(Cached::both, "", [](LightingSpec&) {});
    lean.label = "both, lean";
    lean.cache.packing = "with_frames";
    lean.cache.samples = 1;
    lean.tuning.subsets = 16;
    lean.cache.filter = lean.cache.detectsChanges = false;
    rows.push_back(lean);
    return rows;
}

} // namespace

std::string cachedName(Cached cached) {
    return cached == Cached::shadow ? "shadow" : "occlusion";
}

std::vector<Cached> measuredBy(const LightingSpec& spec) {
    if (spec.cached != Cached::both) return {spec.cached};
    return {Cached::occlusion, Cached::shadow};
}

std::vector<LightingSpec> lightingRows(Cached cached, bool quick) {
    if (cached == Cached::both) return packedRows(quick);
    std::vector<LightingSpec> rows;
    const auto add = [&](const std::string& what, const Change& change) {
        rows.push_back(changed(cached, what, change));
    };
    addReferences(rows, cached);
    add("", [](LightingSpec&) {});
    add("history off", [](LightingSpec& s) { s.cache.history = false; });
    add("filter off", [](LightingSpec& s) { s.cache.filter = false; });
    add("change_detection off", [](LightingSpec& s) { s.cache.detectsChanges = false; });
    if (cached == Cached::occlusion) addObscurance(rows);
    if (quick) return rows;
    add("history and filter off", [](LightingSpec& s) { s.cache.history = s.cache.filter = false; });
    for (const uint32_t samples : {1u, 2u, 8u, 12u, 16u, 32u})
        add(fmt::format("samples {}", samples), [=](LightingSpec& s) { s.cache.samples = samples; });
    // The technique's own limit at this resolution: what remains is the error of the method.
    add("converged", [](LightingSpec& s) {
        s.cache.samples = 32;
        s.tuning.subsets = 16;
        s.tuning.maxWeight = 0.98f;
        s.cache.filter = false;
    });
    add("ratio 4", [](LightingSpec& s) { s.cache.ratio = 4; });
    add("filter over time", [](LightingSpec& s) { s.cache.filtersHistory = true; });
    add("ratio 1", [](LightingSpec& s) { s.cache.ratio = 1; });
    for (const float weight : {0.5f, 0.8f, 0.9f, 0.98f})
        add(fmt::format("history weight {}", weight), [=](LightingSpec& s) { s.tuning.maxWeight = weight; });
    for (const float step : {0.5f, 2.0f, 3.0f})
        add(fmt::format("filter radius {}", 4.0f * step),
            [=](LightingSpec& s) { s.cache.filterStep = step; });
    add("filter the same at any convergence", [](LightingSpec& s) { s.tuning.maxSmoothing = 1.0f; });
    for (const uint32_t subsets : {1u, 4u, 16u})
        add(fmt::format("patterns {}", subsets), [=](LightingSpec& s) { s.tuning.subsets = subsets; });
    add("taps point", [](LightingSpec& s) { s.overrides.push_back({"bilateral_filter.TAPS", "point"}); });
    add("resampling nearest", [](LightingSpec& s) {
        for (const char* name : {"reprojection_cache.RESAMPLING", "lighting_cache.RESAMPLING"})
            s.overrides.push_back({name, "nearest"});
    });
    add("checkerboard depth", [](LightingSpec& s) {
        s.overrides.push_back({"depth_downsample.CHECKERBOARD", "on"});
    });
    return rows;
}

std::vector<LightingSpec> combinedRows(Cached cached, bool quick) {
    if (quick && cached != Cached::both) return {};
    LightingSpec spec =
        cached == Cached::both ? packedRows(true).front() : changed(cached, "", [](LightingSpec&) {});
    spec.label += " + combine_lighting";
    spec.combines = true;
    return {spec};
}

std::span<const std::string_view> chiefLighting() {
    static constexpr std::string_view names[] = {"reference", "framework", "framework + history off",
                                                 "packed, shadow_in_integer", "obscurance"};
    return names;
}

bool isChiefLighting(std::string_view variant) {
    return std::ranges::find(chiefLighting(), variant) != chiefLighting().end();
}

std::vector<Cached> cachedOf(const Plan& plan) {
    std::vector<Cached> result;
    for (const Cached cached : {Cached::occlusion, Cached::shadow})
        if (plan.has(cachedName(cached))) result.push_back(cached);
    if (result.size() == 2) result.push_back(Cached::both);
    return result;
}

bool objectsMove(const scenes::Scene& scene) {
    return std::any_of(scene.instances.begin(), scene.instances.end(), [](const auto& i) { return i.moves; });
}

reprise::SceneNeeds needsOf(const LightingSpec& spec, const scenes::Scene& scene) {
    reprise::SceneNeeds needs;
    needs.antiAliasing = false;
    needs.cameraMoves = scene.cameraMoves;
    needs.objectsMove = objectsMove(scene);
    needs.engineWritesMotion = true; // the renderer's: the report measures the framework alone
    needs.ambientOcclusion = spec.cached != Cached::shadow;
    needs.sunShadows = spec.cached != Cached::occlusion;
    needs.combinesLighting = spec.combines;
    return needs;
}

reprise::Settings settingsOf(const LightingSpec& spec, reprise::Stage stage) {
    reprise::Settings settings;
    settings.stage = stage;
    settings.cache = spec.cache;
    settings.overrides = spec.overrides;
    return settings;
}

} // namespace report
