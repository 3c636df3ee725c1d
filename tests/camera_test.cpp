// SPDX-License-Identifier: Apache-2.0
// The camera's numbers against closed forms in long double, for every depth kind and both projections.
#include "reprise/camera.hpp"

#include <array>
#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace {

using namespace reprise;
using Real = long double;

enum class Kind { standard, reversed, reversedInfinite, orthographic, orthographicReversed };
constexpr Kind kinds[] = {Kind::standard, Kind::reversed, Kind::reversedInfinite, Kind::orthographic,
                          Kind::orthographicReversed};
constexpr Real nearPlane = 0.1L, farPlane = 200.0L, scaleX = 1.3L, scaleY = 2.1L, shiftX = 0.07L,
               shiftY = -0.04L;

bool orthographic(Kind kind) {
    return kind == Kind::orthographic || kind == Kind::orthographicReversed;
}

// Clip z is depthScale * z + depthOffset.
struct DepthMap {
    Real scale, offset;
};
DepthMap depthMap(Kind kind) {
    const Real range = farPlane - nearPlane;
    switch (kind) {
    case Kind::standard:
        return {farPlane / range, -farPlane * nearPlane / range};
    case Kind::reversed:
        return {-nearPlane / range, farPlane * nearPlane / range};
    case Kind::reversedInfinite:
        return {0.0L, nearPlane};
    case Kind::orthographic:
        return {1.0L / range, -nearPlane / range};
    case Kind::orthographicReversed:
        return {-1.0L / range, farPlane / range};
    }
    return {};
}

// Off-centre by shift, so that no term can be forgotten.
glm::dmat4 projectionOf(Kind kind) {
    glm::dmat4 m(0.0);
    m[0][0] = static_cast<double>(scaleX);
    m[1][1] = static_cast<double>(scaleY);
    m[2][2] = static_cast<double>(depthMap(kind).scale);
    m[3][2] = static_cast<double>(depthMap(kind).offset);
    const int column = orthographic(kind) ? 3 : 2;
    m[column][0] = static_cast<double>(shiftX);
    m[column][1] = static_cast<double>(shiftY);
    m[column][3] = 1.0;
    return m;
}

struct Point {
    Real x, y, z;
};

struct Projected {
    Real ndcX, ndcY, depth, w;
};

Projected project(Kind kind, Point p) {
    const Real w = orthographic(kind) ? 1.0L : p.z;
    const Real shiftScale = orthographic(kind) ? 1.0L : p.z;
    return {(scaleX * p.x + shiftX * shiftScale) / w, (scaleY * p.y + shiftY * shiftScale) / w,
            (depthMap(kind).scale * p.z + depthMap(kind).offset) / w, w};
}

// A camera at `eye`, turned by `angle` about y; both directions in closed form.
struct Pose {
    Real angle;
    Point eye;
};

glm::dmat4 worldToView(const Pose& pose) {
    const double c = std::cos(static_cast<double>(pose.angle)), s = std::sin(static_cast<double>(pose.angle));
    const double x = static_cast<double>(pose.eye.x), y = static_cast<double>(pose.eye.y),
                 z = static_cast<double>(pose.eye.z);
    glm::dmat4 m(1.0);
    m[0] = {c, 0.0, s, 0.0};
    m[2] = {-s, 0.0, c, 0.0};
    m[3] = {-c * x + s * z, -y, -s * x - c * z, 1.0};
    return m;
}

Point toView(const Pose& pose, Point p) {
    const Real c = std::cos(pose.angle), s = std::sin(pose.angle);
    const Point d{p.x - pose.eye.x, p.y - pose.eye.y, p.z - pose.eye.z};
    return {c * d.x - s * d.z, d.y, s * d.x + c * d.z};
}

Point toWorld(const Pose& pose, Point p) {
    const Real c = std::cos(pose.angle), s = std::sin(pose.angle);
    return {c * p.x + s * p.z + pose.eye.x, p.y + pose.eye.y, -s * p.x + c * p.z + pose.eye.z};
}

