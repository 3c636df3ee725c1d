// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"
#include "printed_forms.hpp"
#include "projections.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

using oracle::DepthFormat;

const std::string header = "reprise/miss_detection.hlsli";

// --- Depth accuracy

struct Storage {
    std::string name, constant;
    DepthFormat format;
};

const Storage storages[] = {{"float32", "DEPTH_ROUNDING_FLOAT32", DepthFormat::float32},
                            {"unorm24", "DEPTH_ROUNDING_UNORM24", DepthFormat::unorm24},
                            {"unorm16", "DEPTH_ROUNDING_UNORM16", DepthFormat::unorm16}};

std::vector<Projection> depthProjections() {
    std::vector<Projection> all = projections();
    all.push_back(perspective("standard, far", 0.01, 1e5, false));
    all.push_back(perspective("reversed, far", 0.01, 1e5, true));
    return all;
}

// in0 is (linear depth, device depth as stored, coefficients).
std::vector<Row> depthRows(const Projection& projection, DepthFormat format) {
    Random random(1);
    std::vector<Row> rows;
    const double far = std::isinf(projection.farM) ? 1e5 : projection.farM;
    const glm::dvec2 coefficients = linearDepthCoefficients(projection);
    for (int i = 0; i < 1000; ++i) {
        const double linear = projection.nearM * std::pow(far / projection.nearM, random.unit());
        const float depth = static_cast<float>(linear); // what the shader is given
        const double device = oracle::deviceDepth(depth, projection.matrix);
        rows.push_back({vec4(depth, oracle::storedDepth(device, format), coefficients)});
    }
    return rows;
}

Comparison depthErrors(const Projection& projection, const Storage& storage) {
    return {{"linearDepthError",
             {header},
             "float2 rounding = " + storage.constant +
                 ";\nout0.x = linearDepthError(in0.x, in0.zw, rounding);\n"
                 "out0.y = depthThreshold(in0.x, in0.zw, rounding, 0.0);\n"
                 "out0.z = linearDepthFromDevice(in0.y, in0.zw);",
             1,
             1,
             {{"ORTHOGRAPHIC", projection.orthographic}}},
            depthRows(projection, storage.format),
            [projection, storage](const Row& in) {
                const double linear = in[0].x, device = oracle::deviceDepth(linear, projection.matrix);
                // Of the device depth: the format's rounding, and those of its product and its coefficient,
                // three and one for safety; and seven of the linear depth, and one.
                const double relative = 8.0 * roundoff;
                const double inDevice =
                    oracle::depthRounding(device, storage.format) + 4.0 * roundoff * std::abs(device);
                const double error = oracle::linearDepthError(linear, inDevice, projection.matrix);
                const double share = error / linear;
                // Where a few percent more would reach infinity, an estimate is all that can be asked.
                if (!projection.orthographic && !(share < 20.0)) return std::vector{finite()};
                const double expected = error + relative * linear * (1.0 + 2.0 * share + share * share);
                // Constants of two digits, and a device depth that cancels; the share's error grows with
                // itself.
                const double bound = 0.01 * expected * (1.0 + share);
                return std::vector{near(dvec2(expected, 2.0 * expected), 2.0 * bound)};
            }};
}

// What it is for: the depth as stored and read again is no farther off.
TEST(MissDetection, depthIsNoFartherOffThanItsError) {
    for (const Projection& projection : depthProjections())
        for (const Storage& storage : storages) {
            const Comparison each = depthErrors(projection, storage);
            const auto out = run(each.function, each.inputs);
            double largestShare = 0.0;
            for (size_t i = 0; i < out.size(); ++i) {
                const double off = std::abs(static_cast<double>(out[i][0].z) - each.inputs[i][0].x);
                ASSERT_LE(off, out[i][0].x)
                    << projection.name << ", " << storage.name << " at " << each.inputs[i][0].x;
                largestShare = std::max(largestShare, off / out[i][0].x);
            }
            // And it is no idle bound: somewhere the depth is off by a tenth of it, nearly all of it where
            // the format is coarser than the arithmetic.
            EXPECT_GE(largestShare, storage.format == DepthFormat::unorm16 ? 0.9 : 0.1)
                << projection.name << ", " << storage.name;
        }
}

TEST(MissDetection, errorOfDepthAgreesForEveryDepthKindAndFormat) {
    for (const Projection& projection : depthProjections())
        for (const Storage& storage : storages) {
            SCOPED_TRACE(projection.name + ", " + storage.name);
            expectAgrees(depthErrors(projection, storage));
        }
}

