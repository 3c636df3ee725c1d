// SPDX-License-Identifier: Apache-2.0
// Depth kinds x projections x direction of y x jittered or not x sign and scale of motion: camera_velocity
// finds the motion that ray casting finds, and temporal_aa fetches history from where the surface was, by
// motion that it is given and by its own.
#include "planes.hpp"
#include "temporal_aa_case.hpp"

#include <tuple>

namespace passes {
namespace {

constexpr int width = 64, height = 48;
const glm::dvec2 extent(width, height);
constexpr double aspect = static_cast<double>(width) / height;

// A float32 depth of a standard projection resolves 2^-24 z^2 / near metres at depth z: 1e-4 m at the 20 m of
// the background, whose parallax changes by less than 1/4 px per metre. The rest is roundings of the matrix
// product.
constexpr double motionBoundPx = 1.0 / 512.0;

struct Setting {
    CameraKind kind;
    bool sharesY = false, jittered = false;
};

std::string text(const Setting& setting) {
    return text(setting.kind) + (setting.sharesY ? ", y shared" : ", y opposed") +
           (setting.jittered ? ", jittered" : ", not jittered");
}

PlatformSwitches platformOf(const Setting& setting) {
    return {{"NDC_AND_UV_SHARE_Y", setting.sharesY ? 1 : 0}};
}

// Everything that is seen, by ray casting.
struct Truth {
    PlanesView current, previous;
    std::vector<Hit> hits;
    std::vector<glm::dvec2> motion; // UV

