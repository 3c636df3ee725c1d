// SPDX-License-Identifier: Apache-2.0
// The images of a plan whose passes are chosen, and which image is which pass's input.
#pragma once

#include "reprise/plan.hpp"

namespace reprise {

inline constexpr std::string_view temporalPass = "temporal_aa", velocityImage = "gOutVelocity";
inline constexpr std::string_view upsamplePass = "bilateral_upsample", combinePass = "combine_lighting";
inline constexpr std::string_view cachePass = "reprojection_cache", filterPass = "bilateral_filter";
inline constexpr std::string_view lightingCachePass = "lighting_cache";
inline constexpr std::string_view framesPacking = "with_frames"; // CacheSettings::packing
inline constexpr std::string_view obscurancePass = "scalable_obscurance",
                                  obscuranceFilterPass = "obscurance_filter";

bool isHistory(const ImageInfo& input);
bool isImage(const ImageInfo& info); // else a buffer
// The images that an input may be, the first that an earlier pass wrote: gInVelocity is what gOutVelocity
// wrote; the framework's steps read what the step before wrote, whichever that is.
std::vector<std::string> sourcesOf(std::string_view input, const CacheSettings& cache);
// What the framework hands over: the first of these images that there is.
std::vector<std::string> lightingImages(const CacheSettings& cache);
// Image that a pass writes as this output: the two runs of the filter write two.
std::string imageName(const PlannedPass& pass, std::string_view output);

// Makes plan.images anew, with lifetimes and memory, for this extent.
void planImages(FramePlan& plan, bool engineWritesMotion, std::string_view colourFormat, Extent extent);

} // namespace reprise
