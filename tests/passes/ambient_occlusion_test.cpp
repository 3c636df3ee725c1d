// SPDX-License-Identifier: Apache-2.0
// ambient_occlusion executed and held to the oracle.
//
// Bound of a pixel: how far roundings may move the points that it checks, and what that changes (Visibility
// in oracle/ambient_occlusion.hpp). A check beside the edge of a texel may read either; that is at most 1 /
// N.
#include "ambient_occlusion_case.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace passes {
namespace {

constexpr std::pair<int, int> sizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float poisons[] = {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -3.0f, 1e38f};

class OcclusionOracle : public PassTest {};
class AmbientOcclusion : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, AmbientOcclusion, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

std::vector<Variant> variants() {
    std::vector<Variant> found = committedVariants("ambient_occlusion");
    found.push_back(variantOf(pack(), "ambient_occlusion", {{"NORMALS", "read"}, {"ORTHOGRAPHIC", "on"}}));
    return found;
}

void expectOracle(Pass& pass, Stage stage, const AmbientOcclusionCase& frame) {
    const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
    EXPECT_TRUE(result.holds()) << describe(pass.variant(), stage, frame.depth.width, frame.depth.height)
                                << ", frame " << frame.pass.frame << ": " << text(result);
}

TEST_P(AmbientOcclusion, equalsTheOracleAtEverySizeAndInEveryFrame) {
    for (const Variant& variant : variants()) {
        Pass pass(variant, GetParam(), {rg32f});
        for (const Surfaces surfaces : {Surfaces::random, Surfaces::corner})
            for (const auto& [width, height] : sizes)
                for (const int frame : {0, 1, 5})
                    expectOracle(pass, GetParam(),
                                 ambientOcclusionCase(variant, surfaces, width, height, 81, frame));
    }
}

TEST_P(AmbientOcclusion, defaultsEqualTheOracleInHalfFloatAtALargeOddSize) {
    const Variant variant = variantOf(pack(), "ambient_occlusion");
    Pass pass(variant, GetParam());
    expectOracle(pass, GetParam(), ambientOcclusionCase(variant, Surfaces::corner, 641, 359, 82));
}

// Of every ratio and of odd frames the normal is that of one pixel under the texel, which all differ in.
TEST_P(AmbientOcclusion, normalsOfTheFrameEqualTheOracleAtEveryRatio) {
    for (const std::string_view orthographic : {"off", "on"}) {
        const Variant variant =
            variantOf(pack(), "ambient_occlusion", {{"NORMALS", "read"}, {"ORTHOGRAPHIC", orthographic}});
        Pass pass(variant, GetParam(), {rg32f});
        for (const int ratio : {1, 2, 4})
            for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {7, 5}, {64, 64}, {321, 180}}) {
                auto frame = ambientOcclusionCase(variant, Surfaces::corner, width, height, 88);
                setRatio(frame, ratio, 88);
                expectOracle(pass, GetParam(), frame);
            }
    }
}

// A bound as wide as the whole range would let anything pass.
TEST_F(OcclusionOracle, boundsAreNarrow) {
    const auto frame =
        ambientOcclusionCase(variantOf(pack(), "ambient_occlusion"), Surfaces::corner, 64, 64, 83);
    const oracle::Image depth = oracleImage(frame.depth);
    oracle::AmbientOcclusion pass = frame.pass;
    pass.depth = &depth;
    double sum = 0.0, occluded = 0.0;
    for (int i = 0; i < 64 * 64; ++i) {
        const oracle::Visibility visibility = oracle::visibilityAt(pass, i % 64, i / 64);
        sum += visibility.error;
        occluded += visibility.value < 0.9;
    }
    EXPECT_LT(sum / (64 * 64), 0.005);
    EXPECT_GT(occluded, 200.0); // of the card and of what it stands before
}

// Broken depths count as sky, broken normals as facing the camera: the oracle says what every pixel that may
// see one shows, and that no other changes.
TEST_P(AmbientOcclusion, brokenTexelsAreSkyOrFaceTheCamera) {
    for (const std::string_view normals : {"reconstructed", "read"}) {
        const Variant variant = variantOf(pack(), "ambient_occlusion", {{"NORMALS", normals}});
        Pass pass(variant, GetParam(), {rg32f});
        for (const float value : poisons) {
            auto frame = ambientOcclusionCase(variant, Surfaces::corner, 33, 17, 84);
            frame.depth.at(10, 9, 0) = value;
            for (int c = 0; c < 3 && value != 1e38f; ++c)
                frame.normal.at(2 * 20, 2 * 8, c) = value == -3.0f ? 0.0f : value;
            expectOracle(pass, GetParam(), frame);
            std::fill(frame.depth.values.begin(), frame.depth.values.end(), value);
            const Pixels sky = run(pass, frame)[0];
            for (int i = 0; i < 33 * 17; ++i) {
                ASSERT_EQ(sky.at(i % 33, i / 33, 0), 1.0f) << value;
                ASSERT_EQ(sky.at(i % 33, i / 33, 1), 65504.0f) << value;
            }
        }
    }
}

