// SPDX-License-Identifier: Apache-2.0
// Checks of model files before the importer sees them: it trusts offsets, counts and links that a damaged
// file gets wrong. A file that passes cannot make it read out of bounds, recurse without end or allocate
// without bound.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace scenes {

// Thrown inside the loader and turned into a Result at its boundary: one clause on what is wrong and what to
// do.
struct Refusal {
    std::string reason;
};

inline constexpr size_t maxFileBytes = size_t(1) << 30;
inline constexpr size_t maxElements = 20'000'000; // vertices or indices of one model
inline constexpr size_t maxNodes = 100'000;
inline constexpr int maxNodeDepth = 256; // the importer recurses

std::vector<std::byte> readFile(const std::filesystem::path& file, size_t maxBytes = maxFileBytes);
std::string lowerExtension(const std::filesystem::path& file);

// glTF 2.0, as JSON or GLB.
void checkGltf(const std::filesystem::path& file);
// Wavefront OBJ.
void checkObj(const std::filesystem::path& file);

} // namespace scenes
