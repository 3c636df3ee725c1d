// SPDX-License-Identifier: Apache-2.0
// Frames for bilateral_upsample, its execution and its comparison with the oracle.
#pragma once

#include "bilateral_filter_case.hpp"
#include "depth_downsample_case.hpp"

namespace passes {

struct BilateralUpsampleCase {
    oracle::UpsamplePass pass;  // images apart
    DepthDownsampleCase depths; // of the frame; the coarse ones are what the oracle makes of them
    Pixels filtered, coarseDepth, normal;
    reprise::BilateralUpsampleParameters parameters{};
};

// Random values over the random depths of randomDepthDownsampleCase(), random normals that see the camera or
// not.
BilateralUpsampleCase bilateralUpsampleCase(const Variant& variant, int width, int height, uint64_t seed);
std::vector<Pixels> run(Pass& pass, const BilateralUpsampleCase& frame);
Comparison compareWithOracle(const BilateralUpsampleCase& frame, const Pixels& upsampled);

} // namespace passes
