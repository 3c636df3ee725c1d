// SPDX-License-Identifier: Apache-2.0
#include "shaders.hpp"
#include "parallel.hpp"

#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace report {
namespace fs = std::filesystem;
using reprise::Stage;

namespace {

template <class T> T orThrow(reprise::Result<T> result) {
    if (!result) throw std::runtime_error(result.error().message);
    return std::move(*result);
}

reprise::BindingKind kindNamed(const std::string& name) {
    using Kind = reprise::BindingKind;
    static const std::map<std::string, Kind> kinds{
        {"sampledImage", Kind::sampledImage},   {"pointSampler", Kind::pointSampler},
        {"linearSampler", Kind::linearSampler}, {"storageImage", Kind::storageImage},
        {"uniformBuffer", Kind::uniformBuffer}, {"storageBuffer", Kind::storageBuffer}};
    return kinds.at(name);
}

reprisec::Reflection reflectionOf(const nlohmann::json& json) {
    reprisec::Reflection reflection;
    for (const auto& b : json.at("bindings"))
        reflection.bindings.push_back({b.at("name"), b.at("binding"), kindNamed(b.at("kind")),
                                       b.at("samples"), b.at("gathers"), b.at("fetches"), b.at("stores"),
                                       b.at("scalars")});
    if (const auto& parameters = json.at("parameters"); !parameters.is_null()) {
        reflection.parameterBytes = parameters.at("bytes");
        for (const auto& m : parameters.at("members"))
            reflection.parameters.push_back({m.at("name"), m.at("type"), m.at("offset"), m.at("bytes")});
    }
    const auto& outputs = json.at("colourOutputs"); // null outside fragment shaders
    reflection.colourOutputs = outputs.is_null() ? 0u : outputs.get<uint32_t>();
    return reflection;
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

std::optional<reprisec::Compiled> readCommitted(const fs::path& generated, const reprise::Variant& variant,
                                                Stage stage) {
    auto spirv = reprise::spirvFromDirectory(generated.string())(variant, stage);
    const std::string name = reprise::spirvFileName(variant, stage);
    const fs::path file = generated / variant.pass->name / (name.substr(0, name.size() - 4) + ".json");
    std::ifstream stream(file);
    if (!spirv || !stream) return {};
    const auto json = nlohmann::json::parse(stream, nullptr, false);
    if (json.is_discarded())
        throw std::runtime_error(fmt::format("{} is no JSON; make it anew", file.string()));
    reprisec::Compiled compiled;
    compiled.spirv = std::move(*spirv);
    compiled.reflection = reflectionOf(json);
    return compiled;
}

Shaders::Shaders(const Assets& assets, bool fresh)
    : pack_(orThrow(reprisec::Pack::load(assets.packToml))), generated_(assets.generated), fresh_(fresh) {}

reprisec::Compiled Shaders::make(const reprise::Variant& variant, Stage stage) const {
    if (!fresh_)
        if (auto committed = readCommitted(generated_, variant, stage)) return std::move(*committed);
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
                [&](size_t i) { results[i] = make(work[i].second.first, work[i].second.second); });
    for (size_t i = 0; i < work.size(); ++i)
        compiled_.emplace(work[i].first, std::move(results[i]));
}

const reprisec::Compiled& Shaders::get(const reprise::Variant& variant, Stage stage) {
    const std::string name = reprise::spirvFileName(variant, stage);
    auto found = compiled_.find(name);
    if (found == compiled_.end()) found = compiled_.emplace(name, make(variant, stage)).first;
    return found->second;
}

const std::vector<uint32_t>& Shaders::fullscreenVertex() {
    const auto variant = orThrow(reprise::makeVariant(pack_.passes(), "fullscreen"));
    return get(variant, Stage::vertex).spirv;
}

reprise::SpirvSource Shaders::source() {
    return [this](const reprise::Variant& variant, Stage stage) -> reprise::Result<std::vector<uint32_t>> {
        try {
            return get(variant, stage).spirv;
        } catch (const std::exception& failure) {
            return reprise::Error{reprise::ErrorCode::badShader, failure.what()};
        }
    };
}

reprisec::Compiled compileText(const std::string& name, const std::string& text, Stage stage) {
    const char* entry = stage == Stage::compute  ? "mainCompute"
                        : stage == Stage::vertex ? "mainVertex"
                                                 : "mainFragment";
    return orThrow(reprisec::compileSource({.name = name,
                                            .text = text,
                                            .entry = entry,
                                            .stage = stage,
                                            .defines = {},
                                            .includeDirectories = {}}));
}

} // namespace report
