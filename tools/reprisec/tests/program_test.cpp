// SPDX-License-Identifier: Apache-2.0
// The program reprisec: what it writes, checks and says.
#include "small_pack.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>

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

// The real pack: the plan of a scene with nothing but a moving camera has no velocity pass, unless vectors
// are asked for.
class Needs : public Program {
protected:
    Outcome listed(const std::string& needs, const std::string& targets = "spirv") const {
        writeText(folder / "needs.toml", needs);
        return run("--needs " + (folder / "needs.toml").string() + " --targets " + targets +
                   " --list-outputs");
    }
};

TEST_F(Needs, selectTheModulesOfTheScenesPlan) {
    const std::string alone =
        "[needs]\nobjectsMove = false\n[settings]\nstage = \"fragment\"\npreset = \"lean\"\n";
    const Outcome camera = listed(alone),
                  vectors = listed(alone + "[settings.overrides]\nMOTION = \"vectors\"\n");
    for (const Outcome* each : {&camera, &vectors}) {
        EXPECT_EQ(each->code, 0);
        EXPECT_NE(each->text.find("fullscreen vertex"), std::string::npos) << each->text;
        EXPECT_EQ(each->text.find("object_velocity"), std::string::npos) << each->text;
    }
    EXPECT_NE(camera.text.find("temporal_aa--motion-camera"), std::string::npos) << camera.text;
    EXPECT_EQ(camera.text.find("camera_velocity"), std::string::npos) << camera.text;
    EXPECT_NE(vectors.text.find("camera_velocity fragment"), std::string::npos) << vectors.text;
    const Outcome wrong = listed("[needs]\nobjectMoves = false\n");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.text.find("needs.toml:2: there is no need \"objectMoves\""), std::string::npos)
        << wrong.text;
}

// GLSL has no quad operations: the module that has them is for Vulkan alone, the one without for both.
TEST_F(Needs, askNoGlslOfQuadOperations) {
    const Outcome best = listed("[settings]\nstage = \"compute\"\npreset = \"best\"\n", "spirv glsl450 json");
    const auto has = [&](const std::string& ending, bool quads) {
        std::istringstream lines(best.text);
        for (std::string line; std::getline(lines, line);)
            if (line.starts_with("temporal_aa--") && line.ends_with(ending) &&
                (line.find("quad_sharing-on") != std::string::npos) == quads)
                return true;
        return false;
    };
    for (const char* ending : {" spirv", " json"})
        EXPECT_TRUE(has(ending, true) && has(ending, false)) << ending << "\n" << best.text;
    EXPECT_TRUE(has(" glsl450", false)) << best.text;
    EXPECT_FALSE(has(" glsl450", true)) << best.text;
    const Outcome made = run("--needs " + (folder / "needs.toml").string() +
                             " --targets spirv glsl450 --out " + (folder / "out").string());
    EXPECT_EQ(made.code, 0) << made.text;
    const Outcome named =
        run("--variant temporal_aa--quad_sharing-on --stage compute --targets glsl450 --out " +
            (folder / "out").string());
    EXPECT_EQ(named.code, 1) << "asked for by name it must exist";
}

