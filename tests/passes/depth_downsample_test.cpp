// SPDX-License-Identifier: Apache-2.0
// depth_downsample executed and held to the oracle.
//
// Bound: float32 roundings of the conversion to metres (linearDepthBound in depth_downsample_case.cpp). Which
// texel is chosen has none: device depth is monotonic in linear depth, so both see the same order.
#include "depth_downsample_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}, {641, 359}};

class DepthDownsample : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, DepthDownsample, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

// Every combination, not the committed ones alone: depth kind, projection and choice act on each other.
std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    for (const std::string_view ratio : {"1", "2", "4"})
        for (int bits = 0; bits < 16; ++bits) {
            const auto value = [&](int bit) { return (bits >> bit & 1) != 0 ? "on" : "off"; };
            variants.push_back(variantOf(pack(), "depth_downsample",
                                         {{"RATIO", ratio},
                                          {"CHECKERBOARD", value(0)},
                                          {"DEPTH_LINEAR", value(1)},
                                          {"DEPTH_REVERSED", value(2)},
                                          {"ORTHOGRAPHIC", value(3)}}));
        }
    return variants;
}

TEST_P(DepthDownsample, everyVariantEqualsTheOracleAtEverySize) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam());
        for (const bool infinite : {false, true}) {
            if (infinite && reprise::switchValue(variant, "DEPTH_REVERSED") == "off") continue;
            for (const auto& [width, height] : sizes) {
                const auto frame = randomDepthDownsampleCase(variant, width, height, 71, infinite);
                const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), width, height) << ": " << text(result);
            }
        }
    }
}

// A broken depth counts as sky: it reaches the texel above it, and leaves that one a depth.
TEST_P(DepthDownsample, brokenDepthReachesItsOwnTexelAlone) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam());
        const auto clean = randomDepthDownsampleCase(variant, 19, 14, 72);
        const Pixels expected = run(pass, clean)[0];
        for (const float value : {std::nanf(""), infinity, -infinity, -3.0f, 1e38f}) {
            auto frame = clean;
            const glm::ivec2 place(9, 6), coarse = place / frame.pass.ratio;
            frame.depth.at(place.x, place.y, 0) = value;
            const Pixels got = run(pass, frame)[0];
            const Comparison result = compareWithOracle(frame, got);
            EXPECT_TRUE(result.holds())
                << describe(variant, GetParam(), 19, 14) << ", " << value << ": " << text(result);
            for (int y = 0; y < got.height; ++y)
                for (int x = 0; x < got.width; ++x)
                    if (glm::ivec2(x, y) != coarse) {
                        EXPECT_EQ(got.at(x, y, 0), expected.at(x, y, 0)) << value << " at " << x << ", " << y;
                    }
            std::fill(frame.depth.values.begin(), frame.depth.values.end(), value);
            const Pixels all = run(pass, frame)[0];
            for (const float depth : all.values)
                ASSERT_EQ(depth, 65504.0f) << describe(variant, GetParam(), 19, 14) << ", all is " << value;
        }
    }
}

// HALF_DEPTH: the same depth in either image, of 11 significant bits in the second, and hardly nearer there.
TEST_P(DepthDownsample, halfDepthIsTheSame) {
    const Variant variant = variantOf(pack(), "depth_downsample", {{"HALF_DEPTH", "on"}});
    Pass pass(variant, GetParam());
    const auto frame = randomDepthDownsampleCase(variant, 39, 27, 58);
    const auto got = run(pass, frame);
    ASSERT_EQ(got.size(), 2u);
    EXPECT_TRUE(compareWithOracle(frame, got[0]).holds());
    for (int y = 0; y < got[0].height; ++y)
        for (int x = 0; x < got[0].width; ++x) {
            const float depth = got[0].at(x, y, 0), half = got[1].at(x, y, 0);
            ASSERT_GE(half, depth * (1.0f - 0x1.01p-11f));
            ASSERT_LE(half, depth * (1.0f + 0x1.01p-10f));
        }
}

} // namespace
} // namespace passes
