// SPDX-License-Identifier: Apache-2.0
// The little of a SPIR-V module that building a pipeline needs, read from its own words.
#pragma once

#include "reprise/pack.hpp"

#include <map>

namespace reprise {

struct SpirvModule {
    std::span<const uint32_t> words;
    Stage stage = Stage::compute;
    std::string entry;
    bool usesQuadOperations = false;
    std::vector<uint32_t> bindings; // numbers in descriptor set 0, ascending
};

// badShader when the words are no module, or have no entry point of vertex, fragment or compute.
Result<SpirvModule> readModule(std::span<const uint32_t> words);

} // namespace reprise
