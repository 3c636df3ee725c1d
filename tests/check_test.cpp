// SPDX-License-Identifier: Apache-2.0
// reprise check: the table is whole and holds, wrong functions are reported, errors are counted right.
#include "commands.hpp"

#include "inputs.hpp"

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace check;
using functions::infinity;
using functions::notANumber;

const fs::path hlsl = "hlsl";

const functions::Bench& bench() {
    static harness::Gpu gpu(harness::DeviceOptions{.device = "", .validation = true});
    static const functions::Bench shared{gpu, hlsl};
    return shared;
}

struct TemporaryFolder {
    fs::path path;
    TemporaryFolder() {
        static int count = 0;
        path = fs::temp_directory_path() /
               ("reprise-check-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        fs::create_directories(path);
    }
    ~TemporaryFolder() { fs::remove_all(path); }
};

std::string contents(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string messageOf(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        return failure.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

// --- the table

std::string names(const std::vector<PublicFunction>& functions) {
    std::string text;
    for (const PublicFunction& function : functions)
        text += function.header + ": " + function.name + "\n";
    return text;
}

TEST(CheckTable, everyFunctionOfEveryHeaderHasACase) {
    EXPECT_EQ(names(withoutCase(publicFunctions(hlsl), table())), "");
}

TEST(CheckTable, everyCaseIsOfAFunctionThatIsThere) {
    const auto functions = publicFunctions(hlsl);
    for (const Case& each : table())
        EXPECT_NE(
            std::find(functions.begin(), functions.end(), PublicFunction{each.header(), each.function()}),
            functions.end())
            << each.header() << " " << each.function();
}

TEST(CheckTable, functionWithoutACaseIsReported) {
    auto cases = table();
    std::erase_if(cases, [](const Case& each) { return each.function() == "clipToUv"; });
    EXPECT_EQ(names(withoutCase(publicFunctions(hlsl), cases)), "reprise/reprojection.hlsli: clipToUv\n");
}

TEST(CheckTable, functionsAreFoundInTheTextOfTheHeaders) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path / "reprise");
    write(folder.path / "reprise/b.hlsli",
          "float2 spread(float a,\n              float b) {\n    return max(a, b);\n}\n"
          "ColourBox boxOf(Texture2D<float4> t) {\n}\n"
          "float2 spread(float2 a) {\n}\n");
    write(folder.path / "reprise/a.hlsli",
          "#define MACRO(x) (x)\nstatic const float LIMIT = float(1.0);\n"
          "struct Pair {\n    float a;\n    float sum(float b) {\n    }\n};\n"
          "// float quoted(float a)\nvoid nothing() {\n}\n");
    EXPECT_EQ(names(publicFunctions(folder.path)),
              "reprise/a.hlsli: nothing\nreprise/b.hlsli: spread\nreprise/b.hlsli: boxOf\n");
}

TEST(CheckTable, everyBoundHasAReasonAndEverySweepAName) {
    std::set<std::string> seen;
    for (const Case& each : table()) {
        EXPECT_STRNE(each.bound.reason, "") << each.function();
        EXPECT_TRUE(seen.insert(each.function() + " " + each.sweep).second)
            << each.function() << " has two sweeps named " << each.sweep;
        EXPECT_LE(each.sweep.size(), 60u) << each.sweep << " is wider than its column";
    }
}

// With the validation layer, a tenth of the inputs: what the command asks on its device.
TEST(CheckTable, everyFunctionHoldsItsBoundAndStaysFinite) {
    for (const Case& each : table())
        EXPECT_EQ(failure(check::run(bench(), each, {.quick = true})), "");
}

// --- the page

// "| `colour` | 7 | 12 |": functions and sweeps of each header, as the table has them.
TEST(CheckPage, everyHeaderHasItsRow) {
    const std::string page = contents("docs/check.md");
    std::map<std::string, std::set<std::string>> functionsOf;
    std::map<std::string, size_t> sweepsOf;
    std::set<std::pair<std::string, std::string>> all;
    const auto cases = table();
    for (const Case& each : cases) {
        const std::string header = fs::path(each.header()).stem().string();
        functionsOf[header].insert(each.function());
        ++sweepsOf[header];
        all.emplace(header, each.function());
    }
    for (const auto& [header, functions] : functionsOf)
        EXPECT_TRUE(has(page, "\n| `" + header + "` | " + std::to_string(functions.size()) + " | " +
                                  std::to_string(sweepsOf[header]) + " | "))
            << header << ": " << functions.size() << " functions, " << sweepsOf[header] << " sweeps";
    EXPECT_TRUE(
        has(page, std::to_string(all.size()) + " functions, " + std::to_string(cases.size()) + " sweeps"));
}

// --- deliberately wrong functions

std::vector<Outcome> outcomesOf(const std::vector<Case>& cases, const functions::Mutation& mutation = {}) {
    std::vector<Outcome> outcomes;
    for (const Case& each : cases)
        outcomes.push_back(check::run(bench(), each, {.quick = true}, mutation));
    return outcomes;
}

std::vector<Case> casesOf(const std::string& function) {
    auto cases = table();
    std::erase_if(cases, [&](const Case& each) { return each.function() != function; });
    return cases;
}

struct Wrong {
    std::string function, header, find, replacement, reported;
};

TEST(CheckMutants, wrongFunctionsAreReportedForWhatTheyDo) {
    const std::string above = "above its bound";
    const Wrong wrongs[] = {
        {"compressHdr", "colour", "max(maxComponent(colour), 0.0)", "maxComponent(colour)", "infinity"},
        {"expandHdr", "colour", "max(1.0 - maxComponent(compressed), 1.0 / (1.0 + MAX_COLOUR))",
         "(1.0 - maxComponent(compressed))", "infinity"},
        {"sanitize", "colour", "colour.b > 0.0 ? colour.b : 0.0", "colour.b", above},
        {"luminanceFeedback", "feedback",
         "saturate(1.0 - abs(currentLuminance - historyLuminance) / largest)",
         "1.0 - abs(currentLuminance - historyLuminance) / largest", "NaN"},
        {"blendHistory", "feedback", "current + (history - current) * weight",
         "current * (1.0 - weight) + history * (weight + 1e-6)", above},
        {"boxOfVariance", "neighbourhood", "variance > 0.0 ? min(variance, MAX_VARIANCE) : 0.0",
         "max(variance, 0.0)", "infinity"},
        // Moments about zero, which cancel in dark detail on a bright base.
        {"boxOfVariance", "neighbourhood", "(mean - n.centre) * (mean - n.centre)", "mean * mean", above},
        {"clipToBoxCentre", "history_constraint", "max(box.maximum - box.minimum, 2.0 * times * minExtent)",
         "box.maximum - box.minimum", above},
        {"clipToUv", "reprojection", "inFront && all(abs(uv) <= 8.0)", "inFront", "infinity"},
        {"clipToUv", "reprojection", "positionCS.w > 0.0", "positionCS.w != 0.0", above},
        {"linearDepthFromDevice", "depth", "1.0 / max(affine, 1e-30)", "1.0 / affine", "infinity"},
        {"unjitterWeightsGaussian", "unjitter", "clamp(jitterPx, -1.0, 1.0)", "jitterPx", "NaN"},
        {"isInsideUv", "coordinates", "all(asuint(uv) <= asuint(1.0))", "!any(abs(uv - 0.5) > 0.5)", above},
        {"quadSwapY", "quad_sharing", "ddy_fine(value) * side.y", "ddy_fine(value) * side.x", above},
        {"sampleCatmullRom5", "resampling", "f * f * (-0.5 + 0.5 * f)", "f * f * (-0.5 + 0.49 * f)", above},
    };
    for (const Wrong& wrong : wrongs) {
        const functions::Mutation mutation{"reprise/" + wrong.header + ".hlsli", wrong.find,
                                           wrong.replacement};
        const auto cases = casesOf(wrong.function);
        std::string reported;
        for (const Outcome& outcome : outcomesOf(cases, mutation))
            reported += failure(outcome) + "\n";
        EXPECT_TRUE(has(reported, wrong.function) && has(reported, wrong.reported))
            << wrong.replacement << " for " << wrong.find << " is reported as: " << reported;
    }
}

TEST(CheckMutants, printedFormsAreSeenToBreak) {
    std::map<std::string, Tally> printed;
    const auto cases = table();
    for (const Case& each : cases)
        if (each.printed)
            printed.emplace(each.function(), *check::run(bench(), each, {.quick = true}).printed);
    // 0/0 in a box without extent, and w = 0.
    EXPECT_GT(printed.at("clipToUv").nan, 0u);
    EXPECT_GT(printed.at("clipToUv").infinity, 0u);
    EXPECT_GT(printed.at("clipToBoxCentre").share.value, 1.0);
}

// --- counting

constexpr double step = 0x1p-23; // of binary32 at 1

TEST(CheckCounting, ulpIsTheStepOfBinary32AtTheExactResult) {
    EXPECT_EQ(ulpDistance(1.0f + 0x1p-23f, 1.0), 1.0);
    EXPECT_EQ(ulpDistance(1.0f - 0x1p-24f, 1.0), 0.5); // the step above 1 counts
    EXPECT_EQ(ulpDistance(1.0f, 1.0 - 0x1p-24), 1.0);
    EXPECT_EQ(ulpDistance(-2.0f, -2.0 - 3.0 * 2.0 * step), 3.0);
    EXPECT_EQ(ulpDistance(65504.0f, 65504.0 + 0.25 * 0x1p-8), 0.25);
    EXPECT_EQ(ulpDistance(0x1p-126f, 0.0), 0x1p23); // denormals by the step of the smallest normal number
    EXPECT_EQ(ulpDistance(0.0f, 0x1p-126 * step), 1.0);
}

Tally tallied(const std::vector<float>& actual, const std::vector<Right>& rights, const Bound& bound) {
    std::vector<Row> inputs, outputs;
    for (size_t i = 0; i < actual.size(); ++i) {
        inputs.push_back({vec4(static_cast<float>(i))});
        outputs.push_back({vec4(actual[i], notANumber, infinity, 7.0f)});
    }
    return tally(
        inputs, outputs, [&](const Row& in) { return std::vector{rights[static_cast<size_t>(in[0].x)]}; },
        bound);
}

TEST(CheckCounting, worstErrorsAreFoundWithTheirInputs) {
    const Tally t =
        tallied({1.0f, 102.0f, 0.5f}, {right(1.0), right(100.0), right(0.25)}, {Unit::relative, 0.5, "half"});
    EXPECT_EQ(t.inputs, 3u);
    EXPECT_EQ(t.absolute.value, 2.0);
    EXPECT_EQ(t.absolute.input[0].x, 1.0f);
    EXPECT_EQ(t.absolute.actual, 102.0f);
    EXPECT_EQ(t.absolute.expected, 100.0);
    EXPECT_EQ(t.relative.value, 1.0);
    EXPECT_EQ(t.relative.input[0].x, 2.0f);
    EXPECT_EQ(t.ulp.value, 0.25 / (0.25 * step));
    EXPECT_EQ(t.share.value, 2.0);
    EXPECT_EQ(t.nan + t.infinity, 0u) << "components that are not compared do not count";
}

TEST(CheckCounting, nanAndInfinityAreCountedByRow) {
    const Tally t = tallied({notANumber, 1.0f, infinity, -infinity}, std::vector(4, right(1.0)),
                            {Unit::absolute, 0.0, ""});
    EXPECT_EQ(t.nan, 1u);
    EXPECT_EQ(t.infinity, 2u);
    EXPECT_EQ(t.firstNotFinite[0].x, 0.0f);
    EXPECT_EQ(t.share.value, 0.0);
}

TEST(CheckCounting, openResultsMustOnlyBeFinite) {
    const Tally t = tallied({5.0f, notANumber}, {open(1), open(1)}, {Unit::exact, 0.0, ""});
    EXPECT_EQ(t.open, 2u);
    EXPECT_EQ(t.nan, 1u);
    EXPECT_EQ(t.share.value, 0.0);
    EXPECT_TRUE(t.absolute.input.empty());
}

TEST(CheckCounting, eachUnitOfABoundIsItsOwn) {
    const auto shareOf = [](const Bound& bound) {
        return tallied({4.5f}, {right(4.0, 8.0)}, bound).share.value;
    };
    EXPECT_EQ(shareOf({Unit::absolute, 0.25, ""}), 2.0);
    EXPECT_EQ(shareOf({Unit::relative, 0.25, ""}), 0.5);
    EXPECT_EQ(shareOf({Unit::ulp, 0x1p20, ""}), 0.5 / (0x1p20 * 4.0 * step));
    EXPECT_EQ(shareOf({Unit::roundings, 0x1p20, ""}), 1.0); // 2^20 times 2^-24 of 8
    EXPECT_EQ(shareOf({Unit::exact, 0.0, ""}), infinity);
    EXPECT_EQ(shareOf({Unit::finite, 0.0, ""}), 0.0);
}

// Devices may take denormals for 0: what that costs is no error, more is.
TEST(CheckCounting, flushedDenormalsAreNoError) {
    const Bound exact{Unit::exact, 0.0, ""};
    EXPECT_EQ(tallied({0.0f}, {right(1e-40)}, exact).share.value, 0.0);
    EXPECT_GT(tallied({0.0f}, {right(1e-37)}, exact).share.value, 1.0);
    EXPECT_TRUE(tallied({1.0f}, {right(0.0)}, exact).relative.input.empty())
        << "of 0 there is no relative error";
}

TEST(CheckCounting, oracleThatIsNotFiniteIsAnError) {
    EXPECT_NE(messageOf([] { tallied({1.0f}, {right(static_cast<double>(notANumber))}, {}); }), "");
}

// --- the command

Case snippet(const std::string& body) {
    return {"one input",
            {"sanitize", {"reprise/colour.hlsli"}, body},
            {Unit::exact, 0.0, "a copy"},
            [](const Effort&) {
                return Sweep{{{vec4(2.0f, 0.0f, 0.0f, notANumber)}},
                             [](const Row&) { return std::vector{right(2.0)}; }};
            }};
}

std::string messageOfCheck(const Case& each, const fs::path& out) {
    report::CheckOptions options;
    options.out = out;
    return messageOf([&] { report::checkCases(options, {each}, {}); });
}

TEST(CheckCommand, writesOneRowALineWithEveryField) {
    const TemporaryFolder folder;
    Case both = snippet("out0.x = in0.x;");
    both.printed = {"a document", "out0.x = in0.y / in0.y;", ""};
    EXPECT_EQ(messageOfCheck(both, folder.path / "check.json"), "") << "a printed form may do what it does";
    const std::string text = contents(folder.path / "check.json");
    const auto json = nlohmann::json::parse(text);
    EXPECT_EQ(json.at("schema"), 1);
    for (const char* key : {"name", "driver", "type"})
        EXPECT_NE(json.at("device").at(key), "") << key;
    EXPECT_EQ(json.at("quick"), false);
    ASSERT_EQ(json.at("rows").size(), 2u);
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
    const auto& row = json["rows"][0];
    for (const char* key :
         {"function", "header", "sweep", "form", "inputs", "open", "nan", "infinity", "first_not_finite",
          "absolute", "relative", "ulp", "bound", "share_of_bound", "holds"})
        EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(row["form"], "pack");
    EXPECT_EQ(row["holds"], true);
    EXPECT_EQ(row["ulp"]["value"], 0.0);
    EXPECT_EQ(row["ulp"]["input"].dump(), "[[2,0,0,\"nan\"]]");
    EXPECT_EQ(row["bound"]["unit"], "exact");
    EXPECT_EQ(row["bound"]["reason"], "a copy");
    const auto& printed = json["rows"][1];
    EXPECT_EQ(printed["form"], "printed");
    EXPECT_EQ(printed["printed_in"], "a document");
    EXPECT_EQ(printed["nan"], 1);
    EXPECT_EQ(printed["holds"], false);
}

TEST(CheckCommand, nanInfinityAndErrorsAreFailuresWithASentence) {
    const TemporaryFolder folder;
    const fs::path out = folder.path / "check.json";
    EXPECT_TRUE(has(messageOfCheck(snippet("out0.x = in0.y / in0.y;"), out), "NaN for 1 inputs"));
    EXPECT_TRUE(has(messageOfCheck(snippet("out0.x = in0.x / in0.y;"), out), "infinity for 1 inputs"));
    EXPECT_TRUE(has(messageOfCheck(snippet("out0.x = in0.x * 1.001;"), out), "above its bound"));
    EXPECT_EQ(nlohmann::json::parse(contents(out))["rows"][0]["holds"], false)
        << "the file is written all the same";
    report::CheckOptions options;
    options.out = out;
    const auto work = [&] {
        report::checkCases(options, {snippet("out0.x = in0.x;")}, {{"reprise/new.hlsli", "made"}});
    };
    EXPECT_TRUE(has(messageOf(work), "made of reprise/new.hlsli has no case"));
}

TEST(CheckCommand, failureOnTheWayLeavesTheFileAsItWas) {
    const TemporaryFolder folder;
    const fs::path out = folder.path / "check.json";
    write(out, "before");
    EXPECT_NE(messageOfCheck(snippet("out0.x = noSuchFunction(in0.x);"), out), "");
    EXPECT_EQ(contents(out), "before");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), {}), 1);
}

