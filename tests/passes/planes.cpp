// SPDX-License-Identifier: Apache-2.0
#include "planes.hpp"

#include <optional>

namespace passes {

namespace {

// Tilted in x and in y, so that no two pixels have the same depth.
struct Plane {
    glm::dvec3 point, normal;
    double halfSize; // of a square around the point, in x and y of the world
};
const Plane planes[] = {
    {{0.0, 0.0, 18.0}, {0.17, 0.23, -1.0}, 1e9},
    {{1.5, 0.4, 6.0}, {-0.31, 0.19, -1.0}, 2.0},
};

PlanesView viewOfEye(const CameraKind& kind, double aspect, glm::dvec3 eye, glm::dvec3 turn, double zoom) {
    return {{viewOf(eye, turn), projectionOf(kind, aspect, zoom)}, glm::dvec2(0.0), false};
}

std::optional<glm::dvec3> intersect(const Plane& plane, glm::dvec3 from, glm::dvec3 to) {
    const double share = glm::dot(plane.point - from, plane.normal) / glm::dot(to - from, plane.normal);
    const glm::dvec3 place = from + (to - from) * share;
    const glm::dvec3 away = glm::abs(place - plane.point);
    if (away.x > plane.halfSize || away.y > plane.halfSize) return {};
    return place;
}

} // namespace

PlanesView currentView(const CameraKind& kind, double aspect) {
    return viewOfEye(kind, aspect, {0.4, 0.1, -0.3}, {0.02, -0.03, 0.01}, 1.0);
}

PlanesView previousView(const CameraKind& kind, double aspect) {
    return viewOfEye(kind, aspect, {0.0, 0.3, -0.6}, {0.05, 0.01, -0.02}, 1.04);
}

Hit castRay(const PlanesView& view, glm::dvec2 px, glm::dvec2 extent) {
    // The image was moved by +jitter, so what lies at px was at px - jitter.
    const glm::dvec2 ndc = oracle::uvToNdc((px - view.jitterPx) / extent, view.sharesY);
    const glm::dmat4 viewToWorld = glm::inverse(view.camera.worldToView);
    const glm::dvec3 from(viewToWorld * oracle::viewPoint(ndc, 1.0, view.camera.viewToClip));
    const glm::dvec3 to(viewToWorld * oracle::viewPoint(ndc, 10.0, view.camera.viewToClip));
    Hit hit;
    hit.linearDepth = 1e30;
    for (int surface = 0; surface < 2; ++surface) {
        const auto place = intersect(planes[surface], from, to);
        if (!place) continue;
        const double depth = (view.camera.worldToView * glm::dvec4(*place, 1.0)).z;
        if (depth > 0.0 && depth < hit.linearDepth) hit = {*place, depth, surface};
    }
    return hit;
}

glm::dvec2 uvOf(const PlanesView& view, glm::dvec3 world) {
    const glm::dvec4 clip = view.camera.viewToClip * (view.camera.worldToView * glm::dvec4(world, 1.0));
    return oracle::ndcToUv(glm::dvec2(clip) / clip.w, view.sharesY);
}

} // namespace passes
