// SPDX-License-Identifier: Apache-2.0
#include "model_check.hpp"

#include <charconv>
#include <string_view>

namespace scenes {
namespace {

constexpr size_t maxLineBytes = 1 << 20; // a face with as many corners is not a face

struct Counts {
    int64_t positions = 0, uvs = 0, normals = 0;
    size_t corners = 0;
};

// Next word of the line, or empty.
std::string_view takeWord(std::string_view& line) {
    const size_t begin = line.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(" \t\r"));
    line.remove_prefix(word.size());
    return word;
}

void forEachLine(std::string_view text, const auto& visit) {
    size_t number = 0;
    while (!text.empty()) {
        const size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        ++number;
        if (line.size() > maxLineBytes)
            throw Refusal{"line " + std::to_string(number) + " is longer than 1 MiB; export it again"};
        visit(line, number);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
}

// One corner, position/uv/normal, of which the latter two may be missing.
void checkCorner(std::string_view corner, const Counts& counts, size_t number) {
    const int64_t limits[] = {counts.positions, counts.uvs, counts.normals};
    for (const int64_t limit : limits) {
        const size_t slash = corner.find('/');
        const std::string_view part = corner.substr(0, slash);
        int64_t value = 0;
        const auto parsed = std::from_chars(part.data(), part.data() + part.size(), value);
        const bool absent = part.empty() && limit != counts.positions;
        if (!absent && (parsed.ec != std::errc{} || parsed.ptr != part.data() + part.size() || value == 0 ||
                        value > limit || value < -limit))
            throw Refusal{"line " + std::to_string(number) +
                          " names a vertex, uv or normal that does not exist (" +
                          std::string(part.substr(0, 20)) + "); export it again"};
        if (slash == std::string_view::npos) return;
        corner.remove_prefix(slash + 1);
    }
}

void checkFace(std::string_view line, Counts& counts, size_t number) {
    const size_t before = counts.corners;
    for (std::string_view corner = takeWord(line); !corner.empty(); corner = takeWord(line)) {
        if (corner == "\\")
            throw Refusal{"line " + std::to_string(number) + " is continued on the next; join them"};
        if (corner.front() == '#') break;
        checkCorner(corner, counts, number);
        ++counts.corners;
    }
    if (counts.corners == before)
        throw Refusal{"line " + std::to_string(number) + " is a face without corners; export it again"};
    if (counts.corners > maxElements) throw Refusal{"it has more than 20 million corners; simplify it"};
}

} // namespace

void checkObj(const std::filesystem::path& file) {
    const std::vector<std::byte> bytes = readFile(file);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.find('\0') != std::string_view::npos)
        throw Refusal{"it is not a text file in UTF-8; save it as one"};
    Counts counts;
    forEachLine(text, [&](std::string_view line, size_t) {
        const std::string_view keyword = takeWord(line);
        counts.positions += keyword == "v";
        counts.uvs += keyword == "vt";
        counts.normals += keyword == "vn";
    });
    if (counts.positions == 0) throw Refusal{"it has no vertices; export it again"};
    if (size_t(counts.positions) > maxElements)
        throw Refusal{"it has more than 20 million vertices; simplify it"};
    forEachLine(text, [&](std::string_view line, size_t number) {
        const std::string_view keyword = takeWord(line);
        if (keyword == "f" || keyword == "l" || keyword == "p") checkFace(line, counts, number);
    });
    if (counts.corners == 0) throw Refusal{"it has no faces; export it with them"};
}

} // namespace scenes
