// SPDX-License-Identifier: Apache-2.0
// scalable_obscurance executed and held to the oracle.
//
// Bound of a pixel: how far roundings may move its taps, its normal and its place in the history, what that
// changes (scalable_obscurance.hpp in tests/oracle/), and where it decides a step of the value, that step of
// 1/4080.
#include "changed_pack.hpp"
#include "scalable_obscurance_case.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {1, 40}, {64, 64}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -3.0f, 1e38f};

class ScalableObscuranceOracle : public PassTest {};
class ScalableObscurance : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, ScalableObscurance, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> variants() {
    std::vector<Variant> found = committedVariants("scalable_obscurance");
    found.push_back(variantOf(pack(), "scalable_obscurance", {{"MOTION", "off"}, {"ORTHOGRAPHIC", "on"}}));
    return found;
}

void expectOracle(Pass& pass, Stage stage, const ScalableObscuranceCase& frame) {
    const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
    EXPECT_TRUE(result.holds()) << describe(pass.variant(), stage, frame.depth.width, frame.depth.height)
                                << ", frame " << frame.pass.frame << ": " << text(result);
}

TEST_P(ScalableObscurance, equalsTheOracleAtEverySizeAndInEveryFrame) {
    for (const Variant& variant : variants()) {
        Pass pass(variant, GetParam());
        for (const Surfaces surfaces : {Surfaces::random, Surfaces::corner})
            for (const auto& [width, height] : sizes)
                for (const int frame : {0, 1, 5})
                    expectOracle(pass, GetParam(),
                                 scalableObscuranceCase(variant, surfaces, width, height, 131, frame));
    }
}

TEST_P(ScalableObscurance, defaultsEqualTheOracleAtALargeOddSize) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, GetParam());
    expectOracle(pass, GetParam(), scalableObscuranceCase(variant, Surfaces::corner, 641, 359, 132));
}

// A bound as wide as the whole range would let anything pass.
TEST_F(ScalableObscuranceOracle, boundsAreNarrow) {
    const auto frame =
        scalableObscuranceCase(variantOf(pack(), "scalable_obscurance"), Surfaces::corner, 64, 64, 133);
    const oracle::Image depth = oracleImage(frame.depth);
    oracle::ScalableObscurance pass = frame.pass;
    pass.depth = &depth;
    double sum = 0.0, occluded = 0.0;
    for (int i = 0; i < 64 * 64; ++i) {
        const oracle::Visibility visibility = oracle::obscuranceAt(pass, i % 64, i / 64);
        sum += visibility.error;
        occluded += visibility.value < 0.9;
    }
    EXPECT_LT(sum / (64 * 64), 0.01); // a hundredth of the range
    EXPECT_GT(occluded, 400.0);       // of the corner, of the card and of what it stands before
}

bool isObscurance(const Pixels& digits) {
    for (const float value : digits.values)
        if (!(value >= 0.0f && value <= 1.0f)) return false;
    return true;
}

// Broken depths count as sky, broken motion leads nowhere: the oracle says what every pixel shows.
TEST_P(ScalableObscurance, brokenTexelsAreSkyOrHaveNoHistory) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, GetParam());
    for (const float value : poisons) {
        auto frame = scalableObscuranceCase(variant, Surfaces::corner, 33, 17, 134);
        frame.velocity.at(20, 8, 0) = value;
        frame.velocity.at(21, 8, 1) = value;
        // As depth_hierarchy leaves it, and as it never does.
        frame.depth.at(10, 9, 0) = value;
        setParameters(frame);
        // Three pixels of motion, in its unit, are a place in the image.
        if (value != -3.0f) expectOracle(pass, GetParam(), frame);
        frame.hierarchy.at(10, 9, 0) = value;
        EXPECT_TRUE(isObscurance(run(pass, frame)[0])) << value;
        for (Pixels* all : {&frame.velocity, &frame.hierarchy}) {
            std::fill(all->values.begin(), all->values.end(), value);
            EXPECT_TRUE(isObscurance(run(pass, frame)[0])) << value;
        }
    }
}

// What is written into a float target, and read from it as history, is held as well.
TEST_P(ScalableObscurance, brokenHistoriesOfFloatImagesLeaveNumbers) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, GetParam(), {rgba32f});
    for (const float value : poisons) {
        auto frame = scalableObscuranceCase(variant, Surfaces::corner, 33, 17, 135);
        frame.history.format = rgba32f;
        std::fill(frame.history.values.begin(), frame.history.values.end(), value);
        EXPECT_TRUE(isObscurance(run(pass, frame)[0])) << value;
    }
}

