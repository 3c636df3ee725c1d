// SPDX-License-Identifier: Apache-2.0
#include "cameras.hpp"
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/reprojection.hlsli";

// Rows: matrix, (uv, depth, row of the camera pair), view rays.
struct Reprojections {
    std::vector<CameraPair> cameras;
    std::vector<Row> rows;
};

Reprojections deviceRows(const Convention& convention) {
    Random random(1);
    Reprojections made;
    for (int i = 0; i < 400; ++i) {
        const CameraPair pair = randomCameras(random, convention.projection);
        made.cameras.push_back(pair);
        Row row;
        push(row, pair.previous.viewToClip * pair.previous.worldToView *
                      glm::inverse(pair.current.worldToView) * glm::inverse(pair.current.viewToClip));
        double device =
            oracle::deviceDepth(randomDepth(random, convention.projection), convention.projection.matrix);
        if (i % 10 == 0) device = i % 20 == 0 ? 0.0 : 1.0; // the planes themselves, infinite ones among them
        row.push_back(vec4(random.unit(), random.unit(), device, i));
        made.rows.push_back(row);
    }
    return made;
}

Comparison byDeviceDepth(const Convention& convention) {
    const Reprojections made = deviceRows(convention);
    return {{"reprojectDeviceDepth",
             {header},
             "out0.xy = reprojectDeviceDepth(in4.xy, in4.z, float4x4(in0, in1, in2, in3));",
             5,
             1,
             convention.defines()},
            made.rows,
            [made, convention](const Row& in) {
                const CameraPair& pair = made.cameras[static_cast<size_t>(in[4].w)];
                const dvec2 uv = oracle::reprojectDeviceDepth(xy(in[4]), in[4].z, pair.current, pair.previous,
                                                              convention.sharesY);
                const dvec4 point(oracle::uvToNdc(xy(in[4]), convention.sharesY), in[4].z, 1.0);
                // uv - 1/2 is rounded at 1/2, so NDC at 1.
                return std::vector{
                    nearClip(matrixOf(in), point, glm::max(glm::abs(point), dvec4(1, 1, 0, 1)), uv)};
            }};
}

Comparison byLinearDepth(const Convention& convention) {
    Reprojections made = deviceRows(convention);
    Random random(2);
    for (size_t i = 0; i < made.rows.size(); ++i) {
        const CameraPair& pair = made.cameras[i];
        Row row;
        push(row,
             pair.previous.viewToClip * pair.previous.worldToView * glm::inverse(pair.current.worldToView));
        row.push_back(vec4(random.unit(), random.unit(), randomDepth(random, convention.projection), i));
        row.push_back(vec4(viewRays(convention)));
        made.rows[i] = row;
    }
    return {{"reprojectLinearDepth",
             {header},
             "out0.xy = reprojectLinearDepth(in4.xy, in4.z, in5, float4x4(in0, in1, in2, in3));",
             6,
             1,
             convention.defines()},
            made.rows,
            [made, convention](const Row& in) {
                const CameraPair& pair = made.cameras[static_cast<size_t>(in[4].w)];
                const dvec2 uv = oracle::reprojectLinearDepth(xy(in[4]), in[4].z, pair.current, pair.previous,
                                                              convention.sharesY);
                const dvec2 ndc = oracle::uvToNdc(xy(in[4]), convention.sharesY);
                const dvec4 point = oracle::viewPoint(ndc, in[4].z, convention.projection.matrix);
                // The ray is rounded at the size of its extent and its origin, not at its own.
                const dvec4 rays = glm::abs(viewRays(convention));
                const double scale = convention.projection.orthographic ? 1.0 : in[4].z;
                const dvec4 sizes(scale * (rays.x + rays.z), scale * (rays.y + rays.w), point.z, 1.0);
                return std::vector{nearClip(matrixOf(in), point, sizes, uv)};
            }};
}

TEST(Reprojection, deviceDepthAgreesForEveryDepthKindAndYDirection) {
    for (const Convention& convention : conventions()) {
        SCOPED_TRACE(convention.projection.name + (convention.sharesY ? ", shared y" : ""));
        expectAgrees(byDeviceDepth(convention));
    }
}

TEST(Reprojection, linearDepthAgreesForEveryDepthKindAndYDirection) {
    for (const Convention& convention : conventions()) {
        SCOPED_TRACE(convention.projection.name + (convention.sharesY ? ", shared y" : ""));
        expectAgrees(byLinearDepth(convention));
    }
}

TEST(Reprojection, matrixOnTheWrongSideIsCaught) {
    expectCaught(byDeviceDepth(conventions()[0]),
                 {header, "transform(reprojection, float4(", "mul(reprojection, float4("});
}

TEST(Reprojection, ndcWithTheWrongYIsCaught) {
    // As the slide prints it: 0.5 * q.xy / q.w + 0.5.
    expectCaught(byDeviceDepth(conventions()[0]),
                 {"reprise/coordinates.hlsli", "ndc * NDC_TO_UV_SCALE + 0.5", "ndc * 0.5 + 0.5"});
}

TEST(Reprojection, placeBehindThePreviousCameraWithoutItsGuardIsCaught) {
    expectCaught(byDeviceDepth(conventions()[0]),
                 {header, "return inFront && all(abs(uv) <= 8.0) ? uv : BEHIND_CAMERA_UV;",
                  "return all(abs(uv) <= 8.0) ? uv : BEHIND_CAMERA_UV;"});
    expectCaught(byDeviceDepth(conventions()[0]),
                 {header, "bool inFront = positionCS.w > 0.0;", "bool inFront = positionCS.w != 0.0;"});
}

