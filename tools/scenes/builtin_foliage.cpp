// SPDX-License-Identifier: Apache-2.0
// foliage: alpha-tested leaf cards and grass that sway, seen by a camera that walks past slowly.
#include "builtin.hpp"

#include <cmath>

namespace scenes::build {
namespace {

// A ball of cards around the origin, each turned at random; normals point outwards so that the crown shades
// as one.
Mesh leafBall(float radius, int cards, uint32_t seed) {
    Mesh mesh;
    for (int i = 0; i < cards; ++i) {
        const float azimuth = 6.2832f * hash(i, 0, seed), height = 2.0f * hash(i, 1, seed) - 1.0f;
        const float ring = std::sqrt(1.0f - height * height),
                    distance = radius * std::sqrt(0.15f + 0.85f * hash(i, 2, seed));
        const glm::vec3 outwards(ring * std::cos(azimuth), height, ring * std::sin(azimuth));
        glm::mat4 transform = glm::translate(glm::mat4(1.0f), outwards * distance * glm::vec3(1, 0.8f, 1));
        transform = glm::rotate(transform, 6.2832f * hash(i, 3, seed), {0, 1, 0});
        transform = glm::rotate(transform, 2.2f * (hash(i, 4, seed) - 0.5f), {1, 0, 0});
        const float size = 0.55f + 0.3f * hash(i, 5, seed);
        const size_t first = mesh.vertices.size();
        append(mesh, card({size, size}), transform);
        for (size_t v = first; v < mesh.vertices.size(); ++v)
            mesh.vertices[v].normal = glm::normalize(outwards + glm::vec3(0, 0.35f, 0));
    }
    return mesh;
}

// Tufts over a square patch, lit as the ground is.
Mesh grassPatch(float size, int tufts, uint32_t seed) {
    Mesh mesh;
    for (int i = 0; i < tufts; ++i) {
        const glm::vec3 foot((hash(i, 0, seed) - 0.5f) * size, 0, (hash(i, 1, seed) - 0.5f) * size);
        glm::mat4 transform = glm::translate(glm::mat4(1.0f), foot);
        transform = glm::rotate(transform, 6.2832f * hash(i, 2, seed), {0, 1, 0});
        append(mesh, card({0.4f, 0.2f + 0.18f * hash(i, 3, seed)}), transform);
    }
    for (Vertex& vertex : mesh.vertices)
        vertex.normal = {0, 1, 0};
    return mesh;
}

// Wind: a lean about the foot that gusts, different for each phase.
glm::dmat4 sway(double seconds, double phase, double amount) {
    const double gust = 0.6 + 0.4 * std::sin(0.9 * seconds + 0.5 * phase);
    const double lean =
        amount * gust *
        (0.4 + std::sin(3.1 * seconds + phase) + 0.35 * std::sin(7.3 * seconds + 2.0 * phase));
    return turned(lean, {0.3, 0.0, -0.954});
}

void addTree(Scene& scene, glm::dvec3 foot, double size, uint32_t bark, uint32_t leaf,
             const uint32_t balls[3], int seed) {
    Mesh trunk = rod({0, 0, 0}, {0.1f, 2.2f, 0}, 0.11f, 8);
    append(trunk, rod({0.08f, 1.5f, 0}, {0.7f, 2.5f, 0.2f}, 0.05f));
    append(trunk, rod({0.08f, 1.7f, 0}, {-0.6f, 2.7f, -0.2f}, 0.05f));
    const glm::dmat4 place =
        at(foot.x, foot.y, foot.z) * turned(1.7 * seed) * glm::scale(glm::dmat4(1.0), glm::dvec3(size));
    addInstance(scene, addMesh(scene, trunk), bark, place);
    const glm::dvec3 crown[] = {
        {0.1, 3.0, 0}, {0.75, 2.6, 0.25}, {-0.65, 2.75, -0.2}, {0.1, 2.5, 0.6}, {0.0, 2.4, -0.6}};
    for (int i = 0; i < 5; ++i) {
        const glm::dvec3 centre = crown[i];
        addMoving(scene, balls[(i + seed) % 3], leaf, [=](double t) {
            return place * sway(t, 1.3 * i + 2.1 * seed, 0.03) * at(centre.x, centre.y, centre.z) *
                   sway(t, 2.9 * i + seed, 0.05);
        });
    }
}

void addGrass(Scene& scene, uint32_t blade) {
    uint32_t patches[3];
    for (uint32_t i = 0; i < 3; ++i)
        patches[i] = addMesh(scene, grassPatch(2.2f, 70, 91 + i));
    for (int z = 0; z < 5; ++z) {
        for (int x = -2 - z * 3 / 4; x <= 2 + z * 3 / 4; ++x) {
            const glm::dmat4 place = at(2.0 * x, 0, -3.1 - 2.0 * z);
            const double phase = 0.9 * x + 0.6 * z;
            // Grass leans by shear, so that its feet stay on the ground.
            addMoving(scene, patches[size_t(x + z + 60) % 3], blade, [=](double t) {
                glm::dmat4 shear(1.0);
                shear[1][0] = 0.22 * std::sin(2.6 * t + phase) + 0.1 * std::sin(6.1 * t + 1.7 * phase);
                return place * shear;
            });
        }
    }
}

} // namespace

Scene foliage() {
    Scene scene;
    scene.name = "foliage";
    scene.shows = "Alpha-tested leaves and grass that sway in wind, passed by a slow camera.";
    scene.sunDirection = glm::normalize(glm::vec3(-0.55f, 0.65f, 0.35f));
    const uint32_t soil = addMaterial(scene, {.texture = addTexture(scene, grassGround(512))});
    const uint32_t bark =
        addMaterial(scene, {.texture = addTexture(scene, planks(256, {0.32f, 0.24f, 0.17f}))});
    const uint32_t leaf = addMaterial(
        scene, {.texture = addTexture(scene, leaves(256, 101)), .alphaCutoff = 0.5f, .twoSided = true});
    const uint32_t blade = addMaterial(
        scene, {.texture = addTexture(scene, blades(256, 102)), .alphaCutoff = 0.5f, .twoSided = true});
    addInstance(scene, addMesh(scene, floor({120, 120}, 0.35f)), soil, glm::dmat4(1.0));
    uint32_t balls[3];
    for (uint32_t i = 0; i < 3; ++i)
        balls[i] = addMesh(scene, leafBall(0.78f, 52, 111 + i));
    const glm::dvec3 feet[] = {{-2.4, 0, -6.0}, {2.2, 0, -7.5}, {-5.5, 0, -11}, {0.3, 0, -13},
                               {5.8, 0, -12},   {-2.8, 0, -18}, {3.5, 0, -20}};
    for (int i = 0; i < 7; ++i)
        addTree(scene, feet[i], 1.0 + 0.12 * (i % 3), bark, leaf, balls, i);
    addGrass(scene, blade);
    scene.worldToView = [](double seconds) {
        const glm::dvec3 eye(-0.5 + 0.5 * seconds, 1.55, 0.6);
        return lookAt(eye, eye + glm::dvec3(0.05, 0.06, -1.0));
    };
    return scene;
}

} // namespace scenes::build
