// SPDX-License-Identifier: Apache-2.0
#include "guarded.hpp"
#include "plan_switches.hpp"
#include "reprise/format.hpp"

#include <algorithm>
#include <cmath>

namespace reprise {
namespace {

constexpr std::string_view temporalPass = "temporal_aa", velocityImage = "gOutVelocity";
constexpr std::string_view inPrefix = "gIn", outPrefix = "gOut";

// gInVelocity is what gOutVelocity wrote.
std::string writtenName(std::string_view input) {
    return std::string(outPrefix) + std::string(input.substr(inPrefix.size()));
}

bool isHistory(const ImageInfo& input) {
    return !input.history.empty();
}
bool isImage(const ImageInfo& info) {
    return !info.format.empty();
} // else a buffer

// A pass that may take part, and why not, if so.
struct Candidate {
    PlannedPass pass;
    std::string_view veto;
};

std::string_view vetoOf(const PassInfo& pass, const SceneNeeds& needs) {
    if (pass.name == temporalPass && !needs.antiAliasing) return "Anti-aliasing is not asked for.";
    const bool camera = pass.name == "camera_velocity", object = pass.name == "object_velocity";
    if ((camera || object) && needs.engineWritesMotion) return "The engine writes motion vectors itself.";
    if (camera && !needs.cameraMoves)
        return "The camera does not move: the motion of what stands still is zero, and is cleared, not "
               "computed.";
    if (object && !needs.objectsMove) return "No object moves.";
    return {};
}

Stage stageOf(const PassInfo& pass, Stage wanted) {
    if (!pass.fullscreen) return Stage::fragment;
    return std::ranges::find(pass.stages, wanted) != pass.stages.end() ? wanted : pass.stages.front();
}

void addCandidate(std::vector<Candidate>& candidates, const Variant& variant, Stage stage,
                  std::string_view veto) {
    Candidate candidate{{forStage(variant, stage), stage, {}, {}}, veto};
    for (const ImageInfo& input : variant.pass->inputs)
        if (exists(variant, input)) candidate.pass.reads.emplace_back(input.name);
    for (const ImageInfo& output : variant.pass->outputs)
        if (exists(variant, output)) candidate.pass.writes.emplace_back(output.name);
    candidates.push_back(std::move(candidate));
}

// Every pass of the table in its order; object_velocity twice when there are skinned meshes beside rigid
// ones.
Result<std::vector<Candidate>> candidatesFor(std::span<const PassInfo> passes,
                                             std::span<const PresetInfo> presets, const SceneNeeds& needs,
                                             const Settings& settings, std::vector<Dropped>& dropped) {
    std::vector<Candidate> candidates;
    for (const PassInfo& pass : passes) {
        if (pass.outputs.empty()) continue; // the full-screen triangle
        auto variant = chooseVariant(pass, presets, needs, settings, dropped);
        if (!variant) return variant.error();
        const Stage stage = stageOf(pass, settings.stage);
        const std::string_view veto = vetoOf(pass, needs);
        addCandidate(candidates, *variant, stage, veto);
        if (!needs.skinnedMeshes || !veto.empty() || !setSwitch(*variant, "SKINNING", "on")) continue;
        addCandidate(candidates, *variant, stage, veto);
    }
    return candidates;
}

void want(std::vector<std::string>& wanted, std::string name) {
    if (std::ranges::find(wanted, name) == wanted.end()) wanted.push_back(std::move(name));
}

bool wantsAny(const std::vector<std::string>& wanted, const PlannedPass& pass) {
    return std::ranges::any_of(pass.writes, [&](const std::string& name) {
        return std::ranges::find(wanted, name) != wanted.end();
    });
}

void wantInputs(std::vector<std::string>& wanted, const Variant& variant) {
    for (const ImageInfo& input : variant.pass->inputs)
        if (exists(variant, input) && isImage(input) && !isHistory(input))
            want(wanted, writtenName(input.name));
}

// A pass that is left out has no switches worth a word, and is named once.
void drop(FramePlan& plan, std::string_view pass, std::string reason) {
    std::erase_if(plan.dropped, [&](const Dropped& each) {
        return each.pass == pass || each.pass.starts_with(std::string(pass) + ":");
    });
    plan.dropped.push_back({std::string(pass), std::move(reason)});
}

// Walks back from the anti-aliased frame.
void choosePasses(std::vector<Candidate> candidates, FramePlan& plan) {
    std::vector<std::string> wanted;
    for (auto candidate = candidates.rbegin(); candidate != candidates.rend(); ++candidate) {
        const std::string_view name = candidate->pass.variant.pass->name;
        const bool needed = name == temporalPass || wantsAny(wanted, candidate->pass);
        if (!candidate->veto.empty()) {
            drop(plan, name, std::string(candidate->veto));
        } else if (!needed) {
            drop(plan, name, "Nothing reads " + candidate->pass.writes.front() + ".");
        } else {
            wantInputs(wanted, candidate->pass.variant);
            plan.passes.insert(plan.passes.begin(), std::move(candidate->pass));
        }
    }
}

uint32_t scaled(uint32_t texels, float scale) {
    return std::max(1u, static_cast<uint32_t>(std::ceil(static_cast<float>(texels) * scale)));
}

class ImageTable {
public:
    ImageTable(FramePlan& plan, const SceneNeeds& needs, const Settings& settings, Extent extent)
        : plan_(plan), needs_(needs), settings_(settings), extent_(extent) {}

