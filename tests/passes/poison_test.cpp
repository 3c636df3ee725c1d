// SPDX-License-Identifier: Apache-2.0
// Broken texels: what a NaN, an infinity, a negative or an enormous value in one texel of an input reaches,
// and how long it stays. Every output is finite whatever the inputs hold.
#include "footprint.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float poisons[] = {notANumber, infinity, -infinity, -3.0f, 1e38f};
constexpr std::string_view inputs[] = {"gInColour", "gInDepth", "gInVelocity", "gHistoryColour"};
// A corner, inside, and both halves of a quad.
constexpr glm::ivec2 places[] = {{0, 0}, {7, 6}, {10, 9}};
constexpr int width = 19, height = 14;

Pixels& inputOf(TemporalAaFrame& frame, std::string_view name) {
    return name == "gInColour"     ? frame.colour
           : name == "gInDepth"    ? frame.depth
           : name == "gInVelocity" ? frame.velocity
                                   : frame.history;
}

// The same image in 32-bit floats, which can hold 1e38.
void widen(Pixels& pixels) {
    pixels.format = pixels.format == rgba16f ? rgba32f : pixels.format == rg16f ? rg32f : pixels.format;
}

TemporalAaFrame wideFrame(uint64_t seed) {
    TemporalAaFrame frame = randomFrame(width, height, seed);
    for (std::string_view name : inputs)
        widen(inputOf(frame, name));
    return frame;
}

void poisonTexel(Pixels& pixels, glm::ivec2 place, float value) {
    for (int c = 0; c < pixels.channels; ++c)
        pixels.at(place.x, place.y, c) = value;
}

void poisonAll(Pixels& pixels, float value) {
    std::fill(pixels.values.begin(), pixels.values.end(), value);
}

// The first value that is no colour, in words; empty if there is none.
std::string firstBroken(const std::vector<Pixels>& outputs) {
    for (const Pixels& output : outputs)
        for (size_t i = 0; i < output.values.size(); ++i)
            if (!(output.values[i] >= 0.0f && output.values[i] <= 65504.0f))
                return std::to_string(output.values[i]) + " at texel " + std::to_string(i / 4);
    return {};
}

// The first pixel that differs from the clean run though the broken texel should not reach it.
std::string firstBeyondFootprint(const Pass& pass, Stage stage, const TemporalAaFrame& clean,
                                 std::string_view input, glm::ivec2 place,
                                 const std::vector<Pixels>& expected, const std::vector<Pixels>& got) {
    for (size_t output = 0; output < got.size(); ++output) {
        const Reached kind = output == 0 ? Reached::historyOutput : Reached::colourOutput;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c)
                    if (got[output].at(x, y, c) != expected[output].at(x, y, c) &&
                        !mayReach(pass.variant(), stage, clean, input, place, x, y, kind))
                        return "output " + std::to_string(output) + " pixel (" + std::to_string(x) + ", " +
                               std::to_string(y) + ")";
    }
    return {};
}

std::string poisonText(std::string_view input, float value, glm::ivec2 place) {
    return std::to_string(value) + " in " + std::string(input) + " at (" + std::to_string(place.x) + ", " +
           std::to_string(place.y) + ")";
}

class Poison : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, Poison, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

TEST_P(Poison, oneTexelStaysWithinTheFootprint) {
    const TemporalAaFrame clean = wideFrame(11);
    for (const Variant& variant : committedVariants("temporal_aa")) {
        Pass pass(variant, GetParam());
        const auto expected = run(pass, clean);
        size_t changed = 0;
        for (std::string_view input : inputs) {
            for (const float value : poisons) {
                for (const glm::ivec2 place : places) {
                    TemporalAaFrame poisoned = clean;
                    poisonTexel(inputOf(poisoned, input), place, value);
                    const auto got = run(pass, poisoned);
                    const std::string what =
                        describe(variant, GetParam(), width, height) + ", " + poisonText(input, value, place);
                    EXPECT_EQ(firstBroken(got), "") << what;
                    EXPECT_EQ(firstBeyondFootprint(pass, GetParam(), clean, input, place, expected, got), "")
                        << what;
                    changed += got[0].values != expected[0].values;
                }
            }
        }
        // A poison that no output ever saw would prove nothing.
        EXPECT_GE(changed, 10u) << describe(variant, GetParam(), width, height);
    }
}

