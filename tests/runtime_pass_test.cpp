// SPDX-License-Identifier: Apache-2.0
// One pass at a time: recording, timing and every way in which it can fail.
#include "runtime_support.hpp"

#include <cmath>

namespace {

using namespace reprise;

constexpr const char* scaleText = R"(
[[vk::binding(0)]] cbuffer ScaleParameters { float4 gOutputSize; float4 gScale; };
[[vk::binding(1)]] Texture2D<float4> gInColour;
[[vk::binding(33)]] SamplerState gInColour_sampler;
float4 scaled(float2 uv) { return gInColour.SampleLevel(gInColour_sampler, uv, 0.0) * gScale; }
#if STAGE_COMPUTE
[[vk::binding(16)]] RWTexture2D<float4> gOutColour;
[numthreads(8, 8, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    if (any(thread.xy >= uint2(gOutputSize.xy))) return;
    gOutColour[thread.xy] = scaled((float2(thread.xy) + 0.5) * gOutputSize.zw);
}
#else
float4 mainFragment(float4 positionPx : SV_Position) : SV_Target0 { return scaled(positionPx.xy * gOutputSize.zw); }
#endif
)";

struct ScaleParameters {
    float outputSize[4];
    float scale[4];
};

constexpr Stage stages[] = {Stage::fragment, Stage::compute};
constexpr BindingInfo bindings[] = {
    {"ScaleParameters", 0, BindingKind::uniformBuffer},
    {"gInColour", 1, BindingKind::sampledImage},
    {"gOutColour", 16, BindingKind::storageImage},
    {"gInColour_sampler", 33, BindingKind::pointSampler},
};
constexpr ImageInfo inputs[] = {{"gInColour", "", "rgba16f", 1.0f, "", {}, ""}};
constexpr ImageInfo outputs[] = {{"gOutColour", "", "rgba16f", 1.0f, "", {}, ""}};

const PassInfo scalePass{.name = "scale",
                         .summary = "",
                         .source = "",
                         .stages = stages,
                         .fullscreen = true,
                         .threads = {8, 8, 1},
                         .pixelsPerThread = {1, 1},
                         .parameterBytes = sizeof(ScaleParameters),
                         .switches = {},
                         .bindings = bindings,
                         .inputs = inputs,
                         .outputs = outputs};

const std::vector<uint32_t>& fullscreenSpirv() {
    static const auto spirv = compiled(fullscreenText, "mainVertex", Stage::vertex);
    return spirv;
}

const std::vector<uint32_t>& scaleSpirv(Stage stage) {
    static const auto fragment = compiled(scaleText, "mainFragment", Stage::fragment, {{"STAGE_COMPUTE", 0}});
    static const auto compute = compiled(scaleText, "mainCompute", Stage::compute, {{"STAGE_COMPUTE", 1}});
    return stage == Stage::compute ? compute : fragment;
}

ScaleParameters parametersFor(uint32_t width, uint32_t height, float scale) {
    const auto w = static_cast<float>(width), h = static_cast<float>(height);
    return {{w, h, 1.0f / w, 1.0f / h}, {scale, scale, scale, scale}};
}

std::vector<float> ramp(uint32_t width, uint32_t height) {
    std::vector<float> values(size_t(width) * height * 4);
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(i % 1021); // exact in half
    return values;
}

class PassTest : public RuntimeTest, public testing::WithParamInterface<Stage> {
protected:
    harness::PassRunner runner(VkFormat format = VK_FORMAT_R16G16B16A16_SFLOAT) {
        const VkFormat formats[] = {format};
        return {testGpu(), {&scalePass, {}}, GetParam(), scaleSpirv(GetParam()), fullscreenSpirv(), formats};
    }
};

// Twice the input, texel for texel: powers of two are exact in half. Sizes that fill no group, one and many.
TEST_P(PassTest, everyTexelIsWrittenAtItsOwnPlace) {
    auto pass = runner();
    for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 2u}, {7u, 5u}, {64u, 64u}, {641u, 359u}}) {
        auto in = testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, width, height);
        auto out = testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, width, height);
        auto values = ramp(width, height);
        testGpu().uploadFloats(in, values);
        const auto parameters = parametersFor(width, height, 2.0f);
        testGpu().run([&](VkCommandBuffer commands) {
            const harness::PassRunner::Binding images[] = {{"gInColour", &in}, {"gOutColour", &out}};
            pass.record(commands, images, std::as_bytes(std::span(&parameters, 1)));
        });
        for (float& value : values)
            value *= 2.0f;
        EXPECT_EQ(testGpu().downloadFloats(out), values) << width << "x" << height;
    }
}

