// SPDX-License-Identifier: Apache-2.0
// The ray caster and the scene renderer see the same scene, and the pass ambient_occlusion converges to what
// rays say where the screen knows all that occludes; what scalable_obscurance converges to is what it
// records.
#include "builtin.hpp"
#include "converged.hpp"
#include "truth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace report;

harness::Gpu& gpu() {
    static harness::Gpu instance{harness::DeviceOptions{.device = "", .validation = true}};
    return instance;
}

Shaders& shaders() {
    static Shaders instance(findAssets());
    return instance;
}

scenes::Scene sceneNamed(const std::string& name) {
    for (scenes::Scene& scene : scenes::allScenes())
        if (scene.name == name) return scene;
    throw std::runtime_error("There is no scene " + name);
}

RenderedFrame rendered(const scenes::Scene& scene, int frame, PixelGrid grid) {
    scenes::Renderer renderer(gpu(), scene, grid.width, grid.height);
    return renderFrames(gpu(), renderer, uint32_t(frame), 1, reprise::JitterSequence::none).front();
}

TEST(RayTruth, seesTheDepthThatTheRendererDraws) {
    // Skins, objects that moved, alpha-tested leaves, thin bars. Outlines differ, for vertices are snapped to
    // 1/256 of a pixel: by 3 texels of 100000. Far leaves are tested at another mip: 23 % of foliage differ
    // at 160x90, 15 % at 640x360, 9 % at 1280x720.
    const std::tuple<const char*, int, PixelGrid, double> cases[] = {{"hall_moving", 9, {640, 360}, 2e-4},
                                                                     {"hall_fast_pan", 20, {640, 360}, 2e-4},
                                                                     {"fast_object", 7, {640, 360}, 2e-4},
                                                                     {"foliage", 5, {1280, 720}, 0.12}};
    for (const auto& [name, frame, grid, outlines] : cases) {
        const scenes::Scene scene = sceneNamed(name);
        RenderedFrame image = rendered(scene, frame, grid);
        const std::vector<float> device = gpu().downloadFloats(image.depth);
        const glm::dvec2 coefficients = reprise::linearDepthCoefficients(image.camera.viewToClip);
        RayTruth truth(scene);
        const std::vector<float> cast = truth.linearDepth(frame, grid);
        size_t differ = 0, sky = 0;
        for (size_t i = 0; i < cast.size(); ++i) {
            const bool isSky = device[i] >= 1.0f;
            sky += isSky ? 1 : 0;
            const double drawn = 1.0 / (double(device[i]) * coefficients.x + coefficients.y);
            // Device depth keeps 2^-24 of a metre's inverse over the near plane, as much as 4e-4 of 60 m; a
            // plane seen at a small angle is off by the snapping.
            const bool agrees =
                isSky ? cast[i] == skyLinearDepth : std::abs(cast[i] - drawn) < 0.003 * drawn + 1e-3;
            differ += agrees ? 0 : 1;
        }
        EXPECT_LT(double(differ) / double(cast.size()), outlines) << name;
        EXPECT_TRUE(sky > 50 || std::string(name) == "fast_object") << name;
    }
}

// A floor and two walls that meet in the middle of the picture, and nothing else.
scenes::Scene corner() {
    scenes::Scene scene;
    scene.cameraMoves = false;
    const uint32_t grey = scenes::build::addMaterial(scene, {});
    const uint32_t slab = scenes::build::addMesh(scene, scenes::build::box({40, 40, 40}));
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 centre(0.0);
        centre[axis] = -20.0;
        scenes::build::addInstance(scene, slab, grey,
                                   glm::translate(glm::dmat4(1.0), centre + glm::dvec3(0.0)));
    }
    scene.worldToView = [](double) { return scenes::lookAt({4, 3.5, 4.2}, {0.4, 0.4, 0.4}); };
    scene.farPlane = 100.0;
    return scene;
}