TEST_P(Poison, wholeImagesLeaveFiniteOutputs) {
    for (const Variant& variant : committedVariants("temporal_aa")) {
        Pass pass(variant, GetParam());
        for (const float value : poisons) {
            TemporalAaFrame all = wideFrame(12);
            for (std::string_view input : inputs) {
                TemporalAaFrame one = wideFrame(12);
                poisonAll(inputOf(one, input), value);
                poisonAll(inputOf(all, input), value);
                EXPECT_EQ(firstBroken(run(pass, one)), "") << describe(variant, GetParam(), width, height)
                                                           << ", all of " << input << " is " << value;
            }
            EXPECT_EQ(firstBroken(run(pass, all)), "")
                << describe(variant, GetParam(), width, height) << ", all of every input is " << value;
        }
    }
}

// Point reads see a broken texel exactly, so the oracle tells what its repair gives: NaN and negative colours
// count as black, infinite ones as the largest.
TEST_P(Poison, brokenColoursCountAsTheirRepairedOnes) {
    for (Variant variant : committedVariants("temporal_aa")) {
        ASSERT_TRUE(reprise::setSwitch(variant, "MOTION_BLUR_FALLBACK", "off"));
        if (reprise::switchValue(variant, "NEIGHBOURHOOD") == "four_tap") continue; // reads between texels
        Pass pass(variant, GetParam(), {rgba32f});
        TemporalAaFrame frame = wideFrame(16);
        for (size_t i = 0; i < std::size(places); ++i)
            for (int c = 0; c < 3; ++c)
                frame.colour.at(places[i].x, places[i].y, c) = poisons[(i + static_cast<size_t>(c)) % 4];
        const Comparison result = compareWithOracle(variant, frame, run(pass, frame));
        EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), width, height) << ": " << text(result);
    }
}

// The largest difference of two images.
float largestDifference(const Pixels& a, const Pixels& b) {
    float largest = 0.0f;
    for (size_t i = 0; i < a.values.size(); ++i)
        largest = std::max(largest, std::abs(a.values[i] - b.values[i]));
    return largest;
}

// Nothing but the constant weight forgets what the poison left, so the difference falls as its powers. Frames
// are in float32: a half float stops forgetting when a step is lost in rounding, at 2^-11 / (1 - weight).
TEST_P(Poison, whatItLeavesInHistoryDecaysAsTheWeightsPowers) {
    const Variant variant =
        variantOf(pack(), "temporal_aa",
                  {{"CONSTRAINT", "none"}, {"CLOSEST_FRAGMENT", "off"}, {"MOTION_BLUR_FALLBACK", "off"}});
    Pass pass(variant, GetParam(), {rgba32f});
    TemporalAaFrame clean = wideFrame(13);
    poisonAll(clean.velocity, 0.0f);
    clean.parameters.gFeedbackMax = 0.75f;
    for (const std::string_view input : {"gInColour", "gInVelocity", "gHistoryColour"})
        for (const float value : poisons) {
            const std::string what = poisonText(input, value, {7, 6});
            TemporalAaFrame cleanRun = clean, poisonedRun = clean;
            poisonTexel(inputOf(poisonedRun, input), {7, 6}, value);
            cleanRun.history = run(pass, cleanRun)[0];
            poisonedRun.history = run(pass, poisonedRun)[0];
            const float first = largestDifference(cleanRun.history, poisonedRun.history);
            EXPECT_GT(first, 0.0f) << what;
            poisonedRun.colour = clean.colour; // the poison is gone
            poisonedRun.velocity = clean.velocity;
            for (int frame = 1; frame <= 8; ++frame) {
                cleanRun.history = run(pass, cleanRun)[0];
                poisonedRun.history = run(pass, poisonedRun)[0];
                EXPECT_EQ(firstBroken({poisonedRun.history}), "") << what;
                const float left = largestDifference(cleanRun.history, poisonedRun.history);
                EXPECT_LE(left, first * std::pow(0.75f, static_cast<float>(frame)) * 1.001f)
                    << what << ", frame " << frame;
            }
        }
}