// More records than the first arena holds, of two runners that share it; each must see its own parameters.
TEST_P(PassTest, manyRecordsInOneSubmissionKeepTheirParameters) {
    harness::PassRunner runners[] = {runner(), runner()};
    constexpr int records = 200;
    auto in = testGpu().image(VK_FORMAT_R32G32B32A32_SFLOAT, 1, 1);
    testGpu().uploadFloats(in, std::vector{1.0f, 1.0f, 1.0f, 1.0f});
    std::vector<harness::Image> out;
    for (int i = 0; i < records; ++i)
        out.push_back(testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, 1, 1));
    for (int round = 0; round < 2; ++round) {
        testGpu().run([&](VkCommandBuffer commands) {
            for (int i = 0; i < records; ++i) {
                const auto parameters = parametersFor(1, 1, static_cast<float>(i + round));
                const harness::PassRunner::Binding images[] = {{"gInColour", &in},
                                                               {"gOutColour", &out[size_t(i)]}};
                runners[i % 2].record(commands, images, std::as_bytes(std::span(&parameters, 1)));
            }
        });
        for (int i = 0; i < records; ++i)
            ASSERT_EQ(testGpu().downloadFloats(out[size_t(i)])[0], static_cast<float>(i + round));
    }
}

// A pass over 1024x1024 cannot be faster than 1 us, and a section with ten of them takes longer than one with
// one.
TEST_P(PassTest, timestampsCoverTheWork) {
    auto pass = runner();
    auto in = testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, 1024, 1024);
    auto out = testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, 1024, 1024);
    testGpu().uploadFloats(in, ramp(1024, 1024));
    const auto parameters = parametersFor(1024, 1024, 1.0f);
    const auto record = [&](VkCommandBuffer commands) {
        const harness::PassRunner::Binding images[] = {{"gInColour", &in}, {"gOutColour", &out}};
        pass.record(commands, images, std::as_bytes(std::span(&parameters, 1)));
    };
    const std::function<void(VkCommandBuffer)> sections[] = {record, [&](VkCommandBuffer commands) {
                                                                 for (int i = 0; i < 10; ++i)
                                                                     record(commands);
                                                             }};
    testGpu().time(sections); // warms up: drivers compile on first use
    const auto times = testGpu().time(sections);
    ASSERT_EQ(times.size(), 2u);
    EXPECT_GT(times[0], 1e-3);
    EXPECT_GT(times[1], 2.0 * times[0]);
}

TEST_P(PassTest, bindingsAreThoseOfTheModule) {
    const auto pass = runner();
    std::vector<std::string_view> names;
    for (const BindingInfo& binding : pass.pipeline().bindings())
        names.push_back(binding.name);
    std::vector<std::string_view> expected{"ScaleParameters", "gInColour"};
    if (GetParam() == Stage::compute) expected.push_back("gOutColour");
    expected.push_back("gInColour_sampler");
    EXPECT_EQ(names, expected);
}

INSTANTIATE_TEST_SUITE_P(Stages, PassTest, testing::ValuesIn(stages), [](const auto& stage) {
    return stage.param == Stage::compute ? "compute" : "fragment";
});

} // namespace
