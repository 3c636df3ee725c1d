// SPDX-License-Identifier: Apache-2.0
// A frame recorder with the images an engine would hand it.
#pragma once

#include "reprise/frame.hpp"
#include "runtime_support.hpp"

#include <stdexcept>

inline const reprisec::Pack& testPack() {
    static const auto loaded = reprisec::Pack::load("hlsl/pack.toml");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
}

// Compiled from the sources of the tree, each module once.
inline reprise::Result<std::vector<uint32_t>> packSpirv(const reprise::Variant& variant,
                                                        reprise::Stage stage) {
    static std::map<std::string, std::vector<uint32_t>> cache;
    auto& words = cache[reprise::spirvFileName(variant, stage)];
    if (words.empty()) {
        auto made = reprisec::compile(testPack(), variant, stage, {.glsl = false, .platformSwitches = {}});
        if (!made) return made.error();
        words = made->spirv;
    }
    return words;
}

// The document's filter without anything that depends on more than one pixel and its history, so that the
// blend can be computed by hand: history weighs TaaTuning::feedbackMax.
inline std::vector<reprise::Condition> plainBlend() {
    return {{"CONSTRAINT", "none"},  {"FEEDBACK", "constant"}, {"HDR_WEIGHT", "off"},
            {"COLOUR_SPACE", "rgb"}, {"UNJITTER", "off"},      {"HISTORY_FILTER", "bilinear"}};
}

struct TestFrame {
    explicit TestFrame(reprise::Extent size, VkFormat depthFormat = VK_FORMAT_D32_SFLOAT)
        : extent(size), colour(testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, size.width, size.height)),
          depth(testGpu().image(VK_FORMAT_R32_SFLOAT, size.width, size.height)),
          depthTest(testGpu().image(depthFormat, size.width, size.height)),
          motion(testGpu().image(VK_FORMAT_R16G16_SFLOAT, size.width, size.height)) {
        fill(colour, 0.5f);
        fill(depth, 0.5f);
        fill(depthTest, 1.0f);
        fill(motion, 0.0f);
        testGpu().run(
            [&](VkCommandBuffer commands) { testGpu().use(commands, depthTest, harness::depthReadState); });
        camera.viewToClip = glm::dmat4(1.0);
        camera.viewToClip[2] = {0.0, 0.0, 1.001, 1.0}; // perspective, near 0.1, 90 degrees
        camera.viewToClip[3] = {0.0, 0.0, -0.1, 0.0};
    }

    void fill(harness::Image& image, float value) const {
        const size_t values = size_t(extent.width) * extent.height * harness::channelCount(image.ref.format);
        testGpu().uploadFloats(image, std::vector<float>(values, value));
    }

    reprise::FrameInput input(uint64_t frameIndex) const {
        reprise::FrameInput in;
        in.frameIndex = frameIndex;
        in.camera = camera;
        in.colour = colour.ref;
        in.depth = depth.ref;
        in.motion = motion.ref;
        in.depthAttachment = depthTest.ref;
        in.movingObjects = objects;
        return in;
    }

    reprise::Extent extent;
    harness::Image colour, depth, depthTest, motion;
    reprise::CameraFrame camera;
    std::vector<reprise::ObjectDraw> objects;
};

inline reprise::Result<reprise::FrameRecorder>
tryRecorder(const reprise::FrameRecorder::CreateInfo& info,
            const reprise::Device& device = testGpu().device()) {
    return reprise::FrameRecorder::create(device, testPack().passes(), packSpirv, info);
}

inline reprise::FrameRecorder makeRecorder(const reprise::FrameRecorder::CreateInfo& info) {
    auto made = tryRecorder(info);
    if (!made) throw std::runtime_error(made.error().message);
    return std::move(*made);
}

inline reprise::Result<reprise::FrameOutput> recordOne(reprise::FrameRecorder& recorder,
                                                       const reprise::FrameInput& input) {
    reprise::Result<reprise::FrameOutput> output = reprise::Error{};
    testGpu().run([&](VkCommandBuffer commands) { output = recorder.record(commands, input); });
    return output;
}

inline std::vector<float> downloadRef(const reprise::ImageRef& ref) {
    harness::Image image;
    image.ref = ref;
    image.state = reprise::sampledState;
    return testGpu().downloadFloats(image);
}
