// SPDX-License-Identifier: Apache-2.0
#include "converged.hpp"

#include "reprise/ambient_occlusion.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::Variant;

constexpr float skyDepth = 65504.0f; // SKY_DEPTH of the pack
constexpr uint32_t subsets = 16;     // the most that subsetOfFrame() takes
// The pass's own 16 bits would round each frame. Of obscurance red is in 255 levels whatever the format: the
// mean of 16 frames, each at its nearest level, is off by 0.0003, and by 0.0009 once three times as dark.
constexpr VkFormat valueFormat = VK_FORMAT_R32G32_SFLOAT;

// No frame is black at this intensity, whose taps darken by 5 * 0.6 of it at most: so that the mean is that
// of all taps, and black comes after it.
constexpr double clearIntensity = 1.0 / 3.0;

// The pass's defaults but for these switches.
Variant variantOf(const Shaders& shaders, std::string_view pass,
                  std::initializer_list<std::pair<std::string_view, std::string_view>> switches) {
    auto variant = reprise::makeVariant(shaders.pack().passes(), pass);
    if (!variant) throw std::runtime_error(variant.error().message);
    for (const auto& [name, value] : switches)
        if (const auto set = reprise::setSwitch(*variant, name, value); !set)
            throw std::runtime_error(set.error().message);
    return *variant;
}

uint32_t texelsOf(uint32_t pixels, uint32_t ratio) {
    return (pixels + ratio - 1) / ratio;
}

std::vector<float> floats(glm::dvec4 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z),
            static_cast<float>(v.w)};
}

std::vector<float> sizeOf(uint32_t width, uint32_t height) {
    return floats({width, height, 1.0 / width, 1.0 / height});
}

// Into a new image of `format`; the pass has one output.
harness::Image runOnce(harness::Gpu& gpu, Shaders& shaders, const Variant& variant, reprise::Stage stage,
                       const PassData& data, uint32_t width, uint32_t height, VkFormat format) {
    const reprisec::Compiled& compiled = shaders.get(variant, stage);
    harness::Image output = gpu.image(format, width, height);
    std::vector<harness::PassRunner::Binding> bindings{{variant.pass->outputs.front().name, &output}};
    for (const auto& [name, image] : data.images)
        bindings.push_back({name, image});
    const auto parameters =
        packParameters(compiled.reflection, variant.pass->parameterBytes, data.parameters);
    harness::PassRunner runner(gpu, variant, stage, compiled.spirv, shaders.fullscreenVertex(),
                               std::vector{format});
    gpu.run([&](VkCommandBuffer commands) { runner.record(commands, bindings, parameters); });
    return output;
}

// Linear depth of the frame at its own resolution: depth_downsample starts at half.
harness::Image fullDepth(harness::Gpu& gpu, RenderedFrame& frame, double farthest) {
    const VkExtent2D extent = frame.depth.ref.extent;
    const glm::dvec2 coefficients = reprise::linearDepthCoefficients(frame.camera.viewToClip);
    std::vector<float> depth = gpu.downloadFloats(frame.depth);
    for (float& value : depth) {
        const double metres = 1.0 / (static_cast<double>(value) * coefficients.x + coefficients.y);
        value = metres > 0.0 && metres < farthest ? static_cast<float>(metres) : skyDepth;
    }
    harness::Image image = gpu.image(VK_FORMAT_R32_SFLOAT, extent.width, extent.height);
    gpu.uploadFloats(image, depth);
    return image;
}

harness::Image coarseDepth(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                           const OcclusionEstimate& estimate) {
    const VkExtent2D extent = frame.depth.ref.extent;
    const uint32_t width = texelsOf(extent.width, estimate.ratio),
                   height = texelsOf(extent.height, estimate.ratio);
    const glm::dvec2 coefficients = reprise::linearDepthCoefficients(frame.camera.viewToClip);
    PassData data;
    data.images = {{"gInDepth", &frame.depth}};
    data.parameters = {
        {"gInputSize", sizeOf(extent.width, extent.height)},
        {"gOutputSize", sizeOf(width, height)},
        {"gLinearDepth", {static_cast<float>(coefficients.x), static_cast<float>(coefficients.y)}},
        {"gSkyDepth", {static_cast<float>(estimate.skyDepth)}}};
    const Variant variant =
        variantOf(shaders, "depth_downsample", {{"RATIO", fmt::format("{}", estimate.ratio)}});
    return runOnce(gpu, shaders, variant, estimate.stage, data, width, height, VK_FORMAT_R32_SFLOAT);
}

// Levels 0 to 4 beside each other: across the frame's width and half of it more.
harness::Image depthHierarchy(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                              const ObscuranceEstimate& estimate) {
    const VkExtent2D extent = frame.depth.ref.extent;
    const uint32_t width = (3 * extent.width + 1) / 2;
    const glm::dvec2 coefficients = reprise::linearDepthCoefficients(frame.camera.viewToClip);
    PassData data;
    data.images = {{"gInDepth", &frame.depth}};
    data.parameters = {
        {"gInputSize", sizeOf(extent.width, extent.height)},
        {"gOutputSize", sizeOf(width, extent.height)},
        {"gLinearDepth", {static_cast<float>(coefficients.x), static_cast<float>(coefficients.y)}},
        {"gSkyDepth", {static_cast<float>(estimate.skyDepth)}}};
    return runOnce(gpu, shaders, variantOf(shaders, "depth_hierarchy", {}), estimate.stage, data, width,
                   extent.height, VK_FORMAT_R32_SFLOAT);
}

void checkAbove0(double radius, double sky) {
    if (!(radius > 0.0 && sky > 0.0))
        throw std::runtime_error("Radius and sky depth of a converged estimate must be above 0");
}

