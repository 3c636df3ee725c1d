// SPDX-License-Identifier: Apache-2.0
// Runs a frame plan: owns history and transient images, decides when history is valid, records the passes.
#pragma once

#include "reprise/camera.hpp"
#include "reprise/pass.hpp"
#include "reprise/plan.hpp"

#include <optional>

namespace reprise {

// A mesh that moved. Positions are 3 floats; skinned meshes add 4 × uint8 joints and 4 × float weights.
struct ObjectDraw {
    // Identity for skinned meshes: their palettes go to world.
    glm::mat4 objectToWorld{1.0f}, prevObjectToWorld{1.0f};
    VkBuffer positions = VK_NULL_HANDLE, joints = VK_NULL_HANDLE, weights = VK_NULL_HANDLE;
    VkBuffer indices = VK_NULL_HANDLE;
    VkDeviceSize positionsOffset = 0, jointsOffset = 0, weightsOffset = 0, indicesOffset = 0;
    VkBuffer palette = VK_NULL_HANDLE, prevPalette = VK_NULL_HANDLE; // float4x4 per joint
    VkIndexType indexType = VK_INDEX_TYPE_UINT32;
    uint32_t indexCount = 0;
};

struct TaaTuning {
    float feedbackMin = 0.88f, feedbackMax = 0.97f; // history weight; constant feedback uses feedbackMax
    bool rampFeedback = false; // history of n frames weighs at most n / (n + 1): after a reset, their mean
    float blurFromPx = 2.0f, blurToPx = 15.0f;      // trust 1 and trust 0 of the motion blur fallback
    glm::vec2 motionToUv{1.0f, 1.0f};               // scales gInVelocity to UV, curr - prev
};

// The numbers that a preset comes with.
TaaTuning tuningOf(const PresetInfo& preset);

struct FrameInput {
    uint64_t frameIndex = 0;                 // a gap to the previous call resets history
    CameraFrame camera;                      // unjittered
    glm::dvec2 jitterPx{0.0};                // the jitter that colour and depth were rendered with
    ImageRef colour, depth;                  // in SHADER_READ_ONLY_OPTIMAL
    std::optional<ImageRef> motion;          // with needs.engineWritesMotion; SHADER_READ_ONLY_OPTIMAL
    std::optional<ImageRef> depthAttachment; // with objectsMove: tested, not written; DEPTH_READ_ONLY_OPTIMAL
    std::span<const ObjectDraw> movingObjects;
    bool resetHistory = false; // camera cut
    std::optional<TaaTuning> tuning; // else that of the preset
};

struct FrameOutput {
    ImageRef colour; // in SHADER_READ_ONLY_OPTIMAL; valid until the next record(); can be copied from
    std::optional<ImageRef> motion; // likewise; none when nothing moves
    bool historyWasReset = false;
    std::string_view resetReason; // "first frame", "frame gap", "resize", "request" or empty
};

class FrameRecorder {
public:
    struct CreateInfo {
        SceneNeeds needs;
        Settings settings;
        Extent extent;
        VkFormat colourFormat = VK_FORMAT_R16G16B16A16_SFLOAT; // of history and output
        VkFormat depthFormat = VK_FORMAT_D32_SFLOAT;           // of FrameInput::depthAttachment
        uint32_t framesInFlight = 2;
    };
    // The table must outlive the recorder; the presets are those of the generated table.
    static Result<FrameRecorder> create(const Device& device, std::span<const PassInfo> passes,
                                        const SpirvSource& spirv, const CreateInfo& info);
    FrameRecorder(FrameRecorder&&) noexcept;
    FrameRecorder& operator=(FrameRecorder&&) noexcept;
    ~FrameRecorder(); // the caller has waited until the GPU no longer uses it

    // New extent: images are made anew and history is reset. The GPU must be idle with the old ones.
    Result<void> resize(Extent extent);
    // Records every pass of the plan into `commands`. The caller has waited until the GPU is done with the
    // call `framesInFlight` before this one. On failure nothing has been recorded and history is unchanged.
    Result<FrameOutput> record(VkCommandBuffer commands, const FrameInput& input);

    const FramePlan& plan() const;

private:
    struct State;
    explicit FrameRecorder(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace reprise
