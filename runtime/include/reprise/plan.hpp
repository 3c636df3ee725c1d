// SPDX-License-Identifier: Apache-2.0
// Which passes and images a frame needs, and why the others were left out. Pure: no Vulkan types, no state.
#pragma once

#include "reprise/pack.hpp"

namespace reprise {

// What the scene asks for. Everything that is false is left out of the code, the frame and the memory.
struct SceneNeeds {
    bool antiAliasing = true;
    bool cameraMoves = true;
    bool objectsMove = true;
    bool skinnedMeshes = false;
    bool engineWritesMotion = false; // the engine's own motion vectors: no velocity pass at all
    bool hdr = true;                 // colour exceeds display white
    bool fastMotion = false;         // motion blur fallback is wanted
    bool reversedDepth = false;
    bool orthographic = false;
    bool linearDepth = false; // depth input is linear view depth in metres
};

struct Settings {
    Stage stage = Stage::compute;       // fragment or compute, for every full-screen pass
    std::string_view preset = "best";   // of temporal_aa
    std::vector<Condition> overrides{}; // switches of temporal_aa set by hand, after the preset and the needs
    bool quadOperations = true;         // the device has them in compute (Device::quadOperations)
    std::string_view colourFormat{};    // of temporal_aa's outputs; empty: as the table recommends
};

struct Extent {
    uint32_t width = 0, height = 0;
};

struct PlannedImage {
    std::string name; // resource name: of the output that writes it, or of the input that is external
    std::string format;
    Extent extent;
    bool history = false;            // two of them, kept from frame to frame
    bool external = false;           // the engine's
    bool cleared = false;            // to zero before its first pass, because no pass writes the whole of it
    int firstPass = 0, lastPass = 0; // lifetime; images whose lifetimes do not meet may share memory
    int memory = -1;    // transient images with the same number share it; -1: history or external
    uint64_t bytes = 0; // of one
};

struct PlannedPass {
    Variant variant;
    Stage stage = Stage::compute;
    std::vector<std::string> reads, writes;   // resource names of the table
    std::vector<int> readImages, writeImages; // the same as places in FramePlan::images; -1: a buffer
};

struct Dropped {
    std::string pass;   // or "pass: SWITCH"
    std::string reason; // one sentence
};

struct FramePlan {
    std::vector<PlannedPass> passes; // in order of recording
    std::vector<PlannedImage> images;
    std::vector<Dropped> dropped;
    uint64_t bytes = 0; // of all images that the runtime allocates, after aliasing
    uint64_t bytesWithoutAliasing = 0;
};

// An output gOutX of an earlier pass is the input gInX of a later one; an input that no pass writes is the
// engine's. presets: of temporal_aa. Errors: zeroExtent, invalidArgument (an unknown preset, switch, format
// or stage).
Result<FramePlan> plan(std::span<const PassInfo> passes, std::span<const PresetInfo> presets,
                       const SceneNeeds& needs, const Settings& settings, Extent extent);

// Gives transient images the `memory` that they may share, largest first, and the sums of the plan.
void shareMemory(FramePlan& plan);

} // namespace reprise
