// SPDX-License-Identifier: Apache-2.0
// thin_geometry: a yard of railings, mesh fences, wires and lattice masts against the sky. At 640×360 one
// pixel is 2.7 mm at one metre, so the wires (12 mm) are below one pixel from 4.5 m on, and the poles (60 mm)
// from 22 m on.
#include "builtin.hpp"

#include <cmath>

namespace scenes::build {
namespace {

Mesh railing(float length) {
    Mesh mesh;
    for (float height : {0.12f, 0.6f, 1.05f})
        append(mesh, rod({0, height, 0}, {length, height, 0}, 0.018f));
    const int bars = int(length / 0.14f);
    for (int i = 0; i <= bars; ++i) {
        const float x = length * float(i) / float(bars), radius = i % 12 == 0 ? 0.025f : 0.009f;
        append(mesh, rod({x, i % 12 == 0 ? 0.0f : 0.12f, 0}, {x, 1.05f, 0}, radius));
    }
    return mesh;
}

// Crossing diagonal wires between posts.
Mesh meshFence(float length, float height) {
    Mesh mesh;
    const float step = 0.16f, radius = 0.006f;
    for (float x = -height; x < length; x += step) {
        const float from = std::max(x, 0.0f), to = std::min(x + height, length);
        if (to - from < 0.01f) continue; // at the ends a wire would have no length
        append(mesh, rod({from, from - x, 0}, {to, to - x, 0}, radius, 4));
        append(mesh, rod({from, height - (from - x), 0}, {to, height - (to - x), 0}, radius, 4));
    }
    for (float x = 0.0f; x <= length; x += 2.0f)
        append(mesh, rod({x, 0, 0}, {x, height + 0.2f, 0}, 0.03f));
    append(mesh, rod({0, height, 0}, {length, height, 0}, 0.015f));
    return mesh;
}

Mesh latticeMast(float height) {
    Mesh mesh;
    const auto corner = [=](int side, float up) {
        const float half = 0.75f * (1.0f - up / (height * 1.15f));
        return glm::vec3((side & 1) ^ (side >> 1) ? half : -half, up, side & 2 ? half : -half);
    };
    const int floors = 11;
    for (int side = 0; side < 4; ++side) {
        append(mesh, rod(corner(side, 0), corner(side, height), 0.035f));
        for (int i = 0; i < floors; ++i) {
            const float low = height * float(i) / float(floors), high = height * float(i + 1) / float(floors);
            const int next = (side + 1) & 3;
            append(mesh, rod(corner(side, low), corner(next, high), 0.014f, 4));
            append(mesh, rod(corner(next, low), corner(side, high), 0.014f, 4));
            append(mesh, rod(corner(side, high), corner(next, high), 0.014f, 4));
        }
    }
    for (float up : {0.72f, 0.86f})
        append(mesh, rod({-2.2f, height * up, 0}, {2.2f, height * up, 0}, 0.03f));
    return mesh;
}

void addPowerLine(Scene& scene, uint32_t steel, uint32_t black) {
    const uint32_t mast = addMesh(scene, latticeMast(13.0f));
    const glm::vec3 feet[] = {{-24, 0, -38}, {-3, 0, -30}, {17, 0, -24}, {34, 0, -17}};
    Mesh wires;
    for (int i = 0; i < 4; ++i) {
        addInstance(scene, mast, steel, at(feet[i].x, 0, feet[i].z) * turned(-1.2));
        if (i == 0) continue;
        for (float up : {9.36f, 11.18f})
            for (float side : {-2.2f, 2.2f}) {
                const glm::vec3 arm = glm::vec3(turned(-1.2) * glm::dvec4(side, up, 0, 0));
                append(wires, wire(feet[i - 1] + arm, feet[i] + arm, 1.4f, 0.012f, 24));
            }
    }
    addInstance(scene, addMesh(scene, wires), black, glm::dmat4(1.0));
}

Mesh antennas() {
    Mesh mesh;
    for (int i = 0; i < 14; ++i) {
        const float x = -13.0f + 2.1f * float(i), z = -13.0f - 5.0f * hash(i, 0, 61);
        const float height = 3.0f + 3.5f * hash(i, 1, 61), lean = 0.5f * (hash(i, 2, 61) - 0.5f);
        append(mesh, rod({x, 0, z}, {x + lean, height, z}, 0.008f + 0.022f * hash(i, 3, 61)));
        for (float up = 0.7f; up < 0.99f; up += 0.09f)
            append(mesh, rod({x + lean * up - 0.35f, height * up, z}, {x + lean * up + 0.35f, height * up, z},
                             0.006f, 4));
    }
    return mesh;
}

void addYard(Scene& scene, uint32_t steel, uint32_t paint) {
    const uint32_t ground =
        addMaterial(scene, {.texture = addTexture(scene, concrete(512, {0.62f, 0.6f, 0.57f}, 0.5f))});
    addInstance(scene, addMesh(scene, floor({160, 160}, 0.25f)), ground, glm::dmat4(1.0));
    const uint32_t rail = addMesh(scene, railing(9.0f)), fence = addMesh(scene, meshFence(12.0f, 2.0f));
    addInstance(scene, rail, paint, at(-6.5, 0, -5.0) * turned(0.25));
    addInstance(scene, rail, paint, at(2.6, 0, -7.3) * turned(-0.2));
    addInstance(scene, rail, steel, at(-9.0, 0, -17.0));
    addInstance(scene, fence, steel, at(-13.0, 0, -10.5) * turned(-0.1));
    addInstance(scene, fence, steel, at(1.5, 0, -11.5) * turned(0.15));
    addInstance(scene, addMesh(scene, antennas()), steel, glm::dmat4(1.0));
}

} // namespace

Scene thinGeometry() {
    Scene scene;
    scene.name = "thin_geometry";
    scene.shows =
        "Fences, wires and poles from below one to three pixels wide against the sky, under a slow pan.";
    scene.sunDirection = glm::normalize(glm::vec3(-0.5f, 0.7f, 0.45f));
    const uint32_t steel = addMaterial(scene, {.baseColour = {0.32f, 0.34f, 0.37f, 1}, .roughness = 0.5f});
    const uint32_t black = addMaterial(scene, {.baseColour = {0.03f, 0.03f, 0.035f, 1}, .roughness = 0.6f});
    const uint32_t paint = addMaterial(scene, {.baseColour = {0.7f, 0.16f, 0.06f, 1}, .roughness = 0.4f});
    addPowerLine(scene, steel, black);
    addYard(scene, steel, paint);
    scene.worldToView = [](double seconds) {
        const double yaw = 0.16 * std::sin(0.9 * seconds) - 0.05;
        return lookAt({0.3, 1.7, 0.0}, {0.3 + std::sin(yaw), 1.85, -std::cos(yaw)});
    };
    return scene;
}

} // namespace scenes::build