TEST(MissDetection, wrongDepthErrorsAreCaught) {
    const Projection standard = depthProjections()[0], reversed = depthProjections()[1];
    // As if linear depth were as even as device depth.
    expectCaught(depthErrors(standard, storages[1]), {header, "linearDepth * affineError", "affineError"});
    expectCaught(depthErrors(standard, storages[2]), {header, "+ depthRounding.y", ""});
    expectCaught(depthErrors(standard, storages[2]), {header, "/ (1.0 - share)", ""});
    // A reversed depth taken for one of even steps.
    expectCaught(
        depthErrors(reversed, storages[0]),
        {header, "deviceDepth * (depthRounding.x + AFFINE_ROUNDING)", "(depthRounding.x + AFFINE_ROUNDING)"});
}

TEST(MissDetection, hostileDepthsGiveFiniteErrors) {
    Random random(2);
    std::vector<float> values(std::begin(hostileFinite), std::end(hostileFinite));
    values.insert(values.end(), {3.4e38f, -3.4e38f, 1e-30f});
    std::vector<Row> rows;
    for (int i = 0; i < 2000; ++i)
        rows.push_back({vec4(random.of(values), random.of(values), random.of(values), random.of(values)),
                        vec4(random.of(values), random.of(values), 0, 0)});
    for (int orthographic : {0, 1})
        expectAgrees({{"linearDepthError",
                       {header},
                       "out0.x = linearDepthError(in0.x, in0.zw, in1.xy);\n"
                       "out0.y = depthThreshold(in0.x, in0.zw, in1.xy, in0.y);",
                       2,
                       1,
                       {{"ORTHOGRAPHIC", orthographic}}},
                      rows,
                      [](const Row&) { return std::vector{finite()}; }});
}

// --- Hit

// in0 is (uv, last depth, cache depth), in1 (threshold, object, cached object).
std::vector<Row> hitRows() {
    Random random(3);
    std::vector<Row> rows;
    for (int i = 0; i < 3000; ++i) {
        const float last = random.in(0.1f, 100.0f), threshold = random.of(std::vector{0.01f, 0.2f, 1.0f});
        rows.push_back({vec4(random.in(-0.1f, 1.1f), random.in(-0.1f, 1.1f), last,
                             last + threshold * random.in(-2.0f, 2.0f)),
                        vec4(threshold, random.below(3), random.below(3), 0)});
    }
    const float broken[] = {notANumber, infinity, -infinity};
    for (int i = 0; i < 500; ++i) {
        Row row = {vec4(0.5f, 0.5f, 10.0f, 10.0f), vec4(1.0f, 8388607.0f, 8388607.0f, 0)};
        const size_t place = random.below(6);
        if (place < 4)
            row[0][static_cast<int>(place)] = random.of(broken);
        else
            row[1][static_cast<int>(place - 3)] = random.of(broken);
        rows.push_back(row);
    }
    return rows;
}

Comparison hits() {
    return {{"isCacheHit",
             {header},
             "out0.x = isCacheHit(in0.xy, in0.z, in0.w, in1.x) ? 1.0 : 0.0;\n"
             "out0.y = isCacheHit(in0.xy, in0.z, in0.w, in1.x, in1.y, in1.z) ? 1.0 : 0.0;",
             2},
            hitRows(),
            [](const Row& in) {
                const double difference = std::abs(static_cast<double>(in[0].z) - in[0].w);
                // A difference this close to the threshold, or a place to the border, may fall to either
                // side.
                const dvec2 border = glm::abs(glm::abs(xy(in[0]) - 0.5) - 0.5);
                if (std::abs(difference - in[1].x) < 1e-5 || std::min(border.x, border.y) < 1e-7)
                    return std::vector{finite()};
                const bool hit = oracle::isCacheHit(xy(in[0]), in[0].z, in[0].w, in[1].x);
                return std::vector{near(dvec2(hit, hit && in[1].y == in[1].z), 0.0)};
            }};
}

TEST(MissDetection, hitNeedsViewportDepthAndObject) {
    expectAgrees(hits());
}

TEST(MissDetection, wrongHitsAreCaught) {
    expectCaught(hits(),
                 {header, "abs(lastDepth - cacheDepth) < zThreshold", "lastDepth - cacheDepth < zThreshold"});
    expectCaught(hits(), {header, "abs(lastDepth - cacheDepth) < zThreshold",
                          "!(abs(lastDepth - cacheDepth) >= zThreshold)"}); // true for NaN
    expectCaught(hits(), {header, "isInsideUv(prevUv) && isSameDepth", "isSameDepth"});
    expectCaught(hits(), {header, "abs(objectId - cacheObjectId) < 0.5", "objectId - cacheObjectId < 0.5"});
}

