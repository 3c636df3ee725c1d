// SPDX-License-Identifier: Apache-2.0
// depth_encoding.hlsli and bounded.hlsli.
#include "cases.hpp"
#include "few_bits.hpp"

namespace check {
namespace {

using oracle::held;

const std::string encoding = "reprise/depth_encoding.hlsli", boundedHeader = "reprise/bounded.hlsli";

// --- a clamp that NaN does not pass

Case clamps() {
    return {"to ±1e30, NaN and infinity too",
            storing("bounded", boundedHeader,
                    "out0.x = bounded(in0.x, in1.x, in1.y); out1.xy = bounded(in0.xy, in1.x, in1.y);\n"
                    "out2.xyz = bounded(in0.xyz, in1.x, in1.y); out3 = bounded(in0, in1.x, in1.y);",
                    2, 4),
            {Unit::exact, 0.0, "an ordered comparison, and copies"},
            [](const Effort& effort) {
                const auto values = beyondMarks + std::vector{infinity, -infinity, notANumber};
                Random random(1);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(40000); ++i) {
                    const float a = random.of(beyondMarks), b = i % 2 == 0 ? anyValue(random) : a;
                    rows.push_back(
                        {vec4(random.of(values), random.of(values), anyValue(random), random.of(values)),
                         vec4(std::min(a, b), std::max(a, b), 0, 0)});
                }
                return Sweep{rows, [](const Row& in) {
                                 dvec4 v;
                                 for (int c = 0; c < 4; ++c)
                                     v[c] = held(in[0][c], in[1].x, in[1].y);
                                 return std::vector{right(v.x), right(dvec2(v)), right(dvec3(v)), right(v)};
                             }};
            }};
}

// --- keys of depth

// depth, near, far: over the range, its ends, outside, NaN
std::vector<Row> depths(const Effort& effort) {
    const std::pair<float, float> ranges[] = {
        {0.1f, 100.0f}, {0.01f, 10000.0f}, {1.0f, 1.5f}, {1e-4f, 1e7f}, {1e-4f, 1e-3f}};
    std::vector<Row> rows;
    for (const auto& [near, far] : ranges) {
        const auto inside = logarithmic(near, far, effort.of(20000));
        for (float depth : inside + ofBothSigns({0.0f, 1e-40f, 1e-30f, 1e30f, infinity, notANumber}))
            rows.push_back({vec4(depth, near, far, 0.0f)});
    }
    return rows;
}

double heldDepth(const Row& in) {
    return held(in[0].x, in[0].y, in[0].z);
}

// Of log2 of the depth: Vulkan lets log2 err by 2^-21 near 1 and 3 steps elsewhere, and the quotient by 2.5.
double octavesOf(const Row& in) {
    return std::log2(static_cast<double>(in[0].z) / in[0].y);
}

double logarithmError(const Row& in) {
    return 0x1p-21 + 2.0 * divisionError + 16.0 * roundoff * octavesOf(in);
}

// Relative, of exp2.
double exponentialError(const Row& in) {
    return std::log(2.0) * logarithmError(in) + (3.0 + 2.0 * octavesOf(in)) * 2.0 * roundoff;
}

std::vector<Case> keys() {
    const std::string range = "depth 1e-4 to 1e7 m, beyond, NaN";
    return {
        {range,
         storing("linearKeyFromDepth", encoding, "out0.x = linearKeyFromDepth(in0.x, in0.y, in0.z);"),
         {Unit::roundings, 5.0, "two differences at far, in relation to the range, and a division"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              const double range2 = static_cast<double>(in[0].z) - in[0].y;
                              return std::vector{right(oracle::linearKey(in[0].x, in[0].y, in[0].z),
                                                       1.0 + in[0].z / range2)};
                          }};
         }},
        {range + ", there and back",
         storing("depthFromLinearKey", encoding,
                 "out0.x = depthFromLinearKey(linearKeyFromDepth(in0.x, in0.y, in0.z), in0.y, in0.z);"),
         {Unit::roundings, 10.0, "both ways at far"},
         [](const Effort& effort) {
             return Sweep{depths(effort),
                          [](const Row& in) { return std::vector{right(heldDepth(in), in[0].z)}; }};
         }},
        {range,
         storing("logarithmicEnds", encoding, "out0.xy = logarithmicEnds(in0.y, in0.z);"),
         {Unit::roundings, 1.0, "what Vulkan allows log2, and a division"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              return std::vector{Right{dvec4(in[0].y, octavesOf(in), 0, 0),
                                                       dvec4(0.0, logarithmError(in) / roundoff, 0, 0), 2}};
                          }};
         }},
        {range,
         storing("logarithmicKeyFromDepth", encoding,
                 "out0.x = logarithmicKeyFromDepth(in0.x, in0.y, in0.z);"),
         {Unit::roundings, 1.0, "what Vulkan allows two log2, and divisions, over the octaves"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              const double size = 2.0 * logarithmError(in) / octavesOf(in) + divisionError;
                              return std::vector{
                                  right(oracle::logarithmicKey(in[0].x, in[0].y, in[0].z), size / roundoff)};
                          }};
         }},
        {range + ", there and back",
         storing(
             "depthFromLogarithmicKey", encoding,
             "out0.x = depthFromLogarithmicKey(logarithmicKeyFromDepth(in0.x, in0.y, in0.z), in0.y, in0.z);"),
         {Unit::roundings, 1.0, "what Vulkan allows log2 and exp2, over the octaves"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              return std::vector{right(heldDepth(in), 2.0 * exponentialError(in) *
                                                                          heldDepth(in) / roundoff)};
                          }};
         }}};
}

