// SPDX-License-Identifier: Apache-2.0
// Frames for combine_lighting, its execution and its comparison with the oracle.
#pragma once

#include "comparison.hpp"
#include "oracle/combine_lighting.hpp"
#include "reprise/pack_table.hpp"

namespace passes {

struct CombineLightingCase {
    oracle::CombinePass pass; // images apart
    Pixels lighting, ambient, sun, other;
    reprise::CombineLightingParameters parameters{};
};

// Random visibilities a little beyond [0,1], and lights over five decades that differ from texel to texel.
CombineLightingCase combineLightingCase(const Variant& variant, int width, int height, uint64_t seed);
std::vector<Pixels> run(Pass& pass, const CombineLightingCase& frame);
Comparison compareWithOracle(const CombineLightingCase& frame, const Pixels& lit);

} // namespace passes
