// SPDX-License-Identifier: Apache-2.0
#include "plan_images.hpp"

#include "reprise/format.hpp"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

constexpr std::string_view inPrefix = "gIn", outPrefix = "gOut";

struct Layout {
    FramePlan& plan;
    bool engineWritesMotion;
    std::string_view colourFormat;
    Extent extent;
};

int find(const FramePlan& plan, std::string_view name) {
    const auto found = std::ranges::find(plan.images, name, &PlannedImage::name);
    return found == plan.images.end() ? -1 : static_cast<int>(found - plan.images.begin());
}

PlannedImage& at(FramePlan& plan, int image) {
    return plan.images[static_cast<size_t>(image)];
}

uint32_t scaled(uint32_t texels, float scale) {
    return std::max(1u, static_cast<uint32_t>(std::ceil(static_cast<float>(texels) * scale)));
}

int add(const Layout& layout, const ImageInfo& info, std::string name, std::string_view format, int pass) {
    PlannedImage image;
    image.name = std::move(name);
    image.format = format;
    image.extent = {scaled(layout.extent.width, info.scale * info.widthScale),
                    scaled(layout.extent.height, info.scale)};
    image.firstPass = image.lastPass = pass;
    image.bytes = uint64_t(texelBytes(format)) * image.extent.width * image.extent.height;
    layout.plan.images.push_back(std::move(image));
    return static_cast<int>(layout.plan.images.size()) - 1;
}

// What an earlier pass wrote, or else the engine's. Motion that neither gives is zero everywhere.
int addInput(const Layout& layout, const ImageInfo& input, int pass) {
    const std::string written = writtenName(input.name);
    int image = find(layout.plan, written);
    if (image < 0) image = find(layout.plan, input.sameAs.empty() ? input.name : input.sameAs);
    if (image < 0) {
        const bool zero = written == velocityImage && !layout.engineWritesMotion;
        image = add(layout, input, zero ? written : std::string(input.name), input.format, pass);
        at(layout.plan, image).external = !zero;
        at(layout.plan, image).cleared = zero;
    }
    at(layout.plan, image).lastPass = pass;
    return image;
}

int addOutput(const Layout& layout, const PassInfo& pass, const ImageInfo& output, int index) {
    int image = find(layout.plan, output.name);
    if (image < 0) {
        const bool chosen = pass.name == temporalPass && !layout.colourFormat.empty();
        image = add(layout, output, std::string(output.name), chosen ? layout.colourFormat : output.format,
                    index);
        at(layout.plan, image).cleared = !pass.fullscreen;
    }
    at(layout.plan, image).lastPass = index; // drawn over, if it was there before
    return image;
}

int keepHistory(FramePlan& plan, std::string_view output) {
    const int image = find(plan, output);
    if (image >= 0) at(plan, image).history = true;
    return image;
}

// Inputs come first, and history last: it is an output of the same pass.
void addPass(const Layout& layout, int index) {
    PlannedPass& pass = layout.plan.passes[static_cast<size_t>(index)];
    const PassInfo& info = *pass.variant.pass;
    pass.readImages.assign(pass.reads.size(), -1);
    pass.writeImages.clear();
    size_t read = 0;
    for (const ImageInfo& input : info.inputs) {
        if (!exists(pass.variant, input)) continue;
        if (isImage(input) && !isHistory(input)) pass.readImages[read] = addInput(layout, input, index);
        ++read;
    }
    for (const ImageInfo& output : info.outputs)
        if (exists(pass.variant, output)) pass.writeImages.push_back(addOutput(layout, info, output, index));
    read = 0;
    for (const ImageInfo& input : info.inputs) {
        if (!exists(pass.variant, input)) continue;
        if (isHistory(input)) pass.readImages[read] = keepHistory(layout.plan, input.history);
        ++read;
    }
}

// The engine may read motion after the frame is recorded.
void keepMotion(FramePlan& plan) {
    if (const int image = find(plan, velocityImage); image >= 0)
        at(plan, image).lastPass = static_cast<int>(plan.passes.size()) - 1;
}

} // namespace

bool isHistory(const ImageInfo& input) {
    return !input.history.empty();
}
bool isImage(const ImageInfo& info) {
    return !info.format.empty();
}

std::string writtenName(std::string_view input) {
    return std::string(outPrefix) + std::string(input.substr(inPrefix.size()));
}

void planImages(FramePlan& plan, bool engineWritesMotion, std::string_view colourFormat, Extent extent) {
    plan.images.clear();
    const Layout layout{plan, engineWritesMotion, colourFormat, extent};
    for (int pass = 0; pass < static_cast<int>(plan.passes.size()); ++pass)
        addPass(layout, pass);
    keepMotion(plan);
    shareMemory(plan);
}

void shareMemory(FramePlan& plan) {
    struct Block {
        uint64_t bytes;
        std::vector<const PlannedImage*> images;
    };
    std::vector<PlannedImage*> transients;
    plan.bytes = plan.bytesWithoutAliasing = 0;
    for (PlannedImage& image : plan.images) {
        if (image.external) continue;
        plan.bytesWithoutAliasing += image.bytes * (image.history ? 2 : 1);
        if (image.history)
            plan.bytes += 2 * image.bytes;
        else
            transients.push_back(&image);
    }
    std::ranges::stable_sort(transients, std::greater<>(), &PlannedImage::bytes);
    std::vector<Block> blocks;
    for (PlannedImage* image : transients) {
        const auto meets = [&](const PlannedImage* other) {
            return image->firstPass <= other->lastPass && other->firstPass <= image->lastPass;
        };
        auto block = std::ranges::find_if(
            blocks, [&](const Block& each) { return std::ranges::none_of(each.images, meets); });
        if (block == blocks.end()) block = blocks.insert(blocks.end(), {image->bytes, {}});
        block->images.push_back(image);
        image->memory = static_cast<int>(block - blocks.begin());
    }
    for (const Block& block : blocks)
        plan.bytes += block.bytes;
}

} // namespace reprise
