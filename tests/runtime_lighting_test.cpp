// SPDX-License-Identifier: Apache-2.0
// The framework recorded frame by frame: values over time, sizes, depth conventions, and what is broken.
#include "runtime_frame_support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace reprise;

class LightingTest : public RuntimeTest, public testing::WithParamInterface<Stage> {
protected:
    FrameRecorder::CreateInfo info(SceneNeeds needs, Extent extent, const CacheSettings& cache = {}) const {
        needs.antiAliasing = false;
        return {.needs = needs, .settings = {.stage = GetParam(), .cache = cache}, .extent = extent};
    }

    static std::vector<float> lightingOf(FrameRecorder& recorder, const FrameInput& input) {
        const auto output = recordOne(recorder, input);
        if (!output) throw std::runtime_error(output.error().message);
        if (!output->lighting) throw std::runtime_error("There is no lighting.");
        EXPECT_FALSE(output->colour.image) << "no anti-aliasing, no colour";
        return downloadRef(*output->lighting);
    }
};

constexpr SceneNeeds still{.cameraMoves = false, .objectsMove = false};
SceneNeeds with(SceneNeeds needs, bool SceneNeeds::*need) {
    needs.*need = true;
    return needs;
}

SceneNeeds cached(uint32_t channels) {
    SceneNeeds needs = still;
    needs.cachedChannels = channels;
    return needs;
}

// A value of the engine's that changes from frame to frame, on a surface that faces a still camera.
struct FreshValue {
    explicit FreshValue(Extent extent, uint32_t ratio)
        : image(testGpu().image(VK_FORMAT_R16G16_SFLOAT, (extent.width + ratio - 1) / ratio,
                                (extent.height + ratio - 1) / ratio)) {}

    void fill(float value, float depth) {
        std::vector<float> texels;
        for (uint32_t i = 0; i < image.ref.extent.width * image.ref.extent.height; ++i)
            texels.insert(texels.end(), {value, depth});
        testGpu().uploadFloats(image, texels);
    }
    harness::Image image;
};

// linear depth of device depth 0.5 in TestFrame's projection: 0.1 / (1.001 - 0.5)
constexpr float surfaceDepth = 0.1f / (1.001f - 0.5f);

// The mean of all frames until history weighs its most: what each step hands on is what the next one reads,
// and history swaps, before the filter or after it.
TEST_P(LightingTest, aValueOfTheEnginesIsAveragedOverFrames) {
    const Extent extent{33, 18};
    for (const bool moves : {false, true})
        for (const uint32_t ratio : {1u, 2u, 4u})
            for (const bool filtersHistory : {false, true}) {
                SceneNeeds needs = cached(1);
                needs.cameraMoves = moves; // it does not, but history is then reprojected
                auto recorder = makeRecorder(
                    info(needs, extent,
                         {.ratio = ratio, .detectsChanges = false, .filtersHistory = filtersHistory}));
                TestFrame frame(extent);
                FreshValue fresh(extent, ratio);
                double sum = 0.0;
                for (uint64_t n = 0; n < 6; ++n) {
                    const double value = n % 3 == 0 ? 0.75 : 0.25;
                    sum += value;
                    fresh.fill(static_cast<float>(value), surfaceDepth);
                    auto input = frame.input(n);
                    input.fresh = fresh.image.ref;
                    const auto lighting = lightingOf(recorder, input);
                    const size_t channels = lighting.size() / (size_t(extent.width) * extent.height);
                    for (size_t i = 0; i < lighting.size(); i += channels)
                        ASSERT_NEAR(lighting[i], sum / double(n + 1), 3e-3)
                            << "frame " << n << ", texel " << i / 2;
                }
            }
}