class CameraTest : public testing::TestWithParam<Kind> {};

TEST(Jitter, haltonIsTheRadicalInverseFromIndexOne) {
    const double expected[][2] = {{1.0 / 2, 1.0 / 3}, {1.0 / 4, 2.0 / 3}, {3.0 / 4, 1.0 / 9},
                                  {1.0 / 8, 4.0 / 9}, {5.0 / 8, 7.0 / 9}, {3.0 / 8, 2.0 / 9},
                                  {7.0 / 8, 5.0 / 9}, {1.0 / 16, 8.0 / 9}};
    for (uint64_t i = 0; i < 8; ++i) {
        for (const auto sequence : {JitterSequence::halton8, JitterSequence::halton16}) {
            const glm::dvec2 jitter = jitterPx(sequence, i);
            EXPECT_NEAR(jitter.x, expected[i][0] - 0.5, 1e-15); // a sum of at most 4 rounded digits
            EXPECT_NEAR(jitter.y, expected[i][1] - 0.5, 1e-15);
        }
    }
}

TEST(Jitter, sequencesRepeatAfterTheirPeriodAndStayInThePixel) {
    for (const auto sequence : {JitterSequence::none, JitterSequence::uniform4Helix, JitterSequence::halton8,
                                JitterSequence::halton16}) {
        const uint32_t period = jitterPeriod(sequence);
        std::set<std::pair<double, double>> seen;
        for (uint64_t i = 0; i < period; ++i) {
            const glm::dvec2 jitter = jitterPx(sequence, i);
            EXPECT_EQ(jitter, jitterPx(sequence, i + 1000 * uint64_t(period)));
            EXPECT_TRUE(jitter.x >= -0.5 && jitter.x < 0.5 && jitter.y >= -0.5 && jitter.y < 0.5);
            seen.insert({jitter.x, jitter.y});
        }
        EXPECT_EQ(seen.size(), period) << "no offset comes twice";
    }
    EXPECT_EQ(jitterPx(JitterSequence::none, 7), glm::dvec2(0.0));
}

TEST(Jitter, everyStepOfTheHelixCrossesTheHorizontalCentreLine) {
    glm::dvec2 sum(0.0);
    for (uint64_t i = 0; i < 4; ++i) {
        const glm::dvec2 jitter = jitterPx(JitterSequence::uniform4Helix, i);
        EXPECT_LT(jitter.y * jitterPx(JitterSequence::uniform4Helix, i + 1).y, 0.0);
        sum += jitter;
    }
    EXPECT_EQ(sum, glm::dvec2(0.0));
}

TEST_P(CameraTest, jitterMovesTheImageByItsPixels) {
    constexpr uint32_t width = 641, height = 359;
    const glm::dvec2 jitter(0.3, -0.2);
    const glm::dmat4 plain = projectionOf(GetParam());
    const glm::dmat4 jittered = jitteredProjection(plain, jitter, width, height);
    for (const double z : {0.5, 3.0, 150.0}) {
        const glm::dvec4 view(0.4, -0.3, z, 1.0);
        const glm::dvec4 a = plain * view, b = jittered * view;
        const glm::dvec3 moved = glm::dvec3(b) / b.w - glm::dvec3(a) / a.w;
        EXPECT_NEAR(moved.x * width / 2.0, 0.3, 1e-12); // right; a few roundings of values near 1, times 320
        EXPECT_NEAR(moved.y * height / -2.0, -0.2, 1e-12); // y of NDC is up
        EXPECT_EQ(moved.z, 0.0);
    }
}

