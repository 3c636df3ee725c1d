// SPDX-License-Identifier: Apache-2.0
// What clang-format cannot hold HLSL to: CONTRIBUTING's rules on sizes, comments, switches and tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = REPRISE_SOURCE_DIRECTORY;

struct SourceFile {
    fs::path path;
    std::string text;
    std::vector<std::string> lines;

    std::string name() const { return path.lexically_relative(root).string(); }
    bool isHeader() const { return path.extension() == ".hlsli"; }
    // Of the passes that include it.
    bool isPartOfPasses() const { return isHeader() && path.parent_path().filename() == "passes"; }
};

std::string readText(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream.good()) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
}

SourceFile readFile(const fs::path& path) {
    SourceFile file{path, readText(path), {}};
    std::istringstream stream(file.text);
    for (std::string line; std::getline(stream, line);)
        file.lines.push_back(line);
    return file;
}

std::vector<SourceFile> hlslFiles() {
    std::vector<SourceFile> files;
    for (const auto& entry : fs::recursive_directory_iterator(root / "hlsl"))
        if (entry.path().extension() == ".hlsl" || entry.path().extension() == ".hlsli")
            files.push_back(readFile(entry.path()));
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

std::string place(const SourceFile& file, size_t line) {
    return file.name() + ":" + std::to_string(line + 1);
}

// Columns as an editor counts them: bytes that begin no character of UTF-8 are none.
size_t columns(const std::string& line) {
    return static_cast<size_t>(
        std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool isComment(const std::string& line) {
    return line.find("//") != std::string::npos;
}

bool isBlank(const std::string& line) {
    return line.find_first_not_of(" \t") == std::string::npos;
}

TEST(HlslStyle, thereAreFilesToCheck) {
    EXPECT_GE(hlslFiles().size(), 18u);
}

TEST(HlslStyle, everyFileBeginsWithItsLicence) {
    for (const SourceFile& file : hlslFiles()) {
        ASSERT_FALSE(file.lines.empty()) << file.name();
        EXPECT_EQ(file.lines[0], "// SPDX-License-Identifier: Apache-2.0") << file.name();
    }
}

TEST(HlslStyle, linesAreAtMost110ColumnsWithoutTabsOrTrailingBlanks) {
    for (const SourceFile& file : hlslFiles()) {
        for (size_t i = 0; i < file.lines.size(); ++i) {
            const std::string& line = file.lines[i];
            EXPECT_LE(columns(line), 110u) << place(file, i);
            EXPECT_EQ(line.find('\t'), std::string::npos) << place(file, i) << " has a tab";
            EXPECT_EQ(line.find('\r'), std::string::npos) << place(file, i) << " has a carriage return";
            EXPECT_TRUE(line.empty() || line.back() != ' ') << place(file, i) << " ends with a blank";
        }
        EXPECT_TRUE(file.text.ends_with("\n")) << file.name() << " does not end with a line break";
    }
}

// A reason to be longer is a line of the file that begins with "// Longer than".
TEST(HlslStyle, filesAreShortOrSayWhyNot) {
    for (const SourceFile& file : hlslFiles()) {
        const size_t most = file.isHeader() ? 200 : 250;
        const bool saysWhy = file.text.find("// Longer than") != std::string::npos;
        EXPECT_TRUE(file.lines.size() <= most || saysWhy)
            << file.name() << " has " << file.lines.size()
            << " lines; split it, or say in a line that begins "
            << "with \"// Longer than " << most << " lines\" why not";
        EXPECT_TRUE(file.lines.size() > most || !saysWhy)
            << file.name() << " gives a reason that it does not need";
    }
}

TEST(HlslStyle, nothingIsSwitchedOffByZero) {
    const std::regex off(R"(^\s*#\s*if\s+(0|false)\b)");
    for (const SourceFile& file : hlslFiles())
        for (size_t i = 0; i < file.lines.size(); ++i)
            EXPECT_FALSE(std::regex_search(file.lines[i], off)) << place(file, i);
}

TEST(HlslStyle, headersHaveTheGuardOfTheirName) {
    for (const SourceFile& file : hlslFiles()) {
        if (!file.isHeader()) continue;
        std::string guard = "REPRISE_" + file.path.stem().string() + "_HLSLI";
        std::transform(guard.begin(), guard.end(), guard.begin(),
                       [](unsigned char c) { return std::toupper(c); });
        EXPECT_NE(file.text.find("#ifndef " + guard + "\n#define " + guard + "\n"), std::string::npos)
            << file.name() << " has no guard " << guard;
        EXPECT_TRUE(file.text.ends_with("#endif\n")) << file.name();
    }
}

TEST(HlslStyle, commentsAreNeitherMissingNorEverywhere) {
    for (const SourceFile& file : hlslFiles()) {
        const auto comments = std::count_if(file.lines.begin(), file.lines.end(), isComment);
        const auto blanks = std::count_if(file.lines.begin(), file.lines.end(), isBlank);
        // The licence is no comment on the code.
        const double share = static_cast<double>(comments - 1) /
                             static_cast<double>(static_cast<std::ptrdiff_t>(file.lines.size()) - blanks - 1);
        EXPECT_GE(share, 0.08) << file.name();
        // A file of a few lines is mostly its contract.
        EXPECT_TRUE(share <= 0.35 || file.lines.size() < 30) << file.name() << ": " << share;
    }
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
    return text;
}

std::set<std::string> quotedIn(const std::string& text) {
    static const std::regex quoted("\"([^\"]*)\"");
    std::set<std::string> found;
    for (auto i = std::sregex_iterator(text.begin(), text.end(), quoted); i != std::sregex_iterator(); ++i)
        found.insert((*i)[1]);
    return found;
}

// The macros that the table defines: NAME for a switch with off and on, NAME_VALUE for another; read with a
// pattern, not with the compiler, so that the two are held against each other.
std::set<std::string> tableMacros() {
    const std::string table = readText(root / "hlsl/pack.toml");
    std::set<std::string> macros = {"STAGE_COMPUTE"};
    std::smatch platform;
    if (std::regex_search(table, platform, std::regex(R"(platform_switches = \[([^\]]*)\])")))
        macros.merge(quotedIn(platform[1]));
    const std::regex entry(R"re(\[\[pass\.switch\]\]\s+name = "([A-Z_0-9]+)"\s+values = \[([^\]]*)\])re");
    for (auto i = std::sregex_iterator(table.begin(), table.end(), entry); i != std::sregex_iterator(); ++i) {
        const std::set<std::string> values = quotedIn((*i)[2]);
        if (values == std::set<std::string>{"off", "on"})
            macros.insert((*i)[1]);
        else
            for (const std::string& value : values)
                macros.insert((*i)[1].str() + "_" + upper(value));
    }
    return macros;
}

std::set<std::string> definedIn(const std::string& text) {
    static const std::regex definition(R"(#\s*define\s+([A-Za-z_][A-Za-z_0-9]*))");
    std::set<std::string> found;
    for (auto i = std::sregex_iterator(text.begin(), text.end(), definition); i != std::sregex_iterator();
         ++i)
        found.insert((*i)[1]);
    return found;
}

TEST(HlslStyle, everyTestedSwitchIsInATable) {
    std::set<std::string> known = tableMacros();
    known.merge(definedIn(readText(root / "hlsl/reprise/platform.hlsli")));
    for (const SourceFile& file : hlslFiles())
        if (file.isPartOfPasses()) known.merge(definedIn(file.text));
    const std::regex condition(R"(^\s*#\s*(?:if|elif)\s+(.*)$)"), name("[A-Za-z_][A-Za-z_0-9]*");
    size_t tested = 0;
    for (const SourceFile& file : hlslFiles()) {
        const std::set<std::string> own = definedIn(file.text);
        for (size_t i = 0; i < file.lines.size(); ++i) {
            std::smatch match;
            if (!std::regex_match(file.lines[i], match, condition)) continue;
            const std::string rest = match[1];
            for (auto n = std::sregex_iterator(rest.begin(), rest.end(), name); n != std::sregex_iterator();
                 ++n) {
                ++tested;
                EXPECT_TRUE(known.contains(n->str()) || own.contains(n->str()))
                    << place(file, i) << " tests " << n->str();
            }
        }
    }
    EXPECT_GT(tested, 30u);
}

TEST(HlslStyle, everySwitchOfTheTableIsTested) {
    std::string all;
    for (const SourceFile& file : hlslFiles())
        all += file.text;
    // Itself, or a macro that is made of it.
    const std::function<bool(const std::string&)> isTested = [&](const std::string& macro) {
        if (std::regex_search(all, std::regex("#\\s*(if|elif)[^\n]*\\b" + macro + "\\b"))) return true;
        const std::regex made("#\\s*define\\s+([A-Z_0-9]+)\\s[^\n]*\\b" + macro + "\\b");
        for (auto i = std::sregex_iterator(all.begin(), all.end(), made); i != std::sregex_iterator(); ++i)
            if (isTested((*i)[1])) return true;
        return false;
    };
    const std::string table = readText(root / "hlsl/pack.toml");
    const std::regex entry(R"re(\[\[pass\.switch\]\]\s+name = "([A-Z_0-9]+)")re");
    for (auto i = std::sregex_iterator(table.begin(), table.end(), entry); i != std::sregex_iterator(); ++i) {
        const std::string name = (*i)[1];
        const auto macros = tableMacros();
        EXPECT_TRUE(std::any_of(macros.begin(), macros.end(),
                                [&](const std::string& m) { return m.starts_with(name) && isTested(m); }))
            << name << " changes nothing";
    }
}

TEST(HlslStyle, everyFileHasATestOfItsName) {
    std::set<std::string> tests;
    for (const auto& entry : fs::recursive_directory_iterator(root / "tests"))
        if (entry.is_regular_file()) tests.insert(entry.path().filename().string());
    for (const SourceFile& file : hlslFiles()) {
        const std::string test = file.path.stem().string() + "_test.cpp";
        EXPECT_TRUE(tests.contains(test)) << file.name() << " has no " << test << " under tests";
    }
}

// What the file includes, and what that includes, of hlsl/passes.
void addIncluded(const std::vector<SourceFile>& files, const SourceFile& file, std::set<std::string>& found) {
    for (const SourceFile& other : files) {
        const std::string name = "passes/" + other.path.filename().string();
        const bool isIncluded = file.text.find("#include \"" + name + "\"") != std::string::npos;
        if (other.isPartOfPasses() && isIncluded && found.insert(name).second)
            addIncluded(files, other, found);
    }
}

TEST(HlslStyle, everyHeaderBesideThePassesIsPartOfOne) {
    const std::vector<SourceFile> files = hlslFiles();
    std::set<std::string> included;
    for (const SourceFile& file : files)
        if (!file.isHeader()) addIncluded(files, file, included);
    size_t parts = 0;
    for (const SourceFile& file : files)
        if (file.isPartOfPasses()) {
            ++parts;
            EXPECT_TRUE(included.contains("passes/" + file.path.filename().string()))
                << file.name() << " is included by no pass";
        }
    EXPECT_GE(parts, 6u);
}

} // namespace
