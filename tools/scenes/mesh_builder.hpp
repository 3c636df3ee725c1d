// SPDX-License-Identifier: Apache-2.0
// Procedural meshes: counter-clockwise seen from outside, unit normals, uv in repeats of the texture.
#pragma once

#include "scenes.hpp"

namespace scenes::build {

void append(Mesh& into, const Mesh& part, const glm::mat4& transform = glm::mat4(1.0f));

// Centred on the origin; uvScale is texture repeats per metre.
Mesh box(glm::vec3 size, float uvScale = 1.0f);
// In the xz plane, facing +y.
Mesh floor(glm::vec2 size, float uvScale = 1.0f);
// In the xy plane with its lower edge centred on the origin, facing +z; uv covers the texture once.
Mesh card(glm::vec2 size);
Mesh sphere(float radius, uint32_t rings, uint32_t segments, float uvScale = 1.0f);
Mesh torus(float radius, float tube, uint32_t rings, uint32_t segments, float uvScale = 1.0f);
// A closed cylinder between two points.
Mesh rod(glm::vec3 from, glm::vec3 to, float radius, uint32_t sides = 6);
// A wire hanging between two points, `sag` below their line at mid-span.
Mesh wire(glm::vec3 from, glm::vec3 to, float sag, float radius, uint32_t segments = 16);
// A skinned column along +y whose joints stand at equal heights, joint 0 at its foot.
Mesh bendingColumn(float radius, float height, uint32_t sides, uint32_t rings, uint32_t joints);

} // namespace scenes::build
