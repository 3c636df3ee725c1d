// SPDX-License-Identifier: Apache-2.0
#include "ambient_occlusion_case.hpp"

#include "reprise/ambient_occlusion.hpp"

#include <cmath>
#include <cstdlib>
#include <cstring>

namespace passes {

namespace {

float randomDepth(uint64_t seed, int x, int y) {
    const auto ux = static_cast<uint64_t>(x), uy = static_cast<uint64_t>(y);
    // Surfaces within the radius of each other, not a spread of 100 to 1 from texel to texel.
    return static_cast<float>(3.0 + 1.5 * unitHash(seed, ux, uy));
}

// The inside of a corner of a room, of three planes n p + h = 0 that all see the camera, and before it a card
// half a metre nearer. What an orthographic view sees behind a plane has no depth, and is sky.
float cornerDepth(bool orthographic, glm::dvec4 viewRay, glm::dvec2 uv) {
    constexpr glm::dvec4 planes[] = {{0.1, 0.05, -1.0, 6.0}, {0.05, 1.0, -0.3, 1.6}, {1.0, -0.1, -0.4, 2.0}};
    const glm::dvec2 ray = uv * glm::dvec2(viewRay.x, viewRay.y) + glm::dvec2(viewRay.z, viewRay.w);
    double nearest = 1e9;
    for (const glm::dvec4& plane : planes) {
        const double across = glm::dot(glm::dvec2(plane), ray);
        const double depth = orthographic ? -(plane.w + across) / plane.z : -plane.w / (plane.z + across);
        if (depth > 0.0 || orthographic) nearest = std::min(nearest, depth);
    }
    const bool isCard = glm::all(glm::lessThan(glm::abs(uv - 0.5), glm::dvec2(0.15)));
    return static_cast<float>(isCard ? nearest - 0.5 : nearest);
}

bool isSky(uint64_t seed, int x, int y) {
    return unitHash(seed, static_cast<uint64_t>(x / 3), static_cast<uint64_t>(y / 3), 7) < 0.1;
}

Texel randomNormal(uint64_t seed, int x, int y) {
    glm::dvec3 normal;
    for (int c = 0; c < 3; ++c)
        normal[c] = unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y),
                             static_cast<uint64_t>(c) + 20) -
                    0.5;
    normal.z = -std::abs(normal.z) - 0.1;
    normal *= 0.5 + unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), 24);
    return {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z), 0.0f};
}

} // namespace

void setParameters(AmbientOcclusionCase& frame) {
    const auto width = static_cast<float>(frame.depth.width), height = static_cast<float>(frame.depth.height);
    auto& p = frame.parameters;
    const float size[] = {width, height, 1.0f / width, 1.0f / height};
    std::copy(std::begin(size), std::end(size), p.gOutputSize);
    for (int i = 0; i < 4; ++i)
        p.gViewRay[i] = static_cast<float>(frame.pass.viewRay[i]);
    p.gRadius = static_cast<float>(frame.pass.radius);
    const auto taps = reprise::occlusionTaps(static_cast<uint32_t>(frame.pass.samples),
                                             static_cast<uint64_t>(frame.pass.frame),
                                             static_cast<uint32_t>(frame.pass.subsets));
    static_assert(sizeof(taps) == sizeof(p.gTaps));
    std::memcpy(p.gTaps, taps.data(), sizeof(taps));
    const glm::dvec2 frameToCoarse = glm::dvec2(frame.normal.width, frame.normal.height) /
                                     (double(frame.pass.ratio) * glm::dvec2(width, height));
    for (int i = 0; i < 2; ++i) {
        p.gOcclusionBias[i] = static_cast<float>(frame.pass.bias[i]);
        p.gFrameToCoarse[i] = static_cast<float>(frameToCoarse[i]);
    }
}

void setRatio(AmbientOcclusionCase& frame, int ratio, uint64_t seed) {
    frame.pass.ratio = ratio;
    // Of the last row and column the frame has one pixel alone.
    const int width = ratio * (frame.depth.width - 1) + 1, height = ratio * (frame.depth.height - 1) + 1;
    frame.normal = makePixels(rgba32f, width, height, [&](int x, int y) { return randomNormal(seed, x, y); });
    setParameters(frame);
}

AmbientOcclusionCase ambientOcclusionCase(const Variant& variant, Surfaces surfaces, int width, int height,
                                          uint64_t seed, int frame) {
    AmbientOcclusionCase made;
    CameraKind kind;
    made.pass.orthographic = reprise::switchValue(variant, "ORTHOGRAPHIC") == "on";
    if (made.pass.orthographic) kind.projection = Projection::orthographic;
    made.pass.samples = std::atoi(std::string(reprise::switchValue(variant, "SAMPLES")).c_str());
    made.pass.readNormals = reprise::switchValue(variant, "NORMALS") == "read";
    made.pass.subsets = 3;
    made.pass.frame = frame;
    made.pass.radius = 1.5;
    made.pass.bias = {0.01, 0.002};
    const glm::dmat4 viewToClip = projectionOf(kind, static_cast<double>(width) / height);
    // Values that float32 holds, so that both compute with the same.
    made.pass.viewRay = glm::dvec4(glm::vec4(reprise::viewRay(viewToClip)));
    made.pass.radius = double{1.5f};
    made.pass.bias = glm::dvec2(glm::vec2(0.01f, 0.002f));
    made.depth = makePixels(r32f, width, height, [&](int x, int y) {
        if (isSky(seed, x, y)) return Texel{65504.0f};
        if (surfaces == Surfaces::random) return Texel{randomDepth(seed, x, y)};
        return Texel{cornerDepth(made.pass.orthographic, made.pass.viewRay,
                                 glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(width, height))};
    });
    setRatio(made, 2, seed);
    return made;
}

std::vector<Pixels> run(Pass& pass, const AmbientOcclusionCase& frame) {
    const NamedPixels inputs[] = {{"gInCoarseDepth", &frame.depth}, {"gInNormal", &frame.normal}};
    return pass(inputs, frame.parameters, frame.depth.width, frame.depth.height);
}

Comparison compareWithOracle(const AmbientOcclusionCase& frame, const Pixels& occlusion) {
    const oracle::Image depth = oracleImage(frame.depth), normal = oracleImage(frame.normal);
    oracle::AmbientOcclusion pass = frame.pass;
    pass.depth = &depth;
    pass.normal = &normal;
    return compare(
        occlusion,
        [&](int x, int y, bool careful) {
            const oracle::Visibility visibility = oracle::visibilityAt(pass, x, y);
            return Expected{{visibility.value, oracle::surfaceDepth(pass, x, y), 0.0},
                            {careful ? visibility.error : 0.0, 0.0, 0.0}};
        },
        2);
}

} // namespace passes
