// SPDX-License-Identifier: Apache-2.0
// History between texels of two surfaces. What is packed takes the texels of its own one and all their
// frames; the mean of what a linear filter reads is of neither, and is given up.
#include "reprojection_cache_case.hpp"

namespace passes {
namespace {

class CachedHistory : public PassTest, public testing::WithParamInterface<Stage> {};
INSTANTIATE_TEST_SUITE_P(Stages, CachedHistory, testing::Values(Stage::fragment, Stage::compute),
                         [](const auto& each) { return stageText(each.param); });

constexpr float ownDepth = 5.0f, otherDepth = 9.0f, frames = 7.0f;

// Columns of the history are of this surface and of another in turn, and everything comes from half a texel
// to the left.
ReprojectionCacheCase betweenTwo(const Variant& variant) {
    ReprojectionCacheCase frame = reprojectionCacheCase(variant, 32, 32, 131);
    frame.pass.previous = frame.pass.current;
    setParameters(frame);
    const auto values = frame.pass.values;
    const bool framed = values == oracle::CachePass::Values::withFrames;
    const auto isOwn = [](int x) { return x % 2 == 0; };
    const auto depth = [&](int x) { return isOwn(x) ? ownDepth : otherDepth; };
    frame.coarseDepth = makePixels(r32f, 16, 16, [](int, int) { return Texel{ownDepth}; });
    frame.fresh = makePixels(rgba32f, 16, 16, [&](int, int) {
        const glm::dvec4 fresh(1.0, 0.0, 0.0, 0.0);
        const glm::vec4 texel(framed ? fresh : oracle::packedValues(values, fresh, ownDepth));
        return Texel{texel.x, texel.y};
    });
    frame.history = makePixels(rgba32f, 16, 16, [&](int x, int) {
        const glm::dvec4 held = isOwn(x) ? glm::dvec4(0.25, 0.75, 0.0, 0.0) : glm::dvec4(1.0, 0.0, 0.0, 0.0);
        const glm::vec4 texel(oracle::packedValues(values, held, depth(x), isOwn(x) ? frames : 15.0));
        return Texel{texel.x, texel.y};
    });
    frame.state = makePixels(rg32f, 16, 16, [&](int x, int) { return Texel{frames, depth(x)}; });
    frame.historyDepth = depthsOf(frame.state);
    frame.velocity = makePixels(rg32f, 32, 32, [&](int, int) {
        return Texel{static_cast<float>(0.5 / 16.0 / frame.pass.motionToUv.x)};
    });
    return frame;
}

TEST_P(CachedHistory, packedTexelsOfAnotherSurfaceTakeNothing) {
    for (const std::string_view values : {"with_frames", "shadow_in_integer", "occlusion_in_integer"}) {
        const Variant variant =
            variantOf(pack(), "reprojection_cache", {{"VALUES", values}, {"HISTORY", "motion"}});
        const bool framed = values == "with_frames";
        Pass pass(variant, GetParam(), cacheFormats(variant));
        const ReprojectionCacheCase frame = betweenTwo(variant);
        const auto got = run(pass, frame);
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const float packed = got[0].at(x, y, 0);
                const glm::dvec4 held = oracle::unpackedValues(frame.pass.values, {packed, 0.0, 0.0, 0.0});
                const double count = framed ? oracle::unpackedWithFrames(packed).z : got[1].at(x, y, 0);
                // Seven frames of the history and one fresh; a step of 1/31 either way, packed so.
                const double step = framed ? 1e-3 : 1.0 / 31.0;
                ASSERT_NEAR(held.x, (7.0 * 0.25 + 1.0) / 8.0, step) << values << " at " << x << ", " << y;
                ASSERT_NEAR(held.y, 7.0 * 0.75 / 8.0, step) << values << " at " << x << ", " << y;
                ASSERT_NEAR(count, 8.0, 1e-3) << values << " at " << x << ", " << y;
            }
    }
}

TEST_P(CachedHistory, aFilteredMeanOfTwoSurfacesIsGivenUp) {
    const Variant variant =
        variantOf(pack(), "reprojection_cache", {{"VALUES", "two"}, {"HISTORY", "motion"}});
    Pass pass(variant, GetParam(), {rgba32f, rg32f});
    const auto got = run(pass, betweenTwo(variant));
    for (int y = 0; y < 16; ++y)
        for (int x = 1; x < 16; ++x) { // in the first column the border's own texel stands twice
            ASSERT_EQ(got[0].at(x, y, 0), 1.0f);
            ASSERT_EQ(got[1].at(x, y, 0), 1.0f);
        }
}

} // namespace
} // namespace passes
