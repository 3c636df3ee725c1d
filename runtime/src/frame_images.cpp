// SPDX-License-Identifier: Apache-2.0
#include "frame_images.hpp"

#include "pipeline.hpp"
#include "reprise/format.hpp"

#include <algorithm>

namespace reprise {
namespace {

struct Use {
    VkImageUsageFlags usage = 0;
    VkFormatFeatureFlags features = 0;
};

bool filtersLinearly(const PassInfo& pass, std::string_view input) {
    const std::string sampler = std::string(input) + "_sampler";
    return std::ranges::any_of(pass.bindings, [&](const BindingInfo& binding) {
        return binding.name == sampler && binding.kind == BindingKind::linearSampler;
    });
}

// Every image can be copied from, so that an engine may present or inspect it.
Use useOf(const FramePlan& plan, int image) {
    Use use{VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
            readFeatures(plan, image) | VK_FORMAT_FEATURE_TRANSFER_SRC_BIT};
    const auto add = [&](VkImageUsageFlags usage, VkFormatFeatureFlags features) {
        use.usage |= usage;
        use.features |= features;
    };
    for (const PlannedPass& pass : plan.passes) {
        if (std::ranges::find(pass.writeImages, image) == pass.writeImages.end()) continue;
        if (pass.stage == Stage::compute)
            add(VK_IMAGE_USAGE_STORAGE_BIT, VK_FORMAT_FEATURE_STORAGE_IMAGE_BIT);
        else
            add(VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT);
    }
    if (plan.images[static_cast<size_t>(image)].cleared)
        add(VK_IMAGE_USAGE_TRANSFER_DST_BIT, VK_FORMAT_FEATURE_TRANSFER_DST_BIT);
    return use;
}

Result<OwnedImage> makeImage(const Device& device, const PlannedImage& planned, const Use& use) {
    const VkFormat format = formatByName(planned.format).value_or(VK_FORMAT_UNDEFINED);
    if (auto checked = checkFormat(device, format, use.features, planned.name); !checked)
        return checked.error();
    const uint32_t limit = device.limits.maxImageDimension2D;
    if (planned.extent.width > limit || planned.extent.height > limit)
        return Error{ErrorCode::invalidArgument, "The image " + planned.name +
                                                     " is larger than the device's " + std::to_string(limit) +
                                                     " texels; ask for a smaller extent."};
    auto info = structure<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {planned.extent.width, planned.extent.height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = use.usage;
    auto image = make(device, device.vk->CreateImage, device.vk->DestroyImage, info,
                      "create the image " + planned.name);
    if (!image) return image.error();
    OwnedImage owned;
    owned.ref.image = image->get();
    owned.ref.format = format;
    owned.ref.extent = {planned.extent.width, planned.extent.height};
    owned.image = std::move(*image);
    return owned;
}

Result<void> makeView(const Device& device, OwnedImage& owned) {
    auto info = structure<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
    info.image = owned.ref.image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = owned.ref.format;
    info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    auto view =
        make(device, device.vk->CreateImageView, device.vk->DestroyImageView, info, "create an image view");
    if (!view) return view.error();
    owned.ref.view = view->get();
    owned.view = std::move(*view);
    return {};
}

// One allocation for images that are never alive together: each starts at its beginning.
Result<void> bindTogether(const Device& device, std::span<OwnedImage* const> images, FrameImages& made) {
    const DeviceFunctions& vk = *device.vk;
    VkMemoryRequirements shared{0, 1, ~0u};
    for (const OwnedImage* image : images) {
        VkMemoryRequirements own{};
        vk.GetImageMemoryRequirements(device.borrowed.device, image->ref.image, &own);
        shared.size = std::max(shared.size, own.size);
        shared.memoryTypeBits &= own.memoryTypeBits;
    }
    auto memory = allocate(device, shared, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, "allocate an image");
    if (!memory) memory = allocate(device, shared, 0, "allocate an image");
    if (!memory) return memory.error();
    for (OwnedImage* image : images) {
        const VkResult bound = vk.BindImageMemory(device.borrowed.device, image->ref.image, memory->get(), 0);
        if (bound != VK_SUCCESS) return vulkanError(bound, "bind an image");
        if (auto view = makeView(device, *image); !view) return view;
    }
    made.memory.push_back(std::move(*memory));
    return {};
}

} // namespace

VkFormatFeatureFlags readFeatures(const FramePlan& plan, int image) {
    VkFormatFeatureFlags features = VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
    for (const PlannedPass& pass : plan.passes)
        for (size_t i = 0; i < pass.reads.size(); ++i)
            if (pass.readImages[i] == image && filtersLinearly(*pass.variant.pass, pass.reads[i]))
                features |= VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    return features;
}

Result<FrameImages> makeFrameImages(const Device& device, const FramePlan& plan) {
    FrameImages made;
    made.images.resize(plan.images.size());
    std::vector<std::vector<OwnedImage*>> blocks;
    for (size_t i = 0; i < plan.images.size(); ++i) {
        const PlannedImage& planned = plan.images[i];
        if (planned.external) continue;
        for (size_t copy = 0; copy < (planned.history ? 2u : 1u); ++copy) {
            auto image = makeImage(device, planned, useOf(plan, static_cast<int>(i)));
            if (!image) return image.error();
            made.images[i][copy] = std::move(*image);
            if (planned.history) {
                OwnedImage* const alone[] = {&made.images[i][copy]};
                if (auto bound = bindTogether(device, alone, made); !bound) return bound.error();
            }
        }
        if (planned.memory < 0) continue;
        blocks.resize(std::max(blocks.size(), static_cast<size_t>(planned.memory) + 1));
        blocks[static_cast<size_t>(planned.memory)].push_back(&made.images[i][0]);
    }
    for (const auto& block : blocks)
        if (auto bound = bindTogether(device, block, made); !bound) return bound.error();
    return made;
}

} // namespace reprise