// Two, three or four values beside the frame's depth: each is the mean of its own frames, on either side of
// an edge in depth that the filter and the upsampling keep. Each of eight stores may take a step of binary16.
TEST_P(LightingTest, channelsOfTheEnginesAreAveragedAndUpsampled) {
    const Extent extent{32, 16};
    TestFrame frame(extent);
    std::vector<float> depths; // 0.2 m, and 9 m on the right
    for (uint32_t i = 0; i < extent.width * extent.height; ++i)
        depths.push_back(i % extent.width < 16 ? 0.5f : 0.99f);
    testGpu().uploadFloats(frame.depth, depths);
    const auto valueOf = [](uint64_t n, uint32_t channel, bool right) {
        const double own = 0.125 * (channel + 1) + (right ? 0.25 : 0.0);
        return (n + channel) % 3 == 0 ? own + 1.0 : own;
    };
    for (const uint32_t channels : {2u, 3u, 4u})
        for (const uint32_t ratio : {1u, 2u, 4u})
            for (const bool moves : {false, true})
                for (const bool filtersHistory : {false, true}) {
                    SceneNeeds needs = cached(channels);
                    needs.cameraMoves = moves; // it does not, but history is then reprojected
                    auto wanted =
                        info(needs, extent,
                             {.ratio = ratio, .detectsChanges = false, .filtersHistory = filtersHistory});
                    wanted.settings.overrides = {{"bilateral_filter.TAPS", "point"}};
                    auto recorder = makeRecorder(wanted);
                    const uint32_t width = extent.width / ratio, height = extent.height / ratio;
                    const size_t stored = channels == 2 ? 2 : 4;
                    harness::Image fresh = testGpu().image(
                        stored == 2 ? VK_FORMAT_R16G16_SFLOAT : VK_FORMAT_R16G16B16A16_SFLOAT, width, height);
                    double sums[2][4] = {};
                    for (uint64_t n = 0; n < 5; ++n) {
                        std::vector<float> texels;
                        for (uint32_t i = 0; i < width * height; ++i)
                            for (uint32_t c = 0; c < stored; ++c)
                                texels.push_back(static_cast<float>(valueOf(n, c, 2 * (i % width) >= width)));
                        testGpu().uploadFloats(fresh, texels);
                        auto input = frame.input(n);
                        input.fresh = fresh.ref;
                        const auto lighting = lightingOf(recorder, input);
                        ASSERT_EQ(lighting.size(), stored * extent.width * extent.height);
                        for (uint32_t c = 0; c < channels; ++c)
                            for (const bool right : {false, true})
                                sums[right][c] += valueOf(n, c, right);
                        for (size_t i = 0; i < lighting.size(); ++i) {
                            const size_t c = i % stored, x = i / stored % extent.width;
                            if (c >= channels) continue;
                            ASSERT_NEAR(lighting[i], sums[x >= 16][c] / double(n + 1), 8 * 0x1p-10)
                                << channels << " channels, frame " << n << ", column " << x << ", channel "
                                << c;
                        }
                    }
                }
}

TEST_P(LightingTest, withoutHistoryEveryFrameStandsAlone) {
    const Extent extent{16, 16};
    for (const bool filter : {false, true}) {
        auto recorder = makeRecorder(info(cached(1), extent, {.history = false, .filter = filter}));
        TestFrame frame(extent);
        FreshValue fresh(extent, 2);
        for (uint64_t n = 0; n < 3; ++n) {
            const float value = n == 1 ? 1.0f : 0.0f;
            fresh.fill(value, surfaceDepth);
            auto input = frame.input(n);
            input.fresh = fresh.image.ref;
            const auto lighting = lightingOf(recorder, input); // R16F
            ASSERT_EQ(lighting.size(), size_t(extent.width) * extent.height);
            for (const float each : lighting)
                ASSERT_NEAR(each, value, 1e-3f) << "frame " << n;
        }
    }
}

TEST_P(LightingTest, aResetForgetsAndSoDoesAChangeThatIsSeen) {
    const Extent extent{16, 16};
    TestFrame frame(extent);
    FreshValue fresh(extent, 2);
    const auto after = [&](bool detects, bool reset) {
        auto recorder = makeRecorder(info(cached(1), extent, {.detectsChanges = detects}));
        float last = 0.0f;
        for (uint64_t n = 0; n < 5; ++n) {
            fresh.fill(n < 4 ? 0.25f : 0.75f, surfaceDepth);
            auto input = frame.input(n);
            input.fresh = fresh.image.ref;
            input.resetHistory = reset && n == 4;
            last = lightingOf(recorder, input).front();
        }
        return last;
    };
    EXPECT_NEAR(after(false, false), 0.35f, 2e-3f) << "the mean of five";
    EXPECT_NEAR(after(false, true), 0.75f, 2e-3f);
    EXPECT_NEAR(after(true, false), 0.75f, 2e-3f);
}

