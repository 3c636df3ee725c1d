// SPDX-License-Identifier: Apache-2.0
#include "changed_pack.hpp"

#include <fstream>
#include <sstream>

#include <unistd.h>

namespace passes {

namespace {

namespace fs = std::filesystem;

std::string readAll(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

// Never one that was there before: compiled modules are remembered by it.
fs::path newDirectory() {
    static int count = 0;
    return fs::temp_directory_path() /
           ("reprise_pack_" + std::to_string(getpid()) + "_" + std::to_string(count++));
}

// False if the text is not there.
bool apply(const TextChange& change, const fs::path& directory) {
    std::string text = readAll(directory / change.file);
    const size_t place = text.find(change.original);
    if (place == std::string::npos) return false;
    text.replace(place, change.original.size(), change.replacement);
    std::ofstream(directory / change.file, std::ios::binary) << text;
    return true;
}

} // namespace

ChangedPack::ChangedPack(std::span<const TextChange> changes) : directory_(newDirectory()) {
    fs::remove_all(directory_);
    fs::copy("hlsl", directory_, fs::copy_options::recursive);
    for (const TextChange& change : changes)
        if (!apply(change, directory_))
            missing_ = std::string(change.file) + " no longer holds: " + std::string(change.original);
    auto loaded = reprisec::Pack::load(directory_ / "pack.toml");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    pack_ = std::move(*loaded);
}

ChangedPack::~ChangedPack() {
    std::error_code ignored;
    fs::remove_all(directory_, ignored);
}

} // namespace passes
