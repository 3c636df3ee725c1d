// SPDX-License-Identifier: Apache-2.0
// obscurance_filter executed and held to the oracle.
//
// Bound: roundings of nine weights, and where they decide a step of the value, that step of 1/4080.
#include "scalable_obscurance_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}, {641, 359}};
constexpr glm::ivec2 directions[] = {{1, 0}, {0, 1}, {2, 0}, {0, 3}};

class ObscuranceFilter : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, ObscuranceFilter, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

TEST_P(ObscuranceFilter, equalsTheOracleInEveryDirectionAtEverySize) {
    const Variant variant = variantOf(pack(), "obscurance_filter");
    Pass pass(variant, GetParam());
    for (const auto& [width, height] : sizes)
        for (const glm::ivec2 direction : directions) {
            const auto frame = obscuranceFilterCase(width, height, direction, 121);
            const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
            EXPECT_TRUE(result.holds())
                << describe(variant, GetParam(), width, height) << ": " << text(result);
        }
}

// Depth and frames pass through both runs, digit for digit.
TEST_P(ObscuranceFilter, depthAndFramesPassThrough) {
    Pass pass(variantOf(pack(), "obscurance_filter"), GetParam());
    const auto across = obscuranceFilterCase(33, 17, {1, 0}, 122);
    auto down = across;
    down.pass.direction = {0, 1};
    down.source = run(pass, across)[0];
    setParameters(down);
    const Pixels got = run(pass, down)[0];
    for (int i = 0; i < 33 * 17; ++i) {
        const int x = i % 33, y = i / 33;
        for (const int c : {1, 2})
            ASSERT_EQ(got.at(x, y, c), across.source.at(x, y, c)) << x << ", " << y;
        const auto frames = [&](const Pixels& of) { return std::lround(255.0f * of.at(x, y, 3)) / 16; };
        ASSERT_EQ(frames(got), frames(across.source)) << x << ", " << y;
    }
}

// An edge of more than the range: each side keeps its own value exactly, whatever the other's.
TEST_P(ObscuranceFilter, nothingPassesAnEdge) {
    Pass pass(variantOf(pack(), "obscurance_filter"), GetParam());
    auto frame = obscuranceFilterCase(33, 17, {1, 0}, 123);
    frame.source = makePixels(rgba8, 33, 17, [&](int x, int) {
        const glm::dvec4 digits =
            oracle::packedObscurance({x < 16 ? 0.25 : 1.0, x < 16 ? 4.0 : 4.25, 1.0}, frame.pass.farM);
        return Texel{static_cast<float>(digits.x), static_cast<float>(digits.y), static_cast<float>(digits.z),
                     static_cast<float>(digits.w)};
    });
    const Pixels got = run(pass, frame)[0];
    EXPECT_EQ(got.values, frame.source.values);
}

// What a target of more bits may hold and this one does not.
TEST_P(ObscuranceFilter, brokenTexelsOfFloatImagesLeaveNumbers) {
    Pass pass(variantOf(pack(), "obscurance_filter"), GetParam(), {rgba32f});
    for (const float value : {std::nanf(""), std::numeric_limits<float>::infinity(), -3.0f, 1e38f}) {
        auto frame = obscuranceFilterCase(33, 17, {1, 0}, 124);
        frame.source.format = rgba32f;
        const Pixels clean = run(pass, frame)[0];
        for (int c = 0; c < 4; ++c)
            frame.source.at(11, 8, c) = value;
        const Pixels got = run(pass, frame)[0];
        for (int i = 0; i < 33 * 17 * 4; ++i) {
            const size_t at = static_cast<size_t>(i);
            ASSERT_TRUE(got.values[at] >= 0.0f && got.values[at] <= 1.0f) << value;
            const int x = i / 4 % 33, y = i / 4 / 33;
            if (y != 8 || std::abs(x - 11) > 4) {
                ASSERT_EQ(got.values[at], clean.values[at]) << value << " at " << x << ", " << y;
            }
        }
    }
}

} // namespace
} // namespace passes