// Mean and root mean square of estimate - truth over the middle of the picture, where the radius stays
// inside.
glm::dvec2 errorInTheMiddle(const std::vector<float>& truth, const std::vector<float>& estimate,
                            PixelGrid grid) {
    double sum = 0.0, squares = 0.0;
    size_t count = 0;
    for (uint32_t y = grid.height / 4; y < grid.height * 3 / 4; ++y)
        for (uint32_t x = grid.width / 4; x < grid.width * 3 / 4; ++x) {
            const size_t i = size_t{y} * grid.width + x;
            const double error = double(estimate[i]) - truth[i];
            sum += error;
            squares += error * error;
            ++count;
        }
    return {sum / double(count), std::sqrt(squares / double(count))};
}

TEST(ConvergedOcclusion, isTheGroundTruthWhereTheScreenKnowsAllOccluders) {
    const scenes::Scene scene = corner();
    constexpr PixelGrid grid{129, 73}; // odd: a coarse image reaches beyond it
    constexpr double radius = 0.8;
    RenderedFrame frame = rendered(scene, 0, grid);
    RayTruth truth(scene);
    for (const uint32_t ratio : {1u, 2u, 4u}) {
        for (const reprise::Stage stage : {reprise::Stage::fragment, reprise::Stage::compute}) {
            const Converged converged = convergedOcclusion(gpu(), shaders(), frame,
                                                           {.ratio = ratio,
                                                            .radius = radius,
                                                            .bias = {0.001, 0.0005},
                                                            .skyDepth = 99.0,
                                                            .stage = stage});
            const PixelGrid own{converged.width, converged.height};
            const auto cast = truth.occlusion(0, {grid.width, grid.height, ratio},
                                              {.radius = radius, .rays = 256, .falloff = Falloff::quadratic});
            ASSERT_EQ(cast.size(), converged.visibility.size());
            ASSERT_EQ(cast.size(), size_t{own.width} * own.height);
            const glm::dvec2 error = errorInTheMiddle(cast, converged.visibility, own);
            // A pixel is 8 cm wide there, a tenth of the radius. The root mean square is that of the texels
            // along the room's edges, whose normal or place is another wall's: they are a texel wide, and off
            // by a part of its width; measured 0.021, 0.042, 0.078. Errors to both sides all but cancel in
            // the mean, measured 0.0034 to 0.0088; without the falloff it is 0.044.
            EXPECT_LT(std::abs(error.x), 0.004 + 0.0015 * ratio) << "ratio " << ratio;
            EXPECT_LT(error.y, 0.022 * ratio) << "ratio " << ratio;
        }
    }
    EXPECT_EQ(gpu().takeValidationMessages(), std::vector<std::string>{});
}

TEST(CoarseViewRay, meetsTheFramesRayAtTheTexelsCentre) {
    const reprise::CameraFrame camera{
        glm::dmat4(1.0), scenes::perspective(0.9, 11.0 / 9.0, 0.1, 50.0, scenes::DepthKind::standard)};
    const glm::dvec4 whole = reprise::viewRay(camera.viewToClip);
    for (const uint32_t ratio : {1u, 2u, 4u}) {
        const glm::dvec4 coarse = coarseViewRay(camera, {11, 9}, ratio);
        const glm::dvec2 texels((11 + ratio - 1) / ratio, (9 + ratio - 1) / ratio);
        const glm::dvec2 centre = (glm::dvec2(1.0, 0.0) + 0.5) / texels; // of texel (1, 0)
        const glm::dvec2 centrePx = (glm::dvec2(1.0, 0.0) + 0.5) * double(ratio);
        const glm::dvec2 expected = glm::dvec2(whole) * centrePx / glm::dvec2(11.0, 9.0);
        EXPECT_NEAR(glm::length(glm::dvec2(coarse) * centre - expected), 0.0, 1e-12);
        EXPECT_EQ(glm::dvec2(coarse.z, coarse.w), glm::dvec2(whole.z, whole.w));
    }
}

TEST(ConvergedOcclusion, refusesWhatHasNoMeaning) {
    const scenes::Scene scene = corner();
    RenderedFrame frame = rendered(scene, 0, {16, 9});
    EXPECT_THROW(convergedOcclusion(gpu(), shaders(), frame, {.ratio = 3, .skyDepth = 99.0}),
                 std::runtime_error);
    EXPECT_THROW(convergedOcclusion(gpu(), shaders(), frame, {.radius = -1.0, .skyDepth = 99.0}),
                 std::runtime_error);
    EXPECT_THROW(convergedOcclusion(gpu(), shaders(), frame, {}), std::runtime_error);
    EXPECT_THROW(convergedObscurance(gpu(), shaders(), frame, {}), std::runtime_error);
    EXPECT_THROW(convergedObscurance(gpu(), shaders(), frame, {.radius = -1.0, .skyDepth = 99.0}),
                 std::runtime_error);
}

