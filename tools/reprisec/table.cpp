// SPDX-License-Identifier: Apache-2.0
// include/reprise/pack_table.hpp: the table of passes as C++ constants, with binding numbers and parameters.
#include "output.hpp"

#include <algorithm>

namespace reprisec {

namespace {

using reprise::BindingKind;

std::string literal(std::string_view text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        if (c == '\n')
            result += "\\n";
        else
            result += c;
    }
    return result + "\"";
}

std::string number(uint64_t value) {
    return std::to_string(value);
}

std::string_view kindName(BindingKind kind) {
    switch (kind) {
    case BindingKind::sampledImage:
        return "BindingKind::sampledImage";
    case BindingKind::pointSampler:
        return "BindingKind::pointSampler";
    case BindingKind::linearSampler:
        return "BindingKind::linearSampler";
    case BindingKind::storageImage:
        return "BindingKind::storageImage";
    case BindingKind::uniformBuffer:
        return "BindingKind::uniformBuffer";
    case BindingKind::storageBuffer:
        break;
    }
    return "BindingKind::storageBuffer";
}

std::string stageValue(Stage stage) {
    return "Stage::" + std::string(stageWord(stage));
}

// Arrays of the generated namespace; an array without elements is not C++, and its name is {}.
class Arrays {
public:
    std::string text;

