// SPDX-License-Identifier: Apache-2.0
// reprojection_cache executed and held to the oracle. The functions' own test is under tests/functions.
//
// Bound of a pixel: what a history misplaced by float32's roundings, or weights of a filter of few bits,
// change in it (placeError and depthError in reprojection_cache_case.cpp), and the store.
#include "reprojection_cache_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}, {641, 359}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 1e38f};

class ReprojectionCache : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, ReprojectionCache, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

bool isFramed(const Variant& variant) {
    return reprise::switchValue(variant, "VALUES") == "with_frames";
}

// Every combination but those that read no history, of which one is enough.
std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    const auto add = [&](std::initializer_list<reprise::Condition> switches) {
        variants.push_back(variantOf(pack(), "reprojection_cache", switches));
    };
    for (const std::string_view values :
         {"one", "two", "four", "occlusion_in_integer", "shadow_in_integer", "with_frames"}) {
        for (const std::string_view resampling : {"nearest", "bilinear"})
            for (const std::string_view history : {"camera", "motion", "still"})
                for (const std::string_view change : {"off", "on"})
                    for (const std::string_view orthographic : {"off", "on"})
                        add({{"VALUES", values},
                             {"RESAMPLING", resampling},
                             {"HISTORY", history},
                             {"CHANGE_DETECTION", change},
                             {"ORTHOGRAPHIC", orthographic}});
        add({{"VALUES", values}, {"HISTORY", "none"}});
    }
    return variants;
}

TEST_P(ReprojectionCache, everyVariantEqualsTheOracleAtEverySize) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), cacheFormats(variant));
        for (const auto& [width, height] : sizes) {
            if (width > 64 && reprise::variantName(variant) != "reprojection_cache") continue;
            const auto frame = reprojectionCacheCase(variant, width, height, 91);
            const Comparison result = compareWithOracle(frame, run(pass, frame));
            EXPECT_TRUE(result.holds())
                << describe(variant, GetParam(), width, height) << ": " << text(result);
        }
    }
}

// The first frame, a cut, a gap or a resize: this frame alone, and one frame of convergence, whatever the
// history holds.
TEST_P(ReprojectionCache, invalidHistoryGivesTheFreshValue) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), cacheFormats(variant));
        auto frame = reprojectionCacheCase(variant, 33, 17, 92);
        frame.pass.historyValid = 0.0;
        setParameters(frame);
        for (const float value : poisons) {
            std::fill(frame.history.values.begin(), frame.history.values.end(), value);
            std::fill(frame.state.values.begin(), frame.state.values.end(), value);
            std::fill(frame.historyDepth.values.begin(), frame.historyDepth.values.end(), value);
            const auto got = run(pass, frame);
            if (isFramed(variant)) {
                const Comparison result = compareWithOracle(frame, got);
                EXPECT_TRUE(result.holds())
                    << describe(variant, GetParam(), 33, 17) << ": " << text(result) << " of " << value;
                continue;
            }
            for (int y = 0; y < got[0].height; ++y)
                for (int x = 0; x < got[0].width; ++x) {
                    // Packing what was packed moves the fraction by roundings alone.
                    ASSERT_NEAR(got[0].at(x, y, 0), frame.fresh.at(x, y, 0), 4e-6f) << value;
                    ASSERT_EQ(got[1].at(x, y, 0), 1.0f) << value;
                }
        }
    }
}

// Broken texels of every input: all that comes out is what a history can hold.
TEST_P(ReprojectionCache, brokenTexelsLeaveNumbers) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), cacheFormats(variant));
        const auto clean = reprojectionCacheCase(variant, 33, 17, 93);
        for (const float value : poisons)
            for (int input = 0; input < 6; ++input) {
                auto frame = clean;
                Pixels* const inputs[] = {&frame.fresh, &frame.velocity,    &frame.history,
                                          &frame.state, &frame.coarseDepth, &frame.historyDepth};
                Pixels& poisoned = *inputs[input];
                for (size_t i = 0; i < poisoned.values.size(); i += 5)
                    poisoned.values[i] = value;
                for (const Pixels& got : run(pass, frame))
                    for (const float each : got.values)
                        ASSERT_TRUE(isFramed(variant) ? each >= 0.0f && each < 0x1p24f
                                                      : std::abs(each) <= 65504.0f)
                            << describe(variant, GetParam(), 33, 17) << ", input " << input << ": " << value;
            }
    }
}

