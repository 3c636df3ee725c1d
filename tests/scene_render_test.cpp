// SPDX-License-Identifier: Apache-2.0
// What the scene renderer writes beside colour, against the scene's own matrices in double precision.
#include "frame_data.hpp"
#include "renderer.hpp"

#include "reprise/pack_table.hpp"

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

// --- The pass sun_shadow, fed with the renderer's shadow map

enum class Sun { unknown, lit, shadowed };

// A rendered frame and what sunVisibility of scene.hlsl says of it.
struct SunFrame {
    reprise::CameraFrame camera;
    scenes::ShadowMap map;
    std::vector<float> texels, depth; // of the shadow map; linear depth in metres
    std::vector<glm::dvec3> normal;
    std::vector<size_t> cascade; // as many as there are: beyond the last, or sky
    std::vector<Sun> sun;
};

// One comparison of the point, moved along its normal.
bool isLit(const SunFrame& frame, size_t cascade, glm::dvec3 world, glm::dvec3 normal) {
    const glm::dvec3 receiver = world + normal * frame.map.texelMetres[cascade] * 1.8;
    const glm::dvec3 light(frame.map.cascades[cascade].worldToClip * glm::dvec4(receiver, 1.0));
    const auto side = int(frame.map.image->ref.extent.height);
    const int x = std::clamp(int((light.x * 0.5 + 0.5) * side), 0, side - 1),
              y = std::clamp(int((0.5 - light.y * 0.5) * side), 0, side - 1);
    const size_t row = size_t(y) * frame.map.image->ref.extent.width;
    return frame.texels[row + cascade * size_t(side) + size_t(x)] >= light.z;
}

// Lit or shadowed is what is so on all of the surface's plane around the point, as far as the pass's disc and
// the offsets of both reach: where no penumbra is. Surfaces that the sun hardly meets are unknown.
Sun hardSun(const SunFrame& frame, size_t cascade, glm::dvec3 world, glm::dvec3 normal, glm::dvec3 sun) {
    const double cosine = glm::dot(normal, sun), texel = frame.map.texelMetres[cascade];
    if (cosine < 0.2) return Sun::unknown;
    const double metres = reprise::SunShadowTuning{}.radius / cosine + 4.0 * texel;
    const glm::dvec3 other = std::abs(normal.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(normal, other)), along = glm::cross(normal, across);
    // Two points a texel, so that none between them is passed over.
    const int reach = int(std::ceil(2.0 * metres / texel)), points = 2 * reach + 1;
    int lit = 0;
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j) {
            const glm::dvec3 way = (across * double(i) + along * double(j)) * (metres / reach);
            lit += isLit(frame, cascade, world + way, normal);
        }
    return lit == 0 ? Sun::shadowed : lit == points * points ? Sun::lit : Sun::unknown;
}

SunFrame sunFrame(scenes::Renderer& renderer, int index) {
    const Picture picture = render(renderer, index);
    SunFrame frame{
        scenes::cameraAt(renderer.scene(), index, aspect), renderer.shadowMap(index), {}, {}, {}, {}, {}};
    frame.texels = gpu().downloadFloats(*frame.map.image);
    const glm::dvec2 linear = reprise::linearDepthCoefficients(frame.camera.viewToClip);
    const glm::dvec3 sun = glm::normalize(glm::dvec3(renderer.scene().sunDirection));
    for (size_t i = 0; i < picture.ids.size(); ++i) {
        const bool isSky = picture.ids[i].x == 0;
        frame.depth.push_back(isSky ? 65504.0f : float(1.0 / (picture.depth[i] * linear.x + linear.y)));
        const float* const n = &picture.normal[i * 4];
        frame.normal.push_back(isSky ? glm::dvec3(0.0) : glm::normalize(glm::dvec3(n[0], n[1], n[2])));
        size_t cascade = 0;
        while (cascade < frame.map.cascades.size() && frame.depth[i] > frame.map.cascades[cascade].farDepth)
            ++cascade;
        frame.cascade.push_back(cascade);
        const glm::dvec3 world = worldAt(frame.camera, centre(i), picture.depth[i]);
        frame.sun.push_back(cascade == frame.map.cascades.size()
                                ? Sun::unknown
                                : hardSun(frame, cascade, world, frame.normal[i], sun));
    }
    return frame;
}

