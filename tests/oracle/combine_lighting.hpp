// SPDX-License-Identifier: Apache-2.0
// Light put together: what each part of it is taken away from by a visibility, and the sum.
#pragma once

#include "colour.hpp"
#include "image.hpp"

namespace oracle {

struct CombinePass {
    bool occluded = true, shadowed = true, addsOther = false;
    const Image* lighting = nullptr; // (occlusion, shadow), or the one of them that there is
    const Image* ambient = nullptr;
    const Image* sun = nullptr;
    const Image* other = nullptr;
};

// What lets an unknown share of light through lets all of it.
inline double visibilityOf(double value) {
    return std::abs(value) <= 1e38 ? std::clamp(value, 0.0, 1.0) : 1.0;
}

inline dvec3 litColour(const CombinePass& pass, int x, int y) {
    const dvec4 lighting = pass.lighting->at(x, y);
    dvec3 sum(0.0);
    if (pass.occluded) sum += visibilityOf(lighting.x) * sanitize(dvec3(pass.ambient->at(x, y)));
    if (pass.shadowed)
        sum += visibilityOf(pass.occluded ? lighting.y : lighting.x) * sanitize(dvec3(pass.sun->at(x, y)));
    if (pass.addsOther) sum += sanitize(dvec3(pass.other->at(x, y)));
    return glm::min(sum, dvec3(maxColour));
}

} // namespace oracle
