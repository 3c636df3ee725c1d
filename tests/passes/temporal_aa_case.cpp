// SPDX-License-Identifier: Apache-2.0
#include "temporal_aa_case.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace passes {

namespace {

enum Stream : uint64_t { colourStream = 1, kindStream, motionStream, depthStream, historyStream };

float randomColour(uint64_t seed, int x, int y, uint64_t channel, Contrast contrast) {
    const double u = unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), channel);
    if (contrast == Contrast::moderate) return static_cast<float>(std::exp2(-6.0 + 10.0 * u));
    if (contrast == Contrast::saturated) return u < 0.5 ? 0.0f : 65504.0f;
    if (u < 0.1) return 0.0f;
    return u > 0.98 ? 65504.0f : static_cast<float>(std::exp2(-10.0 + 25.9 * (u - 0.1) / 0.88));
}

Texel colourTexel(uint64_t seed, int x, int y, Contrast contrast) {
    return {randomColour(seed, x, y, 0, contrast), randomColour(seed, x, y, 1, contrast),
            randomColour(seed, x, y, 2, contrast), 1.0f};
}

// Motion in pixels.
glm::dvec2 randomMotion(uint64_t seed, int x, int y, int width, int height) {
    const auto ux = static_cast<uint64_t>(x), uy = static_cast<uint64_t>(y);
    const glm::dvec2 unit(unitHash(seed, ux, uy, 0) - 0.5, unitHash(seed, ux, uy, 1) - 0.5);
    const double kind = unitHash(seed, ux, uy, 2);
    if (kind < 0.3) return glm::dvec2(0.0);
    if (kind < 0.5) return unit;
    if (kind < 0.9) return unit * 16.0;
    return unit * 4.0 * glm::dvec2(width, height);
}

// Multiples of 1/1024 of which each 4x4 block that a pass can read holds sixteen different ones.
float randomDepth(uint64_t seed, int x, int y) {
    const uint64_t level = hashOf(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y)) % 60;
    return static_cast<float>(level * 16 + static_cast<uint64_t>(x % 4 * 4 + y % 4) + 1) / 1024.0f;
}

// Half of the texels lie near the current colour, so that the constraint leaves some of them alone.
Texel historyTexel(uint64_t seed, const Pixels& colour, int x, int y, Contrast contrast) {
    Texel texel = colourTexel(seed, x, y, contrast);
    const auto ux = static_cast<uint64_t>(x), uy = static_cast<uint64_t>(y);
    if (unitHash(seed, ux, uy, 9) < 0.5) return texel;
    for (int c = 0; c < 3; ++c) {
        const double near =
            colour.at(x, y, c) * (0.9 + 0.2 * unitHash(seed, ux, uy, 10 + static_cast<uint64_t>(c)));
        texel[static_cast<size_t>(c)] = static_cast<float>(std::min(near, 65504.0));
    }
    return texel;
}

oracle::TemporalAa::Neighbourhood neighbourhoodOf(std::string_view value) {
    using Neighbourhood = oracle::TemporalAa::Neighbourhood;
    return value == "four_tap"  ? Neighbourhood::fourTap
           : value == "square"  ? Neighbourhood::square
           : value == "rounded" ? Neighbourhood::rounded
                                : Neighbourhood::variance;
}

oracle::TemporalAa::Constraint constraintOf(std::string_view value) {
    using Constraint = oracle::TemporalAa::Constraint;
    return value == "none"          ? Constraint::none
           : value == "clamp"       ? Constraint::clamp
           : value == "clip_centre" ? Constraint::clipCentre
                                    : Constraint::clipLine;
}

oracle::TemporalAa::Unjitter unjitterOf(std::string_view value) {
    using Unjitter = oracle::TemporalAa::Unjitter;
    return value == "off" ? Unjitter::off : value == "bilinear" ? Unjitter::bilinear : Unjitter::gaussian;
}

void applySwitches(oracle::TemporalAa& taa, const Variant& variant) {
    auto is = [&](std::string_view name, std::string_view value) {
        return reprise::switchValue(variant, name) == value;
    };
    taa.motion = !is("MOTION", "off");
    taa.closestFragment = is("CLOSEST_FRAGMENT", "on");
    taa.ycocg = is("COLOUR_SPACE", "ycocg");
    taa.luminanceFeedback = is("FEEDBACK", "luminance");
    taa.motionBlur = is("MOTION_BLUR_FALLBACK", "on");
    taa.hdrWeight = is("HDR_WEIGHT", "on");
    taa.bicubic = is("HISTORY_FILTER", "bicubic");
    taa.depthReversed = is("DEPTH_REVERSED", "on");
    taa.neighbourhood = neighbourhoodOf(reprise::switchValue(variant, "NEIGHBOURHOOD"));
    taa.constraint = constraintOf(reprise::switchValue(variant, "CONSTRAINT"));
    taa.unjitter = unjitterOf(reprise::switchValue(variant, "UNJITTER"));
}