// --- digits

// Over all magnitudes, odd codes of 24 bits, the ends, and every binary16.
std::vector<Row> keyRows(const Effort& effort) {
    Random random(2);
    std::vector<Row> rows = justHalves();
    for (float key :
         {0.0f, 1.0f, 0x1.fffffep-1f, 0x1.fffffcp-1f, 0.5f, 0x1.000002p-1f, 0x1p-8f, 0x1p-9f, 0x1p-31f})
        rows.push_back({vec4(key)});
    for (size_t i = 0; i < effort.of(40000); ++i) {
        rows.push_back({vec4(random.unit())});
        rows.push_back({vec4(std::exp2(-30.0f * random.unit()) * (0.5f + 0.5f * random.unit()))});
    }
    return rows;
}

double largestKey(double key) {
    return held(key, 0.0, 1.0 - 0x1p-24);
}

const std::string keySweep = "keys 2^-31 to 1, " + everyHalfName;

std::vector<Case> digitCases() {
    const Bound quotient{Unit::roundings, 5.0,
                         "whole digits over 255; open where a rounding decides the code"};
    return {{keySweep, storing("packKey16", encoding, "out0.xy = packKey16(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<2>(held(in[0].x, 0.0, 1.0) * 65535.0, true, 0.005)};
                              }};
             }},
            {keySweep, storing("packKey24", encoding, "out0.xyz = packKey24(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<3>(largestKey(in[0].x) * 16777216.0, true, 0.0)};
                              }};
             }},
            {keySweep, storing("packKey32", encoding, "out0 = packKey32(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<4>(largestKey(in[0].x) * 4294967296.0, false, 0.0)};
                              }};
             }},
            {keySweep + ", through 8-bit channels",
             storing("unpackKey16", encoding,
                     "out0.x = unpackKey16(storedUnorm8(float4(packKey16(in0.x), 0.0, 0.0)).xy);"),
             {Unit::absolute, 0.5 / 65535.0 + 8.0 * roundoff, "half a code"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(held(in[0].x, 0.0, 1.0))}; }};
             }},
            {keySweep + ", through 8-bit channels",
             storing("unpackKey24", encoding,
                     "out0.x = unpackKey24(storedUnorm8(float4(packKey24(in0.x), 0.0)).xyz);"),
             {Unit::absolute, 0x1p-25, "half a code; exact from 1/2 on"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(largestKey(in[0].x))}; }};
             }},
            {keySweep + ", through 8-bit channels",
             storing("unpackKey32", encoding, "out0.x = unpackKey32(storedUnorm8(packKey32(in0.x)));"),
             {Unit::absolute, 0x1p-32, "a code; exact from 2^-9 on"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(largestKey(in[0].x))}; }};
             }},
            {"every digit",
             storing("channelsFromDigits", encoding, "out0 = channelsFromDigits(in0);"),
             {Unit::roundings, 5.0, "a division"},
             [](const Effort&) {
                 std::vector<Row> rows;
                 for (int digit = 0; digit < 256; ++digit)
                     rows.push_back({vec4(digit, 255 - digit, digit ^ 85, digit / 2)});
                 return Sweep{rows, [](const Row& in) {
                                  const dvec4 value = dvec4(in[0]) / 255.0;
                                  return std::vector{Right{value, value, 4}};
                              }};
             }},
            {everyHalfName,
             storing("digitsFromChannels", encoding, "out0 = digitsFromChannels(in0);"),
             {Unit::exact, 0.0, "whole numbers; open within a rounding of half a digit"},
             [](const Effort&) {
                 return Sweep{halfRows(3), [](const Row& in) {
                                  Right made;
                                  for (int c = 0; c < 4; ++c) {
                                      const double digit = held(in[0][c], 0.0, 1.0) * 255.0;
                                      made.value[c] = std::floor(digit + 0.5);
                                      if (std::abs(digit - std::floor(digit) - 0.5) < 1e-4)
                                          made.size[c] = unbounded;
                                  }
                                  return std::vector{made};
                              }};
             }}};
}

Case anyKey() {
    return {
        everyHalfName + " as depth, ends and channels",
        storing(
            "depthFromLogarithmicKey", encoding,
            "out0 = float4(linearKeyFromDepth(in0.x, in0.y, in0.w), depthFromLinearKey(in0.x, 0.1, 100.0),\n"
            "              logarithmicKeyFromDepth(in0.x, 0.1, 100.0), depthFromLogarithmicKey(in0.x, 0.1, "
            "100.0));\n"
            "out0.x = abs(in0.y) < 1e30 && abs(in0.w) < 1e30 ? out0.x : 0.0;\n"
            "out1 = float4(unpackKey16(in0.xy), unpackKey24(in0.xyw), unpackKey32(in0), 0.0);",
            1, 2),
        {Unit::finite, 0.0, "a depth or a key, whichever"},
        [](const Effort&) {
            return Sweep{halfRows(4), [](const Row&) { return std::vector{open(4), open(4)}; }};
        }};
}

} // namespace

std::vector<Case> depthEncodingCases() {
    std::vector<Case> all{clamps()};
    for (const auto& more : {keys(), digitCases(), std::vector{anyKey()}})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
