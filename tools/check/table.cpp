// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include <algorithm>

namespace check {

std::vector<Case> table() {
    std::vector<Case> all;
    for (const auto group :
         {bilateralUpsamplingCases, cacheCases, colourCases, coordinateCases, depthCases, feedbackCases,
          historyConstraintCases, missDetectionCases, neighbourhoodCases, reprojectionCases, samplingCases})
        for (Case& each : group())
            all.push_back(std::move(each));
    std::stable_sort(all.begin(), all.end(),
                     [](const Case& a, const Case& b) { return a.header() < b.header(); });
    return all;
}

} // namespace check
