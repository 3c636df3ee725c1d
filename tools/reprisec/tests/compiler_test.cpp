// SPDX-License-Identifier: Apache-2.0
// compile() and compileSource(): messages, reflection, targets and their reasons.
#include "small_pack.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

using reprise::Stage;
using reprisec::BindingUse;
using reprisec::Compiled;
using testing::AssertionResult;

namespace {

AssertionResult says(const std::string& message, const std::string& part) {
    if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << '"' << message << "\" does not say \"" << part << '"';
}

template <class T> std::string messageOf(const reprisec::Result<T>& result) {
    return result ? std::string("it succeeded") : result.error().message;
}

BindingUse use(const Compiled& compiled, const std::string& name) {
    const auto found = std::ranges::find(compiled.reflection.bindings, name, &BindingUse::name);
    return found == compiled.reflection.bindings.end() ? BindingUse{} : *found;
}

reprisec::Source source(std::string text, Stage stage, std::string entry) {
    return {"given.hlsl", std::move(text), std::move(entry), stage, {}, {}};
}

} // namespace

TEST_F(SmallPack, errorCarriesFileLineVariantAndStage) {
    replace(folder / "lib/taps.hlsli", "image.SampleLevel", "imagine.SampleLevel");
    const std::string message = messageOf(compile("copy--taps-nine", Stage::fragment));
    EXPECT_TRUE(says(message, (folder / "lib/taps.hlsli").string() + ":4: "));
    EXPECT_TRUE(says(message, "imagine"));
    EXPECT_TRUE(says(message, "[copy--taps-nine, fragment]"));
}

TEST_F(SmallPack, misspelledSwitchInIfIsAnErrorWithItsLine) {
    replace(folder / "passes/copy.hlsl", "#elif TAPS_GATHER", "#elif TAPS_GATHERS");
    const std::string message = messageOf(compile("copy", Stage::fragment));
    EXPECT_TRUE(says(message, (folder / "passes/copy.hlsl").string() + ":17: "));
    EXPECT_TRUE(says(message, "TAPS_GATHERS"));
}

TEST_F(SmallPack, undefinedMacroInAHeaderIsAnErrorThere) {
    replace(folder / "lib/taps.hlsli", "float4 tap",
            "// a comment\n#if 1 && \\\n    SOMETHING\n#endif\nfloat4 tap");
    EXPECT_TRUE(
        says(messageOf(compile("copy", Stage::compute)), (folder / "lib/taps.hlsli").string() + ":4: "));
}

TEST_F(SmallPack, macrosThatFilesDefineAndDefinedAskAreNoErrors) {
    replace(folder / "lib/taps.hlsli", "float4 tap",
            "#define OWN 1\n#if OWN && 0x1F // NOT_THIS\n#endif\n#if defined(ANY) || defined OTHER /* "
            "NOR_THIS */\n"
            "#endif\nfloat4 tap");
    EXPECT_EQ(messageOf(compile("copy", Stage::compute)), "it succeeded");
}

TEST_F(SmallPack, missingHeaderIsNamed) {
    replace(folder / "passes/copy.hlsl", "lib/taps.hlsli", "lib/none.hlsli");
    const std::string message = messageOf(compile("copy", Stage::fragment));
    EXPECT_TRUE(says(message, "copy.hlsl:1: "));
    EXPECT_TRUE(says(message, "lib/none.hlsli"));
}

TEST_F(SmallPack, unknownSwitchesAndValuesAreErrorsThatListTheKnownOnes) {
    EXPECT_TRUE(says(messageOf(compile("copy--tops-nine", Stage::fragment)), "it has: TAPS, FINE"));
    EXPECT_TRUE(says(messageOf(compile("copy--taps-ten", Stage::fragment)), "it has: one, nine, gather"));
    EXPECT_TRUE(says(messageOf(compile("copies", Stage::fragment)), "there are: copy"));
    EXPECT_TRUE(says(messageOf(compile("copy", Stage::vertex)), "no such stage"));
}