// The corner between two walls, planes in space as a camera of that convention of
// depth sees it: the same occlusion in each, and less light in the corner than beside it.
TEST_P(LightingTest, aCornerIsTheSameInEveryConventionAndSize) {
    for (const Extent extent : {Extent{1, 1}, Extent{7, 5}, Extent{65, 64}})
        for (const bool orthographic : {false, true}) {
            std::vector<float> expected;
            for (int bits = 0; bits < 4; ++bits) {
                SceneNeeds needs = with(still, &SceneNeeds::ambientOcclusion);
                needs.reversedDepth = bits & 1;
                needs.linearDepth = bits & 2;
                needs.orthographic = orthographic;
                auto recorder = makeRecorder(info(needs, extent));
                TestFrame frame(extent);
                const double nearPlane = 0.1, farPlane = 50.0, range = farPlane - nearPlane;
                glm::dmat4& m = frame.camera.viewToClip;
                m = glm::dmat4(1.0);
                if (orthographic) {
                    m[2][2] = (needs.reversedDepth ? -1.0 : 1.0) / range;
                    m[3][2] = needs.reversedDepth ? farPlane / range : -nearPlane / range;
                } else {
                    m[2] = {0.0, 0.0, needs.reversedDepth ? -nearPlane / range : farPlane / range, 1.0};
                    m[3] = {0.0, 0.0, (needs.reversedDepth ? 1.0 : -1.0) * nearPlane * farPlane / range, 0.0};
                }
                std::vector<float> depths;
                for (uint32_t i = 0; i < extent.width * extent.height; ++i) {
                    const double x = 2.0 * (i % extent.width + 0.5) / extent.width - 1.0;
                    const double side = std::abs(x - 0.13),
                                 depth = orthographic ? 1.2 - 0.9 * side : 1.2 / (1.0 + 0.9 * side);
                    const double clip = m[2][2] * depth + m[3][2];
                    depths.push_back(static_cast<float>(needs.linearDepth ? depth
                                                        : orthographic    ? clip
                                                                          : clip / depth));
                }
                testGpu().uploadFloats(frame.depth, depths);
                std::vector<float> lighting;
                for (uint64_t n = 0; n < 3; ++n)
                    lighting = lightingOf(recorder, frame.input(n));
                if (expected.empty()) expected = lighting;
                // Roundings move a sample over the border of a texel here and there.
                size_t moved = 0;
                double sum = 0.0;
                for (size_t i = 0; i < lighting.size(); ++i) {
                    const double difference = std::abs(double(lighting[i]) - double(expected[i]));
                    moved += difference > 0.02 ? 1 : 0;
                    sum += difference;
                }
                EXPECT_LE(moved, 1 + lighting.size() / 100) << "convention " << bits;
                EXPECT_LT(sum / double(lighting.size()), 0.01) << "convention " << bits;
            }
            if (extent.width < 65) continue;
            const size_t row = size_t(extent.width) * 32;
            EXPECT_LT(expected[row + 32], 0.8f);
            EXPECT_GT(expected[row + 62], expected[row + 32] + 0.1f);
        }
}

// The depth of a corner, broken in one frame, in every way and all over: the outputs are numbers in [0,1]
// then, and from the next frame on they are those of a recorder that begins there.
TEST_P(LightingTest, brokenDepthIsGoneInTheNextFrame) {
    const Extent extent{32, 32};
    const SceneNeeds needs = with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::linearDepth);
    const float infinity = std::numeric_limits<float>::infinity();
    TestFrame frame(extent);
    std::vector<float> corner;
    for (uint32_t i = 0; i < extent.width * extent.height; ++i)
        corner.push_back(static_cast<float>(
            1.2 / (1.0 + 0.9 * std::abs(2.0 * (i % extent.width + 0.5) / extent.width - 1.13))));
    for (const float broken : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, -1.0f, 1e38f}) {
        auto recorder = makeRecorder(info(needs, extent)), begins = makeRecorder(info(needs, extent));
        for (uint64_t n = 0; n < 6; ++n) {
            if (n == 3)
                frame.fill(frame.depth, broken);
            else
                testGpu().uploadFloats(frame.depth, corner);
            const auto lighting = lightingOf(recorder, frame.input(n));
            for (const float each : lighting)
                ASSERT_TRUE(each >= 0.0f && each <= 1.0f) << broken << ", frame " << n;
            if (n < 4) continue;
            const auto expected = lightingOf(begins, frame.input(n));
            EXPECT_LT(expected[extent.width * 16 + 18], 0.9f) << "the corner is there";
            for (size_t i = 0; i < lighting.size(); ++i)
                ASSERT_NEAR(lighting[i], expected[i], 2e-3f) << broken << ", frame " << n << ", value " << i;
        }
    }
}

// The corner once more, by the pass with a hierarchy of its own: darker than the wall beside it, and every
// size and step records.
TEST_P(LightingTest, scalableObscuranceIsRecorded) {
    for (const Extent extent : {Extent{1, 1}, Extent{7, 5}, Extent{65, 64}})
        for (int bits = 0; bits < 4; ++bits) {
            SceneNeeds needs = with(still, &SceneNeeds::ambientOcclusion);
            needs.linearDepth = true;
            needs.cameraMoves = bits & 1;
            auto recorder = makeRecorder(
                info(needs, extent,
                     {.occlusion = "scalable_obscurance", .samples = 7, .filter = (bits & 2) != 0}));
            TestFrame frame(extent);
            std::vector<float> depths;
            for (uint32_t i = 0; i < extent.width * extent.height; ++i)
                depths.push_back(static_cast<float>(
                    1.2 / (1.0 + 0.9 * std::abs(2.0 * (i % extent.width + 0.5) / extent.width - 1.13))));
            testGpu().uploadFloats(frame.depth, depths);
            std::vector<float> lighting;
            for (uint64_t n = 0; n < 6; ++n)
                lighting = lightingOf(recorder, frame.input(n));
            if (extent.width < 65) continue;
            const size_t row = size_t(extent.width) * 32;
            EXPECT_LT(lighting[4 * (row + 36)], 0.9f);
            EXPECT_GT(lighting[4 * (row + 62)], lighting[4 * (row + 36)] + 0.05f);
        }
}

