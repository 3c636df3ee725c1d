// SPDX-License-Identifier: Apache-2.0
#include "plan_switches.hpp"

#include "plan_images.hpp"

#include <algorithm>
#include <array>

namespace reprise {
namespace {

enum class Wish { asPreset, off, on };

struct Rule {
    std::string_view switchName;
    Wish wish;
    std::string_view reason; // of off
};

std::array<Rule, 9> rulesFor(const SceneNeeds& needs) {
    const auto onIf = [](bool condition) { return condition ? Wish::on : Wish::off; };
    const Wish unlessStill = anythingMoves(needs) ? Wish::asPreset : Wish::off;
    return {{
        {"MOTION", unlessStill, "Neither the camera nor an object moves: history lies where it was."},
        {"MOTION_BLUR_FALLBACK", onIf(needs.fastMotion),
         "The scene has no fast motion that a player looks at: one target is enough."},
        {"HDR_WEIGHT", needs.hdr ? Wish::asPreset : Wish::off, "The colour does not exceed display white."},
        // Linear depth grows away from the camera, whatever the device depth does.
        {"DEPTH_REVERSED", onIf(needs.reversedDepth && !needs.linearDepth), "Nearer is the smaller depth."},
        {"DEPTH_LINEAR", onIf(needs.linearDepth), "Depth is device depth."},
        {"SHADOW_REVERSED", onIf(needs.reversedShadows), "Depth of the shadow map is not reversed."},
        {"ORTHOGRAPHIC", onIf(needs.orthographic), "The camera is a perspective one."},
        {"NORMAL_WEIGHTS", onIf(needs.normals), "The engine hands over no normals."},
        {"OTHER_LIGHT", onIf(needs.otherLight), "There is no light beside what is occluded."},
    }};
}

bool hasSwitch(const PassInfo& pass, std::string_view name) {
    return std::ranges::any_of(pass.switches, [&](const SwitchInfo& info) { return info.name == name; });
}

Result<void> applyPreset(Variant& variant, std::span<const PresetInfo> presets, std::string_view name) {
    const auto preset = std::ranges::find(presets, name, &PresetInfo::name);
    if (preset == presets.end()) {
        std::string known;
        for (const PresetInfo& each : presets)
            known += (known.empty() ? "" : ", ") + std::string(each.name);
        return Error{ErrorCode::invalidArgument, "There is no preset '" + std::string(name) + "' of " +
                                                     std::string(variant.pass->name) +
                                                     "; choose one of: " + known + "."};
    }
    for (const Condition& condition : preset->switches)
        if (auto set = setSwitch(variant, condition.switchName, condition.value); !set) return set;
    return {};
}

struct Choice {
    std::string_view switchName;
    std::string value;
    std::string_view reason; // why it is less than it could be; may be empty
};

// Switches of the framework's passes that the needs and the settings name the value of.
std::vector<Choice> choicesFor(const SceneNeeds& needs, const Settings& settings) {
    const CacheSettings& cache = settings.cache;
    // Fewer points than four wait for less than the second image of depth costs.
    const bool halves = needs.ambientOcclusion && cache.samples >= 4 && mergesCache(needs, settings);
    std::vector<Choice> choices{
        {"TEMPORAL", cache.history ? "on" : "off", {}},
        {"RATIO", std::to_string(cache.ratio), {}},
        {"SAMPLES", std::to_string(cache.samples), {}},
        {"HALF_DEPTH", halves ? "on" : "off", {}},
        {"STEP", cache.filterStep == 1.0f ? "one" : "any", {}},
        {"CASCADES", std::to_string(cache.cascades), {}},
        {"NORMALS", needs.normals ? "read" : "reconstructed", {}},
        {"CHANGE_DETECTION", cache.detectsChanges && cache.history ? "on" : "off", {}}};
    const bool both = needs.ambientOcclusion && needs.sunShadows;
    const uint32_t channels = needs.cachedChannels;
    choices.push_back({"VALUES",
                       both            ? std::string(cache.packing)
                       : channels > 2  ? "four"
                       : channels == 2 ? "two"
                                       : "one",
                       {}});
    for (const std::string_view name : {"LIGHTING", "FRESH"})
        choices.push_back({name, both ? "both" : needs.sunShadows ? "shadow" : "occlusion", {}});
    if (!cache.history)
        choices.push_back({"HISTORY", "none", "CacheSettings::history is off."});
    else if (needs.objectsMove)
        choices.push_back({"HISTORY", "motion", {}});
    else if (needs.cameraMoves)
        choices.push_back({"HISTORY", "camera", "No object moves: history is found from depth alone."});
    else
        choices.push_back(
            {"HISTORY", "still", "Neither the camera nor an object moves: history lies where it was."});
    return choices;
}

Result<void> applyChoices(Variant& variant, const SceneNeeds& needs, const Settings& settings,
                          std::vector<Dropped>& dropped) {
    for (const Choice& choice : choicesFor(needs, settings)) {
        if (!hasSwitch(*variant.pass, choice.switchName)) continue;
        // What is fresh has no frames to pack: it comes as two values.
        const bool isFresh = choice.value == framesPacking && variant.pass->name == "sun_shadow";
        if (auto set = setSwitch(variant, choice.switchName, isFresh ? "two" : choice.value); !set)
            return set;
        if (!choice.reason.empty())
            dropped.push_back({std::string(variant.pass->name) + ": " + std::string(choice.switchName),
                               std::string(choice.reason)});
    }
    return {};
}

// Those of this pass: of temporal_aa without its name.
Result<void> applyOverrides(Variant& variant, std::span<const Condition> overrides) {
    for (const Condition& condition : overrides) {
        const size_t dot = condition.switchName.find('.');
        const bool named = dot != std::string_view::npos;
        const std::string_view pass = named ? condition.switchName.substr(0, dot) : temporalPass;
        if (pass != variant.pass->name) continue;
        const std::string_view name = named ? condition.switchName.substr(dot + 1) : condition.switchName;
        if (auto set = setSwitch(variant, name, condition.value); !set) return set;
    }
    return {};
}

Result<void> turnOff(Variant& variant, std::string_view name, std::string_view reason,
                     std::vector<Dropped>& dropped) {
    if (!hasSwitch(*variant.pass, name) || switchValue(variant, name) == "off") return {};
    dropped.push_back({std::string(variant.pass->name) + ": " + std::string(name), std::string(reason)});
    return setSwitch(variant, name, "off");
}

Result<void> applyNeeds(Variant& variant, const SceneNeeds& needs, std::vector<Dropped>& dropped) {
    for (const Rule& rule : rulesFor(needs)) {
        if (rule.wish == Wish::asPreset || !hasSwitch(*variant.pass, rule.switchName)) continue;
        const auto set = rule.wish == Wish::on ? setSwitch(variant, rule.switchName, "on")
                                               : turnOff(variant, rule.switchName, rule.reason, dropped);
        if (!set) return set;
    }
    return {};
}

} // namespace

bool cachesAnything(const SceneNeeds& needs) {
    return needs.ambientOcclusion || needs.sunShadows || needs.cachedChannels > 0;
}

bool mergesCache(const SceneNeeds& needs, const Settings& settings) {
    const CacheSettings& cache = settings.cache;
    return cache.merges && settings.stage == Stage::compute && (cache.history || cache.filter) &&
           (needs.ambientOcclusion || needs.sunShadows) && cache.occlusion != obscurancePass;
}

bool anythingMoves(const SceneNeeds& needs) {
    return needs.cameraMoves || needs.objectsMove;
}

Result<Variant> chooseVariant(const PassInfo& pass, std::span<const PresetInfo> presets,
                              const SceneNeeds& needs, const Settings& settings,
                              std::vector<Dropped>& dropped) {
    auto variant = makeVariant({&pass, 1}, pass.name);
    if (!variant) return variant;
    const bool temporal = pass.name == temporalPass;
    if (temporal)
        if (auto set = applyPreset(*variant, presets, settings.preset); !set) return set.error();
    if (auto set = applyNeeds(*variant, needs, dropped); !set) return set.error();
    if (auto set = applyChoices(*variant, needs, settings, dropped); !set) return set.error();
    if (auto set = applyOverrides(*variant, settings.overrides); !set) return set.error();
    if (settings.stage == Stage::compute && !settings.quadOperations) {
        const auto set =
            turnOff(*variant, "QUAD_SHARING",
                    "The device has no quad and shuffle operations in compute, or subgroups of fewer than 8.",
                    dropped);
        if (!set) return set.error();
    }
    // The closest fragment is looked for to take its motion.
    if (hasSwitch(pass, "MOTION") && switchValue(*variant, "MOTION") == "off")
        if (auto set = turnOff(*variant, "CLOSEST_FRAGMENT", "No motion is read.", dropped); !set)
            return set.error();
    return variant;
}

} // namespace reprise
