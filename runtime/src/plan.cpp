// SPDX-License-Identifier: Apache-2.0
#include "guarded.hpp"
#include "plan_images.hpp"
#include "plan_switches.hpp"
#include "reprise/format.hpp"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

// A pass that may take part, and why not, if so.
struct Candidate {
    PlannedPass pass;
    std::string_view veto;
};

bool isOcclusion(std::string_view pass) {
    return pass == "ambient_occlusion" || pass == obscurancePass;
}

bool isFilter(std::string_view pass) {
    return pass == filterPass || pass == obscuranceFilterPass;
}

std::string_view vetoOf(const PassInfo& pass, const SceneNeeds& needs, const Settings& settings) {
    if (pass.name == temporalPass && !needs.antiAliasing) return "Anti-aliasing is not asked for.";
    if (pass.name == combinePass && !needs.combinesLighting)
        return "The engine puts its light together itself.";
    if (pass.name == upsamplePass && !cachesAnything(needs))
        return "Neither occlusion nor shadows nor channels of the engine's are asked for.";
    if (pass.name == upsamplePass && settings.cache.ratio == 1)
        return "CacheSettings::ratio is 1: there is nothing to upsample.";
    const bool merges = mergesCache(needs, settings);
    if (pass.name == lightingCachePass && !merges) {
        const CacheSettings& cache = settings.cache;
        if (!needs.ambientOcclusion && !needs.sunShadows)
            return "Neither occlusion nor shadows are asked for.";
        if (cache.occlusion == obscurancePass) return "scalable_obscurance accumulates by itself.";
        if (!cache.history && !cache.filter)
            return "CacheSettings::history and filter are off: what is computed is upsampled.";
        if (!cache.merges) return "CacheSettings::merges is off.";
        return "In fragment shaders occlusion, shadow and cache are passes of their own.";
    }
    if (isOcclusion(pass.name)) {
        if (!needs.ambientOcclusion) return "Ambient occlusion is not asked for.";
        if (pass.name != settings.cache.occlusion) return "CacheSettings::occlusion is another pass.";
    }
    if (pass.name == "sun_shadow" && !needs.sunShadows) return "Sun shadows are not asked for.";
    if (merges && (isOcclusion(pass.name) || pass.name == "sun_shadow" || pass.name == cachePass))
        return "lighting_cache does it.";
    if (pass.name == cachePass && !settings.cache.history && !settings.cache.filter)
        return "CacheSettings::history and filter are off: what is computed is upsampled.";
    if (isFilter(pass.name) && !settings.cache.filter) return "CacheSettings::filter is off.";
    const bool camera = pass.name == "camera_velocity", object = pass.name == "object_velocity";
    if ((camera || object) && needs.engineWritesMotion) return "The engine writes motion vectors itself.";
    if (camera && !needs.cameraMoves)
        return "The camera does not move: the motion of what stands still is zero, and is cleared, not "
               "computed.";
    if (object && !needs.objectsMove) return "No object moves.";
    return {};
}

Stage stageOf(const PassInfo& pass, Stage wanted) {
    if (!pass.fullscreen) return Stage::fragment;
    return std::ranges::find(pass.stages, wanted) != pass.stages.end() ? wanted : pass.stages.front();
}

std::vector<std::string> inputsOf(const Variant& variant) {
    std::vector<std::string> names;
    for (const ImageInfo& input : variant.pass->inputs)
        if (exists(variant, input)) names.emplace_back(input.name);
    return names;
}

void addCandidate(std::vector<Candidate>& candidates, const Variant& variant, Stage stage,
                  std::string_view veto, std::string_view run = {}) {
    // A switch of another stage changes nothing in a full-screen pass; a drawn pass has both stages.
    Candidate candidate{
        {variant.pass->fullscreen ? forStage(variant, stage) : variant, stage, run, {}, {}, {}, {}}, veto};
    candidate.pass.reads = inputsOf(variant);
    for (const ImageInfo& output : variant.pass->outputs)
        if (exists(variant, output)) candidate.pass.writes.emplace_back(output.name);
    candidates.push_back(std::move(candidate));
}

