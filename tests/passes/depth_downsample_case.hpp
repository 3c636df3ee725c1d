// SPDX-License-Identifier: Apache-2.0
// Frames for depth_downsample, its execution and its comparison with the oracle.
#pragma once

#include "camera_case.hpp"
#include "oracle/coarse_depth.hpp"

namespace passes {

struct DepthDownsampleCase {
    glm::dmat4 viewToClip{1.0};
    oracle::CoarseDepth pass;
    Pixels depth; // device depth, or metres
    reprise::DepthDownsampleParameters parameters{};

    glm::ivec2 coarse() const { return oracle::coarseExtent({depth.width, depth.height}, pass.ratio); }
};

// Random surfaces from 0.4 to 40 m, some at the far plane, seen by a camera of the kind that the switches
// name. Of perspective cameras with reversed depth it is the infinite one if `infinite`.
DepthDownsampleCase randomDepthDownsampleCase(const Variant& variant, int width, int height, uint64_t seed,
                                              bool infinite = false);
// By how much float32 may misplace a linear depth that is made from device depth, in metres.
double linearDepthBound(const DepthDownsampleCase& frame, double linear);
std::vector<Pixels> run(Pass& pass, const DepthDownsampleCase& frame);
Comparison compareWithOracle(const DepthDownsampleCase& frame, const Pixels& coarseDepth);

} // namespace passes
