// SPDX-License-Identifier: Apache-2.0
// camera_velocity executed and held to the oracle.
//
// Bounds: the store to the output's format, and float32 roundings of the matrix product and the division,
// relative to the terms that are summed (motionBound in camera_case.cpp).
#include "camera_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

Variant variantFor(const CameraKind& kind, bool depthLinear) {
    return variantOf(pack(), "camera_velocity",
                     {{"DEPTH_LINEAR", depthLinear ? "on" : "off"},
                      {"ORTHOGRAPHIC", kind.projection == Projection::orthographic ? "on" : "off"}});
}

class CameraVelocity : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, CameraVelocity, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

TEST_P(CameraVelocity, equalsTheOracleAtEverySize) {
    for (const CameraKind& kind : cameraKinds) {
        for (const bool depthLinear : {false, true}) {
            const Variant variant = variantFor(kind, depthLinear);
            for (const VkFormat format : {rg32f, rg16f}) {
                Pass pass(variant, GetParam(), {format});
                for (const auto& [width, height] : {std::pair(1, 1), {2, 2}, {7, 5}, {64, 64}, {641, 359}}) {
                    const CameraCase frame = randomCameraCase(kind, depthLinear, width, height, 21);
                    const Comparison result = compareWithOracle(frame, run(pass, frame)[0]);
                    EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), width, height) << ", "
                                                << text(kind) << ": " << text(result);
                }
            }
        }
    }
}

// The orthographic form has parallel rays: what stands for perspective there is the switch alone.
TEST_P(CameraVelocity, surfacesBehindThePreviousCameraLeaveTheImage) {
    for (const bool depthLinear : {false, true}) {
        const Variant variant = variantFor(cameraKinds[0], depthLinear);
        Pass pass(variant, GetParam(), {rg32f});
        const CameraCase frame = randomCameraCase(cameraKinds[0], depthLinear, 64, 64, 22, true);
        const Pixels velocity = run(pass, frame)[0];
        const Comparison result = compareWithOracle(frame, velocity);
        EXPECT_TRUE(result.holds()) << describe(variant, GetParam(), 64, 64) << ": " << text(result);
        int outside = 0;
        for (int i = 0; i < 64 * 64; ++i)
            outside += velocity.at(i % 64, i / 64, 0) > 4.0f;
        EXPECT_GT(outside, 400); // a third of the view is behind the other camera
    }
}

TEST_P(CameraVelocity, brokenDepthReachesItsOwnPixelAlone) {
    for (const bool depthLinear : {false, true}) {
        const Variant variant = variantFor(cameraKinds[0], depthLinear);
        Pass pass(variant, GetParam(), {rg16f});
        const CameraCase clean = randomCameraCase(cameraKinds[0], depthLinear, 16, 16, 23);
        const Pixels expected = run(pass, clean)[0];
        const float infinity = std::numeric_limits<float>::infinity();
        for (const float value : {std::nanf(""), infinity, -infinity, -1.0f, 1e38f, -1e38f}) {
            CameraCase poisoned = clean;
            poisoned.depth.at(6, 9, 0) = value;
            const Pixels got = run(pass, poisoned)[0];
            for (int i = 0; i < 16 * 16; ++i) {
                const int x = i % 16, y = i / 16;
                for (int c = 0; c < 2; ++c) {
                    if (x == 6 && y == 9)
                        EXPECT_TRUE(std::isfinite(got.at(x, y, c))) << value;
                    else
                        EXPECT_EQ(got.at(x, y, c), expected.at(x, y, c)) << value << " at " << x << ", " << y;
                }
            }
        }
    }
}

// A depth of nothing but poison, as an engine's cleared or broken target may be.
TEST_P(CameraVelocity, wholeBrokenDepthGivesFiniteMotion) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const bool depthLinear : {false, true}) {
        Pass pass(variantFor(cameraKinds[0], depthLinear), GetParam(), {rg16f});
        CameraCase frame = randomCameraCase(cameraKinds[0], depthLinear, 16, 16, 24);
        for (const float value : {std::nanf(""), infinity, -infinity, -1.0f, 0.0f, 1e38f, -1e38f}) {
            std::fill(frame.depth.values.begin(), frame.depth.values.end(), value);
            const Pixels velocity = run(pass, frame)[0];
            for (const float motion : velocity.values)
                ASSERT_TRUE(std::isfinite(motion) && std::abs(motion) <= 9.5f) << value << " gave " << motion;
        }
    }
}

} // namespace
} // namespace passes
