// SPDX-License-Identifier: Apache-2.0
#include "viewport_shift.hpp"

#include <string_view>
#include <vector>

namespace passes {

namespace {

float shiftPx = 0.0f;
PFN_vkGetDeviceProcAddr nextGetDeviceProcAddr = nullptr;
PFN_vkCmdSetViewport nextCmdSetViewport = nullptr;

void VKAPI_CALL cmdSetViewport(VkCommandBuffer commands, uint32_t first, uint32_t count,
                               const VkViewport* viewports) {
    std::vector<VkViewport> moved(viewports, viewports + count);
    for (VkViewport& viewport : moved) {
        viewport.x += shiftPx;
        viewport.y += shiftPx;
    }
    nextCmdSetViewport(commands, first, count, moved.data());
}

PFN_vkVoidFunction VKAPI_CALL getDeviceProcAddr(VkDevice device, const char* name) {
    const PFN_vkVoidFunction found = nextGetDeviceProcAddr(device, name);
    if (std::string_view(name) != "vkCmdSetViewport") return found;
    nextCmdSetViewport = reinterpret_cast<PFN_vkCmdSetViewport>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(cmdSetViewport);
}

} // namespace

ViewportShift::ViewportShift(float px) {
    shiftPx = px;
}

ViewportShift::~ViewportShift() {
    shiftPx = 0.0f;
}

PFN_vkVoidFunction VKAPI_CALL getInstanceProcAddrForShift(VkInstance instance, const char* name) {
    const PFN_vkVoidFunction found = vkGetInstanceProcAddr(instance, name);
    if (std::string_view(name) != "vkGetDeviceProcAddr") return found;
    nextGetDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(found);
    return reinterpret_cast<PFN_vkVoidFunction>(getDeviceProcAddr);
}

} // namespace passes
