// SPDX-License-Identifier: Apache-2.0
// Opcode and decoration numbers: SPIR-V specification 1.6, sections 3.20, 3.31 and 3.52.
#include "spirv_module.hpp"

#include <algorithm>
#include <cstring>

namespace reprise {
namespace {

constexpr uint32_t magicNumber = 0x07230203, headerWords = 5;
constexpr uint32_t opEntryPoint = 15, opCapability = 17, opFunctionEnd = 56, opDecorate = 71;
constexpr uint32_t capabilityGroupNonUniformQuad = 68;
constexpr uint32_t decorationBinding = 33, decorationDescriptorSet = 34;

struct Place {
    uint32_t set = 0, binding = 0;
    bool bound = false;
};

Error bad(std::string_view why) {
    return {ErrorCode::badShader,
            "The shader is not usable SPIR-V: " + std::string(why) + "; compile the pack again."};
}

bool readStage(uint32_t executionModel, Stage& stage) {
    switch (executionModel) {
    case 0:
        stage = Stage::vertex;
        return true;
    case 4:
        stage = Stage::fragment;
        return true;
    case 5:
        stage = Stage::compute;
        return true;
    default:
        return false;
    }
}

// A literal string is nul-terminated inside its words.
std::string readString(std::span<const uint32_t> words) {
    std::string text(words.size_bytes(), '\0');
    std::memcpy(text.data(), words.data(), text.size());
    return text.substr(0, text.find('\0'));
}

void readDecoration(std::span<const uint32_t> instruction, std::map<uint32_t, Place>& places) {
    if (instruction.size() < 4) return;
    if (instruction[2] == decorationDescriptorSet) places[instruction[1]].set = instruction[3];
    if (instruction[2] != decorationBinding) return;
    places[instruction[1]].binding = instruction[3];
    places[instruction[1]].bound = true;
}

std::vector<uint32_t> bindingsOf(const std::map<uint32_t, Place>& places) {
    std::vector<uint32_t> bindings;
    for (const auto& [id, place] : places)
        if (place.bound && place.set == 0) bindings.push_back(place.binding);
    std::sort(bindings.begin(), bindings.end());
    bindings.erase(std::unique(bindings.begin(), bindings.end()), bindings.end());
    return bindings;
}

} // namespace

Result<SpirvModule> readModule(std::span<const uint32_t> words) {
    if (words.size() < headerWords || words[0] != magicNumber)
        return bad("its first word is not the magic number");
    SpirvModule module;
    module.words = words;
    std::map<uint32_t, Place> places;
    uint32_t last = 0;
    for (size_t at = headerWords; at < words.size();) {
        const uint32_t count = words[at] >> 16, opcode = words[at] & 0xffffu;
        if (count == 0 || count > words.size() - at) return bad("it is cut short");
        const auto instruction = words.subspan(at, count);
        if (opcode == opEntryPoint && module.entry.empty()) {
            if (count < 4 || !readStage(instruction[1], module.stage))
                return bad("its stage is none of a pass");
            module.entry = readString(instruction.subspan(3));
        }
        if (opcode == opCapability && count == 2 && instruction[1] == capabilityGroupNonUniformQuad)
            module.usesQuadOperations = true;
        if (opcode == opDecorate) readDecoration(instruction, places);
        last = opcode;
        at += count;
    }
    // A file cut between two instructions would crash some drivers.
    if (last != opFunctionEnd) return bad("it is cut short");
    if (module.entry.empty()) return bad("it has no entry point");
    module.bindings = bindingsOf(places);
    return module;
}

} // namespace reprise
