// SPDX-License-Identifier: Apache-2.0
#include "reprojection_cache_case.hpp"

#include <cmath>

namespace passes {

namespace {

using oracle::CachePass;

double unit(uint64_t seed, int x, int y, uint64_t what) {
    return unitHash(seed, static_cast<uint64_t>(x + 7), static_cast<uint64_t>(y + 7), what);
}

// View depth of a tilted plane of the world at uv of a camera's frame.
double planeDepth(const oracle::Camera& camera, glm::dvec2 uv) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.3, -1.0)), point(0.0, 0.0, 9.0);
    const glm::dmat4 toWorld = glm::inverse(camera.worldToView);
    const glm::dvec2 ndc = oracle::uvToNdc(uv);
    const glm::dvec3 a(toWorld * oracle::viewPoint(ndc, 1.0, camera.viewToClip));
    const glm::dvec3 b(toWorld * oracle::viewPoint(ndc, 2.0, camera.viewToClip));
    return 1.0 + glm::dot(point - a, normal) / glm::dot(b - a, normal);
}

// Random values as a texel holds them, and depth where it has its place beside them.
Texel valueTexel(const CachePass& pass, uint64_t seed, int x, int y, uint64_t what, double depth) {
    glm::dvec4 values;
    for (int i = 0; i < 4; ++i)
        values[i] = unit(seed, x, y, what + static_cast<uint64_t>(i));
    const double frames = std::floor(15.0 * unit(seed, x, y, what + 4)) + 1.0;
    const glm::vec4 texel(oracle::packedValues(pass.values, values, depth, frames));
    return {texel.x, texel.y, texel.z, texel.w};
}

// Texel of the coarse image to UV of the frame.
glm::dvec2 frameUv(const CachePass& pass, int x, int y) {
    return double(pass.ratio) * glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(pass.frameExtent);
}

// By how much float32 may misplace the history, in texels, and the depth that is expected there, in metres.
// Eight roundings of the sums of four products, as of camera_velocity; a view of the scene 20 m wide at most.
constexpr double placeError = 0x1p-19, depthError = 1e-5;

// Whether the part that becomes a whole number lies between two of them, where a rounding chooses either.
// Means of a few whole numbers often do.
bool isHalfway(const CachePass& pass, glm::dvec4 values) {
    const double whole = pass.values == CachePass::Values::occlusionInInteger ? values.x : values.y;
    return std::abs(glm::fract(31.0 * whole) - 0.5) < 1e-4;
}

} // namespace

void setParameters(ReprojectionCacheCase& frame) {
    const CachePass& pass = frame.pass;
    auto& p = frame.parameters;
    const reprise::CameraFrame current{pass.current.worldToView, pass.current.viewToClip};
    const reprise::CameraFrame previous{pass.previous.worldToView, pass.previous.viewToClip};
    const glm::dmat4 toPreviousClip = reprise::viewToPreviousClip(current, previous);
    for (int i = 0; i < 16; ++i)
        p.gViewToPreviousClip[i] = static_cast<float>(toPreviousClip[i / 4][i % 4]);
    const glm::dvec2 coarse(frame.fresh.width, frame.fresh.height);
    const glm::dvec2 frameToCoarse = glm::dvec2(pass.frameExtent) / (double(pass.ratio) * coarse);
    const glm::dvec4 ray = reprise::viewRay(pass.current.viewToClip);
    for (int i = 0; i < 2; ++i) {
        p.gOutputSize[i] = static_cast<float>(coarse[i]);
        p.gOutputSize[i + 2] = static_cast<float>(1.0 / coarse[i]);
        p.gViewRay[i] = static_cast<float>(ray[i] / frameToCoarse[i]);
        p.gViewRay[i + 2] = static_cast<float>(ray[i + 2]);
        p.gFrameToCoarse[i] = static_cast<float>(frameToCoarse[i]);
        p.gMotionToUv[i] = static_cast<float>(pass.motionToUv[i]);
        p.gMissThreshold[i] = static_cast<float>(pass.missThreshold[i]);
        p.gChange[i] = static_cast<float>(pass.change[i]);
        p.gSpeedPx[i] = static_cast<float>(pass.speedPx[i]);
        p.gClipToDepth[i] = static_cast<float>(i);
        if (oracle::isOrthographic(pass.previous.viewToClip))
            p.gClipToDepth[i] =
                static_cast<float>(reprise::linearDepthCoefficients(pass.previous.viewToClip)[i]);
    }
    p.gConvergenceTime = static_cast<float>(pass.convergenceTime);
    p.gMaxWeight = static_cast<float>(pass.maxWeight);
    p.gHistoryValid = static_cast<float>(pass.historyValid);
}

