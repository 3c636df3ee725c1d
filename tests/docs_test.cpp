// SPDX-License-Identifier: Apache-2.0
// The pages say what the table of passes says, and point at files that are there.
#include "reprisec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using reprise::PassInfo;
using reprise::Stage;

std::string readText(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream.good()) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> pages() {
    std::vector<fs::path> found{"README.md", "CHANGELOG.md", "CONTRIBUTING.md"};
    for (const auto& entry : fs::directory_iterator("docs"))
        if (entry.path().extension() == ".md") found.push_back(entry.path());
    return found;
}

std::string quoted(std::string_view text) {
    return "`" + std::string(text) + "`";
}

// The row of a table whose first cell names the thing; several may share a row.
std::string rowOf(const std::string& page, std::string_view name) {
    std::istringstream stream(page);
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("| ") &&
            line.substr(0, line.find(" |", 2)).find(quoted(name)) != std::string::npos)
            return line;
    return {};
}

bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

const reprisec::Pack& pack() {
    static const auto loaded = reprisec::Pack::load("hlsl/pack.toml");
    EXPECT_TRUE(loaded) << loaded.error().message;
    return *loaded;
}

std::string pageOf(const PassInfo& pass) {
    if (pass.name == "temporal_aa" || pass.name == "sun_shadow" || pass.name == "combine_lighting")
        return readText("docs/" + std::string(pass.name) + ".md");
    if (pass.name == "depth_hierarchy" || pass.name == "scalable_obscurance" ||
        pass.name == "obscurance_filter")
        return readText("docs/scalable_obscurance.md");
    return readText(pass.name.ends_with("_velocity") ? "docs/velocity.md" : "docs/ambient_occlusion.md");
}

// The section of a pass on a page that several share.
std::string sectionOf(const PassInfo& pass) {
    const std::string page = pageOf(pass), heading = "\n## " + std::string(pass.name);
    const size_t begin = page.find(heading);
    if (begin == std::string::npos) return page;
    return page.substr(begin, page.find("\n## ", begin + 1) - begin);
}

// "22, 14.3": texture reads per pixel in the fragment and in the compute form; of a pass with one form that.
std::string readsOf(const reprise::Variant& variant) {
    std::string text;
    for (const Stage stage : {Stage::fragment, Stage::compute}) {
        if (std::ranges::find(variant.pass->stages, stage) == variant.pass->stages.end()) continue;
        const auto compiled =
            reprisec::compile(pack(), variant, stage, {.glsl = false, .platformSwitches = {}});
        if (!compiled) return compiled.error().message;
        double reads = 0.0;
        for (const auto& use : compiled->reflection.bindings)
            if (use.kind == reprise::BindingKind::sampledImage)
                reads += use.samples + use.gathers + use.fetches;
        const auto& pixels = variant.pass->pixelsPerThread;
        if (stage == Stage::compute) reads /= pixels[0] * pixels[1];
        char number[32];
        std::snprintf(number, sizeof(number), "%.*f", std::abs(reads - std::round(reads)) < 0.05 ? 0 : 1,
                      reads);
        text += (text.empty() ? "" : ", ") + std::string(number);
    }
    return text;
}

std::vector<const PassInfo*> passesWithPages() {
    std::vector<const PassInfo*> found;
    for (const PassInfo& pass : pack().passes())
        if (!pass.outputs.empty()) found.push_back(&pass); // not the triangle that draws the others
    return found;
}

TEST(Docs, everySwitchHasARowWithItsValuesAndItsDefault) {
    for (const PassInfo* pass : passesWithPages())
        for (const auto& info : pass->switches) {
            const std::string row = rowOf(sectionOf(*pass), info.name);
            EXPECT_NE(row, "") << pass->name << " " << info.name;
            for (size_t i = 0; i < info.values.size(); ++i) {
                const std::string value(info.values[i]);
                EXPECT_TRUE(has(row, i == info.defaultValue ? "**" + value + "**" : value)) << value << "\n"
                                                                                            << row;
            }
        }
}

TEST(Docs, everyImageHasARowWithItsBindingAndFormat) {
    for (const PassInfo* pass : passesWithPages()) {
        std::vector<reprise::ImageInfo> images(pass->inputs.begin(), pass->inputs.end());
        images.insert(images.end(), pass->outputs.begin(), pass->outputs.end());
        for (const auto& image : images) {
            const std::string row = rowOf(sectionOf(*pass), image.name);
            EXPECT_NE(row, "") << pass->name << " " << image.name;
            EXPECT_TRUE(has(row, image.format)) << image.format << "\n" << row;
            for (const auto& choice : image.formatBy)
                EXPECT_TRUE(has(row, std::string(choice.when.value) + ": " + std::string(choice.format)))
                    << choice.when.value << ": " << choice.format << "\n"
                    << row;
            for (const auto& binding : pass->bindings)
                if (binding.name == image.name) {
                    EXPECT_TRUE(has(row, "| " + std::to_string(binding.binding) + " |")) << row;
                }
        }
    }
}

