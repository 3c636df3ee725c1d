// SPDX-License-Identifier: Apache-2.0
// lighting_cache against the passes whose work it does in one: ambient_occlusion, sun_shadow and
// reprojection_cache, which their own tests hold to the oracle.
#include "lighting_cache_case.hpp"

#include <cmath>
#include <limits>

namespace passes {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class LightingCache : public PassTest {};

std::vector<Variant> allVariants() {
    std::vector<Variant> variants;
    const auto add = [&](std::vector<reprise::Condition> switches) {
        variants.push_back(variantOf(pack(), "lighting_cache", switches));
    };
    struct Kind {
        std::string_view values, fresh;
    };
    for (const Kind kind : {Kind{"one", "occlusion"},
                            {"one", "shadow"},
                            {"two", "both"},
                            {"occlusion_in_integer", "both"},
                            {"shadow_in_integer", "both"},
                            {"with_frames", "both"}})
        for (const std::string_view change : {"off", "on"})
            for (const std::string_view history : {"camera", "motion", "still", "none"})
                for (const std::string_view orthographic : {"off", "on"})
                    add({{"VALUES", kind.values},
                         {"FRESH", kind.fresh},
                         {"CHANGE_DETECTION", change},
                         {"HISTORY", history},
                         {"ORTHOGRAPHIC", orthographic},
                         {"HALF_DEPTH", kind.fresh == "shadow" ? "off" : "on"}});
    add({{"NORMALS", "read"}});
    add({{"SAMPLES", "8"}, {"RESAMPLING", "nearest"}, {"CHANGE_DETECTION", "on"}});
    add({{"RESAMPLING", "nearest"}, {"VALUES", "with_frames"}, {"FRESH", "both"}, {"SAMPLES", "1"}});
    add({{"CASCADES", "4"}, {"SHADOW_REVERSED", "on"}, {"FRESH", "both"}, {"VALUES", "two"}});
    return variants;
}

TEST_F(LightingCache, equalsThePassesWhoseWorkItDoes) {
    for (const Variant& variant : allVariants()) {
        // There what is fresh is packed before it is looked at.
        if (reprise::switchValue(variant, "VALUES").ends_with("in_integer") &&
            reprise::switchValue(variant, "CHANGE_DETECTION") == "on")
            continue;
        Pass merged(variant, Stage::compute, cacheFormats(variant));
        SeparatePasses separate(variant);
        for (const auto& [width, height] : {std::pair{1, 1}, {2, 2}, {7, 5}, {39, 37}}) {
            const LightingCacheCase frame = lightingCacheCase(variant, width, height, 121);
            const Comparison result = compareWithSeparate(frame, run(merged, frame), separate(frame));
            EXPECT_TRUE(result.holds())
                << describe(variant, Stage::compute, width, height) << ": " << text(result);
        }
    }
}

// Packed values are those of two, but for the steps that packing leaves: of the change that is detected too,
// which is not looked for in what is packed.
TEST_F(LightingCache, packedPairsAreThoseOfTwoValues) {
    for (const std::string_view packing : {"occlusion_in_integer", "shadow_in_integer"}) {
        const auto variant = [](std::string_view values) {
            return variantOf(
                pack(), "lighting_cache",
                {{"VALUES", values}, {"FRESH", "both"}, {"HISTORY", "still"}, {"CHANGE_DETECTION", "on"}});
        };
        const Variant packed = variant(packing), two = variant("two");
        Pass one(packed, Stage::compute, {rgba32f, rg32f}), apart(two, Stage::compute, {rgba32f, rg32f});
        const LightingCacheCase frame = lightingCacheCase(packed, 39, 37, 124);
        LightingCacheCase unpacked = frame;
        const auto values = frame.cache.pass.values;
        const auto pairOf = [&](const Pixels& image, int x, int y) {
            return oracle::unpackedValues(values, {image.at(x, y, 0), 0.0, 0.0, 0.0});
        };
        unpacked.cache.history = makePixels(rgba32f, 39, 37, [&](int x, int y) {
            const glm::vec4 pair(pairOf(frame.cache.history, x, y));
            return Texel{pair.x, pair.y};
        });
        const Pixels got = run(one, frame)[0], expected = run(apart, unpacked)[0];
        const double inInteger = 0.5 / 31.0 + 1e-5, inFraction = 1e-5;
        const bool occlusionFirst = values == oracle::CachePass::Values::occlusionInInteger;
        for (int y = 0; y < 37; ++y)
            for (int x = 0; x < 39; ++x) {
                const glm::dvec4 pair = pairOf(got, x, y);
                ASSERT_NEAR(pair.x, expected.at(x, y, 0), occlusionFirst ? inInteger : inFraction);
                ASSERT_NEAR(pair.y, expected.at(x, y, 1), occlusionFirst ? inFraction : inInteger);
            }
    }
}

// Broken texels of every input: all that comes out is what a history can hold.
TEST_F(LightingCache, brokenTexelsLeaveNumbers) {
    for (const Variant& variant : allVariants()) {
        Pass merged(variant, Stage::compute, cacheFormats(variant));
        for (const float value :
             {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity, 1e38f, 1e-30f}) {
            LightingCacheCase frame = lightingCacheCase(variant, 33, 17, 122);
            for (Pixels* poisoned :
                 {&frame.occlusion.depth, &frame.halfDepth, &frame.occlusion.normal, &frame.shadow.map,
                  &frame.cache.velocity, &frame.cache.history, &frame.cache.state, &frame.cache.historyDepth})
                for (size_t i = 0; i < poisoned->values.size(); i += 5)
                    poisoned->values[i] = value;
            for (const Pixels& got : run(merged, frame))
                for (const float each : got.values)
                    ASSERT_TRUE(std::abs(each) <= (got.format == r32f ? 0x1p24f : 65504.0f))
                        << describe(variant, Stage::compute, 33, 17) << ": " << value;
        }
    }
}

// What is not computed is 1, and of both in one value the product is kept.
TEST_F(LightingCache, oneValueOfBothIsTheirProduct) {
    const auto variant = [](std::string_view fresh, std::string_view values) {
        return variantOf(pack(), "lighting_cache",
                         {{"FRESH", fresh}, {"VALUES", values}, {"HISTORY", "none"}});
    };
    const Variant both = variant("both", "one"), two = variant("both", "two"),
                  first = variant("occlusion", "two");
    Pass product(both, Stage::compute, {rgba32f, rg32f}), apart(two, Stage::compute, {rgba32f, rg32f});
    Pass alone(first, Stage::compute, {rgba32f, rg32f});
    const LightingCacheCase frame = lightingCacheCase(two, 39, 37, 123);
    const Pixels one = run(product, frame)[0], pair = run(apart, frame)[0];
    const Pixels occlusion = run(alone, frame)[0];
    for (int y = 0; y < 37; ++y)
        for (int x = 0; x < 39; ++x) {
            ASSERT_NEAR(one.at(x, y, 0), pair.at(x, y, 0) * pair.at(x, y, 1), 1e-5f);
            ASSERT_NEAR(occlusion.at(x, y, 0), pair.at(x, y, 0), 1e-5f);
            ASSERT_EQ(occlusion.at(x, y, 1), 1.0f);
        }
}

} // namespace
} // namespace passes
