// SPDX-License-Identifier: Apache-2.0
// The program reprisec: what it writes, checks and says.
#include "small_pack.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>

#include <sys/wait.h>

namespace {

struct Outcome {
    int code;
    std::string text; // of both streams
};

Outcome run(const std::string& arguments) {
    const std::string command = std::string(REPRISEC_PROGRAM) + " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {-1, "popen failed"};
    Outcome outcome{0, {}};
    std::array<char, 4096> buffer;
    for (size_t got = 0; (got = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
        outcome.text.append(buffer.data(), got);
    outcome.code = WEXITSTATUS(pclose(pipe));
    return outcome;
}

std::map<std::string, std::string> filesUnder(const fs::path& folder) {
    std::map<std::string, std::string> files;
    for (const auto& each : fs::recursive_directory_iterator(folder))
        if (each.is_regular_file())
            files[each.path().lexically_relative(folder).generic_string()] = readBytes(each.path());
    return files;
}

void flipOneByte(const fs::path& file) {
    std::string bytes = readBytes(file);
    ASSERT_FALSE(bytes.empty());
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    writeText(file, bytes);
}

} // namespace

class Program : public SmallPack {
protected:
    std::string packAndOut(const std::string& out = "out") const {
        return "--pack " + (folder / "pack.toml").string() + " --out " + (folder / out).string() + " ";
    }
};

TEST_F(Program, writesEveryTargetAndTheTable) {
    const Outcome written = run(packAndOut());
    ASSERT_EQ(written.code, 0) << written.text;
    const auto files = filesUnder(folder / "out");
    for (const char* name :
         {"copy/copy.frag.spv", "copy/copy.frag.450.glsl", "copy/copy.frag.es.glsl", "copy/copy.frag.json",
          "copy/copy.comp.spv", "copy/copy--taps-nine--fine-on.frag.spv", "copy/copy--taps-nine.comp.spv",
          "include/reprise/pack_table.hpp"})
        EXPECT_TRUE(files.contains(name)) << name;
    EXPECT_FALSE(files.contains("copy/copy--fine-on.comp.spv")) << "the switch has no effect in that stage";
    EXPECT_FALSE(files.contains("copy/copy--taps-gather.frag.es.glsl"));
    EXPECT_NE(files.at("copy/copy--taps-gather.frag.json").find("textureGather"), std::string::npos);
    EXPECT_NE(files.at("include/reprise/pack_table.hpp")
                  .find("static_assert(offsetof(CopyParameters, gCount) == 88)"),
              std::string::npos);
    for (const auto& [name, bytes] : files)
        EXPECT_FALSE(name.ends_with(".part")) << name;
}

TEST_F(Program, twoRunsWithDifferentThreadsGiveTheSameBytes) {
    ASSERT_EQ(run(packAndOut("one") + "--jobs 1").code, 0);
    ASSERT_EQ(run(packAndOut("two") + "--jobs 4").code, 0);
    EXPECT_EQ(filesUnder(folder / "one"), filesUnder(folder / "two"));
}

TEST_F(Program, checkFailsOnOneFlippedByteAMissingAndASuperfluousFile) {
    ASSERT_EQ(run(packAndOut()).code, 0);
    EXPECT_EQ(run(packAndOut() + "--check").code, 0);
    flipOneByte(folder / "out/copy/copy.comp.spv");
    fs::remove(folder / "out/copy/copy.frag.json");
    writeText(folder / "out/copy/copy--old-on.frag.spv", "left over");
    const Outcome checked = run(packAndOut() + "--check");
    EXPECT_EQ(checked.code, 1);
    for (const char* line : {"differs: ", "missing: ", "superfluous: ", "copy.comp.spv", "copy.frag.json",
                             "copy--old-on.frag.spv", "run reprisec"})
        EXPECT_NE(checked.text.find(line), std::string::npos) << line << " in " << checked.text;
    EXPECT_EQ(std::ranges::count(checked.text, '\n'), 4) << checked.text;
    ASSERT_EQ(run(packAndOut()).code, 0);
    EXPECT_EQ(run(packAndOut() + "--check").code, 0) << "writing again mends all three";
}

TEST_F(Program, depfileListsExactlyWhatWasRead) {
    const std::string depfile = (folder / "copy.d").string();
    const Outcome written =
        run(packAndOut() + "--variant copy--taps-nine --stage fragment --targets spirv --depfile " + depfile);
    ASSERT_EQ(written.code, 0) << written.text;
    const std::string path = folder.string();
    EXPECT_EQ(readBytes(depfile), path + "/out/copy/copy--taps-nine.frag.spv: \\\n  " + path +
                                      "/lib/taps.hlsli \\\n  " + path + "/pack.toml \\\n  " + path +
                                      "/passes/copy.hlsl\n");
    EXPECT_EQ(filesUnder(folder / "out").size(), 1u);
}

TEST_F(Program, nothingIsWrittenWhenOneVariantFails) {
    replace(folder / "passes/copy.hlsl", "sum += ddx_fine", "total += ddx_fine");
    const Outcome written = run(packAndOut());
    EXPECT_EQ(written.code, 1);
    EXPECT_NE(written.text.find("[copy--fine-on, fragment]"), std::string::npos) << written.text;
    EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(Program, targetAskedForThatCannotBeExpressedIsAnErrorWithTheReason) {
    const Outcome written = run(packAndOut() + "--variant copy --stage compute --targets glsles");
    EXPECT_EQ(written.code, 1);
    EXPECT_NE(written.text.find("rg16f"), std::string::npos) << written.text;
}

TEST_F(Program, wrongArgumentsEndWithASentence) {
    for (const char* wrong :
         {"--variant copy--taps-ten", "--pass copies", "--needs nowhere.toml", "--stage pixel"}) {
        const Outcome outcome = run(packAndOut() + wrong);
        EXPECT_NE(outcome.code, 0) << wrong;
        EXPECT_FALSE(outcome.text.empty()) << wrong;
    }
    EXPECT_EQ(run("--help").code, 0);
}

// The real pack: the plan of a scene with nothing but a moving camera has no object velocity.
TEST_F(Program, needsSelectTheModulesOfTheScenesPlan) {
    const auto listed = [&](const std::string& needs) {
        writeText(folder / "needs.toml", needs);
        return run("--needs " + (folder / "needs.toml").string() + " --targets spirv --list-outputs");
    };
    const Outcome camera =
        listed("[needs]\nobjectsMove = false\n[settings]\nstage = \"fragment\"\npreset = \"lean\"\n");
    EXPECT_EQ(camera.code, 0);
    EXPECT_NE(camera.text.find("fullscreen vertex"), std::string::npos) << camera.text;
    EXPECT_NE(camera.text.find("camera_velocity fragment"), std::string::npos) << camera.text;
    EXPECT_EQ(camera.text.find("object_velocity"), std::string::npos) << camera.text;
    const Outcome wrong = listed("[needs]\nobjectMoves = false\n");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.text.find("needs.toml:2: there is no need \"objectMoves\""), std::string::npos)
        << wrong.text;
}
