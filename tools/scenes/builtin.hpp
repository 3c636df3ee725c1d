// SPDX-License-Identifier: Apache-2.0
// The built-in scenes, one function each, and the small things that they share.
#pragma once

#include "camera_path.hpp"
#include "mesh_builder.hpp"
#include "texture_builder.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace scenes::build {

Scene thinGeometry();
Scene fastObject();
Scene hdrEmitters();
Scene foliage();
Scene staticCamera();
Scene cameraCut();
Scene hallStatic();
Scene hallSlowPan();
Scene hallFastPan();
Scene hallMoving();
Scene hallRemoved();

inline int addTexture(Scene& scene, Texture texture) {
    scene.textures.push_back(std::move(texture));
    return int(scene.textures.size()) - 1;
}

inline uint32_t addMaterial(Scene& scene, Material material) {
    scene.materials.push_back(material);
    return uint32_t(scene.materials.size()) - 1;
}

inline uint32_t addMesh(Scene& scene, Mesh mesh) {
    scene.meshes.push_back(std::move(mesh));
    return uint32_t(scene.meshes.size()) - 1;
}

// Identities follow the order of the calls, so they are the same in every run.
inline Instance& addInstance(Scene& scene, uint32_t mesh, uint32_t material, const glm::dmat4& transform) {
    Instance instance;
    instance.mesh = mesh;
    instance.material = material;
    instance.id = uint32_t(scene.instances.size());
    instance.objectToWorld = [transform](double) { return transform; };
    scene.instances.push_back(std::move(instance));
    return scene.instances.back();
}

inline Instance& addMoving(Scene& scene, uint32_t mesh, uint32_t material,
                           std::function<glm::dmat4(double)> transform) {
    Instance& instance = addInstance(scene, mesh, material, glm::dmat4(1.0));
    instance.moves = true;
    instance.objectToWorld = std::move(transform);
    return instance;
}

inline glm::dmat4 at(double x, double y, double z) {
    return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z));
}

inline glm::dmat4 turned(double angle, glm::dvec3 axis = {0.0, 1.0, 0.0}) {
    return glm::rotate(glm::dmat4(1.0), angle, axis);
}

} // namespace scenes::build
