// SPDX-License-Identifier: Apache-2.0
// Which rows a report has of the framework: what is cached, and one thing changed at a time.
#pragma once

#include "experiment.hpp"

#include <string>
#include <vector>

namespace report {

enum class Cached { occlusion, shadow, both };
std::vector<Cached> cachedOf(const Plan& plan); // those of its techniques
std::string cachedName(Cached cached);          // the rows' technique: "occlusion" or "shadow"

struct LightingSpec {
    Cached cached = Cached::occlusion;
    std::string label; // "framework", "framework + samples 8", "reference"
    reprise::CacheSettings cache;
    reprise::CacheTuning tuning;
    std::vector<reprise::Condition> overrides;
    bool combines = false; // ends in combine_lighting
};

// Rows for the terminal, and in pictures.
std::span<const std::string_view> chiefLighting();
bool isChiefLighting(std::string_view variant);

// Metres, of what occludes: of the rows and of their ground truth.
inline constexpr float occlusionRadius = 1.0f;
// Radians, of the sun's disc: four times the real one's, a hazy day's, so that a hall has penumbrae; and
// metres, of the disc of the shadow map that stands for it, which is the sun's at two and a half metres.
inline constexpr double sunDiscRadians = 0.02, shadowRadius = 0.05;

// The framework as it is by default, the documents' references, and each step changed or left out; of both,
// the packed forms. quick: those that claims need.
std::vector<LightingSpec> lightingRows(Cached cached, bool quick);
// Those whose plan puts the light together too. They are timed only: their visibility is that of the rows
// above.
std::vector<LightingSpec> combinedRows(Cached cached, bool quick);
// The techniques whose errors a spec has, a row each.
std::vector<Cached> measuredBy(const LightingSpec& spec);
bool objectsMove(const scenes::Scene& scene);
// What the runtime is asked for.
reprise::SceneNeeds needsOf(const LightingSpec& spec, const scenes::Scene& scene);
reprise::Settings settingsOf(const LightingSpec& spec, reprise::Stage stage);

// A row without measurements; `measured` is what its errors are of.
Row lightingRow(Experiment& experiment, const LightingSpec& spec, Cached measured, reprise::Stage stage,
                const std::string& scene);

} // namespace report
