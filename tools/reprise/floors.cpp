// SPDX-License-Identifier: Apache-2.0
#include "floors.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace report {
namespace {

using reprise::BindingKind;
using reprise::Stage;
using reprisec::BindingUse;

constexpr uint32_t samplerShift = 32; // a texture's sampler is at its binding + 32

const reprise::ImageInfo* imageNamed(const reprise::PassInfo& pass, std::string_view name) {
    for (const auto& list : {pass.inputs, pass.outputs})
        for (const auto& image : list)
            if (image.name == name) return &image;
    return nullptr;
}

// A pass reads the red of a depth, the red and green of a motion, the colour of the rest: so does its floor.
std::string swizzle(const reprise::PassInfo& pass, const BindingUse& use) {
    const auto* image = imageNamed(pass, use.name);
    const std::string format(image ? image->format : "");
    if (format.starts_with("r32f") || format.starts_with("r16f") || format == "r8")
        return "sum.x += value.r;";
    if (format.starts_with("rg") && !format.starts_with("rgb")) return "sum.xy += value.rg;";
    return "sum.xyz += value.rgb;";
}

struct Tap {
    Offset offset;
    double shift = 0.0; // a further fraction of a texel, once the footprint is full
};

std::vector<Tap> taps(uint32_t count, const uint32_t (&pixelsPerThread)[2], int step) {
    const auto places = readOffsets(count, pixelsPerThread, step);
    std::vector<Tap> result;
    for (size_t i = 0; i < places.size(); ++i) {
        const auto earlier =
            std::count(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(i), places[i]);
        result.push_back({places[i], 0.25 * static_cast<double>(earlier)});
    }
    return result;
}

std::string readLine(const BindingUse& use, std::string_view call, const Tap& tap, std::string_view add) {
    const std::string uv = tap.shift == 0.0 ? "uv" : fmt::format("uv + {:.4f} * gTexel", tap.shift);
    return fmt::format("    value = {0}.{1}({0}_sampler, {2}, {5}int2({3}, {4}));\n    {6}\n", use.name, call,
                       uv, tap.offset.x, tap.offset.y, call == "SampleLevel" ? "0.0, " : "", add);
}

std::string readsOf(const reprise::PassInfo& pass, const BindingUse& use, const uint32_t (&pixels)[2]) {
    std::string text;
    const std::string add = swizzle(pass, use);
    for (const Tap& tap : taps(use.samples, pixels, 1))
        text += readLine(use, "SampleLevel", tap, add);
    // A gather's corner is between texels: half a texel further, so that rounding cannot choose.
    for (Tap tap : taps(use.gathers, pixels, 2)) {
        tap.shift += 0.5;
        text += readLine(use, "GatherRed", tap, "sum += value;");
    }
    for (const Tap& tap : taps(use.fetches, pixels, 1))
        text +=
            fmt::format("    value = {}.Load(int3(max(int2(uv / gTexel) + int2({}, {}), 0), 0));\n    {}\n",
                        use.name, tap.offset.x, tap.offset.y, add);
    return text;
}

// A CPU rasteriser pays for each parameter of each pixel, so the floor reads as many as the pass.
std::string parametersRead(const reprisec::Reflection& reflection) {
    std::string text;
    for (const BindingUse& use : reflection.bindings)
        for (uint32_t i = 0; i < use.scalars; i += 4)
            text += fmt::format("    sum.{1} += gParameters[{0}].{1};\n", i / 4,
                                std::string_view("xyzw").substr(0, use.scalars - i));
    return text;
}

// The sum, in no more components than the widest image that is written has: a driver drops what a component
// that is not stored was computed from, reads of parameters among them.
std::string foldedSum(const reprise::Variant& variant) {
    size_t components = 1;
    for (const auto& image : variant.pass->outputs) {
        const std::string_view format = reprise::formatOf(variant, image);
        if (reprise::exists(variant, image))
            components = std::max(components, format.starts_with("rgb")  ? size_t{4}
                                              : format.starts_with("rg") ? size_t{2}
                                                                         : size_t{1});
    }
    if (components == 4) return "sum";
    return components == 2 ? "float4(sum.xy + sum.zw, 0.0, 0.0)" : "float4(dot(sum, 1.0), 0.0, 0.0, 0.0)";
}

std::string declarations(const reprisec::Reflection& reflection) {
    std::string text;
    if (reflection.parameterBytes > 0)
        text += fmt::format("[[vk::binding(0)]] cbuffer Parameters {{ float4 gParameters[{}]; }};\n",
                            (reflection.parameterBytes + 15) / 16);
    for (const BindingUse& use : reflection.bindings) {
        if (use.kind == BindingKind::sampledImage)
            text += fmt::format("[[vk::binding({})]] Texture2D<float4> {};\n"
                                "[[vk::binding({})]] SamplerState {}_sampler;\n",
                                use.binding, use.name, use.binding + samplerShift, use.name);
        if (use.kind == BindingKind::storageImage)
            text += fmt::format("[[vk::binding({})]] RWTexture2D<float4> {};\n", use.binding, use.name);
    }
    return text;
}

std::string constants(uint32_t width, uint32_t height) {
    return fmt::format("static const float2 gTexel = float2(1.0 / {}.0, 1.0 / {}.0);\n", width, height);
}

std::string fragmentEntry(uint32_t outputs) {
    std::string text = "struct Outputs {\n";
    for (uint32_t i = 0; i < outputs; ++i)
        text += fmt::format("    float4 c{0} : SV_Target{0};\n", i);
    text += "};\nOutputs mainFragment(float4 positionPx : SV_Position) {\n"
            "    float4 sum = readAll(positionPx.xy * gTexel);\n    Outputs outputs;\n";
    for (uint32_t i = 0; i < outputs; ++i)
        text += fmt::format("    outputs.c{} = sum;\n", i);
    return text + "    return outputs;\n}\n";
}

// As in the passes, what lies beyond the image is dropped by it.
std::string computeEntry(const reprise::Variant& variant, const reprisec::Reflection& reflection) {
    const reprise::PassInfo& pass = *variant.pass;
    const auto threads = reprise::threadsOf(variant);
    const uint32_t px = pass.pixelsPerThread[0], py = pass.pixelsPerThread[1];
    std::string text =
        fmt::format("[numthreads({}, {}, 1)]\nvoid mainCompute(uint3 thread : SV_DispatchThreadID) {{\n"
                    "    uint2 first = thread.xy * uint2({}, {});\n"
                    "    float4 sum = readAll((float2(first) + 0.5) * gTexel);\n",
                    threads[0], threads[1], px, py);
    for (uint32_t y = 0; y < py; ++y)
        for (uint32_t x = 0; x < px; ++x)
            for (const BindingUse& use : reflection.bindings)
                if (use.kind == BindingKind::storageImage)
                    text += fmt::format("    {}[first + uint2({}, {})] = sum;\n", use.name, x, y);
    return text + "}\n";
}

std::string entry(const reprise::Variant& variant, Stage stage, const reprisec::Reflection& reflection) {
    return stage == Stage::compute ? computeEntry(variant, reflection)
                                   : fragmentEntry(std::max(1u, reflection.colourOutputs));
}

// The simple floors' interface, as a reflection would give it.
reprisec::Reflection simpleReflection(Stage stage) {
    reprisec::Reflection reflection;
    reflection.bindings.push_back({.name = "gIn", .binding = 1, .kind = BindingKind::sampledImage});
    if (stage == Stage::compute)
        reflection.bindings.push_back({.name = "gOut", .binding = 16, .kind = BindingKind::storageImage});
    reflection.colourOutputs = 1;
    return reflection;
}

std::string simpleSource(Stage stage, uint32_t width, uint32_t height, std::string_view body) {
    const auto reflection = simpleReflection(stage);
    return declarations(reflection) + constants(width, height) + std::string(body) +
           entry({&simpleFloorPass(), {}}, stage, reflection);
}

} // namespace