// Twelve frames without darkness, then one with it, of which the history leaves a share: its weight, by the
// tuning and by how fast the image moves. Motions of less than half a pixel find the same texel.
TEST_P(LightingTest, historyOfObscuranceWeighsLessInMotion) {
    const Extent extent{65, 64};
    SceneNeeds needs = with(still, &SceneNeeds::ambientOcclusion);
    needs.linearDepth = needs.cameraMoves = needs.engineWritesMotion = true;
    TestFrame frame(extent);
    std::vector<float> depths;
    for (uint32_t i = 0; i < extent.width * extent.height; ++i)
        depths.push_back(static_cast<float>(
            1.2 / (1.0 + 0.9 * std::abs(2.0 * (i % extent.width + 0.5) / extent.width - 1.13))));
    testGpu().uploadFloats(frame.depth, depths);
    const auto darkness = [&](bool history, float speedPx, const ObscuranceTuning& tuning) {
        auto recorder = makeRecorder(
            info(needs, extent,
                 {.occlusion = "scalable_obscurance", .samples = 7, .history = history, .filter = false}));
        std::vector<float> motion;
        for (uint32_t i = 0; i < extent.width * extent.height; ++i)
            motion.insert(motion.end(), {speedPx / static_cast<float>(extent.width), 0.0f});
        testGpu().uploadFloats(frame.motion, motion);
        std::vector<float> lighting;
        for (uint64_t n = 0; n <= 12; ++n) {
            FrameInput input = frame.input(n);
            input.cache.obscurance = tuning;
            input.cache.obscurance.intensity = n < 12 ? 0.0f : 1.0f;
            lighting = lightingOf(recorder, input);
        }
        return 1.0 - double{lighting[4 * (size_t(extent.width) * 32 + 36)]};
    };
    const auto weight = [&](float speedPx, const ObscuranceTuning& tuning) {
        return 1.0 - darkness(true, speedPx, tuning) / darkness(false, speedPx, tuning);
    };
    ASSERT_GT(darkness(false, 0.0f, {}), 0.1);
    // Half a level of red and the noise of the write, over a darkness of 0.1.
    constexpr double bound = 0.03;
    EXPECT_NEAR(weight(0.0f, {}), 0.9, bound);
    EXPECT_NEAR(weight(0.4f, {}), 0.6, bound);
    EXPECT_NEAR(weight(0.4f, {.maxWeight = 0.5f}), 0.5, bound) << "no more than at rest";
    EXPECT_NEAR(weight(0.4f, {.movingWeight = 0.3f}), 0.3, bound);
    EXPECT_NEAR(weight(0.4f, {.movingPx = 0.8f}), 0.75, bound) << "half way";
}

// A shadow map of one cascade whose left half stands in the sun: the left half of a wall that the camera
// faces is lit, the right one is not, alone and packed with occlusion.
TEST_P(LightingTest, shadowsOfTheSunAreCachedAloneAndWithOcclusion) {
    const Extent extent{64, 32};
    TestFrame frame(extent);
    harness::Image map = testGpu().image(VK_FORMAT_R32_SFLOAT, 256, 256);
    std::vector<float> depths;
    for (int i = 0; i < 256 * 256; ++i)
        depths.push_back(i % 256 < 128 ? 1.0f : 0.0f);
    testGpu().uploadFloats(map, depths);
    ShadowCascade cascade;
    cascade.farDepth = 100.0;
    cascade.worldToClip = glm::dmat4(1.0); // the sun looks along the camera, over 2 m, from 0 to 1 m
    for (const bool occlusion : {false, true})
        for (const std::string_view packing :
             {"occlusion_in_integer", "shadow_in_integer", "two", "with_frames"}) {
            SceneNeeds needs = with(still, &SceneNeeds::sunShadows);
            needs.ambientOcclusion = occlusion;
            CacheSettings cache{.cascades = 1, .packing = packing};
            cache.filter = packing != "with_frames";
            auto recorder = makeRecorder(info(needs, extent, cache));
            const uint32_t channels = occlusion ? 2 : 1;
            for (uint64_t n = 0; n < 4; ++n) {
                auto input = frame.input(n);
                input.shadowMap = map.ref;
                input.cascades = {&cascade, 1};
                input.cache.shadow.radius = 0.01;
                const auto lighting = lightingOf(recorder, input);
                for (uint32_t i = 0; i < extent.width * extent.height; ++i) {
                    const uint32_t x = i % extent.width;
                    if (x > 22 && x < 42) continue; // the filter's reach
                    ASSERT_NEAR(lighting[channels * (i + 1) - 1], x < 32 ? 1.0f : 0.0f, 0.02f)
                        << "texel " << x;
                    if (occlusion) {
                        ASSERT_NEAR(lighting[channels * i], 1.0f, 0.02f);
                    }
                }
            }
        }
}

