// SPDX-License-Identifier: Apache-2.0
// Frames for reprojection_cache, its execution and its comparison with the oracle.
#pragma once

#include "bilateral_filter_case.hpp"
#include "camera_case.hpp"
#include "oracle/cache_pass.hpp"

namespace passes {

struct ReprojectionCacheCase {
    oracle::CachePass pass; // images apart
    Pixels fresh, coarseDepth, velocity, history, state;
    Pixels historyDepth; // with frames, in place of the state
    reprise::ReprojectionCacheParameters parameters{};
};

// A tilted plane seen by two cameras, some of its texels nearer by a metre; the history holds the depth that
// the previous camera saw, or another one in a sixth of the texels. width and height are the frame's.
ReprojectionCacheCase reprojectionCacheCase(const Variant& variant, int width, int height, uint64_t seed);
// Of its outputs and lighting_cache's: 32 bits of values, and of state where there is one.
std::vector<VkFormat> cacheFormats(const Variant& variant);
// The depths of a state.
Pixels depthsOf(const Pixels& state);
// Sets what the shader takes from `pass`, by the runtime's own functions.
void setParameters(ReprojectionCacheCase& frame);
std::vector<Pixels> run(Pass& pass, const ReprojectionCacheCase& frame);
// outputs: values and state; with frames values alone.
Comparison compareWithOracle(const ReprojectionCacheCase& frame, const std::vector<Pixels>& outputs);

} // namespace passes
