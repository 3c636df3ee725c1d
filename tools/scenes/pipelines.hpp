// SPDX-License-Identifier: Apache-2.0
// The renderer's pipelines: compiled from HLSL when first asked for, one for each set of switches that a
// scene uses.
#pragma once

#include "scenes.hpp"
#include "vulkan_objects.hpp"

#include <compare>
#include <map>

namespace scenes {

// depth: alpha-tested surfaces first leave their depth alone, so that each pixel is lit once and not once a
// leaf.
enum class Draw : uint8_t { scene, depth, shadow, sky, accumulate };

struct PipelineKey {
    Draw draw = Draw::scene;
    bool skinned = false, textured = false, alphaTest = false;
    bool gbuffer = false; // else colour alone
    auto operator<=>(const PipelineKey&) const = default;
};

// Push constants, as in scene_common.hlsli.
struct RenderConstants {
    glm::vec2 jitterNdc{0.0f}, jitterPx{0.0f};
    float lodBias = 0.0f;
    uint32_t cascade = 0;
};

class Pipelines {
public:
    Pipelines(VkDevice device, VkPipelineLayout sceneLayout, VkPipelineLayout accumulateLayout,
              DepthKind depth, uint32_t pointLights);
    VkPipeline get(const PipelineKey& key);
    VkPipelineLayout layout(Draw draw) const;

private:
    VkPipeline make(const PipelineKey& key);
    VkShaderModule module(const PipelineKey& key, bool vertex);

    VkDevice device_;
    VkPipelineLayout sceneLayout_, accumulateLayout_;
    DepthKind depth_;
    uint32_t pointLights_;
    std::map<PipelineKey, VkPipeline> pipelines_;
    std::map<std::pair<PipelineKey, bool>, VkShaderModule> modules_;
    Cleanup cleanup_;
};

} // namespace scenes
