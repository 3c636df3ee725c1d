// SPDX-License-Identifier: Apache-2.0
// Placing a camera in the right-handed, y-up world.
#pragma once

#include <glm/glm.hpp>

namespace scenes {

// World to view space (x right, y up, +z forward). `up` must not be parallel to the direction of view.
glm::dmat4 lookAt(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up = {0.0, 1.0, 0.0});

} // namespace scenes
