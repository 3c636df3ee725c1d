// SPDX-License-Identifier: Apache-2.0
// From what was typed to what will be measured.
#include "commands.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace report {
namespace fs = std::filesystem;
namespace {

constexpr const char* testModels = "/usr/share/assimp/models"; // package assimp-testmodels
constexpr uint32_t largestSide = 16384; // what Vulkan devices have as the largest 2D image

std::optional<uint32_t> number(std::string_view text) {
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return {};
    return value;
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const scenes::Scene& scene : scenes::allScenes())
        names.push_back(scene.name);
    return names;
}

// The file, or the first of that name among Debian's test models; empty if there is none.
fs::path findModel(const std::string& name) {
    std::error_code error;
    if (fs::is_regular_file(name, error)) return name;
    if (fs::path(name).has_parent_path()) return {};
    for (const auto& entry : fs::recursive_directory_iterator(testModels, error))
        if (entry.path().filename() == name) return entry.path();
    return {};
}

// Passes that read anything else, or write an image of another extent, are measured in the frame that they
// are steps of: "occlusion", "shadow".
bool hasData(const reprise::PassInfo& pass) {
    constexpr std::string_view known[] = {"gInColour", "gInDepth", "gInVelocity", "gHistoryColour"};
    const auto isWhole = [](const reprise::ImageInfo& image) {
        return image.scale == 1.0f && image.widthScale == 1.0f;
    };
    return std::ranges::all_of(pass.outputs, isWhole) &&
           std::ranges::all_of(pass.inputs, [&](const reprise::ImageInfo& input) {
               const std::string_view name = input.sameAs.empty() ? input.name : input.sameAs;
               return input.format.empty() ||
                      (isWhole(input) && std::ranges::find(known, name) != std::end(known));
           });
}

std::vector<std::string> techniqueNames(const reprisec::Pack& pack) {
    std::vector<std::string> names;
    for (const auto& pass : pack.passes())
        if (pass.name != "fullscreen" && hasData(pass)) names.emplace_back(pass.name);
    names.insert(names.end(), {"occlusion", "shadow"});
    return names;
}

std::vector<std::string> chosenTechniques(const std::string& technique, const reprisec::Pack& pack) {
    const auto names = techniqueNames(pack);
    if (technique.empty()) return names;
    if (technique == "lighting") return {"occlusion", "shadow"}; // and both in one cache
    if (std::find(names.begin(), names.end(), technique) == names.end())
        throw std::runtime_error(fmt::format("--technique {} is not known; there are {}, lighting", technique,
                                             fmt::join(names, ", ")));
    return {technique};
}

std::vector<std::string> chosenFlips(const std::vector<std::string>& flips, const reprisec::Pack& pack) {
    std::vector<std::string> known;
    for (const auto& preset : pack.presets("temporal_aa"))
        known.emplace_back(preset.name);
    for (const std::string& name : flips)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw std::runtime_error(
                fmt::format("--flips {} is not a preset; there are {}", name, fmt::join(known, ", ")));
    return flips;
}

} // namespace

Size parseSize(const std::string& text) {
    const size_t x = text.find('x');
    const auto width = number(text.substr(0, x));
    const auto height = x == std::string::npos ? std::nullopt : number(std::string_view(text).substr(x + 1));
    if (!width || !height)
        throw std::runtime_error(fmt::format("--size {} is not WIDTHxHEIGHT, for example 1280x720", text));
    if (*width == 0 || *height == 0 || *width > largestSide || *height > largestSide)
        throw std::runtime_error(
            fmt::format("--size {} must have both sides from 1 to {}", text, largestSide));
    return {*width, *height};
}

std::vector<reprise::Stage> parseStages(const std::string& text) {
    if (text == "fragment") return {reprise::Stage::fragment};
    if (text == "compute") return {reprise::Stage::compute};
    if (text == "both") return {reprise::Stage::fragment, reprise::Stage::compute};
    throw std::runtime_error(fmt::format("--stage {} is not one of fragment, compute, both", text));
}

scenes::Scene findScene(const std::string& nameOrFile) {
    for (scenes::Scene& scene : scenes::allScenes())
        if (scene.name == nameOrFile) return std::move(scene);
    const std::filesystem::path file = findModel(nameOrFile);
    if (file.empty())
        throw std::runtime_error(
            fmt::format("--scene {} is neither a file nor a built-in scene; those are {}", nameOrFile,
                        fmt::join(sceneNames(), ", ")));
    auto loaded = scenes::loadScene(file);
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return std::move(*loaded);
}

void printNotes(const scenes::Scene& scene) {
    for (const std::string& note : scene.notes)
        fmt::print(stderr, "{}: {}\n", scene.name, note);
}

Plan makePlan(const ReportOptions& options, const reprisec::Pack& pack) {
    if (options.frames < 0) throw std::runtime_error("--frames must be at least 1");
    Plan plan;
    plan.stages = parseStages(options.stage);
    plan.techniques = chosenTechniques(options.technique, pack);
    plan.flipped = chosenFlips(options.flips, pack);
    plan.timingOnly = options.timingOnly;
    plan.quick = options.quick;
    plan.truthRays = options.quick ? 64 : 256;
    plan.truthFrames = options.quick ? 4 : 8;
    plan.errorSize = options.quick ? Size{320, 180} : Size{640, 360};
    plan.timingSize = {1280, 720};
    if (!options.size.empty()) plan.errorSize = plan.timingSize = parseSize(options.size);
    plan.frames = options.frames > 0 ? static_cast<uint32_t>(options.frames) : options.quick ? 16u : 32u;
    plan.rounds = options.quick ? 9 : 15;
    for (const std::string& name : options.scenes)
        plan.scenes.push_back(findScene(name));
    plan.lightingScenes = plan.scenes.empty() ? scenes::lightingScenes() : plan.scenes;
    if (plan.scenes.empty()) plan.scenes = scenes::builtInScenes();
    return plan;
}

} // namespace report