// Every pass of the table in its order; object_velocity twice when there are skinned meshes beside rigid
// ones, and the filter in both directions.
Result<std::vector<Candidate>> candidatesFor(std::span<const PassInfo> passes,
                                             std::span<const PresetInfo> presets, const SceneNeeds& needs,
                                             const Settings& settings, std::vector<Dropped>& dropped) {
    std::vector<Candidate> candidates;
    for (const PassInfo& pass : passes) {
        if (pass.outputs.empty()) continue; // the full-screen triangle
        const std::string_view veto = vetoOf(pass, needs, settings);
        // What is left out has no switches to be chosen.
        auto variant = veto.empty() ? chooseVariant(pass, presets, needs, settings, dropped)
                                    : makeVariant(passes, pass.name);
        if (!variant) return variant.error();
        const Stage stage = stageOf(pass, settings.stage);
        if (isFilter(pass.name)) {
            addCandidate(candidates, *variant, stage, veto, "across");
            addCandidate(candidates, *variant, stage, veto, "down");
            continue;
        }
        addCandidate(candidates, *variant, stage, veto);
        if (!needs.skinnedMeshes || !veto.empty() || !setSwitch(*variant, "SKINNING", "on")) continue;
        addCandidate(candidates, *variant, stage, veto);
    }
    return candidates;
}

void want(std::vector<std::string>& wanted, std::string name) {
    if (std::ranges::find(wanted, name) == wanted.end()) wanted.push_back(std::move(name));
}

bool wantsAny(const std::vector<std::string>& wanted, const PlannedPass& pass) {
    return std::ranges::any_of(pass.writes, [&](const std::string& name) {
        return std::ranges::find(wanted, imageName(pass, name)) != wanted.end();
    });
}

void wantInputs(std::vector<std::string>& wanted, const Variant& variant, const CacheSettings& cache) {
    for (const ImageInfo& input : variant.pass->inputs)
        if (exists(variant, input) && isImage(input) && !isHistory(input))
            for (const std::string& source :
                 sourcesOf(input.sameAs.empty() ? input.name : input.sameAs, cache))
                want(wanted, source);
}

// A pass that is left out has no switches worth a word, and is named once.
void drop(FramePlan& plan, std::string_view pass, std::string reason) {
    std::erase_if(plan.dropped, [&](const Dropped& each) {
        return each.pass == pass || each.pass.starts_with(std::string(pass) + ":");
    });
    plan.dropped.push_back({std::string(pass), std::move(reason)});
}

// Walks back from the anti-aliased frame, from the light put together and from the framework's last step.
void choosePasses(std::vector<Candidate> candidates, const SceneNeeds& needs, FramePlan& plan) {
    std::vector<std::string> wanted;
    if (cachesAnything(needs)) wanted = lightingImages(plan.cache);
    for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
        const std::string_view name = candidate->pass.variant.pass->name;
        const bool needed = name == temporalPass || name == combinePass || wantsAny(wanted, candidate->pass);
        if (!candidate->veto.empty()) {
            drop(plan, name, std::string(candidate->veto));
        } else if (!needed) {
            drop(plan, name, "Nothing reads " + candidate->pass.writes.front() + ".");
        } else {
            wantInputs(wanted, candidate->pass.variant, plan.cache);
            plan.passes.insert(plan.passes.begin(), std::move(candidate->pass));
        }
    }
}

// Motion that the camera alone makes follows from the device depth. Where no other pass reads it, temporal_aa
// computes it itself, and there is neither camera_velocity nor its image.
Result<void> mergeCameraMotion(const SceneNeeds& needs, const Settings& settings, FramePlan& plan) {
    const auto temporal = std::ranges::find_if(
        plan.passes, [](const PlannedPass& pass) { return pass.variant.pass->name == temporalPass; });
    if (temporal == plan.passes.end()) return {};
    const std::string_view motion = switchValue(temporal->variant, "MOTION");
    if (needs.linearDepth && motion == "camera")
        return Error{
            ErrorCode::invalidArgument,
            "MOTION camera takes device depth, but SceneNeeds::linearDepth is on; leave the switch at "
            "vectors."};
    const bool cameraAlone = needs.cameraMoves && !needs.objectsMove && !needs.engineWritesMotion;
    const bool overridden = std::ranges::any_of(settings.overrides, [](const Condition& each) {
        return each.switchName == "MOTION" || each.switchName == "temporal_aa.MOTION";
    });
    const auto readers = std::ranges::count_if(plan.passes, [](const PlannedPass& pass) {
        return std::ranges::find(pass.reads, "gInVelocity") != pass.reads.end();
    });
    if (motion != "vectors" || !cameraAlone || needs.linearDepth || overridden || readers != 1) return {};
    if (auto set = setSwitch(temporal->variant, "MOTION", "camera"); !set) return set;
    temporal->reads = inputsOf(temporal->variant);
    std::erase_if(plan.passes,
                  [](const PlannedPass& pass) { return pass.variant.pass->name == "camera_velocity"; });
    drop(plan, "camera_velocity", "temporal_aa alone needs the camera's motion, and computes it from depth.");
    return {};
}

