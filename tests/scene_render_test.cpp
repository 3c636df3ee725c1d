// SPDX-License-Identifier: Apache-2.0
// What the scene renderer writes beside colour, against the scene's own matrices in double precision.
#include "renderer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace {

using scenes::DepthKind;
using scenes::Scene;

constexpr uint32_t width = 160, height = 90;
constexpr double aspect = double(width) / height;

harness::Gpu& gpu() {
    static harness::Gpu instance{harness::DeviceOptions{.device = "", .validation = true}};
    return instance;
}

Scene sceneNamed(const std::string& name) {
    for (Scene& scene : scenes::builtInScenes())
        if (scene.name == name) return scene;
    throw std::runtime_error("There is no scene " + name + ".");
}

struct Picture {
    std::vector<float> colour, depth, normal, motion;
    std::vector<glm::uvec2> ids;
};

Picture render(scenes::Renderer& renderer, int frame, glm::dvec2 jitterPx = {0.0, 0.0}) {
    scenes::FrameTargets targets = renderer.targets();
    gpu().run([&](VkCommandBuffer commands) { renderer.render(commands, frame, jitterPx, targets); });
    Picture picture{gpu().downloadFloats(targets.colour),
                    gpu().downloadFloats(targets.depth),
                    gpu().downloadFloats(targets.normal),
                    gpu().downloadFloats(targets.motion),
                    {}};
    const std::vector<std::byte> ids = gpu().download(targets.ids);
    picture.ids.resize(ids.size() / sizeof(glm::uvec2));
    std::memcpy(picture.ids.data(), ids.data(), ids.size());
    return picture;
}

glm::dvec2 centre(size_t pixel) {
    return {double(pixel % width) + 0.5, double(pixel / width) + 0.5};
}

// World position of what a pixel shows, from its device depth.
glm::dvec3 worldAt(const reprise::CameraFrame& camera, glm::dvec2 unjitteredPx, double depth) {
    const glm::dvec4 clip(unjitteredPx.x / width * 2.0 - 1.0, 1.0 - unjitteredPx.y / height * 2.0, depth,
                          1.0);
    const glm::dvec4 world = glm::inverse(camera.viewToClip * camera.worldToView) * clip;
    return glm::dvec3(world) / world.w;
}

glm::dvec2 pixelOf(const reprise::CameraFrame& camera, glm::dvec4 world) {
    const glm::dvec4 clip = camera.viewToClip * camera.worldToView * world;
    return {(clip.x / clip.w * 0.5 + 0.5) * width, (0.5 - clip.y / clip.w * 0.5) * height};
}

glm::dvec2 motionPx(const Picture& picture, size_t pixel) {
    return {picture.motion[pixel * 2] * double(width), picture.motion[pixel * 2 + 1] * double(height)};
}

// binary16 keeps 11 bits: half a unit of its last place at this length. Rasterizers snap vertices to 1/256
// px, which moves both the depth and the interpolated previous position by as much.
double motionBound(glm::dvec2 px) {
    return 2.0 / 256.0 + glm::length(px) / 2048.0;
}

TEST(SceneMotion, isAnalyticReprojectionWhereNothingButTheCameraMoves) {
    for (const DepthKind kind : {DepthKind::standard, DepthKind::reversed, DepthKind::reversedInfinite}) {
        const Scene scene = sceneNamed("camera_cut");
        scenes::Renderer renderer(gpu(), scene, width, height, kind);
        const glm::dvec2 jitter(0.3, -0.2);
        const Picture picture = render(renderer, 7, jitter);
        const auto now = scenes::cameraAt(scene, 7, aspect, kind),
                   before = scenes::cameraAt(scene, 6, aspect, kind);
        size_t compared = 0;
        for (size_t i = 0; i < picture.ids.size(); ++i) {
            if (picture.ids[i].x == 0) continue;
            const glm::dvec2 at = centre(i) - jitter;
            const glm::dvec3 world = worldAt(now, at, picture.depth[i]);
            // Beyond 60 m a step of depth in single precision is metres wide, and motion there is tested as
            // the sky's.
            if (glm::length(world) > 60.0) continue;
            const glm::dvec2 expected = at - pixelOf(before, glm::dvec4(world, 1.0));
            ASSERT_LT(glm::length(motionPx(picture, i) - expected), motionBound(expected))
                << "pixel " << i % width << "," << i / width << " depth kind " << int(kind);
            ++compared;
        }
        EXPECT_GT(compared, size_t(width) * height / 4);
    }
}

TEST(SceneMotion, ofTheSkyIsTheRotationOfTheCamera) {
    const Scene scene = sceneNamed("thin_geometry");
    scenes::Renderer renderer(gpu(), scene, width, height);
    const Picture picture = render(renderer, 9);
    auto now = scenes::cameraAt(scene, 9, aspect), before = scenes::cameraAt(scene, 8, aspect);
    size_t compared = 0;
    for (size_t i = 0; i < picture.ids.size(); ++i) {
        if (picture.ids[i].x != 0) continue;
        EXPECT_EQ(picture.depth[i], 1.0f);
        const glm::dvec3 eye(glm::inverse(now.worldToView)[3]);
        const glm::dvec3 direction = worldAt(now, centre(i), 0.5) - eye;
        const glm::dvec2 expected = centre(i) - pixelOf(before, glm::dvec4(direction, 0.0));
        ASSERT_LT(glm::length(motionPx(picture, i) - expected), motionBound(expected));
        EXPECT_GT(glm::length(expected), 0.05)
            << "the pan does not move the sky: the test would prove nothing";
        ++compared;
    }
    EXPECT_GT(compared, size_t(width) * height / 8);
}

