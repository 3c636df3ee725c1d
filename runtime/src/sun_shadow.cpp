// SPDX-License-Identifier: Apache-2.0
#include "reprise/sun_shadow.hpp"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

// World space to texels of a column, y down, and depth.
glm::dmat4 worldToTexels(const ShadowCascade& cascade, glm::dvec2 columnSize) {
    glm::dmat4 ndcToTexels(1.0);
    ndcToTexels[0][0] = 0.5 * columnSize.x;
    ndcToTexels[1][1] = -0.5 * columnSize.y;
    ndcToTexels[3] = glm::dvec4(0.5 * columnSize, 0.0, 1.0);
    return ndcToTexels * cascade.worldToClip;
}

glm::dvec4 row(const glm::dmat4& m, int i) {
    return {m[0][i], m[1][i], m[2][i], m[3][i]};
}

bool isOrthographicLight(const glm::dmat4& m) {
    bool finite = true, directions = true;
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(glm::dvec3(row(m, i)));
        finite = finite && std::isfinite(length) && std::isfinite(m[3][i]);
        directions = directions && length > 0.0;
    }
    return finite && directions && row(m, 3) == glm::dvec4(0.0, 0.0, 0.0, 1.0);
}

// Of each row, the number that makes the first cascade's direction this one's; 0 where none does. Engines
// compute matrices in single precision: directions may differ by as much.
glm::dvec3 scaleOf(const glm::dmat4& first, const glm::dmat4& other) {
    glm::dvec3 scale(0.0);
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 from(row(first, i)), to(row(other, i));
        const double factor = glm::dot(from, to) / glm::dot(from, from);
        if (factor > 0.0 && glm::length(to - factor * from) <= 1e-4 * glm::length(to)) scale[i] = factor;
    }
    return scale;
}

// A row in view space as one of (u d, v d, d, 1), or of (u, v, d, 1).
glm::dvec4 overScreen(const glm::dvec4& r, const glm::dvec4& ray, bool orthographic) {
    const double along = r.x * ray.z + r.y * ray.w;
    return orthographic ? glm::dvec4(r.x * ray.x, r.y * ray.y, r.z, r.w + along)
                        : glm::dvec4(r.x * ray.x, r.y * ray.y, r.z + along, r.w);
}

template <size_t count, class Vector> void store(float (&target)[count], const Vector& vector) {
    static_assert(count >= static_cast<size_t>(Vector::length()));
    for (int i = 0; i < Vector::length(); ++i)
        target[i] = static_cast<float>(vector[i]);
}

Result<void> check(std::span<const ShadowCascade> cascades, uint32_t mapWidth, uint32_t mapHeight) {
    const auto fail = [](const char* what) { return Error{ErrorCode::invalidArgument, what}; };
    if (cascades.empty() || cascades.size() > 4)
        return fail("A shadow map has one to four cascades; give as many.");
    if (mapWidth == 0 || mapHeight == 0)
        return Error{ErrorCode::zeroExtent, "The shadow map has no texels; give its whole extent."};
    if (mapWidth % cascades.size() != 0)
        return fail("The cascades are equal columns of the shadow map; give a width that they divide.");
    double before = 0.0;
    for (const ShadowCascade& cascade : cascades) {
        if (!isOrthographicLight(cascade.worldToClip))
            return fail("A cascade's worldToClip is not orthographic; give one of parallel rays.");
        if (!(cascade.farDepth > before))
            return fail("Far depths of cascades must ascend from above 0; sort the cascades.");
        before = cascade.farDepth;
    }
    return {};
}

} // namespace

Result<SunShadowParameters> sunShadowParameters(const CameraFrame& camera, glm::dvec2 frameToCoarse,
                                                std::span<const ShadowCascade> cascades, uint32_t mapWidth,
                                                uint32_t mapHeight, const SunShadowTuning& tuning) {
    if (auto checked = check(cascades, mapWidth, mapHeight); !checked) return checked.error();
    const glm::dvec2 columnSize(double(mapWidth) / double(cascades.size()), mapHeight);
    const glm::dmat4 first = worldToTexels(cascades[0], columnSize);
    SunShadowParameters parameters{};

    glm::dvec4 ray = viewRay(camera.viewToClip);
    ray.x /= frameToCoarse.x;
    ray.y /= frameToCoarse.y;
    const glm::dmat4 viewToTexels = first * glm::inverse(camera.worldToView);
    const bool orthographic = isOrthographic(camera.viewToClip);
    store(parameters.gToShadowX, overScreen(row(viewToTexels, 0), ray, orthographic));
    store(parameters.gToShadowY, overScreen(row(viewToTexels, 1), ray, orthographic));
    store(parameters.gToShadowZ, overScreen(row(viewToTexels, 2), ray, orthographic));

    float(*const scales[])[4] = {&parameters.gCascadeScale1, &parameters.gCascadeScale2,
                                 &parameters.gCascadeScale3};
    float(*const offsets[])[4] = {&parameters.gCascadeOffset1, &parameters.gCascadeOffset2,
                                  &parameters.gCascadeOffset3};
    for (size_t i = 0; i < cascades.size(); ++i) {
        parameters.gCascadeFar[i] = static_cast<float>(cascades[i].farDepth);
        if (i == 0) continue;
        const glm::dmat4 texels = worldToTexels(cascades[i], columnSize);
        const glm::dvec3 scale = scaleOf(first, texels);
        if (!(std::min({scale.x, scale.y, scale.z}) > 0.0))
            return Error{ErrorCode::invalidArgument,
                         "A cascade is not the first one scaled and moved; give all the same axes."};
        store(*scales[i - 1], scale);
        // Exact where the camera is, whatever is left of a difference in direction.
        const glm::dvec4 eye = glm::inverse(camera.worldToView)[3];
        store(*offsets[i - 1], glm::dvec3(texels * eye) - scale * glm::dvec3(first * eye));
    }
    store(parameters.gCascadeSize, glm::dvec4(columnSize, 1.0 / mapWidth, 1.0 / mapHeight));

    const glm::dvec2 texelsAMetre(glm::length(glm::dvec3(row(first, 0))),
                                  glm::length(glm::dvec3(row(first, 1))));
    const double depthAMetre = glm::length(glm::dvec3(row(first, 2)));
    store(parameters.gDisc, glm::dvec3(tuning.radius * texelsAMetre, tuning.leastTexels));
    store(parameters.gShadowBias,
          glm::dvec3(tuning.bias * depthAMetre,
                     tuning.steepest * depthAMetre / std::min(texelsAMetre.x, texelsAMetre.y)));
    return parameters;
}

} // namespace reprise
