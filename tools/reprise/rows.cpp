// SPDX-License-Identifier: Apache-2.0
#include "rows.hpp"
#include "lighting_rows.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::JitterSequence;
using reprise::Stage;
using reprise::Variant;

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return result;
}

bool worksIn(const reprise::SwitchInfo& info, Stage stage) {
    return info.stages.empty() ||
           std::find(info.stages.begin(), info.stages.end(), stage) != info.stages.end();
}

Variant presetVariant(const reprisec::Pack& pack, std::string_view name, Stage stage) {
    auto variant = pack.preset("temporal_aa", name);
    if (!variant) throw std::runtime_error(variant.error().message);
    return reprise::forStage(*variant, stage);
}

void addFlips(const Variant& base, std::string_view name, Stage stage, std::vector<RowSpec>& rows) {
    for (size_t s = 0; s < base.pass->switches.size(); ++s) {
        const reprise::SwitchInfo& info = base.pass->switches[s];
        if (describesInput(info) || !worksIn(info, stage)) continue;
        for (size_t value = 0; value < info.values.size(); ++value) {
            if (value == base.values[s]) continue;
            RowSpec row;
            row.label = fmt::format("{} + {}", name, switchText(info, static_cast<uint8_t>(value)));
            row.variant = base;
            row.preset = name;
            row.variant->values[s] = static_cast<uint8_t>(value);
            rows.push_back(std::move(row));
        }
    }
}

} // namespace

std::string jitterName(JitterSequence sequence) {
    switch (sequence) {
    case JitterSequence::none:
        return "none";
    case JitterSequence::uniform4Helix:
        return "uniform4_helix";
    case JitterSequence::halton8:
        return "halton8";
    case JitterSequence::halton16:
        return "halton16";
    }
    return "";
}

std::string switchText(const reprise::SwitchInfo& info, uint8_t value) {
    return fmt::format("{} {}", lower(info.name), info.values[value]);
}

bool describesInput(const reprise::SwitchInfo& info) {
    return info.name == "DEPTH_REVERSED" || info.name == "DEPTH_LINEAR" || info.name == "ORTHOGRAPHIC";
}

bool cameraMovesAlone(const scenes::Scene& scene) {
    return scene.cameraMoves && !objectsMove(scene);
}

std::vector<RowSpec> temporalRows(const reprisec::Pack& pack, Stage stage,
                                  std::span<const std::string> flipped) {
    std::vector<RowSpec> rows;
    rows.push_back({.label = "none", .variant = {}, .jitter = JitterSequence::none});
    for (const auto& preset : pack.presets("temporal_aa")) {
        RowSpec row{.label = std::string(preset.name),
                    .variant = presetVariant(pack, preset.name, stage),
                    .preset = std::string(preset.name)};
        rows.push_back(row);
        if (preset.name == "inside") continue; // of the document's a flip is enough
        row.label += ", camera";
        row.cameraAlone = true;
        if (auto set = reprise::setSwitch(*row.variant, "MOTION", "camera"); !set)
            throw std::runtime_error(set.error().message);
        rows.push_back(std::move(row));
    }
    for (const std::string& name : flipped)
        addFlips(presetVariant(pack, name, stage), name, stage, rows);
    const Variant inside = presetVariant(pack, "inside", stage);
    for (auto sequence : {JitterSequence::none, JitterSequence::uniform4Helix, JitterSequence::halton8})
        rows.push_back({.label = fmt::format("inside, jitter {}", jitterName(sequence)),
                        .variant = inside,
                        .jitter = sequence});
    rows.push_back({.label = "inside, cut untold", .variant = inside, .cutIsTold = false});
    return rows;
}

std::vector<std::string> presetLabels(const reprisec::Pack& pack) {
    std::vector<std::string> labels;
    for (const RowSpec& row : temporalRows(pack, Stage::compute, {}))
        if (row.cameraAlone || (row.variant && row.label == row.preset)) labels.push_back(row.label);
    return labels;
}

} // namespace report
