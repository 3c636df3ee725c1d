// SPDX-License-Identifier: Apache-2.0
// Runs functions of an HLSL header on the GPU over rows of inputs and compares with an oracle, for the tests
// and for `reprise check`. A mutation compiles the header with one replacement.
#pragma once

#include "harness.hpp"
#include "image.hpp"

#include "reprise/pack.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace functions {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::vec4;
using oracle::Image;

// Half a step of binary32: what one correctly rounded operation errs by, relatively.
inline constexpr double roundoff = 0x1p-24;
// Vulkan lets a division err by 2.5 steps.
inline constexpr double divisionError = 5.0 * roundoff;

struct Texture {
    Image image;         // uploaded as rgba32f
    bool linear = false; // filter
};

// One call as statements over `in0`, `in1` ... to `out0`, `out1` ..., each a float4. Textures are gTexture0
// and so on. In a fragment function `positionPx` is there, and pixel (x, y) takes row 64 y + x of the inputs.
struct Function {
    std::string name;
    std::vector<std::string> headers; // reprise/colour.hlsli
    std::string body;
    int inputs = 1, outputs = 1;
    std::map<std::string, int> defines = {};
    reprise::Stage stage = reprise::Stage::compute;
    std::vector<Texture> textures = {};
    std::string helpers = {}; // functions of the caller's own, after the headers
};

using Row = std::vector<vec4>;

// The device that runs functions, and the directory hlsl/ of the headers.
struct Bench {
    harness::Gpu& gpu;
    std::filesystem::path hlsl;
};

struct Mutation {
    std::string header, find, replacement;
};

struct RunOptions {
    Mutation mutation = {};               // none if its header is empty
    glm::ivec2 extent{0, 0};              // of the output, for a fragment function without inputs
    std::string outputFormat = "rgba32f"; // what the device stores and the rows are read back from
};

// One row of outputs for each row of inputs, or for each pixel. Throws what does not compile or what the
// validation layer reports.
std::vector<Row> run(const Bench& bench, const Function& function, const std::vector<Row>& inputs,
                     const RunOptions& options = {});

// A value and how far each component may be off. Bound infinity: only that the result is finite is asked.
struct Expected {
    dvec4 value{0.0};
    dvec4 bound{0.0};
};

// Missing components are not compared.
Expected near(double value, double bound);
Expected near(dvec2 value, double bound);
Expected near(dvec3 value, double bound);
Expected near(dvec3 value, dvec3 bound);
Expected near(dvec4 value, double bound);
Expected finite(); // all four components

struct Comparison {
    Function function;
    std::vector<Row> inputs;
    std::function<std::vector<Expected>(const Row&)> oracle;
};

// Empty if every output is within its bound; else how many rows are not, and the first of them, decoded.
std::string mismatches(const Bench& bench, const Comparison& comparison, const Mutation& mutation = {});

// The text of a file below hlsl/; throws if it cannot be read.
std::string hlslText(const std::filesystem::path& hlsl, const std::string& file);

} // namespace functions