// lighting_cache and the passes that it stands for, over a corner in a sun whose shadow ends within it, which
// moves back by less than the threshold of another surface. Depths are numbers of binary16, so that
// HALF_DEPTH takes nothing from them. What is fresh is rounded to binary16 on its way from pass to pass, by
// 2^-11, which weights multiply; what is packed by half a level of 1/31, there and here, and by up to three
// levels where change detection sees it; of packed caches half a step of 8 bits more at either end. In
// fragment shaders they are apart either way.
TEST_P(LightingTest, mergedPassesEqualThoseApart) {
    const Extent extent{67, 45};
    TestFrame frame(extent);
    const auto cornerAt = [&](double back) {
        std::vector<float> corner;
        for (uint32_t i = 0; i < extent.width * extent.height; ++i) {
            const double side = std::abs(2.0 * (i % extent.width + 0.5) / extent.width - 1.13);
            corner.push_back(
                static_cast<float>(std::round(1024.0 * 1.2 / (1.0 + 0.9 * side)) / 1024.0 + back));
        }
        return corner;
    };
    harness::Image map = testGpu().image(VK_FORMAT_R32_SFLOAT, 256, 256);
    std::vector<float> depths;
    for (int i = 0; i < 256 * 256; ++i)
        depths.push_back((i % 256 + i / 256 / 4) % 64 < 40 ? 0.995f : 0.1f);
    testGpu().uploadFloats(map, depths);
    ShadowCascade cascade;
    cascade.farDepth = 100.0;
    cascade.worldToClip = glm::dmat4(1.0);
    struct Row {
        bool occlusion, shadow;
        std::string_view packing;
        double bound, detectingBound;
    };
    const Row rows[] = {{true, false, "two", 5 * 0x1p-11, 5 * 0x1p-11},
                        {false, true, "two", 5 * 0x1p-11, 5 * 0x1p-11},
                        {true, true, "two", 5 * 0x1p-11, 5 * 0x1p-11},
                        {true, true, "shadow_in_integer", 1.05 / 31.0 + 1.0 / 255.0, 3.0 / 31.0},
                        {true, true, "occlusion_in_integer", 1.05 / 31.0 + 1.0 / 255.0, 3.0 / 31.0},
                        {true, true, "with_frames", 1.05 / 255.0, 1.05 / 255.0}};
    for (const Row& row : rows)
        for (const bool moves : {false, true})
            for (const bool detects : {false, true}) {
                SceneNeeds needs = with(still, &SceneNeeds::linearDepth);
                needs.ambientOcclusion = row.occlusion;
                needs.sunShadows = row.shadow;
                needs.cameraMoves = moves;
                CacheSettings cache{.cascades = 1, .detectsChanges = detects, .packing = row.packing};
                cache.filter = row.packing != "with_frames";
                auto merged = makeRecorder(info(needs, extent, cache));
                cache.merges = false;
                auto apart = makeRecorder(info(needs, extent, cache));
                double least = 1.0, worst = 0.0;
                for (uint64_t n = 0; n < 6; ++n) {
                    testGpu().uploadFloats(frame.depth, cornerAt(n < 4 ? 0.0 : 0x1p-4));
                    auto input = frame.input(n);
                    input.shadowMap = map.ref;
                    input.cascades = {&cascade, row.shadow ? 1u : 0u};
                    const auto one = lightingOf(merged, input), other = lightingOf(apart, input);
                    ASSERT_EQ(one.size(), other.size());
                    for (size_t i = 0; i < one.size(); ++i) {
                        worst = std::max(worst, std::abs(double(one[i]) - double(other[i])));
                        least = std::min(least, double(one[i]));
                    }
                }
                EXPECT_LE(worst, detects ? row.detectingBound : row.bound)
                    << row.packing << row.occlusion << row.shadow << moves << detects;
                EXPECT_LT(least, 0.8) << "something is occluded or in shadow";
            }
}

TEST_P(LightingTest, whatShadowsMissIsNamed) {
    const Extent extent{16, 16};
    auto recorder = makeRecorder(info(with(still, &SceneNeeds::sunShadows), extent));
    TestFrame frame(extent);
    const auto missing = recordOne(recorder, frame.input(0));
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().message.find("FrameInput::shadowMap"), std::string::npos)
        << missing.error().message;
    harness::Image map = testGpu().image(VK_FORMAT_R32_SFLOAT, 30, 10);
    testGpu().uploadFloats(map, std::vector<float>(300, 1.0f));
    auto input = frame.input(0);
    input.shadowMap = map.ref;
    const auto none = recordOne(recorder, input);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::invalidArgument);
    EXPECT_NE(none.error().message.find("cascade"), std::string::npos) << none.error().message;
    const ShadowCascade one{glm::dmat4(1.0), 10.0};
    input.cascades = {&one, 1};
    EXPECT_FALSE(recordOne(recorder, input)) << "the recorder is for three";
}

// An engine may hand the same input to several recorders: occlusion alone asks nothing of the shadow's.
TEST_P(LightingTest, occlusionTakesNoNoticeOfCascades) {
    const Extent extent{16, 16};
    auto recorder = makeRecorder(info(with(still, &SceneNeeds::ambientOcclusion), extent));
    TestFrame frame(extent);
    auto input = frame.input(0);
    const ShadowCascade one{glm::dmat4(1.0), 10.0};
    input.cascades = {&one, 1};
    const auto recorded = recordOne(recorder, input);
    EXPECT_TRUE(recorded) << recorded.error().message;
}

