// SPDX-License-Identifier: Apache-2.0
// GPU times of passes and of their floors in one run: every round times each once, in turn, so that drift of
// the machine meets all alike.
#pragma once

#include "harness.hpp"
#include "progress.hpp"
#include "results.hpp"
#include "shaders.hpp"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace report {

// What a pass reads while it is timed: images by the name of its inputs, and its parameters by name.
struct PassData {
    std::map<std::string, harness::Image*, std::less<>> images;
    std::map<std::string, std::vector<float>, std::less<>> parameters;
};

struct PassTiming {
    Timing gpu, floor;
    double readsPerPixel = 0.0;
};

class Stopwatch {
public:
    Stopwatch(harness::Gpu& gpu, Shaders& shaders, uint32_t width, uint32_t height);

    // The simple floors of the stage: "copy, fragment", "nine taps, fragment". `source` is RGBA16F.
    void addFloors(reprise::Stage stage, harness::Image& source);
    // A pass and its own floor. Adding one twice is adding it once. `data` must outlive run().
    void addPass(const reprise::Variant& variant, reprise::Stage stage, const PassData& data);
    // How often a section is recorded in one submission, at most: a FrameRecorder that records it needs as
    // many frames in flight.
    static constexpr uint32_t mostTurns = 4;
    // Anything else, by a name of its own.
    void addSection(std::string name, std::function<void(VkCommandBuffer)> record);
    // One untimed round, then `rounds`.
    void run(uint32_t rounds, Progress& progress, double workPerRound);

    std::vector<Floor> floors() const;
    const Timing& floorOf(std::string_view kind, reprise::Stage stage) const; // "copy", "nine taps"
    Timing timing(const std::string& name) const;                             // of the section
    PassTiming passOf(const reprise::Variant& variant, reprise::Stage stage) const;

private:
    struct Section {
        std::string name;
        std::function<void(VkCommandBuffer)> record;
        std::vector<double> samples;
    };
    harness::Image& output(size_t slot, VkFormat format);

    harness::Gpu& gpu_;
    Shaders& shaders_;
    uint32_t width_, height_;
    std::vector<Section> sections_;
    std::map<std::string, double> reads_;
    std::map<std::string, Timing, std::less<>> simple_;
    std::map<std::pair<size_t, VkFormat>, std::unique_ptr<harness::Image>> outputs_;
};

std::string stageText(reprise::Stage stage); // "fragment", "compute"

// The uniform buffer of a pass, each member by its name; a member that is not given is an error.
std::vector<std::byte> packParameters(const reprisec::Reflection& reflection, uint32_t bytes,
                                      const std::map<std::string, std::vector<float>, std::less<>>& values);

} // namespace report
