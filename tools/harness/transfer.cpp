// SPDX-License-Identifier: Apache-2.0
// Texels to the device and back.
#include "gpu_state.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace harness {

const reprise::ImageState transferSourceState{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                              VK_ACCESS_2_TRANSFER_READ_BIT,
                                              VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
const reprise::ImageState transferTargetState{VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                                              VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                              VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
namespace {
constexpr VkPipelineStageFlags2 depthStages =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
}
const reprise::ImageState depthAttachmentState{depthStages,
                                               VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT |
                                                   VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT,
                                               VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
const reprise::ImageState depthReadState{depthStages, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
                                         VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};

namespace {

using Kind = FormatInfo::Kind;

size_t texelCount(const Image& image) {
    return size_t(image.ref.extent.width) * image.ref.extent.height;
}

void checkSize(const char* what, size_t given, size_t needed) {
    if (given != needed)
        throw std::runtime_error("The image takes " + std::to_string(needed) + " " + what + ", but " +
                                 std::to_string(given) + " were given.");
}

VkBufferImageCopy wholeImage(const Image& image) {
    VkBufferImageCopy copy{};
    copy.imageSubresource = {image.ref.aspect, 0, 0, 1};
    copy.imageExtent = {image.ref.extent.width, image.ref.extent.height, 1};
    return copy;
}

bool writes(const reprise::ImageState& state) {
    constexpr VkAccessFlags2 any =
        VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT |
        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
        VK_ACCESS_2_SHADER_WRITE_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    return (state.access & any) != 0;
}

bool same(const reprise::ImageState& a, const reprise::ImageState& b) {
    return a.layout == b.layout && a.stage == b.stage && a.access == b.access;
}

void encode(Kind kind, float value, std::byte* target) {
    if (kind == Kind::single) {
        std::memcpy(target, &value, sizeof(value));
    } else if (kind == Kind::half) {
        const uint16_t bits = floatToHalf(value);
        std::memcpy(target, &bits, sizeof(bits));
    } else {
        const float unit = value > 0.0f ? std::min(value, 1.0f) : 0.0f; // NaN becomes 0
        *target = static_cast<std::byte>(std::lround(unit * 255.0f));
    }
}

float decode(Kind kind, const std::byte* source) {
    if (kind == Kind::unorm8) return static_cast<float>(*source) / 255.0f;
    float value = 0.0f;
    uint16_t bits = 0;
    if (kind == Kind::half) {
        std::memcpy(&bits, source, sizeof(bits));
        return halfToFloat(bits);
    }
    std::memcpy(&value, source, sizeof(value));
    return value;
}

const FormatInfo& floatFormat(const Image& image) {
    const FormatInfo& info = formatInfo(image.ref.format);
    if (info.kind == Kind::other)
        throw std::runtime_error("The format " + std::string(info.name) +
                                 " does not convert to float; use upload() and download().");
    return info;
}

} // namespace

void Gpu::use(VkCommandBuffer commands, Image& image, const reprise::ImageState& to) {
    const Use one[] = {{&image, to}};
    use(commands, one);
}

void Gpu::use(VkCommandBuffer commands, std::span<const Use> uses) {
    std::vector<reprise::ImageTransition> transitions;
    for (const Use& each : uses) {
        if (same(each.image->state, each.to) && !writes(each.to)) continue;
        transitions.push_back({each.image->ref, each.image->state, each.to});
        each.image->state = each.to;
    }
    reprise::transition(state_->device, commands, transitions);
}

void Gpu::upload(Image& image, std::span<const std::byte> texels) {
    checkSize("bytes", texels.size(), texelCount(image) * formatInfo(image.ref.format).texelBytes);
    const Buffer staging = buffer(texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(staging.mapped, texels.data(), texels.size());
    const VkBufferImageCopy copy = wholeImage(image);
    run([&](VkCommandBuffer commands) {
        use(commands, image, transferTargetState);
        vkCmdCopyBufferToImage(commands, staging.buffer, image.ref.image, image.state.layout, 1, &copy);
        use(commands, image, reprise::sampledState);
    });
}

std::vector<std::byte> Gpu::download(Image& image) {
    if (image.state.layout == VK_IMAGE_LAYOUT_UNDEFINED)
        throw std::runtime_error("The image has no content yet; write it before downloading it.");
    std::vector<std::byte> texels(texelCount(image) * formatInfo(image.ref.format).texelBytes);
    const Buffer staging = buffer(texels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    const VkBufferImageCopy copy = wholeImage(image);
    const reprise::ImageState before = image.state;
    run([&](VkCommandBuffer commands) {
        use(commands, image, transferSourceState);
        vkCmdCopyImageToBuffer(commands, image.ref.image, image.state.layout, staging.buffer, 1, &copy);
        use(commands, image, before);
        auto barrier = structure<VkMemoryBarrier2>(VK_STRUCTURE_TYPE_MEMORY_BARRIER_2);
        barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
        barrier.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
        barrier.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
        barrier.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
        auto dependency = structure<VkDependencyInfo>(VK_STRUCTURE_TYPE_DEPENDENCY_INFO);
        dependency.memoryBarrierCount = 1;
        dependency.pMemoryBarriers = &barrier;
        vkCmdPipelineBarrier2(commands, &dependency);
    });
    std::memcpy(texels.data(), staging.mapped, texels.size());
    return texels;
}

void Gpu::uploadFloats(Image& image, std::span<const float> floats) {
    const FormatInfo& info = floatFormat(image);
    checkSize("values", floats.size(), texelCount(image) * info.channels);
    const size_t step = info.texelBytes / info.channels;
    std::vector<std::byte> texels(floats.size() * step);
    for (size_t i = 0; i < floats.size(); ++i)
        encode(info.kind, floats[i], &texels[i * step]);
    upload(image, texels);
}

std::vector<float> Gpu::downloadFloats(Image& image) {
    const FormatInfo& info = floatFormat(image);
    const auto texels = download(image);
    const size_t step = info.texelBytes / info.channels;
    std::vector<float> floats(texels.size() / step);
    for (size_t i = 0; i < floats.size(); ++i)
        floats[i] = decode(info.kind, &texels[i * step]);
    return floats;
}

} // namespace harness