TEST(CheckCommand, placeThatCannotBeWrittenIsSaidBeforeTheWork) {
    const TemporaryFolder folder;
    for (const fs::path& out : {folder.path, folder.path / "none" / "check.json"})
        EXPECT_TRUE(has(messageOfCheck(snippet("out0.x = noSuchFunction(in0.x);"), out), "--out"));
}

struct Ended {
    int code = 0;
    std::string errors;
};

Ended runProgram(const fs::path& program, const std::string& arguments, const fs::path& folder) {
    const fs::path errors = folder / "errors.txt";
    const std::string line = program.string() + " check " + arguments + " >" +
                             (folder / "output.txt").string() + " 2>" + errors.string();
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(errors)};
}

TEST(CheckCommand, programEndsWithOneWhereAFunctionIsBroken) {
    const TemporaryFolder folder;
    const std::string out = "--quick --function compressHdr --out " + (folder.path / "check.json").string();
    EXPECT_EQ(runProgram(REPRISE_PROGRAM, out, folder.path).code, 0);
    EXPECT_EQ(nlohmann::json::parse(contents(folder.path / "check.json"))["rows"].size(),
              casesOf("compressHdr").size());

    // The program in a folder of its own, whose pack has lost a guard.
    fs::create_directories(folder.path / "bin");
    fs::create_directories(folder.path / "share/reprise");
    fs::copy(REPRISE_PROGRAM, folder.path / "bin/reprise");
    fs::copy(hlsl, folder.path / "share/reprise/hlsl", fs::copy_options::recursive);
    const fs::path header = folder.path / "share/reprise/hlsl/reprise/colour.hlsli";
    std::string text = contents(header);
    const std::string guarded = "max(maxComponent(colour), 0.0)";
    ASSERT_TRUE(has(text, guarded));
    write(header, text.replace(text.find(guarded), guarded.size(), "maxComponent(colour)"));
    const Ended broken = runProgram(folder.path / "bin/reprise", out, folder.path);
    EXPECT_EQ(broken.code, 1);
    EXPECT_TRUE(has(broken.errors, "compressHdr (to ±1e30): infinity for")) << broken.errors;
}

TEST(CheckCommand, programSaysWhatItDoesNotKnow) {
    const TemporaryFolder folder;
    const Ended unknown = runProgram(REPRISE_PROGRAM, "--function nothing", folder.path);
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(has(unknown.errors, "--function nothing is not known; there are ")) << unknown.errors;
    EXPECT_EQ(std::count(unknown.errors.begin(), unknown.errors.end(), '\n'), 1);
}

} // namespace