    void addPass(int index) {
        const PlannedPass& pass = plan_.passes[static_cast<size_t>(index)];
        for (const ImageInfo& input : pass.variant.pass->inputs)
            if (exists(pass.variant, input) && isImage(input) && input.sameAs.empty()) addInput(input, index);
        for (const ImageInfo& output : pass.variant.pass->outputs)
            if (exists(pass.variant, output)) addOutput(*pass.variant.pass, output, index);
    }

private:
    PlannedImage* find(std::string_view name) {
        const auto found = std::ranges::find(plan_.images, name, &PlannedImage::name);
        return found == plan_.images.end() ? nullptr : &*found;
    }

    PlannedImage& add(const ImageInfo& info, std::string name, std::string_view format, int pass) {
        PlannedImage image;
        image.name = std::move(name);
        image.format = format;
        image.extent = {scaled(extent_.width, info.scale), scaled(extent_.height, info.scale)};
        image.firstPass = image.lastPass = pass;
        image.bytes = uint64_t(texelBytes(format)) * image.extent.width * image.extent.height;
        return plan_.images.emplace_back(std::move(image));
    }

    void addInput(const ImageInfo& input, int pass) {
        if (isHistory(input)) return; // its output is the image
        if (PlannedImage* written = find(writtenName(input.name))) {
            written->lastPass = pass;
            return;
        }
        if (PlannedImage* known = find(input.name)) {
            known->lastPass = pass;
            return;
        }
        // Motion that the engine does not write and no pass was needed for is zero everywhere.
        const bool zero = writtenName(input.name) == velocityImage && !needs_.engineWritesMotion;
        PlannedImage& image =
            add(input, zero ? writtenName(input.name) : std::string(input.name), input.format, pass);
        image.external = !zero;
        image.cleared = zero;
    }

    void addOutput(const PassInfo& pass, const ImageInfo& output, int index) {
        if (PlannedImage* known = find(output.name)) {
            known->lastPass = index; // drawn over
            return;
        }
        const bool chosen = pass.name == temporalPass && !settings_.colourFormat.empty();
        PlannedImage& image =
            add(output, std::string(output.name), chosen ? settings_.colourFormat : output.format, index);
        image.cleared = !pass.fullscreen;
        image.history = std::ranges::any_of(
            pass.inputs, [&](const ImageInfo& input) { return input.history == output.name; });
    }

    FramePlan& plan_;
    const SceneNeeds& needs_;
    const Settings& settings_;
    Extent extent_;
};

// The engine may read motion after the frame is recorded.
void keepMotion(FramePlan& plan) {
    for (PlannedImage& image : plan.images)
        if (image.name == velocityImage) image.lastPass = static_cast<int>(plan.passes.size()) - 1;
}

Result<void> checkSettings(const Settings& settings, Extent extent) {
    if (extent.width == 0 || extent.height == 0)
        return Error{ErrorCode::zeroExtent, "The extent of the frame is zero; give it a width and a height."};
    if (settings.stage == Stage::vertex)
        return Error{ErrorCode::invalidArgument, "Settings::stage must be fragment or compute."};
    if (!settings.colourFormat.empty() && texelBytes(settings.colourFormat) == 0)
        return Error{ErrorCode::invalidArgument, "There is no format named '" +
                                                     std::string(settings.colourFormat) +
                                                     "'; see reprise/format.hpp."};
    return {};
}

} // namespace

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

Result<FramePlan> plan(std::span<const PassInfo> passes, std::span<const PresetInfo> presets,
                       const SceneNeeds& needs, const Settings& settings, Extent extent) {
    return guarded([&]() -> Result<FramePlan> {
        if (auto checked = checkSettings(settings, extent); !checked) return checked.error();
        FramePlan plan;
        auto candidates = candidatesFor(passes, presets, needs, settings, plan.dropped);
        if (!candidates) return candidates.error();
        choosePasses(std::move(*candidates), plan);
        ImageTable images(plan, needs, settings, extent);
        for (int pass = 0; pass < static_cast<int>(plan.passes.size()); ++pass)
            images.addPass(pass);
        keepMotion(plan);
        shareMemory(plan);
        return plan;
    });
}

} // namespace reprise
