// SPDX-License-Identifier: Apache-2.0
#include "frame_data.hpp"

#include <algorithm>
#include <cmath>

namespace scenes {
namespace {

struct WorldSphere {
    glm::dvec3 centre;
    double radius;
};

WorldSphere worldSphere(const MeshRange& mesh, const glm::dmat4& objectToWorld) {
    // A skinned mesh goes wherever its joints do: it is never culled.
    if (mesh.skinned) return {glm::dvec3(objectToWorld[3]), 1e30};
    double scale = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        scale = std::max(scale, glm::length(glm::dvec3(objectToWorld[axis])));
    // Columns of a shear can stretch more than the longest of them, by no more than the root of three.
    return {glm::dvec3(objectToWorld * glm::dvec4(mesh.centre, 1.0)), mesh.radius * scale * 1.7321};
}

bool inView(const reprise::CameraFrame& camera, const WorldSphere& sphere) {
    const glm::dvec3 centre(camera.worldToView * glm::dvec4(sphere.centre, 1.0));
    if (centre.z < -sphere.radius) return false;
    for (int axis = 0; axis < 2; ++axis) {
        const double slope = camera.viewToClip[axis][axis];
        // One pixel of margin for the jitter is far less than the slack of the sphere.
        if (std::abs(centre[axis]) * slope - centre.z > sphere.radius * std::hypot(slope, 1.0) * 1.01)
            return false;
    }
    return true;
}

bool inCascade(const glm::dmat4& worldToLightClip, const WorldSphere& sphere) {
    const glm::dvec3 clip(worldToLightClip * glm::dvec4(sphere.centre, 1.0));
    const double radius = sphere.radius * glm::length(glm::dvec3(glm::transpose(worldToLightClip)[0]));
    return std::abs(clip.x) < 1.0 + radius && std::abs(clip.y) < 1.0 + radius;
}

// Rays and the motion of the sky, from the frustum's rows for x, y and w alone.
void describeSky(FrameUniforms& uniforms, const reprise::CameraFrame& camera,
                 const reprise::CameraFrame& previous) {
    const auto frustum = [](const glm::dmat4& p) {
        return glm::dmat3(p[0][0], p[0][1], p[0][3], p[1][0], p[1][1], p[1][3], p[2][0], p[2][1], p[2][3]);
    };
    const glm::dmat3 ndcToView = glm::inverse(frustum(camera.viewToClip));
    const glm::dmat3 ndcToWorld = glm::transpose(glm::dmat3(camera.worldToView)) * ndcToView;
    const glm::dmat3 toPrev = frustum(previous.viewToClip) * glm::dmat3(previous.worldToView) * ndcToWorld;
    for (int i = 0; i < 3; ++i) {
        uniforms.ray[i] = glm::vec4(glm::vec3(ndcToWorld[i]), 0.0f);
        uniforms.skyToPrevClip[i] = glm::vec4(toPrev[0][i], toPrev[1][i], toPrev[2][i], 0.0f);
    }
}

void describeLight(FrameUniforms& uniforms, const Scene& scene, const Cascades& cascades) {
    for (uint32_t i = 0; i < cascadeCount; ++i) {
        uniforms.worldToLightClip[i] = glm::mat4(cascades.worldToLightClip[i]);
        uniforms.cascadeFar[int(i)] = float(cascades.farDepth[i]);
        uniforms.cascadeTexel[int(i)] = float(cascades.texel[i]);
    }
    uniforms.sunDirection = glm::vec4(glm::normalize(scene.sunDirection), 0.0f);
    uniforms.sunRadiance = glm::vec4(scene.sunRadiance, 0.0f);
    uniforms.skyRadiance = glm::vec4(scene.skyRadiance, 0.0f);
    uniforms.groundRadiance = glm::vec4(scene.groundRadiance, 0.0f);
    for (size_t i = 0; i < std::min(scene.lights.size(), maxLights); ++i) {
        uniforms.lightPosition[i] = glm::vec4(scene.lights[i].position, 0.0f);
        uniforms.lightIntensity[i] = glm::vec4(scene.lights[i].intensity, 0.0f);
    }
}

InstanceData describeInstance(const Scene& scene, const Instance& instance, const glm::dmat4& world,
                              const glm::dmat4& toClip, const glm::dmat4& prevToClip) {
    const Material& material = scene.materials[instance.material];
    InstanceData data{};
    data.objectToWorld = glm::mat4(world);
    data.objectToClip = glm::mat4(toClip);
    data.prevObjectToClip = glm::mat4(prevToClip);
    const glm::dmat3 normal = glm::transpose(glm::inverse(glm::dmat3(world)));
    for (int axis = 0; axis < 3; ++axis)
        data.normalToWorld[axis] = glm::vec4(glm::vec3(normal[axis]), 0.0f);
    data.baseColour = material.baseColour;
    data.emission = glm::vec4(material.emission, material.roughness);
    data.alphaCutoff = {material.alphaCutoff, material.twoSided ? 1.0f : 0.0f, 0.0f, 0.0f};
    data.identity = {instance.id + 1, noPalette, 0, 0};
    return data;
}

// Appends this frame's and the previous frame's joints; too few joints would let the shader read past the
// end.
void addPalette(FrameContent& content, InstanceData& data, const Instance& instance, const MeshRange& mesh,
                double seconds, double prevSeconds) {
    data.identity.y = uint32_t(content.palette.size());
    std::vector<glm::mat4> current = instance.palette(seconds), previous = instance.palette(prevSeconds);
    current.resize(mesh.jointCount, glm::mat4(1.0f));
    previous.resize(mesh.jointCount, glm::mat4(1.0f));
    content.palette.insert(content.palette.end(), current.begin(), current.end());
    content.prevPalette.insert(content.prevPalette.end(), previous.begin(), previous.end());
}

void sortNearestFirst(const Scene& scene, const std::vector<double>& farthest, std::vector<uint32_t>& order) {
    std::ranges::stable_sort(order, [&](uint32_t a, uint32_t b) {
        const bool testedA = scene.materials[scene.instances[a].material].alphaCutoff > 0.0f;
        const bool testedB = scene.materials[scene.instances[b].material].alphaCutoff > 0.0f;
        return testedA != testedB ? testedB : farthest[a] < farthest[b];
    });
}

} // namespace

bool isPresent(const glm::dmat4& objectToWorld) {
    const double determinant = glm::determinant(glm::dmat3(objectToWorld));
    return std::isfinite(determinant) && std::abs(determinant) > 1e-30;
}

Bounds sceneBounds(const Scene& scene, const SceneData& data, double seconds) {
    Bounds bounds;
    for (const Instance& instance : scene.instances) {
        const glm::dmat4 world = instance.objectToWorld(seconds);
        const MeshRange& mesh = data.meshes[instance.mesh];
        if (!isPresent(world) || mesh.skinned) continue;
        const WorldSphere sphere = worldSphere(mesh, world);
        bounds.low = glm::min(bounds.low, sphere.centre - sphere.radius);
        bounds.high = glm::max(bounds.high, sphere.centre + sphere.radius);
    }
    if (bounds.low.x > bounds.high.x) bounds = {glm::dvec3(-scene.farPlane), glm::dvec3(scene.farPlane)};
    return bounds;
}

FrameContent frameContent(const Scene& scene, const SceneData& data, const Bounds& bounds, int frame,
                          uint32_t width, uint32_t height, DepthKind depth) {
    const double aspect = double(width) / double(height);
    const int prevFrame = std::max(frame - 1, 0);
    const double seconds = frame / scene.framesPerSecond, prevSeconds = prevFrame / scene.framesPerSecond;
    const reprise::CameraFrame camera = cameraAt(scene, frame, aspect, depth);
    const reprise::CameraFrame previous = cameraAt(scene, prevFrame, aspect, depth);
    const glm::dmat4 worldToClip = camera.viewToClip * camera.worldToView;
    const glm::dmat4 prevWorldToClip = previous.viewToClip * previous.worldToView;
    const glm::dvec3 eye(glm::inverse(camera.worldToView)[3]);

    FrameContent content{};
    content.cascades = fitCascades(scene, camera, aspect, bounds);
    describeLight(content.uniforms, scene, content.cascades);
    describeSky(content.uniforms, camera, previous);
    content.uniforms.camera = glm::vec4(eye, 0.0);
    content.uniforms.forward = glm::vec4(glm::vec3(glm::transpose(camera.worldToView)[2]), 0.0f);
    content.uniforms.size = {float(width), float(height), 1.0f / float(width), 1.0f / float(height)};
    content.uniforms.skyDepth.x = depth == DepthKind::standard ? 1.0f : 0.0f;

    std::vector<double> farthest(scene.instances.size());
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const MeshRange& mesh = data.meshes[instance.mesh];
        const glm::dmat4 world = instance.objectToWorld(seconds);
        const glm::dmat4 prevWorld = instance.moves ? instance.objectToWorld(prevSeconds) : world;
        const bool present = isPresent(world);
        // What appears in this frame has no past: it takes its own place as the previous one.
        const glm::dmat4& before = isPresent(prevWorld) ? prevWorld : world;
        content.instances.push_back(describeInstance(scene, instance, present ? world : glm::dmat4(1.0),
                                                     worldToClip * world, prevWorldToClip * before));
        if (!present) continue;
        if (mesh.skinned) addPalette(content, content.instances.back(), instance, mesh, seconds, prevSeconds);
        const WorldSphere sphere = worldSphere(mesh, world);
        farthest[i] = glm::length(sphere.centre - eye) + sphere.radius;
        if (inView(camera, sphere)) content.order.push_back(i);
        for (uint32_t c = 0; c < cascadeCount; ++c)
            if (inCascade(content.cascades.worldToLightClip[c], sphere)) content.casters[c].push_back(i);
    }
    sortNearestFirst(scene, farthest, content.order);
    content.opaqueCount = size_t(std::ranges::count_if(content.order, [&](uint32_t i) {
        return scene.materials[scene.instances[i].material].alphaCutoff <= 0.0f;
    }));
    return content;
}

} // namespace scenes
