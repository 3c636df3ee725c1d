// SPDX-License-Identifier: Apache-2.0
// The triangles of a scene at a frame, and rays against them.
#pragma once

#include "embree.hpp"
#include "scenes.hpp"

#include <memory>
#include <vector>

namespace report {

// One instance in world space.
struct RayGeometry {
    const scenes::Mesh* mesh = nullptr;
    const scenes::Material* material = nullptr;
    const scenes::Texture* texture = nullptr; // of the alpha test; null: the material's alpha alone
    std::vector<glm::vec3> positions;         // per vertex
    bool mirrored = false;                    // the transform turns the winding
};

struct RayHit {
    glm::dvec3 position;
    glm::dvec3 normal; // of the triangle, unit length, against the ray
    bool backFace;     // of a material with one side
    float distance;
};

class RayScene {
public:
    explicit RayScene(const scenes::Scene& scene); // which must outlive this
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    void setFrame(int frame); // from 0
    // The rest may be called from many threads. Directions have unit length.
    // False when nothing lies between `from` and `to` along the ray.
    bool nearest(glm::dvec3 origin, glm::dvec3 direction, float from, float to, RayHit& hit) const;
    // Distance of the nearest surface, infinite when it is farther than `to`.
    float nearestDistance(glm::vec3 origin, glm::vec3 direction, float to) const;
    bool isBlocked(glm::vec3 origin, glm::vec3 direction, float to) const;

private:
    struct Part;
    const scenes::Scene& scene_;
    RTCDevice device_ = nullptr;
    std::unique_ptr<Part> parts_[2]; // what stands still, what moves
    int frame_ = -1;
};

} // namespace report
