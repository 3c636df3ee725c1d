// SPDX-License-Identifier: Apache-2.0
#include "stopwatch.hpp"
#include "floors.hpp"

#include "reprise/format.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

constexpr std::chrono::seconds warmUp{2};

// In a round. Noise has a larger share of a section of a millisecond than of one of twenty: it has more
// turns.
size_t turnsOf(const std::vector<double>& milliseconds) {
    constexpr double turnsMs = 8.0;
    if (milliseconds.empty()) return 1;
    const double least = *std::min_element(milliseconds.begin(), milliseconds.end());
    return static_cast<size_t>(std::clamp(turnsMs / least, 1.0, double(Stopwatch::mostTurns)));
}

using harness::PassRunner;
using reprise::Stage;
using reprise::Variant;

VkFormat recommendedFormat(const Variant& variant, const reprise::ImageInfo& image) {
    const auto format = reprise::formatByName(reprise::formatOf(variant, image));
    if (!format) throw std::runtime_error(fmt::format("{} has an unknown format in the table", image.name));
    return *format;
}

std::string passKey(const Variant& variant, Stage stage) {
    return reprise::spirvFileName(variant, stage);
}

std::string floorKey(const Variant& variant, Stage stage) {
    return "floor of " + passKey(variant, stage);
}

std::string simpleKey(std::string_view kind, Stage stage) {
    return fmt::format("{}, {}", kind, stageText(stage));
}

// What a pass and its floor bind: inputs by name, outputs in table order.
struct Bound {
    std::vector<PassRunner::Binding> bindings;
    std::vector<VkFormat> formats;
};

} // namespace

std::string stageText(Stage stage) {
    return stage == Stage::compute ? "compute" : "fragment";
}

std::vector<std::byte> packParameters(const reprisec::Reflection& reflection, uint32_t bytes,
                                      const std::map<std::string, std::vector<float>, std::less<>>& values) {
    std::vector<std::byte> buffer(bytes);
    for (const auto& member : reflection.parameters) {
        const auto found = values.find(member.name);
        if (found == values.end() || found->second.size() * sizeof(float) < member.bytes ||
            member.offset + member.bytes > bytes)
            throw std::runtime_error(
                fmt::format("The report has no value for the parameter {}", member.name));
        std::memcpy(buffer.data() + member.offset, found->second.data(), member.bytes);
    }
    return buffer;
}

Stopwatch::Stopwatch(harness::Gpu& gpu, Shaders& shaders, uint32_t width, uint32_t height)
    : gpu_(gpu), shaders_(shaders), width_(width), height_(height) {}

harness::Image& Stopwatch::output(size_t slot, VkFormat format) {
    auto& image = outputs_[{slot, format}];
    if (!image) image = std::make_unique<harness::Image>(gpu_.image(format, width_, height_));
    return *image;
}

void Stopwatch::addSection(std::string name, std::function<void(VkCommandBuffer)> record) {
    sections_.push_back({std::move(name), std::move(record), {}});
}

void Stopwatch::addFloors(Stage stage, harness::Image& source) {
    static const reprise::Variant variant{&simpleFloorPass(), {}};
    harness::Image& target = output(0, VK_FORMAT_R16G16B16A16_SFLOAT);
    const std::vector<VkFormat> formats{VK_FORMAT_R16G16B16A16_SFLOAT};
    const auto add = [&](std::string_view kind, const std::string& text) {
        const std::string name = simpleKey(kind, stage);
        const auto compiled = compileText(name, text, stage);
        PassRunner runner(gpu_, variant, stage, compiled.spirv, shaders_.fullscreenVertex(), formats);
        addSection(name, [runner, &source, &target](VkCommandBuffer commands) mutable {
            const PassRunner::Binding images[] = {{"gIn", &source}, {"gOut", &target}};
            runner.record(commands, images, {});
        });
        simple_[name] = {};
    };
    add("copy", copySource(stage, width_, height_));
    add("nine taps", nineTapsSource(stage, width_, height_));
}

