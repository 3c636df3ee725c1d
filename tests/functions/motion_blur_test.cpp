// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "images.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/motion_blur.hlsli";

Comparison trust() {
    Random random(1);
    std::vector<Row> rows;
    for (float motion :
         {0.0f, denormal, 1.9999999f, 2.0f, 2.0000002f, 8.5f, 15.0f, 15.000001f, 65504.0f, 1e30f})
        rows.push_back({vec4(motion, 2.0f, 15.0f, 0.0f)});
    for (int i = 0; i < 2000; ++i) {
        const float from = random.in(0.0f, 10.0f);
        rows.push_back({vec4(random.in(0.0f, 40.0f), from, from + random.in(0.1f, 30.0f), 0.0f)});
    }
    return {{"motionBlurTrust", {header}, "out0.x = motionBlurTrust(in0.x, in0.y, in0.z);"},
            rows,
            [](const Row& in) {
                // Two differences, each relatively rounded once, and a division, of a result of at most 1.
                return std::vector{
                    near(oracle::motionBlurTrust(in[0].x, in[0].y, in[0].z), divisionError + 3.0 * roundoff)};
            }};
}

TEST(MotionBlur, trustFallsFromTwoToFifteenPixels) {
    expectAgrees(trust());
    const auto out =
        run(trust().function, {{vec4(2, 2, 15, 0)}, {vec4(15, 2, 15, 0)}, {vec4(8.5f, 2, 15, 0)}});
    EXPECT_EQ(out[0][0].x, 1.0f);
    EXPECT_EQ(out[1][0].x, 0.0f);
    EXPECT_NEAR(out[2][0].x, 0.5f, 1e-6f); // the middle, within the bound above
}

TEST(MotionBlur, trustThatGrowsWithMotionOrIsNotHeldIsCaught) {
    expectCaught(trust(), {header, "(blurToPx - motionPx)", "(motionPx - blurFromPx)"});
    expectCaught(trust(), {header, "saturate((blurToPx - motionPx) / max(blurToPx - blurFromPx, 1e-6))",
                           "(blurToPx - motionPx) / max(blurToPx - blurFromPx, 1e-6)"});
}

Comparison blur(const Image& image, bool broken) {
    std::vector<Row> rows = randomPlaces({image.width, image.height}, 2, 600);
    Random random(3);
    for (size_t i = 0; i < rows.size(); ++i)
        rows[i][1] = i % 7 == 0 ? vec4(0.0f) : random.in4(-0.5f, 0.5f);
    return {{"sampleMotion",
             {header},
             "out0.xyz = sampleMotion(TEXTURE_ARGUMENT(gTexture0), in0.xy, in1.xy); out0.w = 0.0;",
             2,
             1,
             {},
             reprise::Stage::compute,
             {{image, true}}},
            rows,
            [image, broken](const Row& in) {
                if (broken) return std::vector{finite()};
                // A filter step on each axis of texels in [0, 1], and ten roundings.
                return std::vector{near(oracle::sampleMotion(image, xy(in[0]), xy(in[1])),
                                        2.0 * filterStep + 10.0 * roundoff)};
            }};
}

TEST(MotionBlur, meanAlongTheMotionAgrees) {
    for (glm::ivec2 size : imageSizes)
        expectAgrees(blur(randomImage(size.x, size.y, 4), false));
}

TEST(MotionBlur, blurOverAnotherPartOfTheMotionIsCaught) {
    const Image image = randomImage(16, 9, 5);
    expectCaught(blur(image, false), {header, "0.5 * MOTION_BLUR_SHUTTER", "MOTION_BLUR_SHUTTER"});
    expectCaught(blur(image, false), {header, "uv - stepUv * float(tap)", "uv + stepUv * float(tap)"});
    expectCaught(blur(image, false),
                 {header, "sum / float(2 * MOTION_BLUR_TAPS + 1)", "sum / float(2 * MOTION_BLUR_TAPS)"});
}

TEST(MotionBlur, brokenTexelsGiveFiniteColours) {
    const Image image = brokenImage(16, 9, 6);
    expectAgrees(blur(image, true));
    for (const Row& out : run(blur(image, true).function, blur(image, true).inputs))
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(out[0][c], 0.0f);
            EXPECT_LE(out[0][c], 65504.0f * (1.0f + 0x1p-21f)); // seven sums and a division
        }
}

TEST(MotionBlur, readsThatAreNotRepairedAreCaught) {
    expectCaught(blur(brokenImage(16, 9, 7), true),
                 {header, "sum += sanitize(SAMPLE(colour, uv + stepUv * float(tap)).rgb)",
                  "sum += SAMPLE(colour, uv + stepUv * float(tap)).rgb"});
}

} // namespace
} // namespace functions