    std::string add(const std::string& type, const std::string& name,
                    const std::vector<std::string>& elements, bool oneLine = false) {
        if (elements.empty()) return "{}";
        text += "inline constexpr " + type + " " + name + "[] = {";
        for (size_t i = 0; i < elements.size(); ++i)
            text += oneLine ? (i ? ", " : "") + elements[i] : "\n    " + elements[i] + ",";
        text += oneLine ? "};\n" : "\n};\n";
        return name;
    }
};

std::string addStages(Arrays& arrays, const std::string& name, std::span<const Stage> stages) {
    std::vector<std::string> elements;
    for (Stage stage : stages)
        elements.push_back(stageValue(stage));
    return arrays.add("Stage", name, elements, true);
}

std::string addConditions(Arrays& arrays, const std::string& name,
                          std::span<const reprise::Condition> conditions) {
    std::vector<std::string> elements;
    for (const auto& each : conditions)
        elements.push_back("{" + literal(each.switchName) + ", " + literal(each.value) + "}");
    return arrays.add("Condition", name, elements, true);
}

std::string addFormats(Arrays& arrays, const std::string& name,
                       std::span<const reprise::FormatChoice> choices) {
    std::vector<std::string> elements;
    for (const auto& each : choices)
        elements.push_back("{{" + literal(each.when.switchName) + ", " + literal(each.when.value) + "}, " +
                           literal(each.format) + "}");
    return arrays.add("FormatChoice", name, elements, true);
}

std::string addSwitches(Arrays& arrays, const std::string& pass, const PassInfo& info) {
    std::vector<std::string> elements;
    for (const auto& each : info.switches) {
        const std::string name = pass + "_" + std::string(each.name);
        std::vector<std::string> values;
        for (std::string_view value : each.values)
            values.push_back(literal(value));
        const std::string valuesName = arrays.add("std::string_view", name + "_values", values, true);
        const std::string stagesName = addStages(arrays, name + "_stages", each.stages);
        elements.push_back("{" + literal(each.name) + ", " + valuesName + ", " + number(each.defaultValue) +
                           ", " + literal(each.need) + ",\n     " + literal(each.summary) + ", " +
                           stagesName + "}");
    }
    return arrays.add("SwitchInfo", pass + "_switches", elements);
}

std::string addImages(Arrays& arrays, const std::string& pass, const char* what,
                      std::span<const reprise::ImageInfo> images) {
    std::vector<std::string> elements;
    for (const auto& each : images) {
        const std::string name = pass + "_" + std::string(each.name);
        const std::string when = addConditions(arrays, name + "_when", each.when);
        const bool either = !each.orWhen.empty(), formats = either || !each.formatBy.empty();
        std::string rest;
        if (formats || each.widthScale != 1.0f) rest = ", " + std::to_string(each.widthScale) + "f";
        if (formats) rest += ", " + addFormats(arrays, name + "_formats", each.formatBy);
        if (either) rest += ", " + addConditions(arrays, name + "_or_when", each.orWhen);
        elements.push_back("{" + literal(each.name) + ", " + literal(each.space) + ", " +
                           literal(each.format) + ", " + std::to_string(each.scale) + "f, " +
                           literal(each.history) + ", " + when + ",\n     " + literal(each.sameAs) + rest +
                           "}");
    }
    return arrays.add("ImageInfo", pass + "_" + what, elements);
}

std::string addBindings(Arrays& arrays, const std::string& pass, const PassInfo& info) {
    std::vector<std::string> elements;
    for (const auto& each : info.bindings)
        elements.push_back("{" + literal(each.name) + ", " + number(each.binding) + ", " +
                           std::string(kindName(each.kind)) + "}");
    return arrays.add("BindingInfo", pass + "_bindings", elements);
}

std::string threadsText(std::span<const uint32_t, 3> threads) {
    return "{" + number(threads[0]) + ", " + number(threads[1]) + ", " + number(threads[2]) + "}";
}

std::string addGroups(Arrays& arrays, const std::string& name,
                      std::span<const reprise::GroupChoice> choices) {
    std::vector<std::string> elements;
    for (const auto& each : choices)
        elements.push_back("{{" + literal(each.when.switchName) + ", " + literal(each.when.value) + "}, " +
                           threadsText(each.threads) + "}");
    return arrays.add("GroupChoice", name, elements, true);
}

std::string passElement(Arrays& arrays, const PassInfo& info, uint32_t parameterBytes) {
    const std::string pass(info.name);
    const std::string stages = addStages(arrays, pass + "_stages", info.stages);
    const std::string switches = addSwitches(arrays, pass, info);
    const std::string bindings = addBindings(arrays, pass, info);
    const std::string inputs = addImages(arrays, pass, "inputs", info.inputs);
    const std::string outputs = addImages(arrays, pass, "outputs", info.outputs);
    const std::string groups =
        info.threadsBy.empty() ? "" : ", " + addGroups(arrays, pass + "_groups", info.threadsBy);
    return "{" + literal(info.name) + ", " + literal(info.summary) + ",\n     " + literal(info.source) +
           ", " + stages + ", " + (info.fullscreen ? "true" : "false") + ",\n     " +
           threadsText(info.threads) + ", {" + number(info.pixelsPerThread[0]) + ", " +
           number(info.pixelsPerThread[1]) + "}, " + number(parameterBytes) + ", " + switches + ",\n     " +
           bindings + ", " + inputs + ", " + outputs + ", {" + number(info.overhang[0]) + ", " +
           number(info.overhang[1]) + "}" + groups + "}";
}

std::string addPresets(Arrays& arrays, const Pack& pack, const PassInfo& info) {
    std::vector<std::string> elements;
    for (const auto& each : pack.presets(info.name)) {
        const std::string name = std::string(info.name) + "_preset_" + std::string(each.name);
        elements.push_back("{" + literal(each.name) + ", " + literal(each.summary) + ", " +
                           addConditions(arrays, name, each.switches) + ", " +
                           std::to_string(each.feedbackMin) + "f, " + std::to_string(each.feedbackMax) +
                           "f, " + (each.rampFeedback ? "true" : "false") + "}");
    }
    return arrays.add("PresetInfo", std::string(info.name) + "_presets", elements);
}

std::string addModules(Arrays& arrays, const PassInfo& info, const std::vector<Product>& products) {
    std::vector<std::string> elements;
    for (const auto& [job, compiled] : products)
        if (job.variant.pass->name == info.name)
            elements.push_back("{" + literal(reprise::variantName(job.variant)) + ", " +
                               stageValue(job.stage) + ",\n     " + literal(compiled.glsl450Reason) + ", " +
                               literal(compiled.glslEsReason) + "}");
    return arrays.add("PackModule", std::string(info.name) + "_modules", elements);
}

// The parameters of a pass over all its modules: each must have those that any has, in the same place.
Result<Reflection> parametersOf(const PassInfo& info, const std::vector<Product>& products) {
    Reflection merged;
    std::string first;
    for (const auto& [job, compiled] : products) {
        const Reflection& each = compiled.reflection;
        if (job.variant.pass->name != info.name || each.parameterBytes == 0) continue;
        const auto same = [](const ParameterMember& a, const ParameterMember& b) {
            return a.name == b.name && a.type == b.type && a.offset == b.offset;
        };
        if (first.empty()) {
            merged = each;
            first = reprise::variantName(job.variant);
        } else if (!std::ranges::equal(merged.parameters, each.parameters, same)) {
            return badShader("the parameters of " + reprise::variantName(job.variant) +
                             " are laid out otherwise than in " + first + "; declare them outside #if");
        }
    }
    return merged;
}

// "float4x4" as an array of scalars; an HLSL array has elements of 16 bytes, so its bytes count.
Result<std::string> memberDeclaration(const ParameterMember& member) {
    std::string scalar;
    for (const auto& [hlsl, cpp] :
         {std::pair{"float", "float"}, {"uint", "uint32_t"}, {"int", "int32_t"}, {"bool", "uint32_t"}})
        if (member.type.starts_with(hlsl)) {
            scalar = cpp;
            break;
        }
    if (scalar.empty())
        return badShader("the parameter " + member.name +
                         " is of a type that C++ has no counterpart for; use "
                         "float, int or uint scalars, vectors and matrices");
    const uint32_t count = member.bytes / 4;
    return scalar + " " + member.name + (count > 1 ? "[" + number(count) + "]" : "") + ";";
}

Result<std::string> parameterStruct(const std::string& name, const Reflection& reflection) {
    std::string body, asserts;
    uint32_t at = 0, pads = 0;
    const auto pad = [&](uint32_t to) {
        if (to > at) body += "    float pad" + number(pads++) + "[" + number((to - at) / 4) + "];\n";
    };
    for (const ParameterMember& member : reflection.parameters) {
        pad(member.offset);
        auto declared = memberDeclaration(member);
        if (!declared) return declared;
        body += "    " + *declared +
                (declared->find('[') == std::string::npos ? "" : "   // " + member.type) + "\n";
        asserts +=
            "static_assert(offsetof(" + name + ", " + member.name + ") == " + number(member.offset) + ");\n";
        at = member.offset + member.bytes;
    }
    pad(reflection.parameterBytes);
    return "struct alignas(16) " + name + " {\n" + body + "};\nstatic_assert(sizeof(" + name +
           ") == " + number(reflection.parameterBytes) + ");\n" + asserts;
}

std::string bindingConstants(const PassInfo& info) {
    if (info.bindings.empty()) return {};
    std::string text = "namespace bindings::" + std::string(info.name) + " {\n";
    for (const auto& each : info.bindings)
        text += "inline constexpr uint32_t " + std::string(each.name) + " = " + number(each.binding) + ";\n";
    return text + "}\n";
}

std::string lookup(const std::string& type, const std::string& function, const std::string& comment,
                   const std::vector<std::pair<std::string, std::string>>& arrays) {
    std::string text = "// " + comment + "\ninline std::span<const " + type + "> " + function +
                       "([[maybe_unused]] std::string_view pass) {\n";
    for (const auto& [pass, array] : arrays)
        if (array != "{}")
            text += "    if (pass == " + literal(pass) + ") return generated::" + array + ";\n";
    return text + "    return {};\n}\n";
}

constexpr const char* head = R"(// SPDX-License-Identifier: Apache-2.0
// Generated by reprisec from pack.toml and the HLSL; edit those and run it again.
#pragma once

#include "reprise/pack.hpp"

#include <cstddef>

namespace reprise {

// A module that is committed. A reason says why that target of it does not exist; empty: it does.
struct PackModule {
    std::string_view variant;
    Stage stage;
    std::string_view glsl450Reason, glslEsReason;
};

)";

} // namespace

