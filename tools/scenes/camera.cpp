// SPDX-License-Identifier: Apache-2.0
#include "camera_path.hpp"
#include "scenes.hpp"

#include <cmath>

namespace scenes {

glm::dmat4 perspective(double verticalFov, double aspect, double nearPlane, double farPlane,
                       DepthKind depth) {
    const double focal = 1.0 / std::tan(verticalFov * 0.5);
    glm::dmat4 projection(0.0);
    projection[0][0] = focal / aspect;
    projection[1][1] = focal;
    projection[2][3] = 1.0; // w = view z: the camera looks along +z
    if (depth == DepthKind::standard) {
        projection[2][2] = farPlane / (farPlane - nearPlane);
        projection[3][2] = -nearPlane * farPlane / (farPlane - nearPlane);
    } else if (depth == DepthKind::reversed) {
        projection[2][2] = -nearPlane / (farPlane - nearPlane);
        projection[3][2] = nearPlane * farPlane / (farPlane - nearPlane);
    } else {
        projection[3][2] = nearPlane; // depth = near / z
    }
    return projection;
}

glm::dmat4 orthographic(double height, double aspect, double nearPlane, double farPlane, DepthKind depth) {
    glm::dmat4 projection(1.0);
    projection[0][0] = 2.0 / (height * aspect);
    projection[1][1] = 2.0 / height;
    // An infinite far plane has no orthographic form: reversed stands for it.
    const bool reversed = depth != DepthKind::standard;
    const double range = farPlane - nearPlane;
    projection[2][2] = (reversed ? -1.0 : 1.0) / range;
    projection[3][2] = (reversed ? farPlane : -nearPlane) / range;
    return projection;
}

reprise::CameraFrame cameraAt(const Scene& scene, int frame, double aspect, DepthKind depth) {
    const double seconds = frame / scene.framesPerSecond;
    return {scene.worldToView(seconds),
            perspective(scene.verticalFov, aspect, scene.nearPlane, scene.farPlane, depth)};
}

glm::dmat4 lookAt(glm::dvec3 eye, glm::dvec3 target, glm::dvec3 up) {
    const glm::dvec3 forward = glm::normalize(target - eye);
    // World is right-handed as in glTF, view space is left-handed: the rows are orthonormal with determinant
    // -1.
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const glm::dvec3 trueUp = glm::cross(right, forward);
    glm::dmat4 view(1.0);
    for (int axis = 0; axis < 3; ++axis) {
        view[axis][0] = right[axis];
        view[axis][1] = trueUp[axis];
        view[axis][2] = forward[axis];
    }
    view[3] = {-glm::dot(right, eye), -glm::dot(trueUp, eye), -glm::dot(forward, eye), 1.0};
    return view;
}

} // namespace scenes
