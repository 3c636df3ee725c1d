// SPDX-License-Identifier: Apache-2.0
// Scenes as data: meshes, textures, materials, instances that move, a sun, a camera path. Metres, seconds,
// radians; world y up; the camera looks along +z of its own space.
#pragma once

#include "reprise/camera.hpp"
#include "reprise/result.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace scenes {

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 uv;
};

struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices; // triangles
    // Skinned meshes: joints and weights per vertex, as many as vertices; else empty.
    std::vector<glm::u8vec4> joints;
    std::vector<glm::vec4> weights;
};

struct Texture { // RGBA8, sRGB colour
    uint32_t width = 0, height = 0;
    std::vector<uint8_t> texels;
};

struct Material {
    glm::vec4 baseColour{1.0f}; // linear; alpha multiplies the texture's
    glm::vec3 emission{0.0f};   // linear radiance, may exceed 1 by far
    int texture = -1;           // index or -1
    float alphaCutoff = 0.0f;   // 0: opaque; else alpha test
    float roughness = 0.8f;
    bool twoSided = false;
};

struct Instance {
    uint32_t mesh = 0, material = 0;
    uint32_t id = 0; // permanent
    bool moves = false;
    std::function<glm::dmat4(double seconds)> objectToWorld;
    std::function<std::vector<glm::mat4>(double seconds)> palette; // skinned: joint to world; else empty
};

struct PointLight { // lights without shadow; what an emitter throws on its surroundings
    glm::vec3 position;
    glm::vec3 intensity; // radiance of a white diffuse surface at one metre
};

struct Scene {
    std::string name;
    std::string shows; // one sentence: what it is made for
    std::vector<Mesh> meshes;
    std::vector<Texture> textures;
    std::vector<Material> materials;
    std::vector<Instance> instances;
    glm::vec3 sunDirection{0.4f, 0.8f, -0.3f}; // towards the sun, normalised
    glm::vec3 sunRadiance{3.0f}, skyRadiance{0.35f, 0.45f, 0.6f}, groundRadiance{0.15f, 0.13f, 0.1f};
    double framesPerSecond = 60.0;
    std::vector<PointLight> lights; // at most maxLights are used
    std::vector<std::string> notes; // sentences on what a file asked for and did not get
    std::function<glm::dmat4(double seconds)> worldToView;
    double verticalFov = 0.9;
    double nearPlane = 0.1, farPlane = 200.0;
    bool cameraMoves = true;
    int cutFrame = -1;   // frame at which the camera jumps, or -1
    int eventFrame = -1; // first frame without an object that was there before, or -1
};

inline constexpr size_t maxLights = 4;

// thin_geometry, fast_object, hdr_emitters, foliage, static_camera, camera_cut
std::vector<Scene> builtInScenes();
// hall_static, hall_slow_pan, hall_fast_pan, hall_moving, hall_removed: what occlusion and the sun's shadow are
// measured on.
std::vector<Scene> lightingScenes();
// Both lists, builtInScenes() first.
std::vector<Scene> allScenes();
// glTF, GLB, OBJ. One sentence on failure; never throws, never reads out of bounds.
reprise::Result<Scene> loadScene(const std::filesystem::path& file);

enum class DepthKind { standard, reversed, reversedInfinite };
// The camera of frame `index` for an aspect ratio; what the runtime and the renderer both use.
reprise::CameraFrame cameraAt(const Scene& scene, int frame, double aspect,
                              DepthKind depth = DepthKind::standard);
glm::dmat4 perspective(double verticalFov, double aspect, double nearPlane, double farPlane, DepthKind depth);
glm::dmat4 orthographic(double height, double aspect, double nearPlane, double farPlane, DepthKind depth);

} // namespace scenes
