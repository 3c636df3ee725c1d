// SPDX-License-Identifier: Apache-2.0
// From what a scene needs to the switches of a pass.
#pragma once

#include "reprise/plan.hpp"

namespace reprise {

// Preset, then needs, then overrides. What the needs switched off is added to `dropped`.
Result<Variant> chooseVariant(const PassInfo& pass, std::span<const PresetInfo> presets,
                              const SceneNeeds& needs, const Settings& settings,
                              std::vector<Dropped>& dropped);

bool anythingMoves(const SceneNeeds& needs);
bool cachesAnything(const SceneNeeds& needs);
// Whether lighting_cache does the work of what computes occlusion and shadow and of the cache.
bool mergesCache(const SceneNeeds& needs, const Settings& settings);

} // namespace reprise
