// SPDX-License-Identifier: Apache-2.0
// The table in groups: one file each, of one header or of a few that belong together.
#pragma once

#include "check.hpp"

namespace check {

std::vector<Case> bilateralUpsamplingCases();
std::vector<Case> cacheResamplingCases(); // cache_resampling, finite
std::vector<Case> colourCases();
std::vector<Case> coordinateCases();    // conventions, coordinates
std::vector<Case> depthCases();         // depth, closest_fragment
std::vector<Case> depthEncodingCases(); // depth_encoding, bounded
std::vector<Case> directionalBilateralCases();
std::vector<Case> exponentialHistoryCases();
std::vector<Case> feedbackCases();
std::vector<Case> historyConstraintCases();
std::vector<Case> historyWriteCases();
std::vector<Case> missDetectionCases(); // miss_detection, refresh
std::vector<Case> neighbourhoodCases();
std::vector<Case> packingCases(); // occlusion_depth_packing, occlusion_shadow_packing
std::vector<Case> reprojectionCacheCases();
std::vector<Case> reprojectionCases();
std::vector<Case> samplingCases(); // jitter, sample_pattern, unjitter, motion_blur, resampling, quad_sharing
std::vector<Case> toneMappingCases();

} // namespace check
