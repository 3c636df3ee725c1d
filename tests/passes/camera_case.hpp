// SPDX-License-Identifier: Apache-2.0
// Cameras of every kind, frames of camera_velocity seen by them, and their comparison with the oracle.
#pragma once

#include "comparison.hpp"
#include "oracle/passes.hpp"
#include "reprise/camera.hpp"
#include "reprise/pack_table.hpp"

namespace passes {

enum class Depth { standard, reversed, reversedInfinite };
enum class Projection { perspective, orthographic };

struct CameraKind {
    Depth depth = Depth::standard;
    Projection projection = Projection::perspective;
};
inline constexpr CameraKind cameraKinds[] = {{Depth::standard, Projection::perspective},
                                             {Depth::reversed, Projection::perspective},
                                             {Depth::reversedInfinite, Projection::perspective},
                                             {Depth::standard, Projection::orthographic},
                                             {Depth::reversed, Projection::orthographic}};
std::string text(const CameraKind& kind);
constexpr double nearPlane = 0.25, farPlane = 60.0;

// Column-vector matrices from view space, +z forward, to clip space with depth in [0, 1].
glm::dmat4 projectionOf(const CameraKind& kind, double aspect, double zoom = 1.0);
// The view of an eye turned by yaw, pitch and roll in radians.
glm::dmat4 viewOf(glm::dvec3 eye, glm::dvec3 yawPitchRoll);

struct CameraCase {
    oracle::CameraVelocity pass; // what the oracle takes
    Pixels depth;                // device depth, or metres
    reprise::CameraVelocityParameters parameters{};
    glm::dmat4 toPreviousClip{1.0}; // in double precision what gReprojection is in float32

    int width() const { return depth.width; }
    int height() const { return depth.height; }
};

// Sets the parameters from `pass`, by the runtime's own functions.
void setParameters(CameraCase& frame);
// Random surfaces between the planes, some at the far plane; the previous camera stood elsewhere, was turned
// and had another zoom. With `behind`, it looked the other way and many surfaces are behind it.
CameraCase randomCameraCase(const CameraKind& kind, bool depthLinear, int width, int height, uint64_t seed,
                            bool behind = false);
std::vector<Pixels> run(Pass& pass, const CameraCase& frame);
// What float32 may make of the motion of a pixel; infinite where either side of the guard is right.
glm::dvec2 motionBound(const CameraCase& frame, int x, int y);
Comparison compareWithOracle(const CameraCase& frame, const Pixels& velocity);

} // namespace passes
