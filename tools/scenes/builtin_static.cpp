// SPDX-License-Identifier: Apache-2.0
// static_camera: nothing moves, so whatever flickers is the sampling. camera_cut: the same court, seen by a
// camera that jumps, so that convergence from nothing can be read.
#include "builtin.hpp"

#include <cmath>

namespace scenes::build {
namespace {

void addSpheres(Scene& scene) {
    const glm::vec4 colours[] = {{0.75f, 0.2f, 0.15f, 1},
                                 {0.85f, 0.65f, 0.2f, 1},
                                 {0.2f, 0.45f, 0.25f, 1},
                                 {0.15f, 0.3f, 0.6f, 1},
                                 {0.8f, 0.8f, 0.82f, 1}};
    const uint32_t ball = addMesh(scene, sphere(0.55f, 28, 48));
    for (int i = 0; i < 5; ++i) {
        const uint32_t material =
            addMaterial(scene, {.baseColour = colours[i], .roughness = 0.08f + 0.13f * float(i)});
        addInstance(scene, ball, material, at(-3.0 + 1.5 * i, 0.55, -5.2 - 0.35 * (i & 1)));
    }
}

// Blocks turned by small angles: their edges cross few scanlines over their length and show every step.
void addBlocks(Scene& scene) {
    const uint32_t white =
        addMaterial(scene, {.texture = addTexture(scene, concrete(256, {0.82f, 0.8f, 0.76f}, 0.25f))});
    const uint32_t dark =
        addMaterial(scene, {.texture = addTexture(scene, planks(256, {0.4f, 0.27f, 0.18f}))});
    const uint32_t slab = addMesh(scene, box({3.2f, 0.18f, 0.5f})),
                   tower = addMesh(scene, box({0.8f, 3.6f, 0.8f}));
    addInstance(scene, slab, dark, at(-2.6, 1.9, -7.6) * turned(0.09, {0, 0, 1}) * turned(0.3));
    addInstance(scene, slab, white, at(2.4, 2.3, -8.0) * turned(-0.06, {0, 0, 1}) * turned(-0.4));
    addInstance(scene, slab, white, at(0.0, 3.0, -9.0) * turned(0.03, {0, 0, 1}));
    for (int i = 0; i < 6; ++i)
        addInstance(scene, tower, i & 1 ? dark : white,
                    at(-7.5 + 3.0 * i, 1.8, -12.0 - (i % 3)) * turned(0.2 * i + 0.1));
}

Mesh thinThings() {
    Mesh mesh;
    for (int i = 0; i < 24; ++i) {
        const float x = -4.6f + 0.4f * float(i);
        append(mesh, rod({x, 0, -10}, {x + 0.1f * std::sin(float(i)), 1.3f + 0.03f * float(i), -10}, 0.012f));
    }
    for (int i = 0; i < 9; ++i)
        append(mesh,
               rod({-6, 2.4f + 0.22f * float(i), -10.5f}, {6, 2.9f + 0.18f * float(i), -10.5f}, 0.008f, 5));
    for (int i = 0; i < 12; ++i)
        append(mesh, rod({2.2f, 0.0f, -3.6f}, {3.0f + 0.12f * float(i), 1.5f, -4.6f}, 0.005f, 5));
    return mesh;
}

Scene court() {
    Scene scene;
    scene.sunDirection = glm::normalize(glm::vec3(0.55f, 0.6f, 0.5f));
    const uint32_t squares = addMaterial(
        scene, {.texture = addTexture(scene, checker(256, 8, {0.12f, 0.12f, 0.13f}, {0.86f, 0.84f, 0.8f})),
                .roughness = 0.5f});
    const uint32_t wire = addMaterial(scene, {.baseColour = {0.1f, 0.1f, 0.11f, 1}, .roughness = 0.4f});
    addInstance(scene, addMesh(scene, floor({300, 300}, 0.25f)), squares, at(0, 0, -60));
    addSpheres(scene);
    addBlocks(scene);
    addInstance(scene, addMesh(scene, thinThings()), wire, glm::dmat4(1.0));
    return scene;
}

} // namespace

Scene staticCamera() {
    Scene scene = court();
    scene.name = "static_camera";
    scene.shows = "Nothing moves: slanted edges, a checker floor to the horizon, highlights and thin rods.";
    scene.cameraMoves = false;
    scene.worldToView = [](double) { return lookAt({0.15, 1.6, 0.0}, {0.0, 1.35, -6.0}); };
    return scene;
}

Scene cameraCut() {
    Scene scene = court();
    scene.name = "camera_cut";
    scene.shows = "A slow dolly that cuts to another view at frame 10: convergence from nothing.";
    scene.cutFrame = 10;
    const double cutSeconds = (scene.cutFrame - 0.5) / scene.framesPerSecond;
    scene.worldToView = [cutSeconds](double seconds) {
        if (seconds < cutSeconds) return lookAt({-3.5 + 0.4 * seconds, 2.2, -1.0}, {-1.0, 1.0, -7.0});
        return lookAt({3.6 - 0.4 * seconds, 1.3, -1.6}, {0.4, 1.3, -7.0});
    };
    return scene;
}

} // namespace scenes::build
