// SPDX-License-Identifier: Apache-2.0
// What a module reads and writes, and the layout of its parameters.
#include "internal.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <set>

#include <spirv_cross/spirv.hpp>
#include <spirv_cross/spirv_cross.hpp>

namespace reprisec {

namespace {

using reprise::BindingKind;
namespace sx = spirv_cross;

std::string typeName(const sx::SPIRType& type) {
    std::string name;
    switch (type.basetype) {
    case sx::SPIRType::Float:
        name = "float";
        break;
    case sx::SPIRType::Int:
        name = "int";
        break;
    case sx::SPIRType::UInt:
        name = "uint";
        break;
    case sx::SPIRType::Boolean:
        name = "bool";
        break;
    default:
        return "unknown";
    }
    // SPIRV-Cross sees HLSL's row_major matrix as its transposed one; the name is the HLSL one.
    if (type.columns > 1)
        name += std::to_string(type.columns) + "x" + std::to_string(type.vecsize);
    else if (type.vecsize > 1)
        name += std::to_string(type.vecsize);
    // The outermost dimension is the last.
    for (size_t i = type.array.size(); i > 0; --i)
        name += "[" + std::to_string(type.array[i - 1]) + "]";
    return name;
}

void reflectParameters(const sx::Compiler& compiler, const sx::Resource& block, Reflection& result) {
    const sx::SPIRType& type = compiler.get_type(block.base_type_id);
    for (uint32_t i = 0; i < type.member_types.size(); ++i) {
        ParameterMember member;
        member.name = compiler.get_member_name(block.base_type_id, i);
        member.type = typeName(compiler.get_type(type.member_types[i]));
        member.offset = compiler.type_struct_member_offset(type, i);
        member.bytes = static_cast<uint32_t>(compiler.get_declared_struct_member_size(type, i));
        result.parameters.push_back(std::move(member));
    }
    // The buffer is a multiple of 16 bytes, as the C++ struct is.
    result.parameterBytes = (static_cast<uint32_t>(compiler.get_declared_struct_size(type)) + 15u) & ~15u;
}

// Every use of a resource goes back to one variable through loads and combinations.
struct UseCounter {
    std::map<uint32_t, BindingUse*> variables;
    std::map<uint32_t, uint32_t> origin;

    BindingUse* use(uint32_t id) const {
        for (auto step = origin.find(id); step != origin.end(); step = origin.find(id))
            id = step->second;
        const auto found = variables.find(id);
        return found == variables.end() ? nullptr : found->second;
    }
    void count(uint32_t id, uint32_t BindingUse::*member) const {
        if (BindingUse* found = use(id)) ++(found->*member);
    }
    void countSampled(uint32_t id, uint32_t BindingUse::*member) {
        count(id, member);
        if (const auto sampler = samplers.find(id); sampler != samplers.end()) count(sampler->second, member);
    }
    std::map<uint32_t, uint32_t> samplers; // of a sampled image
};

bool isGather(uint32_t op) {
    return op == spv::OpImageGather || op == spv::OpImageDrefGather || op == spv::OpImageSparseGather ||
           op == spv::OpImageSparseDrefGather;
}

bool isSample(uint32_t op) {
    return op >= spv::OpImageSampleImplicitLod && op <= spv::OpImageSampleProjDrefExplicitLod;
}

void countInstruction(const Instruction& each, UseCounter& counter) {
    const auto& w = each.words;
    if (each.opcode == spv::OpLoad || each.opcode == spv::OpAccessChain || each.opcode == spv::OpImage ||
        each.opcode == spv::OpCopyObject || each.opcode == spv::OpSampledImage)
        counter.origin[w[2]] = w[3];
    if (each.opcode == spv::OpSampledImage) counter.samplers[w[2]] = w[4];
    if (isSample(each.opcode)) counter.countSampled(w[3], &BindingUse::samples);
    if (isGather(each.opcode)) counter.countSampled(w[3], &BindingUse::gathers);
    if (each.opcode == spv::OpImageFetch || each.opcode == spv::OpImageRead)
        counter.count(w[3], &BindingUse::fetches);
    if (each.opcode == spv::OpImageWrite) counter.count(w[1], &BindingUse::stores);
    // Of buffers only structured ones are counted here; a ScalarCounter counts parameters.
    if (each.opcode == spv::OpLoad)
        if (BindingUse* found = counter.use(w[3]); found && found->kind == BindingKind::storageBuffer)
            ++found->fetches;
    if (each.opcode == spv::OpStore) {
        BindingUse* found = counter.use(w[1]);
        if (found && found->kind == BindingKind::storageBuffer) ++found->stores;
    }
}

// Which values of a uniform buffer a module reads. A driver drops what nothing uses, a row of a matrix too,
// so components count where they are used: by an extract or a shuffle, or all of them by anything else.
struct ScalarCounter {
    struct Load {
        std::vector<uint32_t> place; // the indices of the access chain
        uint32_t rows = 1;           // values per component: 4 where a matrix was multiplied
        uint32_t width = 1;          // components
        uint32_t mask = 0;
        bool isComponent = false; // then the mask is known
    };
    std::map<uint32_t, std::vector<uint32_t>> chains; // by pointer
    std::map<uint32_t, Load> loads;                   // by value
    std::map<uint32_t, uint32_t> columns;   // of a type: components of a vector, columns of a matrix
    std::map<uint32_t, uint32_t> constants; // values of 32-bit ones
    uint32_t block = 0;

