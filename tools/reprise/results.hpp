// SPDX-License-Identifier: Apache-2.0
// What a report holds, and how it is written. docs/report.md describes every field.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace report {

using Json = nlohmann::ordered_json;

struct Timing { // milliseconds on the GPU
    double min = 0.0, median = 0.0, max = 0.0;
    uint32_t samples = 0;
};
Timing timingOf(std::vector<double> samples); // at least one

struct Floor {
    std::string name;
    Timing gpu;
    double nsPerPixel = 0.0;
};

struct Errors { // means over the frames after the warm-up; max is that of all of them
    std::optional<double> flip, rmse, max, flicker;
};

struct PassTime {
    std::string name;
    double gpuMs = 0.0;
};

struct Row {
    std::string technique; // the pass
    std::string variant;   // as a reader says it: "inside", "inside + constraint clamp"
    std::string file;      // variantName(); empty where no pass runs
    std::string scene, stage, jitter;
    uint32_t width = 0, height = 0;           // of the time and the memory
    uint32_t errorWidth = 0, errorHeight = 0; // of the error
    uint32_t frames = 0;
    std::optional<Timing> gpu;
    std::optional<double> floorMs, efficiency;  // of the fastest runs
    std::optional<double> perNineTaps, perCopy; // time over the floors of the same run and stage
    std::vector<PassTime> passes;
    std::optional<uint64_t> memoryBytes;
    std::optional<double> readsPerPixel;
    // Of lighting, after an occluder has gone: where the depth seen stays as it was, and where it changes.
    std::optional<double> trailingFrames, rejectedFrames;
    Errors error;
    uint64_t notFinite = 0; // NaN or infinite values in the output; the errors are null then
    std::string errorUnit;  // "display" or "pixels"
    std::string reference;
    std::vector<double> flipPerFrame, rmsePerFrame;
    std::optional<bool> pareto;
};

struct Claim {
    std::string id, document, claim;
    std::optional<std::string> published;
    Json measured;
    std::optional<bool> holds; // absent: this run has not measured it
};

struct Pictures { // of one frame of one scene, PNG files by what they show
    std::string scene;
    uint32_t frame = 0;
    std::map<std::string, std::vector<uint8_t>> png;
};

struct Report {
    Json device, settings;
    std::vector<Floor> floors;
    std::vector<Row> rows;
    std::vector<Claim> claims;
    std::vector<Pictures> pictures;
};

// A row is on the front when no other row of its technique, scene and stage is at least as good in time and
// in FLIP and better in one. Rows without both stay null.
void markPareto(std::vector<Row>& rows);

Json toJson(const Report& report);
std::string toCsv(const Report& report);
// Fails with std::runtime_error, one sentence.
void writeFile(const std::filesystem::path& file, std::string_view bytes);
// report.json, report.csv, index.html and the pictures, made beside `out` and renamed into place when
// complete.
void writeReport(const Report& report, const std::filesystem::path& out);
// Throws a sentence when `out` cannot become a report: asked before hours of measuring, not after.
void checkWritable(const std::filesystem::path& out);

} // namespace report
