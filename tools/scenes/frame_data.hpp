// SPDX-License-Identifier: Apache-2.0
// What one frame of a scene is, apart from its jitter: uniforms, instances, palettes, draw order. Pure
// mathematics; the layouts mirror scene_common.hlsli.
#pragma once

#include "scene_data.hpp"

namespace scenes {

inline constexpr uint32_t cascadeCount = 3, cascadeSize = 1024;
inline constexpr uint32_t noPalette = 0xffffffff;

struct FrameUniforms {
    glm::mat4 worldToLightClip[cascadeCount];
    glm::vec4 cascadeFar, cascadeTexel, camera, forward, sunDirection, sunRadiance, skyRadiance,
        groundRadiance;
    glm::vec4 ray[3], skyToPrevClip[3], lightPosition[maxLights], lightIntensity[maxLights], size, skyDepth;
};
static_assert(sizeof(FrameUniforms) == 3 * 64 + 24 * 16);

struct InstanceData {
    glm::mat4 objectToWorld, objectToClip, prevObjectToClip;
    glm::vec4 normalToWorld[3], baseColour, emission, alphaCutoff;
    glm::uvec4 identity;
};
static_assert(sizeof(InstanceData) == 3 * 64 + 7 * 16);

struct Cascades {
    glm::dmat4 worldToLightClip[cascadeCount];
    double farDepth[cascadeCount];
    double texel[cascadeCount]; // metres
};

struct Bounds {
    glm::dvec3 low{1e300}, high{-1e300};
};

struct FrameContent {
    FrameUniforms uniforms;
    Cascades cascades;
    std::vector<InstanceData> instances;
    std::vector<glm::mat4> palette, prevPalette;
    std::vector<uint32_t> order;                 // instances in view, nearest first, alpha-tested last
    size_t opaqueCount = 0;                      // of those in order
    std::vector<uint32_t> casters[cascadeCount]; // instances that reach each cascade
};

Bounds sceneBounds(const Scene& scene, const SceneData& data, double seconds);
Cascades fitCascades(const Scene& scene, const reprise::CameraFrame& camera, double aspect,
                     const Bounds& bounds);
FrameContent frameContent(const Scene& scene, const SceneData& data, const Bounds& bounds, int frame,
                          uint32_t width, uint32_t height, DepthKind depth);
// A transform that has collapsed stands for an object that is not there.
bool isPresent(const glm::dmat4& objectToWorld);

} // namespace scenes
