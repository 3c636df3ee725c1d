// SPDX-License-Identifier: Apache-2.0
#include "bench.hpp"

#include "viewport_shift.hpp"

#include <cmath>
#include <limits>

namespace passes {

namespace {

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

bool isHalf(VkFormat format) {
    return format == rgba16f || format == rg16f || format == VK_FORMAT_R16_SFLOAT;
}

Pixels emptyPixels(VkFormat format, int width, int height) {
    const int channels = static_cast<int>(harness::channelCount(format));
    return {format, width, height, channels,
            std::vector<float>(static_cast<size_t>(width * height * channels))};
}

harness::Image uploaded(const Pixels& pixels) {
    auto image =
        gpu().image(pixels.format, static_cast<uint32_t>(pixels.width), static_cast<uint32_t>(pixels.height));
    gpu().uploadFloats(image, pixels.values);
    return image;
}

std::vector<VkFormat> tableFormats(const Variant& variant) {
    std::vector<VkFormat> formats;
    for (const auto& output : variant.pass->outputs)
        if (reprise::exists(variant, output))
            formats.push_back(harness::formatByName(reprise::formatOf(variant, output)));
    return formats;
}

std::vector<std::string_view> outputNames(const Variant& variant) {
    std::vector<std::string_view> names;
    for (const auto& output : variant.pass->outputs)
        if (reprise::exists(variant, output)) names.push_back(output.name);
    return names;
}

const std::vector<uint32_t>& fullscreenSpirv() {
    return spirvOf(pack(), variantOf(pack(), "fullscreen"), Stage::vertex);
}

const reprise::PassInfo& passInfo(const reprisec::Pack& from, std::string_view name) {
    for (const auto& pass : from.passes())
        if (pass.name == name) return pass;
    throw std::runtime_error("The table has no pass " + std::string(name) + ".");
}

} // namespace

float& Pixels::at(int x, int y, int channel) {
    return values[static_cast<size_t>((y * width + x) * channels + channel)];
}

float Pixels::at(int x, int y, int channel) const {
    return values[static_cast<size_t>((y * width + x) * channels + channel)];
}

Pixels makePixels(VkFormat format, int width, int height, const std::function<Texel(int x, int y)>& texelAt) {
    Pixels pixels = emptyPixels(format, width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Texel texel = texelAt(x, y);
            for (int c = 0; c < pixels.channels; ++c) {
                const float value = texel[static_cast<size_t>(c)];
                pixels.at(x, y, c) =
                    isHalf(format) ? harness::halfToFloat(harness::floatToHalf(value)) : value;
            }
        }
    }
    return pixels;
}

oracle::Image oracleImage(const Pixels& pixels) {
    oracle::Image image(pixels.width, pixels.height, glm::dvec4(0.0, 0.0, 0.0, 1.0));
    for (int y = 0; y < pixels.height; ++y)
        for (int x = 0; x < pixels.width; ++x)
            for (int c = 0; c < pixels.channels; ++c)
                image.at(x, y)[c] = pixels.at(x, y, c);
    return image;
}

harness::Gpu& gpu() {
    static harness::Gpu instance(
        {.device = "", .validation = true, .getInstanceProcAddr = getInstanceProcAddrForShift});
    return instance;
}

const reprisec::Pack& pack() {
    static const reprisec::Pack instance = orThrow(reprisec::Pack::load("hlsl/pack.toml"));
    return instance;
}

Variant variantOf(const reprisec::Pack& from, std::string_view pass,
                  const std::vector<reprise::Condition>& switches) {
    Variant variant = orThrow(reprise::makeVariant(from.passes(), pass));
    for (const auto& each : switches) {
        const auto done = reprise::setSwitch(variant, each.switchName, each.value);
        if (!done) throw std::runtime_error(done.error().message);
    }
    return variant;
}

std::vector<Variant> committedVariants(std::string_view pass) {
    return pack().committedVariants(passInfo(pack(), pass));
}

std::vector<Variant> randomVariants(std::string_view pass, int count, uint64_t seed) {
    std::vector<Variant> variants;
    for (int i = 0; i < count; ++i) {
        Variant variant = variantOf(pack(), pass);
        const auto switches = variant.pass->switches;
        variant.values.clear();
        for (size_t s = 0; s < switches.size(); ++s)
            variant.values.push_back(
                static_cast<uint8_t>(hashOf(seed, static_cast<uint64_t>(i), s) % switches[s].values.size()));
        variants.push_back(variant);
    }
    return variants;
}

const std::vector<uint32_t>& spirvOf(const reprisec::Pack& from, const Variant& variant, Stage stage,
                                     const PlatformSwitches& platform) {
    static std::map<std::string, std::vector<uint32_t>> cache;
    std::string key =
        from.file().string() + "|" + reprise::spirvFileName(reprise::forStage(variant, stage), stage);
    for (const auto& [name, value] : platform)
        key += "|" + name + std::to_string(value);
    const auto found = cache.find(key);
    if (found != cache.end()) return found->second;
    auto compiled =
        orThrow(reprisec::compile(from, variant, stage, {.glsl = false, .platformSwitches = platform}));
    return cache.emplace(key, std::move(compiled.spirv)).first->second;
}