TEST(SceneMotion, followsRigidObjects) {
    const Scene scene = sceneNamed("fast_object");
    scenes::Renderer renderer(gpu(), scene, width, height);
    const Picture picture = render(renderer, 5);
    const auto camera = scenes::cameraAt(scene, 5, aspect);
    size_t compared = 0;
    double fastest = 0.0;
    for (size_t i = 0; i < picture.ids.size(); ++i) {
        if (picture.ids[i].x == 0) continue;
        const auto& instance = scene.instances.at(picture.ids[i].x - 1);
        if (!instance.moves || instance.palette) continue;
        const glm::dvec4 world(worldAt(camera, centre(i), picture.depth[i]), 1.0);
        const glm::dvec4 object = glm::inverse(instance.objectToWorld(5 / 60.0)) * world;
        const glm::dvec2 expected = centre(i) - pixelOf(camera, instance.objectToWorld(4 / 60.0) * object);
        ASSERT_LT(glm::length(motionPx(picture, i) - expected), motionBound(expected))
            << "instance " << instance.id;
        fastest = std::max(fastest, glm::length(expected));
        ++compared;
    }
    EXPECT_GT(compared, 200u);
    EXPECT_GT(fastest, 2.0); // a quarter of 8 px: this picture is a quarter as wide as 640
}

// The skinned column's own texels come from its own texels: its motion leads from frame to frame.
TEST(SceneMotion, ofTheSkinnedMeshLeadsToWhereItWas) {
    const Scene scene = sceneNamed("fast_object");
    const auto column = std::find_if(scene.instances.begin(), scene.instances.end(),
                                     [](const auto& i) { return bool(i.palette); });
    ASSERT_NE(column, scene.instances.end());
    scenes::Renderer renderer(gpu(), scene, width, height);
    const Picture before = render(renderer, 11), now = render(renderer, 12);
    size_t seen = 0, same = 0, moved = 0;
    for (size_t i = 0; i < now.ids.size(); ++i) {
        if (now.ids[i].x != column->id + 1) continue;
        const glm::dvec2 motion = motionPx(now, i), from = centre(i) - motion;
        const auto x = size_t(std::clamp(from.x, 0.0, width - 1.0)),
                   y = size_t(std::clamp(from.y, 0.0, height - 1.0));
        ++seen;
        same += before.ids[y * width + x].x == column->id + 1;
        moved += glm::length(motion) > 0.25;
    }
    EXPECT_GT(seen, 100u);
    EXPECT_GT(double(same), 0.9 * double(seen)) << "edges may differ by a pixel, no more";
    EXPECT_GT(moved, seen / 4);
}

TEST(SceneJitter, movesThePictureByItsPixels) {
    const Scene scene = sceneNamed("static_camera");
    scenes::Renderer renderer(gpu(), scene, width, height);
    const auto camera = scenes::cameraAt(scene, 0, aspect);
    for (const glm::dvec2 jitter : {glm::dvec2(0.0, 0.0), glm::dvec2(0.4, 0.1), glm::dvec2(-0.3, -0.45)}) {
        const Picture picture = render(renderer, 0, jitter);
        size_t floors = 0;
        for (size_t i = 0; i < picture.ids.size(); ++i) {
            if (picture.ids[i].x != 1) continue; // the floor is the first instance; y = 0
            const glm::dvec3 world = worldAt(camera, centre(i) - jitter, picture.depth[i]);
            if (glm::length(world) > 15.0) continue;
            // A pixel of the lower half spans centimetres of floor: 0.05 px off in jitter is millimetres in
            // height.
            ASSERT_NEAR(world.y, 0.0, 5e-4) << "pixel " << i;
            ++floors;
        }
        EXPECT_GT(floors, 1000u);
    }
}

TEST(SceneIds, stayFromFrameToFrameAndAreZeroInTheSky) {
    const Scene scene = sceneNamed("static_camera");
    scenes::Renderer renderer(gpu(), scene, width, height);
    const Picture first = render(renderer, 3), second = render(renderer, 4);
    EXPECT_EQ(first.ids, second.ids);
    EXPECT_EQ(first.colour, second.colour);
    std::set<uint32_t> seen;
    for (size_t i = 0; i < first.ids.size(); ++i) {
        seen.insert(first.ids[i].x);
        EXPECT_EQ(first.ids[i].x == 0, first.depth[i] == 1.0f);
        EXPECT_EQ(first.ids[i].x == 0, first.ids[i].y == 0);
    }
    EXPECT_GT(seen.size(), 10u);
    EXPECT_TRUE(seen.contains(0));
}

