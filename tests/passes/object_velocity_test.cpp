// SPDX-License-Identifier: Apache-2.0
// object_velocity, drawn by the recorder over camera_velocity and held to the oracle pixel by pixel.
#include "object_case.hpp"

namespace passes {
namespace {

class ObjectVelocity : public PassTest, public testing::WithParamInterface<bool> {};
INSTANTIATE_TEST_SUITE_P(Skinning, ObjectVelocity, testing::Bool(),
                         [](const auto& each) { return each.param ? "skinned" : "rigid"; });

constexpr CameraKind kinds[] = {{Depth::standard, Projection::perspective},
                                {Depth::reversed, Projection::perspective},
                                {Depth::reversedInfinite, Projection::perspective},
                                {Depth::standard, Projection::orthographic},
                                {Depth::reversed, Projection::orthographic}};

void expectOracle(const ObjectCase& object) {
    const Comparison result = compareWithOracle(object, recordedMotion(object));
    EXPECT_TRUE(result.holds()) << (object.skinned ? "skinned, " : "rigid, ") << text(object.kind) << ", "
                                << stageText(object.stage) << ", " << object.width << "x" << object.height
                                << ": " << text(result);
}

TEST_P(ObjectVelocity, equalsTheOracleForEveryCameraKind) {
    for (const CameraKind& kind : kinds) {
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
    for (const CameraKind& kind : kinds)
        expectOracle({.skinned = GetParam(), .kind = kind, .occludedColumns = 30});
}

} // namespace
} // namespace passes
