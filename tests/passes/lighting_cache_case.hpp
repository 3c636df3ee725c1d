// SPDX-License-Identifier: Apache-2.0
// Frames for lighting_cache and their execution, by it and by the three passes whose work it does.
#pragma once

#include "reprojection_cache_case.hpp"
#include "sun_shadow_case.hpp"

namespace passes {

struct LightingCacheCase {
    AmbientOcclusionCase occlusion;
    SunShadowCase shadow;
    ReprojectionCacheCase cache;
    Pixels halfDepth;
    reprise::LightingCacheParameters parameters{};
};

// Depths that a binary16 holds, so that points are compared with the same. The history lies where the
// surfaces are, some of it a metre off, and its values are within what the fresh ones scatter or not.
LightingCacheCase lightingCacheCase(const Variant& variant, int width, int height, uint64_t seed);
std::vector<Pixels> run(Pass& pass, const LightingCacheCase& frame);

// ambient_occlusion, sun_shadow and reprojection_cache one after the other, which their own tests hold to the
// oracle: compute forms, 32 bits.
class SeparatePasses {
public:
    explicit SeparatePasses(const Variant& variant);
    std::vector<Pixels> operator()(LightingCacheCase frame);

private:
    std::string fresh_;
    Pass occlusion_, shadow_, cache_;
};

// But for roundings, and of the deviation of sixteen, which is made from squares here, the root of one.
// Beside half a step of a packed integer either comes out.
Comparison compareWithSeparate(const LightingCacheCase& frame, const std::vector<Pixels>& got,
                               const std::vector<Pixels>& separate);

} // namespace passes
