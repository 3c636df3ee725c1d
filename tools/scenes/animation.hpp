// SPDX-License-Identifier: Apache-2.0
// Nodes and their animation, kept from a model file and sampled at any time.
#pragma once

#include "model_check.hpp"

#include <memory>
#include <optional>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

struct aiScene;

namespace scenes {

template <class T> struct Track {
    std::vector<double> seconds; // ascending
    std::vector<T> values;
};

struct Channel {
    Track<glm::dvec3> position, scale;
    Track<glm::dquat> rotation;
};

struct Node {
    std::string name;
    int parent = -1; // comes before its children
    glm::dmat4 local{1.0};
    std::optional<Channel> channel;
    bool animated = false; // itself or an ancestor
};

struct NodeTree {
    std::vector<Node> nodes;
    double duration = 0.0; // seconds; time loops after it

    glm::dmat4 toWorld(size_t node, double seconds) const;
    // The node of that name, or -1.
    int find(const std::string& name) const;
};

// The first animation of the file drives the nodes. Throws Refusal on values that are not finite.
std::shared_ptr<const NodeTree> makeNodeTree(const aiScene& scene);

} // namespace scenes