// The estimate's extent and depth; its visibility is still to come.
Converged beginFrom(harness::Gpu& gpu, harness::Image& depth) {
    const VkExtent2D extent = depth.ref.extent;
    Converged converged;
    converged.width = extent.width;
    converged.height = extent.height;
    converged.linearDepth = gpu.downloadFloats(depth);
    return converged;
}

} // namespace

glm::dvec4 coarseViewRay(const reprise::CameraFrame& camera, VkExtent2D frame, uint32_t ratio) {
    glm::dvec4 ray = reprise::viewRay(camera.viewToClip);
    ray.x *= static_cast<double>(ratio) * texelsOf(frame.width, ratio) / frame.width;
    ray.y *= static_cast<double>(ratio) * texelsOf(frame.height, ratio) / frame.height;
    return ray;
}

std::vector<float> meanOverCycle(harness::Gpu& gpu, Shaders& shaders, const Variant& variant,
                                 reprise::Stage stage, PassData data, uint32_t width, uint32_t height,
                                 uint32_t count, const std::function<void(uint32_t, PassData&)>& setFrame) {
    std::vector<double> sums(size_t{width} * height);
    for (uint32_t index = 0; index < count; ++index) {
        setFrame(index, data);
        harness::Image output = runOnce(gpu, shaders, variant, stage, data, width, height, valueFormat);
        const std::vector<float> values = gpu.downloadFloats(output);
        for (size_t i = 0; i < sums.size(); ++i)
            sums[i] += static_cast<double>(values[2 * i]);
    }
    std::vector<float> means(sums.size());
    for (size_t i = 0; i < sums.size(); ++i)
        means[i] = static_cast<float>(sums[i] / count);
    return means;
}

Converged convergedOcclusion(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                             const OcclusionEstimate& estimate) {
    if (estimate.ratio != 1 && estimate.ratio != 2 && estimate.ratio != 4)
        throw std::runtime_error(fmt::format(
            "A converged estimate at a ratio of {} does not exist; it is 1, 2 or 4", estimate.ratio));
    checkAbove0(estimate.radius, estimate.skyDepth);
    harness::Image depth = estimate.ratio == 1 ? fullDepth(gpu, frame, estimate.skyDepth)
                                               : coarseDepth(gpu, shaders, frame, estimate);
    Converged converged = beginFrom(gpu, depth);
    PassData data;
    data.images = {{"gInCoarseDepth", &depth}};
    data.parameters = {
        {"gOutputSize", sizeOf(converged.width, converged.height)},
        {"gViewRay", floats(coarseViewRay(frame.camera, frame.depth.ref.extent, estimate.ratio))},
        // Of the engine's normals, which this variant does not read.
        {"gFrameToCoarse", {1.0f, 1.0f}},
        {"gRadius", {static_cast<float>(estimate.radius)}},
        {"gOcclusionBias", {static_cast<float>(estimate.bias.x), static_cast<float>(estimate.bias.y)}}};
    const Variant variant = variantOf(shaders, "ambient_occlusion", {{"SAMPLES", "32"}});
    const auto setFrame = [](uint32_t index, PassData& frameData) {
        std::vector<float>& taps = frameData.parameters["gTaps"];
        taps.clear();
        for (const glm::vec4& tap : reprise::occlusionTaps(32, index, subsets))
            taps.insert(taps.end(), {tap.x, tap.y, tap.z, tap.w});
    };
    converged.visibility = meanOverCycle(gpu, shaders, variant, estimate.stage, std::move(data),
                                         converged.width, converged.height, subsets, setFrame);
    return converged;
}

Converged convergedObscurance(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                              const ObscuranceEstimate& estimate) {
    checkAbove0(estimate.radius, estimate.skyDepth);
    harness::Image depth = fullDepth(gpu, frame, estimate.skyDepth);
    harness::Image hierarchy = depthHierarchy(gpu, shaders, frame, estimate);
    Converged converged = beginFrom(gpu, depth);
    PassData data;
    data.images = {{"gInDepthHierarchy", &hierarchy}};
    data.parameters = {{"gOutputSize", sizeOf(converged.width, converged.height)},
                       {"gViewRay", floats(reprise::viewRay(frame.camera.viewToClip))},
                       {"gRadius", {static_cast<float>(estimate.radius)}},
                       {"gIntensity", {static_cast<float>(clearIntensity)}},
                       {"gBias", {static_cast<float>(estimate.bias.x), static_cast<float>(estimate.bias.y)}},
                       {"gRotationCount", {static_cast<float>(subsets)}},
                       {"gFarDepth", {skyDepth}},
                       // Of the history, which this variant does not read.
                       {"gMaxWeight", {0.0f}},
                       {"gMissThreshold", {0.0f, 0.0f}},
                       {"gMotionToUv", {1.0f, 1.0f}},
                       {"gViewToPreviousDepth", {0.0f, 0.0f, 1.0f, 0.0f}},
                       {"gHistoryValid", {0.0f}},
                       {"gMovingWeight", {0.0f}},
                       {"gMovingPx", {1.0f}}};
    const Variant variant =
        variantOf(shaders, "scalable_obscurance", {{"SAMPLES", "33"}, {"TEMPORAL", "off"}});
    const auto setFrame = [](uint32_t index, PassData& frameData) {
        frameData.parameters["gFrameIndex"] = {static_cast<float>(index)};
    };
    converged.visibility = meanOverCycle(gpu, shaders, variant, estimate.stage, std::move(data),
                                         converged.width, converged.height, subsets, setFrame);
    for (float& value : converged.visibility) {
        const double obscurance = (1.0 - double{value}) / clearIntensity;
        value = static_cast<float>(std::clamp(1.0 - estimate.intensity * obscurance, 0.0, 1.0));
    }
    return converged;
}

} // namespace report
