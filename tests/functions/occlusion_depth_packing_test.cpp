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

// --- The fine form: 12 bits of occlusion, 4 of frames

// As pack, in1.x: noise
const Function packFine{
    "packFineOcclusionDepth",
    {header},
    "OcclusionDepth data; data.occlusion = in0.x; data.linearDepth = in0.y; data.convergence = in0.z;"
    "out0 = packFineOcclusionDepth(data, in0.w, in1.x);",
    2};
const Function unpackFine{"unpackFineOcclusionDepth",
                          {header},
                          "OcclusionDepth data = unpackFineOcclusionDepth(in0, in1.x);"
                          "out0.xyz = float3(data.occlusion, data.linearDepth, data.convergence);",
                          2};

std::vector<Row> fineRoundTrip(const std::vector<Row>& data, const Mutation& mutation = {}) {
    auto stored = run(packFine, data, {.mutation = mutation, .outputFormat = "rgba8"});
    for (size_t i = 0; i < data.size(); ++i)
        stored[i].push_back(vec4(data[i][0].w, 0.0f, 0.0f, 0.0f));
    return run(unpackFine, stored, {.mutation = mutation});
}

// Every step of occlusion with every count of frames, at noises from end to end.
size_t fineCodesOff(const Mutation& mutation = {}) {
    std::vector<Row> data;
    for (const float noise : {0.0f, 0.25f, 0.5f, 0.75f, 0.998f, 1.0f})
        for (int step = 0; step <= 4080; ++step)
            data.push_back({vec4(static_cast<float>(step / 4080.0), static_cast<float>(step % 256 * 0.25),
                                 static_cast<float>(step % 16), 100.0f),
                            vec4(noise)});
    const auto back = fineRoundTrip(data, mutation);
    size_t off = 0;
    for (size_t i = 0; i < data.size(); ++i) {
        const double steps = 4080.0 * back[i][0].x;
        off += !(std::abs(steps - static_cast<double>(i % 4081)) < 1e-3 && back[i][0].z == data[i][0].z &&
                 std::abs(back[i][0].y - data[i][0].y) <= 100.0 / 131070.0 + 1e-4);
    }
    return off;
}

TEST(OcclusionDepthPacking, everyFineStepAndCountComesBackWhateverTheNoise) {
    EXPECT_EQ(fineCodesOff(), 0u);
    EXPECT_GT(fineCodesOff({header, "floor((step + 8.0) / 16.0)", "floor(step / 16.0)"}), 0u);
    EXPECT_GT(fineCodesOff({header, "bounded(noise, 0.002, 0.998)", "2.0 * noise"}), 0u);
    EXPECT_GT(fineCodesOff({header, "16.0 * frames + sixteenths", "sixteenths"}), 0u);
    EXPECT_GT(fineCodesOff({header, "16.0 * (digits.x - data.convergence)", "16.0 * digits.x"}), 0u);
}

// Red alone is the occlusion in 8 bits, to the nearest level.
TEST(OcclusionDepthPacking, redOfTheFineFormIsTheNearestLevel) {
    Random random(6);
    std::vector<Row> data;
    for (int i = 0; i < 4000; ++i)
        data.push_back({vec4(random.in(0.0f, 1.0f), 1.0f, 3.0f, 10.0f), vec4(0.5f)});
    const auto stored = run(packFine, data, {.outputFormat = "rgba8"});
    for (size_t i = 0; i < data.size(); ++i) // half a level, and half a step before it
        ASSERT_NEAR(stored[i][0].x, data[i][0].x, 1.0 / 510.0 + 1.0 / 8160.0 + 1e-6);
}

// What is written is, on average over a noise that is spread evenly, the occlusion.
double fineMeanError(const Mutation& mutation = {}) {
    Random random(7);
    std::vector<Row> data;
    for (int i = 0; i < 64; ++i) {
        const float occlusion = random.in(0.01f, 0.99f);
        for (int k = 0; k < 256; ++k)
            data.push_back({vec4(occlusion, 1.0f, 3.0f, 10.0f), vec4(static_cast<float>((k + 0.5) / 256.0))});
    }
    const auto back = fineRoundTrip(data, mutation);
    double worst = 0.0;
    for (size_t i = 0; i < data.size(); i += 256) {
        double mean = 0.0;
        for (size_t k = i; k < i + 256; ++k)
            mean += double{back[k][0].x} / 256.0;
        worst = std::max(worst, std::abs(mean - double{data[i][0].x}));
    }
    return worst;
}

TEST(OcclusionDepthPacking, noiseKeepsTheMean) {
    // A 256th of a step, which the noise goes by, and the step's rounding.
    EXPECT_LE(fineMeanError(), 1.0 / 4080.0 / 200.0);
    EXPECT_GT(fineMeanError({header, "bounded(noise, 0.002, 0.998)", "0.5"}), 0.3 / 4080.0);
}

TEST(OcclusionDepthPacking, noInputGivesNaNOrInfinity) {
    expectNumbers(pack, hostileRows(hostileFinite, 1, 2000, 2));
    expectNumbers(pack, hostileRows(hostileAny, 1, 2000, 3));
    expectNumbers(packFine, hostileRows(hostileAny, 2, 2000, 8));
    std::vector<Row> rows = hostileRows(hostileAny, 2, 2000, 4);
    Random random(5);
    for (Row& row : rows)
        row[1] = vec4(random.of(hostileFinite));
    expectNumbers(unpack, rows);
    expectNumbers(unpackFine, rows);
}

} // namespace
} // namespace functions
