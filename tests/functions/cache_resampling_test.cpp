// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

using glm::ivec2;

const std::string header = "reprise/cache_resampling.hlsli";

Function sampling(const std::string& name, const Image& image, bool linear) {
    return {name,
            {header},
            "out0 = " + name + "(TEXTURE_ARGUMENT(gTexture0), in0.xy, float4(in0.zw, 1.0 / in0.zw));",
            2,
            1,
            {},
            reprise::Stage::compute,
            {{image, linear}}};
}

// uv times the size is rounded at 20 texels, which moves a place by some 4e-6 of a texel.
const double placeError = 8e-6;

std::vector<Row> places(const Image& image, uint32_t seed) {
    return randomPlaces({image.width, image.height}, seed);
}

Comparison nearest(const Image& image, bool linear) {
    return {sampling("sampleNearest", image, linear), places(image, 1), [image](const Row& in) {
                const dvec2 texel = xy(in[0]) * image.extent(), off = glm::abs(texel - glm::round(texel));
                if (std::min(off.x, off.y) < placeError) return std::vector{finite()};
                // At a centre a linear filter gives its texel but for the place's error.
                return std::vector{near(oracle::samplePoint(image, xy(in[0])), 4.0 * placeError)};
            }};
}

Comparison bilinear(const Image& image, bool linear) {
    return {sampling("sampleBilinear", image, linear), places(image, 2), [image](const Row& in) {
                // Texels in [0, 1], the place's error on each axis, and some roundings.
                return std::vector{near(oracle::sampleLinear(image, xy(in[0])), 4.0 * placeError)};
            }};
}

Comparison bSpline(const Image& image) {
    return {sampling("sampleBSpline4", image, true), places(image, 3), [image](const Row& in) {
                // A step of the filter on each axis, of texels in [0, 1] under weights that sum to 1.
                return std::vector{
                    near(oracle::sampleBSpline16(image, xy(in[0])), 2.0 * filterStep + 4.0 * placeError)};
            }};
}

TEST(CacheResampling, everyReadAgrees) {
    for (glm::ivec2 size : imageSizes) {
        SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y));
        const Image image = randomImage(size.x, size.y, 4);
        for (bool linear : {false, true}) {
            expectAgrees(nearest(image, linear));
            expectAgrees(bilinear(image, linear));
        }
        expectAgrees(bSpline(image));
    }
}

TEST(CacheResampling, wrongReadsAreCaught) {
    const Image image = randomImage(16, 9, 5);
    expectCaught(nearest(image, true), {header, "(floor(uv * size.xy) + 0.5)", "(floor(uv * size.xy))"});
    expectCaught(nearest(image, false), {header, "floor(uv * size.xy)", "floor(uv * size.xy + 0.5)"});
    expectCaught(bilinear(image, true),
                 {header, "float2 high = (first + 1.5)", "float2 high = (first + 1.0)"});
    // Another sample's coordinate.
    expectCaught(bilinear(image, false), {header, "SAMPLE(history, float2(high.x, low.y))",
                                          "SAMPLE(history, float2(low.x, high.y))"});
    expectCaught(bSpline(image), {header, "(1.0 - f) * (1.0 - f) * (1.0 - f) / 6.0", "f * f * f / 6.0"});
    expectCaught(bSpline(image),
                 {header, "(4.0 + f * f * (3.0 * f - 6.0)) / 6.0", "(4.0 + f * f * (3.0 * f - 5.0)) / 6.0"});
    expectCaught(bSpline(image), {header, "w1 / low", "w0 / low"}); // the pair's weights swapped
    expectCaught(bSpline(image), {header, "first + 1.5 + w3 / high", "first + 1.0 + w3 / high"});
    expectCaught(bSpline(image), {header, "first - 0.5 + w1 / low", "first - 0.5"}); // a read at a centre
}

// What repeated resampling blurs by: of x² in texels a kernel makes x² plus its variance.
TEST(CacheResampling, bSplineBlursMoreThanBilinearAtEveryPlace) {
    Image square(16, 1);
    for (int x = 0; x < 16; ++x)
        square.at(x, 0) = dvec4(x * x / 256.0);
    std::vector<Row> rows;
    for (int i = 0; i <= 32; ++i)
        rows.push_back({vec4((8.0f + static_cast<float>(i) / 32.0f) / 16.0f, 0.5f, 16.0f, 1.0f), vec4(0.0f)});
    const auto cubic = run(sampling("sampleBSpline4", square, true), rows);
    const auto straight = run(sampling("sampleBilinear", square, true), rows);
    for (size_t i = 0; i < rows.size(); ++i) {
        const double position = 16.0 * rows[i][0].x - 0.5, f = position - std::floor(position);
        const double blurred = 256.0 * cubic[i][0].x - position * position;
        // A step of the filter, where neighbours differ by 2 · 9 + 1 squared texels at most; between two
        // texels a linear read is off by up to 1/4 of itself, which the spline's own weights already count.
        EXPECT_NEAR(blurred, 1.0 / 3.0, 19.0 * filterStep) << f;
        EXPECT_NEAR(256.0 * straight[i][0].x - position * position, f * (1.0 - f), 1e-3) << f;
        EXPECT_GT(blurred, 0.25) << f;
    }
}

