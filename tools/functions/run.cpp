// SPDX-License-Identifier: Apache-2.0
// A function as a pass of its own on the device.
#include "shader_text.hpp"

#include "reprisec.hpp"

#include <cstring>
#include <deque>
#include <stdexcept>

namespace functions {

namespace {

using reprise::BindingInfo;
using reprise::BindingKind;
using reprise::ImageInfo;
using reprise::Stage;

std::vector<uint32_t> compileOrThrow(const reprisec::Source& source) {
    auto compiled = reprisec::compileSource(source);
    if (!compiled) throw std::runtime_error(compiled.error().message);
    return compiled->spirv;
}

std::vector<uint32_t> compileFunction(const std::filesystem::path& hlsl, const Function& function,
                                      const Mutation& mutation) {
    const bool compute = function.stage == Stage::compute;
    return compileOrThrow({.name = function.name,
                           .text = shaderText(hlsl, function, mutation),
                           .entry = compute ? "mainCompute" : "mainFragment",
                           .stage = function.stage,
                           .defines = function.defines,
                           .includeDirectories = {hlsl}});
}

const std::vector<uint32_t>& fullscreenVertex(const std::filesystem::path& hlsl) {
    static const std::vector<uint32_t> spirv =
        compileOrThrow({.name = "fullscreen.hlsl",
                        .text = hlslText(hlsl, "passes/fullscreen.hlsl"),
                        .entry = "mainVertex",
                        .stage = Stage::vertex,
                        .defines = {},
                        .includeDirectories = {hlsl}});
    return spirv;
}

std::string numbered(std::string name, int number) {
    return name.append(std::to_string(number));
}

// The function as a pass of its own, so that the harness can run it; owns what the spans point to.
struct FunctionPass {
    std::deque<std::string> names;
    std::vector<BindingInfo> bindings;
    std::vector<ImageInfo> outputs;
    reprise::PassInfo info{};

    explicit FunctionPass(const Function& function) {
        // A fragment's helper invocations may read 0 from a buffer, where an image gives them its texels.
        if (function.inputs > 0)
            bind("gIn", inputBinding,
                 function.stage == Stage::compute ? BindingKind::storageBuffer : BindingKind::sampledImage);
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

harness::Image uploaded(harness::Gpu& gpu, const Image& image) {
    harness::Image made = gpu.image(VK_FORMAT_R32G32B32A32_SFLOAT, static_cast<uint32_t>(image.width),
                                    static_cast<uint32_t>(image.height));
    std::vector<float> floats;
    for (const dvec4& texel : image.texels)
        for (int channel = 0; channel < 4; ++channel)
            floats.push_back(static_cast<float>(texel[channel]));
    gpu.uploadFloats(made, floats);
    return made;
}

// One row after the other, the rest zero.
std::vector<float> inputFloats(const Function& function, const std::vector<Row>& inputs, size_t rows) {
    std::vector<float> floats;
    floats.reserve(rows * static_cast<size_t>(function.inputs) * 4);
    for (const Row& row : inputs) {
        if (row.size() != static_cast<size_t>(function.inputs))
            throw std::runtime_error("a row of " + function.name + " has the wrong number of inputs");
        for (const vec4& in : row)
            floats.insert(floats.end(), {in.x, in.y, in.z, in.w});
    }
    floats.resize(rows * static_cast<size_t>(function.inputs) * 4);
    return floats;
}

void throwValidationMessages(harness::Gpu& gpu, const std::string& name) {
    const auto messages = gpu.takeValidationMessages();
    if (!messages.empty())
        throw std::runtime_error(name + ": the validation layer says: " + messages.front());
}

std::vector<Row> collect(harness::Gpu& gpu, std::vector<harness::Image>& images, size_t rows) {
    std::vector<Row> result(rows);
    for (harness::Image& image : images) {
        const std::vector<float> floats = gpu.downloadFloats(image);
        for (size_t row = 0; row < rows; ++row) {
            const float* texel = floats.data() + row * 4;
            result[row].emplace_back(texel[0], texel[1], texel[2], texel[3]);
        }
    }
    return result;
}

} // namespace

std::vector<Row> run(const Bench& bench, const Function& function, const std::vector<Row>& inputs,
                     const RunOptions& options) {
    harness::Gpu& gpu = bench.gpu;
    const bool byRows = function.stage == Stage::compute || function.inputs > 0;
    const uint32_t lines = (static_cast<uint32_t>(inputs.size()) + rowLength - 1) / rowLength;
    const uint32_t width = byRows ? rowLength : static_cast<uint32_t>(options.extent.x);
    const uint32_t height =
        byRows ? (lines + groupSide - 1) / groupSide * groupSide : static_cast<uint32_t>(options.extent.y);
    const FunctionPass pass(function);
    const std::vector<uint32_t> spirv = compileFunction(bench.hlsl, function, options.mutation);
    const std::vector<VkFormat> formats(pass.outputs.size(), harness::formatByName(options.outputFormat));
    harness::PassRunner runner(gpu, {&pass.info, {}}, function.stage, spirv, fullscreenVertex(bench.hlsl),
                               formats);

    std::deque<harness::Image> textures;
    std::vector<harness::Image> outputs;
    for (const Texture& texture : function.textures)
        textures.push_back(uploaded(gpu, texture.image));
    for (size_t i = 0; i < formats.size(); ++i)
        outputs.push_back(gpu.image(formats[i], width, height));
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
    harness::Image rowImage;
    if (function.inputs > 0) {
        const auto floats = inputFloats(function, inputs, static_cast<size_t>(width) * height);
        if (function.stage == Stage::compute) {
            rows = gpu.buffer(floats.size() * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
            std::memcpy(rows.mapped, floats.data(), floats.size() * sizeof(float));
            buffers.push_back({"gIn", rows.buffer, 0, VK_WHOLE_SIZE});
        } else {
            rowImage = gpu.image(VK_FORMAT_R32G32B32A32_SFLOAT,
                                 width * static_cast<uint32_t>(function.inputs), height);
            gpu.uploadFloats(rowImage, floats);
            images.push_back({"gIn", &rowImage});
        }
    }
    const vec4 parameters(0.0f);
    gpu.run([&](VkCommandBuffer commands) {
        runner.record(commands, images, std::as_bytes(std::span(&parameters, 1)), buffers);
    });
    auto result = collect(gpu, outputs, byRows ? inputs.size() : static_cast<size_t>(width) * height);
    throwValidationMessages(gpu, function.name);
    return result;
}

} // namespace functions
