// SPDX-License-Identifier: Apache-2.0
// depth_encoding.hlsli, occlusion_depth_packing.hlsli, occlusion_shadow_packing.hlsli and bounded.hlsli.
#include "cases.hpp"
#include "harness.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string encoding = "reprise/depth_encoding.hlsli",
                  occlusionDepth = "reprise/occlusion_depth_packing.hlsli",
                  occlusionShadow = "reprise/occlusion_shadow_packing.hlsli",
                  boundedHeader = "reprise/bounded.hlsli";

using oracle::held;

// Every bit pattern, NaN, infinities and negatives among them.
std::vector<float> everyHalf() {
    std::vector<float> values;
    for (uint32_t bits = 0; bits < 65536; ++bits)
        values.push_back(harness::halfToFloat(static_cast<uint16_t>(bits)));
    return values;
}

// Two others at random beside each.
std::vector<Row> halfRows(uint32_t seed) {
    const std::vector<float> halves = everyHalf();
    Random random(seed);
    std::vector<Row> rows;
    for (float half : halves)
        rows.push_back({vec4(half, random.of(halves), random.unit(), random.of(halves))});
    return rows;
}

std::vector<Row> justHalves() {
    std::vector<Row> rows;
    for (float half : everyHalf())
        rows.push_back({vec4(half)});
    return rows;
}

const std::string everyHalfName = "every binary16";

// What a store to nearest makes of a value from 2^-14 on, and of channels of 8 bits.
const std::string stores =
    "float storedHalf(float v) {\n"
    "    uint bits = asuint(v);\n"
    "    return v < 0.00006103515625 ? floor(v * 16777216.0 + 0.5) / 16777216.0\n"
    "                                : asfloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);\n"
    "}\n"
    "float4 storedUnorm8(float4 v) { return floor(saturate(v) * 255.0 + 0.5) / 255.0; }\n";

functions::Function call(const std::string& name, const std::string& header, const std::string& body,
                         int inputs = 1, int outputs = 1) {
    functions::Function made{name, {header}, body, inputs, outputs};
    made.helpers = stores;
    return made;
}

// --- a clamp that NaN does not pass