TEST_F(SmallPack, readsAndWritesAreCountedPerBinding) {
    const auto one = compile("copy", Stage::compute);
    const auto nine = compile("copy--taps-nine", Stage::fragment);
    const auto gather = compile("copy--taps-gather", Stage::fragment);
    ASSERT_TRUE(one && nine && gather) << messageOf(one) << messageOf(nine) << messageOf(gather);
    EXPECT_EQ(use(*one, "gInColour").samples, 1u);
    EXPECT_EQ(use(*one, "gOutColour").stores, 1u);
    EXPECT_EQ(use(*one, "gOutColour").binding, 16u);
    EXPECT_EQ(use(*nine, "gInColour").samples, 9u) << "nine calls of an unrolled loop, through a function";
    EXPECT_EQ(use(*nine, "gInColour_sampler").samples, 9u);
    EXPECT_EQ(use(*gather, "gInColour").samples, 0u);
    EXPECT_EQ(use(*gather, "gInColour").gathers, 1u);
    EXPECT_EQ(nine->reflection.colourOutputs, 1u);
}

TEST_F(SmallPack, parametersAreReflectedWithOffsets) {
    const auto compiled = compile("copy", Stage::fragment);
    ASSERT_TRUE(compiled) << messageOf(compiled);
    const auto& parameters = compiled->reflection.parameters;
    ASSERT_EQ(parameters.size(), 4u);
    EXPECT_EQ(parameters[1].name, "gMatrix");
    EXPECT_EQ(parameters[1].type, "float4x4");
    EXPECT_EQ(parameters[1].offset, 16u);
    EXPECT_EQ(parameters[1].bytes, 64u);
    EXPECT_EQ(parameters[2].type, "float2");
    EXPECT_EQ(parameters[2].offset, 80u);
    EXPECT_EQ(parameters[3].type, "uint");
    EXPECT_EQ(parameters[3].offset, 88u);
    EXPECT_EQ(compiled->reflection.parameterBytes, 96u) << "92 bytes, rounded up to 16";
    EXPECT_EQ(load().passes()[0].parameterBytes, 96u);
}

TEST_F(SmallPack, bindingThatTheTableDoesNotListIsRefused) {
    replace(folder / "passes/copy.hlsl", "[[vk::binding(1)]]", "[[vk::binding(2)]]");
    const std::string message = messageOf(compile("copy", Stage::fragment));
    EXPECT_TRUE(says(message, "gInColour has binding 2"));
    EXPECT_TRUE(says(message, "pack.toml"));
}

TEST_F(SmallPack, threadsThatDifferFromTheTableAreRefused) {
    replace(folder / "passes/copy.hlsl", "numthreads(8, 8, 1)", "numthreads(8, 4, 1)");
    EXPECT_TRUE(says(messageOf(compile("copy", Stage::compute)), "numthreads"));
}

TEST_F(SmallPack, glslHasTheNamesOfTheTable) {
    const auto compiled = compile("copy--taps-nine", Stage::fragment);
    ASSERT_TRUE(compiled && compiled->glsl450 && compiled->glslEs) << messageOf(compiled);
    EXPECT_TRUE(says(*compiled->glsl450, "#version 450"));
    EXPECT_TRUE(says(*compiled->glsl450, "layout(binding = 1) uniform sampler2D gInColour;"));
    EXPECT_TRUE(says(*compiled->glsl450, "uniform CopyParameters"));
    EXPECT_TRUE(says(*compiled->glslEs, "#version 300 es"));
    EXPECT_TRUE(says(*compiled->glslEs, "out vec4 gOutColour;"));
}

TEST_F(SmallPack, whatEsCannotExpressIsRecordedWithTheReason) {
    const auto gather = compile("copy--taps-gather", Stage::fragment);
    ASSERT_TRUE(gather) << messageOf(gather);
    EXPECT_TRUE(gather->glsl450) << gather->glsl450Reason;
    EXPECT_FALSE(gather->glslEs);
    EXPECT_TRUE(says(gather->glslEsReason, "textureGather"));
    const auto compute = compile("copy", Stage::compute);
    ASSERT_TRUE(compute) << messageOf(compute);
    EXPECT_TRUE(says(compute->glslEsReason, "rg16f"));
    const auto fine = compile("copy--fine-on", Stage::fragment);
    ASSERT_TRUE(fine) << messageOf(fine);
    EXPECT_FALSE(fine->glslEs);
    EXPECT_FALSE(fine->glslEsReason.empty());
}

