// SPDX-License-Identifier: Apache-2.0
// The camera of a frame and what passes need of it, computed in double precision.
#pragma once

#include <cstdint>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace reprise {

// View space: x right, y up, +z forward. Clip space as in Direct3D: NDC y up, depth in [0,1].
// The projection is unjittered: standard, reversed or reversed infinite depth, perspective or orthographic.
struct CameraFrame {
    glm::dmat4 worldToView{1.0};
    glm::dmat4 viewToClip{1.0};
};

enum class JitterSequence { none, uniform4Helix, halton8, halton16 };

// Offset of frame `index` in pixels, each coordinate in [-0.5, 0.5), x right, y down. INSIDE I1.
glm::dvec2 jitterPx(JitterSequence sequence, uint64_t index);
uint32_t jitterPeriod(JitterSequence sequence);
// Shears the frustum so that the image of width × height pixels moves by +jitterPx (x right, y down).
glm::dmat4 jitteredProjection(const glm::dmat4& viewToClip, glm::dvec2 jitterPx, uint32_t width,
                              uint32_t height);

// linear depth = 1 / (device * x + y) in perspective, device * x + y in orthographic projection.
glm::dvec2 linearDepthCoefficients(const glm::dmat4& viewToClip);
// View x and y of UV (u, v) are xy * (u, v) + zw: per metre of depth in perspective, in metres in
// orthographic projection. The corner rays of INSIDE, "Reprojection of static scenes".
glm::dvec4 viewRay(const glm::dmat4& viewToClip);
bool isOrthographic(const glm::dmat4& viewToClip);
// Takes current (NDC x, NDC y, device depth, 1) to previous clip coordinates, up to a positive factor.
glm::dmat4 reprojection(const CameraFrame& current, const CameraFrame& previous);
// Takes current view space to previous clip space.
glm::dmat4 viewToPreviousClip(const CameraFrame& current, const CameraFrame& previous);

} // namespace reprise
