// SPDX-License-Identifier: Apache-2.0
// What a technique of the pack converges to: its own pass with its most samples, averaged over the whole
// cycle of its patterns, without history, filter or upsampling. Against the ground truth it has the error of
// the method alone; against it a technique has the error of sampling alone.
#pragma once

#include "sequence.hpp"
#include "shaders.hpp"
#include "stopwatch.hpp"

#include <functional>
#include <vector>

namespace report {

// One value per texel of an image at the frame's resolution or a coarse one, rows top to bottom.
struct Converged {
    uint32_t width = 0, height = 0;
    std::vector<float> visibility;  // [0,1]
    std::vector<float> linearDepth; // metres, 65504 in the sky; what the pass read
};

struct OcclusionEstimate {
    // Texels of the frame per texel along an axis: 1, or 2 or 4 through depth_downsample. That of a coarse
    // resolution, upsampled, tells what upsampling costs.
    uint32_t ratio = 1;
    double radius = 1.0;          // metres, above 0
    glm::dvec2 bias{0.01, 0.002}; // gOcclusionBias of the pass: metres, metres per metre of depth
    double skyDepth = 0.0;        // metres, a little less than the far plane
    reprise::Stage stage = reprise::Stage::fragment;
};

// ambient_occlusion with 32 samples, mean of 16 patterns, of a frame rendered without jitter and with
// standard depth. Throws a sentence.
Converged convergedOcclusion(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                             const OcclusionEstimate& estimate);

struct ObscuranceEstimate {
    double radius = 1.0;          // metres, above 0
    double intensity = 1.0;       // gIntensity of the pass
    glm::dvec2 bias{0.01, 0.001}; // gBias of the pass: metres, metres per metre of depth
    double skyDepth = 0.0;        // metres, a little less than the far plane
    reprise::Stage stage = reprise::Stage::fragment;
};

// scalable_obscurance at full resolution with 33 taps, mean of its 16 rotations: a spiral of 528 taps a
// pixel, which stops at black as a whole, not frame by frame. Of a frame rendered without jitter and with
// standard depth. Throws a sentence.
Converged convergedObscurance(harness::Gpu& gpu, Shaders& shaders, RenderedFrame& frame,
                              const ObscuranceEstimate& estimate);

// gViewRay of a pass that runs at a coarse resolution, whose last texels reach beyond a frame of odd size.
glm::dvec4 coarseViewRay(const reprise::CameraFrame& camera, VkExtent2D frame, uint32_t ratio);

// A pass run once for each frame index from 0 to `count`, whose parameters setFrame(index, data) sets, and
// the mean of the first channel of its only output. The converged form of a technique with a pattern per
// frame is one call of it.
std::vector<float> meanOverCycle(harness::Gpu& gpu, Shaders& shaders, const reprise::Variant& variant,
                                 reprise::Stage stage, PassData data, uint32_t width, uint32_t height,
                                 uint32_t count, const std::function<void(uint32_t, PassData&)>& setFrame);

} // namespace report