    void use(uint32_t id, uint32_t mask) {
        const auto found = loads.find(id);
        if (found == loads.end() || found->second.isComponent) return;
        found->second.mask |= mask & ((1u << found->second.width) - 1u);
    }
    void visit(const Instruction& each);
    Load loadOf(const std::vector<uint32_t>& chain, uint32_t components) const {
        Load load{chain, 1, components, 0, false};
        const auto component = chain.size() < 2 ? constants.end() : constants.find(chain.back());
        if (components > 1 || component == constants.end() || component->second > 3) return load;
        // One component of a vector, which may be read whole elsewhere.
        load.place.pop_back();
        return {std::move(load.place), 1, 1, 1u << component->second, true};
    }
    uint32_t width(uint32_t type) const {
        const auto found = columns.find(type);
        return found == columns.end() ? 1 : found->second;
    }
    uint32_t count() const {
        std::map<std::vector<uint32_t>, std::pair<uint32_t, uint32_t>> places; // loads of one place are one
        for (const auto& [id, load] : loads) {
            auto& [mask, rows] = places[load.place];
            mask |= load.mask;
            rows = load.rows;
        }
        uint32_t total = 0;
        for (const auto& [place, read] : places)
            total += static_cast<uint32_t>(std::popcount(read.first)) * read.second;
        return total;
    }
};

void ScalarCounter::visit(const Instruction& each) {
    const auto& w = each.words;
    if (each.opcode == spv::OpTypeVector || each.opcode == spv::OpTypeMatrix) columns[w[1]] = w[3];
    if (each.opcode == spv::OpAccessChain && w[3] == block) chains[w[2]] = {w.begin() + 4, w.end()};
    if (each.opcode == spv::OpConstant && w.size() == 4) constants[w[2]] = w[3];
    if (each.opcode == spv::OpLoad && chains.contains(w[3])) loads[w[2]] = loadOf(chains[w[3]], width(w[1]));
    if (each.opcode < spv::OpVectorExtractDynamic && each.opcode != spv::OpExtInst) return;
    if (each.opcode == spv::OpCompositeExtract) return use(w[3], 1u << w[4]);
    if (each.opcode == spv::OpVectorShuffle) {
        for (size_t i = 5; i < w.size(); ++i)
            if (w[i] < 4) use(w[3], 1u << w[i]);
        return;
    }
    if (each.opcode == spv::OpMatrixTimesVector || each.opcode == spv::OpVectorTimesMatrix) {
        const uint32_t matrix = each.opcode == spv::OpMatrixTimesVector ? w[3] : w[4];
        // The product stands for its matrix: a component of it that nothing uses is a row not read.
        if (const auto found = loads.find(matrix); found != loads.end()) {
            Load product = found->second;
            product.rows = 4;
            product.width = width(w[1]);
            loads[w[2]] = std::move(product);
        }
        return;
    }
    for (size_t i = 3; i < w.size(); ++i)
        use(w[i], 0xf);
}

void addBindings(const sx::Compiler& compiler, const sx::SmallVector<sx::Resource>& resources,
                 BindingKind kind, std::vector<std::pair<uint32_t, BindingUse>>& found) {
    for (const sx::Resource& each : resources) {
        BindingUse use;
        use.name = compiler.get_name(each.id);
        // A cbuffer has no variable name; its block has.
        if (use.name.empty() || kind == BindingKind::uniformBuffer) use.name = each.name;
        use.binding = compiler.get_decoration(each.id, spv::DecorationBinding);
        use.kind = kind; // of a sampler the table knows the filter, the module does not
        found.emplace_back(each.id, std::move(use));
    }
}

Result<void> checkDistinct(const std::vector<BindingUse>& bindings) {
    for (size_t i = 1; i < bindings.size(); ++i)
        if (bindings[i].binding == bindings[i - 1].binding)
            return badShader(bindings[i - 1].name + " and " + bindings[i].name + " both have binding " +
                             std::to_string(bindings[i].binding) +
                             "; give each resource its own [[vk::binding(n)]]");
    return {};
}

Result<Reflection> reflectModule(const Words& module, Stage stage) {
    Reflection result;
    const sx::Compiler compiler(module);
    const auto used = compiler.get_active_interface_variables();
    const sx::ShaderResources resources = compiler.get_shader_resources(used);
    std::vector<std::pair<uint32_t, BindingUse>> found;
    addBindings(compiler, resources.uniform_buffers, BindingKind::uniformBuffer, found);
    addBindings(compiler, resources.separate_images, BindingKind::sampledImage, found);
    addBindings(compiler, resources.sampled_images, BindingKind::sampledImage, found);
    addBindings(compiler, resources.separate_samplers, BindingKind::linearSampler, found);
    addBindings(compiler, resources.storage_images, BindingKind::storageImage, found);
    addBindings(compiler, resources.storage_buffers, BindingKind::storageBuffer, found);
    UseCounter counter;
    for (auto& [id, use] : found)
        counter.variables[id] = &use;
    forEachInstruction(module, [&](const Instruction& each) { countInstruction(each, counter); });
    for (auto& [id, use] : found) {
        if (use.kind == BindingKind::uniformBuffer) {
            ScalarCounter scalars;
            scalars.block = id;
            forEachInstruction(module, [&](const Instruction& each) { scalars.visit(each); });
            use.scalars = scalars.count();
        }
        result.bindings.push_back(use);
    }
    std::ranges::sort(result.bindings, {}, &BindingUse::binding);
    if (auto checked = checkDistinct(result.bindings); !checked) return checked.error();
    for (const auto& block : resources.uniform_buffers)
        if (compiler.get_decoration(block.id, spv::DecorationBinding) == 0)
            reflectParameters(compiler, block, result);
    if (stage == Stage::compute)
        for (uint32_t i = 0; i < 3; ++i)
            result.threads[i] = compiler.get_execution_mode_argument(spv::ExecutionModeLocalSize, i);
    if (stage == Stage::fragment)
        result.colourOutputs = static_cast<uint32_t>(resources.stage_outputs.size());
    return result;
}

} // namespace

Result<Reflection> reflect(const Words& module, Stage stage) {
    try {
        return reflectModule(module, stage);
    } catch (const std::exception& error) {
        return badShader(std::string("SPIRV-Cross cannot reflect the module: ") + error.what());
    }
}

} // namespace reprisec
