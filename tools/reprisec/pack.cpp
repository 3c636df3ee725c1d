// SPDX-License-Identifier: Apache-2.0
// Questions to a loaded pack.
#include "internal.hpp"

#include <algorithm>

namespace reprisec {

std::span<const PassInfo> Pack::passes() const {
    return storage->passes;
}

const fs::path& Pack::file() const {
    return storage->file;
}

std::span<const reprise::PresetInfo> Pack::presets(std::string_view pass) const {
    for (size_t i = 0; i < storage->passes.size(); ++i)
        if (storage->passes[i].name == pass) return storage->presets[i];
    return {};
}

Result<Variant> Pack::preset(std::string_view pass, std::string_view name) const {
    auto variant = reprise::makeVariant(passes(), pass);
    if (!variant) return variant;
    std::string known;
    for (const auto& preset : presets(pass)) {
        known += (known.empty() ? "" : ", ") + std::string(preset.name);
        if (preset.name != name) continue;
        for (const auto& change : preset.switches)
            if (auto set = reprise::setSwitch(*variant, change.switchName, change.value); !set)
                return set.error();
        return variant;
    }
    return Error{ErrorCode::invalidArgument, "the pass " + std::string(pass) + " has no preset \"" +
                                                 std::string(name) +
                                                 "\"; it has: " + (known.empty() ? "none" : known)};
}

Result<Variant> Pack::parseVariant(std::string_view name) const {
    if (name.ends_with("--"))
        return Error{ErrorCode::invalidArgument,
                     "the variant name " + std::string(name) + " ends in --; remove it"};
    const auto next = [&name] {
        const size_t end = std::min(name.find("--"), name.size());
        const std::string_view part = name.substr(0, end);
        name.remove_prefix(std::min(end + 2, name.size()));
        return part;
    };
    auto variant = reprise::makeVariant(passes(), next());
    while (variant && !name.empty()) {
        const std::string_view part = next();
        const size_t dash = std::min(part.find('-'), part.size() - 1);
        if (auto set = reprise::setSwitch(*variant, upper(part.substr(0, dash)), part.substr(dash + 1)); !set)
            return set.error();
    }
    return variant;
}

std::vector<Variant> Pack::committedVariants(const PassInfo& pass) const {
    std::vector<Variant> variants;
    std::set<std::string> names;
    const auto add = [&](const Variant& variant) {
        if (names.insert(reprise::variantName(variant)).second) variants.push_back(variant);
    };
    const auto standard = reprise::makeVariant({&pass, 1}, pass.name);
    if (!standard) return {};
    add(*standard);
    for (const auto& each : presets(pass.name))
        if (auto variant = preset(pass.name, each.name)) add({&pass, variant->values});
    for (size_t i = 0; i < pass.switches.size(); ++i)
        for (size_t value = 0; value < pass.switches[i].values.size(); ++value) {
            Variant flipped = *standard;
            flipped.values[i] = static_cast<uint8_t>(value);
            add(flipped);
        }
    return variants;
}

} // namespace reprisec
