// SPDX-License-Identifier: Apache-2.0
// occlusion_depth_packing.hlsli and occlusion_shadow_packing.hlsli.
#include "cases.hpp"
#include "few_bits.hpp"

namespace check {
namespace {

using oracle::held;

const std::string occlusionDepth = "reprise/occlusion_depth_packing.hlsli",
                  occlusionShadow = "reprise/occlusion_shadow_packing.hlsli";

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

// The fine form: occlusion to a step of 4080 whatever the noise, whole frames to 15.
std::vector<Right> fineOcclusionDepthBack(const Row& in) {
    const double far = in[0].w, frames = held(in[0].z, 0.0, 15.0);
    const bool between = std::abs(frames - std::floor(frames) - 0.5) < 1e-3;
    return {{dvec4(held(in[0].x, 0.0, 1.0), held(in[0].y, 0.0, far), std::floor(frames + 0.5), 0.0),
             dvec4(1.0 / 4080.0 + 8.0 * roundoff, far * (1.0 / 131070.0 + 2.0 * divisionError),
                   between ? unbounded : 0.0, 0.0) /
                 roundoff,
             3}};
}

std::vector<Case> fineOcclusionDepthCases() {
    const std::string sweep = everyHalfName + ", far 1 to 1e7 m, noise 0 to 1";
    // Noise by the occlusion's own digits: any.
    const std::string noise = "float noise = frac(in0.x * 977.0);\n";
    return {{sweep + ", through RGBA8",
             storing("packFineOcclusionDepth", occlusionDepth,
                     filled + noise +
                         "OcclusionDepth back = unpackFineOcclusionDepth(storedUnorm8("
                         "packFineOcclusionDepth(data, in0.w, noise)), in0.w);\n"
                         "out0.xyz = float3(back.occlusion, back.linearDepth, back.convergence);"),
             {Unit::roundings, 1.0, "a step of 4080, half a code of 65535, whole frames"},
             [](const Effort& effort) {
                 return Sweep{occlusionDepths(effort), fineOcclusionDepthBack};
             }},
            {everyHalfName + " as texel",
             storing("unpackFineOcclusionDepth", occlusionDepth,
                     "OcclusionDepth back = unpackFineOcclusionDepth(in0, 100.0);\n"
                     "out0.xyz = float3(back.occlusion, back.linearDepth, back.convergence);"),
             {Unit::finite, 0.0, "what no packing wrote"},
             [](const Effort&) {
                 return Sweep{halfRows(7), [](const Row&) { return std::vector{open(3)}; }};
             }}};
}

std::vector<Case> occlusionDepthCases() {
    const std::string sweep = everyHalfName + ", far 1 to 1e7 m";
    return {
        {sweep,
         storing("packOcclusionDepth", occlusionDepth, filled + "out0 = packOcclusionDepth(data, in0.w);"),
         {Unit::roundings, 6.0, "a division each; open where a rounding decides the code of depth"},
         [](const Effort& effort) {
             return Sweep{occlusionDepths(effort), occlusionDepthOracle};
         }},
        {sweep + ", through RGBA8",
         storing("unpackOcclusionDepth", occlusionDepth,
                 filled + "OcclusionDepth back = unpackOcclusionDepth(storedUnorm8(packOcclusionDepth(data, "
                          "in0.w)), in0.w);\n"
                          "out0.xyz = float3(back.occlusion, back.linearDepth, back.convergence);"),
         {Unit::roundings, 1.0, "half a level of 255, half a code of 65535, whole frames"},
         [](const Effort& effort) {
             return Sweep{occlusionDepths(effort), occlusionDepthBack};
         }},
        {everyHalfName + " as texel",
         storing("unpackOcclusionDepth", occlusionDepth,
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
            storing(function, occlusionShadow, "out0.x = " + function + "(in0.x, in0.y);"),
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
              storing(function, occlusionShadow, "out0.xy = " + function + "(in0.x);"),
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

Case sumOfPairs() {
    return {everyHalfName + " four times, shares 1/4",
            storing("sumOfUnitPairs", occlusionShadow, "out0.xy = sumOfUnitPairs(in0, 0.25);"),
            {Unit::roundings, 8.0, "a sum of four below 32, over its range"},
            [](const Effort&) {
                return Sweep{halfRows(7), [](const Row& in) {
                                 dvec2 sum(0.0);
                                 for (int c = 0; c < 4; ++c)
                                     sum += 0.25 * unpacked(in[0][c]);
                                 return std::vector{right(sum, 1.0)};
                             }};
            }};
}

// Every whole number that a packing writes, thinned, and what it does not.
std::vector<Case> withFrames() {
    const std::string unpack = "VisibilitiesOfFour four = unpackWithFrames(in0.xxxx);\n";
    Case back{"[0, 1]² and all else, frames -1 to 20, and back",
              storing("packWithFrames", occlusionShadow,
                      "VisibilitiesOfFour four = unpackWithFrames(packWithFrames(in0.xy, in0.z).xxxx);\n"
                      "out0.xyz = float3(four.occlusion.x, four.shadow.x, four.frames.x);"),
              {Unit::roundings, 1.0, "half of 1/1023, half a frame"},
              [](const Effort& effort) {
                  Random random(17);
                  std::vector<Row> rows = pairs();
                  rows.resize(std::min(rows.size(), effort.of(rows.size())));
                  for (Row& row : rows)
                      row[0].z = random.in(-1.0f, 20.0f);
                  return Sweep{rows, [](const Row& in) {
                                   const double size = 0.5 / 1023.0 + 4.0 * roundoff;
                                   return std::vector{
                                       Right{dvec4(held(in[0].x, 0.0, 1.0), held(in[0].y, 0.0, 1.0),
                                                   held(in[0].z, 0.0, 15.0), 0.0),
                                             dvec4(size, size, 0.5, 0.0) / roundoff, 3}};
                               }};
              }};
    Case any{everyHalfName + " as texel",
             storing("unpackWithFrames", occlusionShadow,
                     unpack + "out0.xyz = float3(four.occlusion.x, four.shadow.x, four.frames.x);"),
             {Unit::finite, 0.0, "what no packing wrote"},
             [](const Effort&) {
                 return Sweep{justHalves(), [](const Row&) { return std::vector{open(3)}; }};
             }};
    return {back, any};
}

// Both through binary16, to nearest: half a level of 31, half a step of the fraction at 16 and above.
Case throughHalf(const std::string& pack, const std::string& unpack, bool occlusionIsWhole) {
    Case made{
        "[0, 1]² and all else, through binary16",
        storing(unpack, occlusionShadow, "out0.xy = " + unpack + "(storedHalf(" + pack + "(in0.x, in0.y)));"),
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
             storing("PackOccShadow", occlusionShadow, "out0.x = PackOccShadow(in0.x, in0.y);"),
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
             storing("UnpackOccShadow", occlusionShadow, "out0.xy = UnpackOccShadow(in0.x);"),
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
    std::vector<Case> all;
    for (const auto& more : {occlusionDepthCases(), fineOcclusionDepthCases(), listing74(), withFrames()})
        all.insert(all.end(), more.begin(), more.end());
    all.push_back(packing("packUnitPair", false));
    all.push_back(packing("packOcclusionInInteger", false));
    all.push_back(packing("packShadowInInteger", true));
    all.push_back(unpacking("unpackUnitPair", false));
    all.push_back(unpacking("unpackOcclusionInInteger", false));
    all.push_back(unpacking("unpackShadowInInteger", true));
    all.push_back(sumOfPairs());
    all.push_back(throughHalf("packOcclusionInInteger", "unpackOcclusionInInteger", true));
    all.push_back(throughHalf("packShadowInInteger", "unpackShadowInInteger", false));
    return all;
}

} // namespace check
