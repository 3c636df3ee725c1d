// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include <algorithm>

namespace check {

std::vector<Case> table() {
    std::vector<Case> all;
    for (const auto group :
         {bilateralUpsamplingCases, cacheResamplingCases, colourCases, coordinateCases, depthCases,
          depthEncodingCases, directionalBilateralCases, exponentialHistoryCases, feedbackCases,
          historyConstraintCases, historyWriteCases, missDetectionCases, neighbourhoodCases, packingCases,
          reprojectionCacheCases, reprojectionCases, samplingCases, toneMappingCases})
        for (Case& each : group())
            all.push_back(std::move(each));
    std::stable_sort(all.begin(), all.end(),
                     [](const Case& a, const Case& b) { return a.header() < b.header(); });
    return all;
}

} // namespace check
