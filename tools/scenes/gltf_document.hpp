// SPDX-License-Identifier: Apache-2.0
// A glTF file as JSON with its buffers, and reading from its accessors within bounds.
#pragma once

#include "model_check.hpp"

#include <cstdint>

#include <nlohmann/json.hpp>

namespace scenes::gltf {

using Json = nlohmann::json;

inline constexpr uint32_t floatType = 5126;

struct Accessor {
    size_t buffer = 0, offset = 0, stride = 0,
           count = 0; // bytes; a zero stride: no data, every value is zero
    uint32_t componentType = 0;
    size_t components = 0, componentBytes = 0;
};

struct Document {
    Json root;
    std::vector<std::vector<std::byte>> buffers;

    // Buffers, views and accessors, each within the one before it.
    void checkTables() const;
    // A link to a file, or a picture embedded in sound base64.
    void checkLink(const Json& uri, const std::string& where) const;
    Accessor accessor(const Json& index, const std::string& where) const;
    uint64_t unsignedAt(const Accessor& accessor, size_t element, size_t component) const;
    float floatAt(const Accessor& accessor, size_t element, size_t component) const;
    // object[key], where it is there, is an index into root[table].
    void checkIndex(const Json& object, const char* key, const char* table, const std::string& where) const;
};

// Reads the file and its buffers. Throws Refusal.
Document open(const std::filesystem::path& file);

size_t index(const Json& value, const std::string& where);
size_t optionalIndex(const Json& object, const char* key, const std::string& where, size_t otherwise);
// object[key] as an array; empty where it is absent.
const Json& array(const Json& object, const char* key);
const Json& object(const Json& parent, const char* key, const std::string& where);

} // namespace scenes::gltf