// A broken texel of history reaches the pixels that read it, and those hold the fresh value: they equal the
// oracle, as does every other.
TEST_P(ReprojectionCache, brokenHistoryIsNotUsed) {
    for (const Variant& variant : allVariants()) {
        Pass pass(variant, GetParam(), cacheFormats(variant));
        for (const float value : poisons)
            for (const int channel : {0, 1, 4, 5}) { // of the values, then of the state
                auto frame = reprojectionCacheCase(variant, 33, 17, 94);
                if (isFramed(variant) && channel != 0 && channel != 4) continue;
                if (isFramed(variant))
                    (channel == 0 ? frame.history : frame.historyDepth).at(7, 4, 0) = value;
                else
                    (channel < 4 ? frame.history : frame.state).at(7, 4, channel % 4) = value;
                // Between texels a filter spreads what is broken, to texels of weight 0 too.
                const auto got = run(pass, frame);
                for (const Pixels& image : got)
                    for (const float each : image.values)
                        ASSERT_TRUE(std::abs(each) <= (isFramed(variant) ? 0x1p24f : 65504.0f)) << value;
                // Packed pairs are read one by one, and a broken one is left out; their frames are not.
                const bool spreads = frame.pass.bilinear && !isFramed(variant) &&
                                     (!oracle::isPacked(frame.pass.values) || channel == 4);
                if (spreads || frame.pass.where == oracle::CachePass::History::none) continue;
                const Comparison result = compareWithOracle(frame, got);
                EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 33, 17) << ", " << value
                                            << " in channel " << channel << ": " << text(result);
            }
    }
}

// A standing image: the value is the mean of its frames until the largest weight is reached, and the
// convergence counts them.
TEST_P(ReprojectionCache, framesAreAveragedAndCounted) {
    const Variant variant = variantOf(pack(), "reprojection_cache");
    Pass pass(variant, GetParam(), {rgba32f, rg32f});
    auto frame = reprojectionCacheCase(variant, 32, 32, 95);
    frame.pass.previous = frame.pass.current;
    frame.pass.historyValid = 0.0;
    setParameters(frame);
    double sum = 0.0;
    for (int n = 1; n <= 9; ++n) {
        const double value = unitHash(96, static_cast<uint64_t>(n));
        sum += value;
        for (int i = 0; i < 16 * 16; ++i)
            frame.fresh.at(i % 16, i / 16, 0) = static_cast<float>(value);
        const auto got = run(pass, frame);
        frame.history = got[0];
        frame.state = got[1];
        for (int i = 0; i < 16 * 16; ++i) {
            ASSERT_NEAR(frame.history.at(i % 16, i / 16, 0), sum / n, 2e-6) << n;
            ASSERT_NEAR(frame.state.at(i % 16, i / 16, 0), n, 1e-4) << n;
        }
        frame.pass.historyValid = 1.0;
        setParameters(frame);
    }
}

// The fresh values jump, depths do not: with change detection the history of a texel is given up at once
// where the jump is beyond what the values around scatter, and kept where it is within.
TEST_P(ReprojectionCache, changesAreDetected) {
    Pass pass(variantOf(pack(), "reprojection_cache", {{"HISTORY", "still"}, {"CHANGE_DETECTION", "on"}}),
              GetParam(), {rgba32f, rg32f});
    for (const bool jumps : {false, true}) {
        auto frame = reprojectionCacheCase(pass.variant(), 64, 64, 97);
        for (int y = 0; y < frame.fresh.height; ++y)
            for (int x = 0; x < frame.fresh.width; ++x) {
                const double noise = 0.2 * unitHash(98, static_cast<uint64_t>(x), static_cast<uint64_t>(y));
                frame.fresh.at(x, y, 0) = static_cast<float>((jumps ? 0.8 : 0.4) + noise);
                frame.history.at(x, y, 0) = 0.5f;
                frame.history.at(x, y, 1) = frame.fresh.at(x, y, 1);
                frame.state.at(x, y, 0) = 9.0f;
            }
        const Pixels got = run(pass, frame)[1];
        for (int y = 0; y < got.height; ++y)
            for (int x = 0; x < got.width; ++x)
                ASSERT_EQ(got.at(x, y, 0), jumps ? 1.0f : 10.0f) << x << ", " << y;
    }
}

} // namespace
} // namespace passes