std::vector<VkFormat> cacheFormats(const Variant& variant) {
    const bool framed = cachedValuesOf(variant) == CachePass::Values::withFrames;
    return framed ? std::vector<VkFormat>{r32f} : std::vector<VkFormat>{rgba32f, rg32f};
}

Pixels depthsOf(const Pixels& state) {
    return makePixels(r32f, state.width, state.height,
                      [&](int x, int y) { return Texel{state.at(x, y, 1)}; });
}

ReprojectionCacheCase reprojectionCacheCase(const Variant& variant, int width, int height, uint64_t seed) {
    ReprojectionCacheCase made;
    CachePass& pass = made.pass;
    const auto isOn = [&](std::string_view name) { return reprise::switchValue(variant, name) == "on"; };
    CameraKind kind;
    if (isOn("ORTHOGRAPHIC")) kind.projection = Projection::orthographic;
    const double aspect = static_cast<double>(width) / height;
    pass.current = {viewOf({0.1, 0.05, -0.2}, {0.02, -0.01, 0.01}), projectionOf(kind, aspect)};
    pass.previous = {viewOf({0.0, 0.1, -0.3}, {0.04, 0.01, -0.02}), projectionOf(kind, aspect, 1.03)};
    pass.values = cachedValuesOf(variant);
    const std::string_view history = reprise::switchValue(variant, "HISTORY");
    pass.where = history == "motion"  ? CachePass::History::motion
                 : history == "still" ? CachePass::History::still
                 : history == "none"  ? CachePass::History::none
                                      : CachePass::History::camera;
    pass.bilinear =
        reprise::switchValue(variant, "RESAMPLING") == "bilinear" && pass.where != CachePass::History::still;
    pass.detectsChange = isOn("CHANGE_DETECTION");
    pass.frameExtent = {width, height};
    pass.motionToUv = {0.5, -0.5};
    const glm::ivec2 coarse = oracle::coarseExtent(pass.frameExtent, pass.ratio);
    const auto freshDepth = [&](int x, int y) {
        const double nearer = unit(seed, x / 4, y / 4, 1) < 0.2 ? 1.0 : 0.0;
        const bool sky = unit(seed, x, y, 2) < 0.05;
        return sky ? 65504.0 : planeDepth(pass.current, frameUv(pass, x, y)) - nearer;
    };
    CachePass freshPass = pass; // what is fresh has no frames
    if (pass.values == CachePass::Values::withFrames) freshPass.values = CachePass::Values::two;
    made.fresh = makePixels(rgba32f, coarse.x, coarse.y, [&](int x, int y) {
        return valueTexel(freshPass, seed, x, y, 10, freshDepth(x, y));
    });
    made.coarseDepth = makePixels(r32f, coarse.x, coarse.y,
                                  [&](int x, int y) { return Texel{static_cast<float>(freshDepth(x, y))}; });
    const auto historyDepth = [&](int x, int y) {
        // Depths differ by less than the threshold within the surface.
        const double other = unit(seed, x / 5, y / 5, 3) < 0.16 ? 1.5 : 0.1 * unit(seed, x, y, 4);
        return planeDepth(pass.previous, frameUv(pass, x, y)) + other;
    };
    made.history = makePixels(rgba32f, coarse.x, coarse.y, [&](int x, int y) {
        return valueTexel(pass, seed, x, y, 20, historyDepth(x, y));
    });
    made.state = makePixels(rg32f, coarse.x, coarse.y, [&](int x, int y) {
        const double frames = std::floor(20.0 * unit(seed, x, y, 5)) + 1.0;
        return Texel{static_cast<float>(frames), static_cast<float>(historyDepth(x, y))};
    });
    made.historyDepth = depthsOf(made.state);
    made.velocity = makePixels(rg32f, width, height, [&](int x, int y) {
        const double reach = unit(seed, x / 6, y / 6, 6) < 0.7 ? 8.0 : 80.0; // pixels of the frame
        const glm::dvec2 motion = reach * (glm::dvec2(unit(seed, x, y, 7), unit(seed, x, y, 8)) - 0.5) /
                                  glm::dvec2(width, height) / pass.motionToUv;
        return Texel{static_cast<float>(motion.x), static_cast<float>(motion.y)};
    });
    setParameters(made);
    return made;
}