Pass::Pass(const Variant& variant, Stage stage, std::vector<VkFormat> outputFormats,
           const reprisec::Pack& from, const PlatformSwitches& platform)
    : Pass(variant, stage, std::move(outputFormats), spirvOf(from, variant, stage, platform)) {}

Pass::Pass(const Variant& variant, Stage stage, std::vector<VkFormat> outputFormats,
           std::span<const uint32_t> spirv, std::span<const uint32_t> vertexSpirv)
    : variant_(variant), outputNames_(outputNames(variant)),
      outputFormats_(outputFormats.empty() ? tableFormats(variant) : std::move(outputFormats)),
      runner_(gpu(), variant, stage, spirv, vertexSpirv.empty() ? fullscreenSpirv() : vertexSpirv,
              outputFormats_) {}

std::vector<Pixels> Pass::run(std::span<const NamedPixels> inputs, std::span<const std::byte> parameters,
                              int width, int height) {
    std::vector<harness::Image> images;
    std::vector<std::string_view> names;
    for (const auto& input : variant_.pass->inputs) {
        for (const NamedPixels& given : inputs) {
            if (given.name != input.name || !reprise::exists(variant_, input)) continue;
            images.push_back(uploaded(*given.pixels));
            names.push_back(input.name);
        }
    }
    const size_t firstOutput = images.size();
    for (size_t i = 0; i < outputNames_.size(); ++i) {
        Pixels unwritten = emptyPixels(outputFormats_[i], width, height);
        std::fill(unwritten.values.begin(), unwritten.values.end(), std::numeric_limits<float>::quiet_NaN());
        images.push_back(uploaded(unwritten));
        names.push_back(outputNames_[i]);
    }
    std::vector<harness::PassRunner::Binding> bindings;
    for (size_t i = 0; i < images.size(); ++i)
        bindings.push_back({names[i], &images[i]});
    gpu().run([&](VkCommandBuffer commands) { runner_.record(commands, bindings, parameters); });
    std::vector<Pixels> results;
    for (size_t i = firstOutput; i < images.size(); ++i) {
        results.push_back(emptyPixels(outputFormats_[i - firstOutput], width, height));
        results.back().values = gpu().downloadFloats(images[i]);
    }
    return results;
}

void PassTest::TearDown() {
    std::string text;
    for (const std::string& message : gpu().takeValidationMessages())
        text += message + "\n";
    EXPECT_EQ(text, "") << "the validation layer spoke";
}

std::string stageText(Stage stage) {
    return stage == Stage::compute ? "compute" : stage == Stage::fragment ? "fragment" : "vertex";
}

std::string describe(const Variant& variant, Stage stage, int width, int height) {
    return reprise::variantName(reprise::forStage(variant, stage)) + ", " + stageText(stage) + ", " +
           std::to_string(width) + "x" + std::to_string(height);
}

uint64_t hashOf(uint64_t seed, uint64_t a, uint64_t b, uint64_t c) {
    uint64_t z = seed + 0x9e3779b97f4a7c15u * (1 + a + 7919 * b + 104729 * c);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double unitHash(uint64_t seed, uint64_t a, uint64_t b, uint64_t c) {
    return static_cast<double>(hashOf(seed, a, b, c) >> 11) * 0x1p-53;
}

Pixels highContrastNoise(VkFormat format, int width, int height, uint64_t seed) {
    return makePixels(format, width, height, [seed](int x, int y) {
        Texel texel{};
        for (size_t c = 0; c < 4; ++c) {
            const double u = unitHash(seed, static_cast<uint64_t>(x), static_cast<uint64_t>(y), c);
            texel[c] = static_cast<float>(u < 0.5 ? 0.25 * u : 0.75 + 0.25 * u);
        }
        return texel;
    });
}

double storeError(VkFormat format, double value) {
    // Below the normal range the step of a half float is 2^-24.
    return isHalf(format) ? std::max(std::abs(value) * 0x1p-10, 0x1p-24) : std::abs(value) * 0x1p-23 + 1e-37;
}

std::vector<VkFormat> wideFormats(const Variant& variant) {
    std::vector<VkFormat> formats;
    for (const auto& output : variant.pass->outputs) {
        if (!reprise::exists(variant, output)) continue;
        const std::string_view format = reprise::formatOf(variant, output);
        formats.push_back(format == "rgba16f"                    ? rgba32f
                          : format == "rg16f" || format == "rg8" ? rg32f
                          : format == "rgba8"                    ? VK_FORMAT_R8G8B8A8_UNORM
                                                                 : r32f);
    }
    return formats;
}

} // namespace passes
