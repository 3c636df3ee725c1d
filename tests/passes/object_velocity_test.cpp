// SPDX-License-Identifier: Apache-2.0
// object_velocity, drawn by the recorder over camera_velocity and held to the oracle pixel by pixel.
#include "object_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

class ObjectVelocity : public PassTest, public testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(Skinning, ObjectVelocity, testing::Bool(),
                         [](const auto& each) { return each.param ? "skinned" : "rigid"; });

void expectOracle(const ObjectCase& object) {
    const Comparison result = compareWithOracle(object, recordedMotion(object));
    EXPECT_TRUE(result.holds()) << (object.skinned ? "skinned, " : "rigid, ") << text(object.kind) << ", "
                                << stageText(object.stage) << ", " << object.width << "x" << object.height
                                << ": " << text(result);
}

TEST_P(ObjectVelocity, equalsTheOracleForEveryCameraKind) {
    for (const CameraKind& kind : cameraKinds) {
        ObjectCase object{.skinned = GetParam(), .kind = kind};
        expectOracle(object);
        object.jitterPx = {0.0, 0.0};
        expectOracle(object);
    }
}

TEST_P(ObjectVelocity, equalsTheOracleAtEverySize) {
    for (const Stage stage : {Stage::fragment, Stage::compute})
        for (const auto& [width, height] : {std::pair(1, 1), {2, 2}, {7, 5}, {64, 64}, {641, 359}})
            expectOracle(
                {.skinned = GetParam(), .stage = stage, .kind = {}, .width = width, .height = height});
}

TEST_P(ObjectVelocity, whatIsBehindTheSceneLeavesTheCamerasMotion) {
    for (const CameraKind& kind : cameraKinds)
        expectOracle({.skinned = GetParam(), .kind = kind, .occludedColumns = 30});
}

// --- A broken placement

constexpr float brokenValues[] = {std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::infinity(),
                                  -std::numeric_limits<float>::infinity(), 1e38f};

// The first motion that is no number, in words; empty if there is none.
std::string firstNotFinite(const Pixels& motion) {
    for (size_t i = 0; i < motion.values.size(); ++i)
        if (!std::isfinite(motion.values[i])) return "texel " + std::to_string(i / 2);
    return {};
}

// Where it was is unknown: what is seen of it came from outside of the image, which rejects its history, and
// nothing else changes. Divided as it comes it is NaN. 1e38 may come to lie anywhere.
TEST_P(ObjectVelocity, whatWasAtNoPlaceCameFromOutside) {
    for (const CameraKind& kind : cameraKinds)
        for (const float value : brokenValues) {
            const ObjectCase sound{.skinned = GetParam(), .kind = kind};
            ObjectCase broken = sound;
            broken.brokenPrevPlacement = value;
            const Pixels expected = recordedMotion(sound), motion = recordedMotion(broken),
                         background = backgroundMotion(sound, rg32f);
            EXPECT_EQ(firstNotFinite(motion), "") << text(kind) << ", " << value;
            size_t seen = 0;
            for (int i = 0; i < sound.width * sound.height; ++i) {
                const int x = i % sound.width, y = i / sound.width;
                const auto apart = [&](const Pixels& other, int c) {
                    return std::abs(motion.at(x, y, c) - other.at(x, y, c));
                };
                if (apart(expected, 0) == 0.0f && apart(expected, 1) == 0.0f) {
                    // 1e-3: a step of binary16 at motions below 1.
                    EXPECT_LT(std::max(apart(background, 0), apart(background, 1)), 1e-3f)
                        << text(kind) << ", " << value << " at " << x << ", " << y;
                    continue;
                }
                ++seen;
                const bool isFinite = std::isfinite(value);
                const bool isOutside =
                    std::abs(motion.at(x, y, 0)) > 1.0f && std::abs(motion.at(x, y, 1)) > 1.0f;
                EXPECT_TRUE(isFinite || isOutside) << text(kind) << ", " << value << " at " << x << ", " << y;
            }
            EXPECT_GT(seen, 60u) << text(kind) << ", " << value; // the orthographic camera sees 65
        }
}

} // namespace
} // namespace passes