// The first frame, and the frame after a cut, a gap or a resize: history is not looked at.
TEST_P(ScalableObscurance, invalidHistoryGivesTheCurrentFrameExactly) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, GetParam());
    auto frame = scalableObscuranceCase(variant, Surfaces::corner, 33, 17, 136);
    frame.pass.historyValid = 0.0;
    setParameters(frame);
    expectOracle(pass, GetParam(), frame);
    const Pixels expected = run(pass, frame)[0];
    for (const float value : {0.0f, 0.5f, 1.0f}) {
        std::fill(frame.history.values.begin(), frame.history.values.end(), value);
        EXPECT_EQ(run(pass, frame)[0].values, expected.values) << value;
    }
}

// The table says that the hierarchy is wider than the frame; one that is not is refused.
TEST_P(ScalableObscurance, aHierarchyOfTheFramesExtentIsRefused) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, GetParam());
    auto frame = scalableObscuranceCase(variant, Surfaces::corner, 33, 17, 140);
    frame.hierarchy = frame.depth;
    try {
        run(pass, frame);
        ADD_FAILURE() << "it was taken";
    } catch (const std::exception& refused) {
        EXPECT_NE(std::string(refused.what()).find("gInDepthHierarchy is 33x17"), std::string::npos)
            << refused.what();
    }
}

// Turns of neighbours leave no wide gap: those of any 4x4 pixels at most a tenth of a turn, and those of the
// blur's 9x9 a thirtieth. As many random ones leave about ln(n) / n: 0.17 and 0.054.
TEST(ScalableObscuranceTurns, ofAnyNeighboursAreSpreadEvenly) {
    for (const auto& [side, most] : {std::pair(4, 0.1), std::pair(9, 1.0 / 30.0)})
        for (const glm::ivec2 corner : {glm::ivec2(0, 0), glm::ivec2(17, 4), glm::ivec2(1276, 711)}) {
            std::set<double> turns;
            for (int i = 0; i < side * side; ++i)
                turns.insert(oracle::numberOfPixel(corner.x + i % side, corner.y + i / side));
            double gap = *turns.begin() + 1.0 - *turns.rbegin();
            for (auto next = std::next(turns.begin()); next != turns.end(); ++next)
                gap = std::max(gap, *next - *std::prev(next));
            EXPECT_LE(gap, most) << side;
        }
}

// A tilted plane that fills the view, 5 m away.
Pixels tiltedPlane(const ScalableObscuranceCase& frame, int size) {
    const glm::dvec4 ray = frame.pass.viewRay;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, 0.7, -1.0));
    return makePixels(r32f, size, size, [&](int x, int y) {
        const glm::dvec2 xy =
            (glm::dvec2(x, y) + 0.5) / double(size) * glm::dvec2(ray.x, ray.y) + glm::dvec2(ray.z, ray.w);
        return Texel{static_cast<float>(-5.0 / glm::dot(normal, glm::dvec3(xy, 1.0)))};
    });
}

// Nothing stands over a plane, however steep and however coarse the levels: a tap's depth is that of its
// texel's place. Taken for the place asked for, coarse levels darken it.
TEST_P(ScalableObscurance, planesAreOpen) {
    const Variant variant =
        variantOf(pack(), "scalable_obscurance", {{"SAMPLES", "33"}, {"TEMPORAL", "off"}});
    Pass pass(variant, GetParam());
    auto frame = scalableObscuranceCase(variant, Surfaces::corner, 256, 256, 137);
    frame.depth = tiltedPlane(frame, 256);
    frame.pass.radius = 8.0;
    frame.pass.bias = {0.0, 1e-4};
    setParameters(frame);
    const Pixels open = unpacked(run(pass, frame)[0], frame.pass.farM);
    for (int i = 0; i < 256 * 256; ++i)
        ASSERT_EQ(open.at(i % 256, i / 256, 0), 1.0f) << i % 256 << ", " << i / 256;
}

// --- Accumulation of a standing view

constexpr int side = 128;
constexpr double standingIntensity = 1.0; // the default

