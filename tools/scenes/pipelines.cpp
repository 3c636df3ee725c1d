// SPDX-License-Identifier: Apache-2.0
#include "pipelines.hpp"

#include "renderer.hpp"
#include "reprisec.hpp"

#include <fstream>
#include <iterator>
#include <mutex>

namespace scenes {
namespace {

std::filesystem::path& chosenDirectory() {
    static std::filesystem::path directory;
    return directory;
}

std::vector<std::filesystem::path> shaderDirectories() {
    if (!chosenDirectory().empty()) return {chosenDirectory()};
    std::vector<std::filesystem::path> candidates;
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    if (!ignored) candidates.push_back(program.parent_path() / "../share/reprise/scenes");
    candidates.emplace_back(REPRISE_SCENES_SHADER_DIRECTORY);
    return candidates;
}

std::filesystem::path findShader(const std::string& name) {
    std::string tried;
    for (const auto& directory : shaderDirectories()) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(directory / name, ignored)) return directory / name;
        tried += (tried.empty() ? "" : " nor in ") + directory.string();
    }
    throw std::runtime_error("The scene shader " + name + " is not in " + tried +
                             "; install the scenes' shaders.");
}

const char* fileOf(Draw draw) {
    switch (draw) {
    case Draw::scene:
    case Draw::depth:
        return "scene.hlsl";
    case Draw::shadow:
        return "shadow.hlsl";
    case Draw::sky:
        return "sky.hlsl";
    case Draw::accumulate:
        break;
    }
    return "accumulate.hlsl";
}

std::vector<uint32_t> compileShader(const PipelineKey& key, bool vertex, uint32_t pointLights) {
    const std::filesystem::path file = findShader(fileOf(key.draw));
    std::ifstream stream(file, std::ios::binary);
    reprisec::Source source;
    source.name = file.string();
    source.text.assign(std::istreambuf_iterator<char>(stream), {});
    source.entry = vertex ? "mainVertex" : "mainFragment";
    source.stage = vertex ? reprise::Stage::vertex : reprise::Stage::fragment;
    source.defines = {
        {"SKINNED", key.skinned},      {"TEXTURED", key.textured}, {"DEPTH_ONLY", key.draw == Draw::depth},
        {"ALPHA_TEST", key.alphaTest}, {"GBUFFER", key.gbuffer},   {"POINT_LIGHTS", int(pointLights)}};
    source.includeDirectories = {file.parent_path()};
    auto compiled = reprisec::compileSource(source);
    if (!compiled) throw std::runtime_error(compiled.error().message);
    return compiled->spirv;
}

bool hasFragment(const PipelineKey& key) {
    return key.draw != Draw::shadow || key.alphaTest;
}

struct VertexLayout {
    std::vector<VkVertexInputBindingDescription> bindings;
    std::vector<VkVertexInputAttributeDescription> attributes;
};

VertexLayout vertexLayout(const PipelineKey& key) {
    if (key.draw == Draw::sky || key.draw == Draw::accumulate) return {};
    VertexLayout layout;
    layout.bindings = {{0, 12, VK_VERTEX_INPUT_RATE_VERTEX}, {1, 20, VK_VERTEX_INPUT_RATE_VERTEX}};
    layout.attributes = {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
                         {1, 1, VK_FORMAT_R32G32B32_SFLOAT, 0},
                         {2, 1, VK_FORMAT_R32G32_SFLOAT, 12}};
    if (key.skinned) {
        layout.bindings.push_back({2, 4, VK_VERTEX_INPUT_RATE_VERTEX});
        layout.bindings.push_back({3, 16, VK_VERTEX_INPUT_RATE_VERTEX});
        layout.attributes.push_back({3, 2, VK_FORMAT_R8G8B8A8_UINT, 0});
        layout.attributes.push_back({4, 3, VK_FORMAT_R32G32B32A32_SFLOAT, 0});
    }
    return layout;
}

std::vector<VkFormat> colourFormats(const PipelineKey& key) {
    if (key.draw == Draw::shadow) return {};
    if (key.draw == Draw::accumulate) return {VK_FORMAT_R32G32B32A32_SFLOAT};
    if (!key.gbuffer) return {VK_FORMAT_R16G16B16A16_SFLOAT};
    return {VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R32_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT,
            VK_FORMAT_R16G16_SFLOAT, VK_FORMAT_R32G32_UINT};
}

VkPipelineDepthStencilStateCreateInfo depthState(const PipelineKey& key, DepthKind depth) {
    auto info = structure<VkPipelineDepthStencilStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO);
    const bool standard = depth == DepthKind::standard || key.draw == Draw::shadow;
    const bool afterDepth = key.draw == Draw::scene && key.alphaTest;
    info.depthTestEnable = key.draw != Draw::accumulate;
    info.depthWriteEnable = info.depthTestEnable && key.draw != Draw::sky && !afterDepth;
    info.depthCompareOp = standard ? VK_COMPARE_OP_LESS_OR_EQUAL : VK_COMPARE_OP_GREATER_OR_EQUAL;
    if (afterDepth) info.depthCompareOp = VK_COMPARE_OP_EQUAL;
    return info;
}

