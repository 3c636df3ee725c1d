// SPDX-License-Identifier: Apache-2.0
// A scene rendered frame by frame for a temporal pass to run on, and its ground truth.
#pragma once

#include "metrics.hpp"
#include "progress.hpp"
#include "renderer.hpp"

#include <vector>

namespace report {

struct RenderedFrame {
    harness::Image colour, depth, depthTest, motion, ids;
    glm::dvec2 jitterPx{0.0};
    reprise::CameraFrame camera;
};

// Frames of one sample sequence, kept on the GPU so that every variant reads the same ones.
// withIds keeps instance IDs and the depth attachment too, which only the velocity passes need.
std::vector<RenderedFrame> renderFrames(harness::Gpu& gpu, scenes::Renderer& renderer, uint32_t first,
                                        uint32_t count, reprise::JitterSequence jitter, bool withIds = false);

struct GroundTruth {
    std::vector<Picture> pictures; // per frame
    std::vector<FlipSide> flipSides;
};
GroundTruth renderGroundTruth(scenes::Renderer& renderer, uint32_t width, uint32_t height, uint32_t frames,
                              uint32_t samples, Progress& progress);

// A linear scene-referred RGBA image as a display-linear picture. NaN and infinity stay, for the caller to
// count.
Picture displayPicture(harness::Gpu& gpu, harness::Image& image);
// Of an image that the runtime owns, in SHADER_READ_ONLY_OPTIMAL.
harness::Image borrowed(const reprise::ImageRef& ref);

// sRGB-encoded PNG file of a display-linear picture.
std::vector<uint8_t> pngOf(const Picture& picture);

} // namespace report
