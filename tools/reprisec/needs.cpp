// SPDX-License-Identifier: Apache-2.0
// needs.toml: what a scene asks for, in the words of reprise/plan.hpp, and the modules that its plan uses.
#include "output.hpp"

#include "reprise/plan.hpp"

#include <algorithm>
#include <limits>
#include <variant>

#include <toml++/toml.h>

namespace reprisec {

namespace {

using reprise::CacheSettings;
using reprise::SceneNeeds;

struct Scene {
    SceneNeeds needs;
    reprise::Settings settings;
    std::deque<std::string> texts; // what the views in `settings` point to
};

using NeedField = std::variant<bool SceneNeeds::*, uint32_t SceneNeeds::*>;

constexpr std::pair<std::string_view, NeedField> needFields[] = {
    {"antiAliasing", &SceneNeeds::antiAliasing},
    {"cameraMoves", &SceneNeeds::cameraMoves},
    {"objectsMove", &SceneNeeds::objectsMove},
    {"skinnedMeshes", &SceneNeeds::skinnedMeshes},
    {"engineWritesMotion", &SceneNeeds::engineWritesMotion},
    {"hdr", &SceneNeeds::hdr},
    {"fastMotion", &SceneNeeds::fastMotion},
    {"reversedDepth", &SceneNeeds::reversedDepth},
    {"orthographic", &SceneNeeds::orthographic},
    {"linearDepth", &SceneNeeds::linearDepth},
    {"ambientOcclusion", &SceneNeeds::ambientOcclusion},
    {"sunShadows", &SceneNeeds::sunShadows},
    {"reversedShadows", &SceneNeeds::reversedShadows},
    {"normals", &SceneNeeds::normals},
    {"combinesLighting", &SceneNeeds::combinesLighting},
    {"otherLight", &SceneNeeds::otherLight},
    {"cachedChannels", &SceneNeeds::cachedChannels}};

// Does not compile when a need is added: then it has a name above too.
[[maybe_unused]] constexpr size_t countNeeds(const SceneNeeds& needs) {
    [[maybe_unused]] const auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q] = needs;
    return 17;
}
static_assert(std::size(needFields) == countNeeds({}), "a need has no name here");

using CacheField = std::variant<bool CacheSettings::*, uint32_t CacheSettings::*, float CacheSettings::*,
                                std::string_view CacheSettings::*>;

constexpr std::pair<std::string_view, CacheField> cacheFields[] = {
    {"occlusion", &CacheSettings::occlusion},
    {"ratio", &CacheSettings::ratio},
    {"samples", &CacheSettings::samples},
    {"cascades", &CacheSettings::cascades},
    {"history", &CacheSettings::history},
    {"detectsChanges", &CacheSettings::detectsChanges},
    {"merges", &CacheSettings::merges},
    {"filter", &CacheSettings::filter},
    {"filtersHistory", &CacheSettings::filtersHistory},
    {"filterStep", &CacheSettings::filterStep},
    {"packing", &CacheSettings::packing}};

// Thrown while reading, caught in readScene.
struct Mistake {
    uint32_t line;
    std::string message;
};

[[noreturn]] void fail(const toml::node& node, std::string message) {
    throw Mistake{static_cast<uint32_t>(node.source().begin.line), std::move(message)};
}

std::string_view text(Scene& scene, const toml::node& node) {
    if (const auto value = node.value_exact<std::string>()) return scene.texts.emplace_back(*value);
    fail(node, "this must be a string");
}

const toml::table& table(const toml::node& node) {
    if (const toml::table* found = node.as_table()) return *found;
    fail(node, "this must be a table");
}

bool flag(const toml::node& node, std::string_view message) {
    if (const auto value = node.value_exact<bool>()) return *value;
    fail(node, std::string(message));
}

uint32_t wholeNumber(const toml::node& node) {
    const auto value = node.value_exact<int64_t>();
    if (!value || *value < 0 || *value > std::numeric_limits<uint32_t>::max())
        fail(node, "this must be a whole number from 0 on");
    return static_cast<uint32_t>(*value);
}

float number(const toml::node& node) {
    const auto value = node.value<double>();
    if (!node.is_number() || !value) fail(node, "this must be a number");
    return static_cast<float>(*value);
}

// The member that `key` names; `kind` is what the message calls one.
template <class Fields>
auto fieldOf(const Fields& fields, std::string_view kind, const toml::key& key, const toml::node& value) {
    std::string known;
    for (const auto& [name, member] : fields) {
        if (name == key.str()) return member;
        known += (known.empty() ? "" : ", ") + std::string(name);
    }
    fail(value,
         "there is no " + std::string(kind) + " \"" + std::string(key.str()) + "\"; there are: " + known);
}

void readNeed(Scene& scene, const toml::key& key, const toml::node& value) {
    const NeedField field = fieldOf(needFields, "need", key, value);
    if (const auto* whole = std::get_if<uint32_t SceneNeeds::*>(&field))
        scene.needs.*(*whole) = wholeNumber(value);
    else
        scene.needs.*std::get<bool SceneNeeds::*>(field) = flag(value, "a need is true or false");
}

void readCacheSetting(Scene& scene, const toml::key& key, const toml::node& value) {
    CacheSettings& cache = scene.settings.cache;
    const CacheField field = fieldOf(cacheFields, "setting of the cache", key, value);
    if (const auto* yesNo = std::get_if<bool CacheSettings::*>(&field))
        cache.*(*yesNo) = flag(value, "this must be true or false");
    else if (const auto* whole = std::get_if<uint32_t CacheSettings::*>(&field))
        cache.*(*whole) = wholeNumber(value);
    else if (const auto* size = std::get_if<float CacheSettings::*>(&field))
        cache.*(*size) = number(value);
    else
        cache.*std::get<std::string_view CacheSettings::*>(field) = text(scene, value);
}

void readOverride(Scene& scene, const toml::key& key, const toml::node& value) {
    if (value.is_table())
        fail(value, "the switch of another pass is written in quotes: \"" + std::string(key.str()) +
                        ".SWITCH\" = \"value\"");
    const std::string_view switchName = scene.texts.emplace_back(key.str());
    scene.settings.overrides.push_back({switchName, text(scene, value)});
}

void readSetting(Scene& scene, const toml::key& key, const toml::node& value) {
    if (key == "stage") {
        const auto name = text(scene, value);
        if (name != "fragment" && name != "compute") fail(value, "the stage is \"fragment\" or \"compute\"");
        scene.settings.stage = name == "compute" ? Stage::compute : Stage::fragment;
    } else if (key == "preset") {
        scene.settings.preset = text(scene, value);
    } else if (key == "colourFormat") {
        scene.settings.colourFormat = text(scene, value);
    } else if (key == "overrides") {
        for (const auto& [name, wanted] : table(value))
            readOverride(scene, name, wanted);
    } else if (key == "cache") {
        for (const auto& [name, wanted] : table(value))
            readCacheSetting(scene, name, wanted);
    } else {
        fail(value, "there is no setting \"" + std::string(key.str()) +
                        "\"; there are: stage, preset, colourFormat, overrides, cache");
    }
}

Result<void> readScene(const fs::path& file, Scene& scene) {
    auto content = readText(file);
    if (!content) return content.error();
    const auto located = [&](uint32_t line, std::string_view message) {
        return Error{ErrorCode::invalidArgument,
                     file.string() + ":" + std::to_string(line) + ": " + std::string(message)};
    };
    try {
        const toml::table root = toml::parse(*content, file.string());
        for (const auto& [section, node] : root) {
            if (section != "needs" && section != "settings")
                fail(node, "only [needs] and [settings] are known here");
            for (const auto& [key, value] : table(node))
                section == "needs" ? readNeed(scene, key, value) : readSetting(scene, key, value);
        }
    } catch (const toml::parse_error& error) {
        return located(error.source().begin.line, error.description());
    } catch (const Mistake& mistake) {
        return located(mistake.line, mistake.message);
    }
    return {};
}

void add(std::vector<Job>& jobs, const Variant& variant, Stage stage, bool vulkanAlone) {
    const Job job{reprise::forStage(variant, stage), stage, vulkanAlone};
    const auto same = [&](const Job& each) {
        return outputPath(each, Target::spirv) == outputPath(job, Target::spirv);
    };
    if (std::ranges::none_of(jobs, same)) jobs.push_back(job);
}

Result<void> addPlan(std::vector<Job>& jobs, const Pack& pack, const Scene& scene) {
    const bool vulkanAlone = scene.settings.quadOperations;
    // Which modules there are does not depend on the extent.
    auto plan =
        reprise::plan(pack.passes(), pack.presets("temporal_aa"), scene.needs, scene.settings, {64, 64});
    if (!plan) return plan.error();
    for (const reprise::PlannedPass& planned : plan->passes) {
        const auto& stages = planned.variant.pass->stages;
        add(jobs, planned.variant, planned.stage, vulkanAlone);
        if (planned.stage != Stage::fragment) continue;
        if (std::ranges::find(stages, Stage::vertex) != stages.end()) {
            add(jobs, planned.variant, Stage::vertex, vulkanAlone);
        } else {
            auto triangle = reprise::makeVariant(pack.passes(), "fullscreen");
            if (!triangle) return triangle.error();
            add(jobs, *triangle, Stage::vertex, vulkanAlone);
        }
    }
    return {};
}

} // namespace

Result<std::vector<Job>> jobsForNeeds(const Pack& pack, const fs::path& needsToml) {
    Scene scene;
    if (auto read = readScene(needsToml, scene); !read) return read.error();
    std::vector<Job> jobs;
    // What the plan asks of a device without quad operations, and what more of one with them.
    for (const bool quadOperations : {false, true}) {
        scene.settings.quadOperations = quadOperations;
        if (auto added = addPlan(jobs, pack, scene); !added)
            return Error{added.error().code, needsToml.string() + ":1: " + added.error().message};
    }
    return jobs;
}

} // namespace reprisec
