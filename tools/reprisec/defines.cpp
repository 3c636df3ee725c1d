// SPDX-License-Identifier: Apache-2.0
// Macros: which ones a variant defines, and the check that #if tests no others.
#include "internal.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

namespace reprisec {

std::string upper(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return result;
}

Result<std::string> readText(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return Error{ErrorCode::fileError, "cannot read " + file.string() + "; does it exist?"};
    return std::string{std::istreambuf_iterator<char>(stream), {}};
}

std::string_view entryPoint(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return "mainVertex";
    case Stage::fragment:
        return "mainFragment";
    case Stage::compute:
        break;
    }
    return "mainCompute";
}

std::string_view stageWord(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return "vertex";
    case Stage::fragment:
        return "fragment";
    case Stage::compute:
        break;
    }
    return "compute";
}

namespace {

bool isOnOff(const reprise::SwitchInfo& info) {
    return std::ranges::all_of(info.values, [](std::string_view v) { return v == "off" || v == "on"; });
}

// Switches of a pass that is not being compiled are all 0: a shared header may test them.
void defineSwitch(Defines& defines, const reprise::SwitchInfo& info, std::string_view value) {
    const std::string name(info.name);
    if (isOnOff(info)) {
        defines[name] |= value == "on";
        return;
    }
    for (std::string_view each : info.values)
        defines[name + "_" + upper(each)] |= each == value;
}

bool isWordStart(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}
bool isWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

std::string_view nextWord(std::string_view& text) {
    size_t begin = 0;
    while (begin < text.size() && !isWordStart(text[begin])) {
        // The letters of a number such as 0x1F or 1u are no identifier.
        if (std::isdigit(static_cast<unsigned char>(text[begin])))
            while (begin + 1 < text.size() && isWord(text[begin + 1]))
                ++begin;
        ++begin;
    }
    size_t end = begin;
    while (end < text.size() && isWord(text[end]))
        ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

// Comments become blanks and continued lines are joined, with the line numbers kept.
std::string withoutComments(std::string_view text) {
    std::string result;
    bool line = false, block = false;
    for (size_t i = 0; i < text.size(); ++i) {
        const std::string_view two = text.substr(i, 2);
        if (text[i] == '\n')
            line = false;
        else if (!line && !block && (two == "//" || two == "/*"))
            (two == "//" ? line : block) = true;
        if (block && two == "*/") {
            block = false;
            ++i;
            continue;
        }
        result += (line || block) && text[i] != '\n' ? ' ' : text[i];
    }
    return result;
}

struct Directive {
    std::string word, rest;
    size_t line;
};

std::vector<Directive> directives(const std::string& text) {
    std::vector<Directive> found;
    const std::string clean = withoutComments(text);
    size_t number = 0;
    for (size_t at = 0; at < clean.size();) {
        const size_t first = ++number;
        std::string line;
        for (bool more = true; more && at < clean.size();) {
            const size_t end = std::min(clean.find('\n', at), clean.size());
            line += clean.substr(at, end - at);
            at = end + 1;
            more = line.ends_with('\\');
            if (more) line.back() = ' ', ++number;
        }
        const size_t hash = line.find_first_not_of(" \t");
        if (hash == std::string::npos || line[hash] != '#') continue;
        std::string_view rest = std::string_view(line).substr(hash + 1);
        const std::string word(nextWord(rest));
        found.push_back({word, std::string(rest), first});
    }
    return found;
}

// `defined(NAME)` asks whether there is one, so it may name any.
std::string undefinedWord(std::string_view condition, const std::set<std::string>& known) {
    for (std::string_view word = nextWord(condition); !word.empty(); word = nextWord(condition)) {
        if (word == "defined")
            nextWord(condition);
        else if (!known.contains(std::string(word)))
            return std::string(word);
    }
    return {};
}

} // namespace

Result<Defines> definesOf(const Pack& pack, const Variant* variant, Stage stage, const Defines& platform) {
    Defines defines;
    for (const PassInfo& pass : pack.passes())
        for (const auto& info : pass.switches) {
            const bool own = variant && variant->pass->name == pass.name;
            defineSwitch(defines, info, own ? reprise::switchValue(*variant, info.name) : std::string_view{});
        }
    const auto& known = pack.storage->platformSwitches;
    for (const std::string& name : known)
        defines[name] = 0;
    for (const auto& [name, value] : platform) {
        if (std::ranges::find(known, name) == known.end())
            return Error{ErrorCode::invalidArgument, "there is no platform switch " + name + " in " +
                                                         pack.file().string() +
                                                         "; add it to platform_switches"};
        defines[name] = value;
    }
    defines["STAGE_COMPUTE"] = stage == Stage::compute;
    return defines;
}

Result<void> checkTestedMacros(const std::vector<NamedText>& files, const Defines& defines) {
    std::set<std::string> known;
    for (const auto& [name, value] : defines)
        known.insert(name);
    for (const NamedText& file : files)
        for (const Directive& directive : directives(file.text))
            if (directive.word == "define") {
                std::string_view rest = directive.rest;
                known.insert(std::string(nextWord(rest)));
            }
    for (const NamedText& file : files)
        for (const Directive& directive : directives(file.text)) {
            if (directive.word != "if" && directive.word != "elif") continue;
            const std::string word = undefinedWord(directive.rest, known);
            if (!word.empty())
                return badShader(file.name + ":" + std::to_string(directive.line) + ": #" + directive.word +
                                 " tests " + word +
                                 ", which no table and no file defines; spell it as pack.toml does");
        }
    return {};
}

} // namespace reprisec
