// SPDX-License-Identifier: Apache-2.0
// bilateral_filter executed and held to the oracle. The functions' own test is
// directional_bilateral_test.cpp.
//
// Bound: roundings of the weights, and what the steps of the device's linear filter move
// (bilateral_filter_case).
#include "bilateral_filter_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr glm::ivec2 directions[] = {{1, 0}, {0, 1}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 1e38f};

class BilateralFilter : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, BilateralFilter, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    for (const std::string_view values : {"one", "two", "four", "occlusion_in_integer", "shadow_in_integer"})
        for (const std::string_view taps : {"linear", "point"})
            for (const std::string_view step : {"one", "any"})
                variants.push_back(variantOf(pack(), "bilateral_filter",
                                             {{"VALUES", values}, {"TAPS", taps}, {"STEP", step}}));
    return variants;
}

TEST_P(BilateralFilter, everyVariantEqualsTheOracleAtEverySize) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), {rgba32f});
        for (const auto& [width, height] : sizes)
            for (const glm::ivec2 direction : directions) {
                const auto frame = bilateralFilterCase(variant, width, height, direction, 101);
                const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), width, height) << ": " << text(result);
            }
    }
}

TEST_P(BilateralFilter, defaultsEqualTheOracleInHalfFloatAtALargeOddSize) {
    const Variant variant = variantOf(pack(), "bilateral_filter");
    Pass pass(variant, GetParam());
    const auto frame = bilateralFilterCase(variant, 641, 359, {1, 0}, 102);
    const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
    EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 641, 359) << ": " << text(result);
}

// The farthest that a tap of the direction reads: 4 texels; a linear one also texels beside it, of weight 0.
bool mayReach(const BilateralFilterCase& frame, glm::ivec2 texel, int x, int y) {
    const glm::ivec2 away = texel - glm::ivec2(x, y), along = away * frame.pass.direction;
    return std::abs(along.x + along.y) <= 4 + frame.pass.linear &&
           std::abs(away.x + away.y - along.x - along.y) <= frame.pass.linear;
}

TEST_P(BilateralFilter, brokenTexelsStayInTheFootprintAndAreFilledFromTheirNeighbours) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), {rgba32f});
        for (const float value : poisons)
            for (const int channel : {0, 1, 4, 5}) { // of the values, then of the state
                auto frame = bilateralFilterCase(variant, 33, 17, {1, 0}, 103);
                const Pixels clean = run(pass, frame)[0];
                (channel < 4 ? frame.cache : frame.state).at(11, 8, channel % 4) = value;
                const Pixels got = run(pass, frame)[0];
                for (int y = 0; y < 17; ++y)
                    for (int x = 0; x < 33; ++x)
                        for (int c = 0; c < 4; ++c) {
                            ASSERT_TRUE(std::abs(got.at(x, y, c)) <= 65504.0f) << value << " in " << channel;
                            if (!mayReach(frame, {11, 8}, x, y)) {
                                ASSERT_EQ(got.at(x, y, c), clean.at(x, y, c)) << value << " in " << channel;
                            }
                        }
                const bool isDepth = channel == (oracle::isDepthApart(frame.pass.values) ? 5 : 1);
                if (frame.pass.linear || (isDepth && value == 1e38f)) continue;
                const Comparison result = compareWithOracle(frame, got);
                EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 33, 17) << ", " << value
                                            << " in " << channel << ": " << text(result);
            }
    }
}

// Step 6: the fewer frames the history holds, the less of its own value a texel keeps. On one surface that is
// centre / (centre + smoothing (1 - centre)), smoothing from 0.7 at 8 frames to 3.7 at none.
TEST_P(BilateralFilter, filtersMoreWhereConvergenceIsLow) {
    const Variant variant = variantOf(pack(), "bilateral_filter");
    Pass pass(variant, GetParam(), {rgba32f});
    auto frame = bilateralFilterCase(variant, 33, 1, {1, 0}, 104);
    for (const float frames : {0.0f, 1.0f, 4.0f, 8.0f, 200.0f}) {
        for (int x = 0; x < 33; ++x) {
            frame.cache.at(x, 0, 0) = x == 16 ? 1.0f : 0.0f;
            frame.cache.at(x, 0, 1) = 3.0f;
            frame.state.at(x, 0, 0) = frames;
        }
        const double smoothing = 3.7 - 3.0 * std::min(double{frames} / 8.0, 1.0), centre = 0.402619947;
        // A step of the filter's weights may let some of the centre into a tap.
        EXPECT_NEAR(run(pass, frame)[0].at(16, 0, 0), centre / (centre + smoothing * (1.0 - centre)), 1e-5)
            << frames;
    }
}

} // namespace
} // namespace passes
