// SPDX-License-Identifier: Apache-2.0
// hdr_emitters: an alley at night with bulbs, tubes and points of radiance 50 to 2000, many below a pixel
// wide.
#include "builtin.hpp"

#include <cmath>

namespace scenes::build {
namespace {

void addAlley(Scene& scene) {
    const uint32_t road = addMaterial(
        scene, {.texture = addTexture(scene, concrete(512, {0.3f, 0.3f, 0.33f}, 0.9f)), .roughness = 0.3f});
    const uint32_t brick = addMaterial(
        scene, {.texture = addTexture(scene, bricks(512, {0.36f, 0.24f, 0.22f}, {0.25f, 0.24f, 0.24f}))});
    const uint32_t metal = addMaterial(scene, {.baseColour = {0.08f, 0.09f, 0.1f, 1}, .roughness = 0.35f});
    addInstance(scene, addMesh(scene, floor({30, 60}, 0.3f)), road, at(0, 0, -20));
    const uint32_t wall = addMesh(scene, box({0.5f, 7, 40}, 0.4f));
    addInstance(scene, wall, brick, at(-4.2, 3.5, -18));
    addInstance(scene, wall, brick, at(4.2, 3.5, -18));
    addInstance(scene, addMesh(scene, box({9, 9, 0.5f}, 0.4f)), brick, at(0, 4.5, -28));
    Mesh pipes;
    for (int i = 0; i < 6; ++i) {
        const float z = -4.0f - 3.6f * float(i), side = (i & 1) ? 3.75f : -3.75f;
        append(pipes, rod({side, 0, z}, {side, 7, z}, 0.07f, 8));
        append(pipes, box({0.9f, 0.8f, 0.8f}),
               glm::translate(glm::mat4(1.0f), {side * 0.92f, 0.4f, z + 1.2f}));
    }
    for (int i = 0; i < 5; ++i)
        append(pipes, wire({-4, 4.9f, -5.0f * float(i) - 4}, {4, 4.6f, -5.0f * float(i) - 6}, 0.5f, 0.012f));
    addInstance(scene, addMesh(scene, pipes), metal, glm::dmat4(1.0));
}

uint32_t glow(Scene& scene, glm::vec3 radiance) {
    return addMaterial(scene, {.baseColour = {0, 0, 0, 1}, .emission = radiance});
}

// Strings of bulbs across the alley, 200 to 2000.
void addBulbs(Scene& scene) {
    const uint32_t bulb = addMesh(scene, sphere(0.035f, 8, 12));
    const uint32_t warm[3] = {glow(scene, {200, 130, 60}), glow(scene, {800, 500, 220}),
                              glow(scene, {2000, 1300, 600})};
    for (int row = 0; row < 5; ++row) {
        for (int i = 1; i < 12; ++i) {
            const double t = i / 12.0, sag = 0.5 * 4.0 * t * (1.0 - t);
            addInstance(scene, bulb, warm[(i + row) % 3],
                        at(-4 + 8 * t, 4.85 - 0.3 * t - sag, -5.0 * row - 4 - 2 * t));
        }
    }
}

// Neon tubes 2.4 cm wide: a frame, a zigzag and long lines that run into the distance.
void addTubes(Scene& scene) {
    Mesh frame, zigzag, lines;
    const glm::vec3 corner[] = {
        {-3.85f, 1.6f, -6}, {-3.85f, 3.2f, -6}, {-3.85f, 3.2f, -8.5f}, {-3.85f, 1.6f, -8.5f}};
    for (int i = 0; i < 4; ++i)
        append(frame, rod(corner[i], corner[(i + 1) & 3], 0.012f));
    for (int i = 0; i < 8; ++i)
        append(zigzag, rod({3.85f, (i & 1) ? 3.0f : 2.0f, -7.0f - 0.4f * float(i)},
                           {3.85f, (i & 1) ? 2.0f : 3.0f, -7.4f - 0.4f * float(i)}, 0.012f));
    for (float side : {-3.9f, 3.9f})
        append(lines, rod({side, 0.08f, -2}, {side, 0.08f, -27}, 0.012f));
    addInstance(scene, addMesh(scene, frame), glow(scene, {300, 20, 120}), glm::dmat4(1.0));
    addInstance(scene, addMesh(scene, zigzag), glow(scene, {20, 160, 400}), glm::dmat4(1.0));
    addInstance(scene, addMesh(scene, lines), glow(scene, {10, 60, 50}), glm::dmat4(1.0));
}

// Panels of points 2 cm wide on the far wall.
void addPanels(Scene& scene) {
    Mesh panel[3];
    for (int y = 0; y < 14; ++y)
        for (int x = 0; x < 30; ++x)
            append(
                panel[int(hash(x, y, 81) * 3.0f)], box(glm::vec3(0.03f)),
                glm::translate(glm::mat4(1.0f), {-2.9f + 0.2f * float(x), 1.2f + 0.2f * float(y), -27.7f}));
    const glm::vec3 colours[] = {{50, 50, 60}, {10, 120, 30}, {250, 60, 10}};
    for (int i = 0; i < 3; ++i)
        addInstance(scene, addMesh(scene, panel[i]), glow(scene, colours[i]), glm::dmat4(1.0));
}

} // namespace

Scene hdrEmitters() {
    Scene scene;
    scene.name = "hdr_emitters";
    scene.shows = "Bulbs, thin tubes and points of radiance 50 to 2000 against the dark, under a slow dolly.";
    scene.sunDirection = glm::normalize(glm::vec3(0.25f, 0.9f, 0.3f));
    scene.sunRadiance = glm::vec3(0.05f, 0.06f, 0.09f);
    scene.skyRadiance = glm::vec3(0.012f, 0.016f, 0.03f);
    scene.groundRadiance = glm::vec3(0.01f, 0.009f, 0.008f);
    scene.lights = {{{0, 4.2f, -6}, {2.2f, 1.5f, 0.75f}},
                    {{0, 4.0f, -17}, {2.6f, 1.7f, 0.8f}},
                    {{-3.5f, 2.4f, -7.2f}, {1.3f, 0.15f, 0.6f}},
                    {{3.5f, 2.5f, -8.6f}, {0.15f, 0.7f, 1.6f}}};
    scene.farPlane = 80.0;
    addAlley(scene);
    addBulbs(scene);
    addTubes(scene);
    addPanels(scene);
    scene.worldToView = [](double seconds) {
        const glm::dvec3 eye(0.4 * std::sin(0.5 * seconds), 1.7, 0.8 - 0.8 * seconds);
        return lookAt(eye, eye + glm::dvec3(-0.03, 0.1, -1.0));
    };
    return scene;
}

} // namespace scenes::build
