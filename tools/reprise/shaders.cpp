// SPDX-License-Identifier: Apache-2.0
#include "shaders.hpp"
#include "parallel.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace fs = std::filesystem;
namespace {

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

} // namespace

Assets findAssets() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    const fs::path beside = program.parent_path().parent_path() / "share" / "reprise";
    for (const fs::path& root : {beside, fs::path(REPRISE_SOURCE_DIR)})
        if (fs::exists(root / "hlsl" / "pack.toml", error))
            return {root / "hlsl" / "pack.toml", root / "generated"};
    throw std::runtime_error(
        fmt::format("No pack at {}: keep the program in the folder that it came in, with share/ beside bin/",
                    (beside / "hlsl").string()));
}

Shaders::Shaders(const Assets& assets)
    : pack_(orThrow(reprisec::Pack::load(assets.packToml))),
      committed_(reprise::spirvFromDirectory((assets.generated / "spirv").string())) {}

reprisec::Compiled Shaders::compileOne(const reprise::Variant& variant, reprise::Stage stage) const {
    return orThrow(reprisec::compile(pack_, variant, stage, {.glsl = false, .platformSwitches = {}}));
}

void Shaders::prepare(std::span<const Request> requests) {
    std::map<std::string, Request> missing;
    for (const Request& request : requests) {
        std::string name = reprise::spirvFileName(request.first, request.second);
        if (!compiled_.contains(name)) missing.emplace(std::move(name), request);
    }
    std::vector<std::pair<std::string, Request>> work(missing.begin(), missing.end());
    std::vector<reprisec::Compiled> results(work.size());
    parallelFor(work.size(),
                [&](size_t i) { results[i] = compileOne(work[i].second.first, work[i].second.second); });
    for (size_t i = 0; i < work.size(); ++i)
        compiled_.emplace(work[i].first, std::move(results[i]));
}

const reprisec::Compiled& Shaders::get(const reprise::Variant& variant, reprise::Stage stage) {
    const std::string name = reprise::spirvFileName(variant, stage);
    auto found = compiled_.find(name);
    if (found == compiled_.end()) found = compiled_.emplace(name, compileOne(variant, stage)).first;
    return found->second;
}

const std::vector<uint32_t>& Shaders::fullscreenVertex() {
    const auto variant = orThrow(reprise::makeVariant(pack_.passes(), "fullscreen"));
    return get(variant, reprise::Stage::vertex).spirv;
}

reprise::SpirvSource Shaders::source() {
    return [this](const reprise::Variant& variant,
                  reprise::Stage stage) -> reprise::Result<std::vector<uint32_t>> {
        if (auto found = committed_(variant, stage)) return found;
        try {
            return get(variant, stage).spirv;
        } catch (const std::exception& failure) {
            return reprise::Error{reprise::ErrorCode::badShader, failure.what()};
        }
    };
}

reprisec::Compiled compileText(const std::string& name, const std::string& text, reprise::Stage stage) {
    const char* entry = stage == reprise::Stage::compute ? "mainCompute" : "mainFragment";
    return orThrow(reprisec::compileSource({.name = name,
                                            .text = text,
                                            .entry = entry,
                                            .stage = stage,
                                            .defines = {},
                                            .includeDirectories = {}}));
}

} // namespace report
