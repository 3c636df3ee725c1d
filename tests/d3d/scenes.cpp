// SPDX-License-Identifier: Apache-2.0
#include "scenes.hpp"

#include "passes/ambient_occlusion_case.hpp"
#include "passes/bilateral_upsample_case.hpp"
#include "passes/camera_case.hpp"
#include "passes/combine_lighting_case.hpp"
#include "passes/depth_downsample_case.hpp"
#include "passes/depth_hierarchy_case.hpp"
#include "passes/lighting_cache_case.hpp"
#include "passes/object_case.hpp"
#include "passes/reprojection_cache_case.hpp"
#include "passes/scalable_obscurance_case.hpp"
#include "passes/sun_shadow_case.hpp"
#include "passes/temporal_aa_case.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace d3d {

namespace {

using passes::Comparison;
using passes::Expected;
using passes::Pixels;
using passes::Texel;
using Outputs = std::vector<Pixels>;

struct Size {
    int width, height;
};
// The first is that of the controls, the other has odd rows and columns.
constexpr Size sizes[] = {{64, 64}, {33, 17}};

std::string text(Size size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

template <class T> std::vector<std::byte> bytesOf(const T& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    return {bytes.begin(), bytes.end()};
}

// --- camera_velocity

Scene cameraScene(const Variant& variant, Size size, bool behind) {
    passes::CameraKind kind;
    if (reprise::switchValue(variant, "ORTHOGRAPHIC") == "on")
        kind.projection = passes::Projection::orthographic;
    const bool linear = reprise::switchValue(variant, "DEPTH_LINEAR") == "on";
    const auto frame = std::make_shared<const passes::CameraCase>(
        passes::randomCameraCase(kind, linear, size.width, size.height, 61, behind));
    Scene scene{
        text(size) + (behind ? "-behind" : ""), size.width, size.height, {}, {}, {}, {}, {}, {}, frame};
    scene.images = {{"gInDepth", &frame->depth}};
    scene.parameters = bytesOf(frame->parameters);
    scene.judge = [frame](const Outputs& outputs, const DeviceError&) {
        return compareWithOracle(*frame, outputs[0]);
    };
    return scene;
}

std::vector<Scene> cameraScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes)
        scenes.push_back(cameraScene(variant, size, false));
    if (reprise::switchValue(variant, "ORTHOGRAPHIC") == "off")
        scenes.push_back(cameraScene(variant, sizes[0], true));
    return scenes;
}

// --- object_velocity

Vertices objectVertices(const passes::ObjectDrawData& data, bool skinned) {
    Vertices vertices;
    vertices.elements = {{"POSITION", "float3", 0}};
    if (skinned) {
        vertices.elements.push_back({"BLENDINDICES", "ubyte4", 12});
        vertices.elements.push_back({"BLENDWEIGHT", "float4", 16});
    }
    vertices.stride = skinned ? 32 : 12;
    for (size_t i = 0; i < 3; ++i) {
        const auto append = [&](const auto& value) {
            const auto bytes = bytesOf(value);
            vertices.bytes.insert(vertices.bytes.end(), bytes.begin(), bytes.end());
        };
        append(data.positions[i]);
        if (!skinned) continue;
        append(data.joints[i]);
        append(data.weights[i]);
    }
    return vertices;
}

std::vector<Scene> objectScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        passes::ObjectCase object;
        object.skinned = reprise::switchValue(variant, "SKINNING") == "on";
        object.width = size.width;
        object.height = size.height;
        const passes::ObjectDrawData data = drawDataOf(object);
        Scene scene{text(size), size.width, size.height, {}, {}, {}, {}, {}, {}, {}};
        scene.parameters = bytesOf(data.parameters);
        if (object.skinned)
            scene.palettes = {{"gInJoints", data.palette}, {"gInPrevJoints", data.prevPalette}};
        scene.vertices = objectVertices(data, object.skinned);
        scene.before = backgroundMotion(object, passes::rgba32f);
        scene.judge = [object](const Outputs& outputs, const DeviceError&) {
            return compareWithOracle(object, outputs[0]);
        };
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

