// SPDX-License-Identifier: Apache-2.0
// Frames for sun_shadow, its execution and its comparison with the oracle.
#pragma once

#include "ambient_occlusion_case.hpp"
#include "oracle/sun_shadow.hpp"
#include "reprise/sun_shadow.hpp"

namespace passes {

struct SunShadowCase {
    oracle::SunShadow pass; // images apart
    enum class Values { one, two, occlusionInInteger, shadowInInteger } values = Values::one;
    reprise::CameraFrame camera;
    std::vector<reprise::ShadowCascade> cascades;
    Pixels depth, map, occlusion;
    reprise::SunShadowParameters parameters{};
};

// A shadow map of noise, so that each of its texels counts. Some pixels are sky, some lie beyond the last
// cascade or beside their own.
SunShadowCase sunShadowCase(const Variant& variant, Surfaces surfaces, int width, int height, uint64_t seed,
                            int frame = 1);
// Sets what the shader takes from `pass`, the camera and the cascades.
void setParameters(SunShadowCase& frame);
// The light's rays as NDC of a column of `extent` metres around `centre`, depth over `range` metres.
glm::dmat4 lightClip(glm::dvec3 centre, glm::dvec2 extent, double range, bool reversed);
std::vector<Pixels> run(Pass& pass, const SunShadowCase& frame);
Comparison compareWithOracle(const SunShadowCase& frame, const Pixels& shadow);

} // namespace passes
