// SPDX-License-Identifier: Apache-2.0
#include "scalable_obscurance_case.hpp"

#include "depth_hierarchy_case.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

namespace passes {

namespace {

using oracle::ObscuranceTexel;

double unit(uint64_t seed, int x, int y, uint64_t what) {
    return unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), what);
}

Texel texelOf(glm::dvec4 digits) {
    return {static_cast<float>(digits.x), static_cast<float>(digits.y), static_cast<float>(digits.z),
            static_cast<float>(digits.w)};
}

Texel anyBytes(uint64_t seed, int x, int y) {
    Texel texel{};
    for (size_t c = 0; c < 4; ++c)
        texel[c] = static_cast<float>(std::floor(256.0 * unit(seed, x, y, 30 + c)) / 255.0);
    return texel;
}

bool isOn(const Variant& variant, std::string_view name) {
    return reprise::switchValue(variant, name) == "on";
}

// Depth of the pixel as it is expected in the previous view, apart from it by up to 1.3 thresholds.
Texel historyTexel(const oracle::ScalableObscurance& pass, uint64_t seed, int x, int y) {
    if (unit(seed, x / 3, y / 3, 9) < 0.05) return anyBytes(seed, x, y);
    const oracle::AmbientOcclusion surface = oracle::surfaceOf(pass);
    const double depth = oracle::surfaceDepth(surface, x, y);
    const glm::dvec3 point = oracle::viewPointOf(surface, glm::dvec2(x + 0.5, y + 0.5), depth);
    const double expected =
        std::min(pass.motion ? glm::dot(pass.toPreviousDepth, glm::dvec4(point, 1.0)) : depth, pass.farM);
    const double threshold = pass.missThreshold.x + pass.missThreshold.y * expected;
    ObscuranceTexel texel;
    texel.value = unit(seed, x, y, 10);
    texel.depth = expected + threshold * 1.3 * (2.0 * unit(seed, x, y, 11) - 1.0);
    texel.frames = std::floor(16.0 * unit(seed, x, y, 12));
    return texelOf(oracle::packedObscurance(texel, pass.farM));
}

// Of a whole number of steps that a rounding by `error` may make another.
double stepsOff(double value, double error) {
    return std::max(std::abs(std::floor(value + error) - std::floor(value)),
                    std::abs(std::floor(value - error) - std::floor(value)));
}

// Value, metres and frames as the digits hold them.
glm::dvec3 written(const ObscuranceTexel& texel, double farM, double noise) {
    const ObscuranceTexel back =
        oracle::unpackedObscurance(oracle::packedObscurance(texel, farM, noise), farM);
    return {back.value, back.depth, back.frames};
}

// Bounds of the three, where `error` is that of the value and `frameError` that of the frames.
glm::dvec3 writtenBound(const ObscuranceTexel& texel, double farM, double noise, double error,
                        double frameError) {
    const double value =
        stepsOff(4080.0 * oracle::held(texel.value, 0.0, 1.0) + noise, 4080.0 * error) / 4080.0;
    const double key = 65535.0 * oracle::held(texel.depth / farM, 0.0, 1.0) + 0.5;
    const double depth = stepsOff(key, 4.0 * 0x1p-24 * key) / 65535.0 * farM;
    return {value, depth, stepsOff(oracle::held(texel.frames, 0.0, 15.0) + 0.5, frameError)};
}

} // namespace

Pixels hierarchyOf(const Pixels& depth) {
    const glm::ivec2 frame(depth.width, depth.height), extent = hierarchyExtent(frame.x, frame.y);
    return makePixels(r32f, extent.x, extent.y, [&](int x, int y) {
        const auto shown = oracle::hierarchySource(frame, {x, y});
        if (!shown) return Texel{std::numeric_limits<float>::quiet_NaN()};
        const float metres = depth.at(shown->x, shown->y, 0);
        return Texel{metres > 0.0f && metres < 65504.0f ? metres : 65504.0f};
    });
}

