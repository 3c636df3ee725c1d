// SPDX-License-Identifier: Apache-2.0
// SPIRV-Cross: SPIR-V to GLSL 4.50 and ES, with the names of the HLSL resources.
#include "internal.hpp"

#include <algorithm>
#include <cctype>

#include <spirv_cross/spirv.hpp>
#include <spirv_cross/spirv_glsl.hpp>

namespace reprisec {

namespace {

namespace sx = spirv_cross;

sx::CompilerGLSL::Options optionsFor(Stage stage, GlslTarget target) {
    sx::CompilerGLSL::Options options;
    options.es = target == GlslTarget::es;
    options.version = !options.es ? 450 : stage == Stage::compute ? 310 : 300;
    options.fragment.default_float_precision = sx::CompilerGLSL::Options::Highp;
    options.fragment.default_int_precision = sx::CompilerGLSL::Options::Highp;
    // Images then lie in memory as Vulkan's do, top row first, and depth is [0,1] after GL's own mapping.
    options.vertex.flip_vert_y = true;
    options.vertex.fixup_clipspace = true;
    options.relax_nan_checks = true; // GLSL has no clamp that says what NaN becomes
    return options;
}

// A texture that is both sampled and fetched becomes two uniforms; the second gets this suffix, and is merged
// into the first in the text.
const std::string fetchedSuffix = "_fetched";

std::vector<std::string> nameCombinedSamplers(sx::CompilerGLSL& compiler) {
    const uint32_t dummy = compiler.build_dummy_sampler_for_combined_images();
    compiler.build_combined_image_samplers();
    std::vector<std::string> merged;
    std::map<uint32_t, uint32_t> samplerOf;
    for (const auto& each : compiler.get_combined_image_samplers())
        if (each.sampler_id != dummy) {
            if (samplerOf.contains(each.image_id))
                throw sx::CompilerError(
                    "texture " + compiler.get_name(each.image_id) +
                    " is read through two samplers, and GLSL joins the two; declare it twice");
            samplerOf[each.image_id] = each.sampler_id;
        }
    for (const auto& each : compiler.get_combined_image_samplers()) {
        std::string name = compiler.get_name(each.image_id);
        if (each.sampler_id == dummy && samplerOf.contains(each.image_id)) {
            merged.push_back(name);
            name += fetchedSuffix;
        }
        compiler.set_name(each.combined_id, name);
        compiler.set_decoration(each.combined_id, spv::DecorationBinding,
                                compiler.get_decoration(each.image_id, spv::DecorationBinding));
    }
    return merged;
}

bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

void replaceWord(std::string& text, const std::string& from, const std::string& to) {
    for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + 1)) {
        const bool whole = (at == 0 || !isWord(text[at - 1])) &&
                           (at + from.size() >= text.size() || !isWord(text[at + from.size()]));
        if (whole) text.replace(at, from.size(), to);
    }
}

void mergeFetched(std::string& text, const std::string& name) {
    const std::string alias = name + fetchedSuffix;
    const size_t declared = text.find(" " + alias + ";");
    if (declared == std::string::npos) return;
    const size_t begin = text.rfind('\n', declared) + 1;
    text.erase(begin, text.find('\n', declared) + 1 - begin);
    replaceWord(text, alias, name);
}

// GLSL before 4.10 links stages by name, so both sides carry the location.
void nameVaryings(sx::CompilerGLSL& compiler, const sx::SmallVector<sx::Resource>& varyings) {
    for (const sx::Resource& each : varyings)
        compiler.set_name(
            each.id, "varying" + std::to_string(compiler.get_decoration(each.id, spv::DecorationLocation)));
}

void nameInterface(sx::CompilerGLSL& compiler, Stage stage, const GlslNames& names) {
    const sx::ShaderResources resources = compiler.get_shader_resources();
    if (stage == Stage::vertex) nameVaryings(compiler, resources.stage_outputs);
    if (stage == Stage::fragment) {
        nameVaryings(compiler, resources.stage_inputs);
        for (const sx::Resource& each : resources.stage_outputs) {
            const uint32_t location = compiler.get_decoration(each.id, spv::DecorationLocation);
            if (location < names.outputs.size()) compiler.set_name(each.id, names.outputs[location]);
        }
    }
    // A cbuffer has no instance name; without one SPIRV-Cross would number it.
    for (const sx::Resource& each : resources.uniform_buffers)
        if (compiler.get_name(each.id).empty()) compiler.set_name(each.id, "parameters");
}

// What ES 3.10 can write (OpenGL ES 3.1, table 8.27).
const std::map<std::string, uint32_t>& esStorageFormats() {
    static const std::map<std::string, uint32_t> formats{{"r32f", spv::ImageFormatR32f},
                                                         {"rgba16f", spv::ImageFormatRgba16f},
                                                         {"rgba32f", spv::ImageFormatRgba32f},
                                                         {"rgba8", spv::ImageFormatRgba8},
                                                         {"rgba8_snorm", spv::ImageFormatRgba8Snorm},
                                                         {"r32i", spv::ImageFormatR32i},
                                                         {"r32ui", spv::ImageFormatR32ui},
                                                         {"rgba32ui", spv::ImageFormatRgba32ui}};
    return formats;
}

// Desktop GL writes images without naming their format; ES must name one.
Result<Words> forTarget(const Words& module, Stage stage, GlslTarget target, const GlslNames& names) {
    if (target != GlslTarget::es) return module;
    std::map<std::string, uint32_t> formats;
    const sx::Compiler compiler(module);
    const sx::ShaderResources resources = compiler.get_shader_resources();
    if (stage != Stage::compute && !resources.storage_buffers.empty())
        return badShader("ES 3.00 has no storage buffers (" +
                         compiler.get_name(resources.storage_buffers.front().id) + ")");
    for (const auto& image : resources.storage_images) {
        const std::string name = compiler.get_name(image.id);
        const auto wanted = names.formats.find(name);
        if (wanted == names.formats.end())
            return badShader("no format is known for the storage image " + name + ", and ES demands one");
        const auto format = esStorageFormats().find(wanted->second);
        if (format == esStorageFormats().end())
            return badShader("ES 3.10 has no " + wanted->second + " storage images (" + name +
                             "); use the fragment form");
        formats[name] = format->second;
    }
    return withStorageFormats(module, formats);
}

std::string compileText(const Words& module, Stage stage, GlslTarget target, const GlslNames& names) {
    sx::CompilerGLSL compiler(module);
    compiler.set_common_options(optionsFor(stage, target));
    const auto merged = nameCombinedSamplers(compiler);
    nameInterface(compiler, stage, names);
    std::string text = compiler.compile();
    for (const std::string& name : merged)
        mergeFetched(text, name);
    return text;
}

std::string targetName(Stage stage, GlslTarget target) {
    if (target == GlslTarget::gl450) return "GLSL 4.50";
    return stage == Stage::compute ? "GLSL ES 3.10" : "GLSL ES 3.00";
}

} // namespace

Result<std::string> emitGlsl(const Words& module, Stage stage, GlslTarget target, const GlslNames& names) {
    std::string text;
    try {
        auto input = forTarget(module, stage, target, names);
        if (!input) return input.error();
        text = compileText(*input, stage, target, names);
    } catch (const std::exception& error) {
        return badShader(targetName(stage, target) + " cannot express it: " + error.what());
    }
    if (auto checked = checkGlsl("emitted", text, stage); !checked)
        return badShader(targetName(stage, target) + " does not compile: " + checked.error().message);
    return text;
}

} // namespace reprisec
