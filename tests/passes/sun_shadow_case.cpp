// SPDX-License-Identifier: Apache-2.0
#include "sun_shadow_case.hpp"

#include <cmath>
#include <cstdlib>

namespace passes {

namespace {

// The columns of the oracle, from the cascades and the camera alone.
void setColumns(SunShadowCase& frame) {
    const glm::dvec2 half = 0.5 * frame.pass.columnSize;
    glm::dmat4 toTexels(1.0);
    toTexels[0][0] = half.x;
    toTexels[1][1] = -half.y;
    toTexels[3] = {half, 0.0, 1.0};
    const glm::dmat4 viewToWorld = glm::inverse(frame.camera.worldToView);
    frame.pass.columns.clear();
    for (const reprise::ShadowCascade& cascade : frame.cascades)
        frame.pass.columns.push_back({toTexels * cascade.worldToClip * viewToWorld, cascade.farDepth});
}

} // namespace

glm::dmat4 lightClip(glm::dvec3 centre, glm::dvec2 extent, double range, bool reversed) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.4, -0.7, 0.5));
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), along));
    const glm::dvec3 up = glm::cross(along, right);
    const auto rowOf = [&](glm::dvec3 axis, double scale, double offset) {
        return glm::dvec4(axis * scale, offset - scale * glm::dot(axis, centre));
    };
    const double sign = reversed ? -1.0 : 1.0;
    return glm::transpose(glm::dmat4(rowOf(right, 2.0 / extent.x, 0.0), rowOf(up, 2.0 / extent.y, 0.0),
                                     rowOf(along, sign / range, 0.5), glm::dvec4(0.0, 0.0, 0.0, 1.0)));
}

void setParameters(SunShadowCase& frame) {
    setColumns(frame);
    reprise::SunShadowTuning tuning;
    tuning.radius = frame.pass.radius;
    tuning.leastTexels = frame.pass.leastTexels;
    tuning.bias = frame.pass.bias;
    tuning.steepest = frame.pass.steepest;
    const auto made = reprise::sunShadowParameters(frame.camera, {1.0, 1.0}, frame.cascades,
                                                   static_cast<uint32_t>(frame.map.width),
                                                   static_cast<uint32_t>(frame.map.height), tuning);
    if (!made) throw std::runtime_error(made.error().message);
    frame.parameters = *made;
    const auto width = static_cast<float>(frame.depth.width), height = static_cast<float>(frame.depth.height);
    const float size[] = {width, height, 1.0f / width, 1.0f / height};
    std::copy(std::begin(size), std::end(size), frame.parameters.gOutputSize);
    frame.parameters.gFrameIndex = static_cast<float>(frame.pass.frame);
    frame.parameters.gSubsetCount = static_cast<float>(frame.pass.subsets);
}

SunShadowCase sunShadowCase(const Variant& variant, Surfaces surfaces, int width, int height, uint64_t seed,
                            int frame) {
    const auto value = [&](std::string_view name) {
        return std::string(reprise::switchValue(variant, name));
    };
    const bool orthographic = value("ORTHOGRAPHIC") == "on";
    const Variant occlusion =
        variantOf(pack(), "ambient_occlusion", {{"ORTHOGRAPHIC", orthographic ? "on" : "off"}});
    const AmbientOcclusionCase surface = ambientOcclusionCase(occlusion, surfaces, width, height, seed);
    SunShadowCase made;
    made.pass.surface = surface.pass;
    made.depth = surface.depth;
    CameraKind kind;
    if (orthographic) kind.projection = Projection::orthographic;
    made.camera = {viewOf({1.5, 2.0, -3.0}, {0.3, -0.1, 0.05}),
                   projectionOf(kind, static_cast<double>(width) / height)};
    made.pass.samples = std::atoi(value("SAMPLES").c_str());
    made.pass.subsets = 3;
    made.pass.frame = frame;
    made.pass.reversed = value("SHADOW_REVERSED") == "on";
    made.values = value("VALUES") == "one"                    ? SunShadowCase::Values::one
                  : value("VALUES") == "two"                  ? SunShadowCase::Values::two
                  : value("VALUES") == "occlusion_in_integer" ? SunShadowCase::Values::occlusionInInteger
                                                              : SunShadowCase::Values::shadowInInteger;

    // Of unequal sides, so that none takes another's place, and not as wide as the view; the last ends before
    // the farthest surfaces.
    const int count = std::atoi(value("CASCADES").c_str());
    const glm::dmat4 viewToWorld = glm::inverse(made.camera.worldToView);
    const double farDepths[] = {3.4375, 3.875, 4.125, 4.375};
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 centre(viewToWorld * glm::dvec4(0.1 * i, 0.05, 3.25 + 0.25 * i, 1.0));
        const glm::dvec2 extent(4.5 + 1.5 * i, 3.5 + 0.75 * i);
        made.cascades.push_back({lightClip(centre, extent, 12.0 * (i + 1), made.pass.reversed),
                                 i + 1 == count ? 4.375 : farDepths[i]});
    }
    made.pass.columnSize = {48, 40};
    made.map = makePixels(r32f, 48 * count, 40, [&](int x, int y) {
        const double noise = unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), 31);
        return Texel{static_cast<float>(0.3 + 0.4 * noise)};
    });
    made.occlusion = makePixels(rg32f, width, height, [&](int x, int y) {
        return Texel{
            static_cast<float>(unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), 32))};
    });
    made.pass.radius = 0.25;
    made.pass.leastTexels = 1.5;
    made.pass.bias = {0.25, 0.0625}; // so that many texels lie within it
    setParameters(made);
    return made;
}

std::vector<Pixels> run(Pass& pass, const SunShadowCase& frame) {
    const NamedPixels inputs[] = {
        {"gInCoarseDepth", &frame.depth}, {"gInShadowMap", &frame.map}, {"gInOcclusion", &frame.occlusion}};
    return pass(inputs, frame.parameters, frame.depth.width, frame.depth.height);
}

Comparison compareWithOracle(const SunShadowCase& frame, const Pixels& shadow) {
    using Values = SunShadowCase::Values;
    const oracle::Image depth = oracleImage(frame.depth), map = oracleImage(frame.map);
    oracle::SunShadow pass = frame.pass;
    pass.surface.depth = &depth;
    pass.map = &map;
    return compare(
        shadow,
        [&](int x, int y, bool careful) {
            const oracle::Visibility sun = oracle::sunVisibilityAt(pass, x, y);
            const double error = careful ? sun.error : 0.0, occlusion = frame.occlusion.at(x, y, 0);
            const double surface = oracle::surfaceDepth(pass.surface, x, y);
            if (frame.values == Values::one) return Expected{{sun.value, surface, 0.0}, {error, 0.0, 0.0}};
            if (frame.values == Values::two)
                return Expected{{frame.occlusion.at(x, y, 0), sun.value, 0.0}, {0.0, error, 0.0}};
            if (frame.values == Values::occlusionInInteger)
                return Expected{{oracle::packPair(occlusion, sun.value), surface, 0.0}, {error, 0.0, 0.0}};
            // A sample more or less is some levels; roundings alone are none, for the mean of a power of two
            // of samples is exact.
            const double step = std::ceil(31.0 * std::max(error - 1e-6, 0.0));
            return Expected{{oracle::packPair(sun.value, occlusion), surface, 0.0}, {step, 0.0, 0.0}};
        },
        2);
}

} // namespace passes