// --- temporal_aa

std::vector<Scene> temporalAaScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const bool first = size.width == sizes[0].width;
        const auto contrast = first ? passes::Contrast::moderate : passes::Contrast::extreme;
        const auto frame = std::make_shared<const passes::TemporalAaFrame>(
            passes::randomFrame(size.width, size.height, first ? 62 : 63, contrast));
        Scene scene{text(size), size.width, size.height, {}, {}, {}, {}, {}, {}, frame};
        scene.images = {{"gInColour", &frame->colour},
                        {"gInDepth", &frame->depth},
                        {"gInVelocity", &frame->velocity},
                        {"gHistoryColour", &frame->history}};
        scene.parameters = bytesOf(frame->parameters);
        scene.judge = [frame, variant](const Outputs& outputs, const DeviceError& error) {
            return compareWithOracle(variant, *frame, outputs, error.coordinatePx());
        };
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

// --- The framework's passes; sizes are those of the target

template <class Case> Scene sceneOf(Size size, std::shared_ptr<const Case> frame) {
    Scene scene{text(size), size.width, size.height, {}, {}, {}, {}, {}, {}, frame};
    scene.parameters = bytesOf(frame->parameters);
    scene.judge = [frame](const Outputs& outputs, const DeviceError&) {
        if constexpr (requires { compareWithOracle(*frame, outputs); })
            return compareWithOracle(*frame, outputs);
        else
            return compareWithOracle(*frame, outputs[0]);
    };
    return scene;
}

template <class Case> std::shared_ptr<const Case> shared(Case frame) {
    return std::make_shared<const Case>(std::move(frame));
}

std::vector<Scene> depthDownsampleScenes(const Variant& variant) {
    const int ratio = reprise::switchValue(variant, "RATIO").front() - '0';
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame =
            shared(passes::randomDepthDownsampleCase(variant, ratio * size.width, ratio * size.height, 64));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInDepth", &frame->depth}};
    }
    return scenes;
}

std::vector<Scene> ambientOcclusionScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    // Controls take the first, whose depths differ from texel to texel; the bounds of the other are narrow.
    for (const Size size : sizes) {
        const auto surfaces =
            size.width == sizes[0].width ? passes::Surfaces::random : passes::Surfaces::corner;
        const auto frame =
            shared(passes::ambientOcclusionCase(variant, surfaces, size.width, size.height, 65));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInCoarseDepth", &frame->depth}, {"gInNormal", &frame->normal}};
    }
    return scenes;
}

std::vector<Scene> reprojectionCacheScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame =
            shared(passes::reprojectionCacheCase(variant, 2 * size.width, 2 * size.height, 66));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInFresh", &frame->fresh},
                                {"gInVelocity", &frame->velocity},
                                {"gInCoarseDepth", &frame->coarseDepth},
                                {"gHistoryCache", &frame->history},
                                {"gHistoryCacheFiltered", &frame->history},
                                {"gHistoryCoarseDepth", &frame->historyDepth},
                                {"gHistoryCacheState", &frame->state},
                                {"gHistoryCacheStateFiltered", &frame->state}};
    }
    return scenes;
}

std::vector<Scene> bilateralFilterScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame = shared(passes::bilateralFilterCase(variant, size.width, size.height, {1, 0}, 67));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInCache", &frame->cache},
                                {"gInCacheFiltered", &frame->cache},
                                {"gInCacheState", &frame->state},
                                {"gInCacheStateFiltered", &frame->state}};
    }
    return scenes;
}

std::vector<Scene> bilateralUpsampleScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame = shared(passes::bilateralUpsampleCase(variant, size.width, size.height, 68));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInFiltered", &frame->filtered},
                                {"gInCoarseDepth", &frame->coarseDepth},
                                {"gInDepth", &frame->depths.depth},
                                {"gInNormal", &frame->normal}};
    }
    return scenes;
}

