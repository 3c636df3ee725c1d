// SPDX-License-Identifier: Apache-2.0
// The uniform buffers of the passes, from a frame's input.
#pragma once

#include "reprise/frame.hpp"
#include "reprise/pack_table.hpp"

namespace reprise {

CameraVelocityParameters cameraParameters(const FrameInput& input, const CameraFrame& previous,
                                          VkExtent2D extent, bool linearDepth);
ObjectVelocityParameters objectParameters(const ObjectDraw& object, const FrameInput& input,
                                          const CameraFrame& previous, VkExtent2D extent);
// historyFrames: frames since history was reset, 0 when it holds none.
// tuning.motionToUv is for the engine's own motion; that of the velocity passes is in UV.
TemporalAaParameters temporalParameters(const FrameInput& input, const CameraFrame& previous,
                                        const TaaTuning& tuning, VkExtent2D extent, uint64_t historyFrames,
                                        bool engineMotion);

// What the framework's passes are filled from, beside the frame's input.
struct CacheFrame {
    CameraFrame previous;
    VkExtent2D extent{}; // of the frame
    CacheSettings cache{}; // as planned
    bool historyValid = false, reversedDepth = false, linearDepth = false, engineMotion = false;
};
// The uniform buffer of a framework's pass. Errors: those of sunShadowParameters().
Result<std::vector<std::byte>> cacheParameters(const PlannedPass& planned, const FrameInput& input,
                                               const CacheFrame& frame);

} // namespace reprise
