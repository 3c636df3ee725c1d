// SPDX-License-Identifier: Apache-2.0
// What d3d_cases asks for, read from its job file: one statement a line, words separated by blanks, files
// relative to the job file's directory. tests/d3d/job_file.hpp writes it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace d3d {

namespace fs = std::filesystem;
using Texels = std::vector<float>; // four a texel, rows top to bottom
using Macros = std::map<std::string, std::string>;

// Failures of a job are exceptions with a sentence; they become a line of the results.
struct Failure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct ShaderJob {
    std::string name, profile, entry, file;
    std::vector<fs::path> roots; // of the file and its includes; the first that has it
    Macros macros;
};

// Each function of a header, called by a shader of its own.
struct HeaderJob {
    std::string name, profile, file;
    std::vector<fs::path> roots;
    Macros macros;
};

struct TextureJob {
    unsigned slot = 0;
    bool linear = false;
    int width = 0, height = 0;
    Texels texels;
};

// A constant of Direct3D 9, as registers of four floats.
struct ConstantJob {
    bool vertex = false;
    std::string name;
    std::vector<float> registers;
};

struct BufferJob { // structured, of the vertex stage, Direct3D 11
    unsigned slot = 0, stride = 0;
    std::vector<char> bytes;
};

struct ElementJob {
    std::string semantic, type; // float2, float3, float4, ubyte4
    unsigned offset = 0;
};

struct RunJob {
    std::string name;
    bool compute = false;
    int version = 9; // of Direct3D
    int width = 0, height = 0;
    std::string vertexShader, shader;
    unsigned groups[2] = {1, 1};
    std::vector<TextureJob> textures;
    std::vector<ConstantJob> constants;
    std::vector<char> parameters; // constant buffer 0 of both stages, Direct3D 11
    std::vector<BufferJob> buffers;
    unsigned vertexStride = 0;
    std::vector<char> vertices;
    std::vector<ElementJob> elements;
    std::vector<Texels> targets; // what each holds before the run

    unsigned vertexCount() const { return static_cast<unsigned>(vertices.size()) / vertexStride; }
};

struct Jobs {
    std::vector<ShaderJob> shaders;
    std::vector<HeaderJob> headers;
    std::vector<RunJob> runs;
};

Jobs readJobs(const fs::path& file);
std::vector<char> readBytes(const fs::path& file);
void writeTexels(const fs::path& file, const Texels& texels);

} // namespace d3d