void applyParameters(oracle::TemporalAa& taa, const reprise::TemporalAaParameters& parameters) {
    taa.jitterPx = {parameters.gJitterPx[0], parameters.gJitterPx[1]};
    taa.motionToUv = {parameters.gMotionToUv[0], parameters.gMotionToUv[1]};
    taa.historyValid = parameters.gHistoryValid;
    taa.feedbackMin = parameters.gFeedbackMin;
    taa.feedbackMax = parameters.gFeedbackMax;
    taa.blurFromPx = parameters.gBlurFromPx;
    taa.blurToPx = parameters.gBlurToPx;
}

bool isCamera(const Variant& variant) {
    return reprise::switchValue(variant, "MOTION") == "camera";
}

// The levels of randomDepth() as surfaces from 0.4 to 25 m, and the sky: two of them differ by more than
// shared reads round by.
float surfaceDepth(const CameraKind& kind, const oracle::Camera& camera, double level) {
    if (level > 0.9) return kind.depth == Depth::standard ? 1.0f : 0.0f;
    return static_cast<float>(oracle::deviceDepth(0.4 * std::pow(100.0, level), camera.viewToClip));
}

// Its depth is that of the frame; parameters follow.
void setCamera(TemporalAaFrame& frame, const oracle::CameraVelocity& camera) {
    frame.camera = camera;
    CameraCase same{.pass = camera, .depth = {}};
    setParameters(same);
    std::ranges::copy(same.parameters.gReprojection, frame.parameters.gReprojection);
    for (int i = 0; i < 2; ++i)
        frame.parameters.gJitterPx[i] = static_cast<float>(camera.jitterPx[i]);
}

// The motion of every texel in double precision, and what float32 may make of it.
struct CameraMotion {
    oracle::Image motion, error;

    explicit CameraMotion(const TemporalAaFrame& frame)
        : motion(frame.width(), frame.height()), error(frame.width(), frame.height()) {
        CameraCase camera{.pass = frame.camera, .depth = frame.depth};
        setParameters(camera);
        for (int y = 0; y < frame.height(); ++y)
            for (int x = 0; x < frame.width(); ++x) {
                const double depth = frame.depth.at(x, y, 0);
                motion.at(x, y) = {oracle::cameraVelocity(camera.pass, x, y, depth), 0.0, 0.0};
                error.at(x, y) = {motionBound(camera, x, y), 0.0, 0.0};
            }
    }
};

// What the oracle takes of a frame.
struct OracleFrame {
    oracle::Image colour, depth, velocity, history;
    std::optional<CameraMotion> camera;
    oracle::TemporalAa taa;

    OracleFrame(const Variant& variant, const TemporalAaFrame& frame, double coordinateErrorPx)
        : colour(oracleImage(frame.colour)), depth(oracleImage(frame.depth)),
          velocity(oracleImage(frame.velocity)), history(oracleImage(frame.history)) {
        applySwitches(taa, variant);
        applyParameters(taa, frame.parameters);
        taa.colour = &colour;
        taa.depth = &depth;
        taa.velocity = &velocity;
        taa.history = &history;
        taa.filterErrorPx = coordinateErrorPx;
        if (!isCamera(variant)) return;
        camera.emplace(frame);
        taa.velocity = &camera->motion;
        taa.velocityError = &camera->error;
        taa.motionToUv = {1.0, 1.0};
    }
    OracleFrame(const OracleFrame&) = delete; // taa points into it

    glm::dvec3 valueOf(size_t output, int x, int y) const {
        return ofOutput(output, oracle::temporalAa(taa, x, y));
    }
    glm::dvec3 errorOf(size_t output, int x, int y) const {
        return ofOutput(output, oracle::temporalAaError(taa, x, y));
    }

private:
    static glm::dvec3 ofOutput(size_t output, const oracle::TemporalAaPixel& pixel) {
        return output == 0 ? pixel.history : pixel.colour;
    }
};

template <class ExpectedOf>
Comparison compareEach(const std::vector<Pixels>& outputs, const ExpectedOf& expectedOf) {
    Comparison all;
    for (size_t output = 0; output < outputs.size(); ++output) {
        const Comparison each = compare(
            outputs[output], [&](int x, int y, bool careful) { return expectedOf(output, x, y, careful); },
            3);
        join(all, each, output == 0 ? "gOutHistory" : "gOutColour");
    }
    return all;
}

} // namespace

glm::dvec2 motionOf(const Variant& variant, const TemporalAaFrame& frame, int x, int y) {
    if (isCamera(variant)) return oracle::cameraVelocity(frame.camera, x, y, frame.depth.at(x, y, 0));
    return {frame.velocity.at(x, y, 0), frame.velocity.at(x, y, 1)};
}