TEST_F(SmallPack, platformSwitchForEsReachesOnlyTheEsText) {
    replace(folder / "passes/copy.hlsl", "#elif TAPS_GATHER", "#elif TAPS_GATHER && !PLATFORM_GLES");
    const auto compiled = compile("copy--taps-gather", Stage::fragment);
    ASSERT_TRUE(compiled && compiled->glsl450 && compiled->glslEs) << messageOf(compiled);
    EXPECT_TRUE(says(*compiled->glsl450, "textureGather"));
    EXPECT_EQ(use(*compiled, "gInColour").gathers, 1u);
    EXPECT_EQ(compiled->glslEs->find("textureGather"), std::string::npos);
}

TEST_F(SmallPack, dependenciesAreThePassAndTheHeadersItIncludes) {
    const auto compiled = compile("copy", Stage::fragment);
    ASSERT_TRUE(compiled) << messageOf(compiled);
    const std::vector<fs::path> expected{folder / "passes/copy.hlsl", folder / "lib/taps.hlsli"};
    EXPECT_EQ(compiled->dependencies, expected);
}

TEST_F(SmallPack, switchOfOneStageIsAtItsDefaultInTheOther) {
    const auto on = compile("copy--fine-on", Stage::compute), off = compile("copy", Stage::compute);
    ASSERT_TRUE(on && off) << messageOf(on);
    EXPECT_EQ(on->spirv, off->spirv);
}

TEST(CompileSource, givesSpirvOfAnyText) {
    const auto compiled = reprisec::compileSource(source(
        "[[vk::binding(3)]] RWStructuredBuffer<float> gData; [numthreads(64, 1, 1)] void run(uint3 id : "
        "SV_DispatchThreadID) { gData[id.x] = gData[id.x] * 2.0 + gData[id.y]; }",
        Stage::compute, "run"));
    ASSERT_TRUE(compiled) << messageOf(compiled);
    EXPECT_EQ(compiled->spirv[0], 0x07230203u);
    EXPECT_EQ(compiled->reflection.threads[0], 64u);
    EXPECT_EQ(use(*compiled, "gData").fetches, 2u);
    EXPECT_EQ(use(*compiled, "gData").stores, 1u);
}

// A vector that is read whole and by its components is four values, and a product reads the rows it needs.
TEST(CompileSource, parametersCountOnceHoweverTheyAreRead) {
    const auto compiled =
        reprisec::compileSource(source("[[vk::binding(0)]] cbuffer Parameters { row_major float4x4 gMatrix; "
                                       "float4 gWhole; float4 gPart; };\n"
                                       "float4 mainFragment(float4 p : SV_Position) : SV_Target0 {\n"
                                       "    float4 a = mul(gMatrix, p), b = sin(gWhole);\n"
                                       "    return float4(a.xy, b.x * gWhole.y, b.y + gWhole.x + gPart.z); }",
                                       Stage::fragment, "mainFragment"));
    ASSERT_TRUE(compiled) << messageOf(compiled);
    EXPECT_EQ(use(*compiled, "Parameters").scalars, 8u + 4u + 1u);
}

TEST(CompileSource, fetchAndSampleOfOneTextureShareOneUniform) {
    const auto compiled = reprisec::compileSource(
        source("[[vk::binding(1)]] Texture2D<float4> gIn; [[vk::binding(33)]] SamplerState gIn_sampler;\n"
               "float4 mainFragment(float4 p : SV_Position) : SV_Target0 {\n"
               "    return gIn.Load(int3(p.xy, 0)) + gIn.SampleLevel(gIn_sampler, p.xy, 0.0); }",
               Stage::fragment, "mainFragment"),
        {.glsl = true, .platformSwitches = {}});
    ASSERT_TRUE(compiled && compiled->glsl450 && compiled->glslEs) << messageOf(compiled);
    EXPECT_EQ(use(*compiled, "gIn").fetches, 1u);
    EXPECT_EQ(use(*compiled, "gIn").samples, 1u);
    for (const std::string& text : {*compiled->glsl450, *compiled->glslEs}) {
        EXPECT_EQ(text.find("uniform", text.find("uniform") + 1), std::string::npos) << text;
        EXPECT_TRUE(says(text, "texelFetch(gIn,"));
    }
}

