// SPDX-License-Identifier: Apache-2.0
// fast_object: a room of detailed textures, and things that cross it at 8 to 25 pixels a frame (640×360, 60
// Hz): at 6 m one metre a second is about one pixel a frame. The camera stands still, so every change of the
// background is a disocclusion.
#include "builtin.hpp"

#include <algorithm>
#include <cmath>

namespace scenes::build {
namespace {

void addRoom(Scene& scene) {
    const uint32_t tiles =
        addMaterial(scene, {.texture = addTexture(scene, mosaic(512, 32)), .roughness = 0.35f});
    const uint32_t brick = addMaterial(
        scene, {.texture = addTexture(scene, bricks(512, {0.6f, 0.3f, 0.22f}, {0.62f, 0.6f, 0.55f}))});
    const uint32_t wood =
        addMaterial(scene, {.texture = addTexture(scene, planks(512, {0.62f, 0.45f, 0.28f}))});
    addInstance(scene, addMesh(scene, floor({14, 14}, 0.4f)), tiles, at(0, 0, -5));
    const uint32_t wall = addMesh(scene, box({14, 5, 0.3f}, 0.5f));
    addInstance(scene, wall, brick, at(0, 2.5, -9));
    addInstance(scene, wall, wood, at(-6.4, 2.5, -5) * turned(1.5708));
    addInstance(scene, wall, wood, at(6.4, 2.5, -5) * turned(-1.5708));
    for (int i = 0; i < 5; ++i) {
        const uint32_t paper =
            addMaterial(scene, {.texture = addTexture(scene, poster(512, 70 + uint32_t(i)))});
        const uint32_t sheet = addMesh(scene, card({1.5f, 2.1f}));
        addInstance(scene, sheet, paper, at(-4.4 + 2.2 * i, 1.1 + 0.25 * (i & 1), -8.83));
    }
}

void addCrossing(Scene& scene) {
    const uint32_t crate = addMaterial(
        scene, {.texture = addTexture(scene, checker(256, 8, {0.85f, 0.25f, 0.15f}, {0.95f, 0.9f, 0.8f}))});
    const uint32_t blue = addMaterial(scene, {.baseColour = {0.1f, 0.25f, 0.6f, 1}, .roughness = 0.25f});
    const uint32_t striped = addMaterial(
        scene, {.texture = addTexture(scene, planks(256, {0.9f, 0.75f, 0.2f})), .roughness = 0.3f});
    // Peak speeds 2.6 × 7 = 18 m/s at 6.5 m, 2.2 × 5 = 11 m/s at 4.8 m, and a ring that turns where it
    // stands.
    addMoving(scene, addMesh(scene, box(glm::vec3(0.8f), 1.25f)), crate, [](double t) {
        return at(2.6 * std::sin(7.0 * t), 1.7, -6.5) *
               turned(6.0 * t, glm::normalize(glm::dvec3(1, 2, 0.5)));
    });
    addMoving(scene, addMesh(scene, torus(0.42f, 0.13f, 32, 16)), striped, [](double t) {
        return at(-2.2 * std::cos(5.0 * t), 2.75 + 0.3 * std::sin(9.0 * t), -4.8) *
               turned(8.0 * t, {1, 0, 0});
    });
    // Thrown in from the left at 9 m/s, stands still from 0.3 s on.
    addMoving(scene, addMesh(scene, sphere(0.38f, 20, 32)), blue, [](double t) {
        const double travelled = 9.0 * std::min(t, 0.3);
        return at(-3.6 + travelled, 0.38, -4.9) * turned(-travelled / 0.38, {0, 0, 1});
    });
    // Vanishes after half a second; a matrix of zeros is an object that is not there.
    addMoving(scene, addMesh(scene, box({0.7f, 1.4f, 0.7f}, 1.0f)), striped,
              [](double t) { return t < 0.5 ? at(2.5, 0.7, -5.6) * turned(3.0 * t) : glm::dmat4(0.0); });
}

// The palette of a column whose joints each turn against the one below.
std::vector<glm::mat4> bend(double seconds, uint32_t joints, float height) {
    std::vector<glm::mat4> palette;
    const float spacing = height / float(joints - 1);
    glm::dmat4 jointToWorld = at(-0.6, 0, -7.6);
    for (uint32_t joint = 0; joint < joints; ++joint) {
        jointToWorld = jointToWorld * at(0, joint == 0 ? 0.0 : spacing, 0) *
                       turned(0.42 * std::sin(6.5 * seconds - 0.7 * joint), {0.35, 0, 0.94});
        palette.emplace_back(jointToWorld * at(0, -double(spacing) * joint, 0));
    }
    return palette;
}

void addColumn(Scene& scene) {
    constexpr uint32_t joints = 4;
    constexpr float height = 2.6f;
    const uint32_t skin = addMaterial(
        scene, {.texture = addTexture(scene, checker(256, 8, {0.2f, 0.55f, 0.35f}, {0.85f, 0.85f, 0.6f}))});
    Instance& column = addMoving(scene, addMesh(scene, bendingColumn(0.3f, height, 24, 24, joints)), skin,
                                 [](double) { return glm::dmat4(1.0); });
    column.palette = [](double seconds) { return bend(seconds, joints, height); };
}

} // namespace

Scene fastObject() {
    Scene scene;
    scene.name = "fast_object";
    scene.shows =
        "Objects at 8 to 25 pixels a frame over detailed textures: disocclusion, one stops, one vanishes.";
    scene.sunDirection = glm::normalize(glm::vec3(0.45f, 0.75f, 0.6f));
    scene.sunRadiance = glm::vec3(2.2f, 2.1f, 1.9f);
    scene.cameraMoves = false;
    scene.farPlane = 60.0;
    addRoom(scene);
    addCrossing(scene);
    addColumn(scene);
    scene.worldToView = [](double) { return lookAt({0.2, 1.75, 0.4}, {0.0, 1.6, -6.0}); };
    return scene;
}

} // namespace scenes::build
