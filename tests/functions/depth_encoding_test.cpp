// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/depth_encoding.hlsli";

struct Range {
    float nearM, farM;
};
const Range ranges[] = {{0.1f, 100.0f}, {0.01f, 10000.0f}, {1.0f, 1.5f}, {1e-4f, 1e7f}};

// depth, near, far; depths spread over the logarithm, with the ends and what lies outside
std::vector<Row> depths() {
    std::vector<Row> rows;
    for (const Range& range : ranges) {
        for (int i = 0; i <= 1000; ++i) {
            const double depth =
                range.nearM * std::pow(static_cast<double>(range.farM) / range.nearM, i / 1000.0);
            rows.push_back({vec4(static_cast<float>(depth), range.nearM, range.farM, 0.0f)});
        }
        for (float depth : {-1.0f, 0.0f, denormal, 1e30f})
            rows.push_back({vec4(depth, range.nearM, range.farM, 0.0f)});
    }
    return rows;
}

double heldDepth(const Row& in) {
    return oracle::held(in[0].x, in[0].y, in[0].z);
}

// A key as a 16-bit unorm target keeps it.
const std::string unorm16 = "key = floor(key * 65535.0 + 0.5) / 65535.0;";

// key, depth from it, depth from it in 16 bits
Comparison linearKeys() {
    return {{"linear key",
             {header},
             "float key = linearKeyFromDepth(in0.x, in0.y, in0.z); out0.x = key;"
             "out0.y = depthFromLinearKey(key, in0.y, in0.z);" +
                 unorm16 + "out0.z = depthFromLinearKey(key, in0.y, in0.z);"},
            depths(),
            [](const Row& in) {
                // Differences rounded at far, and a division; 16 bits add half a code.
                const double range = static_cast<double>(in[0].z) - in[0].y;
                const double key = 3.0 * roundoff * in[0].z / range + divisionError,
                             depth = 2.0 * key * range;
                Expected expected =
                    near(dvec3(oracle::linearKey(in[0].x, in[0].y, in[0].z), heldDepth(in), heldDepth(in)),
                         dvec3(key, depth, depth + range / 131070.0));
                return std::vector{expected};
            }};
}

// The same, logarithmic. log2(depth / near) is off by 2^-21 near 1 and by 3 ULP elsewhere, the division
// by 2.5, and exp2 by 3 + 2 |x| ULP: all of it in log2 of the depth.
Comparison logarithmicKeys() {
    return {
        {"logarithmic key",
         {header},
         "float key = logarithmicKeyFromDepth(in0.x, in0.y, in0.z); out0.x = key;"
         "out0.y = depthFromLogarithmicKey(key, in0.y, in0.z);" +
             unorm16 + "out0.z = depthFromLogarithmicKey(key, in0.y, in0.z);"},
        depths(),
        [](const Row& in) {
            const double octaves = std::log2(static_cast<double>(in[0].z) / in[0].y), depth = heldDepth(in);
            const double log2Error = 0x1p-21 + 2.0 * divisionError + 16.0 * roundoff * octaves;
            const double relative = std::log(2.0) * log2Error + (3.0 + 2.0 * octaves) * 2.0 * roundoff;
            const double code = std::log(static_cast<double>(in[0].z) / in[0].y) / 131070.0;
            return std::vector{near(dvec3(oracle::logarithmicKey(in[0].x, in[0].y, in[0].z), depth, depth),
                                    dvec3(2.0 * log2Error / octaves + divisionError, 2.0 * relative * depth,
                                          (2.0 * relative + 1.0001 * code) * depth))};
        }};
}

TEST(DepthEncoding, linearKeysLeadBackWithinHalfACode) {
    expectAgrees(linearKeys());
}

TEST(DepthEncoding, logarithmicKeysLeadBackWithTheSameRelativeErrorEverywhere) {
    expectAgrees(logarithmicKeys());
}

