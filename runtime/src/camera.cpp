// SPDX-License-Identifier: Apache-2.0
#include "reprise/camera.hpp"

#include <glm/matrix.hpp>

namespace reprise {
namespace {

// The digits of `index` in `base`, mirrored at the radix point: in [0, 1).
double radicalInverse(uint64_t index, uint64_t base) {
    double result = 0.0, digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= static_cast<double>(base);
        result += digit * static_cast<double>(index % base);
    }
    return result;
}

// From index 1: index 0 is the corner (0, 0) in both bases.
glm::dvec2 halton(uint64_t index) {
    return glm::dvec2(radicalInverse(index, 2), radicalInverse(index, 3)) - 0.5;
}

} // namespace

uint32_t jitterPeriod(JitterSequence sequence) {
    switch (sequence) {
    case JitterSequence::none:
        break;
    case JitterSequence::uniform4Helix:
        return 4;
    case JitterSequence::halton8:
        return 8;
    case JitterSequence::halton16:
        return 16;
    }
    return 1;
}

glm::dvec2 jitterPx(JitterSequence sequence, uint64_t index) {
    // Every step crosses the horizontal centre line, so that two frames in turn see both halves of a pixel.
    constexpr double helix[4][2] = {{-0.25, -0.25}, {0.25, 0.25}, {0.25, -0.25}, {-0.25, 0.25}};
    const uint64_t step = index % jitterPeriod(sequence);
    switch (sequence) {
    case JitterSequence::none:
        break;
    case JitterSequence::uniform4Helix:
        return {helix[step][0], helix[step][1]};
    case JitterSequence::halton8:
    case JitterSequence::halton16:
        return halton(step + 1);
    }
    return {0.0, 0.0};
}

glm::dmat4 jitteredProjection(const glm::dmat4& viewToClip, glm::dvec2 jitterPx, uint32_t width,
                              uint32_t height) {
    // NDC y points up, pixel y down.
    const glm::dvec2 jitterNdc(2.0 * jitterPx.x / width, -2.0 * jitterPx.y / height);
    glm::dmat4 shear(1.0);
    shear[3][0] = jitterNdc.x;
    shear[3][1] = jitterNdc.y;
    return shear * viewToClip;
}

bool isOrthographic(const glm::dmat4& viewToClip) {
    return viewToClip[0][3] == 0.0 && viewToClip[1][3] == 0.0 && viewToClip[2][3] == 0.0;
}

glm::dvec2 linearDepthCoefficients(const glm::dmat4& viewToClip) {
    const double clipZPerDepth = viewToClip[2][2], clipZ = viewToClip[3][2];
    if (isOrthographic(viewToClip)) return {viewToClip[3][3] / clipZPerDepth, -clipZ / clipZPerDepth};
    return {viewToClip[2][3] / clipZ, -clipZPerDepth / clipZ};
}

glm::dvec4 viewRay(const glm::dmat4& viewToClip) {
    const glm::dmat4& p = viewToClip;
    const bool orthographic = isOrthographic(p);
    // Clip x = p00 x + p20 z + p30, clip w = p23 z or p33; solved for x at ndc = -1 (u = 0) and ndc = +1 (u =
    // 1).
    const double w = orthographic ? p[3][3] : p[2][3];
    const double offsetX = orthographic ? p[3][0] : p[2][0], offsetY = orthographic ? p[3][1] : p[2][1];
    return {2.0 * w / p[0][0], -2.0 * w / p[1][1], (-w - offsetX) / p[0][0], (w - offsetY) / p[1][1]};
}

glm::dmat4 viewToPreviousClip(const CameraFrame& current, const CameraFrame& previous) {
    return previous.viewToClip * previous.worldToView * glm::inverse(current.worldToView);
}

glm::dmat4 reprojection(const CameraFrame& current, const CameraFrame& previous) {
    return viewToPreviousClip(current, previous) * glm::inverse(current.viewToClip);
}

} // namespace reprise
