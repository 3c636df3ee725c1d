// SPDX-License-Identifier: Apache-2.0
// sun_shadow executed and held to the oracle.
//
// Bound of a pixel: 1 / N for each sample that roundings may move to another shadow texel, or whose plane
// they may move past what that texel holds (oracle/sun_shadow.hpp).
#include "sun_shadow_case.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float poisons[] = {notANumber, infinity, -infinity, -3.0f, 1e38f};

class SunShadowOracle : public PassTest {};
class SunShadow : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, SunShadow, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> variants() {
    std::vector<Variant> found = committedVariants("sun_shadow");
    found.push_back(variantOf(pack(), "sun_shadow",
                              {{"CASCADES", "4"}, {"ORTHOGRAPHIC", "on"}, {"SHADOW_REVERSED", "on"}}));
    found.push_back(variantOf(pack(), "sun_shadow", {{"CASCADES", "2"}, {"VALUES", "shadow_in_integer"}}));
    found.push_back(variantOf(pack(), "sun_shadow", {{"ORTHOGRAPHIC", "on"}, {"VALUES", "two"}}));
    return found;
}

void expectOracle(Pass& pass, Stage stage, const SunShadowCase& frame) {
    const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
    EXPECT_TRUE(result.holds()) << describe(pass.variant(), stage, frame.depth.width, frame.depth.height)
                                << ", frame " << frame.pass.frame << ": " << text(result);
}

TEST_P(SunShadow, equalsTheOracleAtEverySizeAndInEveryFrame) {
    for (const Variant& variant : variants()) {
        Pass pass(variant, GetParam(), {rg32f});
        for (const Surfaces surfaces : {Surfaces::random, Surfaces::corner})
            for (const auto& [width, height] : sizes)
                for (const int frame : {0, 1, 5})
                    expectOracle(pass, GetParam(),
                                 sunShadowCase(variant, surfaces, width, height, 91, frame));
    }
}

TEST_P(SunShadow, defaultsEqualTheOracleInHalfFloatAtALargeOddSize) {
    const Variant variant = variantOf(pack(), "sun_shadow");
    Pass pass(variant, GetParam());
    expectOracle(pass, GetParam(), sunShadowCase(variant, Surfaces::corner, 641, 359, 92));
}

// A bound as wide as the whole range would let anything pass, and so would a picture all lit.
TEST_F(SunShadowOracle, boundsAreNarrowAndEveryCascadeIsSeen) {
    for (const Surfaces surfaces : {Surfaces::random, Surfaces::corner}) {
        const auto frame =
            sunShadowCase(variantOf(pack(), "sun_shadow", {{"CASCADES", "4"}}), surfaces, 64, 64, 93);
        const oracle::Image depth = oracleImage(frame.depth), map = oracleImage(frame.map);
        oracle::SunShadow pass = frame.pass;
        pass.surface.depth = &depth;
        pass.map = &map;
        double error = 0.0;
        int shadowed[5] = {};
        for (int i = 0; i < 64 * 64; ++i) {
            const oracle::Visibility sun = oracle::sunVisibilityAt(pass, i % 64, i / 64);
            error += sun.error / (64 * 64);
            const double metres = oracle::surfaceDepth(pass.surface, i % 64, i / 64);
            size_t column = 0;
            while (column < 4 && metres > pass.columns[column].farDepth)
                ++column;
            shadowed[column] += sun.value < 0.9;
        }
        EXPECT_LT(error, 0.005);
        for (int column = 0; column < 4; ++column)
            EXPECT_GT(shadowed[column], 50) << column;
        EXPECT_EQ(shadowed[4], 0);
    }
}

// Broken depths are sky; a broken shadow texel, whatever the receiver, is lit where it is NaN.
TEST_P(SunShadow, brokenTexelsAreSkyOrLit) {
    for (const std::string_view reversed : {"off", "on"}) {
        const Variant variant = variantOf(pack(), "sun_shadow", {{"SHADOW_REVERSED", reversed}});
        Pass pass(variant, GetParam(), {rg32f});
        for (const float value : poisons) {
            auto frame = sunShadowCase(variant, Surfaces::corner, 33, 17, 94);
            frame.depth.at(10, 9, 0) = value;
            for (int i = 0; i < 200; ++i)
                frame.map.at(static_cast<int>(hashOf(95, static_cast<uint64_t>(i)) % 144),
                             static_cast<int>(hashOf(96, static_cast<uint64_t>(i)) % 40), 0) = value;
            expectOracle(pass, GetParam(), frame);
            const Pixels clean = frame.depth;
            std::fill(frame.depth.values.begin(), frame.depth.values.end(), value);
            const Pixels sky = run(pass, frame)[0];
            frame.depth = clean;
            std::fill(frame.map.values.begin(), frame.map.values.end(), notANumber);
            const Pixels lit = run(pass, frame)[0];
            for (int i = 0; i < 33 * 17; ++i) {
                ASSERT_EQ(sky.at(i % 33, i / 33, 0), 1.0f) << value;
                ASSERT_EQ(sky.at(i % 33, i / 33, 1), 65504.0f) << value;
                ASSERT_EQ(lit.at(i % 33, i / 33, 0), 1.0f) << value;
            }
        }
    }
}

