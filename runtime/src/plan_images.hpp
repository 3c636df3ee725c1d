// SPDX-License-Identifier: Apache-2.0
// The images of a plan whose passes are chosen.
#pragma once

#include "reprise/plan.hpp"

namespace reprise {

inline constexpr std::string_view temporalPass = "temporal_aa", velocityImage = "gOutVelocity";

bool isHistory(const ImageInfo& input);
bool isImage(const ImageInfo& info); // else a buffer
// gInVelocity is what gOutVelocity wrote.
std::string writtenName(std::string_view input);

// Makes plan.images anew, with lifetimes and memory, for this extent.
void planImages(FramePlan& plan, bool engineWritesMotion, std::string_view colourFormat, Extent extent);

} // namespace reprise