// A texture of ones with broken texels gives 1 where any of what is read is whole.
Comparison ofOnes(const std::string& name, bool linear) {
    Image ones(16, 9, dvec4(1.0));
    Random random(6);
    const float broken[] = {notANumber, infinity, -infinity};
    for (dvec4& texel : ones.texels)
        if (random.below(4) == 0) texel[static_cast<int>(random.below(4))] = random.of(broken);
    return {sampling(name, ones, linear), places(ones, 7), [ones](const Row& in) {
                const dvec2 position = xy(in[0]) * ones.extent() - 0.5;
                const ivec2 first(glm::floor(position));
                const dvec2 f = position - dvec2(first);
                double whole = 0.0;
                for (int i = 0; i < 4; ++i) {
                    const dvec4 texel = oracle::texelClamped(ones, first.x + i % 2, first.y + i / 2);
                    const double share = (i % 2 == 1 ? f.x : 1.0 - f.x) * (i / 2 == 1 ? f.y : 1.0 - f.y);
                    if (texel == dvec4(1.0)) whole += share;
                }
                if (whole < 1e-4) return std::vector{finite()};
                return std::vector{near(dvec4(1.0), 16.0 * roundoff)}; // a sum over itself
            }};
}

TEST(CacheResampling, brokenTexelsTakeNoPart) {
    expectAgrees(ofOnes("sampleBilinear", false));
    // A linear filter mixes a broken texel into every read beside it; such a read is left out whole.
    for (const std::string name : {"sampleNearest", "sampleBilinear", "sampleBSpline4"}) {
        const Comparison each = ofOnes(name, name != "sampleNearest");
        for (const Row& out : run(each.function, each.inputs))
            for (int c = 0; c < 4; ++c)
                EXPECT_TRUE(out[0][c] == 0.0f || std::abs(out[0][c] - 1.0f) < 1e-5f)
                    << name << " " << out[0][c];
    }
}

TEST(CacheResampling, brokenTexelsThatTakePartAreCaught) {
    expectCaught(ofOnes("sampleBilinear", false),
                 {header, "return total > 1e-6 ? sum / total : 0.0;", "return sum;"});
    expectCaught(ofOnes("sampleBilinear", false), {header, "weights.x * numberOrZero(a)", "weights.x * a"});
    const Image broken = brokenImage(16, 9, 8);
    expectCaught({sampling("sampleNearest", broken, false), places(broken, 9),
                  [](const Row&) { return std::vector{finite()}; }},
                 {header, "numberOrZero(SAMPLE(history, nearestTexelUv(uv, size)))",
                  "SAMPLE(history, nearestTexelUv(uv, size))"});
}

TEST(CacheResampling, hostilePlacesAndTexelsGiveNumbers) {
    const Image image = brokenImage(16, 9, 8);
    std::vector<Row> rows = places(image, 9);
    Random random(10);
    for (Row& row : rows)
        if (random.below(3) == 0)
            row[0] = vec4(random.of(hostileFinite), random.of(hostileFinite), row[0].z, row[0].w);
    for (const std::string name : {"sampleNearest", "sampleBilinear", "sampleBSpline4"})
        for (bool linear : {false, true})
            expectAgrees(
                {sampling(name, image, linear), rows, [](const Row&) { return std::vector{finite()}; }});
}

// --- A history of 2x2 texels a pixel

Comparison subpixels() {
    std::vector<Row> rows;
    const float jitters[] = {-0.5f, -0.25f, -1e-6f, 0.0f, 1e-6f, 0.25f, 0.49f};
    for (float x : jitters)
        for (float y : jitters)
            for (int texel = 0; texel < 16; ++texel)
                rows.push_back(
                    {vec4(2 * texel % 8 / 2, texel / 4, x, y), vec4(texel % 4 + 0.5, texel / 4 + 0.5, 0, 0)});
    return {
        {"highResolutionTexel, isFreshTexel",
         {header},
         "out0.xy = highResolutionTexel(in0.xy, in0.zw); out0.z = isFreshTexel(in1.xy, in0.zw) ? 1.0 : 0.0;",
         2},
        rows,
        [](const Row& in) {
            const dvec2 jitter(in[0].z, in[0].w);
            const ivec2 pixel(glm::floor(xy(in[0]))), texel(glm::floor(xy(in[1])));
            const bool fresh = texel == oracle::highResolutionTexel(texel / 2, jitter);
            // Whole numbers, exact.
            return std::vector{near(dvec3(oracle::highResolutionTexel(pixel, jitter), fresh), 0.0)};
        }};
}