// Where the depth is broken, so is the camera's motion: history is dropped, or comes from anywhere in the
// image, never from a NaN. With the depth the motion is whole again.
TEST_P(Poison, brokenDepthMovesHistoryForOneFrame) {
    for (const std::string_view closest : {"off", "on"}) {
        const Variant variant = variantOf(pack(), "temporal_aa",
                                          {{"MOTION", "camera"},
                                           {"CLOSEST_FRAGMENT", closest},
                                           {"CONSTRAINT", "none"},
                                           {"UNJITTER", "off"}});
        Pass pass(variant, GetParam(), {rgba32f, rgba32f});
        TemporalAaFrame clean = wideFrame(17);
        clean.depth.at(7, 6, 0) = 0x1p-11f; // the closest of all, which any poison changes
        const auto expected = run(pass, clean);
        for (const float value : poisons) {
            TemporalAaFrame frame = clean;
            poisonTexel(frame.depth, {7, 6}, value);
            const auto got = run(pass, frame);
            EXPECT_EQ(firstBroken(got), "") << value;
            size_t moved = 0;
            for (int i = 0; i < width * height; ++i) {
                const int x = i % width, y = i / width;
                const bool near =
                    std::abs(x - 7) <= (closest == "on") && std::abs(y - 6) <= (closest == "on");
                const bool same = got[0].at(x, y, 0) == expected[0].at(x, y, 0);
                EXPECT_TRUE(near || same) << value << " at " << x << ", " << y;
                moved += !same;
            }
            EXPECT_GT(moved, 0u) << value;
            // The motion of the next frame is that of its own depth, so the oracle, given the history that
            // the poison left, says what comes.
            frame.depth = clean.depth;
            frame.history = got[0];
            const auto next = run(pass, frame);
            const Comparison result = compareWithOracle(variant, frame, next);
            EXPECT_TRUE(result.holds()) << value << ": " << text(result);
        }
    }
}

// With the neighbourhood, what is left after one frame lies in the box of the clean colours around it.
TEST_P(Poison, theNeighbourhoodForgetsAfterOneFrame) {
    for (const std::string_view constraint : {"clamp", "clip_centre", "clip_line"}) {
        const Variant variant = variantOf(pack(), "temporal_aa",
                                          {{"CONSTRAINT", constraint},
                                           {"NEIGHBOURHOOD", "square"},
                                           {"UNJITTER", "off"},
                                           {"MOTION_BLUR_FALLBACK", "off"}});
        Pass pass(variant, GetParam(), {rgba32f});
        TemporalAaFrame frame = wideFrame(14);
        poisonAll(frame.velocity, 0.0f);
        const Pixels colour = frame.colour;
        for (const float value : poisons) {
            frame.colour = colour;
            poisonTexel(frame.colour, {7, 6}, value);
            frame.history = run(pass, frame)[0];
            frame.colour = colour;
            const Pixels next = run(pass, frame)[0];
            const oracle::Image image = oracleImage(colour);
            for (int i = 0; i < width * height; ++i) {
                const int x = i % width, y = i / width;
                const oracle::Box box = oracle::boxOfSquare(oracle::squareAt(image, x, y));
                for (int c = 0; c < 3; ++c) {
                    const double slack = 0x1p-20 * box.maximum[c]; // roundings of the blend
                    ASSERT_GE(next.at(x, y, c), box.minimum[c] - slack) << constraint << " " << value;
                    ASSERT_LE(next.at(x, y, c), box.maximum[c] + slack) << constraint << " " << value;
                }
            }
        }
    }
}

// The first frame, and the frame after a cut, a gap or a resize: history is not looked at, whatever it holds.
TEST_P(Poison, invalidHistoryGivesTheCurrentColourExactly) {
    for (const Variant& variant : committedVariants("temporal_aa")) {
        Pass pass(variant, GetParam());
        TemporalAaFrame frame = randomFrame(width, height, 15);
        frame.parameters.gHistoryValid = 0.0f;
        const auto expected = run(pass, frame);
        const Comparison current = compareWithOracle(variant, frame, expected);
        EXPECT_TRUE(current.holds()) << describe(variant, GetParam(), width, height) << ": " << text(current);
        for (const float value : {notANumber, infinity, -infinity, -3.0f, 65504.0f, 0.0f}) {
            poisonAll(frame.history, value);
            const auto got = run(pass, frame);
            for (size_t i = 0; i < got.size(); ++i)
                EXPECT_EQ(got[i].values, expected[i].values)
                    << describe(variant, GetParam(), width, height) << ", history is " << value;
        }
    }
}

} // namespace
} // namespace passes