std::vector<Offset> readOffsets(uint32_t count, const uint32_t (&pixelsPerThread)[2], int step) {
    const int width = static_cast<int>(pixelsPerThread[0]), height = static_cast<int>(pixelsPerThread[1]);
    std::vector<Offset> places;
    for (int y = -1; y <= height; y += step)
        for (int x = -1; x <= width; x += step)
            places.push_back({x, y});
    const auto distance =
        [&](const Offset& o) { // to the middle of the covered pixels, in half texels, squared
            const int dx = 2 * o.x - (width - 1) + (step - 1), dy = 2 * o.y - (height - 1) + (step - 1);
            return dx * dx + dy * dy;
        };
    std::stable_sort(places.begin(), places.end(),
                     [&](const Offset& a, const Offset& b) { return distance(a) < distance(b); });
    std::vector<Offset> result;
    for (uint32_t i = 0; i < count; ++i)
        result.push_back(places[i % places.size()]);
    return result;
}

double readsPerPixel(const reprise::Variant& variant, Stage stage, const reprisec::Reflection& reflection) {
    uint32_t reads = 0;
    for (const BindingUse& use : reflection.bindings)
        if (use.kind == BindingKind::sampledImage) reads += use.samples + use.gathers + use.fetches;
    const auto& pixels = variant.pass->pixelsPerThread;
    return static_cast<double>(reads) / (stage == Stage::compute ? pixels[0] * pixels[1] : 1u);
}

