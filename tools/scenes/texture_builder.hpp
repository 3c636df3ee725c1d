// SPDX-License-Identifier: Apache-2.0
// Procedural textures, sRGB RGBA8, tiling unless they carry a shape in alpha.
#pragma once

#include "scenes.hpp"

namespace scenes::build {

// Deterministic value in [0,1) of a lattice point.
float hash(int x, int y, uint32_t seed);
// Smooth value noise in [0,1], repeating after `period` lattice steps.
float noise(float x, float y, int period, uint32_t seed);

Texture checker(uint32_t size, uint32_t cells, glm::vec3 first, glm::vec3 second);
Texture bricks(uint32_t size, glm::vec3 brick, glm::vec3 mortar);
Texture mosaic(uint32_t size, uint32_t cells);
Texture planks(uint32_t size, glm::vec3 wood);
Texture concrete(uint32_t size, glm::vec3 colour, float contrast);
Texture grassGround(uint32_t size);
// A poster: coloured blocks and rows of letter-like marks, full of high frequencies.
Texture poster(uint32_t size, uint32_t seed);
// Alpha shapes: a twig with leaves; a tuft of blades.
Texture leaves(uint32_t size, uint32_t seed);
Texture blades(uint32_t size, uint32_t seed);

} // namespace scenes::build