Case clamps() {
    return {"to ±1e30, NaN and infinity too",
            call("bounded", boundedHeader,
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
         call("linearKeyFromDepth", encoding, "out0.x = linearKeyFromDepth(in0.x, in0.y, in0.z);"),
         {Unit::roundings, 5.0, "two differences at far, in relation to the range, and a division"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              const double range2 = static_cast<double>(in[0].z) - in[0].y;
                              return std::vector{right(oracle::linearKey(in[0].x, in[0].y, in[0].z),
                                                       1.0 + in[0].z / range2)};
                          }};
         }},
        {range + ", there and back",
         call("depthFromLinearKey", encoding,
              "out0.x = depthFromLinearKey(linearKeyFromDepth(in0.x, in0.y, in0.z), in0.y, in0.z);"),
         {Unit::roundings, 10.0, "both ways at far"},
         [](const Effort& effort) {
             return Sweep{depths(effort),
                          [](const Row& in) { return std::vector{right(heldDepth(in), in[0].z)}; }};
         }},
        {range,
         call("logarithmicEnds", encoding, "out0.xy = logarithmicEnds(in0.y, in0.z);"),
         {Unit::roundings, 1.0, "what Vulkan allows log2, and a division"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              return std::vector{Right{dvec4(in[0].y, octavesOf(in), 0, 0),
                                                       dvec4(0.0, logarithmError(in) / roundoff, 0, 0), 2}};
                          }};
         }},
        {range,
         call("logarithmicKeyFromDepth", encoding, "out0.x = logarithmicKeyFromDepth(in0.x, in0.y, in0.z);"),
         {Unit::roundings, 1.0, "what Vulkan allows two log2, and divisions, over the octaves"},
         [](const Effort& effort) {
             return Sweep{depths(effort), [](const Row& in) {
                              const double size = 2.0 * logarithmError(in) / octavesOf(in) + divisionError;
                              return std::vector{
                                  right(oracle::logarithmicKey(in[0].x, in[0].y, in[0].z), size / roundoff)};
                          }};
         }},
        {range + ", there and back",
         call(
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

// Digits over 255; half a code away from the next, rounding decides.
template <size_t Count> Right digitsRight(double scaled, bool rounds, double slack) {
    const double above = scaled - std::floor(scaled);
    if (rounds && std::abs(above - 0.5) < slack) return open(static_cast<int>(Count));
    const auto digits =
        oracle::digits<Count>(static_cast<uint64_t>(std::floor(scaled + (rounds ? 0.5 : 0.0))));
    Right made;
    made.components = static_cast<int>(Count);
    for (size_t i = 0; i < Count; ++i)
        made.value[static_cast<int>(i)] = made.size[static_cast<int>(i)] = digits[i] / 255.0;
    return made;
}

double largestKey(double key) {
    return held(key, 0.0, 1.0 - 0x1p-24);
}

const std::string keySweep = "keys 2^-31 to 1, " + everyHalfName;

std::vector<Case> digitCases() {
    const Bound quotient{Unit::roundings, 5.0,
                         "whole digits over 255; open where a rounding decides the code"};
    return {{keySweep, call("packKey16", encoding, "out0.xy = packKey16(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<2>(held(in[0].x, 0.0, 1.0) * 65535.0, true, 0.005)};
                              }};
             }},
            {keySweep, call("packKey24", encoding, "out0.xyz = packKey24(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<3>(largestKey(in[0].x) * 16777216.0, true, 0.0)};
                              }};
             }},
            {keySweep, call("packKey32", encoding, "out0 = packKey32(in0.x);"), quotient,
             [](const Effort& effort) {
                 return Sweep{keyRows(effort), [](const Row& in) {
                                  return std::vector{
                                      digitsRight<4>(largestKey(in[0].x) * 4294967296.0, false, 0.0)};
                              }};
             }},
            {keySweep + ", through 8-bit channels",
             call("unpackKey16", encoding,
                  "out0.x = unpackKey16(storedUnorm8(float4(packKey16(in0.x), 0.0, 0.0)).xy);"),
             {Unit::absolute, 0.5 / 65535.0 + 8.0 * roundoff, "half a code"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(held(in[0].x, 0.0, 1.0))}; }};
             }},
            {keySweep + ", through 8-bit channels",
             call("unpackKey24", encoding,
                  "out0.x = unpackKey24(storedUnorm8(float4(packKey24(in0.x), 0.0)).xyz);"),
             {Unit::absolute, 0x1p-25, "half a code; exact from 1/2 on"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(largestKey(in[0].x))}; }};
             }},
            {keySweep + ", through 8-bit channels",
             call("unpackKey32", encoding, "out0.x = unpackKey32(storedUnorm8(packKey32(in0.x)));"),
             {Unit::absolute, 0x1p-32, "a code; exact from 2^-9 on"},
             [](const Effort& effort) {
                 return Sweep{keyRows(effort),
                              [](const Row& in) { return std::vector{right(largestKey(in[0].x))}; }};
             }},
            {"every digit",
             call("channelsFromDigits", encoding, "out0 = channelsFromDigits(in0);"),
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
             call("digitsFromChannels", encoding, "out0 = digitsFromChannels(in0);"),
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
        call("depthFromLogarithmicKey", encoding,
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

// --- occlusion and depth in RGBA8

const std::string filled = "OcclusionDepth data; data.occlusion = in0.x; data.linearDepth = in0.y;\n"
                           "data.convergence = in0.z;\n";

// occlusion, depth, convergence, far
std::vector<Row> occlusionDepths(const Effort& effort) {
    Random random(5);
    std::vector<Row> rows;
    for (const Row& half : halfRows(6)) {
        const float far = std::exp2(random.in(0.0f, 23.2f));
        rows.push_back({vec4(half[0].x, half[0].y, half[0].w, far)});
    }
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float far = std::exp2(random.in(0.0f, 23.2f));
        rows.push_back({vec4(random.in(-0.2f, 1.2f), far * random.in(-0.1f, 1.2f),
                             std::floor(random.in(0.0f, 300.0f)), far)});
    }
    return rows;
}

std::vector<Right> occlusionDepthOracle(const Row& in) {
    const double key = held(in[0].y / static_cast<double>(in[0].w), 0.0, 1.0);
    const Right digits = digitsRight<2>(key * 65535.0, true, 0.05);
    const double occlusion = held(in[0].x, 0.0, 1.0), frames = held(in[0].z, 0.0, 255.0) / 255.0;
    return {{dvec4(occlusion, digits.value.x, digits.value.y, frames),
             dvec4(occlusion, digits.size.x, digits.size.y, frames), 4}};
}

// As a row of one kind after the other: occlusion to half a level, depth to half a code, whole frames.
std::vector<Right> occlusionDepthBack(const Row& in) {
    const double far = in[0].w, frames = held(in[0].z, 0.0, 255.0);
    const bool between = std::abs(frames - std::floor(frames) - 0.5) < 1e-3;
    return {{dvec4(held(in[0].x, 0.0, 1.0), held(in[0].y, 0.0, far), std::floor(frames + 0.5), 0.0),
             dvec4(1.0 / 510.0 + 4.0 * roundoff, far * (1.0 / 131070.0 + 2.0 * divisionError),
                   between ? unbounded : 0.0, 0.0) /
                 roundoff,
             3}};
}

std::vector<Case> occlusionDepthCases() {
    const std::string sweep = everyHalfName + ", far 1 to 1e7 m";
    return {{sweep,
             call("packOcclusionDepth", occlusionDepth, filled + "out0 = packOcclusionDepth(data, in0.w);"),
             {Unit::roundings, 6.0, "a division each; open where a rounding decides the code of depth"},
             [](const Effort& effort) {
                 return Sweep{occlusionDepths(effort), occlusionDepthOracle};
             }},
            {sweep + ", through RGBA8",
             call("unpackOcclusionDepth", occlusionDepth,
                  filled + "OcclusionDepth back = unpackOcclusionDepth(storedUnorm8(packOcclusionDepth(data, "
                           "in0.w)), in0.w);\n"
                           "out0.xyz = float3(back.occlusion, back.linearDepth, back.convergence);"),
             {Unit::roundings, 1.0, "half a level of 255, half a code of 65535, whole frames"},
             [](const Effort& effort) {
                 return Sweep{occlusionDepths(effort), occlusionDepthBack};
             }},
            {everyHalfName + " as texel",
             call("unpackOcclusionDepth", occlusionDepth,
                  "OcclusionDepth back = unpackOcclusionDepth(in0, 100.0);\n"
                  "out0.xyz = float3(back.occlusion, back.linearDepth, back.convergence);"),
             {Unit::finite, 0.0, "what no packing wrote"},
             [](const Effort&) {
                 return Sweep{halfRows(7), [](const Row&) { return std::vector{open(3)}; }};
             }}};
}

// --- occlusion and shadow in one binary16

// Over [0, 1]²: every level of the integer part and between, and every binary16 in one of both.
std::vector<Row> pairs() {
    std::vector<Row> rows;
    for (int i = 0; i <= 248; ++i)
        for (int k = 0; k <= 252; ++k)
            rows.push_back(
                {vec4(static_cast<float>(i) / 248.0f, static_cast<float>(k) / 252.0f, 0.0f, 0.0f)});
    for (const Row& half : halfRows(8))
        rows.push_back({vec4(half[0].x, half[0].z, 0.0f, 0.0f)});
    for (const Row& half : halfRows(9))
        rows.push_back({vec4(half[0].z, half[0].x, 0.0f, 0.0f)});
    return rows;
}

// The integer part may fall to either side where the product is rounded onto a half.
Right packedRight(double whole, double part) {
    const double level = held(whole, 0.0, 1.0) * 31.0;
    if (std::abs(level - std::floor(level) - 0.5) < 1e-5) return open(1);
    return right(oracle::packPair(whole, part), 32.0);
}

// What either part of an unpacked number is, for what no packing wrote too.
dvec2 unpacked(double packed) {
    const double known = held(packed, 0.0, 31.984375), integer = std::floor(known);
    return {integer / 31.0, std::min((known - integer) / 0.984375, 1.0)};
}

Case packing(const std::string& function, bool swaps) {
    return {"[0, 1]², " + everyHalfName,
            call(function, occlusionShadow, "out0.x = " + function + "(in0.x, in0.y);"),
            {Unit::roundings, 2.0, "a product and a sum at 32; open where a rounding decides the level"},
            [swaps](const Effort&) {
                return Sweep{pairs(), [swaps](const Row& in) {
                                 return std::vector{swaps ? packedRight(in[0].y, in[0].x)
                                                          : packedRight(in[0].x, in[0].y)};
                             }};
            }};
}

Case unpacking(const std::string& function, bool swaps) {
    Case made{everyHalfName,
              call(function, occlusionShadow, "out0.xy = " + function + "(in0.x);"),
              {Unit::roundings, 6.0, "a division below 1"},
              [swaps](const Effort&) {
                  return Sweep{justHalves(), [swaps](const Row& in) {
                                   const dvec2 pair = unpacked(in[0].x);
                                   return std::vector{right(swaps ? dvec2(pair.y, pair.x) : pair, 1.0)};
                               }};
              }};
    made.printed = {"Listing 7.4, UnpackOccShadow", "out0.xy = float2(floor(in0.x) / 31.0, frac(in0.x));",
                    ""};
    return made;
}

// Both through binary16, to nearest: half a level of 31, half a step of the fraction at 16 and above.
Case throughHalf(const std::string& pack, const std::string& unpack, bool occlusionIsWhole) {
    Case made{
        "[0, 1]² and all else, through binary16",
        call(unpack, occlusionShadow, "out0.xy = " + unpack + "(storedHalf(" + pack + "(in0.x, in0.y)));"),
        {Unit::roundings, 1.0, "half of 1/31 in the integer part, half of 1/63 in the fraction"},
        [occlusionIsWhole](const Effort&) {
            return Sweep{pairs(), [occlusionIsWhole](const Row& in) {
                             const dvec2 sizes(1.0 / 62.0 + 4.0 * roundoff, 1.0 / 126.0 + 64.0 * roundoff);
                             const dvec2 size = occlusionIsWhole ? sizes : dvec2(sizes.y, sizes.x);
                             return std::vector{
                                 Right{dvec4(held(in[0].x, 0.0, 1.0), held(in[0].y, 0.0, 1.0), 0.0, 0.0),
                                       dvec4(size, 0.0, 0.0) / roundoff, 2}};
                         }};
        }};
    made.printed = {"Listing 7.4",
                    "float p = storedHalf(floor(saturate(in0.x) * 31.0) + clamp(in0.y, 0.01, 0.99));\n"
                    "out0.xy = float2(floor(p) / 31.0, frac(p));",
                    ""};
    return made;
}

// The listing's own names: rounded down, the fraction held away from its ends.
std::vector<Case> listing74() {
    return {{"[0, 1]², " + everyHalfName,
             call("PackOccShadow", occlusionShadow, "out0.x = PackOccShadow(in0.x, in0.y);"),
             {Unit::roundings, 2.0, "a product and a sum at 32; open where a rounding decides the level"},
             [](const Effort&) {
                 return Sweep{
                     pairs(), [](const Row& in) {
                         const double level = held(in[0].x, 0.0, 1.0) * 31.0;
                         if (std::abs(level - std::round(level)) < 1e-5 && level != std::round(level))
                             return std::vector{open(1)};
                         return std::vector{right(std::floor(level) + held(in[0].y, 0.01, 0.99), 32.0)};
                     }};
             }},
            {everyHalfName,
             call("UnpackOccShadow", occlusionShadow, "out0.xy = UnpackOccShadow(in0.x);"),
             {Unit::roundings, 64.0, "a division below 1, and the end at 31.99"},
             [](const Effort&) {
                 return Sweep{
                     justHalves(), [](const Row& in) {
                         const double known = held(in[0].x, 0.0, 31.99);
                         return std::vector{right(
                             dvec2(std::min(std::floor(known) / 31.0, 1.0), known - std::floor(known)), 1.0)};
                     }};
             }}};
}

} // namespace

std::vector<Case> packingCases() {
    std::vector<Case> all{clamps()};
    for (const auto& more : {keys(), digitCases(), std::vector{anyKey()}, occlusionDepthCases(), listing74()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(packing("packUnitPair", false));
    all.push_back(packing("packOcclusionInInteger", false));
    all.push_back(packing("packShadowInInteger", true));
    all.push_back(unpacking("unpackUnitPair", false));
    all.push_back(unpacking("unpackOcclusionInInteger", false));
    all.push_back(unpacking("unpackShadowInInteger", true));
    all.push_back(throughHalf("packOcclusionInInteger", "unpackOcclusionInInteger", true));
    all.push_back(throughHalf("packShadowInInteger", "unpackShadowInInteger", false));
    return all;
}

} // namespace check