// The slide's fragment, with its places as given.
Function fragmentOfTheSlide(const std::string& open, const std::string& close, const std::string& depth) {
    return {"bHit",
            {header},
            "float3 PosPrev = in0.xyz; float4 cache_val = in0.wwww; float g_fZThres = in1.x;\n"
            "bool bHit = " +
                open + "all(PosPrev.xy >= 0.0) && all(PosPrev.xy <= 1.0) &&\n" + depth + close +
                ";\nout0.x = bHit ? 1.0 : 0.0; out0.y = out0.x * (in1.y == in1.z ? 1.0 : 0.0);",
            2};
}

const std::string depthMatch = "    abs(PosPrev.z - cache_val.w) < g_fZThres";

TEST(MissDetection, theCorrectedFragmentOfTheSlideAgrees) {
    Comparison corrected = hits();
    corrected.function = fragmentOfTheSlide("(", ")", depthMatch);
    expectAgrees(corrected);
}

TEST(MissDetection, thePrintedBracesOfBHitAreCaught) {
    expectDoesNotCompile(fragmentOfTheSlide("{ ", "; }", depthMatch), "Expected");
}

TEST(MissDetection, thePrintedSecondDeclarationOfBHitIsCaught) {
    Function again = fragmentOfTheSlide("(", ")", depthMatch);
    again.body += "\nbool bHit = bHit && in1.y > 0.0;";
    expectDoesNotCompile(again, "redefinition");
}

// Device depth of the place against a cache that holds linear depth, as the comparison reads if nothing says
// what w is; and device against device, with one threshold for all distances, in a reversed buffer.
TEST(MissDetection, thePrintedComparisonOfUnnamedDepthsIsCaught) {
    const Projection reversed = perspective("reversed infinite", 0.1, HUGE_VAL, true);
    Random random(4);
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i) {
        const float depth = random.in(1.0f, 500.0f), other = i % 2 == 0 ? depth : 2.0f * depth;
        rows.push_back(
            {vec4(0.5f, 0.5f, depth, other), vec4(0.05f, oracle::deviceDepth(depth, reversed.matrix),
                                                  oracle::deviceDepth(other, reversed.matrix), 0.001f)});
    }
    Comparison right{{"bHit", {header}, "out0.x = isCacheHit(in0.xy, in0.z, in0.w, in1.x) ? 1.0 : 0.0;", 2},
                     rows,
                     [](const Row& in) { return std::vector{near(in[0].z == in[0].w ? 1.0 : 0.0, 0.0)}; }};
    expectAgrees(right);
    right.function.body = "out0.x = abs(in1.y - in0.w) < in1.x ? 1.0 : 0.0;";
    EXPECT_NE(mismatches(right), "") << "device depth against linear depth";
    right.function.body = "out0.x = abs(in1.y - in1.z) < in1.w ? 1.0 : 0.0;";
    EXPECT_NE(mismatches(right), "") << "one threshold in reversed device depth";
}

// Between a near and a far surface: the linear filter's depth is of neither, the point filter's of one of
// them.
TEST(MissDetection, depthThroughALinearFilterMissesAtAnEdge) {
    Image depth(16, 1, dvec4(5.0));
    for (int x = 8; x < 16; ++x)
        depth.at(x, 0) = dvec4(20.0);
    std::vector<Row> rows;
    for (int i = 0; i < 160; ++i) // from 5.05 to 10.95 texels
        rows.push_back({vec4((5.05f + 0.0371875f * static_cast<float>(i)) / 16.0f, 0.5f, 5.0f, 0.5f)});
    const auto hitsOf = [&](bool linear) {
        return run({"edge",
                    {header},
                    "out0.x = isCacheHit(in0.xy, in0.z, SAMPLE(gTexture0, in0.xy).x, in0.w) ? 1.0 : 0.0;",
                    1,
                    1,
                    {},
                    reprise::Stage::compute,
                    {{depth, linear}}},
                   rows);
    };
    const auto linear = hitsOf(true), point = hitsOf(false);
    for (size_t i = 0; i < rows.size(); ++i) {
        const double texel = 16.0 * rows[i][0].x;
        if (std::abs(texel - 8.0) > 0.01) {
            EXPECT_EQ(point[i][0].x, texel < 8.0 ? 1.0f : 0.0f) << texel;
        }
        // 5 + 15 (texel - 7.5) is within 0.5 of 5 up to 7.5333; the filter's step is 1/256 of a texel.
        if (std::abs(texel - 7.5333) > 0.005) {
            EXPECT_EQ(linear[i][0].x, texel < 7.5333 ? 1.0f : 0.0f) << texel;
        }
    }
}

