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
    change(spec);
    return spec;
}

// Twelve samples of occlusion without anything but upsampling (Drobot, Table 7.1).
LightingSpec reference(Cached cached) {
    LightingSpec spec = changed(cached, "", [](LightingSpec& s) {
        s.cache.samples = 12;
        s.cache.history = s.cache.filter = false;
    });
    spec.label = "reference";
    return spec;
}

} // namespace

std::string cachedName(Cached cached) {
    switch (cached) {
    case Cached::occlusion:
        return "occlusion";
    case Cached::shadow:
        return "shadow";
    case Cached::both:
        break;
    }
    return "occlusion and shadow";
}

std::vector<LightingSpec> lightingRows(Cached cached, bool quick) {
    std::vector<LightingSpec> rows;
    const auto add = [&](const std::string& what, const Change& change) {
        rows.push_back(changed(cached, what, change));
    };
    rows.push_back(reference(cached));
    add("", [](LightingSpec&) {});
    add("history off", [](LightingSpec& s) { s.cache.history = false; });
    add("filter off", [](LightingSpec& s) { s.cache.filter = false; });
    add("history and filter off", [](LightingSpec& s) { s.cache.history = s.cache.filter = false; });
    add("change_detection off", [](LightingSpec& s) { s.cache.detectsChanges = false; });
    for (const uint32_t samples : {1u, 2u, 8u, 12u, 16u, 32u})
        if (!quick || samples == 1 || samples == 8)
            add(fmt::format("samples {}", samples), [=](LightingSpec& s) { s.cache.samples = samples; });
    add("converged", [](LightingSpec& s) {
        s.cache.samples = 32;
        s.tuning.subsets = 16;
        s.tuning.maxWeight = 0.98f;
        s.cache.filter = false;
    });
    add("ratio 4", [](LightingSpec& s) { s.cache.ratio = 4; });
    add("filter over time", [](LightingSpec& s) { s.cache.filtersHistory = true; });
    if (quick) return rows;
    for (const float weight : {0.5f, 0.8f, 0.9f, 0.98f})
        add(fmt::format("history weight {}", weight), [=](LightingSpec& s) { s.tuning.maxWeight = weight; });
    for (const float step : {0.5f, 2.0f, 3.0f})
        add(fmt::format("filter radius {}", 4.0f * step),
            [=](LightingSpec& s) { s.tuning.filterStep = step; });
    add("filter the same at any convergence", [](LightingSpec& s) { s.tuning.maxSmoothing = 1.0f; });
    for (const uint32_t subsets : {1u, 4u, 16u})
        add(fmt::format("patterns {}", subsets), [=](LightingSpec& s) { s.tuning.subsets = subsets; });
    add("taps point", [](LightingSpec& s) { s.overrides.push_back({"bilateral_filter.TAPS", "point"}); });
    add("resampling nearest", [](LightingSpec& s) {
        s.overrides.push_back({"reprojection_cache.RESAMPLING", "nearest"});
    });
    add("checkerboard depth", [](LightingSpec& s) {
        s.overrides.push_back({"depth_downsample.CHECKERBOARD", "on"});
    });
    return rows;
}

// On the terminal, and in pictures.
bool isChiefLighting(const std::string& variant) {
    return variant == "reference" || variant == "framework" || variant == "framework + history off";
}

std::vector<Cached> cachedOf(const Plan& plan) {
    std::vector<Cached> result;
    for (const Cached cached : {Cached::occlusion})
        if (plan.has(cachedName(cached))) result.push_back(cached);
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
