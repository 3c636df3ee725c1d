// SPDX-License-Identifier: Apache-2.0
// Frames for bilateral_filter, its execution and its comparison with the oracle.
#pragma once

#include "comparison.hpp"
#include "oracle/filter_pass.hpp"
#include "reprise/pack_table.hpp"

namespace passes {

struct BilateralFilterCase {
    oracle::FilterPass pass;
    Pixels cache, state; // as reprojection_cache leaves them
    reprise::BilateralFilterParameters parameters{};
};

oracle::CachePass::Values cachedValuesOf(const Variant& variant);
// Random values as a cache holds them, and depth where it has its place beside them.
Texel randomCached(oracle::CachePass::Values values, uint64_t seed, int x, int y, double depth);

// Random values and frames on surfaces of three depths, in blocks, and sky.
BilateralFilterCase bilateralFilterCase(const Variant& variant, int width, int height, glm::ivec2 direction,
                                        uint64_t seed);
std::vector<Pixels> run(Pass& pass, const BilateralFilterCase& frame);
Comparison compareWithOracle(const BilateralFilterCase& frame, const Pixels& filtered);

} // namespace passes
