// SPDX-License-Identifier: Apache-2.0
// depth_hierarchy executed and held to the oracle.
//
// Bound: float32 roundings of the conversion to metres (linearDepthBound in depth_downsample_case.cpp). Which
// texel is shown has none.
#include "depth_hierarchy_case.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {5, 40}, {64, 64}, {641, 359}};
constexpr float infinity = std::numeric_limits<float>::infinity();

class DepthHierarchy : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, DepthHierarchy, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    for (const std::string_view linear : {"off", "on"})
        for (const std::string_view orthographic : {"off", "on"})
            variants.push_back(variantOf(pack(), "depth_hierarchy",
                                         {{"DEPTH_LINEAR", linear}, {"ORTHOGRAPHIC", orthographic}}));
    return variants;
}

TEST_P(DepthHierarchy, everyVariantEqualsTheOracleForEveryDepthKindAtEverySize) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam());
        for (const Depth kind : {Depth::standard, Depth::reversed, Depth::reversedInfinite})
            for (const auto& [width, height] : sizes) {
                const auto frame = depthHierarchyCase(variant, width, height, 111, kind);
                const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), width, height) << ": " << text(result);
            }
    }
}

// A broken depth is the sky's in the texels that show it, and in no other.
TEST_P(DepthHierarchy, brokenDepthsAreSkyInTheTexelsThatShowThem) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam());
        for (const float value : {std::nanf(""), infinity, -infinity, -3.0f, 1e38f}) {
            auto frame = depthHierarchyCase(variant, 33, 17, 112);
            for (const glm::ivec2 place : {glm::ivec2(0, 0), glm::ivec2(11, 4), glm::ivec2(32, 16)})
                frame.depths.depth.at(place.x, place.y, 0) = value;
            const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
            EXPECT_TRUE(result.holds()) << value << ": " << text(result);
            std::fill(frame.depths.depth.values.begin(), frame.depths.depth.values.end(), value);
            const Pixels all = run(pass, frame)[0];
            for (const float depth : all.values)
                ASSERT_EQ(depth, 65504.0f) << describe(variant, GetParam(), 33, 17) << ", all is " << value;
        }
    }
}

// The rotated grid: of a level k the columns and rows that its texels show lie at most 2^k apart and are at
// least twice as many as it has, where a plain grid shows one row in 2^k alone.
TEST(DepthHierarchyLevels, showTwiceTheColumnsAndRowsThatTheyHave) {
    for (int level = 1; level < oracle::levelCount; ++level) {
        std::set<int> columns, rows;
        const glm::ivec2 extent = oracle::levelExtent({64, 64}, level);
        for (int y = 0; y < extent.y; ++y)
            for (int x = 0; x < extent.x; ++x) {
                const glm::ivec2 shown = oracle::shownTexel({x, y}, level);
                EXPECT_EQ(shown >> level, glm::ivec2(x, y)); // within the square that it stands for
                columns.insert(shown.x);
                rows.insert(shown.y);
            }
        EXPECT_EQ(columns.size(), 2u * static_cast<size_t>(extent.x));
        EXPECT_EQ(rows.size(), 2u * static_cast<size_t>(extent.y));
    }
}

} // namespace
} // namespace passes
