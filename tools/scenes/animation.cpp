// SPDX-License-Identifier: Apache-2.0
#include "animation.hpp"

#include "assimp_convert.hpp"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace scenes {
namespace {

glm::dvec3 blend(const glm::dvec3& a, const glm::dvec3& b, double t) {
    return glm::mix(a, b, t);
}
glm::dquat blend(const glm::dquat& a, const glm::dquat& b, double t) {
    return glm::slerp(a, b, t);
}

template <class T> T sample(const Track<T>& track, double seconds, const T& otherwise) {
    if (track.values.empty()) return otherwise;
    const auto after = std::ranges::upper_bound(track.seconds, seconds);
    if (after == track.seconds.begin()) return track.values.front();
    const size_t next = size_t(after - track.seconds.begin()), previous = next - 1;
    if (after == track.seconds.end()) return track.values.back();
    const double span = track.seconds[next] - track.seconds[previous];
    return blend(track.values[previous], track.values[next],
                 span > 0.0 ? (seconds - track.seconds[previous]) / span : 0.0);
}

glm::dvec3 convert(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}
glm::dquat convert(const aiQuaternion& q) {
    return glm::normalize(glm::dquat(q.w, q.x, q.y, q.z));
}

// The importer gives keys in ticks; a file can hold them unsorted or not finite.
template <class T, class Key> Track<T> readTrack(const Key* keys, unsigned count, double ticksPerSecond) {
    Track<T> track;
    for (unsigned i = 0; i < count; ++i) {
        const double seconds = keys[i].mTime / ticksPerSecond;
        const T value = convert(keys[i].mValue);
        bool finite = std::isfinite(seconds);
        for (int c = 0; c < int(T::length()); ++c)
            finite = finite && std::isfinite(value[c]);
        if (!finite)
            throw Refusal{"its animation holds a value that is infinite or not a number; export it again"};
        if (!track.seconds.empty() && seconds < track.seconds.back())
            throw Refusal{"its animation goes back in time; export it again"};
        track.seconds.push_back(seconds);
        track.values.push_back(value);
    }
    return track;
}

void addNodes(NodeTree& tree, const aiNode& node, int parent, int depth) {
    if (depth > maxNodeDepth || tree.nodes.size() >= maxNodes)
        throw Refusal{"it has too many nodes or nests them too deep; flatten them"};
    const int self = int(tree.nodes.size());
    tree.nodes.push_back(
        {node.mName.C_Str(), parent, convertMatrix(node.mTransformation), std::nullopt, false});
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        addNodes(tree, *node.mChildren[i], self, depth + 1);
}

} // namespace

glm::dmat4 convertMatrix(const aiMatrix4x4& m) {
    glm::dmat4 result(m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4,
                      m.c4, m.d4);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(result[column][row]))
                throw Refusal{"a transform holds a value that is infinite or not a number; export it again"};
    return result;
}

glm::dmat4 NodeTree::toWorld(size_t index, double seconds) const {
    if (duration > 0.0) seconds = std::fmod(seconds, duration);
    glm::dmat4 world(1.0);
    for (int i = int(index); i >= 0; i = nodes[size_t(i)].parent) {
        const Node& node = nodes[size_t(i)];
        glm::dmat4 local = node.local;
        if (node.channel) {
            // The importer fills each channel with position, rotation and scale, the node's own where not
            // animated.
            const glm::dvec3 scale = sample(node.channel->scale, seconds, glm::dvec3(1.0));
            const glm::dvec3 position = sample(node.channel->position, seconds, glm::dvec3(local[3]));
            const glm::dquat rotation = sample(node.channel->rotation, seconds, glm::dquat(1, 0, 0, 0));
            local = glm::translate(glm::dmat4(1.0), position) * glm::mat4_cast(rotation) *
                    glm::scale(glm::dmat4(1.0), scale);
        }
        world = local * world;
    }
    return world;
}

int NodeTree::find(const std::string& name) const {
    const auto found = std::ranges::find(nodes, name, &Node::name);
    return found == nodes.end() ? -1 : int(found - nodes.begin());
}

std::shared_ptr<const NodeTree> makeNodeTree(const aiScene& scene) {
    auto tree = std::make_shared<NodeTree>();
    addNodes(*tree, *scene.mRootNode, -1, 0);
    if (scene.mNumAnimations > 0) {
        const aiAnimation& animation = *scene.mAnimations[0];
        const double ticks = animation.mTicksPerSecond > 0.0 ? animation.mTicksPerSecond : 1000.0;
        for (unsigned i = 0; i < animation.mNumChannels; ++i) {
            const aiNodeAnim& source = *animation.mChannels[i];
            const int node = tree->find(source.mNodeName.C_Str());
            if (node < 0) continue;
            Channel channel{readTrack<glm::dvec3>(source.mPositionKeys, source.mNumPositionKeys, ticks),
                            readTrack<glm::dvec3>(source.mScalingKeys, source.mNumScalingKeys, ticks),
                            readTrack<glm::dquat>(source.mRotationKeys, source.mNumRotationKeys, ticks)};
            for (double end : {channel.position.seconds.empty() ? 0.0 : channel.position.seconds.back(),
                               channel.scale.seconds.empty() ? 0.0 : channel.scale.seconds.back(),
                               channel.rotation.seconds.empty() ? 0.0 : channel.rotation.seconds.back()})
                tree->duration = std::max(tree->duration, end);
            tree->nodes[size_t(node)].channel = std::move(channel);
        }
    }
    for (Node& node : tree->nodes)
        node.animated = node.channel || (node.parent >= 0 && tree->nodes[size_t(node.parent)].animated);
    return tree;
}

} // namespace scenes