// Every combination of needs and steps, three frames of each in one command buffer, where synchronization
// validation sees hazards between frames too.
TEST_P(LightingTest, everyPlanRecords) {
    const Extent extent{33, 17};
    TestFrame frame(extent);
    for (int bits = 0; bits < 512; ++bits) {
        const auto bit = [&](int i) { return (bits >> i & 1) != 0; };
        const SceneNeeds needs{.antiAliasing = bit(0),
                               .cameraMoves = bit(1),
                               .objectsMove = bit(2),
                               .engineWritesMotion = bit(3),
                               .ambientOcclusion = true};
        auto wanted =
            info(needs, extent,
                 {.ratio = bit(4) ? 4u : 2u, .history = bit(5), .filter = bit(6), .filtersHistory = bit(7)});
        if (GetParam() == Stage::fragment && bit(8)) break; // where merging has no say
        wanted.settings.cache.merges = bit(8);
        wanted.needs.antiAliasing = bit(0);
        auto recorder = makeRecorder(wanted);
        testGpu().run([&](VkCommandBuffer commands) {
            for (uint64_t n = 0; n < 2; ++n) {
                const auto output = recorder.record(commands, frame.input(n));
                ASSERT_TRUE(output) << output.error().message << " needs " << bits;
                EXPECT_EQ(output->colour.image != VK_NULL_HANDLE, needs.antiAliasing);
                ASSERT_TRUE(output->lighting);
                EXPECT_EQ(output->lighting->extent.width, extent.width);
            }
        });
    }
}

TEST_P(LightingTest, missingAndMisfitInputsAreNamed) {
    const Extent extent{16, 16};
    auto recorder = makeRecorder(info(cached(1), extent));
    TestFrame frame(extent);
    const auto missing = recordOne(recorder, frame.input(0));
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::missingInput);
    EXPECT_NE(missing.error().message.find("FrameInput::fresh"), std::string::npos)
        << missing.error().message;
    FreshValue fresh(extent, 4);
    fresh.fill(0.5f, 1.0f);
    auto input = frame.input(0);
    input.fresh = fresh.image.ref;
    const auto misfit = recordOne(recorder, input);
    ASSERT_FALSE(misfit);
    EXPECT_NE(misfit.error().message.find("8x8"), std::string::npos) << misfit.error().message;
}

// An image of one colour, or one normal, at half-float's precision.
struct Light {
    Light(Extent extent, glm::vec3 colour)
        : image(testGpu().image(VK_FORMAT_R16G16B16A16_SFLOAT, extent.width, extent.height)) {
        fill(colour);
    }
    void fill(glm::vec3 colour) {
        std::vector<float> texels;
        for (uint32_t i = 0; i < image.ref.extent.width * image.ref.extent.height; ++i)
            texels.insert(texels.end(), {colour.r, colour.g, colour.b, 1.0f});
        testGpu().uploadFloats(image, texels);
    }
    harness::Image image;
};

void expectColour(const std::vector<float>& texels, size_t texel, glm::vec3 colour, const char* what) {
    for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(texels[4 * texel + static_cast<size_t>(c)], colour[c], 2e-3f * colour[c] + 2e-3f)
            << what << ", texel " << texel << ", channel " << c;
}

// A wall that the camera faces and normals that lie in it: over a surface that is turned by a right angle
// half of what is checked lies behind the wall. What lies before it leaves the image sooner and counts less
// then: up to 0.06, of the tenth of the image on either side that is within the radius of its border. With
// normals of the wall itself nothing is occluded.
TEST_P(LightingTest, theEnginesNormalsTurnTheChecks) {
    for (const Extent extent : {Extent{33, 18}, Extent{64, 48}})
        for (const uint32_t ratio : {1u, 2u, 4u})
            for (const bool facing : {false, true}) {
                auto recorder =
                    makeRecorder(info(with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::normals),
                                      extent, {.ratio = ratio}));
                TestFrame frame(extent);
                const Light normals(extent,
                                    facing ? glm::vec3(0.0f, 0.0f, -1.0f) : glm::vec3(0.6f, 0.8f, 0.0f));
                double mean = 0.0;
                for (uint64_t n = 0; n < 4; ++n) {
                    auto input = frame.input(n);
                    input.normal = normals.image.ref;
                    input.cache.radius = 0.04f; // a fifth of the surface's depth
                    input.cache.bias = {5e-4f, 0.0f};
                    const auto lighting = lightingOf(recorder, input);
                    const size_t texels = size_t(extent.width) * extent.height,
                                 channels = lighting.size() / texels;
                    mean = 0.0;
                    for (size_t i = 0; i < texels; ++i)
                        mean += lighting[i * channels] / double(texels);
                }
                if (facing)
                    EXPECT_NEAR(mean, 1.0, 2e-3) << "ratio " << ratio;
                else
                    EXPECT_NEAR(mean, 0.5, 0.06) << "ratio " << ratio;
            }
}