TEST(DepthEncoding, wrongKeysAreCaught) {
    expectCaught(linearKeys(), {header, "nearM + bounded(key, 0.0, 1.0)", "bounded(key, 0.0, 1.0)"});
    expectCaught(linearKeys(),
                 {header, "bounded(linearDepth - nearM, 0.0, range)", "bounded(linearDepth, 0.0, range)"});
    expectCaught(logarithmicKeys(), {header, "ends.x * exp2(bounded(key, 0.0, 1.0) * ends.y)",
                                     "ends.x + exp2(bounded(key, 0.0, 1.0) * ends.y)"});
    expectCaught(logarithmicKeys(), {header, "bounded(linearDepth, ends.x, MAX_FAR_M) / ends.x",
                                     "bounded(linearDepth, ends.x, MAX_FAR_M)"});
}

// How many digits in the channels, and the codes that are to come back from a target of 8-bit channels.
struct Split {
    std::string pack, unpack;
};
const Split split16{"out0.xy = packKey16(in0.x);", "out0.x = unpackKey16(in0.xy);"};
const Split split24{"out0.xyz = packKey24(in0.x);", "out0.x = unpackKey24(in0.xyz);"};
const Split split32{"out0 = packKey32(in0.x);", "out0.x = unpackKey32(in0);"};

// Through an RGBA8 image of the device.
std::vector<Row> throughUnorm8(const Split& split, const std::vector<Row>& keys,
                               const Mutation& mutation = {}) {
    const auto stored =
        run({"pack", {header}, split.pack}, keys, {.mutation = mutation, .outputFormat = "rgba8"});
    return run({"unpack", {header}, split.unpack}, stored, {.mutation = mutation});
}

std::vector<Row> every16BitKey() {
    std::vector<Row> keys;
    for (int code = 0; code < 65536; ++code)
        keys.push_back({vec4(static_cast<float>(code / 65535.0), 0.0f, 0.0f, 0.0f)});
    return keys;
}

TEST(DepthEncoding, every16BitCodeComesBackFromTwoChannels) {
    const std::vector<Row> keys = every16BitKey();
    const auto back = throughUnorm8(split16, keys);
    for (size_t code = 0; code < 65536; ++code)
        ASSERT_EQ(oracle::key16Code(back[code][0].x), static_cast<int>(code));
    // The digits themselves, against integers.
    const auto stored = run({"packKey16", {header}, split16.pack}, keys, {.outputFormat = "rgba8"});
    for (size_t code = 0; code < 65536; ++code) {
        const auto digits = oracle::digits<2>(code);
        ASSERT_EQ(std::lround(stored[code][0].x * 255.0f), std::lround(digits[0])) << code;
        ASSERT_EQ(std::lround(stored[code][0].y * 255.0f), std::lround(digits[1])) << code;
    }
}

// Wrong by one in some code: each is what one writes first.
TEST(DepthEncoding, splitsThatLoseACodeAreCaught) {
    const auto codesLost = [](const Mutation& mutation) {
        const auto back = throughUnorm8(split16, every16BitKey(), mutation);
        size_t lost = 0;
        for (size_t code = 0; code < 65536; ++code)
            lost += oracle::key16Code(back[code][0].x) != static_cast<int>(code);
        return lost;
    };
    EXPECT_EQ(codesLost({}), 0u);
    EXPECT_GT(codesLost({header, "return digits / 255.0;", "return digits / 256.0;"}), 0u);
    EXPECT_GT(codesLost({header, "return floor(bounded(channels, 0.0, 1.0) * 255.0 + 0.5);",
                         "return bounded(channels, 0.0, 1.0) * 256.0;"}),
              0u);
    EXPECT_GT(codesLost({header, "digits.x * 256.0 + digits.y", "digits.x * 255.0 + digits.y"}), 0u);
    EXPECT_GT(codesLost({header, "digits.x * 256.0 + digits.y", "digits.y * 256.0 + digits.x"}), 0u);
}