void setParameters(ScalableObscuranceCase& frame) {
    const auto& pass = frame.pass;
    auto& p = frame.parameters;
    const auto width = static_cast<float>(frame.depth.width), height = static_cast<float>(frame.depth.height);
    const float size[] = {width, height, 1.0f / width, 1.0f / height};
    std::copy(std::begin(size), std::end(size), p.gOutputSize);
    for (int i = 0; i < 4; ++i) {
        p.gViewRay[i] = static_cast<float>(pass.viewRay[i]);
        p.gViewToPreviousDepth[i] = static_cast<float>(pass.toPreviousDepth[i]);
    }
    for (int i = 0; i < 2; ++i) {
        p.gBias[i] = static_cast<float>(pass.bias[i]);
        p.gMissThreshold[i] = static_cast<float>(pass.missThreshold[i]);
        p.gMotionToUv[i] = static_cast<float>(pass.motionToUv[i]);
    }
    p.gRadius = static_cast<float>(pass.radius);
    p.gIntensity = static_cast<float>(pass.intensity);
    p.gFrameIndex = static_cast<float>(pass.frame);
    p.gRotationCount = static_cast<float>(pass.rotations);
    p.gFarDepth = static_cast<float>(pass.farM);
    p.gMaxWeight = static_cast<float>(pass.maxWeight);
    p.gHistoryValid = static_cast<float>(pass.historyValid);
    p.gMovingWeight = static_cast<float>(pass.movingWeight);
    p.gMovingPx = static_cast<float>(pass.movingPx);
    frame.hierarchy = hierarchyOf(frame.depth);
}

ScalableObscuranceCase scalableObscuranceCase(const Variant& variant, Surfaces surfaces, int width,
                                              int height, uint64_t seed, int frame) {
    ScalableObscuranceCase made;
    const AmbientOcclusionCase scene = ambientOcclusionCase(variant, surfaces, width, height, seed);
    auto& pass = made.pass;
    pass.orthographic = scene.pass.orthographic;
    pass.viewRay = scene.pass.viewRay;
    pass.samples = std::atoi(std::string(reprise::switchValue(variant, "SAMPLES")).c_str());
    pass.temporal = isOn(variant, "TEMPORAL");
    pass.motion = isOn(variant, "MOTION");
    pass.frame = frame;
    // Of an image of few pixels a wide one, so that levels are met. Values that float32 holds.
    pass.radius = width <= 64 ? 4.0 : 1.5;
    pass.bias = {double{0.01f}, double{0.002f}};
    pass.intensity = 0.5;
    pass.maxWeight = double{0.9f};
    pass.movingWeight = 0.375;
    pass.movingPx = 2.0; // of motions up to three pixels
    pass.missThreshold = {0.0625, 0.03125};
    pass.motionToUv = {0.5, -0.5};
    pass.toPreviousDepth = {0.03125, -0.015625, 1.0, 0.0625};
    made.depth = scene.depth;
    const oracle::Image depth = oracleImage(made.depth);
    pass.depth = &depth;
    made.history =
        makePixels(rgba8, width, height, [&](int x, int y) { return historyTexel(pass, seed, x, y); });
    pass.depth = nullptr;
    made.velocity = makePixels(rg32f, width, height, [&](int x, int y) {
        // Up to three pixels, a few out of the image.
        const double reach = unit(seed, x / 6, y / 6, 13) < 0.9 ? 6.0 : 60.0;
        const glm::dvec2 motion = reach * (glm::dvec2(unit(seed, x, y, 14), unit(seed, x, y, 15)) - 0.5) /
                                  glm::dvec2(width, height) / pass.motionToUv;
        return Texel{static_cast<float>(motion.x), static_cast<float>(motion.y)};
    });
    setParameters(made);
    return made;
}

std::vector<Pixels> run(Pass& pass, const ScalableObscuranceCase& frame) {
    const NamedPixels inputs[] = {{"gInDepthHierarchy", &frame.hierarchy},
                                  {"gInVelocity", &frame.velocity},
                                  {"gHistoryObscurance", &frame.history}};
    return pass(inputs, frame.parameters, frame.depth.width, frame.depth.height);
}

Pixels unpacked(const Pixels& digits, double farM) {
    return makePixels(rgba32f, digits.width, digits.height, [&](int x, int y) {
        glm::dvec4 texel;
        for (int c = 0; c < 4; ++c)
            texel[c] = digits.at(x, y, c);
        const float broken = std::numeric_limits<float>::quiet_NaN();
        for (int c = 0; c < 4; ++c) {
            // A channel is a whole number of 255.
            const double code = 255.0 * texel[c];
            if (!(std::abs(code - std::round(code)) < 1e-3)) return Texel{broken, broken, broken, broken};
        }
        const ObscuranceTexel back = oracle::unpackedObscurance(texel, farM);
        return Texel{static_cast<float>(back.value), static_cast<float>(back.depth),
                     static_cast<float>(back.frames), 0.0f};
    });
}