ScalableObscuranceCase standingView(const Variant& variant) {
    auto frame = scalableObscuranceCase(variant, Surfaces::corner, side, side, 138);
    frame.pass.radius = double{1.5f};
    // A lattice of boxes before the corner, so that there are edges and contacts everywhere; no sky.
    frame.depth = makePixels(r32f, side, side, [&](int x, int y) {
        const glm::dvec2 xy = (glm::dvec2(x, y) + 0.5) / double(side);
        const float wall = static_cast<float>(6.0 - 2.0 * xy.x - 1.5 * std::abs(xy.y - 0.5));
        const bool isBox = x / 11 % 3 == 1 && y / 9 % 2 == 1;
        return Texel{wall - (isBox ? 0.4f : 0.0f) - 0.05f * static_cast<float>(unitHash(139, x / 4, y / 4))};
    });
    frame.pass.historyValid = 0.0;
    frame.pass.intensity = standingIntensity;
    setParameters(frame);
    return frame;
}

using Values = std::vector<double>;

Values valuesOf(const Pixels& digits, double farM) {
    const Pixels shown = unpacked(digits, farM);
    Values values;
    for (int i = 0; i < side * side; ++i)
        values.push_back(double{shown.at(i % side, i / side, 0)});
    return values;
}

// One frame of a pattern of `rotations`, without a history.
Values single(Stage stage, std::string_view samples, int rotations, int frameIndex,
              const reprisec::Pack& from = pack(), double intensity = standingIntensity) {
    const Variant variant =
        variantOf(from, "scalable_obscurance", {{"SAMPLES", samples}, {"TEMPORAL", "off"}});
    Pass pass(variant, stage, {}, from);
    auto frame = standingView(variant);
    frame.pass.rotations = rotations;
    frame.pass.frame = frameIndex;
    frame.pass.intensity = intensity;
    setParameters(frame);
    return valuesOf(run(pass, frame)[0], frame.pass.farM);
}

