// SPDX-License-Identifier: Apache-2.0
// temporal_aa executed and held to the oracle, pixel by pixel.
//
// Bounds: the store to the output's format (storeError) and, where that does not suffice, what the pixel's
// own conditioning makes of float32 roundings and of the filter's weights (oracle::Disturbance). A float32
// output has next to no error of its own, so that a constant wrong in its sixth digit is seen.
#include "temporal_aa_case.hpp"

namespace passes {
namespace {

struct Size {
    int width, height;
};
constexpr Size smallSizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr Size largeSize{641, 359};

void expectOracle(Pass& pass, Stage stage, const TemporalAaFrame& frame) {
    const Comparison result = compareWithOracle(pass.variant(), frame, run(pass, frame));
    EXPECT_TRUE(result.holds()) << describe(pass.variant(), stage, frame.width(), frame.height()) << ": "
                                << text(result);
}

std::vector<VkFormat> float32Outputs(const Variant& variant) {
    std::vector<VkFormat> formats;
    for (const auto& output : variant.pass->outputs)
        if (reprise::exists(variant, output)) formats.push_back(rgba32f);
    return formats;
}

class LinearFilter : public PassTest {};
class TemporalAa : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, TemporalAa, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

TEST_P(TemporalAa, committedVariantsEqualTheOracleAtSmallSizes) {
    for (const Variant& variant : committedVariants("temporal_aa")) {
        if (reprise::forStage(variant, GetParam()).values != variant.values)
            continue; // the same as another one
        Pass pass(variant, GetParam(), float32Outputs(variant));
        for (const Size size : smallSizes)
            expectOracle(pass, GetParam(), randomFrame(size.width, size.height, 1));
    }
}

TEST_P(TemporalAa, randomCombinationsOfSwitchesEqualTheOracle) {
    for (const Variant& variant : randomVariants("temporal_aa", 20, 20160314)) {
        Pass pass(variant, GetParam(), float32Outputs(variant));
        expectOracle(pass, GetParam(), randomFrame(64, 64, 2));
        expectOracle(pass, GetParam(), randomFrame(7, 5, 3, Contrast::extreme));
    }
}

TEST_P(TemporalAa, presetsEqualTheOracleInHalfFloat) {
    for (const auto& preset : pack().presets("temporal_aa")) {
        Pass pass(*pack().preset("temporal_aa", preset.name), GetParam());
        expectOracle(pass, GetParam(), randomFrame(64, 64, 4, Contrast::extreme));
        expectOracle(pass, GetParam(), randomFrame(largeSize.width, largeSize.height, 5));
    }
}

TEST_F(LinearFilter, weightsHaveAtLeastTheBitsThatHistoryNeeds) {
    // Vulkan's least is 4 bits; below 8 a history of sub-pixel motion would drift visibly.
    EXPECT_LE(linearFilterError(), 0x1p-8);
    RecordProperty("error", std::to_string(linearFilterError()));
}

} // namespace
} // namespace passes