// Packed with occlusion that is no number, the pair is one all the same.
TEST_P(SunShadow, brokenOcclusionLeavesAPair) {
    for (const std::string_view values : {"occlusion_in_integer", "shadow_in_integer"}) {
        const Variant variant = variantOf(pack(), "sun_shadow", {{"VALUES", values}});
        Pass pass(variant, GetParam(), {rg32f});
        for (const float value : poisons) {
            auto frame = sunShadowCase(variant, Surfaces::corner, 33, 17, 97);
            std::fill(frame.occlusion.values.begin(), frame.occlusion.values.end(), value);
            const Pixels got = run(pass, frame)[0];
            for (int i = 0; i < 33 * 17; ++i) {
                const float packed = got.at(i % 33, i / 33, 0);
                ASSERT_TRUE(packed >= 0.0f && packed < 32.0f) << values << " " << value << ": " << packed;
            }
        }
    }
}

// A plane n p + h = 0 of view space, seen by the camera of a case, and what the light sees of it: depth at
// the centre of each shadow texel, moved towards the light by `over` metres where `isOver`.
void showPlane(SunShadowCase& frame, glm::dvec3 normal, double h, double over,
               const std::function<bool(glm::dvec2 texel)>& isOver) {
    const oracle::SunShadow& pass = frame.pass;
    const oracle::AmbientOcclusion& surface = pass.surface;
    const int width = frame.depth.width, height = frame.depth.height;
    frame.depth = makePixels(r32f, width, height, [&](int x, int y) {
        const glm::dvec2 uv = (glm::dvec2(x, y) + 0.5) / glm::dvec2(width, height);
        const glm::dvec2 ray =
            uv * glm::dvec2(surface.viewRay) + glm::dvec2(surface.viewRay.z, surface.viewRay.w);
        const double along = glm::dot(glm::dvec2(normal), ray);
        return Texel{
            static_cast<float>(surface.orthographic ? -(h + along) / normal.z : -h / (along + normal.z))};
    });
    const int columnWidth = static_cast<int>(pass.columnSize.x);
    frame.map = makePixels(r32f, frame.map.width, frame.map.height, [&](int x, int y) {
        const glm::dmat4& toTexels = pass.columns[static_cast<size_t>(x / columnWidth)].viewToTexels;
        const glm::dmat4 toView = glm::inverse(toTexels);
        const glm::dvec2 texel(x % columnWidth + 0.5, y + 0.5);
        const glm::dvec3 from(toView * glm::dvec4(texel, 0.0, 1.0)), to(toView * glm::dvec4(texel, 1.0, 1.0));
        const double depth = -(glm::dot(normal, from) + h) / glm::dot(normal, to - from);
        const double metres = glm::length(to - from) * (pass.reversed ? -1.0 : 1.0);
        return Texel{static_cast<float>(depth - (isOver(texel) ? over / metres : 0.0))};
    });
}

// The normal of a plane that the camera sees and that is `slope` metres deep a metre across for the light.
glm::dvec3 normalOfSlope(const SunShadowCase& frame, double slope, double turn) {
    const glm::dmat4& toTexels = frame.pass.columns[0].viewToTexels;
    glm::dvec3 axis[3];
    for (int i = 0; i < 3; ++i)
        axis[i] = glm::normalize(oracle::rowOf(toTexels, i)) * (i == 2 && frame.pass.reversed ? -1.0 : 1.0);
    return slope * (std::cos(turn) * axis[0] + std::sin(turn) * axis[1]) - axis[2];
}

double lowest(const Pixels& picture) {
    double least = 2.0;
    for (int i = 0; i < picture.width * picture.height; ++i)
        least = std::min(least, double{picture.at(i % picture.width, i / picture.width, 0)});
    return least;
}

