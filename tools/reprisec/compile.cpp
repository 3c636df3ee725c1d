// SPDX-License-Identifier: Apache-2.0
// The way from a variant or a text to everything that is emitted from it.
#include "internal.hpp"

#include <algorithm>
#include <cstring>

namespace reprisec {

namespace {

using reprise::BindingKind;

// PLATFORM_GLES asks the HLSL for what ES lacks done without, so the ES text has a module of its own.
constexpr const char* esSwitch = "PLATFORM_GLES";

Result<Words> moduleFrom(const Source& source, const Defines& defines, std::vector<fs::path>* dependencies) {
    auto front = hlslToSpirv(source, defines);
    if (!front) return front.error();
    if (dependencies) *dependencies = front->headers;
    auto optimised = optimise(withoutStorageFormats(front->spirv));
    if (!optimised) return badShader(source.name + ":1: " + optimised.error().message);
    Words module = withDefinedSaturate(withStorageAccess(*optimised));
    if (auto valid = validate(module); !valid) return badShader(source.name + ":1: " + valid.error().message);
    return module;
}

void emitInto(const Result<std::string>& text, std::optional<std::string>& target, std::string& reason) {
    if (text)
        target = *text;
    else
        reason = text.error().message;
}

Result<void> emitTargets(const Source& source, const Defines& defines, const Words& module,
                         const GlslNames& names, Compiled& compiled) {
    emitInto(emitGlsl(module, source.stage, GlslTarget::gl450, names), compiled.glsl450,
             compiled.glsl450Reason);
    if (!defines.contains(esSwitch) || defines.at(esSwitch) != 0) {
        emitInto(emitGlsl(module, source.stage, GlslTarget::es, names), compiled.glslEs,
                 compiled.glslEsReason);
        return {};
    }
    Defines forEs = defines;
    forEs[esSwitch] = 1;
    auto esModule = moduleFrom(source, forEs, nullptr);
    if (!esModule) return badShader(esModule.error().message + " (with PLATFORM_GLES)");
    emitInto(emitGlsl(*esModule, source.stage, GlslTarget::es, names), compiled.glslEs,
             compiled.glslEsReason);
    return {};
}

Result<Compiled> compileText(const Source& source, const Defines& defines, const GlslNames& names,
                             bool glsl) {
    Compiled compiled;
    auto module = moduleFrom(source, defines, &compiled.dependencies);
    if (!module) return module.error();
    compiled.spirv = withoutDebugNames(*module);
    if (auto valid = validate(compiled.spirv); !valid)
        return badShader(source.name + ":1: " + valid.error().message);
    auto reflection = reflect(compiled.spirv, source.stage);
    if (!reflection) return badShader(source.name + ":1: " + reflection.error().message);
    compiled.reflection = std::move(*reflection);
    if (!glsl)
        compiled.glsl450Reason = compiled.glslEsReason = "not asked for";
    else if (auto emitted = emitTargets(source, defines, *module, names, compiled); !emitted)
        return emitted.error();
    return compiled;
}

const PassInfo* findPass(const Pack& pack, const Variant& variant) {
    if (!variant.pass) return nullptr;
    const auto pass = std::ranges::find(pack.passes(), variant.pass->name, &PassInfo::name);
    return pass == pack.passes().end() ? nullptr : &*pass;
}

// Names of images that this variant is without, by the table's own conditions.
bool isAbsent(const Variant& variant, std::string_view name) {
    for (const auto* images : {&variant.pass->inputs, &variant.pass->outputs})
        for (const auto& image : *images)
            if (image.name == name) return !reprise::exists(variant, image);
    return false;
}

std::string textureOf(const std::string& name) {
    constexpr std::string_view suffix = "_sampler";
    return name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : name;
}

// The module may use no binding that the table does not promise, for the plan provides only those.
Result<void> checkBindings(const Variant& variant, const fs::path& table, Reflection& reflection) {
    for (BindingUse& use : reflection.bindings) {
        const auto& known = variant.pass->bindings;
        const auto entry = std::ranges::find_if(
            known, [&](const auto& each) { return each.name == use.name && each.binding == use.binding; });
        if (entry == known.end())
            return badShader(use.name + " has binding " + std::to_string(use.binding) + ", which " +
                             table.string() + " does not list for this pass; make the two agree");
        if (isAbsent(variant, textureOf(use.name)))
            return badShader(use.name + " is used, but `when` in " + table.string() +
                             " says that this variant has none; make the two agree");
        use.kind = entry->kind;
    }
    return {};
}

Result<void> checkForm(const Variant& variant, Stage stage, const Reflection& reflection) {
    if (stage == Stage::compute && !std::ranges::equal(reflection.threads, reprise::threadsOf(variant)))
        return badShader("numthreads differs from `threads` in the table; make the two agree");
    const auto outputs = static_cast<uint32_t>(std::ranges::count_if(
        variant.pass->outputs, [&](const auto& image) { return reprise::exists(variant, image); }));
    if (stage == Stage::fragment && reflection.colourOutputs != outputs)
        return badShader("it writes " + std::to_string(reflection.colourOutputs) +
                         " targets where the table has " + std::to_string(outputs) +
                         " outputs; make the two agree");
    return {};
}

GlslNames namesOf(const Variant& variant) {
    GlslNames names;
    for (const auto& output : variant.pass->outputs)
        if (reprise::exists(variant, output)) {
            names.outputs.emplace_back(output.name);
            names.formats.emplace(output.name, reprise::formatOf(variant, output));
        }
    return names;
}

Result<Compiled> compileVariant(const Pack& pack, const Variant& variant, Stage stage,
                                const Options& options) {
    const auto& storage = *pack.storage;
    const size_t index = static_cast<size_t>(variant.pass - storage.passes.data());
    const fs::path& file = storage.sources[index].file;
    auto text = readText(file);
    if (!text) return text.error();
    auto defines = definesOf(pack, &variant, stage, options.platformSwitches);
    if (!defines) return defines.error();
    const Source source{file.string(), *text, std::string(entryPoint(stage)),
                        stage,         {},    storage.includeDirectories};
    auto compiled = compileText(source, *defines, namesOf(variant), options.glsl);
    if (!compiled) return compiled;
    compiled->dependencies.insert(compiled->dependencies.begin(), file);
    auto checked = checkBindings(variant, pack.file(), compiled->reflection);
    if (checked) checked = checkForm(variant, stage, compiled->reflection);
    if (!checked) return badShader(file.string() + ":1: " + checked.error().message);
    return compiled;
}

// Of the first stage that uses the parameters. HLSL that does not compile says so in compile(); here it is 0.
uint32_t parameterBytes(const Pack& pack, size_t index) {
    const PassInfo& pass = pack.storage->passes[index];
    const fs::path& file = pack.storage->sources[index].file;
    const Variant variant{&pass, {}};
    const auto text = readText(file);
    for (Stage stage : pass.stages) {
        const auto defines = definesOf(pack, &variant, stage, {});
        if (!text || !defines) return 0;
        const Source source{file.string(), *text, std::string(entryPoint(stage)),
                            stage,         {},    pack.storage->includeDirectories};
        const auto front = hlslToSpirv(source, *defines);
        if (!front) return 0;
        const auto reflection = reflect(front->spirv, stage);
        if (reflection && reflection->parameterBytes > 0) return reflection->parameterBytes;
    }
    return 0;
}

Error located(const Error& error, const std::string& what, Stage stage) {
    return {error.code, error.message + " [" + what + ", " + std::string(stageWord(stage)) + "]"};
}

// A directory with a pack.toml knows the macros that its headers test; they are 0 unless the source says so.
Result<Defines> definesFor(const Source& source, const Options& options) {
    Defines defines;
    for (const fs::path& directory : source.includeDirectories) {
        std::error_code ignored;
        if (!fs::is_regular_file(directory / "pack.toml", ignored)) continue;
        auto table = readTable(directory / "pack.toml");
        if (!table) return table.error();
        Pack pack;
        pack.storage = *table;
        auto known = definesOf(pack, nullptr, source.stage, {});
        if (!known) return known.error();
        defines.merge(*known);
    }
    defines["STAGE_COMPUTE"] = source.stage == Stage::compute;
    for (const auto& [name, value] : options.platformSwitches)
        defines[name] = value;
    for (const auto& [name, value] : source.defines)
        defines[name] = value;
    return defines;
}

} // namespace

Result<Pack> Pack::load(const fs::path& packToml) {
    auto table = readTable(packToml);
    if (!table) return table.error();
    Pack pack;
    pack.storage = *table;
    for (size_t i = 0; i < pack.storage->passes.size(); ++i)
        if (!pack.storage->sources[i].parameters.empty())
            (*table)->passes[i].parameterBytes = parameterBytes(pack, i);
    return pack;
}

Result<Compiled> compile(const Pack& pack, const Variant& variant, Stage stage, const Options& options) {
    const PassInfo* pass = findPass(pack, variant);
    if (!pass)
        return Error{ErrorCode::invalidArgument, "the variant is of no pass of " + pack.file().string()};
    // The variant may come from the generated table; here it is one of this pack.
    Variant own = reprise::forStage(variant, stage);
    own.pass = pass;
    const std::string name = reprise::variantName(own);
    if (std::ranges::find(pass->stages, stage) == pass->stages.end())
        return located({ErrorCode::invalidArgument, "the pass has no such stage in " + pack.file().string()},
                       name, stage);
    auto compiled = compileVariant(pack, own, stage, options);
    if (!compiled) return located(compiled.error(), name, stage);
    return compiled;
}

Result<Compiled> compileSource(const Source& source, const Options& options) {
    auto defines = definesFor(source, options);
    if (!defines) return located(defines.error(), source.name, source.stage);
    auto compiled = compileText(source, *defines, {}, options.glsl);
    if (!compiled) return located(compiled.error(), source.name, source.stage);
    return compiled;
}

} // namespace reprisec