std::vector<Scene> sunShadowScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame =
            shared(passes::sunShadowCase(variant, passes::Surfaces::corner, size.width, size.height, 69));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInCoarseDepth", &frame->depth},
                                {"gInShadowMap", &frame->map},
                                {"gInOcclusion", &frame->occlusion}};
    }
    return scenes;
}

// Held to the passes whose work it does, on the other device.
std::vector<Scene> lightingCacheScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame = shared(passes::lightingCacheCase(variant, size.width, size.height, 72));
        const auto expected =
            std::make_shared<const std::vector<Pixels>>(passes::SeparatePasses(variant)(*frame));
        Scene scene{text(size), size.width, size.height, {}, {}, {}, {}, {}, {}, frame};
        scene.parameters = bytesOf(frame->parameters);
        scene.judge = [frame, expected](const Outputs& outputs, const DeviceError&) {
            return compareWithSeparate(*frame, outputs, *expected);
        };
        scene.images = {{"gInCoarseDepth", &frame->occlusion.depth},
                        {"gInHalfDepth", &frame->halfDepth},
                        {"gInNormal", &frame->occlusion.normal},
                        {"gInShadowMap", &frame->shadow.map},
                        {"gInVelocity", &frame->cache.velocity},
                        {"gHistoryCache", &frame->cache.history},
                        {"gHistoryCacheFiltered", &frame->cache.history},
                        {"gHistoryCoarseDepth", &frame->cache.historyDepth},
                        {"gHistoryCacheState", &frame->cache.state},
                        {"gHistoryCacheStateFiltered", &frame->cache.state}};
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

std::vector<Scene> depthHierarchyScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        auto made = passes::depthHierarchyCase(variant, 2 * size.width / 3, size.height, 69);
        setExtent(made, {size.width, size.height});
        const auto frame = shared(std::move(made));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInDepth", &frame->depths.depth}};
    }
    return scenes;
}

std::vector<Scene> scalableObscuranceScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto surfaces =
            size.width == sizes[0].width ? passes::Surfaces::random : passes::Surfaces::corner;
        const auto frame =
            shared(passes::scalableObscuranceCase(variant, surfaces, size.width, size.height, 70));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInDepthHierarchy", &frame->hierarchy},
                                {"gInVelocity", &frame->velocity},
                                {"gHistoryObscurance", &frame->history}};
    }
    return scenes;
}

std::vector<Scene> obscuranceFilterScenes(const Variant&) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame = shared(passes::obscuranceFilterCase(size.width, size.height, {1, 0}, 71));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInObscurance", &frame->source}};
    }
    return scenes;
}

std::vector<Scene> combineLightingScenes(const Variant& variant) {
    std::vector<Scene> scenes;
    for (const Size size : sizes) {
        const auto frame = shared(passes::combineLightingCase(variant, size.width, size.height, 72));
        scenes.push_back(sceneOf(size, frame));
        scenes.back().images = {{"gInLighting", &frame->lighting},
                                {"gInAmbientLight", &frame->ambient},
                                {"gInSunLight", &frame->sun},
                                {"gInOtherLight", &frame->other}};
    }
    return scenes;
}

// --- fullscreen

// Where a pixel says that it is, to 1/1024 px: far from the half pixel that is looked for.
constexpr double positionBoundPx = 0x1p-10;

std::vector<Scene> fullscreenScenes(const Variant&) {
    std::vector<Scene> scenes;
    for (const Size size : {sizes[0], sizes[1], Size{1, 1}, Size{641, 359}}) {
        Scene scene{text(size), size.width, size.height, {}, {}, {}, {}, {}, {}, {}};
        scene.judge = [](const Outputs& outputs, const DeviceError&) {
            return passes::compare(
                outputs[0],
                [](int x, int y, bool) {
                    return Expected{{x + 0.5, y + 0.5, 0.0}, glm::dvec3(positionBoundPx)};
                },
                2);
        };
        scenes.push_back(std::move(scene));
    }
    return scenes;
}