Result<std::string> tableHeader(const Pack& pack, const std::vector<Product>& products) {
    Arrays arrays;
    std::string structs;
    std::vector<std::string> passes;
    std::vector<std::pair<std::string, std::string>> presets, modules;
    for (size_t i = 0; i < pack.passes().size(); ++i) {
        const PassInfo& info = pack.passes()[i];
        auto parameters = parametersOf(info, products);
        if (!parameters) return parameters.error();
        structs += "// " + std::string(info.name) + ": " + std::string(info.summary) + "\n";
        if (parameters->parameterBytes > 0) {
            auto text = parameterStruct(pack.storage->sources[i].parameters, *parameters);
            if (!text) return badShader(std::string(info.name) + ": " + text.error().message);
            structs += *text;
        }
        structs += bindingConstants(info) + "\n";
        passes.push_back(passElement(arrays, info, parameters->parameterBytes));
        presets.emplace_back(info.name, addPresets(arrays, pack, info));
        modules.emplace_back(info.name, addModules(arrays, info, products));
    }
    arrays.add("PassInfo", "passes", passes);
    return head + structs + "namespace generated {\n\n" + arrays.text + "\n} // namespace generated\n\n" +
           "// Every pass, in the order of pack.toml.\n"
           "inline std::span<const PassInfo> packPasses() { return generated::passes; }\n" +
           lookup("PresetInfo", "packPresets", "The named presets of a pass.", presets) +
           lookup("PackModule", "packModules", "The committed modules of a pass.", modules) +
           "\n} // namespace reprise\n";
}

} // namespace reprisec
