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

uint32_t scaled(uint32_t texels, double scale) {
    return static_cast<uint32_t>(std::ceil(texels * scale));
}

// Coarse images follow the plan's ratio, in passes too that need not know it. A scale of 0 is an extent of
// the image's own.
int add(const Layout& layout, const ImageInfo& info, std::string name, std::string_view format, int pass) {
    const double scale =
        info.scale > 0.0f && info.scale < 1.0f ? 1.0 / layout.plan.cache.ratio : double(info.scale);
    PlannedImage image;
    image.name = std::move(name);
    image.format = format;
    image.extent = {scaled(layout.extent.width, scale * info.widthScale),
                    scaled(layout.extent.height, scale)};
    image.firstPass = image.lastPass = pass;
    image.bytes = uint64_t(texelBytes(format)) * image.extent.width * image.extent.height;
    layout.plan.images.push_back(std::move(image));
    return static_cast<int>(layout.plan.images.size()) - 1;
}

// What an earlier pass wrote, or else the engine's. Motion that neither gives is zero everywhere.
int addInput(const Layout& layout, const Variant& variant, const ImageInfo& input, int pass) {
    std::string_view name = input.sameAs.empty() ? input.name : input.sameAs;
    int image = -1;
    for (const std::string& source : sourcesOf(name, layout.plan.cache))
        if (image < 0) image = find(layout.plan, source);
    if (image < 0) image = find(layout.plan, name);
    if (image < 0) {
        const bool zero = name == "gInVelocity" && !layout.engineWritesMotion;
        // A value of the engine's that no step has touched is upsampled or combined as it is.
        const bool value = name == "gInFiltered" || name == "gInLighting";
        const std::string_view given = value ? "gInFresh" : name;
        image = add(layout, input, std::string(zero ? velocityImage : given), formatOf(variant, input), pass);
        at(layout.plan, image).external = !zero;
        at(layout.plan, image).cleared = zero;
    }
    at(layout.plan, image).lastPass = pass;
    return image;
}

int addOutput(const Layout& layout, const PlannedPass& pass, const ImageInfo& output, int index) {
    const PassInfo& info = *pass.variant.pass;
    const std::string name = imageName(pass, output.name);
    int image = find(layout.plan, name);
    if (image < 0) {
        const bool chosen = info.name == temporalPass && !layout.colourFormat.empty();
        image =
            add(layout, output, name, chosen ? layout.colourFormat : formatOf(pass.variant, output), index);
        at(layout.plan, image).cleared = !info.fullscreen;
    }
    at(layout.plan, image).lastPass = index; // drawn over, if it was there before
    return image;
}

// Inputs come first; history later, because it is an output of the same pass or of one after it.
void addPass(const Layout& layout, int index) {
    PlannedPass& pass = layout.plan.passes[static_cast<size_t>(index)];
    const PassInfo& info = *pass.variant.pass;
    pass.readImages.assign(pass.reads.size(), -1);
    pass.writeImages.clear();
    size_t read = 0;
    for (const ImageInfo& input : info.inputs) {
        if (!exists(pass.variant, input)) continue;
        if (isImage(input) && !isHistory(input))
            pass.readImages[read] = addInput(layout, pass.variant, input, index);
        ++read;
    }
    for (const ImageInfo& output : info.outputs)
        if (exists(pass.variant, output)) pass.writeImages.push_back(addOutput(layout, pass, output, index));
}

// The history of the cache is what the filter made of it, where the plan filters over time.
void addHistory(FramePlan& plan, PlannedPass& pass) {
    size_t read = 0;
    for (const ImageInfo& input : pass.variant.pass->inputs) {
        if (!exists(pass.variant, input)) continue;
        if (isHistory(input)) {
            const bool filtered = plan.cache.filtersHistory && input.history == "gOutCache";
            int image = filtered ? find(plan, "gOutFiltered") : -1;
            if (image < 0) image = find(plan, input.history);
            if (image >= 0) at(plan, image).history = true;
            pass.readImages[read] = image;
        }
        ++read;
    }
}

// The engine may read these after the frame is recorded.
void keepOutputs(FramePlan& plan) {
    const auto keep = [&](std::string_view name) {
        const int image = find(plan, name);
        if (image >= 0) at(plan, image).lastPass = static_cast<int>(plan.passes.size()) - 1;
        return image >= 0;
    };
    keep(velocityImage);
    keep("gOutLit");
    for (const std::string& name : lightingImages(plan.cache))
        if (keep(name)) break;
}

} // namespace

bool isHistory(const ImageInfo& input) {
    return !input.history.empty();
}
bool isImage(const ImageInfo& info) {
    return !info.format.empty();
}

std::vector<std::string> sourcesOf(std::string_view input, const CacheSettings& cache) {
    if (input == "gInFresh") return {"gOutShadow", "gOutOcclusion"};
    if (input == "gInCache") return {"gOutFilteredAcross", "gOutCache"};
    if (input == "gInFiltered") return {"gOutFiltered", "gOutCache", "gOutShadow", "gOutOcclusion"};
    if (input == "gInObscurance") return {"gOutFilteredObscuranceAcross", "gOutObscurance"};
    if (input == "gInLighting") return lightingImages(cache);
    if (input == "gInColour") return {"gOutLit"};
    return {std::string(outPrefix) + std::string(input.substr(inPrefix.size()))};
}

std::vector<std::string> lightingImages(const CacheSettings& cache) {
    if (cache.occlusion == obscurancePass) return {"gOutFilteredObscurance", "gOutObscurance"};
    std::vector<std::string> images{"gOutUpsampled"};
    for (std::string& each : sourcesOf("gInFiltered", cache))
        images.push_back(std::move(each));
    return images;
}

std::string imageName(const PlannedPass& pass, std::string_view output) {
    return std::string(output) + (pass.run == "across" ? "Across" : "");
}

void planImages(FramePlan& plan, bool engineWritesMotion, std::string_view colourFormat, Extent extent) {
    plan.images.clear();
    const Layout layout{plan, engineWritesMotion, colourFormat, extent};
    for (int pass = 0; pass < static_cast<int>(plan.passes.size()); ++pass)
        addPass(layout, pass);
    for (PlannedPass& pass : plan.passes)
        addHistory(plan, pass);
    keepOutputs(plan);
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
