// SPDX-License-Identifier: Apache-2.0
// Products of matrices are made in double precision: in single precision a camera far from the origin
// jitters.
#include "frame_parameters.hpp"

#include <algorithm>
#include <cstring>

namespace reprise {
namespace {

template <size_t count> void store(float (&target)[count], const glm::mat4& matrix) {
    static_assert(sizeof(target) == sizeof(matrix));
    std::memcpy(target, &matrix, sizeof(matrix));
}

template <size_t count, class Vector> void store(float (&target)[count], const Vector& vector) {
    static_assert(count == static_cast<size_t>(Vector::length()));
    for (size_t i = 0; i < count; ++i)
        target[i] = static_cast<float>(vector[static_cast<int>(i)]);
}

glm::dvec4 sizeOf(VkExtent2D extent) {
    return {extent.width, extent.height, 1.0 / extent.width, 1.0 / extent.height};
}

} // namespace

CameraVelocityParameters cameraParameters(const FrameInput& input, const CameraFrame& previous,
                                          VkExtent2D extent, bool linearDepth) {
    CameraVelocityParameters parameters{};
    const auto toPrevious =
        linearDepth ? viewToPreviousClip(input.camera, previous) : reprojection(input.camera, previous);
    store(parameters.gReprojection, glm::mat4(toPrevious));
    store(parameters.gViewRay, viewRay(input.camera.viewToClip));
    store(parameters.gOutputSize, sizeOf(extent));
    store(parameters.gJitterUv, input.jitterPx / glm::dvec2(extent.width, extent.height));
    return parameters;
}

ObjectVelocityParameters objectParameters(const ObjectDraw& object, const FrameInput& input,
                                          const CameraFrame& previous, VkExtent2D extent) {
    ObjectVelocityParameters parameters{};
    const auto toClip = [](const CameraFrame& camera, const glm::mat4& toWorld) {
        return glm::mat4(camera.viewToClip * camera.worldToView * glm::dmat4(toWorld));
    };
    store(parameters.gObjectToClip, toClip(input.camera, object.objectToWorld));
    store(parameters.gPrevObjectToClip, toClip(previous, object.prevObjectToWorld));
    store(parameters.gJitterNdc, input.jitterPx * glm::dvec2(2.0 / extent.width, -2.0 / extent.height));
    return parameters;
}

TaaTuning tuningOf(const PresetInfo& preset) {
    TaaTuning tuning;
    tuning.feedbackMin = preset.feedbackMin;
    tuning.feedbackMax = preset.feedbackMax;
    tuning.rampFeedback = preset.rampFeedback;
    return tuning;
}

TemporalAaParameters temporalParameters(const FrameInput& input, const TaaTuning& tuning, VkExtent2D extent,
                                        uint64_t historyFrames, bool engineMotion) {
    const auto frames = static_cast<float>(historyFrames);
    const float most = tuning.rampFeedback ? frames / (frames + 1.0f) : 1.0f;
    TemporalAaParameters parameters{};
    store(parameters.gOutputSize, sizeOf(extent));
    store(parameters.gJitterPx, input.jitterPx);
    store(parameters.gMotionToUv, engineMotion ? tuning.motionToUv : glm::vec2(1.0f));
    parameters.gHistoryValid = historyFrames > 0 ? 1.0f : 0.0f;
    parameters.gFeedbackMin = std::min(tuning.feedbackMin, most);
    parameters.gFeedbackMax = std::min(tuning.feedbackMax, most);
    parameters.gBlurFromPx = tuning.blurFromPx;
    parameters.gBlurToPx = tuning.blurToPx;
    return parameters;
}

} // namespace reprise
