// SPDX-License-Identifier: Apache-2.0
// What the tests of passes share: a device with validation, the pack, and a pass as a call from images to
// images.
#pragma once

#include "harness.hpp"
#include "oracle/oracle.hpp"
#include "reprisec.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace passes {

using reprise::Stage;
using reprise::Variant;

// An image on the CPU. Its values are ones that `format` can hold, so that upload and oracle see the same.
struct Pixels {
    VkFormat format = VK_FORMAT_UNDEFINED;
    int width = 0, height = 0, channels = 0;
    std::vector<float> values;

    float& at(int x, int y, int channel);
    float at(int x, int y, int channel) const;
};

using Texel = std::array<float, 4>;
Pixels makePixels(VkFormat format, int width, int height, const std::function<Texel(int x, int y)>& texelAt);
oracle::Image oracleImage(const Pixels& pixels);

// The formats of the table for the outputs of a variant, but of 32 bits where they have 16.
std::vector<VkFormat> wideFormats(const Variant& variant);

harness::Gpu& gpu();
// hlsl/pack.toml of the repository, which is the working directory of every test.
const reprisec::Pack& pack();
Variant variantOf(const reprisec::Pack& from, std::string_view pass,
                  const std::vector<reprise::Condition>& switches = {});
std::vector<Variant> committedVariants(std::string_view pass);
// `count` variants with every switch drawn at random.
std::vector<Variant> randomVariants(std::string_view pass, int count, uint64_t seed);

using PlatformSwitches = std::map<std::string, int>;
// SPIR-V of a variant, compiled once in each program.
const std::vector<uint32_t>& spirvOf(const reprisec::Pack& from, const Variant& variant, Stage stage,
                                     const PlatformSwitches& platform = {});

struct NamedPixels {
    std::string_view name;
    const Pixels* pixels;
};

// A variant as a pipeline. Outputs have the table's formats unless others are given.
class Pass {
public:
    Pass(const Variant& variant, Stage stage, std::vector<VkFormat> outputFormats = {},
         const reprisec::Pack& from = pack(), const PlatformSwitches& platform = {});
    // Drawn by `vertexSpirv` in place of the pass fullscreen's.
    Pass(const Variant& variant, Stage stage, std::vector<VkFormat> outputFormats,
         std::span<const uint32_t> spirv, std::span<const uint32_t> vertexSpirv = {});

    const Variant& variant() const { return variant_; }
    // The outputs of the variant in table order. Inputs that the variant has not are passed over. Before the
    // run each output holds NaN, which a pixel that is not written keeps.
    template <class Parameters>
    std::vector<Pixels> operator()(std::span<const NamedPixels> inputs, const Parameters& parameters,
                                   int width, int height) {
        return run(inputs, std::as_bytes(std::span(&parameters, 1)), width, height);
    }
    std::vector<Pixels> run(std::span<const NamedPixels> inputs, std::span<const std::byte> parameters,
                            int width, int height);

private:
    Variant variant_;
    std::vector<std::string_view> outputNames_;
    std::vector<VkFormat> outputFormats_;
    harness::PassRunner runner_;
};

// Largest error of the weights of the device's linear filter, in texels, at the sizes that the tests use.
double linearFilterError();

// Fails a test that leaves a validation message behind.
class PassTest : public testing::Test {
protected:
    void SetUp() override { gpu().takeValidationMessages(); }
    void TearDown() override;
};

std::string stageText(Stage stage);
std::string describe(const Variant& variant, Stage stage, int width, int height);

// A reproducible stream of numbers: splitmix64 of seed and place.
uint64_t hashOf(uint64_t seed, uint64_t a, uint64_t b = 0, uint64_t c = 0);
double unitHash(uint64_t seed, uint64_t a, uint64_t b = 0, uint64_t c = 0); // [0, 1)
// Noise of high contrast: every value is below 1/8 or above 7/8, and hardly two are equal.
Pixels highContrastNoise(VkFormat format, int width, int height, uint64_t seed);

inline constexpr VkFormat rgba16f = VK_FORMAT_R16G16B16A16_SFLOAT, rgba32f = VK_FORMAT_R32G32B32A32_SFLOAT;
inline constexpr VkFormat rg16f = VK_FORMAT_R16G16_SFLOAT, rg32f = VK_FORMAT_R32G32_SFLOAT;
inline constexpr VkFormat r32f = VK_FORMAT_R32_SFLOAT;

// Rounding of a value to an output's format. Half-float stores may truncate (Mesa's do): one step of 11 bits.
double storeError(VkFormat format, double value);

} // namespace passes
