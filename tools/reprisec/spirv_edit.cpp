// SPDX-License-Identifier: Apache-2.0
// Small edits of SPIR-V modules that neither glslang nor the optimiser make.
#include "internal.hpp"

#include <algorithm>
#include <bit>

#include <spirv_cross/GLSL.std.450.h>
#include <spirv_cross/spirv.hpp>

namespace reprisec {

namespace {

constexpr size_t headerWords = 5;
constexpr size_t boundWord = 3;

Instruction instructionAt(const Words& module, size_t at) {
    const uint32_t count = std::max(module[at] >> 16, 1u);
    return {module[at] & 0xffffu, std::span(module).subspan(at, std::min<size_t>(count, module.size() - at))};
}

uint32_t firstWord(spv::Op opcode, size_t words) {
    return static_cast<uint32_t>(words) << 16 | static_cast<uint32_t>(opcode);
}

void append(Words& module, spv::Op opcode, std::initializer_list<uint32_t> operands) {
    module.push_back(firstWord(opcode, operands.size() + 1));
    module.insert(module.end(), operands);
}

// Copies the module instruction by instruction; `copy` appends what shall stand in its place.
Words rewrite(const Words& module, const std::function<void(const Instruction&, Words&)>& copy) {
    Words result(module.begin(), module.begin() + headerWords);
    forEachInstruction(module, [&](const Instruction& each) { copy(each, result); });
    return result;
}

void keep(const Instruction& each, Words& out) {
    out.insert(out.end(), each.words.begin(), each.words.end());
}

// OpTypeImage: result, sampled type, dim, depth, arrayed, ms, sampled, format.
bool isStorageImageType(const Instruction& each) {
    return each.opcode == spv::OpTypeImage && each.words[7] == 2;
}

// The storage image variables of a module, by what their pointers point to.
struct StorageImages {
    std::map<uint32_t, Instruction> types, pointers, variables;
    std::map<uint32_t, uint32_t> variableOfLoad;
    std::set<uint32_t> read, written;
};

void noteDeclaration(const Instruction& each, StorageImages& found) {
    if (isStorageImageType(each)) found.types.emplace(each.words[1], each);
    if (each.opcode == spv::OpTypePointer && found.types.contains(each.words[3]))
        found.pointers.emplace(each.words[1], each);
    if (each.opcode == spv::OpVariable && found.pointers.contains(each.words[1]))
        found.variables.emplace(each.words[2], each);
}

void noteUse(const Instruction& each, StorageImages& found) {
    const auto variable = [&](uint32_t id) {
        const auto load = found.variableOfLoad.find(id);
        return load == found.variableOfLoad.end() ? 0 : load->second;
    };
    if (each.opcode == spv::OpLoad && found.variables.contains(each.words[3]))
        found.variableOfLoad[each.words[2]] = each.words[3];
    if (each.opcode == spv::OpImageWrite) found.written.insert(variable(each.words[1]));
    if (each.opcode == spv::OpImageRead) found.read.insert(variable(each.words[3]));
    if (each.opcode == spv::OpImageTexelPointer) { // atomics do both
        found.read.insert(each.words[3]);
        found.written.insert(each.words[3]);
    }
}

StorageImages storageImages(const Words& module) {
    StorageImages found;
    forEachInstruction(module, [&](const Instruction& each) {
        noteDeclaration(each, found);
        noteUse(each, found);
    });
    return found;
}

// Ids whose names reflection, SPIRV-Cross and a debugger's list of resources use.
std::set<uint32_t> namedIds(const Words& module) {
    std::set<uint32_t> ids;
    forEachInstruction(module, [&](const Instruction& each) {
        if (each.opcode == spv::OpTypeStruct) ids.insert(each.words[1]);
        if (each.opcode == spv::OpVariable && each.words[3] != spv::StorageClassFunction)
            ids.insert(each.words[2]);
    });
    return ids;
}

std::map<uint32_t, std::string> namesOf(const Words& module) {
    std::map<uint32_t, std::string> names;
    forEachInstruction(module, [&](const Instruction& each) {
        if (each.opcode == spv::OpName) names[each.words[1]] = literalString(each.words.subspan(2));
    });
    return names;
}

} // namespace

void forEachInstruction(const Words& module, const std::function<void(const Instruction&)>& visit) {
    for (size_t at = headerWords; at < module.size();) {
        const Instruction each = instructionAt(module, at);
        visit(each);
        at += each.words.size();
    }
}

std::string literalString(std::span<const uint32_t> words) {
    std::string text;
    for (uint32_t word : words)
        for (int byte = 0; byte < 4; ++byte) {
            const char c = static_cast<char>(word >> (8 * byte) & 0xff);
            if (c == 0) return text;
            text += c;
        }
    return text;
}

Words withoutStorageFormats(const Words& module) {
    bool any = false, read = false;
    forEachInstruction(module, [&](const Instruction& each) {
        any |= isStorageImageType(each) && each.words[3] != spv::DimSubpassData;
        read |= each.opcode == spv::OpImageRead;
        // Atomics exist for three formats only, which glslang names rightly.
        if (each.opcode == spv::OpImageTexelPointer) any = false;
    });
    if (!any) return module;
    bool first = true;
    return rewrite(module, [&](const Instruction& each, Words& out) {
        if (std::exchange(first, false)) {
            append(out, spv::OpCapability, {spv::CapabilityStorageImageWriteWithoutFormat});
            if (read) append(out, spv::OpCapability, {spv::CapabilityStorageImageReadWithoutFormat});
        }
        keep(each, out);
        if (isStorageImageType(each)) out[out.size() - each.words.size() + 8] = spv::ImageFormatUnknown;
    });
}

Words withStorageAccess(const Words& module) {
    const StorageImages images = storageImages(module);
    bool decorated = false;
    return rewrite(module, [&](const Instruction& each, Words& out) {
        // Decorations come before the first type.
        const bool type = each.opcode >= spv::OpTypeVoid && each.opcode <= spv::OpTypeForwardPointer;
        if (type && !std::exchange(decorated, true))
            for (const auto& [id, variable] : images.variables) {
                if (!images.read.contains(id)) append(out, spv::OpDecorate, {id, spv::DecorationNonReadable});
                if (!images.written.contains(id))
                    append(out, spv::OpDecorate, {id, spv::DecorationNonWritable});
            }
        keep(each, out);
    });
}

Words withoutDebugNames(const Words& module) {
    const std::set<uint32_t> named = namedIds(module);
    return rewrite(module, [&](const Instruction& each, Words& out) {
        switch (each.opcode) {
        case spv::OpName:
            if (each.words[2] == 0) return; // glslang names the instance of a cbuffer ""
            [[fallthrough]];
        case spv::OpMemberName:
            if (named.contains(each.words[1])) keep(each, out);
            return;
        case spv::OpSource:
        case spv::OpSourceContinued:
        case spv::OpSourceExtension:
        case spv::OpString:
        case spv::OpLine:
        case spv::OpNoLine:
        case spv::OpModuleProcessed:
            return;
        default:
            keep(each, out);
        }
    });
}

Words withDefinedSaturate(const Words& module) {
    std::map<uint32_t, float> constants; // scalars, and vectors of equal ones
    forEachInstruction(module, [&](const Instruction& each) {
        if (each.opcode == spv::OpConstantNull) constants[each.words[2]] = 0.0f;
        if (each.opcode == spv::OpConstant && each.words.size() == 4)
            constants[each.words[2]] = std::bit_cast<float>(each.words[3]);
        if (each.opcode != spv::OpConstantComposite) return;
        const auto parts = each.words.subspan(3);
        const auto first = constants.find(parts.front());
        const bool equal = std::ranges::all_of(parts, [&](uint32_t part) { return part == parts.front(); });
        if (equal && first != constants.end()) constants[each.words[2]] = first->second;
    });
    const auto is = [&](uint32_t id, float value) {
        const auto found = constants.find(id);
        return found != constants.end() && found->second == value;
    };
    return rewrite(module, [&](const Instruction& each, Words& out) {
        keep(each, out);
        const bool clamp = each.opcode == spv::OpExtInst && each.words[4] == GLSLstd450FClamp;
        if (clamp && is(each.words[6], 0.0f) && is(each.words[7], 1.0f))
            out[out.size() - each.words.size() + 4] = GLSLstd450NClamp;
    });
}

Words withStorageFormats(const Words& module, const std::map<std::string, uint32_t>& formatOfName) {
    const StorageImages images = storageImages(module);
    const auto names = namesOf(module);
    uint32_t bound = module[boundWord];
    std::map<uint32_t, uint32_t> typeOfVariable;
    Words result = rewrite(module, [&](const Instruction& each, Words& out) {
        if (each.opcode == spv::OpVariable && images.variables.contains(each.words[2])) {
            const uint32_t id = each.words[2];
            const auto name = names.find(id);
            const auto format = formatOfName.find(name == names.end() ? std::string{} : name->second);
            if (format != formatOfName.end()) {
                const Instruction& pointer = images.pointers.at(each.words[1]);
                const Instruction& image = images.types.at(pointer.words[3]);
                const uint32_t newImage = bound++, newPointer = bound++;
                keep(image, out);
                out[out.size() - image.words.size() + 1] = newImage;
                out[out.size() - image.words.size() + 8] = format->second;
                append(out, spv::OpTypePointer, {newPointer, each.words[3], newImage});
                keep(each, out);
                out[out.size() - each.words.size() + 1] = newPointer;
                typeOfVariable[id] = newImage;
                return;
            }
        }
        keep(each, out);
        if (each.opcode == spv::OpLoad)
            if (const auto type = typeOfVariable.find(each.words[3]); type != typeOfVariable.end())
                out[out.size() - each.words.size() + 1] = type->second;
    });
    result[boundWord] = bound;
    return result;
}

} // namespace reprisec