// Each field changes the list of modules, or takes effect without changing it where another one says so.
TEST_F(Needs, selectWhatTheFrameworkCaches) {
    const std::string still = "[needs]\nantiAliasing = false\ncameraMoves = false\nobjectsMove = false\n";
    const auto has = [](const Outcome& outcome, const char* module) {
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        return outcome.text.find(std::string(module) + " compute") != std::string::npos;
    };
    const Outcome usual = listed(still + "ambientOcclusion = true\n");
    for (const char* module : {"depth_downsample--half_depth-on",
                               "lighting_cache--history-still--change_detection-on--half_depth-on",
                               "bilateral_filter", "bilateral_upsample"})
        EXPECT_TRUE(has(usual, module)) << module << "\n" << usual.text;
    EXPECT_EQ(usual.text.find("ambient_occlusion"), std::string::npos) << usual.text;
    const Outcome apart =
        listed(still + "ambientOcclusion = true\n[settings.cache]\nmerges = false\nfilterStep = 2.0\n");
    for (const char* module :
         {"depth_downsample", "ambient_occlusion", "reprojection_cache--history-still--change_detection-on",
          "bilateral_filter--step-any"})
        EXPECT_TRUE(has(apart, module)) << module << "\n" << apart.text;
    EXPECT_EQ(apart.text.find("lighting_cache"), std::string::npos) << apart.text;
    EXPECT_EQ(usual.text.find("sun_shadow"), std::string::npos) << usual.text;
    EXPECT_EQ(usual.text.find("temporal_aa"), std::string::npos) << usual.text;

    const Outcome alone = listed(still + "ambientOcclusion = true\n[settings.cache]\nratio = 4\nsamples = 8\n"
                                         "history = false\nfilter = false\n");
    for (const char* module :
         {"depth_downsample--ratio-4", "ambient_occlusion--samples-8", "bilateral_upsample--ratio-4"})
        EXPECT_TRUE(has(alone, module)) << module << "\n" << alone.text;
    EXPECT_EQ(alone.text.find("reprojection_cache"), std::string::npos) << alone.text;
    EXPECT_EQ(alone.text.find("bilateral_filter"), std::string::npos) << alone.text;

    const Outcome both = listed(still + "ambientOcclusion = true\nsunShadows = true\nreversedShadows = true\n"
                                        "[settings.cache]\ncascades = 2\npacking = \"shadow_in_integer\"\n"
                                        "detectsChanges = false\nmerges = false\n");
    for (const char* module : {"sun_shadow--cascades-2--values-shadow_in_integer--shadow_reversed-on",
                               "reprojection_cache--history-still--values-shadow_in_integer"})
        EXPECT_TRUE(has(both, module)) << module << "\n" << both.text;
    const Outcome two = listed(still + "ambientOcclusion = true\nsunShadows = true\n[settings.cache]\n"
                                       "packing = \"two\"\ndetectsChanges = false\n");
    EXPECT_TRUE(has(two, "lighting_cache--values-two--fresh-both--history-still--half_depth-on")) << two.text;

    const Outcome other = listed(still + "ambientOcclusion = true\n[settings.cache]\n"
                                         "occlusion = \"scalable_obscurance\"\nsamples = 7\n");
    for (const char* module : {"depth_hierarchy", "scalable_obscurance--motion-off", "obscurance_filter"})
        EXPECT_TRUE(has(other, module)) << module << "\n" << other.text;

    const Outcome value = listed(still + "cachedChannels = 1\n[settings.overrides]\n"
                                         "\"bilateral_filter.TAPS\" = \"point\"\n");
    EXPECT_TRUE(has(value, "bilateral_filter--taps-point")) << value.text;
    EXPECT_EQ(value.text.find("ambient_occlusion"), std::string::npos) << value.text;
    const Outcome four = listed(still + "cachedChannels = 4\n");
    EXPECT_TRUE(has(four, "bilateral_upsample--values-four")) << four.text;
}

// Lighting before shading, which makes the motion, and anti-aliasing after it: docs/runtime.md, "Where in the
// frame".
TEST_F(Needs, theirSumHasTheModulesOfTwoRecorders) {
    const auto lines = [&](const std::string& needs) {
        const Outcome outcome = listed("[needs]\n" + needs);
        EXPECT_EQ(outcome.code, 0) << outcome.text;
        std::istringstream stream(outcome.text);
        std::set<std::string> found;
        for (std::string line; std::getline(stream, line);)
            found.insert(line);
        return found;
    };
    std::set<std::string> both = lines("antiAliasing = false\nambientOcclusion = true\n");
    const auto second = lines("engineWritesMotion = true\n");
    EXPECT_FALSE(std::ranges::includes(both, second));
    both.insert(second.begin(), second.end());
    EXPECT_EQ(both, lines("ambientOcclusion = true\n"));
}

TEST_F(Needs, mistakesAreNamedWithTheirLine) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"[settings.cache]\nratios = 2\n", ":2: there is no setting of the cache \"ratios\""},
        {"[settings.cache]\nhistory = 1\n", ":2: this must be true or false"},
        {"[settings.cache]\nratio = -2\n", ":2: this must be a whole number"},
        {"[settings.cache]\nratio = 4294967298\n", ":2: this must be a whole number"}, // 2 in 32 bits
        {"[settings.cache]\nsamples = 4.0\n", ":2: this must be a whole number"},
        {"[settings.cache]\npacking = true\n", ":2: this must be a string"},
        {"[settings]\ncache = true\n", ":2: this must be a table"},
        {"[settings]\ncashe = 1\n", ":2: there is no setting \"cashe\""},
        {"[needs]\nsunShadows = \"yes\"\n", ":2: a need is true or false"},
        {"[needs]\ncachedChannels = true\n", ":2: this must be a whole number"},
        {"[needs]\ncachedChannels = 5\n", ":1: SceneNeeds::cachedChannels is 0 to 4, not 5"},
        {"[settings.cache]\nfilterStep = \"1\"\n", ":2: this must be a number"},
        {"[settings.overrides]\nbilateral_filter.TAPS = \"point\"\n",
         ":2: the switch of another pass is written in quotes: \"bilateral_filter.SWITCH\""},
        {"[settings.overrides]\n\"no_pass.TAPS\" = \"point\"\n", ":1: there is no pass \"no_pass\""},
        {"[needs]\nambientOcclusion = true\n[settings.cache]\nratio = 3\n",
         ":1: CacheSettings::ratio is 1, 2 or 4, not 3"}};
    for (const auto& [needs, said] : mistakes) {
        const Outcome outcome = listed(needs);
        EXPECT_EQ(outcome.code, 1) << needs;
        EXPECT_NE(outcome.text.find(std::string("needs.toml") + said), std::string::npos)
            << needs << outcome.text;
    }
}
