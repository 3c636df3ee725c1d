// SPDX-License-Identifier: Apache-2.0
// Frames for ambient_occlusion, its execution and its comparison with the oracle.
#pragma once

#include "camera_case.hpp"
#include "oracle/ambient_occlusion.hpp"

namespace passes {

struct AmbientOcclusionCase {
    oracle::AmbientOcclusion pass; // images apart
    Pixels depth, normal;          // the normals of the frame
    reprise::AmbientOcclusionParameters parameters{};
};

enum class Surfaces { random, corner }; // every texel its own depth; or the corner of a room and a card

// A tenth of the texels are sky. The frame is twice as large and a pixel less, which an odd size makes of it.
AmbientOcclusionCase ambientOcclusionCase(const Variant& variant, Surfaces surfaces, int width, int height,
                                          uint64_t seed, int frame = 1);
// Gives it the frame of another ratio, 1, 2 or 4.
void setRatio(AmbientOcclusionCase& frame, int ratio, uint64_t seed);
// Sets what the shader takes from `pass`.
void setParameters(AmbientOcclusionCase& frame);
std::vector<Pixels> run(Pass& pass, const AmbientOcclusionCase& frame);
Comparison compareWithOracle(const AmbientOcclusionCase& frame, const Pixels& occlusion);

} // namespace passes
