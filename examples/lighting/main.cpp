// SPDX-License-Identifier: Apache-2.0
// An engine whose camera moves towards a wall: occlusion before shading, which this engine does on the CPU,
// and anti-aliasing after it. The occlusion of the last frame must be closer to the truth than that of the
// first, and the resolved frame closer than one that is shaded from it. lighting PACK_DIRECTORY
#include "engine.hpp"
#include "reprise/frame.hpp"
#include "reprise/pack_table.hpp"

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>

namespace {

constexpr uint32_t width = 160, height = 90, frames = 24;

// Once: a recorder for what comes before shading, and one for what comes after it.
struct Recorders {
    reprise::FrameRecorder lighting, antiAliasing;
};

reprise::Result<Recorders> makeRecorders(const reprise::Device& device, const char* packDirectory) {
    const auto spirv = reprise::spirvFromDirectory(packDirectory);
    reprise::FrameRecorder::CreateInfo info;
    info.needs.objectsMove = info.needs.hdr = false;
    info.needs.linearDepth = true; // in metres
    info.extent = {width, height};
    auto antiAliasing = reprise::FrameRecorder::create(device, reprise::packPasses(), spirv, info);
    if (!antiAliasing) return antiAliasing.error();
    info.needs.antiAliasing = false;
    info.needs.ambientOcclusion = true;
    auto lighting = reprise::FrameRecorder::create(device, reprise::packPasses(), spirv, info);
    if (!lighting) return lighting.error();
    return Recorders{std::move(*lighting), std::move(*antiAliasing)};
}

// Every frame, once depth is rendered: visibility of each pixel in red, for the engine's shaders.
reprise::Result<reprise::FrameOutput> recordLighting(Recorders& recorders, VkCommandBuffer commands,
                                                     reprise::FrameInput frame) {
    frame.cache.radius = 1.0f; // metres
    return recorders.lighting.record(commands, frame);
}

// Once the frame is shaded, with the same camera, jitter and depth.
reprise::Result<reprise::FrameOutput> recordAntiAliasing(Recorders& recorders, VkCommandBuffer commands,
                                                         reprise::FrameInput frame,
                                                         const reprise::ImageRef& shaded) {
    frame.colour = shaded;
    return recorders.antiAliasing.record(commands, frame);
}

// --- The scene: a checkered floor 1 m below the first frame's camera, and a wall 4 m ahead of it.

struct Surface {
    double depth = 0.0;    // metres
    double fromEdge = 0.0; // distance to the edge between floor and wall, metres
    double albedo = 0.0;
};

const double floorHeight = -1.0, wallDepth = 4.0, radius = 1.0;

glm::dvec3 cameraPosition(uint64_t frame) {
    return glm::dvec3(0.02, 0.005, 0.02) * static_cast<double>(frame);
}

reprise::CameraFrame cameraOf(uint64_t frame) {
    const double focal = 1.6, nearPlane = 0.1, farPlane = 100.0;
    reprise::CameraFrame camera;
    camera.worldToView = glm::translate(glm::dmat4(1.0), -cameraPosition(frame));
    camera.viewToClip = glm::dmat4(0.0);
    camera.viewToClip[0][0] = focal * height / width;
    camera.viewToClip[1][1] = focal;
    camera.viewToClip[2] = {0.0, 0.0, farPlane / (farPlane - nearPlane), 1.0};
    camera.viewToClip[3][2] = -nearPlane * farPlane / (farPlane - nearPlane);
    return camera;
}

Surface surfaceAt(glm::dvec2 px, uint64_t frame) {
    const glm::dmat4 projection = cameraOf(frame).viewToClip;
    const double x = (2.0 * px.x / width - 1.0) / projection[0][0],
                 y = (1.0 - 2.0 * px.y / height) / projection[1][1];
    const glm::dvec3 eye = cameraPosition(frame);
    const double ahead = wallDepth - eye.z, below = floorHeight - eye.y;
    const bool onFloor = y * ahead < below;
    Surface surface;
    surface.depth = onFloor ? below / y : ahead;
    surface.fromEdge = onFloor ? ahead - surface.depth : y * ahead - below;
    const double along = eye.x + x * surface.depth;
    const double square = std::floor(along / 0.3) + std::floor(surface.fromEdge / 0.3);
    surface.albedo = std::fmod(square + 1000.0, 2.0) < 0.5 ? 0.3 : 0.9;
    return surface;
}

// What ambient_occlusion converges to at a distance from the edge: 1 - the mean, over directions distributed
// as the cosine, of 1 - (d / radius)^2, d the distance to the other plane.
double trueVisibility(double fromEdge) {
    constexpr int steps = 48;
    double occlusion = 0.0;
    for (int i = 0; i < steps * steps; ++i) {
        const double azimuth = (i % steps + 0.5) / steps * glm::two_pi<double>();
        const double sine = std::sqrt((i / steps + 0.5) / steps); // to the normal
        const double towards = sine * std::cos(azimuth);
        const double d = towards > 0.0 ? fromEdge / towards : radius;
        if (d < radius) occlusion += 1.0 - d * d / (radius * radius);
    }
    return 1.0 - occlusion / (steps * steps);
}

double visibilityAt(double fromEdge) {
    static const std::vector<double> table = [] {
        std::vector<double> made;
        for (int i = 0; i <= 256; ++i)
            made.push_back(trueVisibility(radius * i / 256.0));
        return made;
    }();
    return fromEdge >= radius ? 1.0 : table[static_cast<size_t>(256.0 * fromEdge / radius)];
}

using Values = std::vector<double>;
using OfSurface = std::function<double(const Surface&, size_t pixel)>;

// Mean of `side` x `side` places in each pixel: 1 is a rendering.
Values render(uint64_t frame, int side, glm::dvec2 jitterPx, const OfSurface& of) {
    Values values(size_t(width) * height, 0.0);
    for (size_t i = 0; i < values.size(); ++i)
        for (int k = 0; k < side * side; ++k) {
            const glm::dvec2 place(double(i % width) + (k % side + 0.5) / side,
                                   double(i / width) + (k / side + 0.5) / side);
            values[i] += of(surfaceAt(place - jitterPx, frame), i) / (side * side);
        }
    return values;
}

double rmse(const Values& a, const Values& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// --- The frame

struct Frames {
    const Engine& engine;
    Staging staging;
    Texture depth, colour;
};

void fill(const Frames& frames, const Texture& texture, int channels, const Values& values) {
    auto* floats = static_cast<float*>(frames.staging.texels);
    for (const double value : values)
        for (int c = 0; c < channels; ++c)
            *floats++ = static_cast<float>(value);
    VkCommandBuffer commands = beginCommands(frames.engine);
    upload(commands, frames.staging, texture);
    submit(frames.engine, commands);
}

// Red of an image of 16-bit floats.
Values redOf(const Frames& frames, VkCommandBuffer commands, const reprise::ImageRef& image,
             size_t channels) {
    download(commands, image, frames.staging);
    submit(frames.engine, commands);
    const auto* halves = static_cast<const uint16_t*>(frames.staging.texels);
    Values values;
    for (size_t i = 0; i < size_t(width) * height; ++i)
        values.push_back(glm::unpackHalf1x16(halves[channels * i]));
    return values;
}

struct Result {
    Values lighting, shaded, resolved;
};

reprise::Result<Result> runFrame(Recorders& recorders, const Frames& frames, uint64_t index) {
    reprise::FrameInput input;
    input.frameIndex = index;
    input.camera = cameraOf(index);
    input.jitterPx = reprise::jitterPx(reprise::JitterSequence::halton16, index);
    input.depth = frames.depth.ref;
    fill(frames, frames.depth, 1,
         render(index, 1, input.jitterPx, [](const Surface& s, size_t) { return s.depth; }));
    Result result;
    VkCommandBuffer commands = beginCommands(frames.engine);
    const auto lighting = recordLighting(recorders, commands, input);
    if (!lighting) return lighting.error();
    result.lighting = redOf(frames, commands, *lighting->lighting, 1);
    result.shaded = render(index, 1, input.jitterPx,
                           [&](const Surface& s, size_t i) { return s.albedo * result.lighting[i]; });
    fill(frames, frames.colour, 4, result.shaded);
    commands = beginCommands(frames.engine);
    const auto resolved = recordAntiAliasing(recorders, commands, input, frames.colour.ref);
    if (!resolved) return resolved.error();
    result.resolved = redOf(frames, commands, resolved->colour, 4);
    return result;
}

int fail(const reprise::Error& error) {
    std::fprintf(stderr, "lighting: %s\n", error.message.c_str());
    return 1;
}

reprise::Result<reprise::Device> borrowDevice(const Engine& engine) {
    reprise::EnabledFeatures enabled;
    enabled.synchronization2 = enabled.shaderStorageImageWriteWithoutFormat = true;
    return reprise::borrow({engine.instance, engine.physicalDevice, engine.device, engine.queueFamily,
                            vkGetInstanceProcAddr, enabled});
}

int run(const Frames& images, const char* packDirectory) {
    const auto device = borrowDevice(images.engine);
    if (!device) return fail(device.error());
    auto recorders = makeRecorders(*device, packDirectory);
    if (!recorders) return fail(recorders.error());
    Result first, last;
    for (uint64_t frame = 0; frame < frames; ++frame) {
        auto result = runFrame(*recorders, images, frame);
        if (!result) return fail(result.error());
        (frame == 0 ? first : last) = std::move(*result);
    }
    const auto visibility = [](const Surface& s, size_t) { return visibilityAt(s.fromEdge); };
    const auto shade = [](const Surface& s, size_t) { return s.albedo * visibilityAt(s.fromEdge); };
    const Values shaded = render(frames - 1, 8, {}, shade);
    const double one = rmse(first.lighting, render(0, 8, {}, visibility)),
                 many = rmse(last.lighting, render(frames - 1, 8, {}, visibility)),
                 raw = rmse(last.shaded, shaded), resolved = rmse(last.resolved, shaded);
    std::printf("RMSE of occlusion: %.4f in the first frame, %.4f in the last\n", one, many);
    std::printf("RMSE of the frame: %.4f as shaded, %.4f resolved\n", raw, resolved);
    // 0.60 and 0.40 on a CPU driver. Without history 0.70 and 0.54, a camera that is said to stand still 0.93
    // and 0.84, a jitter of the wrong sign the second 0.46.
    return many < 0.65 * one && resolved < 0.43 * raw ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "lighting: name the directory of the compiled pack.\n");
        return 2;
    }
    const Engine engine = startEngine();
    const Frames images{engine, makeStaging(engine, VkDeviceSize(width) * height * 16),
                        makeTexture(engine, VK_FORMAT_R32_SFLOAT, width, height),
                        makeTexture(engine, VK_FORMAT_R32G32B32A32_SFLOAT, width, height)};
    const int result = run(images, argv[1]);
    destroy(engine, images.depth);
    destroy(engine, images.colour);
    destroy(engine, images.staging);
    stopEngine(engine);
    return result;
}