TEST(Reprojection, rayThatIsNotScaledByDepthIsCaught) {
    expectCaught(byLinearDepth(conventions()[0]),
                 {header, "float3(ray * linearDepth, linearDepth)", "float3(ray, linearDepth)"});
    expectCaught(byLinearDepth(conventions()[0]),
                 {header, "uv * viewRay.xy + viewRay.zw", "uv * viewRay.zw + viewRay.xy"});
}

// Of one camera that stands still, every place is its own previous place.
TEST(Reprojection, nothingMovesUnderACameraThatStandsStill) {
    for (const Convention& convention : conventions()) {
        SCOPED_TRACE(convention.projection.name);
        Comparison still = byDeviceDepth(convention);
        const glm::dmat4 identity(1.0);
        for (Row& row : still.inputs)
            for (int column = 0; column < 4; ++column)
                row[static_cast<size_t>(column)] = vec4(identity[column]);
        still.oracle = [](const Row& in) {
            return std::vector{near(xy(in[4]), 4.0 * roundoff)};
        }; // to NDC and back
        expectAgrees(still);
    }
}

std::vector<Row> clipPositions() {
    std::vector<Row> rows;
    const float values[] = {0.0f,  -0.0f,  1.0f,     -1.0f,     0.3f,      denormal,
                            1e30f, -1e30f, infinity, -infinity, notANumber};
    for (float x : values)
        for (float w : values) {
            rows.push_back({vec4(x, 0.5f, 0.0f, w)});
            rows.push_back({vec4(-0.25f, x, 0.0f, w)});
        }
    Random random(3);
    for (int i = 0; i < 2000; ++i)
        rows.push_back({random.in4(-3.0f, 3.0f)});
    return rows;
}

Comparison clipping() {
    return {{"clipToUv", {header}, "out0.xy = clipToUv(in0);"}, clipPositions(), [](const Row& in) {
                const dvec4 clip(in[0]);
                const bool odd = !glm::all(glm::lessThan(glm::abs(clip), dvec4(1e38)));
                const bool flushed = std::abs(clip.w) < flush && clip.w != 0.0;
                // Infinity and NaN in front of the camera are nowhere; with an infinite w any finite place
                // will do.
                if (std::isinf(clip.w) || flushed) return std::vector{finite()};
                if (odd && clip.w > 0.0) return std::vector{near(oracle::behindCameraUv, 0.0)};
                const dvec2 uv = oracle::clipToUv(clip);
                const dvec2 ndc = clip.w > 0.0 ? glm::abs(dvec2(clip)) / clip.w : dvec2(0.0);
                // A division, a product, a sum; beyond 17 in NDC a place is behind whatever its error.
                const double size = std::min(std::max(ndc.x, ndc.y), 20.0);
                const double bound =
                    clip.w > 0.0 ? divisionError * size + 2.0 * roundoff * (1.0 + size) : 0.0;
                return std::vector{isAtLimit(ndc, bound) ? finite() : near(uv, bound)};
            }};
}

TEST(Reprojection, clipPositionsOfAnyKindGiveFinitePlaces) {
    expectAgrees(clipping());
    for (const Row& out : run(clipping().function, clipPositions()))
        for (int axis = 0; axis < 2; ++axis)
            EXPECT_LE(std::abs(out[0][axis]), 8.0f);
}

TEST(Reprojection, clipPositionsWithoutTheLimitAreCaught) {
    expectCaught(clipping(), {header, "inFront && all(abs(uv) <= 8.0)", "inFront"});
}

TEST(Reprojection, historyBehindTheCameraIsOutsideOfTheImage) {
    for (float w : {0.0f, -0.0f, -1.0f, notANumber, -infinity}) {
        const auto out = run({"behind", {header}, "out0.x = isInsideUv(clipToUv(in0)) ? 1.0 : 0.0;"},
                             {{vec4(0, 0, 0, w)}});
        EXPECT_EQ(out[0][0].x, 0.0f) << "w " << w;
    }
}

Comparison motions() {
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i) {
        vec4 current = random.in4(-1.5f, 1.5f), previous = random.in4(-1.5f, 1.5f);
        current.w = random.in(0.5f, 3.0f);
        previous.w = i % 10 == 0 ? random.in(-1.0f, 0.0f) : random.in(0.5f, 3.0f);
        rows.push_back({current, previous});
    }
    return {{"motionFromClip", {header}, "out0.xy = motionFromClip(in0, in1);", 2}, rows, [](const Row& in) {
                // NDC up to 3 on both sides, places up to 8: as clipToUv, twice, and a difference.
                return std::vector{near(oracle::motionFromClip(dvec4(in[0]), dvec4(in[1])),
                                        2.0 * (divisionError * 3.0 + 8.0 * roundoff) + 10.0 * roundoff)};
            }};
}

TEST(Reprojection, motionPointsFromThePreviousToTheCurrentPlace) {
    expectAgrees(motions());
}

TEST(Reprojection, motionOfTheOtherSignIsCaught) {
    expectCaught(motions(), {header, "clipToUv(positionCS) - clipToUv(prevPositionCS)",
                             "clipToUv(prevPositionCS) - clipToUv(positionCS)"});
}

} // namespace
} // namespace functions
