// SPDX-License-Identifier: Apache-2.0
// The program's commands. Each throws std::exception with one sentence; main() prints it and ends with 1.
#pragma once

#include "check.hpp"
#include "experiment.hpp"
#include "floors.hpp"

#include "reprise/plan.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace report {

struct ReportOptions {
    bool quick = false, timingOnly = false, fresh = false, allRows = false;
    std::vector<std::string> scenes; // names of built-in ones, or files
    std::string technique;           // empty: all
    std::string size;                // "1280x720", empty: the defaults
    int frames = 0;                  // 0: the default
    std::string stage = "both";
    std::string device;
    std::vector<std::string> flips{"inside"};
    std::filesystem::path out = "report";
};

struct CheckOptions {
    bool quick = false;
    std::string function; // empty: all
    std::string device;
    std::filesystem::path out = "check.json";
};

struct PlanOptions {
    reprise::SceneNeeds needs;
    reprise::CacheSettings cache; // but for the next three
    std::string occlusion = "ambient_occlusion", packing = "shadow_in_integer";
    uint32_t samples = 0; // 0: the default of the pass `occlusion`
    std::string stage = "compute", preset = "best", size = "1920x1080";
};

struct PlanCost {
    uint64_t spirvBytes = 0; // of each module once
    // A pass counts by its output's share of the frame's pixels, geometry as if it covered the frame.
    double readsPerPixel = 0.0;
};

struct RenderOptions {
    std::string scene, size = "640x360", device, show = "colour";
    int frame = 0;
    bool truth = false;
    double radius = 1.0; // of occlusion, metres
    uint32_t rays = 256; // a pixel
    std::filesystem::path out;
};

void reportCommand(const ReportOptions& options);
void checkCommand(const CheckOptions& options);
// The command over a table of the caller's own; `unchecked` are functions to be reported as without a case.
void checkCases(const CheckOptions& options, const std::vector<check::Case>& cases,
                const std::vector<check::PublicFunction>& unchecked);
void listCommand();
void planCommand(const PlanOptions& options);
void renderCommand(const RenderOptions& options);

// "1280x720"; throws a sentence on anything else and on sizes that no device has.
Size parseSize(const std::string& text);
std::vector<reprise::Stage> parseStages(const std::string& text);
// A built-in scene's name, or a file.
scenes::Scene findScene(const std::string& nameOrFile);
// What a file asked for and did not get, on stderr.
void printNotes(const scenes::Scene& scene);
reprise::FramePlan makeFramePlan(Shaders& shaders, const reprise::SceneNeeds& needs,
                                 const reprise::Settings& settings,
                                 Size size); // throws the runtime's sentence
// The plan of `needs` under the settings of `options`, whose own needs are not looked at; it must not
// outlive the options.
reprise::FramePlan planFor(Shaders& shaders, const reprise::SceneNeeds& needs, const PlanOptions& options);
// What `reprise plan` compares a scene with: occlusion and shadows in one cache, anti-aliasing with the
// fallback for fast motion, rigid and skinned objects that move; CacheSettings as they are by default.
reprise::FramePlan planOfEverything(Shaders& shaders, const PlanOptions& options);
PlanCost costOf(Shaders& shaders, const reprise::FramePlan& plan, Size size);
// "0: llvmpipe ..., cpu"
std::vector<std::string> deviceLines();
Plan makePlan(const ReportOptions& options, const reprisec::Pack& pack);

} // namespace report