// Normals that are broken in one frame, all over or in a texel: the lighting is a visibility in that frame,
// and the one after is that of a wall that the camera faces.
TEST_P(LightingTest, brokenNormalsAreGoneInTheNextFrame) {
    const Extent extent{32, 32};
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float broken : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 0.0f}) {
        auto recorder = makeRecorder(
            info(with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::normals), extent));
        TestFrame frame(extent);
        Light normals(extent, glm::vec3(0.0f, 0.0f, -1.0f));
        for (uint64_t n = 0; n < 6; ++n) {
            normals.fill(n == 3 ? glm::vec3(broken) : glm::vec3(0.0f, 0.0f, -1.0f));
            auto input = frame.input(n);
            input.normal = normals.image.ref;
            const auto lighting = lightingOf(recorder, input);
            for (size_t i = 0; i < lighting.size(); ++i) {
                ASSERT_TRUE(lighting[i] >= 0.0f && lighting[i] <= 1.0f) << broken << ", frame " << n;
                if (n != 3) {
                    ASSERT_NEAR(lighting[i], 1.0f, 2e-3f) << broken << ", frame " << n;
                }
            }
        }
    }
}

TEST_P(LightingTest, normalsThatAreMissingAreNamed) {
    const Extent extent{16, 16};
    auto recorder =
        makeRecorder(info(with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::normals), extent));
    TestFrame frame(extent);
    const Light coarse({8, 8}, glm::vec3(0.0f, 0.0f, -1.0f));
    for (const bool misfit : {false, true}) {
        auto input = frame.input(0);
        if (misfit) input.normal = coarse.image.ref;
        const auto refused = recordOne(recorder, input);
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.error().code, misfit ? ErrorCode::invalidArgument : ErrorCode::missingInput);
        EXPECT_NE(refused.error().message.find("FrameInput::normal"), std::string::npos)
            << refused.error().message;
    }
}

// Full resolution with motion vectors, which the cache reads at one texel each.
TEST_P(LightingTest, fullResolutionTakesMotion) {
    const Extent extent{33, 17};
    SceneNeeds needs = with(still, &SceneNeeds::ambientOcclusion);
    needs.objectsMove = needs.engineWritesMotion = true;
    auto recorder = makeRecorder(info(needs, extent, {.ratio = 1}));
    TestFrame frame(extent);
    for (uint64_t n = 0; n < 2; ++n)
        EXPECT_EQ(lightingOf(recorder, frame.input(n)).size() % (33 * 17), 0u);
}

// A value of 1/4, constant in time, and lights: the sum by hand, at every ratio and with every last step.
TEST_P(LightingTest, theEnginesLightsAreCombinedWithACachedValue) {
    const Extent extent{17, 9};
    const glm::vec3 ambient(0.8f, 0.4f, 12.0f), other(0.1f, 3.0f, 0.0f);
    for (const uint32_t ratio : {1u, 2u, 4u})
        for (int bits = 0; bits < 8; ++bits) {
            SceneNeeds needs = with(cached(1), &SceneNeeds::combinesLighting);
            needs.otherLight = bits & 1;
            auto recorder = makeRecorder(
                info(needs, extent, {.ratio = ratio, .history = (bits & 2) != 0, .filter = (bits & 4) != 0}));
            TestFrame frame(extent);
            FreshValue fresh(extent, ratio);
            fresh.fill(0.25f, surfaceDepth);
            const Light ambientLight(extent, ambient), otherLight(extent, other);
            for (uint64_t n = 0; n < 2; ++n) {
                auto input = frame.input(n);
                input.fresh = fresh.image.ref;
                input.ambientLight = ambientLight.image.ref;
                input.otherLight = otherLight.image.ref;
                const auto output = recordOne(recorder, input);
                ASSERT_TRUE(output) << output.error().message;
                ASSERT_TRUE(output->lit);
                const auto lit = downloadRef(*output->lit);
                for (size_t i = 0; i < lit.size() / 4; ++i)
                    expectColour(lit, i, 0.25f * ambient + (needs.otherLight ? other : glm::vec3(0.0f)),
                                 "lit");
            }
        }
}