// --- Magnification

const double placeErrorPx = 1.0 / 256.0;

// in0 is (place, ddx), in1 ddy.
Row footprintRow(Random& random, double angle, double scaleX, double scaleY, double shear) {
    const dvec2 ddx = scaleX * dvec2(std::cos(angle), std::sin(angle));
    const dvec2 ddy =
        scaleY * dvec2(-std::sin(angle) + shear * std::cos(angle), std::cos(angle) + shear * std::sin(angle));
    return {vec4(random.in(2.0f, 60.0f), random.in(2.0f, 60.0f), ddx), vec4(ddy, 0, 0)};
}

std::vector<Row> footprintRows() {
    Random random(5);
    std::vector<Row> rows;
    for (int i = 0; i < 6000; ++i) {
        const double angle = i % 3 == 0 ? 0.0 : random.in(-4.0f, 4.0f);
        const double scale = random.of(std::vector{0.1, 0.4, 0.8, 1.0, 1.2});
        const double stretch = i % 2 == 0 ? 1.0 : random.in(0.3f, 1.0f);
        rows.push_back(
            footprintRow(random, angle, scale, scale * stretch, i % 5 == 0 ? random.in(-0.4f, 0.4f) : 0.0));
    }
    return rows;
}

Comparison coverage() {
    return {
        {"coversPixelCentre", {header}, "out0.x = coversPixelCentre(in0.xy, in0.zw, in1.xy) ? 1.0 : 0.0;", 2},
        footprintRows(),
        [](const Row& in) {
            const dvec2 ddx(in[0].z, in[0].w), ddy = xy(in[1]);
            const double distance = oracle::centreDistance(xy(in[0]), ddx, ddy, 3);
            const double area = std::abs(ddx.x * ddy.y - ddx.y * ddy.x);
            // What is farther by less than the place's own error may count as covered.
            const double longer =
                std::max(std::abs(ddx.x) + std::abs(ddx.y), std::abs(ddy.x) + std::abs(ddy.y));
            const double slack = placeErrorPx * longer / area;
            if (distance <= 0.5 - 1e-5) return std::vector{near(1.0, 0.0)};
            if (distance >= 0.5 + slack + 1e-5) return std::vector{near(0.0, 0.0)};
            return std::vector{finite()};
        }};
}

TEST(MissDetection, pixelCoversACentreIfItsParallelogramDoes) {
    expectAgrees(coverage());
}

TEST(MissDetection, whatIsMinifiedAlwaysCoversACentre) {
    Random random(6);
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i)
        rows.push_back(footprintRow(random, random.in(-4.0f, 4.0f), random.in(1.42f, 40.0f),
                                    random.in(1.42f, 40.0f), 0.0));
    expectAgrees({coverage().function, rows, [](const Row&) { return std::vector{near(1.0, 0.0)}; }});
}

const std::string coversBegin = "    float2 f = frac(prevPx - 0.5);";

// As on the slide, with its names.
Mutation printedPixR() {
    return {header, coversBegin,
            "    float2 IPrev = prevPx - 0.5;\n"
            "    float2 PixR = max(abs(ddxPx), abs(ddyPx)) * 0.5;\n"
            "    return all(abs(IPrev - round(IPrev)) <= PixR);\n" +
                coversBegin};
}

TEST(MissDetection, thePrintedPixRUnderARollIsCaught) {
    expectCaught(coverage(), printedPixR());
    // Without roll and shear it is right.
    Comparison straight = coverage();
    std::erase_if(straight.inputs, [](const Row& in) { return in[0].w != 0.0f || in[1].x != 0.0f; });
    ASSERT_GT(straight.inputs.size(), 500u);
    EXPECT_EQ(mismatches(straight, printedPixR()), "");
}

// An image moved by half a pixel, with derivatives as a device rounds them: nothing is magnified.
TEST(MissDetection, thePrintedPixRAtHalfAPixelIsCaught) {
    const float rounded = 1.0f - 0x1p-20f;
    const Comparison half = {coverage().function,
                             {{vec4(10.0f, 7.0f, rounded, 0.0f), vec4(0.0f, rounded, 0, 0)}},
                             [](const Row&) { return std::vector{near(1.0, 0.0)}; }};
    expectCaught(half, printedPixR());
}

