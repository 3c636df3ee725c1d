// SPDX-License-Identifier: Apache-2.0
#include "job_file.hpp"

#include <cstring>
#include <iterator>
#include <sstream>

namespace d3d {

namespace {

std::string joined(const std::vector<fs::path>& roots) {
    std::string text;
    for (const fs::path& root : roots)
        text += (text.empty() ? "" : ",") + root.generic_string();
    return text;
}

void writeShader(std::ostream& stream, const Shader& shader) {
    stream << shader.file << " " << joined(shader.roots);
    for (const auto& [name, value] : shader.macros)
        stream << " " << name << "=" << value;
    stream << "\n";
}

std::string word(std::istream& stream) {
    std::string text;
    stream >> text;
    return text;
}

std::string rest(std::istream& stream) {
    std::string text;
    std::getline(stream >> std::ws, text);
    if (text.ends_with('\r')) text.pop_back();
    return text;
}

} // namespace

JobFile::JobFile(fs::path directory) : directory_(std::move(directory)) {
    fs::create_directories(directory_);
    stream_.open(directory_ / "jobs.txt", std::ios::binary);
    stream_.exceptions(std::ios::failbit | std::ios::badbit);
}

std::string JobFile::blob(std::span<const std::byte> bytes) {
    const std::string name = "blob" + std::to_string(blobs_++);
    std::ofstream stream(directory_ / name, std::ios::binary);
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    return name;
}

std::string JobFile::blob(const passes::Pixels& pixels) {
    std::vector<float> texels;
    for (int i = 0; i < pixels.width * pixels.height; ++i)
        for (int c = 0; c < 4; ++c)
            texels.push_back(c < pixels.channels ? pixels.at(i % pixels.width, i / pixels.width, c)
                                                 : static_cast<float>(c == 3));
    return blob(std::as_bytes(std::span(texels)));
}

void JobFile::add(const Shader& shader) {
    if (!shaders_.insert(shader.name).second) return;
    stream_ << "shader " << shader.name << " " << shader.profile << " " << shader.entry << " ";
    writeShader(stream_, shader);
}

void JobFile::addHeader(const Shader& header) {
    stream_ << "header " << header.name << " " << header.profile << " ";
    writeShader(stream_, header);
}

void JobFile::add(const Run& run) {
    const bool compute = run.groups[0] > 0;
    stream_ << (compute ? "dispatch " : "draw ") << run.name << " ";
    if (!compute) stream_ << run.version << " ";
    stream_ << run.width << " " << run.height << " ";
    if (compute)
        stream_ << run.shader << " " << run.groups[0] << " " << run.groups[1] << "\n";
    else
        stream_ << run.vertexShader << " " << run.shader << "\n";
    for (const Texture& texture : run.textures) {
        auto [image, isNew] = images_.try_emplace(texture.pixels);
        if (isNew) image->second = blob(*texture.pixels);
        stream_ << "texture " << texture.slot << (texture.linear ? " linear " : " point ")
                << texture.pixels->width << " " << texture.pixels->height << " " << image->second << "\n";
    }
    for (const Constant& constant : run.constants)
        stream_ << "constant " << (constant.vertex ? "vertex " : "fragment ") << constant.name << " "
                << blob(std::as_bytes(std::span(constant.registers))) << "\n";
    if (!run.parameters.empty()) stream_ << "parameters " << blob(run.parameters) << "\n";
    for (const Palette& palette : run.palettes)
        stream_ << "buffer " << palette.slot << " " << palette.stride << " " << blob(palette.bytes) << "\n";
    if (!run.vertices.bytes.empty()) {
        stream_ << "vertices " << run.vertices.stride << " " << blob(run.vertices.bytes) << "\n";
        for (const Element& element : run.vertices.elements)
            stream_ << "element " << element.semantic << " " << element.type << " " << element.offset << "\n";
    }
    for (const passes::Pixels& target : run.targets)
        stream_ << "target " << blob(target) << "\n";
    stream_.flush();
}

Results::Results(const fs::path& directory) : directory_(directory) {
    std::ifstream stream(directory / "results.txt");
    if (!stream)
        throw std::runtime_error("There are no results in " + directory.string() + "; run d3d_run first.");
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        const std::string kind = word(words), name = word(words);
        if (kind == "function") {
            const std::string signature = word(words);
            functions_.emplace(name, std::pair(signature, rest(words)));
        } else
            reports_[kind + " " + name] = rest(words);
    }
}

std::string Results::of(const std::string& kind, const std::string& name) const {
    const auto found = reports_.find(kind + " " + name);
    return found == reports_.end() ? std::string() : found->second;
}

std::vector<std::pair<std::string, std::string>> Results::functions(const std::string& header) const {
    std::vector<std::pair<std::string, std::string>> found;
    const auto [first, last] = functions_.equal_range(header);
    for (auto each = first; each != last; ++each)
        found.push_back(each->second);
    return found;
}

std::vector<passes::Pixels> Results::targets(const Run& run) const {
    std::vector<passes::Pixels> targets;
    for (size_t i = 0; i < run.targets.size(); ++i) {
        const fs::path file = directory_ / (run.name + "." + std::to_string(i));
        std::ifstream stream(file, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
        passes::Pixels pixels{passes::rgba32f, run.width, run.height, 4, {}};
        pixels.values.resize(static_cast<size_t>(run.width * run.height * 4));
        if (bytes.size() != pixels.values.size() * sizeof(float))
            throw std::runtime_error(file.string() + " is missing or of another size.");
        std::memcpy(pixels.values.data(), bytes.data(), bytes.size());
        targets.push_back(std::move(pixels));
    }
    return targets;
}

} // namespace d3d
