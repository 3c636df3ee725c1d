// SPDX-License-Identifier: Apache-2.0
// A headless Vulkan device with images, transfers and timestamps, for the tests and the report.
// Failures are std::runtime_error with one sentence: this is a tool's code, not the runtime's.
#pragma once

#include "reprise/device.hpp"
#include "reprise/pass.hpp"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace harness {

struct DeviceOptions {
    std::string device; // substring of the name, or an index; empty: a discrete GPU if any, else the first
    bool validation = false; // Khronos layer with synchronization validation; messages are collected
    // What the runtime loads its functions through; null: the loader's. A test may stand between the two.
    PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
};

struct Image {
    reprise::ImageRef ref;
    uint32_t samples = 1;
    reprise::ImageState state{};  // tracked by the helpers below
    std::shared_ptr<void> memory; // keeps image, view and memory alive
};

struct Buffer {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize bytes = 0;
    std::byte* mapped = nullptr; // host visible and coherent
    std::shared_ptr<void> memory;
};

class Gpu {
public:
    explicit Gpu(const DeviceOptions& options = {});
    ~Gpu();
    Gpu(const Gpu&) = delete;
    Gpu& operator=(const Gpu&) = delete;

    const reprise::Device& device() const;
    VkDevice handle() const;
    VkQueue queue() const;
    std::string name() const, driver() const, type() const; // type: cpu, discrete, integrated, virtual, other
    // Every validation message since the last call; empty without validation.
    std::vector<std::string> takeValidationMessages();

    // usage: 0 takes sampled, storage if the format allows, colour or depth attachment, transfer both ways.
    Image image(VkFormat format, uint32_t width, uint32_t height, uint32_t samples = 1,
                VkImageUsageFlags usage = 0);
    Buffer buffer(VkDeviceSize bytes, VkBufferUsageFlags usage);

    // Texels as the format stores them, rows top to bottom, no padding. Leaves the image in sampledState.
    void upload(Image& image, std::span<const std::byte> texels);
    std::vector<std::byte> download(Image& image); // leaves it in the state that it had
    // Channels as float, converted from or to the format (r8, rg8, rgba8 unorm, r16f, rg16f, rgba16f, r32f,
    // rg32f, rgba32f, d32f; uint formats through download()). `floats` has channels × width × height values.
    void uploadFloats(Image& image, std::span<const float> floats);
    std::vector<float> downloadFloats(Image& image);

    // Moves the image from its tracked state; several in one barrier.
    void use(VkCommandBuffer commands, Image& image, const reprise::ImageState& to);
    struct Use {
        Image* image;
        reprise::ImageState to;
    };
    void use(VkCommandBuffer commands, std::span<const Use> uses);

    // Records, submits and waits.
    void run(const std::function<void(VkCommandBuffer)>& record);

    // With room for one more pass in the submission that is being recorded, or the next. All passes share it,
    // as those of an engine's frame do. Valid until the next call.
    reprise::FrameArena& arena();

    // GPU time in milliseconds of each section, one submission; sections[i] is called between two timestamps
    // with full barriers around them, so that nothing overlaps.
    std::vector<double> time(std::span<const std::function<void(VkCommandBuffer)>> sections);

private:
    struct State;
    std::unique_ptr<State> state_;
};

// States beside those of reprise/pass.hpp; depthReadState is that of FrameInput::depthAttachment.
extern const reprise::ImageState transferSourceState, transferTargetState, depthAttachmentState,
    depthReadState;

uint32_t channelCount(VkFormat format);
VkFormat formatByName(std::string_view name); // r32f, rg16f, rgba16f, rgba8 ...; throws on an unknown one
uint16_t floatToHalf(float value);            // round to nearest even, NaN and infinity kept
float halfToFloat(uint16_t bits);

// One pass with its pipeline, run over images by name. Handles arena and transitions.
class PassRunner {
public:
    PassRunner(Gpu& gpu, const reprise::Variant& variant, reprise::Stage stage,
               std::span<const uint32_t> spirv, std::span<const uint32_t> fullscreenVertex,
               std::span<const VkFormat> outputFormats);
    struct Binding {
        std::string_view name;
        Image* image;
    };
    // Records with transitions of every image to the state it is needed in. Callable many times in one
    // submission.
    void record(VkCommandBuffer commands, std::span<const Binding> images,
                std::span<const std::byte> parameters, std::span<const reprise::NamedBuffer> buffers = {});
    const reprise::PassPipeline& pipeline() const;

private:
    struct State;
    std::shared_ptr<State> state_;
};

} // namespace harness
