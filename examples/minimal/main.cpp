// SPDX-License-Identifier: Apache-2.0
// An engine whose scene is a tilted checker that moves: eight jittered frames through the runtime. The last
// resolved frame must be closer to the truth than the frame as it was rendered. minimal PACK_DIRECTORY
#include "engine.hpp"
#include "reprise/frame.hpp"
#include "reprise/pack_table.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <glm/gtc/packing.hpp>

namespace {

constexpr uint32_t width = 160, height = 90, frames = 8;
const glm::dvec2 velocityPx(1.37, 0.61); // of the checker, a frame

struct Images {
    Texture colour, depth, motion;
};

// Once: borrow the engine's device and say what the scene needs.
reprise::Result<reprise::FrameRecorder> makeRecorder(const Engine& engine, const char* packDirectory) {
    reprise::EnabledFeatures enabled;
    enabled.synchronization2 = enabled.shaderStorageImageWriteWithoutFormat = true;
    const auto device = reprise::borrow({engine.instance, engine.physicalDevice, engine.device,
                                         engine.queueFamily, vkGetInstanceProcAddr, enabled});
    if (!device) return device.error();
    reprise::FrameRecorder::CreateInfo info;
    info.needs.engineWritesMotion = true; // so there is no velocity pass
    info.needs.hdr = false;
    info.extent = {width, height};
    return reprise::FrameRecorder::create(*device, reprise::packPasses(),
                                          reprise::spirvFromDirectory(packDirectory), info);
}

// Every frame: hand over what was rendered with `jitterPx`, take the resolved image.
reprise::Result<reprise::FrameOutput> resolve(reprise::FrameRecorder& recorder, VkCommandBuffer commands,
                                              uint64_t frame, glm::dvec2 jitterPx, const Images& images) {
    reprise::FrameInput input;
    input.frameIndex = frame;
    input.jitterPx = jitterPx;
    input.colour = images.colour.ref;
    input.depth = images.depth.ref;
    input.motion = images.motion.ref;
    return recorder.record(commands, input);
}

// The scene: 0 or 1 at a place of the image, in pixels.
double checker(glm::dvec2 px, uint64_t frame) {
    px -= velocityPx * static_cast<double>(frame);
    const double u = (px.x + 0.3 * px.y) / 7.3, v = (px.y - 0.3 * px.x) / 7.3;
    return std::fmod(std::floor(u) + std::floor(v) + 1000.0, 2.0) < 0.5 ? 0.1 : 0.9;
}

// Mean of `side` x `side` places in each pixel: 1 is a rendering, 16 the truth.
std::vector<double> render(uint64_t frame, int side, glm::dvec2 jitterPx) {
    std::vector<double> values;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            double sum = 0.0;
            for (int i = 0; i < side * side; ++i)
                sum += checker(
                    glm::dvec2(x + (i % side + 0.5) / side, y + (i / side + 0.5) / side) - jitterPx, frame);
            values.push_back(sum / (side * side));
        }
    return values;
}

double rmse(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

using Texel = std::function<glm::vec4(size_t)>;

void fill(const Engine& engine, const Staging& staging, const Texture& texture, int channels,
          const Texel& texel) {
    auto* floats = static_cast<float*>(staging.texels);
    for (size_t i = 0; i < size_t(width) * height; ++i)
        for (int c = 0; c < channels; ++c)
            *floats++ = texel(i)[c];
    VkCommandBuffer commands = beginCommands(engine);
    upload(commands, staging, texture);
    submit(engine, commands);
}

// History and output are RGBA16F.
std::vector<double> resolvedRed(const Staging& staging) {
    const auto* halves = static_cast<const uint16_t*>(staging.texels);
    std::vector<double> values;
    for (size_t i = 0; i < size_t(width) * height; ++i)
        values.push_back(glm::unpackHalf1x16(halves[4 * i]));
    return values;
}

int fail(const reprise::Error& error) {
    std::fprintf(stderr, "minimal: %s\n", error.message.c_str());
    return 1;
}

int run(const Engine& engine, const Staging& staging, const Images& images, const char* packDirectory) {
    auto recorder = makeRecorder(engine, packDirectory);
    if (!recorder) return fail(recorder.error());
    for (uint64_t frame = 0; frame < frames; ++frame) {
        const glm::dvec2 jitterPx = reprise::jitterPx(reprise::JitterSequence::halton16, frame);
        const auto rendered = render(frame, 1, jitterPx);
        fill(engine, staging, images.colour, 4,
             [&](size_t i) { return glm::vec4(static_cast<float>(rendered[i])); });
        VkCommandBuffer commands = beginCommands(engine);
        const auto output = resolve(*recorder, commands, frame, jitterPx, images);
        if (!output) return fail(output.error());
        download(commands, output->colour, staging);
        submit(engine, commands);
    }
    const auto truth = render(frames - 1, 16, {});
    const double raw = rmse(render(frames - 1, 1, {}), truth), resolved = rmse(resolvedRed(staging), truth);
    std::printf("RMSE against the truth: %.4f as rendered, %.4f resolved\n", raw, resolved);
    // 0.74 on a CPU driver. Motion of the wrong sign gives 2.3, a jitter of the wrong sign 0.94.
    return resolved < 0.85 * raw ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "minimal: name the directory of the compiled pack.\n");
        return 2;
    }
    const Engine engine = startEngine();
    const Staging staging = makeStaging(engine, VkDeviceSize(width) * height * 16);
    const Images images{makeTexture(engine, VK_FORMAT_R32G32B32A32_SFLOAT, width, height),
                        makeTexture(engine, VK_FORMAT_R32_SFLOAT, width, height),
                        makeTexture(engine, VK_FORMAT_R32G32_SFLOAT, width, height)};
    fill(engine, staging, images.depth, 1, [](size_t) { return glm::vec4(0.5f); });
    const glm::vec2 motionUv = velocityPx / glm::dvec2(width, height);
    fill(engine, staging, images.motion, 2, [&](size_t) { return glm::vec4(motionUv, 0.0f, 0.0f); });
    const int result = run(engine, staging, images, argv[1]);
    for (const Texture& texture : {images.colour, images.depth, images.motion})
        destroy(engine, texture);
    destroy(engine, staging);
    stopEngine(engine);
    return result;
}
