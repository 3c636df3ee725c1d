// SPDX-License-Identifier: Apache-2.0
// What the runtime's tests share: a device with validation, and shaders compiled from text.
#pragma once

#include "harness.hpp"
#include "reprisec.hpp"

#include <gtest/gtest.h>

// One device for all tests of a program; validation messages are what each test must end without.
inline harness::Gpu& testGpu() {
    static harness::Gpu gpu({.device = "", .validation = true});
    return gpu;
}

inline std::string joined(const std::vector<std::string>& messages) {
    std::string text;
    for (const std::string& message : messages)
        text += message + "\n";
    return text;
}

class RuntimeTest : public testing::Test {
protected:
    void SetUp() override { testGpu().takeValidationMessages(); }
    void TearDown() override { EXPECT_EQ(joined(testGpu().takeValidationMessages()), ""); }
};

inline std::vector<uint32_t> compiled(const std::string& text, const std::string& entry, reprise::Stage stage,
                                      const std::map<std::string, int>& defines = {}) {
    auto result = reprisec::compileSource({.name = "test",
                                           .text = text,
                                           .entry = entry,
                                           .stage = stage,
                                           .defines = defines,
                                           .includeDirectories = {}});
    EXPECT_TRUE(result) << result.error().message;
    return result ? result->spirv : std::vector<uint32_t>{};
}

inline constexpr const char* fullscreenText = R"(
float4 mainVertex(uint vertex : SV_VertexID) : SV_Position {
    return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);
})";