// The nearest of each ratio x ratio pixels, as depth_downsample has it.
std::vector<float> nearestDepth(const SunFrame& frame, uint32_t ratio) {
    const uint32_t w = width / ratio;
    std::vector<float> coarse(size_t(w) * (height / ratio), 65504.0f);
    for (size_t i = 0; i < frame.depth.size(); ++i) {
        float& nearest = coarse[i / width / ratio * w + i % width / ratio];
        nearest = std::min(nearest, frame.depth[i]);
    }
    return coarse;
}

// Visibility and linear depth of every texel, from the default variant of generated/.
std::vector<float> sunShadow(const SunFrame& frame, std::span<const float> depth, uint32_t ratio) {
    const uint32_t w = width / ratio, h = height / ratio;
    const auto variant = reprise::makeVariant(reprise::generated::passes, "sun_shadow");
    const auto words = reprise::spirvFromDirectory("generated")(*variant, reprise::Stage::compute);
    if (!words) throw std::runtime_error(words.error().message);
    const VkFormat format = VK_FORMAT_R32G32_SFLOAT;
    harness::PassRunner runner(gpu(), *variant, reprise::Stage::compute, *words, {}, {&format, 1});
    harness::Image coarse = gpu().image(VK_FORMAT_R32_SFLOAT, w, h), shadow = gpu().image(format, w, h);
    gpu().uploadFloats(coarse, depth);
    const VkExtent2D map = frame.map.image->ref.extent;
    auto made =
        reprise::sunShadowParameters(frame.camera, {1.0, 1.0}, frame.map.cascades, map.width, map.height);
    if (!made) throw std::runtime_error(made.error().message);
    const float size[] = {float(w), float(h), 1.0f / float(w), 1.0f / float(h)};
    std::copy(std::begin(size), std::end(size), made->gOutputSize);
    made->gSubsetCount = 4.0f;
    const harness::PassRunner::Binding images[] = {
        {"gInCoarseDepth", &coarse}, {"gInShadowMap", frame.map.image}, {"gOutShadow", &shadow}};
    gpu().run([&](VkCommandBuffer commands) {
        runner.record(commands, images, std::as_bytes(std::span(&*made, 1)));
    });
    return gpu().downloadFloats(shadow);
}

// Whether the neighbours that are nearer in depth lie in the plane of the surface: of what is narrower than
// two texels the pass cannot know the plane.
bool isPlaneKnown(const SunFrame& frame, std::span<const float> depth, uint32_t ratio, size_t texel,
                  glm::dvec3 normal) {
    const int w = int(width / ratio), h = int(height / ratio), x = int(texel) % w, y = int(texel) / w;
    const glm::dvec4 ray = reprise::viewRay(frame.camera.viewToClip);
    const glm::dmat3 viewToWorld(glm::inverse(frame.camera.worldToView));
    const auto point = [&](glm::ivec2 at) {
        const double d = depth[size_t(at.y * w + at.x)];
        const glm::dvec2 uv = (glm::dvec2(at) + 0.5) / glm::dvec2(w, h);
        return viewToWorld * glm::dvec3((uv * glm::dvec2(ray) + glm::dvec2(ray.z, ray.w)) * d, d);
    };
    for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
        double nearest = 1e30;
        bool inPlane = false;
        for (const int side : {-1, 1}) {
            const glm::ivec2 at = glm::ivec2(x, y) + side * step;
            if (at.x < 0 || at.y < 0 || at.x >= w || at.y >= h) continue;
            const double difference = std::abs(depth[size_t(at.y * w + at.x)] - depth[texel]);
            const glm::dvec3 way = point(at) - point({x, y});
            if (difference < nearest) inPlane = std::abs(glm::dot(normal, way)) < 0.02 * glm::length(way);
            nearest = std::min(nearest, difference);
        }
        if (!inPlane) return false;
    }
    return true;
}

