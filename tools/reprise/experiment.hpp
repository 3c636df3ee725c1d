// SPDX-License-Identifier: Apache-2.0
// The measurements of a report: one function per technique fills rows.
#pragma once

#include "results.hpp"
#include "rows.hpp"
#include "sequence.hpp"
#include "shaders.hpp"
#include "stopwatch.hpp"

#include "reprise/frame.hpp"

#include <string>
#include <vector>

namespace report {

struct Size {
    uint32_t width = 0, height = 0;
};

// What is measured, after the command line has been read and the defaults chosen.
struct Plan {
    std::vector<scenes::Scene> scenes;         // of anti-aliasing and motion
    std::vector<scenes::Scene> lightingScenes; // of what the framework caches
    std::vector<std::string> techniques;
    std::vector<reprise::Stage> stages;
    std::vector<std::string> flipped; // presets whose switches are flipped one by one
    Size errorSize, timingSize;
    uint32_t frames = 0, rounds = 0, truthSamples = 64;
    uint32_t truthRays = 64, truthFrames = 4; // of lighting; frames compared where each needs rays of its own
    bool timingOnly = false, quick = false;
    bool has(std::string_view technique) const;
    bool hasLighting() const;
};

// Means leave out the frames in which history has hardly begun; curves have all of them.
inline constexpr uint32_t warmUpFrames = 4;

struct Experiment {
    harness::Gpu& gpu;
    Shaders& shaders;
    const Plan& plan;
    Progress& progress;
    Report& report;
};

// The runtime at the size of the errors; throws its sentence.
reprise::FrameRecorder makeRecorder(Experiment& experiment, const reprise::SceneNeeds& needs,
                                    const reprise::Settings& settings);

// As PNG, of one frame of the scene.
void keepPicture(Report& report, const std::string& scene, const std::string& name, const Picture& picture,
                 uint32_t frame);

// In renderings of a scene, on a CPU.
inline constexpr double workPerTimingRound = 400.0, workPerTruth = 60.0;

// Steps of progress that the plan will take, in renderings of the scene.
double plannedWork(const Plan& plan, const Shaders& shaders);

double lightingWork(const Plan& plan); // the framework's part of it

// Errors of temporal_aa on one scene, in rows without times; pictures of the presets.
void measureTemporal(Experiment& experiment, scenes::Renderer& renderer);
// Errors of the velocity passes against the renderer's own motion, in pixels.
void measureVelocity(Experiment& experiment, scenes::Renderer& renderer);
// Errors of the framework on one scene, against ray casting, in rows without times.
void measureLighting(Experiment& experiment, const scenes::Scene& scene);
// Times of every distinct variant of the plan, written into the rows; with timingOnly it makes the rows.
void measureTimes(Experiment& experiment);
std::vector<Claim> judgeClaims(const Report& report, const Plan& plan);

} // namespace report
