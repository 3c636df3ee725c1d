// SPDX-License-Identifier: Apache-2.0
// Variants: their switches, their names and their SPIR-V files.
#include "reprise/pack.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace reprise {

namespace {

constexpr uint32_t spirvMagic = 0x07230203;

template <class Range> std::string listNames(const Range& items) {
    std::string text;
    for (const auto& item : items) {
        if (!text.empty()) text += ", ";
        if constexpr (requires { item.name; })
            text += item.name;
        else
            text += item;
    }
    return text.empty() ? "none" : text;
}

Error invalid(std::string message) {
    return {ErrorCode::invalidArgument, std::move(message)};
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

// An empty list of values stands for all defaults.
uint8_t valueAt(const Variant& variant, size_t index) {
    return index < variant.values.size() ? variant.values[index] : variant.pass->switches[index].defaultValue;
}

// Of those on one switch, one.
bool allHold(const Variant& variant, std::span<const Condition> conditions) {
    return std::ranges::all_of(conditions, [&](const Condition& condition) {
        return std::ranges::any_of(conditions, [&](const Condition& alternative) {
            return alternative.switchName == condition.switchName &&
                   switchValue(variant, alternative.switchName) == alternative.value;
        });
    });
}

Result<std::vector<uint32_t>> readWords(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    if (stream.bad() || bytes.size() < 20 || bytes.size() % 4 != 0)
        return Error{ErrorCode::fileError, file.string() + " is not readable as SPIR-V; generate it again"};
    std::vector<uint32_t> words(bytes.size() / 4);
    std::memcpy(words.data(), bytes.data(), bytes.size());
    if (words[0] != spirvMagic)
        return Error{ErrorCode::fileError,
                     file.string() + " does not begin as SPIR-V does; generate it again"};
    return words;
}

} // namespace

Result<Variant> makeVariant(std::span<const PassInfo> passes, std::string_view passName) {
    const auto pass = std::ranges::find(passes, passName, &PassInfo::name);
    if (pass == passes.end())
        return invalid("there is no pass \"" + std::string(passName) + "\"; there are: " + listNames(passes));
    Variant variant{&*pass, {}};
    for (const SwitchInfo& info : pass->switches)
        variant.values.push_back(info.defaultValue);
    return variant;
}

Result<void> setSwitch(Variant& variant, std::string_view switchName, std::string_view value) {
    if (!variant.pass) return invalid("the variant has no pass; make it with makeVariant");
    const auto switches = variant.pass->switches;
    const auto found = std::ranges::find(switches, switchName, &SwitchInfo::name);
    if (found == switches.end())
        return invalid("the pass " + std::string(variant.pass->name) + " has no switch \"" +
                       std::string(switchName) + "\"; it has: " + listNames(switches));
    const auto place = std::ranges::find(found->values, value);
    if (place == found->values.end())
        return invalid("the switch " + std::string(switchName) + " of the pass " +
                       std::string(variant.pass->name) + " has no value \"" + std::string(value) +
                       "\"; it has: " + listNames(found->values));
    for (size_t i = variant.values.size(); i < switches.size(); ++i)
        variant.values.push_back(switches[i].defaultValue);
    variant.values[static_cast<size_t>(found - switches.begin())] =
        static_cast<uint8_t>(place - found->values.begin());
    return {};
}

std::string_view switchValue(const Variant& variant, std::string_view switchName) {
    if (!variant.pass) return {};
    const auto switches = variant.pass->switches;
    const auto found = std::ranges::find(switches, switchName, &SwitchInfo::name);
    if (found == switches.end()) return {};
    return found->values[valueAt(variant, static_cast<size_t>(found - switches.begin()))];
}

bool exists(const Variant& variant, const ImageInfo& image) {
    return allHold(variant, image.when) || (!image.orWhen.empty() && allHold(variant, image.orWhen));
}

std::string_view formatOf(const Variant& variant, const ImageInfo& image) {
    for (const FormatChoice& choice : image.formatBy)
        if (switchValue(variant, choice.when.switchName) == choice.when.value) return choice.format;
    return image.format;
}

std::span<const uint32_t, 3> threadsOf(const Variant& variant) {
    for (const GroupChoice& choice : variant.pass->threadsBy)
        if (switchValue(variant, choice.when.switchName) == choice.when.value) return choice.threads;
    return variant.pass->threads;
}

double scaleOf(const Variant& variant, const ImageInfo& image) {
    const std::string_view ratio = switchValue(variant, "RATIO");
    int divisor = 0;
    std::from_chars(ratio.data(), ratio.data() + ratio.size(), divisor);
    return image.scale > 0.0f && image.scale < 1.0f && divisor > 0 ? 1.0 / divisor
                                                                   : static_cast<double>(image.scale);
}

std::string variantName(const Variant& variant) {
    if (!variant.pass) return {};
    std::string name(variant.pass->name);
    for (size_t i = 0; i < variant.pass->switches.size(); ++i) {
        const SwitchInfo& info = variant.pass->switches[i];
        const uint8_t value = valueAt(variant, i);
        if (value == info.defaultValue) continue;
        name.append("--").append(lower(info.name)).append("-").append(info.values[value]);
    }
    return name;
}

Variant forStage(const Variant& variant, Stage stage) {
    Variant result{variant.pass, {}};
    if (!variant.pass) return result;
    for (size_t i = 0; i < variant.pass->switches.size(); ++i) {
        const SwitchInfo& info = variant.pass->switches[i];
        const bool effective =
            info.stages.empty() || std::ranges::find(info.stages, stage) != info.stages.end();
        result.values.push_back(effective ? valueAt(variant, i) : info.defaultValue);
    }
    return result;
}

std::string_view stageName(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return "vert";
    case Stage::fragment:
        return "frag";
    case Stage::compute:
        return "comp";
    }
    return "unknown";
}

std::string spirvFileName(const Variant& variant, Stage stage) {
    return variantName(forStage(variant, stage)) + "." + std::string(stageName(stage)) + ".spv";
}

SpirvSource spirvFromDirectory(std::string directory) {
    return [root = std::filesystem::path(std::move(directory))](
               const Variant& variant, Stage stage) -> Result<std::vector<uint32_t>> {
        if (!variant.pass) return invalid("the variant has no pass; make it with makeVariant");
        const std::string name = spirvFileName(variant, stage);
        std::error_code ignored;
        for (const auto& file : {root / name, root / std::string(variant.pass->name) / name})
            if (std::filesystem::is_regular_file(file, ignored)) return readWords(file);
        return Error{ErrorCode::missingVariant, "there is no " + name + " in " + root.string() +
                                                    "; compile it with reprisec --variant " +
                                                    variantName(variant)};
    };
}

} // namespace reprise