// Keys over all magnitudes, odd codes of the full 24 bits and the ends.
std::vector<Row> keys(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (float key :
         {0.0f, 1.0f, 0x1.fffffep-1f, 0x1.fffffcp-1f, 0.5f, 0x1.000002p-1f, 0x1p-8f, 0x1p-9f, 0x1p-31f})
        rows.push_back({vec4(key)});
    for (int i = 0; i < 20000; ++i) {
        rows.push_back({vec4(0.5f + 0.5f * random.unit())});
        rows.push_back({vec4(random.unit())});
        rows.push_back({vec4(std::exp2(-30.0f * random.unit()) * (0.5f + 0.5f * random.unit()))});
    }
    return rows;
}

double largestKey(double key) {
    return std::min(key, 1.0 - 0x1p-24);
}

// 24 bits: exact from 1/2 on, half a code below, and 1 is the last code. 32 bits: exact from 2^-9 on, a code
// below.
double error24(double key) {
    return key >= 0.5 ? 0.0 : 0x1p-25;
}
double error32(double key) {
    return key >= 0x1p-9 ? 0.0 : 0x1p-32;
}

size_t keysOff(const Split& split, double (*error)(double), const Mutation& mutation = {}) {
    const std::vector<Row> in = keys(1);
    const auto back = throughUnorm8(split, in, mutation);
    size_t off = 0;
    for (size_t i = 0; i < in.size(); ++i) {
        const double key = largestKey(in[i][0].x), difference = std::abs(back[i][0].x - key);
        off += !(difference <= error(key));
    }
    return off;
}

TEST(DepthEncoding, threeAndFourChannelsGiveKeysBackWithinTheStatedError) {
    EXPECT_EQ(keysOff(split24, error24), 0u);
    EXPECT_EQ(keysOff(split32, error32), 0u);
}

TEST(DepthEncoding, wrongSplitsOf24And32BitsAreCaught) {
    // From 2^23 on adding a half rounds to even, so that every odd code is off by one.
    EXPECT_GT(keysOff(split24, error24,
                      {header, "whole + (scaled - whole >= 0.5 ? 1.0 : 0.0)", "floor(scaled + 0.5)"}),
              0u);
    EXPECT_GT(keysOff(split24, error24, {header, "whole + (scaled - whole >= 0.5 ? 1.0 : 0.0)", "whole"}),
              0u);
    EXPECT_GT(
        keysOff(split24, error24, {header, "digits.y * 256.0 + digits.z", "digits.z * 256.0 + digits.y"}),
        0u);
    EXPECT_GT(keysOff(split32, error32, {header, "digits.w / 256.0 + digits.z", "digits.z"}), 0u);
    EXPECT_GT(keysOff(split32, error32,
                      {header, "bounded(key, 0.0, LARGEST_KEY) * 256.0", "bounded(key, 0.0, 1.0) * 255.0"}),
              0u);
}

TEST(DepthEncoding, noInputGivesNaNOrInfinity) {
    const Function all{
        "depth encodings",
        {header},
        "out0 = float4(linearKeyFromDepth(in0.x, in0.y, in0.z), depthFromLinearKey(in0.x, in0.y, in0.z), "
        "logarithmicKeyFromDepth(in0.x, in0.y, in0.z), depthFromLogarithmicKey(in0.x, in0.y, in0.z));"
        "out1 = float4(packKey16(in0.x), unpackKey16(in0.xy), 0.0);"
        "out2 = float4(packKey24(in0.x), unpackKey24(in0.xyz));"
        "out3 = packKey32(in0.x); out4.x = unpackKey32(in0);",
        1,
        5};
    std::vector<Row> rows = triples(hostileFinite);
    for (const Row& broken : hostileRows(hostileAny, 1, 500, 3)) // a key or a depth of a broken history
        rows.push_back({vec4(broken[0].x, 0.1f, 100.0f, broken[0].w)});
    expectNumbers(all, rows);
}

} // namespace
} // namespace functions