// glslang reports success and hands over a module that no driver need take.
// Clamps to [0, 1] are what saturate became; other clamps stay.
TEST(CompileSource, saturateSaysWhatBecomesOfNaN) {
    constexpr uint32_t extInst = 12, fClamp = 43, nClamp = 81;
    const auto count = [](const std::string& expression, uint32_t which) {
        const auto compiled = reprisec::compileSource(
            source("float4 mainFragment(float4 c : TEXCOORD0) : SV_Target0 { return " + expression + "; }",
                   Stage::fragment, "mainFragment"));
        EXPECT_TRUE(compiled) << messageOf(compiled);
        size_t found = 0;
        for (size_t at = 5; at < compiled->spirv.size(); at += compiled->spirv[at] >> 16)
            found += (compiled->spirv[at] & 0xffffu) == extInst && compiled->spirv[at + 4] == which;
        return found;
    };
    EXPECT_EQ(count("saturate(c)", nClamp), 1u);
    EXPECT_EQ(count("saturate(c.x) * c", nClamp), 1u);
    EXPECT_EQ(count("clamp(c, 0.0, 2.0)", nClamp), 0u);
    EXPECT_EQ(count("clamp(c, 0.0, 2.0)", fClamp), 1u);
}

TEST(CompileSource, invalidSpirvIsRefusedWithASentence) {
    const auto compiled = reprisec::compileSource(source(
        "[[vk::binding(1)]] Texture2D<float> gIn; [[vk::binding(33)]] SamplerComparisonState gIn_sampler;\n"
        "float4 mainFragment(float4 p : SV_Position) : SV_Target0 {\n"
        "    return gIn.GatherCmp(gIn_sampler, p.xy, 0.5); }",
        Stage::fragment, "mainFragment"));
    ASSERT_FALSE(compiled);
    EXPECT_EQ(compiled.error().code, reprise::ErrorCode::badShader);
    EXPECT_TRUE(says(messageOf(compiled), "not valid"));
    EXPECT_TRUE(says(messageOf(compiled), "[given.hlsl, fragment]"));
}

TEST(CompileSource, twoResourcesAtOneBindingAreRefused) {
    const auto compiled = reprisec::compileSource(
        source("[[vk::binding(1)]] Texture2D<float4> gA; [[vk::binding(1)]] Texture2D<float4> gB;\n"
               "float4 mainFragment(float4 p : SV_Position) : SV_Target0 {\n"
               "    return gA.Load(int3(p.xy, 0)) + gB.Load(int3(p.xy, 0)); }",
               Stage::fragment, "mainFragment"));
    EXPECT_TRUE(says(messageOf(compiled), "both have binding 1"));
}

TEST_F(SmallPack, macrosOfThePackBesideTheHeadersAreZero) {
    writeText(folder / "lib/asks.hlsli", "#if TAPS_NINE || PLATFORM_GLES\n#error set\n#endif\n");
    auto text = source("#include \"lib/asks.hlsli\"\nfloat4 mainFragment() : SV_Target0 { return 1.0; }",
                       Stage::fragment, "mainFragment");
    EXPECT_FALSE(reprisec::compileSource(text)) << "nobody says where the headers are";
    text.includeDirectories = {folder};
    EXPECT_EQ(messageOf(reprisec::compileSource(text)), "it succeeded");
    text.defines = {{"TAPS_NINE", 1}};
    EXPECT_FALSE(reprisec::compileSource(text)) << "#error is reached";
}

// What a consumer of GLSL has none of: what GLSL lacks, and not what a layout of parameters keeps from it.
TEST(Generated, lacksGlslForNothingButWhatTheLanguageHasNot) {
    size_t modules = 0;
    for (const auto& file : std::filesystem::recursive_directory_iterator("generated")) {
        if (file.path().extension() != ".json") continue;
        ++modules;
        std::ifstream stream(file.path());
        const auto json = nlohmann::json::parse(stream);
        const auto& switches = json.at("switches");
        const auto& targets = json.at("targets");
        const bool rowsShare = json.at("stage") == "compute" && switches.contains("QUAD_SHARING") &&
                               switches.at("QUAD_SHARING") == "on";
        EXPECT_EQ(targets.at("glsl450").at("reason").is_null(), !rowsShare) << file.path();
        const auto& reason = targets.at("glslEs").at("reason");
        if (!reason.is_null()) {
            EXPECT_FALSE(says(reason.get<std::string>(), "std140")) << file.path();
        }
    }
    EXPECT_GT(modules, 200u);
}