double rms(const Values& a, const Values& b) {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// Of 16 frames of 33 taps each, which together are a spiral of 528. At the clear intensity no frame is black,
// so that what is black is so after the mean.
Values converged(Stage stage, double clearIntensity, const reprisec::Pack& from) {
    Values mean(side * side, 0.0);
    for (int frame = 0; frame < 16; ++frame) {
        const Values each = single(stage, "33", 16, frame, from, clearIntensity);
        for (size_t i = 0; i < each.size(); ++i)
            mean[i] += each[i] / 16.0;
    }
    for (double& value : mean)
        value = std::max(1.0 - standingIntensity / clearIntensity * (1.0 - value), 0.0);
    return mean;
}

// The history, from frame to frame, through RGBA8.
class Accumulation {
public:
    Accumulation(Stage stage, std::string_view samples, const reprisec::Pack& from = pack(),
                 std::string_view motion = "off")
        : variant_(variantOf(from, "scalable_obscurance", {{"SAMPLES", samples}, {"MOTION", motion}})),
          pass_(variant_, stage, {}, from), frame_(standingView(variant_)) {}

    ScalableObscuranceCase& frame() { return frame_; }
    Values next() {
        setParameters(frame_);
        frame_.history = run(pass_, frame_)[0];
        frame_.pass.historyValid = 1.0;
        ++frame_.pass.frame;
        return valuesOf(frame_.history, frame_.pass.farM);
    }

private:
    Variant variant_;
    Pass pass_;
    ScalableObscuranceCase frame_;
};

// RMSE against the converged estimator.
struct StandingErrors {
    double one = 0.0, three = 0.0, settled = 0.0, whole = 0.0;
};

StandingErrors standingErrors(Stage stage, std::string_view few, std::string_view many, const Values& limit,
                              const reprisec::Pack& from = pack()) {
    StandingErrors errors;
    errors.one = rms(single(stage, few, 3, 1, from), limit);
    errors.whole = rms(single(stage, many, 1, 0, from), limit);
    Accumulation accumulation(stage, few, from);
    accumulation.frame().pass.frame = 0;
    for (int i = 0; i < 63; ++i) {
        const double error = rms(accumulation.next(), limit);
        if (i == 2) errors.three = error;
        if (i >= 60) errors.settled += error / 3.0;
    }
    std::printf("%s taps: RMSE %.5f in a frame, %.5f after three, %.5f after 63, %.5f of %s in one\n",
                few.data(), errors.one, errors.three, errors.settled, errors.whole, many.data());
    return errors;
}

constexpr std::pair<const char*, const char*> fewAndMany[] = {{"5", "15"}, {"7", "21"}, {"11", "33"}};

// "For a static image it meant tripling the effective sample count": against the converged estimator three
// rotations err as one frame of three times the samples does, within 5 %. So they do by construction where
// the frames have equal weights, as the first three have; what is left is the clamp at black, the taps of a
// frame that lie in the image, and the steps of the history. Of a weight of 0.9 the three have shares of
// 0.299, 0.332 and 0.369 instead of a third each.
TEST_P(ScalableObscurance, threeRotationsErrAsThreeTimesTheSamples) {
    // Taps darken by at most 5 * 0.6 of the intensity.
    const Values limit = converged(GetParam(), standingIntensity / 3.0, pack());
    for (const auto& [few, many] : fewAndMany) {
        const StandingErrors errors = standingErrors(GetParam(), few, many, limit);
        EXPECT_NEAR(errors.three / errors.whole, 1.0, 0.05) << few;
        EXPECT_NEAR(errors.settled / errors.whole, 1.0, 0.05) << few;
        EXPECT_GT(errors.one / errors.whole, 1.3) << few; // there is something to gain
    }
}

// The control: without the bound of a tap frames of 7 and fewer are black too often.
TEST_P(ScalableObscurance, tapsWithoutABoundErrMoreThanThreeTimesTheSamples) {
    const TextChange change{"passes/scalable_obscurance.hlsl", "min(term, MOST_OF_A_TAP)", "term"};
    const ChangedPack unbounded({&change, 1});
    ASSERT_EQ(unbounded.missing(), "");
    // Of the formula, which reaches 5.
    const Values limit = converged(GetParam(), standingIntensity / 25.0, unbounded.pack());
    const StandingErrors errors = standingErrors(GetParam(), "7", "21", limit, unbounded.pack());
    EXPECT_GT(errors.three / errors.whole, 1.05);
    EXPECT_GT(errors.settled / errors.whole, 1.05);
}

// Mean over 96 frames of a standing history that was black with a full count, against that of its rotations:
// of the worst pixel, and on average over the image.
struct OffTheMean {
    double worst = 0.0, average = 0.0;
};

OffTheMean offTheMean(Stage stage, const reprisec::Pack& from = pack()) {
    Values mean(side * side, 0.0), sum = mean;
    for (int f = 0; f < 3; ++f) {
        const Values each = single(stage, "7", 3, f);
        for (size_t i = 0; i < each.size(); ++i)
            mean[i] += each[i] / 3.0;
    }
    Accumulation accumulation(stage, "7", from);
    auto& first = accumulation.frame();
    first.pass.frame = 0;
    first.pass.historyValid = 1.0;
    first.history = makePixels(rgba8, side, side, [&](int x, int y) {
        const glm::dvec4 digits =
            oracle::packedObscurance({0.0, double{first.depth.at(x, y, 0)}, 15.0}, first.pass.farM);
        return Texel{static_cast<float>(digits.x), static_cast<float>(digits.y), static_cast<float>(digits.z),
                     static_cast<float>(digits.w)};
    });
    for (int i = 0; i < 192; ++i) {
        const Values each = accumulation.next();
        for (size_t p = 0; i >= 96 && p < each.size(); ++p)
            sum[p] += each[p] / 96.0;
    }
    OffTheMean off;
    for (size_t p = 0; p < sum.size(); ++p) {
        off.worst = std::max(off.worst, std::abs(sum[p] - mean[p]));
        off.average += (sum[p] - mean[p]) / static_cast<double>(sum.size());
    }
    return off;
}

// Feedback in few bits: 8 bits stop up to five levels of 1/255 short of the mean, and 12 bits without noise
// up to a third of a level. Each pixel is nearer than a quarter, and the average than a sixteenth, a step of
// the 12 bits.
TEST_P(ScalableObscurance, historyOfEightBitChannelsConvergesToTheMean) {
    const OffTheMean off = offTheMean(GetParam());
    std::printf("mean of the history against that of the frames: worst %.6f, on average %.7f\n", off.worst,
                off.average);
    EXPECT_LT(off.worst, 0.25 / 255.0);
    EXPECT_LT(std::abs(off.average), 1.0 / 4080.0);
}

// The control: as 8 bits come, to the nearest level.
TEST_P(ScalableObscurance, historyOfEightBitsAloneStopsShortOfTheMean) {
    const TextChange change{"reprise/occlusion_depth_packing.hlsli",
                            "float sixteenths = step + 8.0 - 16.0 * level;", "float sixteenths = 8.0;"};
    const ChangedPack coarse({&change, 1});
    ASSERT_EQ(coarse.missing(), "");
    const OffTheMean off = offTheMean(GetParam(), coarse.pack());
    std::printf("8 bits alone: worst %.6f, on average %.7f\n", off.worst, off.average);
    EXPECT_GT(off.worst, 3.0 / 255.0);
    EXPECT_LT(off.average, -1.0 / 255.0); // from black it stops below
}

// Frames until what is left of the difference, over the pixels chosen, is at most a tenth.
template <class Chosen>
int framesToATenth(const std::vector<Values>& frames, const Values& before, const Values& after,
                   Chosen chosen) {
    for (size_t t = 0; t < frames.size(); ++t) {
        double left = 0.0, all = 0.0;
        for (size_t i = 0; i < after.size(); ++i) {
            if (!chosen(i)) continue;
            left += after[i] - frames[t][i];
            all += after[i] - before[i];
        }
        if (left <= 0.1 * all) return static_cast<int>(t) + 1;
    }
    return 1000;
}

Pixels withoutBoxes(const Pixels& boxes) {
    Pixels wall = boxes;
    for (int i = 0; i < side * side; ++i) {
        const int x = i % side, y = i / side;
        if (x / 11 % 3 == 1 && y / 9 % 2 == 1) wall.at(x, y, 0) += 0.4f;
    }
    return wall;
}

// Boxes stand before a wall until a frame. Frames after it to a tenth of the darkness.
struct Trailed {
    int rejected = 0, trailing = 0; // where depth tells, and where it does not
};

Trailed trailedFrames(Accumulation& accumulation, const Pixels& boxes, const Pixels& wall) {
    Values before, after;
    for (int i = 0; i < 60; ++i)
        before = accumulation.next();
    accumulation.frame().depth = wall;
    std::vector<Values> frames;
    for (int i = 0; i < 60; ++i)
        frames.push_back(accumulation.next());
    after.assign(side * side, 0.0); // over whole cycles, when all is settled
    for (int i = 0; i < 30; ++i) {
        const Values each = accumulation.next();
        for (size_t p = 0; p < each.size(); ++p)
            after[p] += each[p] / 30.0;
    }
    const auto depthTells = [&](size_t p) { return wall.values[p] - boxes.values[p] > 0.3f; };
    const auto isShadowed = [&](size_t p) {
        return wall.values[p] == boxes.values[p] && after[p] - before[p] > 0.1;
    };
    return {framesToATenth(frames, before, after,
                           [&](size_t p) { return depthTells(p) && after[p] - before[p] > 0.1; }),
            framesToATenth(frames, before, after, isShadowed)};
}

// "Depth rejection has a problem of information trailing": where boxes stood the depth tells, and the history
// is gone at once. Beside them it tells nothing, and their darkness goes by the weight: 0.9^n is a tenth
// after 22 frames.
TEST_P(ScalableObscurance, darknessOfARemovedOccluderTrailsWhereDepthDoesNotTell) {
    Accumulation accumulation(GetParam(), "7");
    const Pixels boxes = accumulation.frame().depth;
    const Trailed frames = trailedFrames(accumulation, boxes, withoutBoxes(boxes));
    std::printf("frames to a tenth: %d where depth tells, %d where it does not\n", frames.rejected,
                frames.trailing);
    EXPECT_LE(frames.rejected, 3); // the first frame, or the mean of the first rotations
    EXPECT_GE(frames.trailing, 20);
    EXPECT_LE(frames.trailing, 23);
}

// In motion less is trailing: at 0.6, 0.6^n is a tenth after 5 frames; at half the speed from which on that
// holds, 0.75^n after 9. Motions of less than half a pixel find the same texel.
TEST_P(ScalableObscurance, darknessTrailsLessInMotion) {
    const auto framesTrailed = [&](float speedPx) {
        Accumulation accumulation(GetParam(), "7", pack(), "on");
        auto& frame = accumulation.frame();
        frame.pass.motionToUv = {1.0, 1.0};
        frame.pass.toPreviousDepth = {0.0, 0.0, 1.0, 0.0};
        frame.pass.movingWeight = double{0.6f};
        frame.pass.movingPx = 0.25;
        const float along = speedPx / (std::sqrt(2.0f) * static_cast<float>(side));
        frame.velocity = makePixels(rg32f, side, side, [&](int, int) { return Texel{along, along}; });
        const Pixels boxes = frame.depth;
        const Pixels wall = withoutBoxes(boxes);
        return trailedFrames(accumulation, boxes, wall).trailing;
    };
    const int still = framesTrailed(0.0f), slow = framesTrailed(0.125f), moving = framesTrailed(0.4f);
    std::printf("frames to a tenth: %d standing, %d at 0.125 px, %d at 0.4 px\n", still, slow, moving);
    EXPECT_NEAR(still, 22, 1);
    EXPECT_NEAR(slow, 9, 1);
    EXPECT_NEAR(moving, 5, 1);
}

} // namespace
} // namespace passes
