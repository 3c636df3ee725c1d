// SPDX-License-Identifier: Apache-2.0
// Two planes and two cameras, ray cast in double precision: what a pass must find, without any formula of a
// pass.
#pragma once

#include "camera_case.hpp"

namespace passes {

struct PlanesView {
    oracle::Camera camera;
    glm::dvec2 jitterPx{0.0};
    bool sharesY = false; // NDC y and UV y run the same way
};

struct Hit {
    glm::dvec3 world{0.0};
    double linearDepth = 0.0;
    int surface = 0; // 0 the background, 1 the card in front of it
};

// The two cameras of a kind: moved sideways, forward, turned and zoomed by several pixels' worth.
PlanesView currentView(const CameraKind& kind, double aspect);
PlanesView previousView(const CameraKind& kind, double aspect);

// What the ray through `px` (pixel coordinates, centres at halves) of the jittered rendering hits first.
Hit castRay(const PlanesView& view, glm::dvec2 px, glm::dvec2 extent);
// Where a world point lies in the unjittered image of a view.
glm::dvec2 uvOf(const PlanesView& view, glm::dvec3 world);

} // namespace passes
