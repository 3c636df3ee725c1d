// SPDX-License-Identifier: Apache-2.0
#include "cache_pass.hpp"
#include "function_runner.hpp"
#include "inputs.hpp"
#include "measured.hpp"

#include "harness.hpp"

#include <gtest/gtest.h>

#include <set>

namespace functions {
namespace {

const std::string header = "reprise/occlusion_shadow_packing.hlsli";

// binary16 as a store leaves it: to nearest, and truncated (positive values: the bits below the mantissa
// off).
const std::string nearest = "f16tof32(f32tof16(packed))";
const std::string truncated = "asfloat(asuint(packed) & 0xFFFFE000u)";

// occlusion, shadow over [0, 1] with both ends and what lies outside
std::vector<Row> pairs() {
    std::vector<Row> rows;
    for (int i = 0; i <= 248; ++i) // 1/248: every level of the integer part, and between
        for (int k = 0; k <= 252; ++k)
            rows.push_back(
                {vec4(static_cast<float>(i) / 248.0f, static_cast<float>(k) / 252.0f, 0.0f, 0.0f)});
    for (float a : {-1.0f, 2.0f, 1e30f, denormal, notANumber})
        for (float b : {-1.0f, 0.5f, 2.0f, notANumber})
            rows.push_back({vec4(a, b, 0.0f, 0.0f)});
    return rows;
}

Function roundTripOf(const std::string& pack, const std::string& store, const std::string& unpack) {
    return {pack + " and back",
            {header},
            "float packed = " + pack + "(in0.x, in0.y); packed = " + store + "; out0.xy = " + unpack +
                "(packed);"};
}

const Function listingOrder = roundTripOf("packOcclusionInInteger", nearest, "unpackOcclusionInInteger");
const Function textOrder = roundTripOf("packShadowInInteger", nearest, "unpackShadowInInteger");

// Half a level of the integer part, half a step of the fraction at 16 and above; and roundings up to 32
// and 1.
const double wholeBound = 1.0 / 62.0 + 4.0 * roundoff;
const double partBound = 1.0 / 126.0 + 64.0 * roundoff;

Comparison roundTrip(const Function& function, bool occlusionIsWhole, double whole = wholeBound,
                     double part = partBound) {
    return {function, pairs(), [=](const Row& in) {
                Expected expected =
                    near(dvec2(oracle::held(in[0].x, 0.0, 1.0), oracle::held(in[0].y, 0.0, 1.0)),
                         occlusionIsWhole ? whole : part);
                expected.bound.y = occlusionIsWhole ? part : whole;
                return std::vector{expected};
            }};
}

TEST(OcclusionShadowPacking, bothOrdersSurviveBinary16) {
    expectAgrees(roundTrip(listingOrder, true));
    expectAgrees(roundTrip(textOrder, false));
}

// A store that truncates costs a whole step of the fraction, and never the integer part.
TEST(OcclusionShadowPacking, bothOrdersSurviveAStoreThatTruncates) {
    expectAgrees(roundTrip(roundTripOf("packOcclusionInInteger", truncated, "unpackOcclusionInInteger"), true,
                           wholeBound, 2.0 * partBound));
    expectAgrees(roundTrip(roundTripOf("packShadowInInteger", truncated, "unpackShadowInInteger"), false,
                           wholeBound, 2.0 * partBound));
}

// The levels that the oracle packs, before any store.
TEST(OcclusionShadowPacking, packedNumberIsTheOracles) {
    expectAgrees(
        {{"packUnitPair", {header}, "out0.x = packUnitPair(in0.x, in0.y);"}, pairs(), [](const Row& in) {
             // The integer part may fall to either side where the product is rounded onto a half.
             const double value = static_cast<double>(in[0].x) * 31.0;
             const bool between = std::abs(value - std::floor(value) - 0.5) < 1e-5;
             return std::vector{
                 near(oracle::packPair(in[0].x, in[0].y), (between ? 1.0 : 0.0) + 64.0 * roundoff)};
         }});
}

dvec2 unpacked(double packed) {
    const double known = oracle::held(packed, 0.0, 31.984375), integer = std::floor(known);
    return {integer / 31.0, std::min((known - integer) / 0.984375, 1.0)};
}

// Of four numbers, whatever they are.
TEST(OcclusionShadowPacking, sumIsThatOfEachUnpacked) {
    Random random(31);
    const float hostile[] = {-1.0f, 1e30f, denormal, notANumber, 31.99f, 0.999f, 32.0f};
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i) {
        vec4 packed, shares;
        for (int c = 0; c < 4; ++c) {
            packed[c] = random.in(0.0f, 31.984375f);
            shares[c] = random.in(0.0f, 0.25f);
        }
        if (i % 4 == 0) packed[i / 4 % 4] = hostile[i / 16 % 7];
        rows.push_back({packed, shares});
    }
    const Comparison sum{
        {"sumOfUnitPairs", {header}, "out0.xy = sumOfUnitPairs(in0, in1);", 2, 1}, rows, [](const Row& in) {
            dvec2 expected(0.0);
            for (int c = 0; c < 4; ++c)
                expected += double(in[1][c]) * unpacked(in[0][c]);
            // Eight roundings at most, of what is at most 1 over its range.
            return std::vector{near(expected, 8.0 * roundoff)};
        }};
    expectAgrees(sum);
    expectCaught(sum, {header, "float4 integers = floor(known);", "float4 integers = floor(known.x);"});
    expectCaught(sum, {header, "min(known - integers, PACK_FRACTION)", "known - integers"});
}

// --- With frames

// occlusion, shadow, frames
std::vector<Row> withFrames() {
    Random random(32);
    std::vector<Row> rows;
    for (int i = 0; i <= 1023; ++i)
        for (int frames = 0; frames <= 15; ++frames)
            rows.push_back({vec4(static_cast<float>(i) / 1023.0f, static_cast<float>(1023 - i) / 1023.0f,
                                 static_cast<float>(frames), 0.0f)});
    for (int i = 0; i < 20000; ++i)
        rows.push_back({vec4(random.in(-0.1f, 1.1f), random.in(-0.1f, 1.1f), random.in(-1.0f, 20.0f), 0.0f)});
    for (const float value : {-1.0f, 1e30f, denormal, infinity, -infinity, notANumber})
        for (int c = 0; c < 3; ++c) {
            vec4 in(0.5f, 0.25f, 7.0f, 0.0f);
            in[c] = value;
            rows.push_back({in});
        }
    return rows;
}

// Half a level and half a frame, and roundings.
Comparison framesRoundTrip() {
    return {{"packWithFrames and back",
             {header},
             "VisibilitiesOfFour four = unpackWithFrames(packWithFrames(in0.xy, in0.z).xxxx);\n"
             "out0 = float4(four.occlusion.x, four.shadow.y, four.frames.z, four.usable.w);"},
            withFrames(),
            [](const Row& in) {
                Expected expected =
                    near(dvec4(oracle::held(in[0].x, 0.0, 1.0), oracle::held(in[0].y, 0.0, 1.0),
                               oracle::held(in[0].z, 0.0, 15.0), 1.0),
                         0.5 / 1023.0 + 4.0 * roundoff);
                expected.bound.z = 0.5;
                expected.bound.w = 0.0;
                return std::vector{expected};
            }};
}

TEST(OcclusionShadowPacking, valuesAndFramesComeBack) {
    expectAgrees(framesRoundTrip());
    expectCaught(framesRoundTrip(), {header, "* 1024.0 + levels.x) * 1024.0 + levels.y",
                                     "* 1024.0 + levels.y) * 1024.0 + levels.x"});
    expectCaught(framesRoundTrip(), {header, "MAX_PACKED_FRAMES = 15.0", "MAX_PACKED_FRAMES = 16.0"});
    expectCaught(framesRoundTrip(), {header, "UNIT_STEPS + 0.5)", "UNIT_STEPS)"});
    expectCaught(framesRoundTrip(), {header, "MAX_PACKED_FRAMES) + 0.5)", "MAX_PACKED_FRAMES))"});
}

// Four numbers, whatever they are: what no packing wrote is not usable and holds 0.
TEST(OcclusionShadowPacking, fourNumbersAreUnpackedEachByItself) {
    Random random(33);
    const float hostile[] = {-1.0f, 0x1p24f, 1e30f, infinity, -infinity, notANumber, 0x1p24f - 1.0f, 0.5f};
    std::vector<Row> rows;
    for (int i = 0; i < 4000; ++i) {
        vec4 packed;
        for (int c = 0; c < 4; ++c)
            packed[c] = i % 3 == 0 ? random.of(hostile) : std::floor(random.in(0.0f, 0x1p24f));
        rows.push_back({packed});
    }
    const Comparison four{
        {"unpackWithFrames",
         {header},
         "VisibilitiesOfFour four = unpackWithFrames(in0);\n"
         "out0 = four.occlusion; out1 = four.shadow; out2 = four.frames; out3 = four.usable;",
         1,
         4},
        rows,
        [](const Row& in) {
            dvec4 occlusion, shadow, frames, usable;
            for (int c = 0; c < 4; ++c) {
                const dvec3 held = oracle::unpackedWithFrames(in[0][c]);
                usable[c] = held.x == held.x;
                occlusion[c] = usable[c] > 0.0 ? held.x : 0.0;
                shadow[c] = usable[c] > 0.0 ? held.y : 0.0;
                frames[c] = usable[c] > 0.0 ? held.z : 0.0;
            }
            return std::vector{near(occlusion, 4.0 * roundoff), near(shadow, 4.0 * roundoff),
                               near(frames, 0.0), near(usable, 0.0)};
        }};
    expectAgrees(four);
    expectCaught(four, {header, "packed < 16777216.0 ? 1.0 : 0.0", "packed < 33554432.0 ? 1.0 : 0.0"});
    expectCaught(four, {header, "four.usable > 0.5 ? packed : 0.0", "packed"});
    expectCaught(four, {header, "min((both - level * 1024.0) * (1.0 / UNIT_STEPS), 1.0)",
                        "(both - level * 1024.0) * (1.0 / 1024.0)"});
}

TEST(OcclusionShadowPacking, wrongPackingsAreCaught) {
    const Comparison right = roundTrip(listingOrder, true);
    expectCaught(right, {header, "float2(integer * (1.0 / PACK_RANGE)",
                         "float2(known * (1.0 / PACK_RANGE)"}); // the fraction stays in the integer
    expectCaught(right, {header, "(known - integer) * (1.0 / PACK_FRACTION)", "known - integer"});
    expectCaught(right,
                 {header, "bounded(part, 0.0, 1.0) * PACK_FRACTION", "bounded(part, 0.0, 1.0)"}); // 1 carries
    expectCaught(roundTrip(textOrder, false),
                 {header, "unpackUnitPair(packed).yx", "unpackUnitPair(packed)"});
    expectCaught(roundTrip(textOrder, false),
                 {header, "packUnitPair(shadow, occlusion)", "packUnitPair(occlusion, shadow)"});
}

// Text: "the fractional part ... is used for occlusion". Listing: the integer part is.
TEST(OcclusionShadowPacking, thePrintedOrderAgainstTheTextIsCaught) {
    const Comparison byTheText = roundTrip(textOrder, false);
    EXPECT_EQ(mismatches(byTheText), "");
    Comparison printed = byTheText;
    printed.function = roundTripOf("PackOccShadow", nearest, "unpackShadowInInteger");
    EXPECT_NE(mismatches(printed), "");
    // "Because it requires more variety": how many occlusions come out where shadow is 1.
    std::vector<Row> rows;
    for (int i = 0; i <= 4096; ++i)
        rows.push_back({vec4(static_cast<float>(i) / 4096.0f, 1.0f, 0.0f, 0.0f)});
    const auto levels = [&](const Function& function) {
        std::set<float> values;
        for (const Row& out : run(function, rows))
            values.insert(out[0].x);
        return values.size();
    };
    measured("levels of occlusion at shadow 1, text's order", static_cast<double>(levels(textOrder)));
    measured("levels of occlusion at shadow 1, listing's order", static_cast<double>(levels(listingOrder)));
    EXPECT_EQ(levels(textOrder), 64u);
    EXPECT_EQ(levels(listingOrder), 32u);
}

const Function printed = roundTripOf("PackOccShadow", nearest, "UnpackOccShadow");

TEST(OcclusionShadowPacking, thePrintedFloorIsCaught) {
    Comparison comparison = roundTrip(listingOrder, true);
    expectCaught(comparison, {header, "bounded(whole, 0.0, 1.0) * PACK_RANGE + 0.5",
                              "bounded(whole, 0.0, 1.0) * PACK_RANGE"});
    // The listing itself, whatever its shadow does: a level off instead of half of one.
    comparison.function = printed;
    comparison.oracle = [](const Row& in) {
        return std::vector{near(oracle::held(in[0].x, 0.0, 1.0), wholeBound)};
    };
    EXPECT_NE(mismatches(comparison), "");
}

TEST(OcclusionShadowPacking, thePrintedClampOfTheFractionIsCaught) {
    // No shadow and full shadow are what most of a picture is, and are to come back as they were.
    const auto ends = [](const Function& function) {
        std::vector<Row> rows;
        for (int i = 0; i <= 31; ++i)
            for (float end : {0.0f, 1.0f}) {
                rows.push_back({vec4(static_cast<float>(i) / 31.0f, end, 0.0f, 0.0f)});
                rows.push_back({vec4(end, static_cast<float>(i) / 31.0f, 0.0f, 0.0f)});
            }
        return Comparison{function, rows, [](const Row& in) {
                              const auto bound = [](float v) {
                                  return v == 0.0f || v == 1.0f ? divisionError : wholeBound;
                              };
                              Expected expected = near(dvec2(in[0].x, in[0].y), bound(in[0].x));
                              expected.bound.y = bound(in[0].y);
                              return std::vector{expected};
                          }};
    };
    EXPECT_EQ(mismatches(ends(listingOrder)), "");
    EXPECT_EQ(mismatches(ends(textOrder)), "");
    EXPECT_NE(mismatches(ends(printed)), "");
}

TEST(OcclusionShadowPacking, thePrintedUnpackingWithoutABoundIsCaught) {
    std::vector<Row> rows;
    for (float value : hostileAny)
        rows.push_back({vec4(value)});
    const Comparison right{
        {"UnpackOccShadow", {header}, "out0.xy = UnpackOccShadow(in0.x);"}, rows, [](const Row&) {
            return std::vector{near(dvec2(0.5), 0.5)}; // [0, 1]
        }};
    expectCaught(right, {header, "bounded(OccShadow, 0.0, PACK_RANGE + 1.0 - MIN_FLT)", "OccShadow"});
    expectCaught(right, {header, "float2(min(integer / PACK_RANGE, 1.0), known - integer)",
                         "float2(floor(OccShadow) / PACK_RANGE, frac(OccShadow))"});
}

// What comes back of each part, for every pair and each order.
struct Errors {
    double occlusion = 0.0, shadow = 0.0, occlusionMean = 0.0;
};

Errors errorsOf(const Function& function) {
    std::vector<Row> rows;
    for (int i = 0; i <= 500; ++i)
        for (int k = 0; k <= 252; ++k)
            rows.push_back(
                {vec4(static_cast<float>(i) / 500.0f, static_cast<float>(k) / 252.0f, 0.0f, 0.0f)});
    const auto out = run(function, rows);
    Errors errors;
    for (size_t i = 0; i < rows.size(); ++i) {
        const double occlusion = static_cast<double>(out[i][0].x) - rows[i][0].x;
        errors.occlusion = std::max(errors.occlusion, std::abs(occlusion));
        errors.occlusionMean += occlusion / static_cast<double>(rows.size());
        errors.shadow = std::max(errors.shadow, std::abs(static_cast<double>(out[i][0].y) - rows[i][0].y));
    }
    return errors;
}

void record(const std::string& what, const Errors& errors) {
    measured(what + ", worst error of occlusion", errors.occlusion);
    measured(what + ", mean error of occlusion", errors.occlusionMean);
    measured(what + ", worst error of shadow", errors.shadow);
}

TEST(OcclusionShadowPacking, worstErrorsOverTheWholeRangeAreTheStatedOnes) {
    const Errors listing = errorsOf(listingOrder), text = errorsOf(textOrder), asPrinted = errorsOf(printed);
    record("occlusion in the integer part", listing);
    record("shadow in the integer part", text);
    record("as printed", asPrinted);
    // Not above the bound, and near it: the bound is the worst case, not a guess.
    EXPECT_LE(listing.occlusion, wholeBound);
    EXPECT_GE(listing.occlusion, 0.95 / 62.0);
    EXPECT_LE(listing.shadow, partBound);
    EXPECT_GE(listing.shadow, 0.9 / 126.0);
    EXPECT_LE(text.shadow, wholeBound);
    EXPECT_LE(text.occlusion, partBound);
    // Printed: nearly a level, half a level on average; and the clamp's 0.01, which rounding to 1/64 makes
    // more.
    EXPECT_GE(asPrinted.occlusion, 0.9 / 31.0);
    EXPECT_NEAR(asPrinted.occlusionMean, -0.5 / 31.0, 0.05 / 31.0);
    EXPECT_LT(std::abs(listing.occlusionMean), 0.05 / 31.0);
    EXPECT_GE(asPrinted.shadow, 0.01);
}

// 31 and no more: 32 to 63 leave the fraction a step of 1/32.
TEST(OcclusionShadowPacking, aRangeAbove31IsCaught) {
    for (const std::string range : {"32.0", "63.0"})
        expectCaught(roundTrip(listingOrder, true), {header, "PACK_RANGE = 31.0", "PACK_RANGE = " + range});
    // As printed: occlusion by floor, so within a level, and shadow within its clamp and a step of 1/64.
    expectCaught(roundTrip(printed, true, 1.0 / 31.0 + 1e-6, 1.0 / 64.0 + 1e-6),
                 {header, "PACK_RANGE = 31.0", "PACK_RANGE = 63.0"});
}

// The law by the oracle's binary16: a range survives with 64 levels as long as (range + 1) * 64 <= 2^11, and
// as printed as long as half the step at the range is below MIN_FLT. Both end at 31.
TEST(OcclusionShadowPacking, lawOfTheLargestRange) {
    for (int range = 1; range <= 255; ++range) {
        bool survives = true, printedSurvives = true;
        for (int whole = 0; whole <= range; ++whole) {
            survives &= std::floor(oracle::nearestBinary16(whole + 63.0 / 64.0)) == whole;
            printedSurvives &= std::floor(oracle::nearestBinary16(whole + 0.99)) == whole;
        }
        EXPECT_EQ(survives, (range + 1) * 64 <= 2048) << range;
        EXPECT_EQ(printedSurvives, oracle::fractionStep(range) / 2.0 < 0.01) << range;
        EXPECT_EQ(survives, range <= 31) << range;
        EXPECT_EQ(printedSurvives, range <= 31) << range;
    }
}

TEST(OcclusionShadowPacking, everyHalfFloatUnpacksIntoTheUnitRange) {
    std::vector<Row> rows;
    for (uint32_t bits = 0; bits < 65536; ++bits)
        rows.push_back({vec4(harness::halfToFloat(static_cast<uint16_t>(bits)))});
    const Function all{"unpack",
                       {header},
                       "out0 = float4(unpackOcclusionInInteger(in0.x), unpackShadowInInteger(in0.x));"
                       "out1.xy = UnpackOccShadow(in0.x);",
                       1,
                       2};
    expectAgrees(
        {all, rows, [](const Row&) {
             return std::vector{near(dvec4(0.5), 0.5), near(dvec2(0.5), 0.5)}; // [0, 1]; false for NaN
         }});
}

// Where the channel holds what was packed, packing what was unpacked gives it again.
TEST(OcclusionShadowPacking, everyHalfFloatThatAPackingWroteComesBack) {
    std::vector<Row> rows;
    for (uint32_t bits = 0; bits < 65536; ++bits) {
        const float value = harness::halfToFloat(static_cast<uint16_t>(bits));
        const float fraction = value - std::floor(value);
        if (value >= 0.0f && value <= 31.984375f && fraction <= 0.984375f) rows.push_back({vec4(value)});
    }
    EXPECT_GT(rows.size(), 20000u);
    const Function again{"pack what was unpacked",
                         {header},
                         "float2 pair = unpackOcclusionInInteger(in0.x);"
                         "float packed = packOcclusionInInteger(pair.x, pair.y); out0.x = " +
                             nearest + ";"};
    // Below 2^-14 binary16 may be flushed to 0.
    expectAgrees({again, rows, [](const Row& in) { return std::vector{near(in[0].x, 6.2e-5)}; }});
}

TEST(OcclusionShadowPacking, noInputGivesNaNOrInfinity) {
    const Function all{
        "pack",
        {header},
        "out0 = float4(packOcclusionInInteger(in0.x, in0.y), packShadowInInteger(in0.x, in0.y), "
        "PackOccShadow(in0.x, in0.y), 0.0);"
        "out1 = float4(unpackOcclusionInInteger(in0.x), unpackShadowInInteger(in0.y));"
        "out2.xy = UnpackOccShadow(in0.x);",
        1,
        3};
    expectNumbers(all, hostileRows(hostileFinite, 1, 300, 1));
    expectNumbers(all, hostileRows(hostileAny, 1, 300, 2));
}

} // namespace
} // namespace functions
