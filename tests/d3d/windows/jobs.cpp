// SPDX-License-Identifier: Apache-2.0
#include "jobs.hpp"

#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>

namespace d3d {

namespace {

template <class T> T next(std::istringstream& words) {
    T value{};
    if (!(words >> value)) throw Failure("the job file has a line that ends early: " + words.str());
    return value;
}

std::vector<fs::path> nextRoots(std::istringstream& words) {
    std::vector<fs::path> roots;
    std::istringstream list(next<std::string>(words));
    for (std::string root; std::getline(list, root, ',');)
        roots.emplace_back(root);
    return roots;
}

Macros restMacros(std::istringstream& words) {
    Macros macros;
    for (std::string word; words >> word;) {
        const size_t equals = word.find('=');
        macros[word.substr(0, equals)] = word.substr(equals + 1);
    }
    return macros;
}

Texels texelsOf(const fs::path& file) {
    const std::vector<char> bytes = readBytes(file);
    Texels texels(bytes.size() / sizeof(float));
    std::memcpy(texels.data(), bytes.data(), texels.size() * sizeof(float));
    return texels;
}

class Reader {
public:
    explicit Reader(fs::path directory) : directory_(std::move(directory)) {}

    void read(const std::string& line) {
        std::istringstream words(line);
        std::string word;
        if (!(words >> word)) return;
        const auto statement = statements().find(word);
        if (statement == statements().end()) throw Failure("the job file has an unknown statement: " + line);
        (this->*statement->second)(words);
    }
    Jobs take() { return std::move(jobs_); }

private:
    using Statement = void (Reader::*)(std::istringstream&);

    static const std::map<std::string, Statement>& statements() {
        static const std::map<std::string, Statement> known = {
            {"shader", &Reader::shader},
            {"header", &Reader::header},
            {"draw", &Reader::draw},
            {"dispatch", &Reader::dispatch},
            {"texture", &Reader::texture},
            {"constant", &Reader::constant},
            {"parameters", &Reader::parameters},
            {"buffer", &Reader::buffer},
            {"vertices", &Reader::vertices},
            {"element", &Reader::element},
            {"target", &Reader::target},
        };
        return known;
    }

    RunJob& run() {
        if (jobs_.runs.empty()) throw Failure("the job file has a resource before the first draw");
        return jobs_.runs.back();
    }

    // Braced lists are evaluated from left to right.
    void shader(std::istringstream& words) {
        jobs_.shaders.push_back(ShaderJob{next<std::string>(words), next<std::string>(words),
                                          next<std::string>(words), next<std::string>(words),
                                          nextRoots(words), restMacros(words)});
    }
    void header(std::istringstream& words) {
        jobs_.headers.push_back(HeaderJob{next<std::string>(words), next<std::string>(words),
                                          next<std::string>(words), nextRoots(words), restMacros(words)});
    }
    void draw(std::istringstream& words) {
        RunJob job;
        job.name = next<std::string>(words);
        job.version = next<int>(words);
        job.width = next<int>(words);
        job.height = next<int>(words);
        job.vertexShader = next<std::string>(words);
        job.shader = next<std::string>(words);
        jobs_.runs.push_back(job);
    }
    void dispatch(std::istringstream& words) {
        RunJob job;
        job.compute = true;
        job.version = 11;
        job.name = next<std::string>(words);
        job.width = next<int>(words);
        job.height = next<int>(words);
        job.shader = next<std::string>(words);
        for (unsigned& groups : job.groups)
            groups = next<unsigned>(words);
        jobs_.runs.push_back(job);
    }
    void texture(std::istringstream& words) {
        TextureJob texture;
        texture.slot = next<unsigned>(words);
        texture.linear = next<std::string>(words) == "linear";
        texture.width = next<int>(words);
        texture.height = next<int>(words);
        texture.texels = texelsOf(directory_ / next<std::string>(words));
        run().textures.push_back(std::move(texture));
    }
    void constant(std::istringstream& words) {
        ConstantJob constant;
        constant.vertex = next<std::string>(words) == "vertex";
        constant.name = next<std::string>(words);
        constant.registers = texelsOf(directory_ / next<std::string>(words));
        run().constants.push_back(std::move(constant));
    }
    void parameters(std::istringstream& words) {
        run().parameters = readBytes(directory_ / next<std::string>(words));
    }
    void buffer(std::istringstream& words) {
        const auto slot = next<unsigned>(words), stride = next<unsigned>(words);
        run().buffers.push_back({slot, stride, readBytes(directory_ / next<std::string>(words))});
    }
    void vertices(std::istringstream& words) {
        run().vertexStride = next<unsigned>(words);
        run().vertices = readBytes(directory_ / next<std::string>(words));
    }
    void element(std::istringstream& words) {
        run().elements.push_back(
            ElementJob{next<std::string>(words), next<std::string>(words), next<unsigned>(words)});
    }
    void target(std::istringstream& words) {
        run().targets.push_back(texelsOf(directory_ / next<std::string>(words)));
    }

    fs::path directory_;
    Jobs jobs_;
};

} // namespace

Jobs readJobs(const fs::path& file) {
    std::ifstream stream(file);
    if (!stream) throw Failure("there is no job file " + file.string());
    Reader reader(file.parent_path());
    for (std::string line; std::getline(stream, line);)
        reader.read(line);
    return reader.take();
}

std::vector<char> readBytes(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw Failure("there is no file " + file.string());
    return {std::istreambuf_iterator<char>(stream), {}};
}

void writeTexels(const fs::path& file, const Texels& texels) {
    std::ofstream stream(file, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(texels.data()),
                 static_cast<std::streamsize>(texels.size() * sizeof(float)));
    if (!stream) throw Failure("could not write " + file.string());
}

} // namespace d3d