TEST(SceneDepth, isTheSameDistanceInEveryKind) {
    const Scene scene = sceneNamed("static_camera");
    std::vector<std::vector<double>> distances;
    for (const DepthKind kind : {DepthKind::standard, DepthKind::reversed, DepthKind::reversedInfinite}) {
        scenes::Renderer renderer(gpu(), scene, width, height, kind);
        const Picture picture = render(renderer, 0);
        const auto camera = scenes::cameraAt(scene, 0, aspect, kind);
        const glm::dvec2 linear = reprise::linearDepthCoefficients(camera.viewToClip);
        distances.emplace_back();
        for (size_t i = 0; i < picture.ids.size(); ++i)
            distances.back().push_back(
                picture.ids[i].x == 0 ? 0.0 : 1.0 / (picture.depth[i] * linear.x + linear.y));
    }
    size_t different = 0;
    for (size_t i = 0; i < distances[0].size(); ++i) {
        // A step of standard depth is z² / near metres a unit. Rasterizers interpolate it from a plane
        // equation in single precision, good to some units of 2^-24 of its largest value: 2^-19 has room, and
        // is 0.5 mm at 5 m.
        const double bound = distances[0][i] * distances[0][i] / scene.nearPlane * 0x1p-18;
        for (size_t kind : {1, 2})
            different += std::abs(distances[kind][i] - distances[0][i]) > bound;
    }
    // Where two surfaces meet within a rounding of coverage a pixel may show the other one.
    EXPECT_LE(different, 4u);
}

TEST(GroundTruth, convergesAndIsDisplayReferred) {
    scenes::Renderer renderer(gpu(), sceneNamed("hdr_emitters"), width, height);
    const std::vector<float> coarse = renderer.groundTruth(4, 64), fine = renderer.groundTruth(4, 256);
    ASSERT_EQ(coarse.size(), size_t(width) * height * 3);
    double sum = 0.0, brightest = 0.0;
    for (size_t i = 0; i < coarse.size(); ++i) {
        ASSERT_TRUE(coarse[i] >= 0.0f && coarse[i] <= 1.0f);
        sum += std::pow(double(coarse[i]) - fine[i], 2.0);
        brightest = std::max(brightest, double(coarse[i]));
    }
    // 64 stratified points leave an edge's coverage wrong by up to about 1/64, on the share of pixels with
    // edges.
    EXPECT_LT(std::sqrt(sum / double(coarse.size())), 0.006);
    EXPECT_GT(brightest, 0.9);
}

TEST(GroundTruth, isTheMeanOfItsRenderingsWhereThereIsNoTexture) {
    Scene scene = sceneNamed("static_camera");
    for (auto& material : scene.materials)
        material.texture = -1; // renderings differ from it in the bias of mipmaps
    scenes::Renderer renderer(gpu(), scene, width, height);
    const std::vector<float> truth = renderer.groundTruth(0, 64);
    std::vector<double> mean(truth.size());
    constexpr int side = 8;
    for (int n = 0; n < side * side; ++n) {
        const Picture picture =
            render(renderer, 0, {(n % side + 0.5) / side - 0.5, (n / side + 0.5) / side - 0.5});
        for (size_t i = 0; i < truth.size(); ++i)
            mean[i] += scenes::displayColour(picture.colour[i / 3 * 4 + i % 3]) / (side * side);
    }
    double sum = 0.0;
    for (size_t i = 0; i < truth.size(); ++i)
        sum += std::pow(mean[i] - truth[i], 2.0);
    // Two different sets of 64 points, each off by up to 1/64 at edges.
    EXPECT_LT(std::sqrt(sum / double(truth.size())), 0.008);
}

TEST(SceneRenderer, drawsEverySceneWithoutAWordFromValidation) {
    gpu().takeValidationMessages();
    std::vector<Scene> all = scenes::builtInScenes();
    for (const char* file :
         {"glTF2/simple_skin/simple_skin.gltf", "glTF2/BoxTextured-glTF/BoxTextured.gltf"}) {
        auto loaded = scenes::loadScene(std::filesystem::path("/usr/share/assimp/models") / file);
        ASSERT_TRUE(loaded) << loaded.error().message;
        all.push_back(std::move(*loaded));
    }
    for (const Scene& scene : all) {
        scenes::Renderer renderer(gpu(), scene, 65, 33);
        scenes::FrameTargets targets = renderer.targets();
        gpu().run([&](VkCommandBuffer commands) {
            for (int frame = 0; frame < 3; ++frame)
                renderer.render(commands, frame, {0.1, -0.2}, targets);
        });
        for (float value : gpu().downloadFloats(targets.colour))
            ASSERT_TRUE(std::isfinite(value)) << scene.name;
        for (float value : gpu().downloadFloats(targets.motion))
            ASSERT_TRUE(std::isfinite(value)) << scene.name;
        renderer.movingObjects(2);
        renderer.groundTruth(1, 64);
    }
    for (const std::string& message : gpu().takeValidationMessages())
        ADD_FAILURE() << message;
}

} // namespace