struct PassScenes {
    std::string_view pass;
    std::vector<Scene> (*scenes)(const Variant&);
};

// One line for each pass of pack.toml.
constexpr PassScenes passScenes[] = {
    {"fullscreen", fullscreenScenes},
    {"camera_velocity", cameraScenes},
    {"object_velocity", objectScenes},
    {"depth_downsample", depthDownsampleScenes},
    {"ambient_occlusion", ambientOcclusionScenes},
    {"reprojection_cache", reprojectionCacheScenes},
    {"bilateral_filter", bilateralFilterScenes},
    {"bilateral_upsample", bilateralUpsampleScenes},
    {"sun_shadow", sunShadowScenes},
    {"lighting_cache", lightingCacheScenes},
    {"depth_hierarchy", depthHierarchyScenes},
    {"scalable_obscurance", scalableObscuranceScenes},
    {"obscurance_filter", obscuranceFilterScenes},
    {"combine_lighting", combineLightingScenes},
    {"temporal_aa", temporalAaScenes},
};

constexpr bool everyPassHasScenes() {
    for (const auto& pass : reprise::generated::passes) {
        bool found = false;
        for (const PassScenes& row : passScenes)
            found = found || row.pass == pass.name;
        if (!found) return false;
    }
    return true;
}
static_assert(everyPassHasScenes(),
              "A pass of generated/include/reprise/pack_table.hpp has no line in `passScenes`.");

} // namespace

std::vector<Scene> scenesOf(const Variant& variant) {
    for (const PassScenes& row : passScenes)
        if (row.pass == variant.pass->name) return row.scenes(variant);
    return {};
}

Vertices fullscreenCorners() {
    constexpr float corners[] = {-1.0f, -1.0f, 3.0f, -1.0f, -1.0f, 3.0f};
    return {8, bytesOf(corners), {{"POSITION", "float2", 0}}};
}

Scene screenCopyScene() {
    constexpr int size = 64;
    const auto noise =
        std::make_shared<const Pixels>(passes::highContrastNoise(passes::rgba32f, size, size, 64));
    Scene scene{"64x64", size, size, {{"gInColour", noise.get()}}, {}, {}, fullscreenCorners(),
                {},      {},   noise};
    scene.parameters = bytesOf(glm::vec4(size, size, 1.0f / size, 1.0f / size));
    // A coordinate that is off by a share of a texel changes the copy by up to that, in x
    // and y.
    scene.judge = [noise](const Outputs& outputs, const DeviceError& error) {
        return passes::compare(
            outputs[0],
            [&](int x, int y, bool) {
                return Expected{{noise->at(x, y, 0), noise->at(x, y, 1), noise->at(x, y, 2)},
                                glm::dvec3(2.0 * error.coordinatePx())};
            },
            3);
    };
    return scene;
}

Scene rampScene() {
    constexpr int size = 64;
    const auto ramp = std::make_shared<const Pixels>(
        passes::makePixels(passes::r32f, size, 1, [](int x, int) { return Texel{static_cast<float>(x)}; }));
    return {"64x64", size, size, {{"gInRamp", ramp.get()}}, {}, {}, {}, {}, {}, ramp};
}

double interpolationErrorPx(const Pixels& positions) {
    double error = 0.0;
    for (int y = 0; y < positions.height; ++y)
        for (int x = 0; x < positions.width; ++x)
            error = std::max({error, std::abs(positions.at(x, y, 0) - (x + 0.5)),
                              std::abs(positions.at(x, y, 1) - (y + 0.5))});
    return error;
}

double filterErrorPx(const Pixels& ramp) {
    double error = 0.0;
    for (int i = 0; i < ramp.width * ramp.height; ++i) {
        const double place = std::clamp((i + 0.5) / 64.0 - 0.5, 0.0, 63.0);
        error = std::max(error, std::abs(ramp.at(i % ramp.width, i / ramp.width, 0) - place));
    }
    return error;
}

} // namespace d3d