reprise::TemporalAaParameters parametersFor(int width, int height) {
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    return {.gOutputSize = {w, h, 1.0f / w, 1.0f / h},
            .gJitterPx = {0.28125f, -0.40625f},
            .gMotionToUv = {1.0f, 1.0f},
            .gHistoryValid = 1.0f,
            .gFeedbackMin = 0.88f,
            .gFeedbackMax = 0.97f,
            .gBlurFromPx = 2.0f,
            .gBlurToPx = 15.0f,
            .pad0 = {},
            .gReprojection = {}};
}

TemporalAaFrame randomFrame(int width, int height, uint64_t seed, Contrast contrast) {
    TemporalAaFrame frame;
    frame.colour = makePixels(rgba16f, width, height, [&](int x, int y) {
        return colourTexel(hashOf(seed, colourStream), x, y, contrast);
    });
    frame.velocity = makePixels(rg16f, width, height, [&](int x, int y) {
        const glm::dvec2 motion =
            randomMotion(hashOf(seed, motionStream), x, y, width, height) / glm::dvec2(width, height);
        return Texel{static_cast<float>(motion.x), static_cast<float>(motion.y), 0.0f, 0.0f};
    });
    frame.depth = makePixels(r32f, width, height, [&](int x, int y) {
        return Texel{randomDepth(hashOf(seed, depthStream), x, y), 0.0f, 0.0f, 0.0f};
    });
    frame.history = makePixels(rgba16f, width, height, [&](int x, int y) {
        return historyTexel(hashOf(seed, historyStream), frame.colour, x, y, contrast);
    });
    frame.parameters = parametersFor(width, height);
    const double aspect = static_cast<double>(width) / height;
    // Most of the depths are within a metre, where a step of centimetres is a motion of many pixels.
    setCamera(frame,
              {.current = {viewOf({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), projectionOf({}, aspect)},
               .previous = {viewOf({0.02, 0.01, -0.03}, {0.02, -0.01, 0.04}), projectionOf({}, aspect, 1.03)},
               .jitterPx = {0.28125, -0.40625},
               .extent = {width, height}});
    return frame;
}

TemporalAaFrame cameraFrame(const CameraKind& kind, int width, int height, uint64_t seed, bool behind) {
    TemporalAaFrame frame = randomFrame(width, height, seed);
    oracle::CameraVelocity camera = randomCameraCase(kind, false, width, height, seed).pass;
    if (behind) camera.previous.worldToView = viewOf({1.4, 2.05, -3.2}, {0.33 + 3.14159, 0.12, 0.02});
    setCamera(frame, camera);
    for (float& depth : frame.depth.values)
        depth = surfaceDepth(kind, frame.camera.current, depth);
    return frame;
}

std::vector<Pixels> run(Pass& pass, const TemporalAaFrame& frame) {
    const NamedPixels inputs[] = {{"gInColour", &frame.colour},
                                  {"gInDepth", &frame.depth},
                                  {"gInVelocity", &frame.velocity},
                                  {"gHistoryColour", &frame.history}};
    return pass(inputs, frame.parameters, frame.width(), frame.height());
}

Comparison compareWithOracle(const Variant& variant, const TemporalAaFrame& frame,
                             const std::vector<Pixels>& outputs) {
    return compareWithOracle(variant, frame, outputs, linearFilterError());
}

Comparison compareWithOracle(const Variant& variant, const TemporalAaFrame& frame,
                             const std::vector<Pixels>& outputs, double coordinateErrorPx) {
    const OracleFrame with(variant, frame, coordinateErrorPx);
    return compareEach(outputs, [&](size_t output, int x, int y, bool careful) {
        return Expected{with.valueOf(output, x, y), careful ? with.errorOf(output, x, y) : glm::dvec3(0.0)};
    });
}

Comparison compareWithVectors(const Variant& variant, const TemporalAaFrame& frame,
                              const std::vector<Pixels>& outputs, const std::vector<Pixels>& expected) {
    OracleFrame with(variant, frame, linearFilterError());
    for (int y = 0; y < frame.height(); ++y)
        for (int x = 0; x < frame.width(); ++x)
            for (int c = 0; c < 2; ++c)
                with.camera->error.at(x, y)[c] +=
                    storeError(frame.velocity.format, frame.velocity.at(x, y, c));
    return compareEach(outputs, [&](size_t output, int x, int y, bool careful) {
        const glm::dvec3 value(expected[output].at(x, y, 0), expected[output].at(x, y, 1),
                               expected[output].at(x, y, 2));
        return Expected{value, careful ? with.errorOf(output, x, y) : glm::dvec3(0.0)};
    });
}

} // namespace passes
