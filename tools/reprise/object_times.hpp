// SPDX-License-Identifier: Apache-2.0
// Times of the pass that draws geometry: the runtime's own pipeline and draws, and a floor that draws the
// same.
#pragma once

#include "experiment.hpp"

#include <string>
#include <vector>

namespace report {

struct ObjectSection {
    reprise::Variant variant;
    std::string scene;           // whose moving objects are drawn
    std::string name, floorName; // in the stopwatch
};
// Adds object_velocity and its floor for the moving objects of frame `index` of every scene that has any, at
// the plan's size of times. What the time depends on is the geometry, so every scene has its own.
std::vector<ObjectSection> addObjectSections(Experiment& experiment, Stopwatch& watch, uint32_t index);

// HLSL of the floor, with both entries: the same vertex input, bindings and coverage, one value interpolated
// and written.
std::string objectFloorSource(bool skinned);

} // namespace report