VkPipelineRasterizationStateCreateInfo rasterState(const PipelineKey& key) {
    auto info = structure<VkPipelineRasterizationStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
    info.polygonMode = VK_POLYGON_MODE_FILL;
    info.lineWidth = 1.0f;
    if (key.draw != Draw::shadow) return info;
    info.depthBiasEnable = VK_TRUE;
    info.depthBiasSlopeFactor = 1.5f; // the receiver's offset along its normal does the rest
    return info;
}

VkPipelineColorBlendAttachmentState blendState(const PipelineKey& key) {
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask = key.draw == Draw::depth ? 0 : 0xf;
    blend.blendEnable = key.draw == Draw::accumulate;
    blend.srcColorBlendFactor = blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
    blend.srcAlphaBlendFactor = blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    return blend;
}

} // namespace

void setShaderDirectory(std::filesystem::path directory) {
    chosenDirectory() = std::move(directory);
}

Pipelines::Pipelines(VkDevice device, VkPipelineLayout sceneLayout, VkPipelineLayout accumulateLayout,
                     DepthKind depth, uint32_t pointLights)
    : device_(device), sceneLayout_(sceneLayout), accumulateLayout_(accumulateLayout), depth_(depth),
      pointLights_(pointLights) {}

VkPipelineLayout Pipelines::layout(Draw draw) const {
    return draw == Draw::accumulate ? accumulateLayout_ : sceneLayout_;
}

VkPipeline Pipelines::get(const PipelineKey& key) {
    auto found = pipelines_.find(key);
    if (found == pipelines_.end()) found = pipelines_.emplace(key, make(key)).first;
    return found->second;
}

VkShaderModule Pipelines::module(const PipelineKey& key, bool vertex) {
    // Switches that a stage does not test do not make another module of it.
    PipelineKey relevant = key;
    // The depth pass and the one after it share the vertex shader: their depths must be equal.
    if (vertex && key.draw == Draw::depth) relevant.draw = Draw::scene;
    if (vertex && relevant.draw == Draw::scene) relevant.textured = relevant.alphaTest = false;
    if (!vertex) relevant.skinned = false;
    if (!vertex && key.draw == Draw::scene) relevant.alphaTest = false;
    if (!vertex && key.draw == Draw::depth) relevant.gbuffer = false;
    const auto found = modules_.find({relevant, vertex});
    if (found != modules_.end()) return found->second;
    const std::vector<uint32_t> words = compileShader(relevant, vertex, pointLights_);
    auto info = structure<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
    info.codeSize = words.size() * 4;
    info.pCode = words.data();
    VkShaderModule module;
    check(vkCreateShaderModule(device_, &info, nullptr, &module), "create a shader module");
    cleanup_.add([device = device_, module] { vkDestroyShaderModule(device, module, nullptr); });
    modules_.emplace(std::pair(relevant, vertex), module);
    return module;
}

VkPipeline Pipelines::make(const PipelineKey& key) {
    VkPipelineShaderStageCreateInfo stages[2]{};
    for (int i = 0; i < (hasFragment(key) ? 2 : 1); ++i) {
        stages[i].sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stages[i].stage = i == 0 ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
        stages[i].module = module(key, i == 0);
        stages[i].pName = i == 0 ? "mainVertex" : "mainFragment";
    }
    const VertexLayout vertices = vertexLayout(key);
    auto input = structure<VkPipelineVertexInputStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
    input.vertexBindingDescriptionCount = uint32_t(vertices.bindings.size());
    input.pVertexBindingDescriptions = vertices.bindings.data();
    input.vertexAttributeDescriptionCount = uint32_t(vertices.attributes.size());
    input.pVertexAttributeDescriptions = vertices.attributes.data();
    auto assembly = structure<VkPipelineInputAssemblyStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    auto viewport =
        structure<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
    viewport.viewportCount = viewport.scissorCount = 1;
    auto samples = structure<VkPipelineMultisampleStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    const VkPipelineDepthStencilStateCreateInfo depth = depthState(key, depth_);
    const VkPipelineRasterizationStateCreateInfo raster = rasterState(key);
    const std::vector<VkFormat> formats = colourFormats(key);
    const std::vector<VkPipelineColorBlendAttachmentState> blends(formats.size(), blendState(key));
    auto blend = structure<VkPipelineColorBlendStateCreateInfo>(
        VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
    blend.attachmentCount = uint32_t(blends.size());
    blend.pAttachments = blends.data();
    // A transform that mirrors turns the winding, so culling is chosen at each draw.
    const VkDynamicState dynamics[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                       VK_DYNAMIC_STATE_CULL_MODE};
    auto dynamic =
        structure<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
    dynamic.dynamicStateCount = 3;
    dynamic.pDynamicStates = dynamics;
    auto rendering =
        structure<VkPipelineRenderingCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO);
    rendering.colorAttachmentCount = uint32_t(formats.size());
    rendering.pColorAttachmentFormats = formats.data();
    rendering.depthAttachmentFormat =
        key.draw == Draw::accumulate ? VK_FORMAT_UNDEFINED : VK_FORMAT_D32_SFLOAT;
    auto info = structure<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
    info.pNext = &rendering;
    info.stageCount = hasFragment(key) ? 2 : 1;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = layout(key.draw);
    VkPipeline pipeline;
    check(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "create a pipeline");
    cleanup_.add([device = device_, pipeline] { vkDestroyPipeline(device, pipeline, nullptr); });
    return pipeline;
}

} // namespace scenes