// The parameters are the members of the constant buffer.
TEST(Docs, everyParameterIsNamed) {
    for (const PassInfo* pass : passesWithPages()) {
        const auto variant = reprise::makeVariant(pack().passes(), pass->name);
        ASSERT_TRUE(variant);
        const auto compiled = reprisec::compile(pack(), *variant, pass->stages.front(),
                                                {.glsl = false, .platformSwitches = {}});
        ASSERT_TRUE(compiled) << compiled.error().message;
        EXPECT_FALSE(compiled->reflection.parameters.empty()) << pass->name;
        for (const auto& parameter : compiled->reflection.parameters)
            EXPECT_NE(rowOf(sectionOf(*pass), parameter.name), "") << pass->name << " " << parameter.name;
    }
}

TEST(Docs, readsPerPixelAreThoseOfTheCompiledCode) {
    const auto standard = reprise::makeVariant(pack().passes(), "temporal_aa");
    ASSERT_TRUE(standard);
    const std::string page = pageOf(*standard->pass), usual = readsOf(*standard);
    for (const auto& preset : pack().presets("temporal_aa"))
        EXPECT_TRUE(
            has(rowOf(page, preset.name), "| " + readsOf(*pack().preset("temporal_aa", preset.name)) + " |"))
            << preset.name << ": " << readsOf(*pack().preset("temporal_aa", preset.name));
    for (const auto& info : standard->pass->switches)
        for (const auto& value : info.values) {
            reprise::Variant flipped = *standard;
            ASSERT_TRUE(reprise::setSwitch(flipped, info.name, value));
            const std::string reads = readsOf(flipped), said = std::string(value) + ": " + reads;
            if (reads != usual) {
                EXPECT_TRUE(has(rowOf(page, info.name), said)) << info.name << " " << said;
            }
        }
}

// The framework's passes have no presets: their sections say what the defaults read, and what each switch
// changes.
TEST(Docs, readsPerPixelOfTheFrameworkAreThoseOfTheCompiledCode) {
    size_t sections = 0;
    for (const PassInfo* pass : passesWithPages()) {
        const std::string section = sectionOf(*pass);
        if (!has(section, "Defaults: ")) continue;
        ++sections;
        const auto standard = reprise::makeVariant(pack().passes(), pass->name);
        ASSERT_TRUE(standard);
        const std::string usual = readsOf(*standard);
        EXPECT_TRUE(has(section, "Defaults: " + usual + " reads.")) << pass->name << ": " << usual;
        for (const auto& info : pass->switches)
            for (const auto& value : info.values) {
                reprise::Variant flipped = *standard;
                ASSERT_TRUE(reprise::setSwitch(flipped, info.name, value));
                const std::string reads = readsOf(flipped), said = std::string(value) + ": " + reads;
                if (reads != usual) {
                    EXPECT_TRUE(has(rowOf(section, info.name), said))
                        << pass->name << " " << info.name << " " << said;
                }
            }
    }
    EXPECT_GE(sections, 3u);
}

TEST(Docs, linksLeadToFiles) {
    const std::regex link(R"(\]\(([^)#:]+)\))");
    size_t links = 0;
    for (const fs::path& page : pages()) {
        const std::string text = readText(page);
        for (std::sregex_iterator each(text.begin(), text.end(), link), end; each != end; ++each, ++links)
            EXPECT_TRUE(fs::exists(page.parent_path() / (*each)[1].str())) << page << ": " << (*each)[1];
    }
    EXPECT_GT(links, 20u);
}

// Names in capitals and stars stand for others.
TEST(Docs, pathsAreThoseOfFiles) {
    const std::regex path(R"(`((?:hlsl|runtime|tests|tools|cmake|docs|generated|examples)/[a-z0-9_/.]*)`)");
    size_t paths = 0;
    for (const fs::path& page : pages()) {
        const std::string text = readText(page);
        for (std::sregex_iterator each(text.begin(), text.end(), path), end; each != end; ++each, ++paths)
            EXPECT_TRUE(fs::exists((*each)[1].str())) << page << ": " << (*each)[1];
    }
    EXPECT_GT(paths, 40u);
}

TEST(Docs, everyRowOfTheDocumentsIsAccountedForOnce) {
    const std::string page = readText("docs/documents.md");
    const std::pair<char, int> series[] = {{'D', 15}, {'T', 5}, {'S', 8}, {'W', 5}, {'I', 11}, {'M', 4}};
    for (const auto& [letter, count] : series)
        for (int i = 1; i <= count; ++i) {
            const std::string start = std::string("\n| ") + letter + std::to_string(i) + " |";
            const size_t first = page.find(start);
            EXPECT_NE(first, std::string::npos) << start;
            EXPECT_EQ(page.find(start, first + 1), std::string::npos) << start;
        }
}

} // namespace
