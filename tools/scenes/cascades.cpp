// SPDX-License-Identifier: Apache-2.0
// Cascaded shadow maps whose texels stand still in the world: each cascade is a sphere around its slice of
// the view, so it does not change size as the camera turns, and it moves in whole texels.
#include "camera_path.hpp"
#include "frame_data.hpp"

#include <cmath>

namespace scenes {
namespace {

// Between the logarithmic split (1) and the even one (0); empirical, judged on thin_geometry.
constexpr double splitBlend = 0.8;
// Shadows end at this many near planes: 60 m for a near plane of 0.1 m.
constexpr double farInNearPlanes = 600.0;

double splitDepth(double nearPlane, double farPlane, uint32_t index) {
    const double share = double(index) / cascadeCount;
    const double logarithmic = nearPlane * std::pow(farPlane / nearPlane, share);
    return splitBlend * logarithmic + (1.0 - splitBlend) * (nearPlane + (farPlane - nearPlane) * share);
}

struct Sphere {
    double depth, radius; // centre on the axis of view
};

// Smallest sphere on the axis through the corners of the slice; spread is the corner's slope from the axis.
Sphere sliceSphere(double nearDepth, double farDepth, double spread) {
    const double s = spread * spread;
    const double depth = std::min(farDepth, 0.5 * (nearDepth + farDepth) * (1.0 + s));
    return {depth, std::hypot(farDepth - depth, farDepth * spread)};
}

void depthRange(const Bounds& bounds, const glm::dmat4& light, double& low, double& high) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 point(corner & 1 ? bounds.low.x : bounds.high.x,
                               corner & 2 ? bounds.low.y : bounds.high.y,
                               corner & 4 ? bounds.low.z : bounds.high.z);
        const double z = (light * glm::dvec4(point, 1.0)).z;
        low = std::min(low, z);
        high = std::max(high, z);
    }
}

} // namespace

Cascades fitCascades(const Scene& scene, const reprise::CameraFrame& camera, double aspect,
                     const Bounds& bounds) {
    Cascades cascades;
    const glm::dvec3 sun = glm::normalize(glm::dvec3(scene.sunDirection));
    const glm::dvec3 up = std::abs(sun.y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dmat4 light = lookAt({0, 0, 0}, -sun, up), viewToWorld = glm::inverse(camera.worldToView);
    const double farPlane = std::min(scene.farPlane, farInNearPlanes * scene.nearPlane);
    const double spread = std::tan(scene.verticalFov * 0.5) * std::hypot(1.0, aspect);
    for (uint32_t i = 0; i < cascadeCount; ++i) {
        const double from = i == 0 ? scene.nearPlane : cascades.farDepth[i - 1];
        const double to = splitDepth(scene.nearPlane, farPlane, i + 1);
        const Sphere sphere = sliceSphere(from, to, spread);
        const double texel = 2.0 * sphere.radius / cascadeSize;
        glm::dvec3 centre = glm::dvec3(light * viewToWorld * glm::dvec4(0, 0, sphere.depth, 1));
        centre.x = std::round(centre.x / texel) * texel;
        centre.y = std::round(centre.y / texel) * texel;
        double low = centre.z - sphere.radius, high = centre.z + sphere.radius;
        depthRange(bounds, light, low, high);
        // A margin for what moves out of the bounds later.
        low -= 0.1 * (high - low);
        glm::dmat4 centred = light;
        centred[3] = glm::dvec4(-centre.x, -centre.y, -low, 1.0);
        cascades.worldToLightClip[i] =
            orthographic(2.0 * sphere.radius, 1.0, 0.0, high - low, DepthKind::standard) * centred;
        cascades.farDepth[i] = to;
        cascades.texel[i] = texel;
    }
    return cascades;
}

} // namespace scenes
