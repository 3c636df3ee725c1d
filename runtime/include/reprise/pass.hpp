// SPDX-License-Identifier: Apache-2.0
// One pass as a Vulkan pipeline, and how to record it. The frame recorder is built on it; an engine with a
// frame graph of its own can use it alone.
#pragma once

#include "reprise/device.hpp"
#include "reprise/pack.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace reprise {

// Descriptors and parameter memory for the passes recorded in one frame slot. The memory is the device's own
// where the host can write that, else the host's. Not thread safe.
class FrameArena {
public:
    // slots: frames in flight. passes: most of them in one frame. parameterBytes: their parameters, summed.
    static Result<FrameArena> create(const Device& device, uint32_t slots, uint32_t passes,
                                     uint32_t parameterBytes);
    FrameArena(FrameArena&&) noexcept;
    FrameArena& operator=(FrameArena&&) noexcept;
    ~FrameArena();

    // Takes slot (frame index mod slots) afresh. The caller has waited until the GPU is done with it.
    Result<void> begin(uint32_t slot);

private:
    friend struct ArenaAccess; // the runtime's own sources
    struct State;
    explicit FrameArena(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

struct NamedImage {
    std::string_view name; // resource name of the table: gInColour, gOutHistory
    ImageRef image;
};

struct NamedBuffer {
    std::string_view name;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize offset = 0;
    VkDeviceSize bytes = VK_WHOLE_SIZE;
};

class PassPipeline {
public:
    // stage: fragment (drawn by `fullscreenVertex`, the SPIR-V of the pass `fullscreen`) or compute.
    // outputFormats: one per existing output in table order; ignored by compute.
    // Errors: missingFeature, unsupportedFormat (with the format's and the output's name), badShader.
    static Result<PassPipeline> create(const Device& device, const Variant& variant, Stage stage,
                                       std::span<const uint32_t> spirv,
                                       std::span<const uint32_t> fullscreenVertex,
                                       std::span<const VkFormat> outputFormats);
    PassPipeline(PassPipeline&&) noexcept;
    PassPipeline& operator=(PassPipeline&&) noexcept;
    ~PassPipeline();

    // Records the pass over the whole extent of its first output. No barriers: inputs are in
    // SHADER_READ_ONLY_OPTIMAL; outputs in COLOR_ATTACHMENT_OPTIMAL (fragment) or GENERAL (compute).
    // Errors: missingInput naming the resource, zeroExtent, invalidArgument (parameter size, extents).
    Result<void> record(VkCommandBuffer commands, FrameArena& arena, std::span<const NamedImage> images,
                        std::span<const NamedBuffer> buffers, std::span<const std::byte> parameters) const;

    Stage stage() const;
    const Variant& variant() const;
    // Bindings that the module really uses, from its own decorations.
    std::span<const BindingInfo> bindings() const;

private:
    friend struct PassAccess; // the runtime's own sources
    struct State;
    explicit PassPipeline(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

// One image barrier with synchronization2. The states that passes take and leave are the constants below.
struct ImageState {
    VkPipelineStageFlags2 stage;
    VkAccessFlags2 access;
    VkImageLayout layout;
};
extern const ImageState undefinedState, sampledState, attachmentState, storageState;
void transition(const Device& device, VkCommandBuffer commands, const ImageRef& image, const ImageState& from,
                const ImageState& to);
// Several images in one barrier, which a GPU waits for once.
struct ImageTransition {
    ImageRef image;
    ImageState from, to;
};
void transition(const Device& device, VkCommandBuffer commands, std::span<const ImageTransition> transitions);

} // namespace reprise
