// SPDX-License-Identifier: Apache-2.0
// The images of a plan in device memory, shared as the plan says.
#pragma once

#include "handles.hpp"
#include "reprise/pass.hpp"
#include "reprise/plan.hpp"

#include <array>

namespace reprise {

struct OwnedImage {
    Unique<VkImage> image;
    Unique<VkImageView> view;
    ImageRef ref;
};

struct FrameImages {
    std::vector<Unique<VkDeviceMemory>> memory; // declared first: freed after the images in it
    // One entry for each image of the plan: history has two, the engine's none.
    std::vector<std::array<OwnedImage, 2>> images;
};

// What the passes of the plan read from an image asks of its format.
VkFormatFeatureFlags readFeatures(const FramePlan& plan, int image);

// Errors: unsupportedFormat naming image and format, outOfMemory.
Result<FrameImages> makeFrameImages(const Device& device, const FramePlan& plan);

} // namespace reprise
