// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/occlusion_depth_packing.hlsli";

// in0: occlusion, linear depth, convergence, far
const Function pack{
    "packOcclusionDepth",
    {header},
    "OcclusionDepth data; data.occlusion = in0.x; data.linearDepth = in0.y; data.convergence = in0.z;"
    "out0 = packOcclusionDepth(data, in0.w);"};
// in0: the texel, in1.x: far
const Function unpack{"unpackOcclusionDepth",
                      {header},
                      "OcclusionDepth data = unpackOcclusionDepth(in0, in1.x);"
                      "out0.xyz = float3(data.occlusion, data.linearDepth, data.convergence);",
                      2};

// Through an RGBA8 image of the device.
std::vector<Row> roundTrip(const std::vector<Row>& data, const Mutation& mutation = {}) {
    auto stored = run(pack, data, {.mutation = mutation, .outputFormat = "rgba8"});
    for (size_t i = 0; i < data.size(); ++i)
        stored[i].push_back(vec4(data[i][0].w, 0.0f, 0.0f, 0.0f));
    return run(unpack, stored, {.mutation = mutation});
}

std::vector<Row> everyDepthCode(float farM) {
    std::vector<Row> rows;
    for (int code = 0; code < 65536; ++code)
        rows.push_back(
            {vec4(static_cast<float>(code % 256) / 255.0f, static_cast<float>(code / 65535.0 * farM),
                  static_cast<float>(code % 256), farM)});
    return rows;
}

TEST(OcclusionDepthPacking, everyDepthCodeOcclusionAndConvergenceComesBack) {
    for (float farM : {1.0f, 150.0f, 1e4f}) {
        const auto data = everyDepthCode(farM), back = roundTrip(data);
        for (size_t code = 0; code < 65536; ++code) {
            ASSERT_EQ(oracle::key16Code(back[code][0].y / static_cast<double>(farM)), static_cast<int>(code))
                << farM;
            ASSERT_EQ(std::lround(back[code][0].x * 255.0f), static_cast<long>(code % 256)) << code;
            ASSERT_EQ(back[code][0].z, static_cast<float>(code % 256)) << code;
        }
    }
}

// How many rows are outside of the stated errors, and the worst error of depth over its far plane.
struct Result {
    size_t off = 0;
    double worstDepth = 0.0;
};

Result within(const Mutation& mutation = {}) {
    Random random(1);
    std::vector<Row> data;
    for (int i = 0; i < 20000; ++i) {
        const float farM = random.of(std::vector{1.0f, 100.0f, 1e5f});
        data.push_back({vec4(random.in(-0.2f, 1.2f), farM * random.in(-0.1f, 1.2f),
                             std::floor(random.in(0.0f, 300.0f)), farM)});
    }
    const auto back = roundTrip(data, mutation);
    Result result;
    for (size_t i = 0; i < data.size(); ++i) {
        const double farM = data[i][0].w;
        // Half a code; division and product around it.
        const double depthBound = farM * (1.0 / 131070.0 + 2.0 * divisionError);
        const double depth = std::abs(back[i][0].y - oracle::held(data[i][0].y, 0.0, farM));
        const double occlusion = std::abs(back[i][0].x - oracle::held(data[i][0].x, 0.0, 1.0));
        const bool frames = back[i][0].z == static_cast<float>(oracle::held(data[i][0].z, 0.0, 255.0));
        result.off += !(depth <= depthBound && occlusion <= 1.0 / 510.0 + 4.0 * roundoff && frames);
        result.worstDepth = std::max(result.worstDepth, depth / farM);
    }
    return result;
}

TEST(OcclusionDepthPacking, errorsAreThoseStatedAndEndsAreClamped) {
    const Result result = within();
    EXPECT_EQ(result.off, 0u);
    measured("worst error of 16-bit depth, over the far plane", result.worstDepth);
    EXPECT_GE(result.worstDepth, 0.95 / 131070.0);
}

TEST(OcclusionDepthPacking, swappedChannelsAndWrongFarPlanesAreCaught) {
    EXPECT_GT(within({header, "unpackKey16(texel.gb)", "unpackKey16(texel.bg)"}).off, 0u);
    EXPECT_GT(
        within({header, "linearKeyFromDepth(data.linearDepth, 0.0, farM)", "data.linearDepth / farM * 0.5"})
            .off,
        0u);
    EXPECT_GT(within({header, "convergenceFromUnorm8(texel.a)", "texel.a"}).off, 0u);
    // Truncated instead of rounded: a whole code off.
    EXPECT_GT(within({"reprise/depth_encoding.hlsli", "bounded(key, 0.0, 1.0) * 65535.0 + 0.5",
                      "bounded(key, 0.0, 1.0) * 65535.0"})
                  .off,
              0u);
    // One channel of depth instead of two.
    EXPECT_GT(within({header, "unpackKey16(texel.gb)", "texel.g"}).off, 0u);
}

TEST(OcclusionDepthPacking, noInputGivesNaNOrInfinity) {
    expectNumbers(pack, hostileRows(hostileFinite, 1, 2000, 2));
    expectNumbers(pack, hostileRows(hostileAny, 1, 2000, 3));
    std::vector<Row> rows = hostileRows(hostileAny, 2, 2000, 4);
    Random random(5);
    for (Row& row : rows)
        row[1] = vec4(random.of(hostileFinite));
    expectNumbers(unpack, rows);
}

} // namespace
} // namespace functions
