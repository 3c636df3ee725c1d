// SPDX-License-Identifier: Apache-2.0
// What the compiler's files share: the storage of a pack, and the steps from HLSL to the targets.
#pragma once

#include "reprisec.hpp"

#include <deque>
#include <functional>
#include <set>

namespace reprisec {

using Words = std::vector<uint32_t>;
using Defines = std::map<std::string, int>;
using reprise::Error;
using reprise::ErrorCode;
using reprise::PassInfo;
namespace fs = std::filesystem;

// What the table says of a pass beyond PassInfo.
struct PassSource {
    fs::path file;          // as messages name it
    std::string parameters; // the C++ struct, and the block in GLSL; empty: no parameters
};

struct Pack::Storage {
    fs::path file;
    std::string name;
    std::vector<fs::path> includeDirectories;
    std::vector<std::string> platformSwitches;
    std::vector<PassInfo> passes;
    std::vector<PassSource> sources;                       // as passes
    std::vector<std::vector<reprise::PresetInfo>> presets; // as passes

    // The spans and views above point into these; a deque keeps its elements in place.
    std::deque<std::string> texts;
    std::deque<std::vector<std::string_view>> textLists;
    std::deque<std::vector<Stage>> stageLists;
    std::deque<std::vector<reprise::Condition>> conditionLists;
    std::deque<std::vector<reprise::FormatChoice>> formatLists;
    std::deque<std::vector<reprise::GroupChoice>> groupLists;
    std::deque<std::vector<reprise::SwitchInfo>> switchLists;
    std::deque<std::vector<reprise::BindingInfo>> bindingLists;
    std::deque<std::vector<reprise::ImageInfo>> imageLists;
};

constexpr uint32_t samplerOffset = 32; // a texture's sampler is at the texture's binding plus this

inline Error badShader(std::string message) {
    return {ErrorCode::badShader, std::move(message)};
}
Result<std::string> readText(const fs::path& file);
std::string upper(std::string_view text);
std::string_view entryPoint(Stage stage); // mainVertex, mainFragment, mainCompute
std::string_view stageWord(Stage stage);  // vertex, fragment, compute

// pack_toml.cpp: the table alone; Pack::load adds the sizes of the parameters, which only the HLSL knows.
Result<std::shared_ptr<Pack::Storage>> readTable(const fs::path& packToml);

// defines.cpp
// Every macro of the table, 0 except where `variant` and the platform switches say otherwise.
Result<Defines> definesOf(const Pack& pack, const Variant* variant, Stage stage, const Defines& platform);
struct NamedText {
    std::string name, text;
};
// Fails on an identifier in #if or #elif that neither `defines` nor a #define in `files` knows.
Result<void> checkTestedMacros(const std::vector<NamedText>& files, const Defines& defines);

// frontend.cpp
struct Frontend {
    Words spirv;
    std::vector<fs::path> headers; // sorted, as the includer found them
};
Result<Frontend> hlslToSpirv(const Source& source, const Defines& defines);
// Compiles GLSL text as an OpenGL driver would; `name` is for the message.
Result<void> checkGlsl(const std::string& name, const std::string& text, Stage stage);

// spirv_edit.cpp
struct Instruction {
    uint32_t opcode;
    std::span<const uint32_t> words; // with the first word
};
void forEachInstruction(const Words& module, const std::function<void(const Instruction&)>& visit);
std::string literalString(std::span<const uint32_t> words);
// glslang calls every storage image rgba32f: makes them formatless, so that any format can be bound.
Words withoutStorageFormats(const Words& module);
// Marks storage images that are only written or only read, keeps the names that reflection needs, drops the
// rest.
Words withStorageAccess(const Words& module);
Words withoutDebugNames(const Words& module);
// HLSL's saturate(NaN) is 0. glslang makes it FClamp, which leaves that open: clamps to [0, 1] become NClamp.
Words withDefinedSaturate(const Words& module);
// Gives the storage images named a format of their own, for GLSL that demands one.
Words withStorageFormats(const Words& module, const std::map<std::string, uint32_t>& formatOfName);

// optimise.cpp
Result<Words> optimise(const Words& module);
Result<void> validate(const Words& module);

// reflect.cpp
Result<Reflection> reflect(const Words& module, Stage stage);

// glsl.cpp
enum class GlslTarget { gl450, es };
struct GlslNames {
    std::vector<std::string> outputs;           // of SV_Target0 on; empty: as the HLSL names them
    std::map<std::string, std::string> formats; // of storage images
};
// On failure the message is the reason for which the target cannot have the module.
Result<std::string> emitGlsl(const Words& module, Stage stage, GlslTarget target, const GlslNames& names);

// json.cpp
std::string reflectionJson(const Variant& variant, Stage stage, const Compiled& compiled,
                           const fs::path& packRoot);

} // namespace reprisec