struct SunCounts {
    size_t lit[scenes::cascadeCount] = {}, shadowed[scenes::cascadeCount] = {}, wrong = 0;
    std::string first; // of what is wrong
};

// Texels whose pixels agree on the sun and on the cascade.
SunCounts compareSun(const SunFrame& frame, uint32_t ratio) {
    const std::vector<float> depth = nearestDepth(frame, ratio), got = sunShadow(frame, depth, ratio);
    const uint32_t w = width / ratio;
    SunCounts counts;
    for (size_t i = 0; i < depth.size(); ++i) {
        const size_t first = i / w * ratio * width + i % w * ratio, last = first + (width + 1) * (ratio - 1);
        const Sun expected = frame.sun[first];
        bool agree = expected != Sun::unknown;
        for (const size_t other : {first + ratio - 1, last - (ratio - 1), last})
            agree = agree && frame.sun[other] == expected && frame.cascade[other] == frame.cascade[first];
        if (!agree || !isPlaneKnown(frame, depth, ratio, i, frame.normal[first])) continue;
        const bool lit = expected == Sun::lit;
        ++(lit ? counts.lit : counts.shadowed)[frame.cascade[first]];
        if (got[i * 2] == (lit ? 1.0f : 0.0f)) continue;
        if (counts.wrong++ == 0)
            counts.first = "texel (" + std::to_string(i % w) + ", " + std::to_string(i / w) +
                           ") of cascade " + std::to_string(frame.cascade[first]) + " is " +
                           std::to_string(got[i * 2]);
    }
    return counts;
}

// A low sun, so that shadows reach far.
Scene sceneInTheEvening(const char* name) {
    Scene scene = sceneNamed(name);
    scene.sunDirection = glm::normalize(glm::vec3(0.6f, 0.35f, -0.3f));
    return scene;
}

TEST(SceneSunShadow, ofThePassIsTheRenderersOwnWhereItIsHardInEveryCascade) {
    gpu().takeValidationMessages();
    for (const char* name : {"hdr_emitters", "camera_cut", "fast_object", "static_camera", "thin_geometry"}) {
        const Scene scene = sceneInTheEvening(name);
        scenes::Renderer renderer(gpu(), scene, width, height);
        const SunFrame frame = sunFrame(renderer, 5);
        for (const uint32_t ratio : {1u, 2u}) {
            const SunCounts counts = compareSun(frame, ratio);
            EXPECT_EQ(counts.wrong, 0u) << name << ", ratio " << ratio << ": " << counts.first;
            if (scene.name != "hdr_emitters") continue;
            for (size_t cascade = 0; cascade < frame.map.cascades.size(); ++cascade) {
                EXPECT_GT(counts.lit[cascade], 20u / (ratio * ratio)) << cascade << ", ratio " << ratio;
                EXPECT_GT(counts.shadowed[cascade], 40u) << cascade << ", ratio " << ratio;
            }
        }
    }
    for (const std::string& message : gpu().takeValidationMessages())
        ADD_FAILURE() << message;
}

// A map whose y runs the other way, columns in another order, and a camera that is not the frame's.
TEST(SceneSunShadow, ofAnotherMapOrCameraIsCaught) {
    const Scene scene = sceneInTheEvening("hdr_emitters");
    scenes::Renderer renderer(gpu(), scene, width, height);
    const SunFrame frame = sunFrame(renderer, 5);
    SunFrame wrong = frame;
    glm::dmat4 flip(1.0);
    flip[1][1] = -1.0;
    for (auto& cascade : wrong.map.cascades)
        cascade.worldToClip = flip * cascade.worldToClip;
    EXPECT_GT(compareSun(wrong, 1).wrong, 100u);
    wrong = frame;
    std::swap(wrong.map.cascades[1].worldToClip, wrong.map.cascades[2].worldToClip);
    EXPECT_GT(compareSun(wrong, 1).wrong, 100u);
    wrong = frame;
    wrong.camera = scenes::cameraAt(scene, 60, aspect);
    EXPECT_GT(compareSun(wrong, 1).wrong, 20u);
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
