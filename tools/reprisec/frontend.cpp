// SPDX-License-Identifier: Apache-2.0
// glslang: HLSL to SPIR-V, and the check that emitted GLSL compiles.
#include "internal.hpp"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <memory>
#include <sstream>

namespace reprisec {

namespace {

void initialiseGlslang() {
    // Once a process, and never torn down: other threads may still compile.
    static const bool done = glslang::InitializeProcess();
    (void)done;
}

EShLanguage language(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return EShLangVertex;
    case Stage::fragment:
        return EShLangFragment;
    case Stage::compute:
        break;
    }
    return EShLangCompute;
}

// Finds headers beside the including file and then in the include directories, and remembers them.
class Includer final : public glslang::TShader::Includer {
public:
    explicit Includer(const std::vector<fs::path>& directories) : directories_(directories) {}

    IncludeResult* includeLocal(const char* header, const char* includer, size_t) override {
        const fs::path beside = fs::path(includer).parent_path() / header;
        if (IncludeResult* found = open(beside.lexically_normal())) return found;
        return includeSystem(header, includer, 0);
    }
    IncludeResult* includeSystem(const char* header, const char*, size_t) override {
        for (const fs::path& directory : directories_)
            if (IncludeResult* found = open((directory / header).lexically_normal())) return found;
        return nullptr;
    }
    void releaseInclude(IncludeResult* result) override { delete result; }

    const std::map<std::string, std::string>& opened() const { return opened_; }

private:
    IncludeResult* open(const fs::path& file) {
        std::error_code ignored;
        if (!fs::is_regular_file(file, ignored)) return nullptr;
        auto text = readText(file);
        if (!text) return nullptr;
        const auto entry = opened_.try_emplace(file.string(), std::move(*text)).first;
        return new IncludeResult(entry->first, entry->second.data(), entry->second.size(), nullptr);
    }

    const std::vector<fs::path>& directories_;
    std::map<std::string, std::string> opened_;
};

// glslang's log as one sentence: "file:line: message", and how many more there are.
std::string firstError(const std::string& log) {
    constexpr std::string_view mark = "ERROR: ";
    std::string first;
    int more = 0;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(mark) || line.find(" compilation errors.") != std::string::npos) continue;
        if (first.empty())
            first = line.substr(mark.size());
        else
            ++more;
    }
    if (first.empty()) first = log.empty() ? "glslang gave no message" : log.substr(0, log.find('\n'));
    while (first.ends_with(' '))
        first.pop_back();
    if (more > 0) first += " (and " + std::to_string(more) + " more)";
    return first;
}

std::string preambleOf(const Defines& defines) {
    std::string preamble;
    for (const auto& [name, value] : defines)
        preamble += "#define " + name + " " + std::to_string(value) + "\n";
    return preamble;
}

Words generate(const glslang::TIntermediate& intermediate, std::string& messages) {
    glslang::SpvOptions options;
    options.disableOptimizer = true; // ours runs afterwards, with passes of our choice
    spv::SpvBuildLogger logger;
    Words words;
    glslang::GlslangToSpv(intermediate, words, &logger, &options);
    messages = logger.getAllMessages();
    return words;
}

} // namespace

Result<Frontend> hlslToSpirv(const Source& source, const Defines& defines) {
    initialiseGlslang();
    glslang::TShader shader(language(source.stage));
    const char* text = source.text.c_str();
    const int length = static_cast<int>(source.text.size());
    const char* name = source.name.c_str();
    shader.setStringsWithLengthsAndNames(&text, &length, &name, 1);
    const std::string preamble = preambleOf(defines);
    shader.setPreamble(preamble.c_str());
    shader.setEntryPoint(source.entry.c_str());
    shader.setSourceEntryPoint(source.entry.c_str());
    shader.setEnvInput(glslang::EShSourceHlsl, language(source.stage), glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    // SPIR-V 1.3 is what every Vulkan since 1.1, SPIRV-Cross and translators to WGSL take.
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    shader.setAutoMapLocations(true);
    const auto messages = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules |
                                                   EShMsgHlslOffsets | EShMsgHlslLegalization);
    Includer includer(source.includeDirectories);
    const bool parsed =
        shader.parse(GetDefaultResources(), 100, ENoProfile, false, false, messages, includer);

    // An undefined macro in #if is 0 without a word, and often the cause of what follows: it is reported
    // first.
    std::vector<NamedText> files{{source.name, source.text}};
    Frontend result;
    for (const auto& [file, content] : includer.opened()) {
        files.push_back({file, content});
        result.headers.emplace_back(file);
    }
    if (auto checked = checkTestedMacros(files, defines); !checked) return checked.error();
    if (!parsed) return badShader(firstError(shader.getInfoLog()));

    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) return badShader(source.name + ":1: " + firstError(program.getInfoLog()));
    std::string log;
    result.spirv = generate(*program.getIntermediate(language(source.stage)), log);
    if (log.find("error") != std::string::npos || result.spirv.empty())
        return badShader(source.name +
                         ":1: glslang could not generate SPIR-V: " + log.substr(0, log.find('\n')));
    return result;
}

Result<void> checkGlsl(const std::string& name, const std::string& text, Stage stage) {
    initialiseGlslang();
    glslang::TShader shader(language(stage));
    const char* content = text.c_str();
    const int length = static_cast<int>(text.size());
    const char* file = name.c_str();
    shader.setStringsWithLengthsAndNames(&content, &length, &file, 1);
    if (!shader.parse(GetDefaultResources(), 100, false, EShMsgDefault))
        return badShader(firstError(shader.getInfoLog()));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(EShMsgDefault)) return badShader(firstError(program.getInfoLog()));
    return {};
}

} // namespace reprisec