Comparison compareWithOracle(const ScalableObscuranceCase& frame, const Pixels& obscurance) {
    const oracle::Image depth = oracleImage(frame.depth), velocity = oracleImage(frame.velocity);
    const oracle::Image history = oracleImage(frame.history);
    oracle::ScalableObscurance pass = frame.pass;
    pass.depth = &depth;
    pass.velocity = &velocity;
    pass.history = &history;
    return compare(
        unpacked(obscurance, pass.farM),
        [&](int x, int y, bool careful) {
            const oracle::Visibility visibility = oracle::obscuranceAt(pass, x, y);
            const ObscuranceTexel texel = oracle::accumulatedAt(pass, x, y, visibility.value);
            const double noise = oracle::writeNoise(pass, x, y);
            const glm::dvec3 value = written(texel, pass.farM, noise);
            if (!careful) return Expected{value, glm::dvec3(1e-7, 1e-5, 0.0)};
            // Roundings of the place in the history and of the expected depth, which the history's steepest
            // weight, 3 / threshold, multiplies.
            double error = visibility.error, frameError = 1e-4;
            for (int i = 0; i < 27; ++i) {
                const glm::dvec2 away = 0x1p-21 * frame.depth.width * glm::dvec2(i % 3 - 1, i / 3 % 3 - 1);
                const auto moved =
                    oracle::accumulatedAt(pass, x, y, visibility.value, away, 2e-5 * (i / 9 - 1));
                error = std::max(error, std::abs(moved.value - texel.value) + visibility.error);
                frameError = std::max(frameError, std::abs(moved.frames - texel.frames) + 1e-4);
            }
            return Expected{value, glm::dvec3(1e-7, 1e-5, 0.0) +
                                       writtenBound(texel, pass.farM, noise, error + 1e-6, frameError)};
        },
        3);
}

void setParameters(ObscuranceFilterCase& frame) {
    auto& p = frame.parameters;
    const auto width = static_cast<float>(frame.source.width),
               height = static_cast<float>(frame.source.height);
    const float size[] = {width, height, 1.0f / width, 1.0f / height};
    std::copy(std::begin(size), std::end(size), p.gOutputSize);
    for (int i = 0; i < 2; ++i) {
        p.gDirection[i] = static_cast<float>(frame.pass.direction[i]);
        p.gDepthRange[i] = static_cast<float>(frame.pass.depthRange[i]);
    }
    p.gFarDepth = static_cast<float>(frame.pass.farM);
}

ObscuranceFilterCase obscuranceFilterCase(int width, int height, glm::ivec2 direction, uint64_t seed) {
    ObscuranceFilterCase made;
    made.pass.direction = direction;
    made.pass.depthRange = {0.0625, 0.03125};
    made.source = makePixels(rgba8, width, height, [&](int x, int y) {
        if (unit(seed, x / 3, y / 3, 1) < 0.1) return anyBytes(seed, x, y);
        ObscuranceTexel texel;
        texel.value = unit(seed, x, y, 2);
        const double surface = unit(seed, x / 5, y / 5, 3);
        texel.depth = (surface < 0.1   ? made.pass.farM
                       : surface < 0.5 ? 4.0
                                       : 20.0) +
                      0.3 * unit(seed, x, y, 4);
        texel.frames = std::floor(16.0 * unit(seed, x, y, 5));
        return texelOf(oracle::packedObscurance(texel, made.pass.farM));
    });
    setParameters(made);
    return made;
}

std::vector<Pixels> run(Pass& pass, const ObscuranceFilterCase& frame) {
    const NamedPixels inputs[] = {{"gInObscurance", &frame.source}};
    return pass(inputs, frame.parameters, frame.source.width, frame.source.height);
}

Comparison compareWithOracle(const ObscuranceFilterCase& frame, const Pixels& filtered) {
    const oracle::Image source = oracleImage(frame.source);
    oracle::ObscuranceFilter pass = frame.pass;
    pass.source = &source;
    return compare(
        unpacked(filtered, pass.farM),
        [&](int x, int y, bool careful) {
            const ObscuranceTexel texel = oracle::filteredObscurance(pass, x, y);
            // Nine weights, each of a difference of depths that is exact to 2^-23 of them, over the range.
            const double range = pass.depthRange.x + pass.depthRange.y * texel.depth;
            const double error = careful ? 1e-6 + 4.0 * 0x1p-23 * texel.depth / range : 0.0;
            return Expected{written(texel, pass.farM, 0.5),
                            glm::dvec3(1e-7, 1e-5, 0.0) + writtenBound(texel, pass.farM, 0.5, error, 1e-4)};
        },
        3);
}

} // namespace passes