// Mean of 16 frames of the runtime's own plan of 33 taps: 16 rotations, no history, no filter.
std::vector<double> meanOfRecordedRotations(RenderedFrame& frame, PixelGrid grid, reprise::Stage stage,
                                            float intensity) {
    reprise::SceneNeeds needs;
    needs.antiAliasing = needs.cameraMoves = needs.objectsMove = false;
    needs.ambientOcclusion = true;
    const reprise::CacheSettings cache{
        .occlusion = "scalable_obscurance", .samples = 33, .history = false, .filter = false};
    auto recorder = reprise::FrameRecorder::create(
        gpu().device(), shaders().pack().passes(), shaders().source(),
        {.needs = needs, .settings = {.stage = stage, .cache = cache}, .extent = {grid.width, grid.height}});
    if (!recorder) throw std::runtime_error(recorder.error().message);
    reprise::FrameInput input;
    input.camera = frame.camera;
    input.depth = frame.depth.ref;
    input.cache.radius = 0.8f;
    input.cache.obscurance.rotations = 16;
    input.cache.obscurance.intensity = intensity;
    std::vector<double> mean(size_t{grid.width} * grid.height);
    for (input.frameIndex = 0; input.frameIndex < 16; ++input.frameIndex) {
        reprise::ImageRef lighting;
        gpu().run([&](VkCommandBuffer commands) {
            auto recorded = recorder->record(commands, input);
            if (!recorded) throw std::runtime_error(recorded.error().message);
            lighting = recorded->lighting.value();
        });
        harness::Image image = borrowed(lighting);
        const auto texels = gpu().downloadFloats(image);
        for (size_t i = 0; i < mean.size(); ++i)
            mean[i] += double{texels[4 * i]} / 16.0;
    }
    return mean;
}

// The estimator is what the runtime's frames average to, stopping at black after the mean and not in each
// frame, so that a distance to it is of sampling alone. Frames of a third of the intensity are never black.
// 1e-5: both have the same levels of red, and differ by roundings of the sum, times 12 at most. A radius that
// is 1 % off, a bias of its own, or a rotation left out changes some of them.
TEST(ConvergedObscurance, isTheMeanOfTheRuntimesRotations) {
    constexpr PixelGrid grid{129, 73};
    RenderedFrame frame = rendered(corner(), 0, grid);
    for (const reprise::Stage stage : {reprise::Stage::fragment, reprise::Stage::compute}) {
        const auto third = meanOfRecordedRotations(frame, grid, stage, 1.0f / 3.0f);
        ObscuranceEstimate estimate{.radius = 0.8, .skyDepth = 99.0, .stage = stage};
        const auto farthest = [&](const auto& expected) {
            const Converged converged = convergedObscurance(gpu(), shaders(), frame, estimate);
            EXPECT_EQ(third.size(), converged.visibility.size());
            double most = 0.0;
            for (size_t i = 0; i < third.size(); ++i)
                most = std::max(most, std::abs(expected(i) - double{converged.visibility[i]}));
            return most;
        };
        const auto blackAfterTheMean = [&](size_t i) {
            return std::clamp(1.0 - estimate.intensity * 3.0 * (1.0 - third[i]), 0.0, 1.0);
        };
        EXPECT_LT(farthest(blackAfterTheMean), 1e-5);
        estimate.radius *= 1.01;
        EXPECT_GT(farthest(blackAfterTheMean), 1e-3);
        estimate.radius = 0.8;
        estimate.intensity = 4.0; // many a frame is black
        EXPECT_LT(farthest(blackAfterTheMean), 1e-5);
        const auto ofBlackFrames = meanOfRecordedRotations(frame, grid, stage, 4.0f);
        EXPECT_GT(farthest([&](size_t i) { return ofBlackFrames[i]; }), 0.03);
    }
    EXPECT_EQ(gpu().takeValidationMessages(), std::vector<std::string>{});
}

} // namespace
