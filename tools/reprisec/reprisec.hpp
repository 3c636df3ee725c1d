// SPDX-License-Identifier: Apache-2.0
// The pack compiler as a library: pack.toml and HLSL in; SPIR-V, GLSL, reflection and C++ out. Thread safe.
#pragma once

#include "reprise/pack.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace reprisec {

using reprise::Result;
using reprise::Stage;
using reprise::Variant;

// pack.toml as tables; the spans of PassInfo point into storage that lives as long as the Pack.
class Pack {
public:
    // Errors name the file and the line.
    static Result<Pack> load(const std::filesystem::path& packToml);
    std::span<const reprise::PassInfo> passes() const;
    std::span<const reprise::PresetInfo> presets(std::string_view pass) const;
    const std::filesystem::path& file() const;
    Result<Variant> preset(std::string_view pass, std::string_view preset) const;
    // Defaults, presets and single flips of a pass, without doubles.
    std::vector<Variant> committedVariants(const reprise::PassInfo& pass) const;
    // The inverse of reprise::variantName.
    Result<Variant> parseVariant(std::string_view name) const;

    struct Storage;
    std::shared_ptr<const Storage> storage;
};

// How often one invocation reads or writes a binding, counted in the optimised SPIR-V.
struct BindingUse {
    std::string name;
    uint32_t binding = 0;
    reprise::BindingKind kind{};
    uint32_t samples = 0, gathers = 0, fetches = 0, stores = 0;
    uint32_t scalars = 0;      // of a uniform buffer: how many of its 32-bit values are read
};

struct ParameterMember {
    std::string name;
    std::string type;      // float, float2, float4, float4x4, uint ...
    uint32_t offset = 0, bytes = 0;
};

struct Reflection {
    std::vector<BindingUse> bindings;
    std::vector<ParameterMember> parameters;   // uniform buffer at binding 0; empty if unused
    uint32_t parameterBytes = 0;
    uint32_t threads[3] = {1, 1, 1};
    uint32_t colourOutputs = 0;                // SV_Targets
};

struct Compiled {
    std::vector<uint32_t> spirv;               // validated and optimised, Vulkan 1.3
    Reflection reflection;
    std::optional<std::string> glsl450, glslEs;   // each compiled again; absent with a reason below
    std::string glsl450Reason, glslEsReason;
    std::vector<std::filesystem::path> dependencies;
};

struct Options {
    bool glsl = true;                                  // emit and check the GLSL targets
    std::map<std::string, int> platformSwitches;       // others are 0
};

Result<Compiled> compile(const Pack& pack, const Variant& variant, Stage stage, const Options& options = {});

// Any HLSL text, for tests, scenes and floors: includes resolve against `includeDirectories`.
struct Source {
    std::string name;                                  // for messages
    std::string text;
    std::string entry;
    Stage stage = Stage::compute;
    std::map<std::string, int> defines;
    std::vector<std::filesystem::path> includeDirectories;
};
Result<Compiled> compileSource(const Source& source,
                               const Options& options = {.glsl = false, .platformSwitches = {}});

} // namespace reprisec