TEST(MissDetection, wrongFootprintsAreCaught) {
    expectCaught(coverage(), {header, "frac(prevPx - 0.5)", "frac(prevPx)"}); // half a texel off
    expectCaught(coverage(), {header, "nearest <= 0.5 * area", "nearest <= area"});
    expectCaught(coverage(), {header, "abs(x * ddyPx.y - y * ddyPx.x)", "abs(x * ddxPx.y - y * ddxPx.x)"});
    // The nearest centre alone is not always the one that is covered.
    expectCaught(coverage(),
                 {header, "min(min(farther.x, farther.y), min(farther.z, farther.w))",
                  "f.x < 0.5 ? (f.y < 0.5 ? farther.x : farther.z) : (f.y < 0.5 ? farther.y : farther.w)"});
}

TEST(MissDetection, pixelWithoutAreaOrWithNanCoversNothing) {
    const float values[] = {0.0f, notANumber, infinity, -infinity};
    std::vector<Row> rows;
    for (float value : values)
        for (int component = 0; component < 6; ++component) {
            Row row = {vec4(4.5f, 4.5f, 0.5f, 0.0f), vec4(0.0f, 0.5f, 0, 0)};
            row[static_cast<size_t>(component / 4)][component % 4] = value;
            const bool edge = component == 2 || component == 5; // the lengths of the two edges
            if (std::isnan(value) || (edge && value == 0.0f)) rows.push_back(row);
        }
    expectAgrees({coverage().function, rows, [](const Row&) { return std::vector{near(0.0, 0.0)}; }});
}

// --- By the hardware's derivatives

const glm::ivec2 extent(64, 64);
const double rolled[] = {0.0, 0.3, 0.7853981633974483};

Function rolledImage(double angle, double scale) {
    std::ostringstream text;
    text.precision(17);
    text << "float2 centred = (positionPx.xy - 32.0) * " << scale << ";\n"
         << "float2 prevPx = float2(" << std::cos(angle) << " * centred.x - " << std::sin(angle)
         << " * centred.y, " << std::sin(angle) << " * centred.x + " << std::cos(angle)
         << " * centred.y) + float2(32.13, 32.37);\n"
         << "out0.x = coversPixelCentre(prevPx / 64.0, float2(64.0, 64.0)) ? 1.0 : 0.0; out0.yz = prevPx;";
    return {"rolled image", {header}, text.str(), 0, 1, {}, reprise::Stage::fragment};
}

struct Counted {
    size_t misses = 0, wrong = 0;
};

Counted count(double angle, double scale, const Mutation& mutation = {}) {
    const auto out = run(rolledImage(angle, scale), {}, {.mutation = mutation, .extent = extent});
    const dvec2 ddx = scale * dvec2(std::cos(angle), std::sin(angle)), ddy(-ddx.y, ddx.x);
    Counted counted;
    for (const Row& pixel : out) {
        const double distance = oracle::centreDistance(dvec2(pixel[0].y, pixel[0].z), ddx, ddy, 3);
        const bool hit = pixel[0].x == 1.0f;
        counted.misses += hit ? 0 : 1;
        // Twice the place's error on each axis, in shares of an edge.
        if (std::abs(distance - 0.5) > 4.0 * placeErrorPx / scale)
            counted.wrong += hit == (distance < 0.5) ? 0 : 1;
    }
    return counted;
}

TEST(MissDetection, hardwareDerivativesGiveTheSameAnswer) {
    for (double angle : rolled)
        for (double scale : {0.5, 1.0})
            EXPECT_EQ(count(angle, scale).wrong, 0u) << angle << " " << scale;
}

// Of a plane of unit squares turned by 45 degrees (sqrt 2 - 1)² is free of centres: 0.172. The printed form
// asks for 0.354 on both axes of 0.5 each: half of the pixels miss though nothing is magnified.
TEST(MissDetection, printedFormMissesHalfOfARolledImage) {
    const double pixels = extent.x * extent.y;
    EXPECT_NEAR(static_cast<double>(count(rolled[2], 1.0).misses) / pixels, 0.172, 0.02);
    EXPECT_NEAR(static_cast<double>(count(rolled[2], 1.0, printedPixR()).misses) / pixels, 0.5, 0.02);
}

TEST(MissDetection, ddxForDdyIsCaught) {
    EXPECT_GT(count(0.3, 0.5, {header, "ddx(prevPx), ddy(prevPx)", "ddx(prevPx), ddx(prevPx)"}).wrong, 0u);
    EXPECT_GT(count(0.3, 0.5, {header, "uvToPx(prevUv, size)", "prevUv"}).wrong, 0u);
}

} // namespace
} // namespace functions
