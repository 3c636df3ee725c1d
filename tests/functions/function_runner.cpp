// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"

#include "harness.hpp"
#include "reprisec.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace functions {

namespace {

using reprise::BindingInfo;
using reprise::BindingKind;
using reprise::ImageInfo;
using reprise::Stage;

constexpr uint32_t inputBinding = 1, textureBinding = 4, samplerDistance = 32, outputBinding = 16;
constexpr uint32_t rowLength = 64, groupSide = 8;
constexpr float unbounded = std::numeric_limits<float>::infinity();

harness::Gpu& gpu() {
    static harness::Gpu instance(harness::DeviceOptions{.device = "", .validation = true});
    return instance;
}

std::filesystem::path hlslDirectory() {
    return REPRISE_HLSL_DIRECTORY;
}

// The header's text in place of its #include: its guard keeps the unchanged file out.
std::string includeOf(const std::string& header, const Mutation& mutation) {
    if (header != mutation.header) return "#include \"" + header + "\"\n";
    std::string text = hlslText(header);
    const size_t at = text.find(mutation.find);
    if (at == std::string::npos)
        throw std::runtime_error("\"" + mutation.find + "\" is not in " + header +
                                 "; the mutation is stale.");
    return text.replace(at, mutation.find.size(), mutation.replacement);
}

std::string numbered(std::string name, int number) {
    return name.append(std::to_string(number));
}

std::string declarations(const Function& function) {
    std::ostringstream text;
    for (size_t i = 0; i < function.textures.size(); ++i)
        text << (function.textures[i].linear ? "TEXTURE_LINEAR" : "TEXTURE_POINT") << "(gTexture" << i << ", "
             << textureBinding + i << ");\n";
    if (function.inputs > 0)
        text << "[[vk::binding(" << inputBinding << ")]] StructuredBuffer<float4> gIn;\n";
    return text.str();
}

std::string loads(const Function& function) {
    std::ostringstream text;
    for (int i = 0; i < function.inputs; ++i)
        text << "    float4 in" << i << " = gIn[row * " << function.inputs << " + " << i << "];\n";
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

std::string shaderText(const Function& function, const Mutation& mutation) {
    // The mutated header comes first, before another one can include the unchanged file.
    std::string text = mutation.header.empty() ? "" : includeOf(mutation.header, mutation);
    for (const std::string& header : function.headers)
        text += includeOf(header, {});
    if (!function.textures.empty()) text += "#include \"reprise/platform.hlsli\"\n";
    text += declarations(function);
    return text + (function.stage == Stage::compute ? computeText(function) : fragmentText(function));
}

std::vector<uint32_t> compileOrThrow(const reprisec::Source& source) {
    auto compiled = reprisec::compileSource(source);
    if (!compiled) throw std::runtime_error(compiled.error().message);
    return compiled->spirv;
}

std::vector<uint32_t> compileFunction(const Function& function, const Mutation& mutation) {
    const bool compute = function.stage == Stage::compute;
    return compileOrThrow({.name = function.name,
                           .text = shaderText(function, mutation),
                           .entry = compute ? "mainCompute" : "mainFragment",
                           .stage = function.stage,
                           .defines = function.defines,
                           .includeDirectories = {hlslDirectory()}});
}

const std::vector<uint32_t>& fullscreenVertex() {
    static const std::vector<uint32_t> spirv = compileOrThrow({.name = "fullscreen.hlsl",
                                                               .text = hlslText("passes/fullscreen.hlsl"),
                                                               .entry = "mainVertex",
                                                               .stage = Stage::vertex,
                                                               .defines = {},
                                                               .includeDirectories = {hlslDirectory()}});
    return spirv;
}

// The function as a pass of its own, so that the harness can run it; owns what the spans point to.
struct FunctionPass {
    std::deque<std::string> names;
    std::vector<BindingInfo> bindings;
    std::vector<ImageInfo> outputs;
    reprise::PassInfo info{};

    explicit FunctionPass(const Function& function) {
        if (function.inputs > 0) bind("gIn", inputBinding, BindingKind::storageBuffer);
        for (size_t i = 0; i < function.textures.size(); ++i) {
            const uint32_t binding = textureBinding + static_cast<uint32_t>(i);
            const std::string name = numbered("gTexture", static_cast<int>(i));
            bind(name, binding, BindingKind::sampledImage);
            bind(name + "_sampler", binding + samplerDistance,
                 function.textures[i].linear ? BindingKind::linearSampler : BindingKind::pointSampler);
        }
        for (int i = 0; i < function.outputs; ++i) {
            bind(numbered("gOut", i), outputBinding + static_cast<uint32_t>(i), BindingKind::storageImage);
            ImageInfo output{};
            output.name = names.back();
            output.scale = 1.0f;
            outputs.push_back(output);
        }
        info.name = function.name;
        info.stages = {&function.stage, 1};
        info.fullscreen = true;
        info.threads[0] = info.threads[1] = groupSide;
        info.threads[2] = 1;
        info.pixelsPerThread[0] = info.pixelsPerThread[1] = 1;
        info.parameterBytes = sizeof(vec4); // an arena of no bytes cannot be made; no shader here reads it
        info.bindings = bindings;
        info.outputs = outputs;
    }

    void bind(const std::string& name, uint32_t binding, BindingKind kind) {
        names.push_back(name);
        bindings.push_back({names.back(), binding, kind});
    }
};

harness::Image uploaded(const Image& image) {
    harness::Image made = gpu().image(VK_FORMAT_R32G32B32A32_SFLOAT, static_cast<uint32_t>(image.width),
                                      static_cast<uint32_t>(image.height));
    std::vector<float> floats;
    for (const dvec4& texel : image.texels)
        for (int channel = 0; channel < 4; ++channel)
            floats.push_back(static_cast<float>(texel[channel]));
    gpu().uploadFloats(made, floats);
    return made;
}

harness::Buffer inputBuffer(const Function& function, const std::vector<Row>& inputs, size_t rows) {
    const size_t values = rows * static_cast<size_t>(function.inputs);
    harness::Buffer buffer = gpu().buffer(values * sizeof(vec4), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    std::memset(buffer.mapped, 0, values * sizeof(vec4));
    for (size_t row = 0; row < inputs.size(); ++row) {
        if (inputs[row].size() != static_cast<size_t>(function.inputs))
            throw std::runtime_error("a row of " + function.name + " has the wrong number of inputs");
        const size_t bytes = inputs[row].size() * sizeof(vec4);
        std::memcpy(buffer.mapped + row * bytes, inputs[row].data(), bytes);
    }
    return buffer;
}

void throwValidationMessages(const std::string& name) {
    const auto messages = gpu().takeValidationMessages();
    if (!messages.empty())
        throw std::runtime_error(name + ": the validation layer says: " + messages.front());
}

std::vector<Row> collect(std::vector<harness::Image>& images, size_t rows) {
    std::vector<Row> result(rows);
    for (harness::Image& image : images) {
        const std::vector<float> floats = gpu().downloadFloats(image);
        for (size_t row = 0; row < rows; ++row) {
            const float* texel = floats.data() + row * 4;
            result[row].emplace_back(texel[0], texel[1], texel[2], texel[3]);
        }
    }
    return result;
}

std::string formatted(const vec4& v) {
    std::ostringstream text;
    text.precision(9);
    text << "(" << v.x << ", " << v.y << ", " << v.z << ", " << v.w << ")";
    return text.str();
}

bool agrees(float actual, double expected, double bound) {
    if (bound == std::numeric_limits<double>::infinity()) return std::isfinite(actual);
    if (std::isnan(bound)) return true;
    return std::abs(static_cast<double>(actual) - expected) <= bound; // false for NaN
}

// What is wrong with one row, or nothing.
std::string mismatch(const std::vector<Expected>& expected, const Row& outputs) {
    std::ostringstream text;
    text.precision(12);
    for (size_t i = 0; i < expected.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const double value = expected[i].value[c], bound = expected[i].bound[c];
            if (agrees(outputs[i][c], value, bound)) continue;
            text << "\n    out" << i << "."
                 << "xyzw"[c] << " is " << outputs[i][c] << ", the oracle says " << value << " within "
                 << bound;
        }
    return text.str();
}

} // namespace

std::string hlslText(const std::string& file) {
    std::ifstream stream(hlslDirectory() / file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Row> run(const Function& function, const std::vector<Row>& inputs, const RunOptions& options) {
    const bool compute = function.stage == Stage::compute;
    const uint32_t lines = (static_cast<uint32_t>(inputs.size()) + rowLength - 1) / rowLength;
    const uint32_t width = compute ? rowLength : static_cast<uint32_t>(options.extent.x);
    const uint32_t height =
        compute ? (lines + groupSide - 1) / groupSide * groupSide : static_cast<uint32_t>(options.extent.y);
    const FunctionPass pass(function);
    const std::vector<uint32_t> spirv = compileFunction(function, options.mutation);
    const std::vector<VkFormat> formats(pass.outputs.size(), harness::formatByName(options.outputFormat));
    harness::PassRunner runner(gpu(), {&pass.info, {}}, function.stage, spirv, fullscreenVertex(), formats);

    std::deque<harness::Image> textures;
    std::vector<harness::Image> outputs;
    for (const Texture& texture : function.textures)
        textures.push_back(uploaded(texture.image));
    for (size_t i = 0; i < formats.size(); ++i)
        outputs.push_back(gpu().image(formats[i], width, height));
    std::vector<harness::PassRunner::Binding> images;
    size_t next = function.inputs > 0 ? 1 : 0;
    for (harness::Image& texture : textures) {
        images.push_back({pass.bindings[next].name, &texture});
        next += 2;
    }
    for (size_t i = 0; i < outputs.size(); ++i)
        images.push_back({pass.outputs[i].name, &outputs[i]});
    std::vector<reprise::NamedBuffer> buffers;
    harness::Buffer rows;
    if (function.inputs > 0) {
        rows = inputBuffer(function, inputs, static_cast<size_t>(width) * height);
        buffers.push_back({"gIn", rows.buffer, 0, VK_WHOLE_SIZE});
    }
    const vec4 parameters(0.0f);
    gpu().run([&](VkCommandBuffer commands) {
        runner.record(commands, images, std::as_bytes(std::span(&parameters, 1)), buffers);
    });
    auto result = collect(outputs, compute ? inputs.size() : static_cast<size_t>(width) * height);
    throwValidationMessages(function.name);
    return result;
}

Expected near(dvec4 value, double bound) {
    return {value, dvec4(bound)};
}

Expected near(dvec3 value, dvec3 bound) {
    return {dvec4(value, 0.0), dvec4(bound, std::numeric_limits<double>::quiet_NaN())};
}

Expected near(dvec3 value, double bound) {
    return near(value, dvec3(bound));
}

Expected near(dvec2 value, double bound) {
    constexpr double any = std::numeric_limits<double>::quiet_NaN();
    return {dvec4(value, 0.0, 0.0), dvec4(bound, bound, any, any)};
}

Expected near(double value, double bound) {
    constexpr double any = std::numeric_limits<double>::quiet_NaN();
    return {dvec4(value, 0.0, 0.0, 0.0), dvec4(bound, any, any, any)};
}

Expected finite() {
    return {dvec4(0.0), dvec4(unbounded)};
}

std::string mismatches(const Comparison& comparison, const Mutation& mutation) {
    const Function& function = comparison.function;
    const std::vector<Row> outputs = run(function, comparison.inputs, {.mutation = mutation});
    size_t wrong = 0;
    std::string first;
    for (size_t row = 0; row < outputs.size(); ++row) {
        const std::string text = mismatch(comparison.oracle(comparison.inputs[row]), outputs[row]);
        if (text.empty() || ++wrong > 3) continue;
        first += "\n  row " + std::to_string(row) + ":";
        for (const vec4& in : comparison.inputs[row])
            first += " " + formatted(in);
        first += text;
    }
    if (wrong == 0) return "";
    return function.name + ": " + std::to_string(wrong) + " of " + std::to_string(outputs.size()) +
           " rows differ" + first;
}

void expectAgrees(const Comparison& comparison) {
    EXPECT_EQ(mismatches(comparison), "");
}

void expectCaught(const Comparison& comparison, const Mutation& mutation) {
    ASSERT_EQ(mismatches(comparison), "") << "the right form must agree for the wrong one to be told";
    EXPECT_NE(mismatches(comparison, mutation), "")
        << "\"" << mutation.replacement << "\" for \"" << mutation.find << "\" passes unnoticed";
}

} // namespace functions
