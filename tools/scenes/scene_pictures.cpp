// SPDX-License-Identifier: Apache-2.0
// scene_pictures DIR [--frame N] [--width W] [--height H] [--truth N] [--mark motion|normal|ids] [SCENE or
// FILE ...] One PNG a scene: one rendering, or with --truth the mean of N, as the report's pictures are made.
#include "renderer.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace {

struct Options {
    std::filesystem::path directory;
    int frame = 8;
    uint32_t width = 640, height = 360, truth = 0;
    std::string mark;
    std::vector<std::string> names;
};

uint8_t srgb(float linear) {
    const float c = linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
    return uint8_t(std::lround(std::fmin(std::fmax(c, 0.0f), 1.0f) * 255.0f));
}

std::vector<float> firstThree(const std::vector<float>& rgba, float scale, float offset) {
    std::vector<float> rgb;
    for (size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) rgb.push_back(rgba[i] * scale + offset);
    return rgb;
}

std::vector<float> motionColours(const std::vector<float>& motion, const Options& options) {
    std::vector<float> rgb;
    for (size_t i = 0; i < motion.size(); i += 2) {
        rgb.push_back(0.2f + 0.02f * motion[i] * float(options.width));
        rgb.push_back(0.2f + 0.02f * motion[i + 1] * float(options.height));
        rgb.push_back(0.2f);
    }
    return rgb;
}

std::vector<float> idColours(const std::vector<std::byte>& texels) {
    std::vector<float> rgb;
    for (size_t i = 0; i < texels.size(); i += 8) {
        uint32_t id[2];
        std::memcpy(id, &texels[i], 8);
        const uint32_t hash = (id[0] * 0x9e3779b9u) ^ (id[1] * 0x85ebca6bu);
        for (int channel = 0; channel < 3; ++channel)
            rgb.push_back(float(hash >> (8 * channel) & 255) / 255.0f);
    }
    return rgb;
}

std::vector<float> picture(harness::Gpu& gpu, scenes::Renderer& renderer, const Options& options) {
    if (options.truth > 0) return renderer.groundTruth(options.frame, options.truth);
    scenes::FrameTargets targets = renderer.targets();
    gpu.run([&](VkCommandBuffer commands) { renderer.render(commands, options.frame, {0.0, 0.0}, targets); });
    if (options.mark == "motion") return motionColours(gpu.downloadFloats(targets.motion), options);
    if (options.mark == "normal") return firstThree(gpu.downloadFloats(targets.normal), 0.5f, 0.5f);
    if (options.mark == "ids") return idColours(gpu.download(targets.ids));
    std::vector<float> colour = firstThree(gpu.downloadFloats(targets.colour), 1.0f, 0.0f);
    for (float& value : colour)
        value = scenes::displayColour(value);
    return colour;
}

bool save(const std::filesystem::path& file, const std::vector<float>& rgb, const Options& options) {
    std::vector<uint8_t> bytes;
    for (float value : rgb)
        bytes.push_back(srgb(value));
    return stbi_write_png(file.c_str(), int(options.width), int(options.height), 3, bytes.data(),
                          int(options.width) * 3) != 0;
}

uint32_t number(const char* text) {
    uint32_t value = 0;
    const char* end = text + std::strlen(text);
    if (std::from_chars(text, end, value).ptr != end || value > 16384)
        throw std::runtime_error(std::string("'") + text + "' is not a number up to 16384; give one.");
    return value;
}

Options parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = arguments[i];
        const bool hasValue = i + 1 < count;
        if (word == "--frame" && hasValue)
            options.frame = int(number(arguments[++i]));
        else if (word == "--truth" && hasValue)
            options.truth = number(arguments[++i]);
        else if (word == "--mark" && hasValue)
            options.mark = arguments[++i];
        else if (word == "--width" && hasValue)
            options.width = number(arguments[++i]);
        else if (word == "--height" && hasValue)
            options.height = number(arguments[++i]);
        else if (options.directory.empty())
            options.directory = word;
        else
            options.names.push_back(word);
    }
    if (options.directory.empty())
        throw std::runtime_error("Usage: scene_pictures DIR [--frame N] [--width W] [--height H] [--truth N] "
                                 "[--mark motion|normal|ids] [SCENE or FILE ...]");
    return options;
}

std::vector<scenes::Scene> chosenScenes(const Options& options) {
    std::vector<scenes::Scene> all = scenes::allScenes(), chosen;
    if (options.names.empty()) return all;
    for (const std::string& name : options.names) {
        const auto found = std::ranges::find(all, name, &scenes::Scene::name);
        if (found != all.end()) {
            chosen.push_back(*found);
            continue;
        }
        auto loaded = scenes::loadScene(name);
        if (!loaded) throw std::runtime_error(loaded.error().message);
        for (const std::string& note : loaded->notes)
            std::printf("%s\n", note.c_str());
        chosen.push_back(std::move(*loaded));
    }
    return chosen;
}

void run(const Options& options) {
    harness::Gpu gpu;
    std::filesystem::create_directories(options.directory);
    for (const scenes::Scene& scene : chosenScenes(options)) {
        size_t triangles = 0;
        for (const auto& instance : scene.instances)
            triangles += scene.meshes[instance.mesh].indices.size() / 3;
        scenes::Renderer renderer(gpu, scene, options.width, options.height);
        const std::filesystem::path file = options.directory / (scene.name + ".png");
        const auto start = std::chrono::steady_clock::now();
        const std::vector<float> rgb = picture(gpu, renderer, options);
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - start;
        if (!save(file, rgb, options))
            throw std::runtime_error("Cannot write " + file.string() + "; is it writable?");
        std::printf("%s: %zu triangles, %zu instances, %.0f ms\n", file.c_str(), triangles,
                    scene.instances.size(), elapsed.count());
    }
}

} // namespace

int main(int count, char** arguments) {
    try {
        run(parse(count, arguments));
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return EXIT_FAILURE;
    }
}
