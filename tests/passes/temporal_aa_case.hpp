// SPDX-License-Identifier: Apache-2.0
// Random frames for temporal_aa, its execution and its comparison with the oracle.
#pragma once

#include "camera_case.hpp"

namespace passes {

struct TemporalAaFrame {
    Pixels colour, depth, velocity, history;
    oracle::CameraVelocity camera; // of MOTION_CAMERA, in place of velocity
    reprise::TemporalAaParameters parameters{};

    int width() const { return colour.width; }
    int height() const { return colour.height; }
};

// Channels of 2^-6 to 2^4, of 0 and 2^-10 to 65504, or of 0 and 65504 alone.
enum class Contrast { moderate, extreme, saturated };

// Every pixel has its own colour, motion (none, below a pixel, several pixels, out of the image) and depth;
// no two depths of a 4x4 block are equal, so that the closest fragment is one.
TemporalAaFrame randomFrame(int width, int height, uint64_t seed, Contrast contrast = Contrast::moderate);
// The same with cameras and jitter of randomCameraCase(), and surfaces and sky that they may see. With
// `behind` the previous camera looked the other way: without a guard most would be found in its image,
// mirrored.
TemporalAaFrame cameraFrame(const CameraKind& kind, int width, int height, uint64_t seed,
                            bool behind = false);
// currUv - prevUv of what the texel shows, as the variant finds it.
glm::dvec2 motionOf(const Variant& variant, const TemporalAaFrame& frame, int x, int y);
reprise::TemporalAaParameters parametersFor(int width, int height);

std::vector<Pixels> run(Pass& pass, const TemporalAaFrame& frame);

// The outputs of `variant` for the frame against the oracle.
Comparison compareWithOracle(const Variant& variant, const TemporalAaFrame& frame,
                             const std::vector<Pixels>& outputs);
// The same for a device whose coordinates and filter weights err by up to so much of a texel together.
Comparison compareWithOracle(const Variant& variant, const TemporalAaFrame& frame,
                             const std::vector<Pixels>& outputs, double coordinateErrorPx);
// Of a variant with MOTION_CAMERA against what it gives with the vectors `frame.velocity`, RG16F, instead.
Comparison compareWithVectors(const Variant& variant, const TemporalAaFrame& frame,
                              const std::vector<Pixels>& outputs, const std::vector<Pixels>& expected);

} // namespace passes
