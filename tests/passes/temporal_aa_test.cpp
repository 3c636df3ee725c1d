// SPDX-License-Identifier: Apache-2.0
// temporal_aa executed and held to the oracle, pixel by pixel.
//
// Bounds: the store to the output's format (storeError) and, where that does not suffice, what the pixel's
// own conditioning makes of float32 roundings and of the filter's weights (oracle::Disturbance). A float32
// output has next to no error of its own, so that a constant wrong in its sixth digit is seen. Of
// MOTION_CAMERA motion errs by what float32 makes of the reprojection too (motionBound).
#include "temporal_aa_case.hpp"

namespace passes {
namespace {

struct Size {
    int width, height;
};
constexpr Size smallSizes[] = {{1, 1}, {2, 2}, {7, 5}, {64, 64}};
constexpr Size largeSize{641, 359};

void expectOracle(Pass& pass, Stage stage, const TemporalAaFrame& frame) {
    const Comparison result = compareWithOracle(pass.variant(), frame, run(pass, frame));
    EXPECT_TRUE(result.holds()) << describe(pass.variant(), stage, frame.width(), frame.height()) << ": "
                                << text(result);
}

std::vector<VkFormat> float32Outputs(const Variant& variant) {
    std::vector<VkFormat> formats;
    for (const auto& output : variant.pass->outputs)
        if (reprise::exists(variant, output)) formats.push_back(rgba32f);
    return formats;
}

class LinearFilter : public PassTest {};
class TemporalAa : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, TemporalAa, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

TEST_P(TemporalAa, committedVariantsEqualTheOracleAtSmallSizes) {
    for (const Variant& variant : committedVariants("temporal_aa")) {
        if (reprise::forStage(variant, GetParam()).values != variant.values)
            continue; // the same as another one
        Pass pass(variant, GetParam(), float32Outputs(variant));
        for (const Size size : smallSizes)
            expectOracle(pass, GetParam(), randomFrame(size.width, size.height, 1));
    }
}

TEST_P(TemporalAa, randomCombinationsOfSwitchesEqualTheOracle) {
    for (const Variant& variant : randomVariants("temporal_aa", 20, 20160314)) {
        Pass pass(variant, GetParam(), float32Outputs(variant));
        expectOracle(pass, GetParam(), randomFrame(64, 64, 2));
        expectOracle(pass, GetParam(), randomFrame(7, 5, 3, Contrast::extreme));
        expectOracle(pass, GetParam(), randomFrame(39, 37, 6, Contrast::saturated));
    }
}

TEST_P(TemporalAa, presetsEqualTheOracleInHalfFloat) {
    for (const auto& preset : pack().presets("temporal_aa")) {
        Pass pass(*pack().preset("temporal_aa", preset.name), GetParam());
        expectOracle(pass, GetParam(), randomFrame(64, 64, 4, Contrast::extreme));
        expectOracle(pass, GetParam(), randomFrame(largeSize.width, largeSize.height, 5));
    }
}

// --- MOTION camera

using Switches = std::vector<reprise::Condition>;

Variant cameraVariant(Switches more, bool reversed, std::string_view motion = "camera") {
    more.push_back({"MOTION", motion});
    more.push_back({"DEPTH_REVERSED", reversed ? "on" : "off"});
    return variantOf(pack(), "temporal_aa", more);
}

std::vector<CameraKind> kindsOfDepth(bool reversed) {
    std::vector<CameraKind> kinds;
    for (const CameraKind& kind : cameraKinds)
        if ((kind.depth != Depth::standard) == reversed) kinds.push_back(kind);
    return kinds;
}

// Pixel alone (in compute a column) and shared, each with the closest fragment's motion and the pixel's own,
// with 3x3 and four taps.
TEST_P(TemporalAa, cameraMotionEqualsTheOracleForEveryCamera) {
    std::vector<Switches> ways;
    for (const std::string_view sharing : {"off", "on"})
        for (const std::string_view closest : {"off", "on"})
            for (const std::string_view neighbourhood : {"rounded", "four_tap"})
                ways.push_back({{"QUAD_SHARING", sharing},
                                {"CLOSEST_FRAGMENT", closest},
                                {"NEIGHBOURHOOD", neighbourhood}});
    for (const Switches& way : ways)
        for (const bool reversed : {false, true}) {
            const Variant variant = cameraVariant(way, reversed);
            Pass pass(variant, GetParam(), float32Outputs(variant));
            for (const CameraKind& kind : kindsOfDepth(reversed)) {
                SCOPED_TRACE(text(kind));
                for (const Size size : smallSizes)
                    expectOracle(pass, GetParam(), cameraFrame(kind, size.width, size.height, 6));
            }
        }
}

TEST_P(TemporalAa, cameraMotionOfThePresetsEqualsTheOracleInHalfFloat) {
    for (const auto& preset : pack().presets("temporal_aa"))
        for (const bool reversed : {false, true}) {
            Pass pass(cameraVariant({preset.switches.begin(), preset.switches.end()}, reversed), GetParam());
            for (const CameraKind& kind : kindsOfDepth(reversed)) {
                SCOPED_TRACE(text(kind));
                expectOracle(pass, GetParam(), cameraFrame(kind, largeSize.width, largeSize.height, 7));
            }
        }
}

// Where the previous camera looked the other way there is no history: the current colour comes back.
TEST_P(TemporalAa, surfacesBehindThePreviousCameraHaveNoHistory) {
    const Variant variant = cameraVariant({{"CLOSEST_FRAGMENT", "off"}, {"UNJITTER", "off"}}, false);
    Pass pass(variant, GetParam(), float32Outputs(variant));
    const TemporalAaFrame frame = cameraFrame({}, 64, 64, 8, true);
    const Pixels history = run(pass, frame)[0];
    int behind = 0;
    for (int i = 0; i < 64 * 64; ++i) {
        const int x = i % 64, y = i / 64;
        if (motionOf(variant, frame, x, y).x < 4.0) continue;
        ++behind;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(history.at(x, y, c), frame.colour.at(x, y, c), 0x1p-22 * frame.colour.at(x, y, c))
                << x << ", " << y; // to the working space and back
    }
    EXPECT_GT(behind, 4000); // of 4096
}

// The same as the two passes one after the other, but that their image of motion has 16 bits. The bound is
// what that rounding, on top of float32's, moves the result by.
TEST_P(TemporalAa, cameraMotionAgreesWithTheVectorsOfCameraVelocity) {
    Pass velocity(variantOf(pack(), "camera_velocity"), GetParam(), {rg16f});
    for (const std::string_view sharing : {"off", "on"})
        for (const bool reversed : {false, true}) {
            const Variant own = cameraVariant({{"QUAD_SHARING", sharing}}, reversed),
                          given = cameraVariant({{"QUAD_SHARING", sharing}}, reversed, "vectors");
            Pass reprojecting(own, GetParam(), float32Outputs(own));
            Pass following(given, GetParam(), float32Outputs(given));
            for (const CameraKind& kind : kindsOfDepth(reversed)) {
                TemporalAaFrame frame = cameraFrame(kind, 64, 64, 9);
                CameraCase camera{.pass = frame.camera, .depth = frame.depth};
                setParameters(camera);
                frame.velocity = run(velocity, camera)[0];
                const Comparison result =
                    compareWithVectors(own, frame, run(reprojecting, frame), run(following, frame));
                EXPECT_TRUE(result.holds())
                    << describe(own, GetParam(), 64, 64) << ", " << text(kind) << ": " << text(result);
            }
        }
}

TEST_F(LinearFilter, weightsHaveAtLeastTheBitsThatHistoryNeeds) {
    // Vulkan's least is 4 bits; below 8 a history of sub-pixel motion would drift visibly.
    EXPECT_LE(linearFilterError(), 0x1p-8);
    RecordProperty("error", std::to_string(linearFilterError()));
}

} // namespace
} // namespace passes
