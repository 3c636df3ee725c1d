// SPDX-License-Identifier: Apache-2.0
// Runs a frame plan: owns history and transient images, decides when history is valid, records the passes.
#pragma once

#include "reprise/camera.hpp"
#include "reprise/pass.hpp"
#include "reprise/plan.hpp"
#include "reprise/sun_shadow.hpp"

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
    float blurFromPx = 2.0f, blurToPx = 15.0f; // trust 1 and trust 0 of the motion blur fallback
    glm::vec2 motionToUv{1.0f, 1.0f};          // scales gInVelocity to UV, curr - prev
};

// The numbers that a preset comes with.
TaaTuning tuningOf(const PresetInfo& preset);

// Of scalable_obscurance and its filter; docs/scalable_obscurance.md says what each does.
struct ObscuranceTuning {
    float intensity = 1.0f;
    glm::vec2 bias{0.01f, 0.001f};      // metres and metres a metre of depth
    uint32_t rotations = 3;             // frames after which the spiral repeats, 1 to 16
    float maxWeight = 0.9f;             // most weight of history, up to 15/16
    float movingWeight = 0.6f;          // the same in motion, up to maxWeight
    float movingPx = 0.25f;             // pixels a frame, above 0: from there on movingWeight
    glm::vec2 depthRange{0.05f, 0.02f}; // of the filter, metres and metres a metre of depth
};

// Of the framework; docs/ambient_occlusion.md says what each does.
struct CacheTuning {
    float radius = 1.0f;                    // metres, of what occludes
    glm::vec2 bias{0.005f, 0.0005f};        // of occlusion, metres and metres a metre of depth
    uint32_t subsets = 8;                   // frames after which the sample patterns repeat, 1 to 16
    glm::vec2 missThreshold{0.05f, 0.03f};  // metres and metres a metre of depth: another surface
    float convergenceTime = 2.0f;           // confidence of equal depths
    float maxWeight = 0.95f;                // most weight of history, [0, 1)
    glm::vec2 speedPx{32.0f, 128.0f};       // coarse texels a frame: history fades, history has no weight
    glm::vec2 change{1.0f, 0.05f};          // deviations and difference that history may differ by
    glm::vec2 depthAmplitude{0.0f, 120.0f}; // of the filter, 1 / metres and 1 / share of the depth
    float converged = 4.0f;                 // frames from which on the history counts as converged
    float maxSmoothing = 4.0f;  // times the document's weight of the neighbours, without history, 1 to 16
    float minSmoothing = 0.05f; // the same with a converged history, 0 to 1: 1 is the document's, 0 no filter
    float normalContrast = 8.0f; // of upsampling by normals: exponent of the cosine
    SunShadowTuning shadow;
    ObscuranceTuning obscurance;
};

struct FrameInput {
    uint64_t frameIndex = 0;  // a gap to the previous call resets history
    CameraFrame camera;       // unjittered
    glm::dvec2 jitterPx{0.0}; // the jitter that colour and depth were rendered with
    // In SHADER_READ_ONLY_OPTIMAL; colour with antiAliasing and without combinesLighting.
    ImageRef colour, depth;
    std::optional<ImageRef> motion; // with needs.engineWritesMotion; SHADER_READ_ONLY_OPTIMAL
    // With needs.sunShadows: cascades side by side, of any extent, R32F or D32F; CacheSettings::cascades of
    // them.
    std::optional<ImageRef> shadowMap;
    std::span<const ShadowCascade> cascades;
    // With needs.cachedChannels, of ceil(extent / ratio) texels: RG16F, one value and its linear depth in
    // metres, or two; RGBA16F, three or four; of three the fourth must stay the same, such as 0.
    std::optional<ImageRef> fresh;
    // With needs.normals: view space, unit, towards the camera; RGBA16F at the frame's extent.
    std::optional<ImageRef> normal;
    // With needs.combinesLighting, linear and already multiplied by the albedo, RGBA16F: the indirect light,
    // with occlusion or a cached value; the sun's as if nothing stood before it, with sunShadows; the rest,
    // with needs.otherLight.
    std::optional<ImageRef> ambientLight, sunLight, otherLight;
    std::optional<ImageRef> depthAttachment; // with objectsMove: tested, not written; DEPTH_READ_ONLY_OPTIMAL
    std::span<const ObjectDraw> movingObjects;
    bool resetHistory = false;       // camera cut
    std::optional<TaaTuning> tuning; // else that of the preset
    CacheTuning cache;
};

struct FrameOutput {
    // In SHADER_READ_ONLY_OPTIMAL; valid until the next record(); can be copied from. Colour without
    // anti-aliasing has no image.
    ImageRef colour;
    // At full resolution: in red visibility by occluders near by, or the sun's, or the value; of both, the
    // sun's in green. RG8 of a packed cache, else RG16F, or at a ratio of 1 as the last step writes it.
    std::optional<ImageRef> lighting;
    std::optional<ImageRef> lit; // with needs.combinesLighting: the light put together, before anti-aliasing
    // Likewise; none where the plan makes none: nothing moves, or the camera alone and MOTION is camera.
    std::optional<ImageRef> motion;
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