// Pixels that lie in the column of their cascade and in its depth, a thousandth from the ends and more.
int coveredPixels(const SunShadowCase& frame) {
    const oracle::Image depth = oracleImage(frame.depth);
    oracle::AmbientOcclusion surface = frame.pass.surface;
    surface.depth = &depth;
    int covered = 0;
    for (int y = 0; y < frame.depth.height; ++y)
        for (int x = 0; x < frame.depth.width; ++x) {
            const double metres = oracle::surfaceDepth(surface, x, y);
            const auto column = std::ranges::find_if(
                frame.pass.columns, [&](const auto& each) { return metres <= each.farDepth; });
            if (column == frame.pass.columns.end()) continue;
            const glm::dvec3 point = oracle::viewPointOf(surface, glm::dvec2(x, y) + 0.5, metres);
            const glm::dvec3 place(column->viewToTexels * glm::dvec4(point, 1.0));
            covered += glm::all(glm::greaterThan(place, glm::dvec3(1e-3))) &&
                       glm::all(glm::lessThan(place, glm::dvec3(frame.pass.columnSize, 1.0) - 1e-3));
        }
    return covered;
}

// No acne: a plane does not shadow itself at any slope that is followed, with a bias of 2 mm under a disc of
// 25 cm and shadow texels of 13 cm and more. No peter-panning: what lies over it by twice that shadows it.
TEST_P(SunShadow, aPlaneIsLitAndWhatLiesOnItShadowsItWhateverTheSlope) {
    for (const std::string_view reversed : {"off", "on"})
        for (const std::string_view orthographic : {"off", "on"}) {
            const Variant variant =
                variantOf(pack(), "sun_shadow",
                          {{"SAMPLES", "32"}, {"SHADOW_REVERSED", reversed}, {"ORTHOGRAPHIC", orthographic}});
            Pass pass(variant, GetParam(), {rg32f});
            for (const double slope : {0.0, 0.5, 1.5, 4.0})
                for (const double turn : {0.3, 1.9, 3.6, 5.2}) {
                    auto frame = sunShadowCase(variant, Surfaces::corner, 64, 64, 98);
                    frame.pass.bias = {0.002, 0.0};
                    setParameters(frame);
                    const glm::dvec3 normal = normalOfSlope(frame, slope, turn);
                    if (normal.z > -0.3) continue; // seen from behind or along
                    const double h = -3.6 * normal.z;
                    const auto none = [](glm::dvec2) { return false; };
                    showPlane(frame, normal, h, 0.0, none);
                    EXPECT_EQ(lowest(run(pass, frame)[0]), 1.0) << "slope " << slope << " turned " << turn;
                    showPlane(frame, normal, h, 0.004, [](glm::dvec2) { return true; });
                    const Pixels under = run(pass, frame)[0];
                    const int covered = coveredPixels(frame);
                    EXPECT_GT(covered, 50) << "slope " << slope << " turned " << turn;
                    int dark = 0;
                    for (const float value : under.values)
                        dark += value == 0.0f;
                    // The second channel is depth, which is above 0.
                    EXPECT_GE(dark, covered) << "slope " << slope << " turned " << turn;
                }
        }
}

// The columns of others hold what would shadow everything: no sample reads one.
TEST_P(SunShadow, samplesStayInTheColumnOfTheirCascade) {
    for (int own = 0; own < 3; ++own) {
        const Variant variant = variantOf(pack(), "sun_shadow", {{"SAMPLES", "32"}});
        Pass pass(variant, GetParam(), {rg32f});
        auto frame = sunShadowCase(variant, Surfaces::corner, 64, 64, 99);
        frame.pass.leastTexels = 30.0; // most of the column
        for (int i = 0; i < 3; ++i)
            frame.cascades[static_cast<size_t>(i)].farDepth = i < own ? 0.01 * (i + 1) : 100.0 + i;
        setParameters(frame);
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 144; ++x)
                frame.map.at(x, y, 0) = x / 48 == own ? 1.0f : 0.0f;
        EXPECT_EQ(lowest(run(pass, frame)[0]), 1.0) << own;
        for (float& value : frame.map.values)
            value = 1.0f - value;
        EXPECT_EQ(lowest(run(pass, frame)[0]), 0.0) << own << ": the samples read nothing of their own";
    }
}

// --- The pattern

// A map that is dark on one side of a line; over it a plane that faces the light.
SunShadowCase edgeCase(const Variant& variant, int frame, int subsets, double turn) {
    auto made = sunShadowCase(variant, Surfaces::corner, 64, 64, 100, frame);
    made.pass.subsets = subsets;
    made.pass.radius = 0.0;
    made.pass.leastTexels = 6.0; // so that the disc holds a hundred texels
    setParameters(made);
    const glm::dvec3 normal = normalOfSlope(made, 0.0, 0.0);
    const glm::dvec2 across(std::cos(turn), std::sin(turn));
    showPlane(made, normal, -3.6 * normal.z, 1.0,
              [&](glm::dvec2 texel) { return glm::dot(texel - glm::dvec2(24.0, 20.0), across) < 0.0; });
    return made;
}

