// SPDX-License-Identifier: Apache-2.0
// A pack of one pass in a folder of its own, which a test may break.
#pragma once

#include "reprisec.hpp"

#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

namespace fs = std::filesystem;

inline void writeText(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
}

inline std::string readBytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

inline const std::string smallTable = R"([pack]
name = "small"
schema = 1
include = ["."]
platform_switches = ["PLATFORM_GLES"]

[[pass]]
name = "copy"
file = "passes/copy.hlsl"
stages = ["fragment", "compute"]
fullscreen = true
threads = [8, 8, 1]
parameters = "CopyParameters"
  [[pass.switch]]
  name = "TAPS"
  values = ["one", "nine", "gather"]
  default = "one"
  [[pass.switch]]
  name = "FINE"
  values = ["off", "on"]
  default = "off"
  stages = ["fragment"]
  [[pass.input]]
  name = "gInColour"
  binding = 1
  filter = "point"
  [[pass.output]]
  name = "gOutColour"
  binding = 16
  format = "rg16f"

[[preset]]
pass = "copy"
name = "fine"
switches = { TAPS = "nine", FINE = "on" }
)";

inline const std::string smallPass = R"(#include "lib/taps.hlsli"

[[vk::binding(0)]] cbuffer CopyParameters {
    float4 gSize;
    row_major float4x4 gMatrix;
    float2 gOffset;
    uint gCount;
};
[[vk::binding(1)]] Texture2D<float4> gInColour;
[[vk::binding(33)]] SamplerState gInColour_sampler;

float4 copied(float2 uv) {
    float4 sum = 0.0;
#if TAPS_NINE
    [unroll] for (int i = 0; i < 9; ++i)
        sum += tap(gInColour, gInColour_sampler, uv + float2(i, gOffset.y) * gSize.zw);
#elif TAPS_GATHER
    sum = gInColour.GatherRed(gInColour_sampler, uv);
#else
    sum = tap(gInColour, gInColour_sampler, uv + gOffset) * gCount;
#endif
#if FINE
    sum += ddx_fine(uv.x);
#endif
    return mul(sum, gMatrix);
}

#if STAGE_COMPUTE
[[vk::binding(16)]] RWTexture2D<float4> gOutColour;
[numthreads(8, 8, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutColour[thread.xy] = copied((thread.xy + 0.5) * gSize.zw);
}
#else
float4 mainFragment(float4 position : SV_Position) : SV_Target0 {
    return copied(position.xy * gSize.zw);
}
#endif
)";

inline const std::string smallHeader = R"(#ifndef TAPS_HLSLI
#define TAPS_HLSLI
float4 tap(Texture2D<float4> image, SamplerState filter, float2 uv) {
    return image.SampleLevel(filter, uv, 0.0); }
#endif
)";

// The folder is removed at the end of the test.
class SmallPack : public testing::Test {
protected:
    fs::path folder;

    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder =
            fs::temp_directory_path() / ("reprisec_" + std::string(test->name()) + std::to_string(getpid()));
        writeText(folder / "pack.toml", smallTable);
        writeText(folder / "passes/copy.hlsl", smallPass);
        writeText(folder / "lib/taps.hlsli", smallHeader);
        writeText(folder / "lib/unused.hlsli", "#error this header is included by nobody\n");
    }
    void TearDown() override { fs::remove_all(folder); }

    reprisec::Pack load() const {
        auto pack = reprisec::Pack::load(folder / "pack.toml");
        EXPECT_TRUE(pack) << (pack ? "" : pack.error().message);
        return pack ? *pack : reprisec::Pack{};
    }
    reprisec::Result<reprisec::Compiled> compile(const std::string& variant, reprise::Stage stage) const {
        const reprisec::Pack pack = load();
        auto parsed = pack.parseVariant(variant);
        if (!parsed) return parsed.error();
        return reprisec::compile(pack, *parsed, stage);
    }
    static void replace(const fs::path& file, const std::string& from, const std::string& to) {
        std::string text = readBytes(file);
        const size_t at = text.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        writeText(file, text.replace(at, from.size(), to));
    }
};