std::string floorSource(const reprise::Variant& variant, Stage stage, const reprisec::Reflection& reflection,
                        uint32_t width, uint32_t height) {
    const reprise::PassInfo& pass = *variant.pass;
    const uint32_t one[2] = {1, 1};
    std::string text = declarations(reflection) + constants(width, height);
    text += "float4 readAll(float2 uv) {\n    float4 value, sum = 0.0;\n";
    text += parametersRead(reflection);
    for (const BindingUse& use : reflection.bindings)
        if (use.kind == BindingKind::sampledImage)
            text += readsOf(pass, use, stage == Stage::compute ? pass.pixelsPerThread : one);
    return text + fmt::format("    return {};\n}}\n", foldedSum(variant)) + entry(variant, stage, reflection);
}

std::string copySource(Stage stage, uint32_t width, uint32_t height) {
    return simpleSource(stage, width, height,
                        "float4 readAll(float2 uv) { return gIn.SampleLevel(gIn_sampler, uv, 0.0); }\n");
}

std::string nineTapsSource(Stage stage, uint32_t width, uint32_t height) {
    std::string body = "float4 readAll(float2 uv) {\n"
                       "    float4 value, low = gIn.SampleLevel(gIn_sampler, uv, 0.0), high = low;\n";
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (x != 0 || y != 0)
                body += fmt::format("    value = gIn.SampleLevel(gIn_sampler, uv, 0.0, int2({}, {}));\n"
                                    "    low = min(low, value);\n    high = max(high, value);\n",
                                    x, y);
    return simpleSource(stage, width, height, body + "    return 0.5 * (low + high);\n}\n");
}

const reprise::PassInfo& simpleFloorPass() {
    static constexpr Stage stages[] = {Stage::fragment, Stage::compute};
    static constexpr reprise::BindingInfo bindings[] = {{"gIn", 1, BindingKind::sampledImage},
                                                        {"gIn_sampler", 33, BindingKind::pointSampler},
                                                        {"gOut", 16, BindingKind::storageImage}};
    static const auto image = [](std::string_view name) {
        reprise::ImageInfo info{};
        info.name = name;
        info.format = "rgba16f";
        info.scale = 1.0f;
        return info;
    };
    static const reprise::ImageInfo input = image("gIn"), output = image("gOut");
    static const reprise::PassInfo pass = [] {
        reprise::PassInfo info{};
        info.name = "floor";
        info.stages = stages;
        info.fullscreen = true;
        info.threads[0] = info.threads[1] = 16; // 8x8 takes a GPU almost twice as long
        info.threads[2] = 1;
        info.pixelsPerThread[0] = info.pixelsPerThread[1] = 1;
        info.bindings = bindings;
        info.inputs = {&input, 1};
        info.outputs = {&output, 1};
        return info;
    }();
    return pass;
}

} // namespace report
