// SPDX-License-Identifier: Apache-2.0
// One hall for occlusion and for the sun's shadow, in five variants by camera and motion. The sun comes in
// from the right through four openings: it crosses a grid, columns and balusters on its way to floor, boxes
// and steps. The left wall has niches; the doorway at the end shows the sky.
#include "builtin.hpp"

#include <cmath>

namespace scenes::build {
namespace {

constexpr float halfWidth = 5.0f, height = 4.4f, front = 3.0f, back = -15.0f;
constexpr float bays[] = {-2.0f, -5.0f, -8.0f, -11.0f}; // z of openings and niches

void addBlock(Mesh& mesh, glm::vec3 low, glm::vec3 high) {
    append(mesh, box(high - low), glm::translate(glm::mat4(1.0f), 0.5f * (low + high)));
}

// A wall along z between two x, with an opening in each bay.
Mesh wallWithBays(float fromX, float toX, float width, float sill, float lintel) {
    Mesh mesh;
    addBlock(mesh, {fromX, 0, back}, {toX, sill, front});
    addBlock(mesh, {fromX, lintel, back}, {toX, height, front});
    float from = front;
    for (float bay : bays) {
        addBlock(mesh, {fromX, sill, bay + 0.5f * width}, {toX, lintel, from});
        from = bay - 0.5f * width;
    }
    addBlock(mesh, {fromX, sill, back}, {toX, lintel, from});
    return mesh;
}

Mesh walls() {
    Mesh mesh = wallWithBays(halfWidth, halfWidth + 0.4f, 2.0f, 0.4f, 3.6f);
    append(mesh, wallWithBays(-halfWidth - 0.6f, -halfWidth, 1.2f, 0.5f, 2.4f)); // niches
    addBlock(mesh, {-halfWidth - 0.9f, 0, back}, {-halfWidth - 0.6f, height, front});
    addBlock(mesh, {-halfWidth - 0.9f, 0, front}, {halfWidth + 0.4f, height, front + 0.3f});
    addBlock(mesh, {-halfWidth - 0.9f, height, back - 0.3f}, {halfWidth + 0.4f, height + 0.3f, front + 0.3f});
    // The end, with a doorway above the stairs.
    addBlock(mesh, {-halfWidth - 0.9f, 0, back - 0.3f}, {-1.1f, height, back});
    addBlock(mesh, {1.1f, 0, back - 0.3f}, {halfWidth + 0.4f, height, back});
    addBlock(mesh, {-1.1f, 3.4f, back - 0.3f}, {1.1f, height, back});
    return mesh;
}

Mesh column() {
    Mesh mesh = rod({0, 0.25f, 0}, {0, height - 0.3f, 0}, 0.27f, 32);
    addBlock(mesh, {-0.4f, 0, -0.4f}, {0.4f, 0.25f, 0.4f});
    addBlock(mesh, {-0.38f, height - 0.3f, -0.38f}, {0.38f, height, 0.38f});
    return mesh;
}

Mesh stairs() {
    Mesh mesh;
    for (int i = 0; i < 5; ++i)
        addBlock(mesh, {-2.4f, 0.18f * float(i), back},
                 {2.4f, 0.18f * float(i + 1), -12.6f - 0.36f * float(i)});
    return mesh;
}

Mesh balustrade() {
    Mesh mesh;
    for (int i = 0; i < 13; ++i) {
        const float x = -4.85f + 0.24f * float(i);
        append(mesh, rod({x, 0.1f, 0}, {x, 0.85f, 0}, 0.045f, 12));
    }
    addBlock(mesh, {-5.0f, 0, -0.12f}, {-1.8f, 0.1f, 0.12f});
    addBlock(mesh, {-5.0f, 0.85f, -0.12f}, {-1.8f, 0.97f, 0.12f});
    return mesh;
}

// Bars in the opening of the second bay: at 4 m from the floor that they shade, their half-shadow is as wide
// as they are.
Mesh grid() {
    Mesh mesh;
    const float x = halfWidth + 0.2f, middle = bays[1];
    for (int i = 0; i <= 12; ++i) {
        const float z = middle - 0.96f + 0.16f * float(i);
        append(mesh, rod({x, 0.4f, z}, {x, 3.6f, z}, 0.018f, 8));
    }
    for (int i = 1; i < 8; ++i) {
        const float y = 0.4f + 0.4f * float(i);
        append(mesh, rod({x, y, middle - 1.0f}, {x, y, middle + 1.0f}, 0.018f, 8));
    }
    return mesh;
}

uint32_t plain(Scene& scene, glm::vec3 colour) {
    return addMaterial(scene, {.baseColour = glm::vec4(colour, 1.0f)});
}

void addBuilding(Scene& scene) {
    const uint32_t tiles = addMaterial(
        scene, {.texture = addTexture(scene, checker(64, 2, {0.5f, 0.48f, 0.45f}, {0.6f, 0.58f, 0.54f}))});
    const uint32_t plaster = plain(scene, {0.7f, 0.67f, 0.6f}), stone = plain(scene, {0.6f, 0.58f, 0.55f});
    const uint32_t iron = plain(scene, {0.1f, 0.1f, 0.11f});
    addInstance(scene, addMesh(scene, floor({30, 40}, 0.5f)), tiles, at(0, 0, -6));
    addInstance(scene, addMesh(scene, walls()), plaster, glm::dmat4(1.0));
    addInstance(scene, addMesh(scene, stairs()), stone, glm::dmat4(1.0));
    addInstance(scene, addMesh(scene, balustrade()), stone, at(0, 0, -8.5));
    addInstance(scene, addMesh(scene, grid()), iron, glm::dmat4(1.0));
    const uint32_t pillar = addMesh(scene, column());
    for (const double z : {-3.5, -6.5, -9.5})
        for (const double x : {-2.9, 2.9})
            addInstance(scene, pillar, stone, at(x, 0, z));
}

// Boxes and balls that touch the floor, each other and the niches.
void addThings(Scene& scene) {
    const uint32_t wood = plain(scene, {0.45f, 0.32f, 0.2f}), red = plain(scene, {0.6f, 0.2f, 0.15f});
    const uint32_t white = plain(scene, {0.8f, 0.8f, 0.78f});
    const uint32_t crate = addMesh(scene, box(glm::vec3(0.8f))),
                   plank = addMesh(scene, box({0.3f, 1.9f, 0.05f}));
    addInstance(scene, crate, wood, at(-1.7, 0.4, -6.2) * turned(0.3));
    addInstance(scene, crate, wood, at(-0.8, 0.4, -6.5) * turned(-0.15));
    addInstance(scene, crate, red, at(-1.3, 1.2, -6.3) * turned(0.7));
    addInstance(scene, plank, wood, at(-1.05, 0.88, -5.75) * turned(0.2) * turned(-0.4, {1, 0, 0}));
    const uint32_t ball = addMesh(scene, sphere(0.35f, 32, 48)),
                   small = addMesh(scene, sphere(0.22f, 24, 36));
    addInstance(scene, ball, white, at(0.1, 0.35, -4.6));
    addInstance(scene, small, red, at(0.68, 0.22, -4.5));
    addInstance(scene, ball, white, at(1.4, 0.35, -8.2));
    for (const float bay : bays) {
        addInstance(scene, small, white, at(-halfWidth - 0.3, 0.72, double(bay)));
        addInstance(scene, addMesh(scene, box({0.35f, 0.5f, 0.35f})), wood,
                    at(-halfWidth - 0.35, 0.75, double(bay) - 0.38) * turned(0.2));
    }
}

Scene hall(const char* name, const char* shows) {
    Scene scene;
    scene.name = name;
    scene.shows = shows;
    scene.sunDirection = glm::normalize(glm::vec3(0.86f, 0.42f, 0.2f));
    scene.farPlane = 60.0;
    addBuilding(scene);
    addThings(scene);
    return scene;
}

constexpr double eyeHeight = 1.65, eyeZ = 1.6;

// Steps to the right by `metres` and turns right by `radians` each frame: both move the picture to the left.
// After 32 frames it goes back the same way.
void setPan(Scene& scene, double metres, double radians) {
    const double rate = scene.framesPerSecond;
    scene.cameraMoves = true;
    scene.worldToView = [=](double seconds) {
        const double there = 32.0, frame = std::fmod(seconds * rate, 2.0 * there);
        const double step = (frame < there ? frame : 2.0 * there - frame) - 0.5 * there;
        const double turn = step * radians;
        const glm::dvec3 eye(0.2 + step * metres, eyeHeight, eyeZ);
        return lookAt(eye, eye + glm::dvec3(std::sin(turn), -0.11, -std::cos(turn)));
    };
}

void standStill(Scene& scene) {
    scene.cameraMoves = false;
    scene.worldToView = [](double) {
        return lookAt({0.2, eyeHeight, eyeZ}, {0.2, eyeHeight - 0.11, eyeZ - 1.0});
    };
}

// A crate that slides through the sun, a ball that rolls, a lamp that swings, a door that turns.
void addMovingThings(Scene& scene) {
    const uint32_t wood = plain(scene, {0.5f, 0.4f, 0.25f}), blue = plain(scene, {0.2f, 0.3f, 0.55f});
    addMoving(scene, addMesh(scene, box(glm::vec3(0.7f))), wood,
              [](double t) { return at(1.3 + 1.0 * std::sin(2.5 * t), 0.35, -5.4) * turned(2.0 * t); });
    addMoving(scene, addMesh(scene, sphere(0.3f, 32, 48)), blue, [](double t) {
        const double way = 0.9 * std::sin(3.0 * t);
        return at(-0.9 + way, 0.3, -3.6) * turned(-way / 0.3, {0, 0, 1});
    });
    Mesh lamp = rod({0, 0, 0}, {0, -1.9f, 0}, 0.02f, 8);
    append(lamp, sphere(0.28f, 24, 36), glm::translate(glm::mat4(1.0f), {0, -2.1f, 0}));
    addMoving(scene, addMesh(scene, lamp), blue, [](double t) {
        return at(1.2, height, -6.5) * turned(0.5 * std::sin(3.5 * t), {0, 0, 1});
    });
    Mesh door;
    addBlock(door, {0, 0.02f, -0.03f}, {0.9f, 2.0f, 0.03f});
    addMoving(scene, addMesh(scene, door), wood,
              [](double t) { return at(-3.9, 0, -5.6) * turned(0.9 * std::sin(2.2 * t)); });
}

} // namespace

Scene hallStatic() {
    Scene scene =
        hall("hall_static", "A hall with niches, columns, stairs and sun from the side; nothing moves.");
    standStill(scene);
    return scene;
}

Scene hallSlowPan() {
    Scene scene = hall("hall_slow_pan", "The hall under a camera that moves it by about 2 pixels a frame.");
    setPan(scene, 0.012, 0.003);
    return scene;
}

Scene hallFastPan() {
    Scene scene = hall("hall_fast_pan", "The hall under a camera that moves it by 15 to 20 pixels a frame.");
    setPan(scene, 0.08, 0.03);
    return scene;
}

Scene hallMoving() {
    Scene scene =
        hall("hall_moving", "The hall with things that slide, roll, swing and turn; a slow camera.");
    addMovingThings(scene);
    setPan(scene, 0.005, 0.0012);
    return scene;
}

Scene hallRemoved() {
    Scene scene =
        hall("hall_removed", "The hall; a tall crate that stands in the sun is gone from frame 12 on.");
    scene.eventFrame = 12;
    const double gone = (scene.eventFrame - 0.5) / scene.framesPerSecond;
    addMoving(scene, addMesh(scene, box({0.7f, 1.7f, 0.7f})), plain(scene, {0.45f, 0.32f, 0.2f}),
              [gone](double t) { return t < gone ? at(1.95, 0.85, -3.1) * turned(0.35) : glm::dmat4(0.0); });
    standStill(scene);
    return scene;
}

} // namespace scenes::build
