// SPDX-License-Identifier: Apache-2.0
#include "handles.hpp"
#include "reprise/pass.hpp"

namespace reprise {

const ImageState undefinedState{VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
const ImageState sampledState{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT |
                                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                              VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
const ImageState attachmentState{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                 VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT |
                                     VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                                 VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
const ImageState storageState{VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT,
                              VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                              VK_IMAGE_LAYOUT_GENERAL};

namespace {

VkImageMemoryBarrier2 barrierOf(const ImageTransition& transition) {
    auto barrier = structure<VkImageMemoryBarrier2>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2);
    barrier.srcStageMask = transition.from.stage;
    barrier.srcAccessMask = transition.from.access;
    barrier.dstStageMask = transition.to.stage;
    barrier.dstAccessMask = transition.to.access;
    barrier.oldLayout = transition.from.layout;
    barrier.newLayout = transition.to.layout;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = transition.image.image;
    barrier.subresourceRange = {transition.image.aspect, 0, 1, 0, 1};
    return barrier;
}

} // namespace

void transition(const Device& device, VkCommandBuffer commands,
                std::span<const ImageTransition> transitions) {
    if (transitions.empty()) return;
    std::vector<VkImageMemoryBarrier2> barriers;
    barriers.reserve(transitions.size());
    for (const ImageTransition& each : transitions)
        barriers.push_back(barrierOf(each));
    auto dependency = structure<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
    dependency.imageMemoryBarrierCount = static_cast<uint32_t>(barriers.size());
    dependency.pImageMemoryBarriers = barriers.data();
    device.vk->CmdPipelineBarrier2(commands, &dependency);
}

void transition(const Device& device, VkCommandBuffer commands, const ImageRef& image, const ImageState& from,
                const ImageState& to) {
    const ImageTransition one[] = {{image, from, to}};
    transition(device, commands, one);
}

} // namespace reprise