Result<void> checkCache(const SceneNeeds& needs, const CacheSettings& cache) {
    if (cache.ratio != 1 && cache.ratio != 2 && cache.ratio != 4)
        return Error{ErrorCode::invalidArgument,
                     "CacheSettings::ratio is 1, 2 or 4, not " + std::to_string(cache.ratio) + "."};
    if (cache.ratio == 1 && needs.ambientOcclusion && needs.sunShadows)
        return Error{
            ErrorCode::invalidArgument,
            "Occlusion and shadows share a cache below full resolution only, where upsampling unpacks "
            "them; at a ratio of 1 make a plan and a recorder for each."};
    if (!(cache.filterStep > 0.0f) || !std::isfinite(cache.filterStep))
        return Error{ErrorCode::invalidArgument, "CacheSettings::filterStep is not a number above 0."};
    if (cache.packing != "occlusion_in_integer" && cache.packing != "shadow_in_integer" &&
        cache.packing != framesPacking && cache.packing != "two")
        return Error{
            ErrorCode::invalidArgument,
            "CacheSettings::packing is occlusion_in_integer, shadow_in_integer, with_frames or two, not '" +
                std::string(cache.packing) + "'."};
    const bool packsFrames = cache.packing == framesPacking && needs.ambientOcclusion && needs.sunShadows;
    if (packsFrames && (cache.filter || !cache.history))
        return Error{ErrorCode::invalidArgument,
                     "CacheSettings::packing with_frames takes history and no filter; turn "
                     "CacheSettings::filter off and history on, or choose another packing."};
    if (!isOcclusion(cache.occlusion))
        return Error{ErrorCode::invalidArgument, "CacheSettings::occlusion is ambient_occlusion or "
                                                 "scalable_obscurance, not '" +
                                                     std::string(cache.occlusion) + "'."};
    if (cache.occlusion == obscurancePass && (needs.sunShadows || needs.cachedChannels > 0))
        return Error{
            ErrorCode::invalidArgument,
            "scalable_obscurance shares no cache; make a plan and a recorder for shadows or channels."};
    if (needs.combinesLighting && !cachesAnything(needs))
        return Error{ErrorCode::invalidArgument,
                     "SceneNeeds::combinesLighting puts light together with a visibility; ask for "
                     "ambientOcclusion, sunShadows or cachedChannels too."};
    if (needs.cachedChannels > 0 && (needs.ambientOcclusion || needs.sunShadows))
        return Error{ErrorCode::invalidArgument,
                     "A cache holds occlusion and shadows or channels of the engine's; make a plan and a "
                     "recorder for each."};
    if (needs.cachedChannels > 4)
        return Error{ErrorCode::invalidArgument, "SceneNeeds::cachedChannels is 0 to 4, not " +
                                                     std::to_string(needs.cachedChannels) + "."};
    return {};
}

// An override of a pass that there is not would have no effect.
Result<void> checkOverrides(std::span<const PassInfo> passes, std::span<const Condition> overrides) {
    for (const Condition& condition : overrides) {
        const size_t dot = condition.switchName.find('.');
        if (dot == std::string_view::npos) continue;
        if (auto known = makeVariant(passes, condition.switchName.substr(0, dot)); !known)
            return known.error();
    }
    return {};
}

Result<void> checkSettings(const Settings& settings, Extent extent) {
    if (extent.width == 0 || extent.height == 0)
        return Error{ErrorCode::zeroExtent, "The extent of the frame is zero; give it a width and a height."};
    if (settings.stage == Stage::vertex)
        return Error{ErrorCode::invalidArgument, "Settings::stage must be fragment or compute."};
    if (!settings.colourFormat.empty() && texelBytes(settings.colourFormat) == 0)
        return Error{ErrorCode::invalidArgument, "There is no format named '" +
                                                     std::string(settings.colourFormat) +
                                                     "'; see reprise/format.hpp."};
    return {};
}

} // namespace

Result<FramePlan> plan(std::span<const PassInfo> passes, std::span<const PresetInfo> presets,
                       const SceneNeeds& needs, const Settings& settings, Extent extent) {
    return guarded([&]() -> Result<FramePlan> {
        if (auto checked = checkSettings(settings, extent); !checked) return checked.error();
        if (auto checked = checkCache(needs, settings.cache); !checked) return checked.error();
        if (auto checked = checkOverrides(passes, settings.overrides); !checked) return checked.error();
        FramePlan plan;
        plan.cache = settings.cache;
        auto candidates = candidatesFor(passes, presets, needs, settings, plan.dropped);
        if (!candidates) return candidates.error();
        choosePasses(std::move(*candidates), needs, plan);
        if (auto merged = mergeCameraMotion(needs, settings, plan); !merged) return merged.error();
        planImages(plan, needs.engineWritesMotion, settings.colourFormat, extent);
        return plan;
    });
}

} // namespace reprise