// Nothing stands over a plane, whatever its tilt.
TEST_P(AmbientOcclusion, planesAreOpen) {
    const Variant variant = variantOf(pack(), "ambient_occlusion", {{"SAMPLES", "32"}});
    Pass pass(variant, GetParam(), {rg32f});
    auto frame = ambientOcclusionCase(variant, Surfaces::corner, 64, 64, 85);
    const glm::dvec4 ray = frame.pass.viewRay;
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.4, 0.3, -1.0));
    frame.depth = makePixels(r32f, 64, 64, [&](int x, int y) {
        const glm::dvec2 xy =
            (glm::dvec2(x, y) + 0.5) / 64.0 * glm::dvec2(ray.x, ray.y) + glm::dvec2(ray.z, ray.w);
        return Texel{static_cast<float>(-5.0 / glm::dot(normal, glm::dvec3(xy, 1.0)))};
    });
    // The slope over a texel: a point is checked against its texel's depth, half a texel away.
    frame.pass.bias = {0.2, 0.0};
    setParameters(frame);
    const Pixels open = run(pass, frame)[0];
    for (int i = 0; i < 64 * 64; ++i)
        ASSERT_EQ(open.at(i % 64, i / 64, 0), 1.0f) << i % 64 << ", " << i / 64;
}

double rms(const std::vector<double>& values, const std::vector<double>& reference) {
    double sum = 0.0;
    for (size_t i = 0; i < values.size(); ++i)
        sum += (values[i] - reference[i]) * (values[i] - reference[i]);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Mean visibility of `frames` frames of a cycle of as many.
std::vector<double> meanOfCycle(Stage stage, std::string_view samples, int frames) {
    const Variant variant = variantOf(pack(), "ambient_occlusion", {{"SAMPLES", samples}});
    Pass pass(variant, stage, {rg32f});
    std::vector<double> mean(64 * 64, 0.0);
    for (int frame = 0; frame < frames; ++frame) {
        auto each = ambientOcclusionCase(variant, Surfaces::corner, 64, 64, 86, frame);
        each.pass.subsets = frames;
        setParameters(each);
        const Pixels got = run(pass, each)[0];
        for (int i = 0; i < 64 * 64; ++i)
            mean[static_cast<size_t>(i)] += double{got.at(i % 64, i / 64, 0)} / frames;
    }
    return mean;
}

// What as many independent checks, each right or wrong, would err by: sqrt(p (1 - p) / count).
double independentError(const std::vector<double>& visibility, double count) {
    double sum = 0.0;
    for (const double p : visibility)
        sum += p * (1.0 - p) / count;
    return std::sqrt(sum / static_cast<double>(visibility.size()));
}

// "We took care to generate a uniformly distributed pattern": a frame's samples err less than independent
// ones, and those of a whole cycle less still in relation.
TEST_P(AmbientOcclusion, patternsAreSpreadEvenlyInAFrameAndOverTheCycle) {
    const auto converged = meanOfCycle(GetParam(), "32", 16);
    const double frame = rms(meanOfCycle(GetParam(), "4", 1), converged) / independentError(converged, 4.0);
    const double cycle = rms(meanOfCycle(GetParam(), "4", 4), converged) / independentError(converged, 16.0);
    EXPECT_LT(frame, 0.9);
    EXPECT_LT(cycle, 0.9);
    std::printf("of independent samples' error: %.3f in a frame, %.3f in a cycle\n", frame, cycle);
}

TEST_P(AmbientOcclusion, thePatternChangesEachFrameAndRepeatsAfterTheCycle) {
    const Variant variant = variantOf(pack(), "ambient_occlusion");
    Pass pass(variant, GetParam(), {rg32f});
    std::set<std::vector<float>> seen;
    std::vector<std::vector<float>> frames;
    for (int frame = 0; frame < 6; ++frame) {
        frames.push_back(
            run(pass, ambientOcclusionCase(variant, Surfaces::corner, 64, 64, 87, frame))[0].values);
        seen.insert(frames.back());
    }
    EXPECT_EQ(seen.size(), 3u); // the case's cycle is of three
    for (size_t frame = 0; frame < 3; ++frame)
        EXPECT_EQ(frames[frame], frames[frame + 3]) << frame;
}

} // namespace
} // namespace passes
