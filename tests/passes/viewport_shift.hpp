// SPDX-License-Identifier: Apache-2.0
// Moves the viewport under the runtime's feet: the tests' device takes the runtime's calls through functions
// that can be told to. Direct3D 9 has its pixel centres at whole numbers of the viewport where Vulkan has
// them at halves, so a viewport that lies half a pixel further right and down rasterises as Direct3D 9 does.
#pragma once

#include <vulkan/vulkan.h>

namespace passes {

inline constexpr float d3d9Shift = 0.5f;

// While it lives, every viewport lies `px` further right and down.
class ViewportShift {
public:
    explicit ViewportShift(float px);
    ~ViewportShift();
    ViewportShift(const ViewportShift&) = delete;
    ViewportShift& operator=(const ViewportShift&) = delete;
};

// For harness::DeviceOptions.
PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddrForShift(VkInstance instance, const char* name);

} // namespace passes
