// SPDX-License-Identifier: Apache-2.0
#include "sequence.hpp"
#include "parallel.hpp"

#include <cmath>

namespace report {

std::vector<RenderedFrame> renderFrames(harness::Gpu& gpu, scenes::Renderer& renderer, uint32_t first,
                                        uint32_t count, reprise::JitterSequence jitter, bool withIds) {
    std::vector<RenderedFrame> result;
    scenes::FrameTargets targets = renderer.targets();
    const VkExtent2D extent = targets.colour.ref.extent;
    const double aspect = static_cast<double>(extent.width) / extent.height;
    for (uint32_t index = first; index < first + count; ++index) {
        const scenes::FrameTargets fresh = renderer.targets();
        targets.colour = fresh.colour;
        targets.depth = fresh.depth;
        targets.motion = fresh.motion;
        if (withIds) targets.depthTest = fresh.depthTest, targets.ids = fresh.ids;
        RenderedFrame frame;
        frame.jitterPx = reprise::jitterPx(jitter, index);
        frame.camera = scenes::cameraAt(renderer.scene(), static_cast<int>(index), aspect);
        gpu.run([&](VkCommandBuffer commands) {
            renderer.render(commands, static_cast<int>(index), frame.jitterPx, targets);
            for (auto* image : {&targets.colour, &targets.depth, &targets.motion})
                gpu.use(commands, *image, reprise::sampledState);
        });
        frame.colour = targets.colour;
        frame.depth = targets.depth;
        frame.motion = targets.motion;
        if (withIds) frame.depthTest = targets.depthTest, frame.ids = targets.ids;
        result.push_back(std::move(frame));
    }
    return result;
}

GroundTruth renderGroundTruth(scenes::Renderer& renderer, uint32_t width, uint32_t height, uint32_t frames,
                              uint32_t samples, Progress& progress) {
    GroundTruth truth;
    for (uint32_t frame = 0; frame < frames; ++frame) {
        truth.pictures.push_back({width, height, renderer.groundTruth(static_cast<int>(frame), samples)});
        progress.step(samples, renderer.scene().name + ", ground truth");
    }
    truth.flipSides.resize(frames);
    parallelFor(frames, [&](size_t i) { truth.flipSides[i] = flipSide(truth.pictures[i]); });
    return truth;
}

Picture displayPicture(harness::Gpu& gpu, harness::Image& image) {
    const std::vector<float> texels = gpu.downloadFloats(image);
    Picture picture{image.ref.extent.width, image.ref.extent.height, {}};
    picture.rgb.resize(texels.size() / 4 * 3);
    for (size_t i = 0; i < texels.size() / 4; ++i)
        for (size_t c = 0; c < 3; ++c) {
            const float value = texels[4 * i + c];
            // An infinity would turn into white and a NaN into black on the way through the tone curve.
            picture.rgb[3 * i + c] = std::isfinite(value) ? scenes::displayColour(value) : value;
        }
    return picture;
}

harness::Image borrowed(const reprise::ImageRef& ref) {
    harness::Image image;
    image.ref = ref;
    image.state = reprise::sampledState;
    return image;
}

} // namespace report
