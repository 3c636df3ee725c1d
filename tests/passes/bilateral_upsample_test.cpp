// SPDX-License-Identifier: Apache-2.0
// bilateral_upsample executed and held to the oracle. The functions' own test is
// bilateral_upsampling_test.cpp.
//
// Bound: that of the functions, and what the rounding of this pass's linear depth moves the weights by.
#include "bilateral_upsample_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -3.0f, 1e38f};

class BilateralUpsample : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, BilateralUpsample, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    for (const std::string_view values : {"one", "two", "four", "occlusion_in_integer", "shadow_in_integer", "with_frames"})
        for (int bits = 0; bits < 16; ++bits) {
            const auto value = [&](int bit) { return (bits >> bit & 1) != 0 ? "on" : "off"; };
            variants.push_back(variantOf(pack(), "bilateral_upsample",
                                         {{"VALUES", values},
                                          {"RATIO", (bits & 1) != 0 ? "4" : "2"},
                                          {"NORMAL_WEIGHTS", value(1)},
                                          {"DEPTH_LINEAR", value(2)},
                                          {"ORTHOGRAPHIC", value(3)}}));
        }
    return variants;
}

TEST_P(BilateralUpsample, everyVariantEqualsTheOracleAtEverySize) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), {rgba32f});
        for (const auto& [width, height] : sizes) {
            const auto frame = bilateralUpsampleCase(variant, width, height, 111);
            const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
            EXPECT_TRUE(result.holds())
                << describe(variant, GetParam(), width, height) << ": " << text(result);
        }
    }
}

TEST_P(BilateralUpsample, bothRatiosEqualTheOracleInHalfFloatAtALargeOddSize) {
    for (const std::string_view ratio : {"2", "4"}) {
        const Variant variant = variantOf(pack(), "bilateral_upsample", {{"RATIO", ratio}});
        Pass pass(variant, GetParam());
        const auto frame = bilateralUpsampleCase(variant, 641, 359, 112);
        const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
        EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 641, 359) << ": " << text(result);
    }
}

// A coarse texel is in the footprint of the pixels within a texel and a half of it.
bool mayReach(int ratio, glm::ivec2 coarse, int x, int y) {
    const glm::dvec2 away = (glm::dvec2(x, y) + 0.5) / double(ratio) - glm::dvec2(coarse) - 0.5;
    return std::max(std::abs(away.x), std::abs(away.y)) < 1.0;
}

TEST_P(BilateralUpsample, brokenTexelsStayInTheFootprintAndHaveNoShare) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), {rgba32f});
        for (const float value : poisons)
            for (int input = 0; input < 4; ++input) {
                auto frame = bilateralUpsampleCase(variant, 23, 13, 113);
                const Pixels clean = run(pass, frame)[0];
                const glm::ivec2 coarse(3, 2), fine(9, 7);
                if (input == 0 && value == -3.0f) continue; // a value like any other
                if (input == 3 && !frame.pass.normalWeights) continue;
                const glm::ivec2 pixel = oracle::pixelOfCoarseTexel(coarse, frame.pass.ratio);
                if (input == 0) frame.filtered.at(coarse.x, coarse.y, 0) = value;
                if (input == 1) frame.coarseDepth.at(coarse.x, coarse.y, 0) = value;
                if (input == 2) frame.depths.depth.at(fine.x, fine.y, 0) = value;
                for (int c = 0; c < 3 && input == 3; ++c)
                    frame.normal.at(pixel.x, pixel.y, c) = value;
                const Pixels got = run(pass, frame)[0];
                for (int y = 0; y < 13; ++y)
                    for (int x = 0; x < 23; ++x) {
                        const bool reached =
                            input == 2 ? glm::ivec2(x, y) == fine : mayReach(frame.pass.ratio, coarse, x, y);
                        for (int c = 0; c < 2; ++c) {
                            ASSERT_TRUE(got.at(x, y, c) >= 0.0f && got.at(x, y, c) <= 1.0f)
                                << describe(variant, GetParam(), 23, 13) << ": " << value << " in " << input;
                            if (!reached) {
                                ASSERT_EQ(got.at(x, y, c), clean.at(x, y, c)) << value << " in " << input;
                            }
                        }
                    }
                const Comparison result = compareWithOracle(frame, got);
                EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 23, 13) << ", " << value
                                            << " in " << input << ": " << text(result);
            }
    }
}

} // namespace
} // namespace passes
