// SPDX-License-Identifier: Apache-2.0
// The Vulkan functions that the runtime calls, loaded through the engine's vkGetInstanceProcAddr: no link to
// a loader.
#pragma once

#include <vulkan/vulkan.h>

// Names without their vk prefix: each is declared, and loaded, once from these lists.
#define REPRISE_INSTANCE_FUNCTIONS(X)                                                                        \
    X(GetDeviceProcAddr)                                                                                     \
    X(GetPhysicalDeviceFormatProperties)                                                                     \
    X(GetPhysicalDeviceMemoryProperties)                                                                     \
    X(GetPhysicalDeviceProperties)                                                                           \
    X(GetPhysicalDeviceProperties2)

#define REPRISE_DEVICE_FUNCTIONS(X)                                                                          \
    X(AllocateDescriptorSets)                                                                                \
    X(AllocateMemory)                                                                                        \
    X(BindBufferMemory)                                                                                      \
    X(BindImageMemory)                                                                                       \
    X(CmdBeginRendering)                                                                                     \
    X(CmdBindDescriptorSets)                                                                                 \
    X(CmdBindIndexBuffer)                                                                                    \
    X(CmdBindPipeline)                                                                                       \
    X(CmdBindVertexBuffers)                                                                                  \
    X(CmdClearColorImage)                                                                                    \
    X(CmdDispatch)                                                                                           \
    X(CmdDraw)                                                                                               \
    X(CmdDrawIndexed)                                                                                        \
    X(CmdEndRendering)                                                                                       \
    X(CmdPipelineBarrier2)                                                                                   \
    X(CmdSetScissor)                                                                                         \
    X(CmdSetViewport)                                                                                        \
    X(CreateBuffer)                                                                                          \
    X(CreateComputePipelines)                                                                                \
    X(CreateDescriptorPool)                                                                                  \
    X(CreateDescriptorSetLayout)                                                                             \
    X(CreateGraphicsPipelines)                                                                               \
    X(CreateImage)                                                                                           \
    X(CreateImageView)                                                                                       \
    X(CreatePipelineLayout)                                                                                  \
    X(CreateSampler)                                                                                         \
    X(CreateShaderModule)                                                                                    \
    X(DestroyBuffer)                                                                                         \
    X(DestroyDescriptorPool)                                                                                 \
    X(DestroyDescriptorSetLayout)                                                                            \
    X(DestroyImage)                                                                                          \
    X(DestroyImageView)                                                                                      \
    X(DestroyPipeline)                                                                                       \
    X(DestroyPipelineLayout)                                                                                 \
    X(DestroySampler)                                                                                        \
    X(DestroyShaderModule)                                                                                   \
    X(FreeMemory)                                                                                            \
    X(GetBufferMemoryRequirements)                                                                           \
    X(GetImageMemoryRequirements)                                                                            \
    X(MapMemory)                                                                                             \
    X(ResetDescriptorPool)                                                                                   \
    X(UpdateDescriptorSets)

namespace reprise {

struct DeviceFunctions {
#define REPRISE_MEMBER(name) PFN_vk##name name = nullptr;
    REPRISE_INSTANCE_FUNCTIONS(REPRISE_MEMBER)
    REPRISE_DEVICE_FUNCTIONS(REPRISE_MEMBER)
#undef REPRISE_MEMBER
};

} // namespace reprise
