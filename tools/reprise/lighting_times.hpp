// SPDX-License-Identifier: Apache-2.0
// Times of whole frame plans and of each of their passes, beside the passes' own floors.
#pragma once

#include "experiment.hpp"

#include <array>

namespace report {

// Two frames that take turns, so that history is reprojected, and what the engine gives beside them.
struct TimedInput {
    std::array<reprise::FrameInput, 2> frames;
    Size size;
};

struct TimedPlan {
    std::string section; // of the whole frame
    std::vector<std::string>
        passes; // section of each pass of the plan, with its floor under floorOf(section)
    reprise::FramePlan plan;
};
std::string floorOf(const std::string& section);

// Adds sections for the frame as the recorder records it, and for each pass alone. label: unique.
TimedPlan addPlan(Experiment& experiment, Stopwatch& watch, const std::string& label,
                  const reprise::SceneNeeds& needs, const reprise::Settings& settings,
                  const TimedInput& input);

} // namespace report
