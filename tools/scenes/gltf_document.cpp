// SPDX-License-Identifier: Apache-2.0
#include "gltf_document.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <set>

namespace scenes {

std::vector<std::byte> readFile(const std::filesystem::path& file, size_t maxBytes) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed))
        throw Refusal{file.filename().string() + " does not exist; check the path"};
    const auto size = std::filesystem::file_size(file, failed);
    if (failed || size > maxBytes)
        throw Refusal{file.filename().string() + " is larger than 1 GiB; split it"};
    std::vector<std::byte> bytes(size);
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    if (size_t(stream.gcount()) != size)
        throw Refusal{file.filename().string() + " cannot be read; check its permissions"};
    return bytes;
}

std::string lowerExtension(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return extension;
}

namespace gltf {
namespace {

constexpr uint32_t glbMagic = 0x46546c67, jsonChunk = 0x4e4f534a, binChunk = 0x004e4942;
constexpr int maxJsonDepth = 64; // the importer's parser recurses

uint32_t word(const std::vector<std::byte>& bytes, size_t offset) {
    uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
}

// Depth of brackets outside of strings.
void checkNesting(const std::string& text) {
    int depth = 0;
    bool quoted = false, escaped = false;
    for (char c : text) {
        if (quoted) {
            quoted = escaped || c != '"';
            escaped = !escaped && c == '\\';
            continue;
        }
        if (c == '"')
            quoted = true;
        else if (c == '{' || c == '[')
            ++depth;
        else if (c == '}' || c == ']')
            --depth;
        if (depth > maxJsonDepth) throw Refusal{"its JSON is nested too deep; export it again"};
    }
}

Json parse(const std::string& text) {
    checkNesting(text);
    // Of two equal keys the importer takes the first and this parser the last: refuse what they read
    // differently.
    std::array<std::set<std::string>, maxJsonDepth + 2> keys;
    bool doubled = false;
    const auto watch = [&](int depth, Json::parse_event_t event, const Json& value) {
        if (event == Json::parse_event_t::object_start) keys[size_t(depth) + 1].clear();
        if (event == Json::parse_event_t::key)
            doubled |= !keys[size_t(depth)].insert(value.get<std::string>()).second;
        return true;
    };
    Json root = Json::parse(text, watch, false);
    if (doubled) throw Refusal{"its JSON names something twice; export it again"};
    if (root.is_discarded() || !root.is_object()) throw Refusal{"it is not valid JSON; export it again"};
    return root;
}

// Splits a GLB file into its JSON and, if there is one, its binary chunk.
std::string splitGlb(const std::vector<std::byte>& bytes, std::vector<std::byte>& binary) {
    if (bytes.size() < 20 || word(bytes, 4) != 2)
        throw Refusal{"it is not a GLB file of version 2; export it as glTF 2.0"};
    if (word(bytes, 8) > bytes.size()) throw Refusal{"it ends too early; copy or export it again"};
    const size_t length = word(bytes, 12);
    if (word(bytes, 16) != jsonChunk || length > bytes.size() - 20)
        throw Refusal{"its first chunk is not JSON or is cut off; export it again"};
    const size_t next = 20 + length;
    if (next < bytes.size()) {
        // The importer reads this chunk's header and body without looking at the length of the file.
        if (bytes.size() - next < 8 || word(bytes, next) > bytes.size() - next - 8 ||
            word(bytes, next + 4) != binChunk)
            throw Refusal{"its binary chunk is cut off; copy or export it again"};
        const auto begin = bytes.begin() + std::ptrdiff_t(next + 8);
        binary.assign(begin, begin + std::ptrdiff_t(word(bytes, next)));
    }
    return {reinterpret_cast<const char*>(bytes.data()) + 20, length};
}

int base64Value(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

std::vector<std::byte> decodeBase64(const std::string& uri, size_t start) {
    std::vector<std::byte> bytes;
    uint32_t bits = 0, held = 0;
    const size_t length = uri.size() - start;
    for (size_t i = start; i < uri.size() && uri[i] != '='; ++i) {
        const int value = base64Value(uri[i]);
        if (value < 0) throw Refusal{"it holds base64 data with a wrong character; export it again"};
        bits = bits << 6 | uint32_t(value);
        held += 6;
        if (held >= 8) bytes.push_back(std::byte(bits >> (held -= 8) & 255));
    }
    // The importer decodes in groups of four and reads past the end of an incomplete one.
    if (length % 4 != 0) throw Refusal{"it holds base64 data that is cut off; export it again"};
    return bytes;
}

std::filesystem::path decodePath(const std::string& uri) {
    std::string decoded;
    for (size_t i = 0; i < uri.size(); ++i) {
        const bool escape = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(uint8_t(uri[i + 1])) &&
                            std::isxdigit(uint8_t(uri[i + 2]));
        decoded += escape ? char(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
        if (escape) i += 2;
    }
    return decoded;
}

std::string textOf(const Json& uri, const std::string& where) {
    if (!uri.is_string()) throw Refusal{where + " has a link that is not text; export it again"};
    return uri;
}

// Where the base64 of an embedded link begins; 0: the link names a file.
size_t embeddedStart(const std::string& uri, const std::string& where) {
    if (uri.rfind("data:", 0) != 0) return 0;
    const size_t comma = uri.find(',');
    if (comma == std::string::npos || uri.find(";base64") > comma)
        throw Refusal{where + " is embedded but not in base64; export it again"};
    return comma + 1;
}

std::vector<std::byte> loadBuffer(const Json& buffer, size_t number, const std::filesystem::path& folder,
                                  std::vector<std::byte>& binary) {
    const std::string where = "buffer " + std::to_string(number);
    if (!buffer.is_object() || !buffer.contains("byteLength"))
        throw Refusal{where + " has no length; export it again"};
    const size_t bytes = index(buffer["byteLength"], where);
    std::vector<std::byte> data;
    if (!buffer.contains("uri")) {
        if (number != 0) throw Refusal{where + " has no data; export it again"};
        data = std::move(binary);
    } else {
        if (!buffer["uri"].is_string())
            throw Refusal{where + " has a link that is not text; export it again"};
        const std::string uri = buffer["uri"];
        const size_t comma = uri.find(',');
        const bool embedded = uri.rfind("data:", 0) == 0;
        if (embedded && (comma == std::string::npos || uri.find(";base64") > comma))
            throw Refusal{where + " is embedded but not in base64; export it again"};
        data = embedded ? decodeBase64(uri, comma + 1) : readFile(folder / decodePath(uri));
    }
    if (data.size() < bytes || bytes == 0)
        throw Refusal{where + " should have " + std::to_string(bytes) + " bytes and has " +
                      std::to_string(data.size()) + "; copy or export it again"};
    data.resize(bytes);
    return data;
}

size_t componentsOf(const Json& accessor, const std::string& where) {
    static const std::pair<const char*, size_t> kinds[] = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT2", 4}, {"MAT3", 9}, {"MAT4", 16}};
    for (const auto& [name, components] : kinds)
        if (accessor.value("type", Json()) == name) return components;
    throw Refusal{where + " has an unknown type; export it again"};
}

size_t componentBytes(uint32_t type, const std::string& where) {
    switch (type) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    case 5125:
    case floatType:
        return 4;
    default:
        throw Refusal{where + " has an unknown component type; export it again"};
    }
}

const Json& entry(const Json& root, const char* table, size_t number, const std::string& where) {
    const Json& entries = array(root, table);
    if (number >= entries.size() || !entries[number].is_object())
        throw Refusal{where + " points to entry " + std::to_string(number) + " of " + table +
                      ", which does not exist; export it again"};
    return entries[number];
}

// A part of a buffer: offset and length, both checked.
struct View {
    size_t buffer, offset, length, stride;
};

View viewAt(const Document& document, size_t number, const std::string& where) {
    const Json& view = entry(document.root, "bufferViews", number, where);
    View result{optionalIndex(view, "buffer", where, SIZE_MAX), optionalIndex(view, "byteOffset", where, 0),
                optionalIndex(view, "byteLength", where, 0), optionalIndex(view, "byteStride", where, 0)};
    if (result.buffer >= document.buffers.size())
        throw Refusal{where + " has a view of no buffer; export it again"};
    const size_t size = document.buffers[result.buffer].size();
    if (result.offset > size || result.length > size - result.offset || result.length == 0 ||
        result.stride > 252)
        throw Refusal{where + " lies in a part of its buffer that does not exist; export it again"};
    return result;
}

} // namespace

size_t index(const Json& value, const std::string& where) {
    // 2^40 leaves room to multiply by any stride without overflow.
    if (!value.is_number_unsigned() || value.get<uint64_t>() > (uint64_t(1) << 40))
        throw Refusal{where +
                      " has a count or an index that is not a sensible whole number; export it again"};
    return value.get<size_t>();
}

size_t optionalIndex(const Json& object, const char* key, const std::string& where, size_t otherwise) {
    return object.is_object() && object.contains(key) ? index(object[key], where) : otherwise;
}

const Json& array(const Json& object, const char* key) {
    static const Json empty = Json::array();
    if (!object.is_object() || !object.contains(key)) return empty;
    if (!object[key].is_array())
        throw Refusal{std::string("its ") + key + " are not a list; export it again"};
    return object[key];
}

const Json& object(const Json& parent, const char* key, const std::string& where) {
    if (!parent.is_object() || !parent.contains(key) || !parent[key].is_object())
        throw Refusal{where + " has no " + key + "; export it again"};
    return parent[key];
}

void Document::checkIndex(const Json& owner, const char* key, const char* table,
                          const std::string& where) const {
    if (!owner.is_object()) throw Refusal{where + " is not an object; export it again"};
    if (owner.contains(key)) entry(root, table, index(owner[key], where), where);
}

void Document::checkLink(const Json& uri, const std::string& where) const {
    const std::string text = textOf(uri, where);
    const size_t start = embeddedStart(text, where);
    if (start == 0) return;
    if (text.rfind("data:image/", 0) != 0)
        throw Refusal{where + " is of no kind of picture; export it as PNG or JPEG"};
    decodeBase64(text, start);
}

Accessor Document::accessor(const Json& number, const std::string& where) const {
    const Json& source = entry(root, "accessors", index(number, where), where);
    Accessor result;
    result.count = optionalIndex(source, "count", where, 0);
    result.componentType = uint32_t(optionalIndex(source, "componentType", where, 0));
    result.components = componentsOf(source, where);
    result.componentBytes = componentBytes(result.componentType, where);
    if (result.count == 0 || result.count > maxElements)
        throw Refusal{where + " has no values or too many; export it again"};
    if (!source.contains("bufferView"))
        throw Refusal{where + " has values without data; export without sparse or compressed accessors"};
    const View view = viewAt(*this, index(source["bufferView"], where), where);
    const size_t offset = optionalIndex(source, "byteOffset", where, 0),
                 element = result.components * result.componentBytes;
    result.buffer = view.buffer;
    result.offset = view.offset + offset;
    result.stride = view.stride == 0 ? element : view.stride;
    if (result.stride < element || offset > view.length ||
        (result.count - 1) * result.stride + element > view.length - offset)
        throw Refusal{where + " reaches beyond its buffer; export it again"};
    return result;
}

void Document::checkTables() const {
    for (size_t i = 0; i < array(root, "bufferViews").size(); ++i)
        viewAt(*this, i, "view " + std::to_string(i));
    for (size_t i = 0; i < array(root, "accessors").size(); ++i) {
        const std::string where = "accessor " + std::to_string(i);
        if (root["accessors"][i].is_object() && root["accessors"][i].contains("sparse"))
            throw Refusal{where + " is sparse; export without sparse accessors"};
        accessor(Json(i), where);
    }
}

uint64_t Document::unsignedAt(const Accessor& accessor, size_t element, size_t component) const {
    const size_t at = accessor.offset + element * accessor.stride + component * accessor.componentBytes;
    uint64_t value = 0; // little-endian, as glTF is and as every machine that this runs on
    std::memcpy(&value, buffers[accessor.buffer].data() + at, accessor.componentBytes);
    return value;
}

float Document::floatAt(const Accessor& accessor, size_t element, size_t component) const {
    const auto bits = uint32_t(unsignedAt(accessor, element, component));
    float value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

Document open(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = readFile(file);
    std::vector<std::byte> binary;
    const bool isGlb = bytes.size() >= 4 && word(bytes, 0) == glbMagic;
    if (isGlb != (lowerExtension(file) == ".glb"))
        throw Refusal{
            "its content is not what its extension says; name binary files .glb and JSON ones .gltf"};
    std::string text = isGlb ? splitGlb(bytes, binary)
                             : std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Document document{parse(text), {}};
    const Json version = document.root.value("asset", Json::object()).is_object()
                             ? document.root.value("asset", Json::object()).value("version", Json())
                             : Json();
    if (!version.is_string() || version.get<std::string>().rfind("2.", 0) != 0)
        throw Refusal{"it is not glTF 2.0; export it as glTF 2.0"};
    size_t number = 0;
    for (const Json& buffer : array(document.root, "buffers"))
        document.buffers.push_back(loadBuffer(buffer, number++, file.parent_path(), binary));
    return document;
}

} // namespace gltf
} // namespace scenes
