// SPDX-License-Identifier: Apache-2.0
// The job file that windows/jobs.hpp reads, and the files that come back.
#pragma once

#include "passes/bench.hpp"

#include <fstream>
#include <set>

namespace d3d {

namespace fs = std::filesystem;

struct Shader {
    std::string name, profile, entry, file;
    std::vector<fs::path> roots;
    std::map<std::string, int> macros;
};

struct Texture {
    uint32_t slot;
    bool linear;
    const passes::Pixels* pixels;
};

struct Constant { // Direct3D 9; registers of four floats
    bool vertex;
    std::string name;
    std::vector<float> registers;
};

struct Element {
    std::string_view semantic, type; // float2, float3, float4, ubyte4
    uint32_t offset;
};

struct Vertices {
    uint32_t stride = 0;
    std::vector<std::byte> bytes;
    std::vector<Element> elements;
};

struct Palette { // Direct3D 11: structured buffer of the vertex stage
    uint32_t slot, stride;
    std::vector<std::byte> bytes;
};

struct Run {
    std::string name;
    int version = 9, width = 0, height = 0;
    std::string vertexShader, shader;
    uint32_t groups[2] = {0, 0}; // of a dispatch; 0: a draw
    std::vector<Texture> textures;
    std::vector<Constant> constants;
    std::vector<std::byte> parameters;
    std::vector<Palette> palettes;
    Vertices vertices;
    std::vector<passes::Pixels> targets; // what each holds before the run
};

class JobFile {
public:
    explicit JobFile(fs::path directory);
    void add(const Shader& shader); // once a name
    void add(const Run& run);
    // Every function of a header.
    void addHeader(const Shader& header);

private:
    std::string blob(std::span<const std::byte> bytes);
    std::string blob(const passes::Pixels& pixels); // as four channels

    fs::path directory_;
    std::ofstream stream_;
    std::set<std::string> shaders_;
    std::map<const passes::Pixels*, std::string> images_;
    int blobs_ = 0;
};

// What d3d_run reported: a line a job, its words after the job's name.
class Results {
public:
    explicit Results(const fs::path& directory);
    // "ok ..." or "failed ..."; empty where nothing was reported.
    std::string of(const std::string& kind, const std::string& name) const;
    // Signature and report of each function of a header.
    std::vector<std::pair<std::string, std::string>> functions(const std::string& header) const;
    std::vector<passes::Pixels> targets(const Run& run) const;

private:
    fs::path directory_;
    std::map<std::string, std::string> reports_;
    std::multimap<std::string, std::pair<std::string, std::string>> functions_;
};

} // namespace d3d
