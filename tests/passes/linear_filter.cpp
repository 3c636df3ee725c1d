// SPDX-License-Identifier: Apache-2.0
// Measures the weights of the device's linear filter: Vulkan asks for no more than a few bits of fraction.
#include "bench.hpp"

#include <cmath>

namespace passes {

namespace {

// Between texels x and x + 1 of a ramp whose texel x is x, the weight is the fraction of what comes back.
constexpr const char* rampText = R"(
[[vk::binding(0)]] cbuffer Parameters { float4 gOutputSize; };
[[vk::binding(1)]] Texture2D<float4> gInRamp;
[[vk::binding(33)]] SamplerState gInRamp_sampler;
[[vk::binding(16)]] RWTexture2D<float4> gOutValue;
[numthreads(8, 8, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    float u = (float(thread.y * 64 + thread.x) + 0.5) / 4096.0;
    gOutValue[thread.xy] = gInRamp.SampleLevel(gInRamp_sampler, float2(u, 0.5), 0.0);
}
)";

constexpr Stage stages[] = {Stage::compute};
constexpr reprise::BindingInfo bindings[] = {
    {"Parameters", 0, reprise::BindingKind::uniformBuffer},
    {"gInRamp", 1, reprise::BindingKind::sampledImage},
    {"gOutValue", 16, reprise::BindingKind::storageImage},
    {"gInRamp_sampler", 33, reprise::BindingKind::linearSampler},
};
constexpr reprise::ImageInfo inputs[] = {{"gInRamp", "", "r32f", 1.0f, "", {}, ""}};
constexpr reprise::ImageInfo outputs[] = {{"gOutValue", "", "r32f", 1.0f, "", {}, ""}};

reprise::PassInfo rampPass() {
    reprise::PassInfo info{};
    info.name = "ramp";
    info.stages = stages;
    info.fullscreen = true;
    info.threads[0] = info.threads[1] = 8;
    info.threads[2] = 1;
    info.pixelsPerThread[0] = info.pixelsPerThread[1] = 1;
    info.parameterBytes = 16;
    info.bindings = bindings;
    info.inputs = inputs;
    info.outputs = outputs;
    return info;
}

double measuredError() {
    constexpr int size = 64;
    auto compiled = reprisec::compileSource({.name = "ramp",
                                             .text = rampText,
                                             .entry = "mainCompute",
                                             .stage = Stage::compute,
                                             .defines = {},
                                             .includeDirectories = {}});
    if (!compiled) throw std::runtime_error(compiled.error().message);
    const reprise::PassInfo info = rampPass();
    Pass pass({&info, {}}, Stage::compute, {r32f}, compiled->spirv);
    const Pixels ramp = makePixels(r32f, size, size, [](int x, int) { return Texel{static_cast<float>(x)}; });
    const NamedPixels named[] = {{"gInRamp", &ramp}};
    const Pixels values = pass(named, glm::vec4(size, size, 0.0f, 0.0f), size, size)[0];
    double error = 0.0;
    for (int i = 0; i < size * size; ++i) {
        const double position = std::clamp((i + 0.5) / size - 0.5, 0.0, size - 1.0);
        error = std::max(error, std::abs(values.at(i % size, i / size, 0) - position));
    }
    return error;
}

} // namespace

double linearFilterError() {
    static const double error = measuredError();
    return error;
}

} // namespace passes
