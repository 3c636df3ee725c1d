// SPDX-License-Identifier: Apache-2.0
// NAME.STAGE.json: what a module binds, reads and writes, and which targets exist.
#include "internal.hpp"

#include <nlohmann/json.hpp>

namespace reprisec {

namespace {

using nlohmann::ordered_json;
using reprise::BindingKind;

const char* kindName(BindingKind kind) {
    switch (kind) {
    case BindingKind::sampledImage:
        return "sampledImage";
    case BindingKind::pointSampler:
        return "pointSampler";
    case BindingKind::linearSampler:
        return "linearSampler";
    case BindingKind::storageImage:
        return "storageImage";
    case BindingKind::uniformBuffer:
        return "uniformBuffer";
    case BindingKind::storageBuffer:
        return "storageBuffer";
    }
    return "unknown";
}

ordered_json bindingJson(const BindingUse& use) {
    return {{"name", use.name},       {"binding", use.binding}, {"kind", kindName(use.kind)},
            {"samples", use.samples}, {"gathers", use.gathers}, {"fetches", use.fetches},
            {"stores", use.stores}, {"scalars", use.scalars}};
}

ordered_json parametersJson(const Reflection& reflection) {
    if (reflection.parameterBytes == 0) return nullptr;
    ordered_json members = ordered_json::array();
    for (const ParameterMember& member : reflection.parameters)
        members.push_back({{"name", member.name},
                           {"type", member.type},
                           {"offset", member.offset},
                           {"bytes", member.bytes}});
    return {{"bytes", reflection.parameterBytes}, {"members", members}};
}

ordered_json targetJson(const std::string& file, bool exists, const std::string& reason) {
    return {{"file", exists ? ordered_json(file) : ordered_json(nullptr)},
            {"reason", exists ? ordered_json(nullptr) : ordered_json(reason)}};
}

} // namespace

std::string reflectionJson(const Variant& variant, Stage stage, const Compiled& compiled,
                           const fs::path& packRoot) {
    const std::string name = reprise::variantName(variant) + "." + std::string(reprise::stageName(stage));
    const Reflection& reflection = compiled.reflection;
    ordered_json json{{"schema", 1},
                      {"pass", variant.pass->name},
                      {"variant", reprise::variantName(variant)},
                      {"stage", stageWord(stage)},
                      {"entry", entryPoint(stage)}};
    json["switches"] = ordered_json::object();
    for (const auto& info : variant.pass->switches)
        json["switches"][std::string(info.name)] = reprise::switchValue(variant, info.name);
    json["bindings"] = ordered_json::array();
    for (const BindingUse& use : reflection.bindings)
        json["bindings"].push_back(bindingJson(use));
    json["parameters"] = parametersJson(reflection);
    json["threads"] = stage == Stage::compute ? ordered_json(reflection.threads) : ordered_json(nullptr);
    json["colourOutputs"] =
        stage == Stage::fragment ? ordered_json(reflection.colourOutputs) : ordered_json(nullptr);
    json["targets"] = {
        {"spirv", targetJson(name + ".spv", true, {})},
        {"glsl450", targetJson(name + ".450.glsl", compiled.glsl450.has_value(), compiled.glsl450Reason)},
        {"glslEs", targetJson(name + ".es.glsl", compiled.glslEs.has_value(), compiled.glslEsReason)}};
    json["sources"] = ordered_json::array();
    for (const fs::path& file : compiled.dependencies)
        json["sources"].push_back(file.lexically_relative(packRoot).generic_string());
    return json.dump(2) + "\n";
}

} // namespace reprisec