std::vector<double> meanOfCycle(Stage stage, std::string_view samples, int frames, double turn) {
    const Variant variant = variantOf(pack(), "sun_shadow", {{"SAMPLES", samples}});
    Pass pass(variant, stage, {rg32f});
    std::vector<double> mean(64 * 64, 0.0);
    for (int frame = 0; frame < frames; ++frame) {
        const Pixels got = run(pass, edgeCase(variant, frame, frames, turn))[0];
        for (int i = 0; i < 64 * 64; ++i)
            mean[static_cast<size_t>(i)] += double{got.at(i % 64, i / 64, 0)} / frames;
    }
    return mean;
}

// Root of the mean square error over that of as many independent samples, sqrt(p (1 - p) / count).
double relativeError(const std::vector<double>& values, const std::vector<double>& converged, double count) {
    double square = 0.0, independent = 0.0;
    for (size_t i = 0; i < values.size(); ++i) {
        square += (values[i] - converged[i]) * (values[i] - converged[i]);
        independent += converged[i] * (1.0 - converged[i]) / count;
    }
    return std::sqrt(square / independent);
}

// "A well-distributed sample set": a frame's samples err less than independent ones, and those of a whole
// cycle less still.
TEST_P(SunShadow, patternsAreSpreadEvenlyInAFrameAndOverTheCycle) {
    double frame = 0.0, cycle = 0.0;
    for (const double turn : {0.4, 1.3, 2.2, 3.9}) {
        const auto converged = meanOfCycle(GetParam(), "32", 16, turn);
        frame += relativeError(meanOfCycle(GetParam(), "4", 1, turn), converged, 4.0) / 4.0;
        cycle += relativeError(meanOfCycle(GetParam(), "4", 4, turn), converged, 16.0) / 4.0;
    }
    // Independent samples are 1.
    EXPECT_LT(frame, 0.85);
    EXPECT_LT(cycle, 0.75);
    std::printf("of independent samples' error: %.3f in a frame, %.3f in a cycle\n", frame, cycle);
}

TEST_P(SunShadow, thePatternChangesEachFrameAndRepeatsAfterTheCycle) {
    const Variant variant = variantOf(pack(), "sun_shadow");
    Pass pass(variant, GetParam(), {rg32f});
    std::set<std::vector<float>> seen;
    std::vector<std::vector<float>> frames;
    for (int frame = 0; frame < 6; ++frame) {
        frames.push_back(run(pass, sunShadowCase(variant, Surfaces::corner, 64, 64, 101, frame))[0].values);
        seen.insert(frames.back());
    }
    EXPECT_EQ(seen.size(), 3u); // the case's cycle is of three
    for (size_t frame = 0; frame < 3; ++frame)
        EXPECT_EQ(frames[frame], frames[frame + 3]) << frame;
}

// --- The parameters

TEST(SunShadowParameters, refuseWhatIsNoCascadedShadowMap) {
    const Variant variant = variantOf(pack(), "sun_shadow");
    const SunShadowCase good = sunShadowCase(variant, Surfaces::corner, 8, 8, 102);
    const auto sentence = [&](std::vector<reprise::ShadowCascade> cascades, uint32_t width, uint32_t height) {
        const auto made = reprise::sunShadowParameters(good.camera, {1.0, 1.0}, cascades, width, height);
        return made ? std::string() : made.error().message;
    };
    EXPECT_EQ(sentence(good.cascades, 144, 40), "");
    EXPECT_NE(sentence({}, 144, 40), "");
    EXPECT_NE(sentence(std::vector(5, good.cascades[0]), 145, 40), "");
    EXPECT_NE(sentence(good.cascades, 0, 40), "");
    EXPECT_NE(sentence(good.cascades, 145, 40), "");
    auto cascades = good.cascades;
    std::swap(cascades[0].farDepth, cascades[1].farDepth);
    EXPECT_NE(sentence(cascades, 144, 40), "") << "far depths descend";
    cascades = good.cascades;
    cascades[1].worldToClip[2][3] = 1.0;
    EXPECT_NE(sentence(cascades, 144, 40), "") << "a perspective light";
    cascades = good.cascades;
    cascades[2].worldToClip = cascades[2].worldToClip * viewOf({0.0, 0.0, 0.0}, {0.1, 0.0, 0.0});
    EXPECT_NE(sentence(cascades, 144, 40), "") << "a turned cascade";
    cascades = good.cascades;
    cascades[0].worldToClip[0][0] = std::nan("");
    EXPECT_NE(sentence(cascades, 144, 40), "") << "a matrix that is none";
}

} // namespace
} // namespace passes
