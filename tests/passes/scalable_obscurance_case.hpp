// SPDX-License-Identifier: Apache-2.0
// Frames for scalable_obscurance and obscurance_filter, their execution and comparison with the oracle.
#pragma once

#include "ambient_occlusion_case.hpp"
#include "oracle/scalable_obscurance.hpp"

namespace passes {

inline constexpr VkFormat rgba8 = VK_FORMAT_R8G8B8A8_UNORM;

struct ScalableObscuranceCase {
    oracle::ScalableObscurance pass; // images apart
    Pixels depth;                    // metres, of the frame
    Pixels hierarchy, velocity, history;
    reprise::ScalableObscuranceParameters parameters{};
};

struct ObscuranceFilterCase {
    oracle::ObscuranceFilter pass;
    Pixels source;
    reprise::ObscuranceFilterParameters parameters{};
};

// Of the oracle: what is no depth is sky, and texels of no level are NaN.
Pixels hierarchyOf(const Pixels& depth);
// History of the surfaces' depths, some of it another surface's, some of any bytes.
ScalableObscuranceCase scalableObscuranceCase(const Variant& variant, Surfaces surfaces, int width,
                                              int height, uint64_t seed, int frame = 1);
// Sets what the shader takes from `pass`, and the hierarchy from `depth`.
void setParameters(ScalableObscuranceCase& frame);
std::vector<Pixels> run(Pass& pass, const ScalableObscuranceCase& frame);
// Digits to value, metres and frames; NaN where nothing was written.
Pixels unpacked(const Pixels& digits, double farM);
Comparison compareWithOracle(const ScalableObscuranceCase& frame, const Pixels& obscurance);

ObscuranceFilterCase obscuranceFilterCase(int width, int height, glm::ivec2 direction, uint64_t seed);
void setParameters(ObscuranceFilterCase& frame);
std::vector<Pixels> run(Pass& pass, const ObscuranceFilterCase& frame);
Comparison compareWithOracle(const ObscuranceFilterCase& frame, const Pixels& filtered);

} // namespace passes
