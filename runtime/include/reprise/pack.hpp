// SPDX-License-Identifier: Apache-2.0
// The pack: the table of passes that reprisec generates from hlsl/pack.toml, and their variants' SPIR-V.
#pragma once

#include "reprise/result.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace reprise {

enum class Stage : uint8_t { vertex, fragment, compute };

// What a binding number of descriptor set 0 holds. A sampler belongs to the texture of the same name
// (its own name ends in _sampler) and is clamp to edge, no mipmaps, of that texture's filter.
enum class BindingKind : uint8_t {
    sampledImage,
    pointSampler,
    linearSampler,
    storageImage,
    uniformBuffer,
    storageBuffer
};

struct BindingInfo {
    std::string_view name; // the HLSL resource name; it is API
    uint32_t binding;      // in set 0; the same in every variant of the pass
    BindingKind kind;
};

struct SwitchInfo {
    std::string_view name;                    // NEIGHBOURHOOD
    std::span<const std::string_view> values; // four_tap, square, rounded
    uint8_t defaultValue;                     // index into values
    std::string_view need;                    // which need of a scene turns it on; may be empty
    std::string_view summary;
    std::span<const Stage> stages; // where it has an effect; empty: in every stage
};

struct Condition { // the image exists only when the switch has the value
    std::string_view switchName;
    std::string_view value;
};

struct FormatChoice { // the image has the format where the switch has the value
    Condition when;
    std::string_view format;
};

struct ImageInfo {
    std::string_view name;           // gInColour, gOutHistory
    std::string_view space;          // meaning, space and unit
    std::string_view format;         // recommended: r32f, rg16f, rgba16f, rgba8; see formatOf()
    float scale;                     // share of the frame's extent, 0: one of its own; see scaleOf()
    std::string_view history;        // the output that becomes this input in the next frame, or empty
    std::span<const Condition> when; // all must hold; of those on one switch, one
    std::string_view sameAs;         // the input whose image this is too, under another filter, or empty
    float widthScale = 1.0f;         // of the width, beside scale
    std::span<const FormatChoice> formatBy = {}; // other formats, by a switch
    std::span<const Condition> orWhen = {};      // if any: in place of `when` these may hold
};

struct GroupChoice { // the compute groups where the switch has the value
    Condition when;
    uint32_t threads[3];
};

struct PassInfo {
    std::string_view name; // temporal_aa
    std::string_view summary;
    std::string_view source; // place in the documents
    std::span<const Stage> stages;
    bool fullscreen;             // the fragment form is drawn by the pass fullscreen's vertex shader
    uint32_t threads[3];         // of a compute group; see threadsOf()
    uint32_t pixelsPerThread[2]; // of the compute form
    uint32_t parameterBytes;     // size of the uniform buffer at binding 0
    std::span<const SwitchInfo> switches;
    std::span<const BindingInfo> bindings; // union over the variants
    std::span<const ImageInfo> inputs;
    std::span<const ImageInfo> outputs; // fragment: SV_Target order
    uint32_t overhang[2] = {0, 0};      // pixels beyond the image that the groups of the compute form cover
    std::span<const GroupChoice> threadsBy = {}; // other groups, by a switch
};

struct PresetInfo {
    std::string_view name; // best
    std::string_view summary;
    std::span<const Condition> switches; // differences from the defaults
    // Numbers that go with them, defaults of TaaTuning.
    float feedbackMin = 0.0f, feedbackMax = 0.0f;
    bool rampFeedback = false;
};

// The value of each switch of a pass, in the order of the table. Empty means all defaults.
struct Variant {
    const PassInfo* pass = nullptr;
    std::vector<uint8_t> values;
};

// All defaults of the pass named.
Result<Variant> makeVariant(std::span<const PassInfo> passes, std::string_view passName);
// Sets one switch; fails with a sentence that lists the valid names if there is none of that name or value.
Result<void> setSwitch(Variant& variant, std::string_view switchName, std::string_view value);
std::string_view switchValue(const Variant& variant, std::string_view switchName);
bool exists(const Variant& variant, const ImageInfo& image);
// The format that the table recommends for an image of the variant.
std::string_view formatOf(const Variant& variant, const ImageInfo& image);
// The threads of a compute group of the variant.
std::span<const uint32_t, 3> threadsOf(const Variant& variant);
// Share of the frame's extent that an image of the variant has, to be rounded up. Below 1 it follows the
// switch RATIO, where the pass has it: the table has the scale of its default.
double scaleOf(const Variant& variant, const ImageInfo& image);

// Canonical name: the pass, then each switch off its default in table order, in lower case:
// "temporal_aa--neighbourhood-square--colour_space-ycocg". Files are NAME.STAGE.spv, STAGE
// being vert, frag or comp.
std::string variantName(const Variant& variant);
// The variant with every switch that has no effect in `stage` at its default: the form of file names.
Variant forStage(const Variant& variant, Stage stage);
std::string_view stageName(Stage stage); // vert, frag or comp
std::string spirvFileName(const Variant& variant, Stage stage);

// Gives the SPIR-V of a variant: from a directory, from memory, or compiled on demand.
using SpirvSource = std::function<Result<std::vector<uint32_t>>(const Variant&, Stage)>;

// Reads NAME.STAGE.spv from `directory` or from its folder named as the pass; a missing file is
// ErrorCode::missingVariant naming the file.
SpirvSource spirvFromDirectory(std::string directory);

} // namespace reprise