// 1 ULP of device depth near 1 is worth z / near ULPs of linear depth: that sets the bound.
TEST_P(CameraTest, linearDepthComesBackFromDeviceDepth) {
    const bool flat = orthographic(GetParam());
    const glm::dvec2 k = linearDepthCoefficients(projectionOf(GetParam()));
    EXPECT_EQ(isOrthographic(projectionOf(GetParam())), flat);
    for (Real z = nearPlane; z < farPlane; z *= 1.37L) {
        const auto device = static_cast<double>(project(GetParam(), {0.0L, 0.0L, z}).depth);
        const double affine = device * k.x + k.y;
        const auto linear = static_cast<double>(z);
        EXPECT_NEAR(flat ? affine : 1.0 / affine, linear,
                    8e-16 * linear * static_cast<double>(farPlane / nearPlane));
    }
}

TEST_P(CameraTest, viewRayGivesTheViewPositionOfEveryUv) {
    const glm::dvec4 ray = viewRay(projectionOf(GetParam()));
    std::mt19937 random(7);
    std::uniform_real_distribution<double> side(-2.0, 2.0), depth(0.2, 100.0);
    for (int i = 0; i < 100; ++i) {
        const Point p{side(random), side(random), depth(random)};
        const Projected seen = project(GetParam(), p);
        const glm::dvec2 uv(static_cast<double>(seen.ndcX * 0.5L + 0.5L),
                            static_cast<double>(0.5L - seen.ndcY * 0.5L));
        const glm::dvec2 at = uv * glm::dvec2(ray) + glm::dvec2(ray.z, ray.w);
        const double z = orthographic(GetParam()) ? 1.0 : static_cast<double>(p.z);
        EXPECT_NEAR(at.x * z, static_cast<double>(p.x), 1e-13 * z + 1e-13);
        EXPECT_NEAR(at.y * z, static_cast<double>(p.y), 1e-13 * z + 1e-13);
    }
}

TEST_P(CameraTest, reprojectionTakesWhatIsSeenToWhereItWasSeen) {
    const Pose now{0.4L, {3.0L, 1.0L, -2.0L}}, before{0.37L, {2.9L, 1.02L, -2.1L}};
    const CameraFrame current{worldToView(now), projectionOf(GetParam())};
    const CameraFrame previous{worldToView(before), projectionOf(GetParam())};
    const glm::dmat4 fromClip = reprojection(current, previous),
                     fromView = viewToPreviousClip(current, previous);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> side(-1.0, 1.0), depth(1.0, 100.0);
    for (int i = 0; i < 100; ++i) {
        const Point view{side(random), side(random), depth(random)};
        const Projected seen = project(GetParam(), view);
        const Projected was = project(GetParam(), toView(before, toWorld(now, view)));
        const glm::dvec4 clip =
            fromClip * glm::dvec4(static_cast<double>(seen.ndcX), static_cast<double>(seen.ndcY),
                                  static_cast<double>(seen.depth), 1.0);
        const glm::dvec4 direct =
            fromView * glm::dvec4(static_cast<double>(view.x), static_cast<double>(view.y),
                                  static_cast<double>(view.z), 1.0);
        // The inverse projection loses far / near of the 1e-16; the pixel bound of 8192 is 1e-4, this is
        // 1e-10.
        EXPECT_NEAR(clip.x / clip.w, static_cast<double>(was.ndcX), 1e-10);
        EXPECT_NEAR(clip.y / clip.w, static_cast<double>(was.ndcY), 1e-10);
        EXPECT_GT(clip.w, 0.0); // the factor is positive: what lies behind can be told
        EXPECT_NEAR(direct.x / direct.w, static_cast<double>(was.ndcX), 1e-13);
        EXPECT_NEAR(direct.z / direct.w, static_cast<double>(was.depth), 1e-13);
    }
}

constexpr std::array<const char*, 5> kindNames{"standard", "reversed", "reversedInfinite", "orthographic",
                                               "orthographicReversed"};

INSTANTIATE_TEST_SUITE_P(Kinds, CameraTest, testing::ValuesIn(kinds), [](const auto& kind) {
    return std::string(kindNames[static_cast<size_t>(kind.param)]);
});

} // namespace