std::vector<Pixels> run(Pass& pass, const ReprojectionCacheCase& frame) {
    const NamedPixels inputs[] = {{"gInFresh", &frame.fresh},
                                  {"gInCoarseDepth", &frame.coarseDepth},
                                  {"gInVelocity", &frame.velocity},
                                  {"gHistoryCache", &frame.history},
                                  {"gHistoryCacheFiltered", &frame.history},
                                  {"gHistoryCoarseDepth", &frame.historyDepth},
                                  {"gHistoryCacheState", &frame.state},
                                  {"gHistoryCacheStateFiltered", &frame.state}};
    return pass(inputs, frame.parameters, frame.fresh.width, frame.fresh.height);
}

Comparison compareWithOracle(const ReprojectionCacheCase& frame, const std::vector<Pixels>& outputs) {
    const oracle::Image fresh = oracleImage(frame.fresh), velocity = oracleImage(frame.velocity);
    const oracle::Image coarseDepth = oracleImage(frame.coarseDepth);
    const oracle::Image history = oracleImage(frame.history);
    CachePass pass = frame.pass;
    const bool framed = pass.values == CachePass::Values::withFrames;
    oracle::Image state = oracleImage(framed ? frame.historyDepth : frame.state);
    for (glm::dvec4& texel : state.texels)
        if (framed) texel.y = texel.x;
    pass.fresh = &fresh;
    pass.coarseDepth = &coarseDepth;
    pass.velocity = &velocity;
    pass.history = &history;
    pass.state = &state;
    const bool packed = oracle::isPacked(pass.values);
    // Two passes over three channels: the values and frames, then the rest of the values and depth.
    const auto part = [&](bool rest) {
        const auto shown = [&](const oracle::CacheTexel& texel) {
            if (framed) return glm::dvec3(glm::dvec2(texel.unpacked), std::min(texel.frames, 15.0));
            return rest ? glm::dvec3(texel.values.z, texel.values.w, texel.depth)
                        : glm::dvec3(texel.values.x, texel.values.y, texel.frames);
        };
        const int own = rest ? 2 : 0;
        const bool apart = oracle::isDepthApart(pass.values);
        const Pixels got = makePixels(rgba32f, fresh.width, fresh.height, [&](int x, int y) {
            if (framed) {
                const glm::vec3 held(oracle::unpackedWithFrames(outputs[0].at(x, y, 0)));
                return Texel{held.x, held.y, held.z};
            }
            const auto value = [&](int c) { return c < outputs[0].channels ? outputs[0].at(x, y, c) : 0.0f; };
            const float depth = apart ? outputs[1].at(x, y, 1) : outputs[0].at(x, y, 1);
            return Texel{value(own), value(own + 1), rest ? depth : outputs[1].at(x, y, 0)};
        });
        return compare(
            got,
            [&](int x, int y, bool careful) {
                const glm::dvec3 value = shown(oracle::cacheTexel(pass, x, y));
                glm::dvec3 bound;
                for (int c = 0; c < 3 && !framed; ++c)
                    bound[c] = storeError(outputs[c == 2 ? 1 : 0].format, value[c]);
                // Half a level, half a frame.
                if (framed) bound = glm::dvec3(0.5 / 1023.0, 0.5 / 1023.0, 0.5) * (1.0 + 1e-5);
                if (!careful) return Expected{value, bound};
                // Steps of the filter's weights, where there is a filter.
                const double error = placeError * fresh.width + (pass.bilinear ? linearFilterError() : 0.0);
                glm::dvec3 most(1e-6, 1e-6, rest ? 0.0 : 1e-5);
                if (!rest && !apart && !framed && pass.values != CachePass::Values::four) most.y = 0.0;
                for (int i = 0; i < 27; ++i) {
                    const glm::dvec2 away(error * (i % 3 - 1), error * (i / 3 % 3 - 1));
                    const auto moved = oracle::cacheTexel(pass, x, y, away, depthError * (i / 9 - 1));
                    most = glm::max(most, glm::abs(shown(moved) - value));
                }
                if (packed && !rest && isHalfway(pass, oracle::cacheTexel(pass, x, y).unpacked)) most.x = 1.0;
                return Expected{value, bound + 1.5 * most};
            },
            3);
    };
    const Comparison first = part(false);
    return first.holds() && !framed ? part(true) : first;
}

} // namespace passes
