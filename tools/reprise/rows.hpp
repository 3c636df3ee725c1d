// SPDX-License-Identifier: Apache-2.0
// Which rows a report has. All come from the table of passes: a new switch or preset is a new row by itself.
#pragma once

#include "reprise/camera.hpp"
#include "reprisec.hpp"
#include "scenes.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace report {

struct RowSpec {
    std::string label;                       // "inside + constraint clamp"
    std::optional<reprise::Variant> variant; // absent: the image as rendered, without anti-aliasing
    reprise::JitterSequence jitter = reprise::JitterSequence::halton16;
    bool cutIsTold = true;         // history is declared invalid at the scene's camera cut
    std::string preset = "inside"; // whose feedback weights the row has
    bool cameraAlone = false;      // only in scenes of which cameraMovesAlone()
};

std::string jitterName(reprise::JitterSequence sequence);
std::string switchText(const reprise::SwitchInfo& info, uint8_t value); // "constraint clamp"
// Switches that say what the engine's data is, not what to do with it: a report has one kind of data.
bool describesInput(const reprise::SwitchInfo& info);

// Then the plan has MOTION camera, and there are no motion vectors.
bool cameraMovesAlone(const scenes::Scene& scene);

// Rows of temporal_aa in `stage`: none, every preset, those of the project with MOTION camera too, every
// switch of `flipped` presets flipped alone, the sample sequences, and the document's preset without being
// told of the cut.
std::vector<RowSpec> temporalRows(const reprisec::Pack& pack, reprise::Stage stage,
                                  std::span<const std::string> flipped);
// Of the presets' rows, those with MOTION camera among them.
std::vector<std::string> presetLabels(const reprisec::Pack& pack);

} // namespace report
