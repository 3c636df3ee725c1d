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
    // What the framework caches (Drobot 7.2 and 7.3); occlusion and shadows share one cache.
    bool ambientOcclusion = false;
    bool sunShadows = false;
    bool reversedShadows = false; // depth of the shadow map is reversed
    bool normals = false;         // the engine's normals, FrameInput::normal, in occlusion and upsampling
    uint32_t cachedChannels = 0;  // 1 to 4 of the engine's own, FrameInput::fresh, without the two above
    // The engine hands over its light in parts and the plan puts them together with what is cached; the first
    // of cachedChannels counts as an occlusion. Anti-aliasing then takes that colour.
    bool combinesLighting = false;
    bool otherLight = false; // combinesLighting: light that neither occlusion nor shadow touches
};

// The framework's steps, for whatever the needs ask it to cache.
struct CacheSettings {
    // What computes occlusion: ambient_occlusion for the framework, or scalable_obscurance (Wronski), which
    // is at full resolution, accumulates by itself and has a filter of its own. Its numbers of samples are
    // others: 7.
    std::string_view occlusion = "ambient_occlusion";
    uint32_t ratio = 2;          // step 1: pixels of the frame per coarse texel along an axis, 1, 2 or 4
    uint32_t samples = 4;        // step 3: a texel and frame; 1, 2, 4, 8, 12, 16 or 32
    uint32_t cascades = 3;       // columns of the shadow map, 1 to 4
    bool history = true;         // steps 4, 5 and 8; false: every frame stands alone
    bool detectsChanges = true;  // history gives way where the values of this frame do not bear it out
    bool filter = true;          // step 6
    bool merges = true;          // steps 3 to 5 in one dispatch, lighting_cache, in compute
    bool filtersHistory = false; // step 8 after the filter: filtering over time
    float filterStep = 1.0f;     // texels between the filter's texels, above 0: 1 reaches four, 2 eight
    // Of occlusion and shadow in one cache: packed in one number, "shadow_in_integer" or
    // "occlusion_in_integer"; "with_frames", packed with the frames of their history, which reads and writes
    // the least, but takes history and no filter; or as "two" values, which costs a channel and no bits.
    std::string_view packing = "shadow_in_integer";
};

struct Settings {
    Stage stage = Stage::compute;     // fragment or compute, for every full-screen pass
    std::string_view preset = "best"; // of temporal_aa
    // Switches set by hand, after the preset and the needs: of temporal_aa by their name, of another pass as
    // "bilateral_filter.TAPS".
    std::vector<Condition> overrides{};
    bool quadOperations = true;      // the device has them in compute (Device::quadOperations)
    std::string_view colourFormat{}; // of temporal_aa's outputs; empty: as the table recommends
    CacheSettings cache{};
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
    std::string_view run{};                   // "across" and "down" of bilateral_filter
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
    CacheSettings cache; // as planned
    uint64_t bytes = 0;  // of all images that the runtime allocates, after aliasing
    uint64_t bytesWithoutAliasing = 0;
};

// An output gOutX of an earlier pass is the input gInX of a later one, and the framework's steps follow each
// other (see docs/runtime.md); an input that no pass writes is the engine's. presets: of temporal_aa.
// Errors: zeroExtent, invalidArgument (an unknown preset, switch, format or stage; a ratio, a number of
// samples or a packing that there is not; with_frames beside a filter or without history; a filterStep that is not above 0; channels of the engine's beside
// occlusion or shadows, or more than 4).
Result<FramePlan> plan(std::span<const PassInfo> passes, std::span<const PresetInfo> presets,
                       const SceneNeeds& needs, const Settings& settings, Extent extent);

// Gives transient images the `memory` that they may share, largest first, and the sums of the plan.
void shareMemory(FramePlan& plan);

} // namespace reprise
