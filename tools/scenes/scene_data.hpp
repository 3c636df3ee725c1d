// SPDX-License-Identifier: Apache-2.0
// A scene on the GPU: vertices, indices, textures with mipmaps. Made once, never changed.
#pragma once

#include "scenes.hpp"
#include "vulkan_objects.hpp"

namespace scenes {

struct MeshRange {
    VkDeviceSize positions = 0, attributes = 0, joints = 0, weights = 0, indices = 0; // byte offsets
    uint32_t indexCount = 0, jointCount = 0;
    bool skinned = false;
    glm::dvec3 centre{0.0}; // bounding sphere in object space
    double radius = 0.0;
};

struct SceneData {
    harness::Buffer positions, attributes, joints, weights, indices;
    std::vector<MeshRange> meshes;
    VkDescriptorSetLayout textureLayout = VK_NULL_HANDLE;
    std::vector<VkDescriptorSet> textureSets; // texture + 1; the first is white
};

SceneData makeSceneData(harness::Gpu& gpu, const Scene& scene, Cleanup& cleanup);

// Mip chain down to 1×1, averaged in linear light. With a cutoff above 0 the share of texels that pass the
// alpha test is kept in every mip, so that leaves do not thin out with distance.
std::vector<Texture> mipChain(const Texture& texture, float alphaCutoff);

// The next mip: half the size, rounded down, averaged in linear light.
Texture halfSize(const Texture& fine);

} // namespace scenes
