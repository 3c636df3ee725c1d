// SPDX-License-Identifier: Apache-2.0
#include "camera_case.hpp"

#include <cmath>
#include <limits>

namespace passes {

namespace {

void store(const glm::dvec4& value, float (&target)[4]) {
    for (int i = 0; i < 4; ++i)
        target[i] = static_cast<float>(value[i]);
}

reprise::CameraFrame runtimeCamera(const oracle::Camera& camera) {
    return {camera.worldToView, camera.viewToClip};
}

double linearRandomDepth(const CameraKind& kind, uint64_t seed, int x, int y) {
    const auto ux = static_cast<uint64_t>(x), uy = static_cast<uint64_t>(y);
    if (unitHash(seed, ux, uy, 1) < 0.05) return kind.depth == Depth::reversedInfinite ? HUGE_VAL : farPlane;
    return 0.4 * std::pow(100.0, unitHash(seed, ux, uy));
}

// What the shader multiplies by the matrix, and how much the products may round.
struct Product {
    glm::dvec4 clip, magnitude;
};

Product productOf(const CameraCase& frame, int x, int y) {
    const oracle::CameraVelocity& pass = frame.pass;
    const glm::dvec2 uv = (glm::dvec2(x + 0.5, y + 0.5) - pass.jitterPx) / pass.extent;
    const glm::dvec2 ndc = oracle::uvToNdc(uv, pass.sharesY);
    const double depth = frame.depth.at(x, y, 0);
    glm::dvec4 v(ndc, depth, 1.0);
    if (pass.depthLinear) v = oracle::viewPoint(ndc, depth, pass.current.viewToClip);
    Product product{frame.toPreviousClip * v, glm::dvec4(0.0)};
    for (int column = 0; column < 4; ++column)
        product.magnitude += glm::abs(frame.toPreviousClip[column]) * std::abs(v[column]);
    return product;
}

} // namespace

// Four products and their sums, matrix and vector rounded before: eight roundings of 2^-24 of the magnitudes.
// Where w itself is not above them, either side of the guard is right; and so is any place outside of the
// image for a surface that was 8 images or more away.
glm::dvec2 motionBound(const CameraCase& frame, int x, int y) {
    const Product product = productOf(frame, x, y);
    const glm::dvec4 error = 8.0 * 0x1p-24 * product.magnitude;
    const double w = std::abs(product.clip.w);
    if (w <= error.w) return glm::dvec2(std::numeric_limits<double>::infinity());
    const glm::dvec2 ndc = glm::abs(glm::dvec2(product.clip) / w);
    const bool farAway = product.clip.w > 0.0 && std::max(ndc.x, ndc.y) >= 15.0; // uv of -7 or 8
    if (farAway) return glm::dvec2(std::numeric_limits<double>::infinity());
    return 0.5 * (glm::dvec2(error) + ndc * error.w) / (w - error.w) +
           0x1p-22 * glm::max(ndc, glm::dvec2(1.0));
}

std::string text(const CameraKind& kind) {
    const std::string depth = kind.depth == Depth::standard   ? "standard"
                              : kind.depth == Depth::reversed ? "reversed"
                                                              : "reversed infinite";
    return depth + (kind.projection == Projection::perspective ? " perspective" : " orthographic");
}

glm::dmat4 projectionOf(const CameraKind& kind, double aspect, double zoom) {
    glm::dmat4 p(0.0);
    const double range = farPlane - nearPlane;
    const bool reversed = kind.depth != Depth::standard;
    if (kind.projection == Projection::orthographic) {
        p[0][0] = zoom / (8.0 * aspect);
        p[1][1] = zoom / 8.0;
        p[2][2] = reversed ? -1.0 / range : 1.0 / range;
        p[3][2] = reversed ? farPlane / range : -nearPlane / range;
        p[3][3] = 1.0;
        return p;
    }
    p[0][0] = 1.6 * zoom / aspect;
    p[1][1] = 1.6 * zoom;
    p[2][3] = 1.0;
    p[2][2] = reversed ? -nearPlane / range : farPlane / range;
    p[3][2] = (reversed ? 1.0 : -1.0) * nearPlane * farPlane / range;
    if (kind.depth == Depth::reversedInfinite) {
        p[2][2] = 0.0;
        p[3][2] = nearPlane;
    }
    return p;
}

glm::dmat4 viewOf(glm::dvec3 eye, glm::dvec3 yawPitchRoll) {
    const glm::dvec3 c = glm::cos(yawPitchRoll), s = glm::sin(yawPitchRoll);
    const glm::dmat3 yaw(c.x, 0, -s.x, 0, 1, 0, s.x, 0, c.x);
    const glm::dmat3 pitch(1, 0, 0, 0, c.y, s.y, 0, -s.y, c.y);
    const glm::dmat3 roll(c.z, s.z, 0, -s.z, c.z, 0, 0, 0, 1);
    glm::dmat4 viewToWorld(yaw * pitch * roll);
    viewToWorld[3] = glm::dvec4(eye, 1.0);
    return glm::inverse(viewToWorld);
}

void setParameters(CameraCase& frame) {
    const oracle::CameraVelocity& pass = frame.pass;
    const reprise::CameraFrame current = runtimeCamera(pass.current), previous = runtimeCamera(pass.previous);
    frame.toPreviousClip = pass.depthLinear ? reprise::viewToPreviousClip(current, previous)
                                            : reprise::reprojection(current, previous);
    for (int i = 0; i < 16; ++i)
        frame.parameters.gReprojection[i] = static_cast<float>(frame.toPreviousClip[i / 4][i % 4]);
    glm::dvec4 ray = reprise::viewRay(pass.current.viewToClip);
    // The runtime's rays are for UV y down and NDC y up; an engine where both run alike turns them over.
    if (pass.sharesY) ray = {ray.x, -ray.y, ray.z, ray.w + ray.y};
    store(ray, frame.parameters.gViewRay);
    store(glm::dvec4(pass.extent, 1.0 / pass.extent), frame.parameters.gOutputSize);
    frame.parameters.gJitterUv[0] = static_cast<float>(pass.jitterPx.x / pass.extent.x);
    frame.parameters.gJitterUv[1] = static_cast<float>(pass.jitterPx.y / pass.extent.y);
}

CameraCase randomCameraCase(const CameraKind& kind, bool depthLinear, int width, int height, uint64_t seed,
                            bool behind) {
    CameraCase frame;
    const double aspect = static_cast<double>(width) / height;
    frame.pass.current = {viewOf({1.5, 2.0, -3.0}, {0.3, -0.1, 0.05}), projectionOf(kind, aspect)};
    const double yaw = behind ? 2.2 : 0.33;
    frame.pass.previous = {viewOf({1.4, 2.05, -3.2}, {yaw, -0.12, 0.02}), projectionOf(kind, aspect, 1.03)};
    frame.pass.extent = {width, height};
    frame.pass.jitterPx = {0.3125, -0.4375};
    frame.pass.depthLinear = depthLinear;
    frame.depth = makePixels(r32f, width, height, [&](int x, int y) {
        const double linear = linearRandomDepth(kind, seed, x, y);
        const bool infinite = std::isinf(linear);
        if (depthLinear) return Texel{infinite ? 1e6f : static_cast<float>(linear)};
        return Texel{
            infinite ? 0.0f : static_cast<float>(oracle::deviceDepth(linear, frame.pass.current.viewToClip))};
    });
    setParameters(frame);
    return frame;
}

std::vector<Pixels> run(Pass& pass, const CameraCase& frame) {
    const NamedPixels inputs[] = {{"gInDepth", &frame.depth}};
    return pass(inputs, frame.parameters, frame.width(), frame.height());
}

Comparison compareWithOracle(const CameraCase& frame, const Pixels& velocity) {
    return compare(
        velocity,
        [&](int x, int y, bool careful) {
            const glm::dvec2 motion = oracle::cameraVelocity(frame.pass, x, y, frame.depth.at(x, y, 0));
            const glm::dvec2 bound = careful ? motionBound(frame, x, y) : glm::dvec2(0.0);
            return Expected{{motion, 0.0}, {bound, 0.0}};
        },
        2);
}

} // namespace passes
