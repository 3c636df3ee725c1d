// SPDX-License-Identifier: Apache-2.0
// Which pixels of temporal_aa may see one texel of one of its inputs: what a broken texel may reach, and no
// more.
#pragma once

#include "temporal_aa_case.hpp"

namespace passes {

enum class Reached { historyOutput, colourOutput };

// True if output pixel (x, y) may depend on texel `texel` of `input`. `frame` is the frame without broken
// texels.
bool mayReach(const Variant& variant, Stage stage, const TemporalAaFrame& frame, std::string_view input,
              glm::ivec2 texel, int x, int y, Reached output);

} // namespace passes