    explicit Truth(const Setting& setting)
        : current(currentView(setting.kind, aspect)), previous(previousView(setting.kind, aspect)) {
        current.sharesY = previous.sharesY = setting.sharesY;
        if (setting.jittered) current.jitterPx = {0.34375, -0.40625};
        for (int i = 0; i < width * height; ++i) {
            const glm::dvec2 px(i % width + 0.5, i / width + 0.5);
            hits.push_back(castRay(current, px, extent));
            motion.push_back(uvOf(current, hits.back().world) - uvOf(previous, hits.back().world));
        }
    }
    size_t index(int x, int y) const {
        return static_cast<size_t>(std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1));
    }
};

CameraCase caseOf(const Setting& setting, const Truth& truth, bool depthLinear) {
    CameraCase frame;
    frame.pass = {truth.current.camera, truth.previous.camera, truth.current.jitterPx, extent,
                  depthLinear,          setting.sharesY};
    frame.depth = makePixels(r32f, width, height, [&](int x, int y) {
        const double linear = truth.hits[truth.index(x, y)].linearDepth;
        const double device = oracle::deviceDepth(linear, truth.current.camera.viewToClip);
        return Texel{static_cast<float>(depthLinear ? linear : device)};
    });
    setParameters(frame);
    return frame;
}

Pass velocityPass(const Setting& setting, Stage stage, bool depthLinear, VkFormat format) {
    const bool orthographic = setting.kind.projection == Projection::orthographic;
    const Variant variant = variantOf(
        pack(), "camera_velocity",
        {{"DEPTH_LINEAR", depthLinear ? "on" : "off"}, {"ORTHOGRAPHIC", orthographic ? "on" : "off"}});
    return Pass(variant, stage, {format}, pack(), platformOf(setting));
}

Pass historyPass(const Setting& setting, Stage stage, bool closest, std::string_view motion = "vectors") {
    const Variant variant =
        variantOf(pack(), "temporal_aa",
                  {{"CONSTRAINT", "none"},
                   {"UNJITTER", "off"},
                   {"MOTION_BLUR_FALLBACK", "off"},
                   {"MOTION", motion},
                   {"CLOSEST_FRAGMENT", closest ? "on" : "off"},
                   {"DEPTH_REVERSED", setting.kind.depth == Depth::standard ? "off" : "on"}});
    return Pass(variant, stage, {rgba32f}, pack(), platformOf(setting));
}

std::vector<Setting> settings() {
    std::vector<Setting> all;
    for (const CameraKind& kind : cameraKinds)
        for (const bool sharesY : {false, true})
            for (const bool jittered : {false, true})
                all.push_back({kind, sharesY, jittered});
    return all;
}

class ConventionMatrix : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, ConventionMatrix, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

double largestMotionPx(const Truth& truth) {
    double largest = 0.0;
    for (const glm::dvec2 motion : truth.motion)
        largest = std::max(largest, glm::length(motion * extent));
    return largest;
}

TEST_P(ConventionMatrix, motionIsThatOfRayCasting) {
    for (const Setting& setting : settings()) {
        const Truth truth(setting);
        EXPECT_GT(largestMotionPx(truth), 3.0); // else the signs would hardly matter
        for (const bool depthLinear : {false, true}) {
            for (const VkFormat format : {rg32f, rg16f}) {
                const CameraCase frame = caseOf(setting, truth, depthLinear);
                Pass pass = velocityPass(setting, GetParam(), depthLinear, format);
                const Comparison result = compare(
                    run(pass, frame)[0],
                    [&](int x, int y, bool) {
                        return Expected{{truth.motion[truth.index(x, y)], 0.0},
                                        {motionBoundPx / extent, 0.0}};
                    },
                    2);
                EXPECT_TRUE(result.holds()) << stageText(GetParam()) << ", " << text(setting)
                                            << (depthLinear ? ", linear depth: " : ": ") << text(result);
            }
        }
    }
}

// --- History

constexpr float historyWeight = 1.0f - 0x1p-6f;

struct MotionForm {
    std::string_view name;
    float toUv[2]; // gMotionToUv: what the stored motion is multiplied by
};
constexpr MotionForm forms[] = {{"curr - prev", {1.0f, 1.0f}},
                                {"prev - curr", {-1.0f, -1.0f}},
                                {"NDC", {0.5f, -0.5f}},
                                {"-NDC", {-0.5f, 0.5f}},
                                {"pixels", {1.0f / width, 1.0f / height}}};

TemporalAaFrame frameOf(const CameraCase& camera, const Pixels& velocity, const MotionForm& form) {
    TemporalAaFrame frame;
    frame.depth = camera.depth;
    frame.velocity = velocity;
    for (size_t i = 0; i < velocity.values.size(); ++i)
        frame.velocity.values[i] /= form.toUv[i % 2];
    frame.colour = makePixels(rgba16f, width, height, [](int x, int y) {
        return Texel{(x + y) % 2 == 0 ? 1.0f : 0.0f, 0.5f, 0.0f, 1.0f};
    });
    frame.parameters = parametersFor(width, height);
    frame.parameters.gFeedbackMax = historyWeight;
    for (int i = 0; i < 2; ++i) {
        frame.parameters.gMotionToUv[i] = form.toUv[i];
        frame.parameters.gJitterPx[i] = static_cast<float>(camera.pass.jitterPx[i]);
    }
    std::ranges::copy(camera.parameters.gReprojection, frame.parameters.gReprojection);
    return frame;
}

// The motion of the pixel whose surface is the closest of the 3x3, by ray casting.
glm::dvec2 closestMotion(const Truth& truth, int x, int y) {
    size_t closest = truth.index(x, y);
    for (int i = 0; i < 9; ++i) {
        const size_t other = truth.index(x + i % 3 - 1, y + i / 3 - 1);
        if (truth.hits[other].linearDepth < truth.hits[closest].linearDepth) closest = other;
    }
    return truth.motion[closest];
}

double distanceToEdgePx(glm::dvec2 uv) {
    const glm::dvec2 toEdge = (0.5 - glm::abs(uv - 0.5)) * extent;
    return std::min(toEdge.x, toEdge.y);
}

// History of black and white noise: a fetch that is off by a tenth of a texel differs by up to a tenth.
Expected expectedOf(const Truth& truth, const TemporalAaFrame& frame, const oracle::Image& history, int x,
                    int y) {
    const glm::dvec2 uv = glm::dvec2(x + 0.5, y + 0.5) / extent - closestMotion(truth, x, y);
    glm::dvec3 colour(frame.colour.at(x, y, 0), frame.colour.at(x, y, 1), frame.colour.at(x, y, 2));
    const double edge = distanceToEdgePx(uv);
    if (std::abs(edge) < 2.0 * motionBoundPx) return {colour, glm::dvec3(1.0)}; // in or out, either is right
    if (edge > 0.0)
        colour = glm::mix(colour, glm::dvec3(oracle::sampleLinear(history, uv)), double{historyWeight});
    return {colour, glm::dvec3(2.0 * motionBoundPx)}; // in x and in y
}

TEST_P(ConventionMatrix, historyIsFetchedWhereTheClosestSurfaceWas) {
    const Pixels noise = makePixels(rgba16f, width, height, [](int x, int y) {
        Texel texel{};
        for (size_t c = 0; c < 3; ++c)
            texel[c] =
                unitHash(41, static_cast<uint64_t>(x), static_cast<uint64_t>(y), c) < 0.5 ? 0.0f : 1.0f;
        return texel;
    });
    const oracle::Image history = oracleImage(noise);
    for (const Setting& setting : settings()) {
        const Truth truth(setting);
        const CameraCase camera = caseOf(setting, truth, false);
        Pass velocity = velocityPass(setting, GetParam(), false, rg32f);
        Pass pass = historyPass(setting, GetParam(), true);
        Pass reprojecting = historyPass(setting, GetParam(), true, "camera");
        const Pixels motion = run(velocity, camera)[0];
        const auto expectHistory = [&](Pass& from, const MotionForm& form) {
            TemporalAaFrame frame = frameOf(camera, motion, form);
            frame.history = noise;
            const Comparison result = compare(
                run(from, frame)[0],
                [&](int x, int y, bool) { return expectedOf(truth, frame, history, x, y); }, 3);
            EXPECT_TRUE(result.holds()) << stageText(GetParam()) << ", " << text(setting) << ", motion "
                                        << form.name << ": " << text(result);
        };
        for (const MotionForm& form : forms)
            expectHistory(pass, form);
        expectHistory(reprojecting, {"of its own", {0.0f, 0.0f}});
    }
}

// A colour that is smooth over the surfaces, within [0, 1] and of a slope of 1/50 to 1/15 a pixel.
glm::dvec3 paint(glm::dvec3 world) {
    return 0.5 + 0.5 * glm::sin(world * glm::dvec3(0.22, 0.27, 0.18));
}

// The loop closed without any motion of the test's own: history is the previous camera's rendering, and what
// comes back is the paint of the surface at the unjittered pixel centre. A jittered pixel shows its surface
// up to half a pixel away, whose motion differs by the perspective there; with the curvature that linear
// filtering does not follow it stays below 1/100. A wrong sign or scale is off by several pixels: by 1/15 and
// more.
TEST_P(ConventionMatrix, reprojectedHistoryShowsTheSameSurface) {
    for (const Setting& setting : settings()) {
        const Truth truth(setting);
        const CameraCase camera = caseOf(setting, truth, false);
        Pass velocity = velocityPass(setting, GetParam(), false, rg16f);
        Pass pass = historyPass(setting, GetParam(), false);
        TemporalAaFrame frame = frameOf(camera, run(velocity, camera)[0], forms[0]);
        frame.history = makePixels(rgba16f, width, height, [&](int x, int y) {
            const glm::dvec3 colour =
                paint(castRay(truth.previous, glm::dvec2(x + 0.5, y + 0.5), extent).world);
            return Texel{static_cast<float>(colour.r), static_cast<float>(colour.g),
                         static_cast<float>(colour.b)};
        });
        PlanesView centred = truth.current;
        centred.jitterPx = {0.0, 0.0};
        size_t seen = 0;
        const auto expectedAt = [&](int x, int y, bool) {
            const Hit hit = castRay(centred, glm::dvec2(x + 0.5, y + 0.5), extent);
            const glm::dvec2 before = uvOf(truth.previous, hit.world) * extent;
            // The surface must have been in the image, and itself on all texels that the fetch blends.
            bool visible = distanceToEdgePx(before / extent) > 2.0;
            for (int i = 0; i < 9; ++i) {
                const glm::dvec2 place = before + glm::dvec2(i % 3 - 1, i / 3 - 1) * 1.5;
                const Hit other = castRay(truth.previous, place, extent);
                visible = visible && other.surface == hit.surface;
                visible =
                    visible && truth.hits[truth.index(x + i % 3 - 1, y + i / 3 - 1)].surface == hit.surface;
            }
            if (!visible) return Expected{glm::dvec3(0.0), glm::dvec3(1e9)};
            ++seen;
            const glm::dvec3 current(frame.colour.at(x, y, 0), frame.colour.at(x, y, 1),
                                     frame.colour.at(x, y, 2));
            return Expected{glm::mix(current, paint(hit.world), double{historyWeight}), glm::dvec3(0.01)};
        };
        const Comparison result = compare(run(pass, frame)[0], expectedAt, 3);
        EXPECT_TRUE(result.holds()) << stageText(GetParam()) << ", " << text(setting) << ": " << text(result);
        EXPECT_GT(seen, size_t{width * height / 3}) << text(setting);
    }
}

} // namespace
} // namespace passes
