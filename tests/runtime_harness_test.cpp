// SPDX-License-Identifier: Apache-2.0
// The harness itself: transfers and half precision must be exact, for every other test stands on them.
#include "runtime_support.hpp"

#include <bit>
#include <cmath>
#include <random>

namespace {

class HarnessTest : public RuntimeTest {};

TEST(Half, everyPatternSurvivesTheRoundTrip) {
    for (uint32_t bits = 0; bits < 0x10000; ++bits) {
        const auto half = static_cast<uint16_t>(bits);
        const float value = harness::halfToFloat(half);
        if (std::isnan(value))
            EXPECT_TRUE(std::isnan(harness::halfToFloat(harness::floatToHalf(value)))) << bits;
        else
            EXPECT_EQ(harness::floatToHalf(value), half) << bits;
    }
}

// Between two neighbours: below the middle goes down, above goes up, the middle to the even one.
TEST(Half, roundsToNearestEven) {
    for (uint32_t bits = 0; bits < 0x7bffu; ++bits) {
        const auto lower = static_cast<uint16_t>(bits);
        const float a = harness::halfToFloat(lower),
                    b = harness::halfToFloat(static_cast<uint16_t>(bits + 1));
        const float middle = (a + b) * 0.5f; // exact: 12 significant bits
        const auto even = static_cast<uint16_t>(bits + (bits & 1u));
        EXPECT_EQ(harness::floatToHalf(middle), even) << bits;
        EXPECT_EQ(harness::floatToHalf(std::nextafter(middle, a)), lower) << bits;
        EXPECT_EQ(harness::floatToHalf(std::nextafter(middle, b)), bits + 1) << bits;
        EXPECT_EQ(harness::floatToHalf(-middle), even | 0x8000u) << bits;
    }
    EXPECT_EQ(harness::floatToHalf(65519.99f), 0x7bffu) << "the largest finite one";
    EXPECT_EQ(harness::floatToHalf(65520.0f), 0x7c00u) << "half a unit above it is infinity";
}

TEST_F(HarnessTest, texelsComeBackAsTheyWere) {
    std::mt19937 random(3);
    for (const auto* name :
         {"r8", "rg8", "rgba8", "r16f", "rg16f", "rgba16f", "r32f", "rg32f", "rgba32f", "d32f"}) {
        const VkFormat format = harness::formatByName(name);
        auto image = testGpu().image(format, 13, 7);
        std::vector<float> values(13 * 7 * harness::channelCount(format));
        // Multiples of 1/255 for unorm; of 1/64 within [0, 1] for the rest, exact in binary16.
        const bool unorm = std::string_view(name).ends_with('8');
        for (float& value : values)
            value = unorm ? static_cast<float>(random() % 256) / 255.0f
                          : static_cast<float>(random() % 65) / 64.0f;
        testGpu().uploadFloats(image, values);
        EXPECT_EQ(testGpu().downloadFloats(image), values) << name;
    }
}

std::string messageOf(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no error";
}

TEST_F(HarnessTest, mistakesAreSentences) {
    const auto has = [](const std::string& text, const char* part) {
        EXPECT_NE(text.find(part), std::string::npos) << text;
    };
    has(messageOf([] { harness::Gpu gpu({.device = "no such card", .validation = false}); }),
        "choose one of: 0 ");
    has(messageOf([] { harness::Gpu gpu({.device = "77", .validation = false}); }), "'77'");
    has(messageOf([] { testGpu().image(VK_FORMAT_R8_UNORM, 0, 4); }), "0x4");
    has(messageOf([] { testGpu().image(VK_FORMAT_R8_UNORM, 1u << 20, 4); }), "as large as");
    has(messageOf([] { testGpu().image(VK_FORMAT_R8_UNORM, 4, 4, 64); }), "64 samples");
    has(messageOf(
            [] { testGpu().image(VK_FORMAT_D32_SFLOAT, 4, 4, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT); }),
        "d32f");
    has(messageOf([] { harness::formatByName("rgb7"); }), "rgb7");
    auto image = testGpu().image(VK_FORMAT_R32_SFLOAT, 2, 2);
    has(messageOf([&] { testGpu().uploadFloats(image, std::vector{1.0f}); }), "4 values");
    has(messageOf([&] { testGpu().download(image); }), "no content");
}

TEST_F(HarnessTest, theDeviceSaysWhatItIs) {
    EXPECT_FALSE(testGpu().name().empty());
    EXPECT_FALSE(testGpu().driver().empty());
    harness::Gpu byName({.device = testGpu().name(), .validation = false});
    EXPECT_EQ(byName.name(), testGpu().name());
}

} // namespace
