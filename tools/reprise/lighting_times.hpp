// SPDX-License-Identifier: Apache-2.0
// Times of whole frame plans and of each of their passes, beside the passes' own floors.
#pragma once

#include "lighting_rows.hpp"

namespace report {

struct TimedPlan {
    std::string section; // of the whole frame
    // Section of each pass of the plan alone, if they were asked for; empty: of this one not.
    std::vector<std::string> passes;
    reprise::FramePlan plan;
};

// A row of the framework, timed on a scene: scenes with the same needs share it.
struct TimedLighting {
    LightingSpec spec;
    reprise::Stage stage;
    size_t scene = 0; // of Plan::lightingScenes
    TimedPlan timed;
};
std::vector<TimedLighting> addLighting(Experiment& experiment, Stopwatch& watch);
// Times, memory and reads into the rows; rows of each pass alone, with its floor.
void fillLighting(Experiment& experiment, const Stopwatch& watch, const std::vector<TimedLighting>& timed);

} // namespace report