TEST(CacheResampling, pixelWritesTheTexelThatItsSampleLiesIn) {
    expectAgrees(subpixels());
}

TEST(CacheResampling, jitterOfTheOtherSignIsCaught) {
    expectCaught(subpixels(), {header, "jitterPx <= 0.0 ? 1.0 : 0.0", "jitterPx <= 0.0 ? 0.0 : 1.0"});
    expectCaught(subpixels(),
                 {header, "floor(positionPx) - 2.0 * floor(0.5 * positionPx)", "floor(positionPx)"});
}

// Four frames of a standing image: each pixel samples one place a frame, and in the end every texel of the
// history holds what is at its centre, unblurred.
TEST(CacheResampling, highResolutionHistoryIsWholeAfterFourFrames) {
    const ivec2 size(14, 10);
    Image history(size.x, size.y, dvec4(notANumber)); // whatever was there
    std::vector<Row> rows;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            rows.push_back({vec4(x + 0.5, y + 0.5, 0, 0)});
    for (int frame = 0; frame < 4; ++frame) {
        for (Row& row : rows)
            row[0].z = static_cast<float>(frame);
        const auto out =
            run({"high-resolution history",
                 {header, "reprise/jitter.hlsli"},
                 "float2 jitterPx = uniform4HelixJitterPx(in0.z);\n"
                 "float2 samplePx = floor(0.5 * in0.xy) + 0.5 - jitterPx;\n"
                 "float4 signal = float4(samplePx, samplePx.x * samplePx.y, 1.0);\n"
                 "float4 size = float4(14.0, 10.0, 1.0 / 14.0, 1.0 / 10.0);\n"
                 "float4 old = sampleNearest(TEXTURE_ARGUMENT(gTexture0), in0.xy * size.zw, size);\n"
                 "out0 = isFreshTexel(in0.xy, jitterPx) ? signal : old;",
                 1,
                 1,
                 {},
                 reprise::Stage::compute,
                 {{history, false}}},
                rows);
        for (size_t i = 0; i < out.size(); ++i)
            history.texels[i] = dvec4(out[i][0]);
    }
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const dvec2 centre = (dvec2(x, y) + 0.5) / 2.0; // in pixels; quarters, exact in binary32
            EXPECT_EQ(history.at(x, y), dvec4(centre, centre.x * centre.y, 1.0)) << x << " " << y;
        }
}

// --- Minification

Comparison levels() {
    Random random(11);
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i) {
        const float scale = std::exp2(random.in(-3.0f, 12.0f));
        rows.push_back({scale * random.in4(-1.0f, 1.0f)});
    }
    return {{"minificationLevel", {header}, "out0.x = minificationLevel(in0.xy, in0.zw);", 1},
            rows,
            [](const Row& in) {
                // Vulkan lets log2 err by 3 steps of a level up to 26 before it is halved, or by 2^-21.
                return std::vector{near(oracle::mipLevel(xy(in[0]), dvec2(in[0].z, in[0].w)),
                                        26.0 * 4.0 * roundoff + 0x1p-20)};
            }};
}

TEST(CacheResampling, levelIsThatOfTheLongerStep) {
    expectAgrees(levels());
    std::vector<Row> hostile;
    Random random(12);
    std::vector<float> values(std::begin(hostileAny), std::end(hostileAny));
    values.insert(values.end(), {1e19f, 3.4e38f});
    for (int i = 0; i < 500; ++i)
        hostile.push_back({vec4(random.of(values), random.of(values), random.of(values), random.of(values))});
    expectAgrees({levels().function, hostile, [](const Row&) { return std::vector{finite()}; }});
}

TEST(CacheResampling, wrongLevelsAreCaught) {
    expectCaught(levels(), {header, "max(dot(ddxPx, ddxPx), dot(ddyPx, ddyPx))", "dot(ddxPx, ddxPx)"});
    expectCaught(levels(), {header, "0.5 * log2", "log2"});
    expectCaught(levels(), {header, "longest > 1.0 ?", "longest > 0.0 ?"});
}

} // namespace
} // namespace functions
