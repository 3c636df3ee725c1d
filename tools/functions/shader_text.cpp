// SPDX-License-Identifier: Apache-2.0
// The shader around a function: bindings, loads of the inputs, stores of the outputs.
#include "shader_text.hpp"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace functions {

namespace {

using reprise::Stage;

// The header's text in place of its #include: its guard keeps the unchanged file out.
std::string includeOf(const std::filesystem::path& hlsl, const std::string& header,
                      const Mutation& mutation) {
    if (header != mutation.header) return "#include \"" + header + "\"\n";
    std::string text = hlslText(hlsl, header);
    const size_t at = text.find(mutation.find);
    if (at == std::string::npos)
        throw std::runtime_error("\"" + mutation.find + "\" is not in " + header +
                                 "; the mutation is stale.");
    return text.replace(at, mutation.find.size(), mutation.replacement);
}

std::string declarations(const Function& function) {
    std::ostringstream text;
    for (size_t i = 0; i < function.textures.size(); ++i)
        text << (function.textures[i].linear ? "TEXTURE_LINEAR" : "TEXTURE_POINT") << "(gTexture" << i << ", "
             << textureBinding + i << ");\n";
    if (function.inputs > 0)
        text << "[[vk::binding(" << inputBinding << ")]] "
             << (function.stage == Stage::compute ? "StructuredBuffer" : "Texture2D") << "<float4> gIn;\n";
    return text.str();
}

std::string loads(const Function& function) {
    std::ostringstream text;
    for (int i = 0; i < function.inputs; ++i) {
        text << "    float4 in" << i << " = gIn[";
        if (function.stage == Stage::compute)
            text << "row * " << function.inputs << " + " << i << "];\n";
        else
            text << "uint2(uint(positionPx.x) * " << function.inputs << " + " << i
                 << ", uint(positionPx.y))];\n";
    }
    for (int i = 0; i < function.outputs; ++i)
        text << "    float4 out" << i << " = 0.0;\n";
    return text.str();
}

std::string computeText(const Function& function) {
    std::ostringstream text;
    for (int i = 0; i < function.outputs; ++i)
        text << "[[vk::binding(" << outputBinding + static_cast<uint32_t>(i) << ")]] RWTexture2D<float4> gOut"
             << i << ";\n";
    text << "[numthreads(" << groupSide << ", " << groupSide << ", 1)]\n"
         << "void mainCompute(uint3 thread : SV_DispatchThreadID) {\n"
         << "    uint row = thread.y * " << rowLength << " + thread.x;\n"
         << loads(function) << function.body << "\n";
    for (int i = 0; i < function.outputs; ++i)
        text << "    gOut" << i << "[thread.xy] = out" << i << ";\n";
    return text.str() + "}\n";
}

std::string fragmentText(const Function& function) {
    std::ostringstream text;
    text << "struct Outputs {\n";
    for (int i = 0; i < function.outputs; ++i)
        text << "    float4 target" << i << " : SV_Target" << i << ";\n";
    text << "};\nOutputs mainFragment(float4 positionPx : SV_Position) {\n"
         << loads(function) << function.body << "\n    Outputs outputs;\n";
    for (int i = 0; i < function.outputs; ++i)
        text << "    outputs.target" << i << " = out" << i << ";\n";
    return text.str() + "    return outputs;\n}\n";
}

} // namespace

std::string hlslText(const std::filesystem::path& hlsl, const std::string& file) {
    std::ifstream stream(hlsl / file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + (hlsl / file).string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string shaderText(const std::filesystem::path& hlsl, const Function& function,
                       const Mutation& mutation) {
    // The mutated header comes first, before another one can include the unchanged file.
    std::string text = mutation.header.empty() ? "" : includeOf(hlsl, mutation.header, mutation);
    for (const std::string& header : function.headers)
        text += includeOf(hlsl, header, {});
    if (!function.textures.empty()) text += "#include \"reprise/platform.hlsli\"\n";
    text += declarations(function) + function.helpers;
    return text + (function.stage == Stage::compute ? computeText(function) : fragmentText(function));
}

} // namespace functions