void Stopwatch::addPass(const Variant& variant, Stage stage, const PassData& data) {
    const std::string key = passKey(variant, stage);
    if (reads_.contains(key)) return;
    const reprisec::Compiled& compiled = shaders_.get(variant, stage);
    Bound bound;
    for (const auto& input : variant.pass->inputs)
        if (reprise::exists(variant, input)) {
            const auto found = data.images.find(input.sameAs.empty() ? input.name : input.sameAs);
            if (found == data.images.end())
                throw std::runtime_error(fmt::format("The report has no image for {}", input.name));
            bound.bindings.push_back({input.name, found->second});
        }
    for (size_t slot = 0; slot < variant.pass->outputs.size(); ++slot) {
        const auto& info = variant.pass->outputs[slot];
        if (!reprise::exists(variant, info)) continue;
        bound.formats.push_back(recommendedFormat(variant, info));
        bound.bindings.push_back({info.name, &output(slot, bound.formats.back())});
    }
    const auto parameters =
        packParameters(compiled.reflection, variant.pass->parameterBytes, data.parameters);
    const auto floor = compileText(floorKey(variant, stage),
                                   floorSource(variant, stage, compiled.reflection, width_, height_), stage);
    const auto add = [&](std::string name, const std::vector<uint32_t>& spirv) {
        PassRunner runner(gpu_, variant, stage, spirv, shaders_.fullscreenVertex(), bound.formats);
        addSection(std::move(name), [runner, bound, parameters](VkCommandBuffer commands) mutable {
            runner.record(commands, bound.bindings, parameters);
        });
    };
    add(key, compiled.spirv);
    add(floorKey(variant, stage), floor.spirv);
    reads_[key] = readsPerPixel(variant, stage, compiled.reflection);
}

void Stopwatch::run(uint32_t rounds, Progress& progress, double workPerRound) {
    // Each round in another order: what ran before leaves its images in the caches of a GPU.
    std::mt19937 random(1);
    std::vector<size_t> order;
    const auto timeAll = [&] {
        order.clear();
        for (size_t i = 0; i < sections_.size(); ++i)
            order.insert(order.end(), turnsOf(sections_[i].samples), i);
        std::shuffle(order.begin(), order.end(), random);
        std::vector<std::function<void(VkCommandBuffer)>> records;
        for (const size_t section : order)
            records.push_back(sections_[section].record);
        return gpu_.time(records);
    };
    // Shaders are compiled by the driver on first use, and a GPU that has waited for rays takes some time to
    // come to its clock.
    const auto begin = std::chrono::steady_clock::now();
    do
        timeAll();
    while (std::chrono::steady_clock::now() - begin < warmUp);
    progress.step(workPerRound, "timing");
    for (uint32_t round = 0; round < rounds; ++round) {
        const std::vector<double> times = timeAll();
        progress.step(workPerRound, "timing");
        for (size_t i = 0; i < times.size(); ++i)
            sections_[order[i]].samples.push_back(times[i]);
    }
    for (auto& [name, value] : simple_)
        value = timing(name);
}

Timing Stopwatch::timing(const std::string& name) const {
    for (const Section& section : sections_)
        if (section.name == name) return timingOf(section.samples);
    throw std::runtime_error(fmt::format("{} was not timed", name));
}

std::vector<Floor> Stopwatch::floors() const {
    std::vector<Floor> result;
    const double pixels = static_cast<double>(width_) * height_;
    for (const auto& [name, value] : simple_)
        result.push_back({name, value, value.median * 1e6 / pixels});
    return result;
}

const Timing& Stopwatch::floorOf(std::string_view kind, Stage stage) const {
    return simple_.at(simpleKey(kind, stage));
}

PassTiming Stopwatch::passOf(const Variant& variant, Stage stage) const {
    const std::string key = passKey(variant, stage);
    return {timing(key), timing(floorKey(variant, stage)), reads_.at(key)};
}

} // namespace report