// The wall whose left half stands in the sun, combined, and then blended by anti-aliasing with a history that
// weighs 3/4: the second frame is a quarter of its own light and three of the first's. No colour is handed
// over.
TEST_P(LightingTest, combinedLightIsAntiAliased) {
    const Extent extent{64, 32};
    TestFrame frame(extent);
    harness::Image map = testGpu().image(VK_FORMAT_R32_SFLOAT, 256, 256);
    std::vector<float> depths;
    for (int i = 0; i < 256 * 256; ++i)
        depths.push_back(i % 256 < 128 ? 1.0f : 0.0f);
    testGpu().uploadFloats(map, depths);
    ShadowCascade cascade;
    cascade.farDepth = 100.0;
    cascade.worldToClip = glm::dmat4(1.0);
    SceneNeeds needs = with(with(still, &SceneNeeds::sunShadows), &SceneNeeds::combinesLighting);
    needs.ambientOcclusion = true;
    auto wanted = info(needs, extent, {.cascades = 1});
    wanted.needs.antiAliasing = true;
    wanted.settings.overrides = plainBlend();
    auto recorder = makeRecorder(wanted);
    const glm::vec3 ambient(0.25f, 0.5f, 0.75f), sun(2.0f, 1.0f, 0.5f);
    Light ambientLight(extent, ambient);
    const Light sunLight(extent, sun);
    for (uint64_t n = 0; n < 2; ++n) {
        ambientLight.fill(n == 0 ? ambient : glm::vec3(0.0f));
        auto input = frame.input(n);
        input.colour = {};
        input.shadowMap = map.ref;
        input.cascades = {&cascade, 1};
        input.cache.shadow.radius = 0.01;
        input.ambientLight = ambientLight.image.ref;
        input.sunLight = sunLight.image.ref;
        input.tuning = TaaTuning{.feedbackMin = 0.75f, .feedbackMax = 0.75f};
        const auto output = recordOne(recorder, input);
        ASSERT_TRUE(output) << output.error().message;
        ASSERT_TRUE(output->lit);
        const auto lit = downloadRef(*output->lit), colour = downloadRef(output->colour);
        for (size_t i = 0; i < lit.size() / 4; ++i) {
            const size_t x = i % extent.width;
            if (x > 19 && x < 44) continue; // reach of the disc, of eight pixels of filter, and of upsampling
            const glm::vec3 direct = x < 32 ? sun : glm::vec3(0.0f);
            expectColour(lit, i, direct + (n == 0 ? ambient : glm::vec3(0.0f)), "lit");
            expectColour(colour, i, direct + (n == 0 ? 1.0f : 0.75f) * ambient, "colour");
        }
    }
}

TEST_P(LightingTest, lightsThatAreMissingAreNamed) {
    const Extent extent{16, 16};
    SceneNeeds needs = with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::combinesLighting);
    needs.sunShadows = needs.otherLight = true;
    auto recorder = makeRecorder(info(needs, extent, {.cascades = 1}));
    TestFrame frame(extent);
    harness::Image map = testGpu().image(VK_FORMAT_R32_SFLOAT, 8, 8);
    testGpu().uploadFloats(map, std::vector<float>(64, 1.0f));
    const ShadowCascade cascade{glm::dmat4(1.0), 10.0};
    const Light light(extent, glm::vec3(1.0f)), small({8, 16}, glm::vec3(1.0f));
    const std::pair<std::optional<ImageRef> FrameInput::*, const char*> lights[] = {
        {&FrameInput::ambientLight, "FrameInput::ambientLight"},
        {&FrameInput::sunLight, "FrameInput::sunLight"},
        {&FrameInput::otherLight, "FrameInput::otherLight"}};
    const auto input = [&] {
        auto made = frame.input(0);
        made.shadowMap = map.ref;
        made.cascades = {&cascade, 1};
        for (const auto& [field, name] : lights)
            made.*field = light.image.ref;
        return made;
    };
    for (const auto& [field, name] : lights)
        for (const bool misfit : {false, true}) {
            auto wrong = input();
            wrong.*field = misfit ? std::optional(small.image.ref) : std::nullopt;
            const auto refused = recordOne(recorder, wrong);
            ASSERT_FALSE(refused) << name;
            EXPECT_EQ(refused.error().code, misfit ? ErrorCode::invalidArgument : ErrorCode::missingInput);
            EXPECT_NE(refused.error().message.find(name), std::string::npos) << refused.error().message;
        }
    EXPECT_TRUE(recordOne(recorder, input()));
}

// A light that is broken all over for a frame shows in that frame alone, and bounded.
TEST_P(LightingTest, brokenLightIsGoneInTheNextFrame) {
    const Extent extent{16, 16};
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float broken : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
        auto wanted =
            info(with(with(still, &SceneNeeds::ambientOcclusion), &SceneNeeds::combinesLighting), extent);
        wanted.needs.antiAliasing = true;
        auto recorder = makeRecorder(wanted);
        TestFrame frame(extent);
        Light ambientLight(extent, glm::vec3(0.5f));
        for (uint64_t n = 0; n < 4; ++n) {
            ambientLight.fill(glm::vec3(n == 2 ? broken : 0.5f));
            auto input = frame.input(n);
            input.ambientLight = ambientLight.image.ref;
            const auto output = recordOne(recorder, input);
            ASSERT_TRUE(output) << output.error().message;
            for (const ImageRef& image : {*output->lit, output->colour})
                for (const float each : downloadRef(image)) {
                    ASSERT_TRUE(each >= 0.0f && each <= 65504.0f) << broken << ", frame " << n;
                    if (n != 2) {
                        ASSERT_TRUE(std::abs(each - 0.5f) < 2e-3f || each == 1.0f) << broken << ": " << each;
                    }
                }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Stages, LightingTest, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) {
                             return each.param == Stage::fragment ? "fragment" : "compute";
                         });

} // namespace
