// SPDX-License-Identifier: Apache-2.0
// combine_lighting executed and held to the oracle.
//
// Bound: four roundings of float32 and that of the output's format (combine_lighting_case.cpp).
#include "combine_lighting_case.hpp"

#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}, {641, 359}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -3.0f, 3e38f};

class CombineLighting : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, CombineLighting, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    for (const std::string_view lighting : {"occlusion", "shadow", "both"})
        for (const std::string_view other : {"off", "on"})
            variants.push_back(
                variantOf(pack(), "combine_lighting", {{"LIGHTING", lighting}, {"OTHER_LIGHT", other}}));
    return variants;
}

TEST_P(CombineLighting, everyVariantEqualsTheOracleAtEverySize) {
    for (const Variant& variant : allVariants())
        for (const VkFormat format : {rgba32f, rgba16f}) {
            Pass pass(variant, GetParam(), {format});
            for (const auto& [width, height] : sizes) {
                const auto frame = combineLightingCase(variant, width, height, 121);
                const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), width, height) << ": " << text(result);
            }
        }
}

// Each input broken in one texel, in every channel: the oracle says what that pixel shows, and that no other
// changes.
TEST_P(CombineLighting, brokenTexelsAreBoundedAndStayAlone) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), {rgba32f});
        for (const float value : poisons)
            for (Pixels CombineLightingCase::*input :
                 {&CombineLightingCase::lighting, &CombineLightingCase::ambient, &CombineLightingCase::sun,
                  &CombineLightingCase::other}) {
                auto frame = combineLightingCase(variant, 23, 13, 122);
                Pixels& broken = frame.*input;
                for (int c = 0; c < broken.channels; ++c)
                    broken.at(9, 7, c) = value;
                const Pixels lit = run(pass, frame)[0];
                const Comparison result = compareWithOracle(frame, lit);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), 23, 13) << ", " << value << ": " << text(result);
                for (const float each : lit.values)
                    ASSERT_TRUE(each >= 0.0f && each <= 65504.0f) << value;
            }
    }
}

// Lights at the limit of binary16 all over: their sum is at that limit, and not infinite.
TEST_P(CombineLighting, theSumStaysAColour) {
    const Variant variant = variantOf(pack(), "combine_lighting", {{"OTHER_LIGHT", "on"}});
    for (const VkFormat format : {rgba32f, rgba16f}) {
        Pass pass(variant, GetParam(), {format});
        auto frame = combineLightingCase(variant, 16, 16, 123);
        for (Pixels* light : {&frame.ambient, &frame.sun, &frame.other})
            std::fill(light->values.begin(), light->values.end(), 65504.0f);
        const Pixels lit = run(pass, frame)[0];
        for (int i = 0; i < 16 * 16; ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(lit.at(i % 16, i / 16, c), 65504.0f);
    }
}

// Where everything is seen, the lights alone are what is shown; where nothing is, the other light.
TEST_P(CombineLighting, visibilityOfOneLeavesTheLightsAndOfNoneTheOther) {
    const Variant variant = variantOf(pack(), "combine_lighting", {{"OTHER_LIGHT", "on"}});
    Pass pass(variant, GetParam(), {rgba32f});
    auto frame = combineLightingCase(variant, 16, 16, 124);
    for (const float visibility : {0.0f, 1.0f}) {
        std::fill(frame.lighting.values.begin(), frame.lighting.values.end(), visibility);
        const Pixels lit = run(pass, frame)[0];
        for (int i = 0; i < 16 * 16; ++i)
            for (int c = 0; c < 3; ++c) {
                const int x = i % 16, y = i / 16;
                const float lights = frame.ambient.at(x, y, c) + frame.sun.at(x, y, c);
                ASSERT_FLOAT_EQ(lit.at(x, y, c), visibility * lights + frame.other.at(x, y, c));
            }
    }
}

} // namespace
} // namespace passes
