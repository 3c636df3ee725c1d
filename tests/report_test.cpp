// SPDX-License-Identifier: Apache-2.0
// What the report does without measuring: rows from the table, floors from reflection, files, page, progress.
#include "commands.hpp"
#include "floors.hpp"
#include "lighting_claims.hpp"
#include "lighting_rows.hpp"
#include "object_times.hpp"
#include "page.hpp"
#include "parallel.hpp"
#include "rotations.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace {

using namespace report;
namespace fs = std::filesystem;
using reprise::Stage;

const reprisec::Pack& pack() {
    static const auto loaded = reprisec::Pack::load("hlsl/pack.toml");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
}

reprise::Variant preset(std::string_view name) {
    auto variant = pack().preset("temporal_aa", name);
    if (!variant) throw std::runtime_error(variant.error().message);
    return *variant;
}

struct TemporaryFolder {
    fs::path path;
    TemporaryFolder() {
        static int count = 0;
        path = fs::temp_directory_path() /
               ("reprise-report-test-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
        fs::create_directories(path);
    }
    ~TemporaryFolder() { fs::remove_all(path); }
};

std::string contents(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::string messageOf(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& failure) {
        return failure.what();
    }
    return "";
}

Row timedRow(std::string variant, double ms, double flip) {
    Row row;
    row.technique = "temporal_aa";
    row.variant = std::move(variant);
    row.scene = "scene";
    row.stage = "compute";
    row.gpu = Timing{ms, ms, ms, 1};
    row.error.flip = flip;
    return row;
}

Report smallReport() {
    Report report;
    report.device = {{"name", "a </script> device"}, {"driver", "d"}, {"type", "cpu"}};
    report.settings = {{"frames", 2}};
    report.floors.push_back({"copy, compute", {1, 2, 3, 9}, 4.0});
    report.rows = {timedRow("fast", 1.0, 0.2), timedRow("good", 2.0, 0.1), timedRow("worse", 2.0, 0.3)};
    report.rows.push_back({});
    report.claims.push_back({"I1", "INSIDE", "a, \"claim\"", {}, nullptr, {}});
    report.pictures.push_back({"a scene/../x", 1, {{"truth", {1, 2, 3}}}});
    return report;
}

TEST(ReportRows, flipEverySwitchThatIsAChoiceExactlyOnce) {
    const std::vector<std::string> flipped{"inside"};
    const auto base = reprise::forStage(preset("inside"), Stage::fragment);
    std::set<std::pair<size_t, uint8_t>> flips;
    for (const RowSpec& row : temporalRows(pack(), Stage::fragment, flipped)) {
        if (!row.label.starts_with("inside + ")) continue;
        size_t differences = 0;
        for (size_t i = 0; i < base.values.size(); ++i)
            if (row.variant->values[i] != base.values[i])
                ++differences, flips.insert({i, row.variant->values[i]});
        EXPECT_EQ(1u, differences) << row.label;
    }
    size_t expected = 0;
    for (const auto& info : base.pass->switches)
        if (!describesInput(info)) expected += info.values.size() - 1;
    EXPECT_EQ(expected, flips.size());
}

TEST(ReportRows, leaveOutWhatHasNoEffectInTheStage) {
    const std::vector<std::string> flipped{"inside"};
    for (const RowSpec& row : temporalRows(pack(), Stage::compute, flipped)) {
        if (!row.variant) continue;
        const auto normal = reprise::forStage(*row.variant, Stage::compute);
        EXPECT_EQ(normal.values, row.variant->values) << row.label;
    }
}

TEST(ReportRows, haveNonePresetsSequencesAndTheUntoldCut) {
    std::set<std::string> labels;
    for (const RowSpec& row : temporalRows(pack(), Stage::fragment, {}))
        labels.insert(row.label);
    for (const char* label :
         {"none", "inside", "best", "best, camera", "lean", "lean, camera", "inside, jitter none",
          "inside, jitter halton8", "inside, jitter uniform4_helix", "inside, cut untold"})
        EXPECT_TRUE(labels.contains(label)) << label;
}

// Only where the plan would set it; it differs from the preset beside it in that alone.
TEST(ReportRows, haveThePresetsAsThePlanSetsThemWhereOnlyTheCameraMoves) {
    const auto rows = temporalRows(pack(), Stage::compute, {});
    size_t found = 0;
    for (size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].cameraAlone, rows[i].label.ends_with(", camera")) << rows[i].label;
        if (!rows[i].cameraAlone) continue;
        ++found;
        EXPECT_EQ(rows[i].label, rows[i - 1].label + ", camera");
        EXPECT_EQ(rows[i].preset, rows[i - 1].preset);
        reprise::Variant same = *rows[i].variant;
        EXPECT_EQ(reprise::switchValue(same, "MOTION"), "camera");
        ASSERT_TRUE(reprise::setSwitch(same, "MOTION", "vectors"));
        EXPECT_EQ(same.values, rows[i - 1].variant->values);
    }
    EXPECT_EQ(found, 2u);
    EXPECT_EQ(presetLabels(pack()),
              (std::vector<std::string>{"inside", "best", "best, camera", "lean", "lean, camera"}));
    EXPECT_TRUE(cameraMovesAlone(findScene("thin_geometry")));
    EXPECT_FALSE(cameraMovesAlone(findScene("fast_object")));
    EXPECT_FALSE(cameraMovesAlone(findScene("static_camera")));
    EXPECT_FALSE(cameraMovesAlone(findScene("foliage"))) << "leaves too";
}

// Less FLIP and less flicker, both measured, at no more time.
TEST(Claims, bestWinsAgainstTheDocumentsOnlyByWhatWasMeasured) {
    ReportOptions options;
    options.quick = true;
    options.technique = "temporal_aa";
    options.scenes = {"foliage"};
    const Plan plan = makePlan(options, pack());
    const auto holds = [&](double flip, std::optional<double> flicker, double ms) {
        Report report;
        report.device = {{"type", "cpu"}};
        for (const bool best : {false, true}) {
            Row row;
            row.technique = "temporal_aa";
            row.variant = best ? "best" : "inside";
            row.scene = "foliage";
            row.stage = "fragment";
            row.error.flip = best ? flip : 0.05;
            row.error.flicker = flicker ? std::optional(best ? *flicker : 0.01) : std::nullopt;
            row.gpu = timingOf({best ? ms : 20.0});
            report.rows.push_back(row);
        }
        for (const Claim& claim : judgeClaims(report, plan))
            if (claim.id == "best") return claim.holds;
        return std::optional<bool>{};
    };
    EXPECT_EQ(holds(0.04, 0.005, 20.0), true);
    EXPECT_EQ(holds(0.05, 0.005, 20.0), false);
    EXPECT_EQ(holds(0.04, 0.01, 20.0), false) << "as much flicker is not less";
    EXPECT_EQ(holds(0.04, 0.005, 20.1), false);
    EXPECT_EQ(holds(0.04, {}, 20.0), std::optional<bool>{}) << "of too few frames for flicker";
}

// Each judges its own row, and none where there is none.
TEST(Claims, theCopysBarsJudgeLeanWithAndWithoutVectors) {
    ReportOptions options;
    options.quick = true;
    options.technique = "temporal_aa";
    options.stage = "compute";
    const Plan plan = makePlan(options, pack());
    const auto holds = [&](std::optional<double> vectors, std::optional<double> camera) {
        Report report;
        report.device = {{"type", "discrete"}};
        for (const auto& [variant, copies] : {std::pair{"lean", vectors}, {"lean, camera", camera}}) {
            if (!copies) continue;
            Row row;
            row.technique = "temporal_aa";
            row.variant = variant;
            row.scene = findScene("thin_geometry").name;
            row.stage = "compute";
            row.perCopy = copies;
            report.rows.push_back(row);
        }
        std::vector<std::optional<bool>> all;
        for (const Claim& claim : judgeClaims(report, plan))
            if (claim.id == "speed, copy" || claim.id == "speed, camera") all.push_back(claim.holds);
        return all;
    };
    using Both = std::vector<std::optional<bool>>;
    EXPECT_EQ(holds(2.2, 2.0), (Both{false, true}));
    EXPECT_EQ(holds(2.1, 2.2), (Both{true, false}));
    EXPECT_EQ(holds({}, 2.0), (Both{{}, true}));
    EXPECT_EQ(holds(2.0, {}), (Both{true, {}}));
}

TEST(Floors, offsetsAreDistinctWhileThereIsRoom) {
    const uint32_t one[2] = {1, 1}, four[2] = {2, 2};
    const auto offsets = readOffsets(9, one, 1);
    for (size_t i = 0; i < offsets.size(); ++i)
        for (size_t j = 0; j < i; ++j)
            EXPECT_FALSE(offsets[i] == offsets[j]) << i << " and " << j;
    EXPECT_EQ((Offset{0, 0}), offsets.front());
    for (const Offset& o : readOffsets(4, four, 1)) { // one read a pixel: the four pixels themselves
        EXPECT_TRUE(o.x >= 0 && o.x <= 1 && o.y >= 0 && o.y <= 1) << o.x << ", " << o.y;
    }
}

// The floor is worth something only if the compiler keeps what was asked for.
void expectFloorReadsWhatThePassReads(const reprise::Variant& variant, Stage stage) {
    const auto pass = reprisec::compile(pack(), variant, stage, {.glsl = false, .platformSwitches = {}});
    ASSERT_TRUE(pass) << pass.error().message;
    const auto floor = compileText("floor", floorSource(variant, stage, pass->reflection, 641, 359), stage);
    for (const auto& use : pass->reflection.bindings) {
        const auto same = std::find_if(floor.reflection.bindings.begin(), floor.reflection.bindings.end(),
                                       [&](const auto& f) { return f.binding == use.binding; });
        ASSERT_NE(floor.reflection.bindings.end(), same) << use.name;
        EXPECT_EQ(use.samples, same->samples) << use.name;
        EXPECT_EQ(use.gathers, same->gathers) << use.name;
        EXPECT_EQ(use.fetches, same->fetches) << use.name;
        EXPECT_EQ(use.scalars, same->scalars) << use.name;
        EXPECT_EQ(use.stores, same->stores) << use.name;
        // Which filter a sampler has is the table's word, not the module's.
        if (!use.name.ends_with("_sampler")) {
            EXPECT_EQ(use.kind, same->kind) << use.name;
        }
    }
    EXPECT_EQ(pass->reflection.bindings.size(), floor.reflection.bindings.size());
    EXPECT_EQ(pass->reflection.colourOutputs, floor.reflection.colourOutputs);
}

TEST(Floors, haveTheReadsAndWritesOfTheirPass) {
    for (const char* name : {"inside", "best", "lean"})
        for (Stage stage : {Stage::fragment, Stage::compute}) {
            SCOPED_TRACE(std::string(name) + ", " + stageText(stage));
            reprise::Variant variant = reprise::forStage(preset(name), stage);
            expectFloorReadsWhatThePassReads(variant, stage);
            ASSERT_TRUE(reprise::setSwitch(variant, "MOTION", "camera"));
            expectFloorReadsWhatThePassReads(variant, stage);
        }
    const auto camera = reprise::makeVariant(pack().passes(), "camera_velocity");
    ASSERT_TRUE(camera);
    for (Stage stage : {Stage::fragment, Stage::compute})
        expectFloorReadsWhatThePassReads(*camera, stage);
}

// A driver compiles for the target's format: what only a component that it lacks needs is not computed, and
// SPIR-V does not show it.
TEST(Floors, sumInTheComponentsThatAreStored) {
    const auto returned = [](std::string_view pass, const std::string& sum) {
        const auto variant = reprise::makeVariant(pack().passes(), pass);
        if (!variant) throw std::runtime_error(variant.error().message);
        const auto source = floorSource(*variant, Stage::fragment, {}, 641, 359);
        return source.find("    return " + sum + ";\n") != std::string::npos;
    };
    EXPECT_TRUE(returned("temporal_aa", "sum"));
    EXPECT_TRUE(returned("camera_velocity", "float4(sum.xy + sum.zw, 0.0, 0.0)"));
    EXPECT_TRUE(returned("depth_downsample", "float4(dot(sum, 1.0), 0.0, 0.0, 0.0)"));
}

// Same vertex inputs, palettes and target: what the compiler drops would be missing from the floor's time.
TEST(Floors, ofTheObjectPassReadsItsPalettesAndVertices) {
    for (const bool skinned : {false, true}) {
        auto variant = reprise::makeVariant(pack().passes(), "object_velocity");
        ASSERT_TRUE(variant);
        if (skinned) {
            ASSERT_TRUE(reprise::setSwitch(*variant, "SKINNING", "on"));
        }
        for (const Stage stage : {Stage::vertex, Stage::fragment}) {
            const auto pass =
                reprisec::compile(pack(), *variant, stage, {.glsl = false, .platformSwitches = {}});
            ASSERT_TRUE(pass) << pass.error().message;
            const auto floor = compileText("floor", objectFloorSource(skinned), stage);
            std::set<uint32_t> expected, found;
            for (const auto& use : pass->reflection.bindings)
                expected.insert(use.binding);
            for (const auto& use : floor.reflection.bindings)
                found.insert(use.binding);
            EXPECT_EQ(expected, found);
            EXPECT_EQ(pass->reflection.colourOutputs, floor.reflection.colourOutputs);
            EXPECT_EQ(pass->reflection.parameterBytes, floor.reflection.parameterBytes);
        }
    }
}

TEST(Results, theFrontHasWhatNoOtherRowBeats) {
    Report report = smallReport();
    markPareto(report.rows);
    EXPECT_TRUE(report.rows[0].pareto.value());
    EXPECT_TRUE(report.rows[1].pareto.value());
    EXPECT_FALSE(report.rows[2].pareto.value());
    EXPECT_FALSE(report.rows[3].pareto.has_value()); // neither time nor error
}

TEST(Results, medianOfEvenAndOddCounts) {
    EXPECT_DOUBLE_EQ(2.0, timingOf({3.0, 1.0, 2.0}).median);
    EXPECT_DOUBLE_EQ(2.5, timingOf({4.0, 1.0, 2.0, 3.0}).median);
    EXPECT_DOUBLE_EQ(4.0, timingOf({4.0, 1.0}).max);
}

TEST(Results, everyFieldOfTheSchemaIsThereEvenIfItDoesNotApply) {
    const Json json = toJson(smallReport());
    for (const char* key : {"schema", "device", "settings", "floors", "rows", "claims"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const Json& row : json["rows"])
        for (const char* key : {"technique", "variant", "scene", "stage", "width", "height", "frames",
                                "gpu_ms", "passes", "memory_bytes", "reads_per_pixel", "error", "reference",
                                "pareto", "efficiency", "floor_ms", "per_frame"})
            EXPECT_TRUE(row.contains(key)) << key;
    const Json& empty = json["rows"][3];
    EXPECT_TRUE(empty["gpu_ms"].is_null());
    EXPECT_TRUE(empty["error"]["flip"].is_null());
    EXPECT_TRUE(json["claims"][0]["holds"].is_null());
}

TEST(Results, csvHasOneLineARowAndAsManyFieldsAsItsHead) {
    Report report = smallReport();
    report.rows[0].variant = "a, \"b\"";
    std::istringstream lines(toCsv(report));
    std::string head, first;
    std::getline(lines, head);
    std::getline(lines, first);
    EXPECT_NE(std::string::npos, first.find("\"a, \"\"b\"\"\""));
    const auto commas = [](const std::string& s) { return std::count(s.begin(), s.end(), ','); };
    EXPECT_EQ(commas(head) + 1, commas(first)); // one is inside the quotes
}

TEST(Results, writesAllFilesAndReplacesAnEarlierReport) {
    const TemporaryFolder folder;
    const fs::path out = folder.path / "report";
    writeReport(smallReport(), out);
    Report second = smallReport();
    second.rows.clear();
    checkWritable(out);
    writeReport(second, out);
    EXPECT_EQ(0u, Json::parse(contents(out / "report.json"))["rows"].size());
    for (const char* name : {"report.csv", "index.html", "a-scene----x-truth.png"})
        EXPECT_TRUE(fs::exists(out / name)) << name;
    EXPECT_EQ(
        1, std::distance(fs::directory_iterator(folder.path), fs::directory_iterator())); // nothing beside it
}

TEST(Results, refusesADirectoryThatIsNoReportAndAFile) {
    const TemporaryFolder folder;
    writeFile(folder.path / "thesis.tex", "work");
    EXPECT_NE("", messageOf([&] { checkWritable(folder.path); }));
    EXPECT_NE("", messageOf([&] { checkWritable(folder.path / "thesis.tex"); }));
    EXPECT_NE("", messageOf([&] { checkWritable("/proc/report"); }));
    EXPECT_EQ("--out is empty; name a directory", messageOf([&] { checkWritable(""); }));
    EXPECT_TRUE(fs::exists(folder.path / "thesis.tex"));
}

// Rows of W2 with errors of 1 where three times the taps are, and of `three` and `settled` with rotations.
Report rotationsReport(const Plan& plan, double three, double settled) {
    Report report;
    report.device = {{"type", "cpu"}};
    for (const RotationCase& each : rotationCases(plan)) {
        const bool isDefault = each.intensity == 1.0f;
        const auto add = [&](const std::string& variant, double error) -> Row& {
            Row row;
            row.technique = "scalable_obscurance";
            row.variant = variant;
            row.scene = "hall_static";
            row.stage = "compute";
            row.error.rmse = error;
            report.rows.push_back(row);
            return report.rows.back();
        };
        add(oneFrameName(each.few, each), 2.0);
        add(oneFrameName(each.many, each), 1.0);
        add(rotationsName(each), isDefault ? settled : 9.0).rmsePerFrame = {2.0, 1.5,
                                                                            isDefault ? three : 9.0};
    }
    return report;
}

// Both the first three frames and the settled ones count, to either side; what is measured beside the default
// intensity does not.
TEST(Claims, threeRotationsAreWithinFivePercent) {
    ReportOptions options;
    options.quick = true;
    options.technique = "occlusion";
    options.stage = "compute";
    const Plan plan = makePlan(options, pack());
    const auto holds = [&](double three, double settled) {
        for (const Claim& claim : judgeLighting(rotationsReport(plan, three, settled), plan))
            if (claim.id == "W2") return claim.holds;
        return std::optional<bool>();
    };
    EXPECT_EQ(holds(1.0, 1.049), true);
    EXPECT_EQ(holds(1.0, 0.951), true);
    EXPECT_EQ(holds(1.051, 1.0), false);
    EXPECT_EQ(holds(1.0, 0.949), false);
    Plan moving = plan;
    std::erase_if(moving.lightingScenes, [](const auto& scene) { return scene.name == "hall_static"; });
    for (const Claim& claim : judgeLighting(rotationsReport(plan, 1.0, 1.0), moving))
        EXPECT_TRUE(claim.id != "W2" || !claim.holds);
}

// Of occlusion, of the shadow and of both: each plan ends in the pass.
TEST(ReportRows, combineTheLightOfEachThatIsCached) {
    Shaders shaders(findAssets());
    const scenes::Scene scene = findScene("hall_static");
    for (const auto& [cached, value] :
         {std::pair(Cached::occlusion, "occlusion"), {Cached::shadow, "shadow"}, {Cached::both, "both"}}) {
        const auto rows = combinedRows(cached, false);
        ASSERT_EQ(rows.size(), 1u);
        const auto plan =
            makeFramePlan(shaders, needsOf(rows[0], scene), settingsOf(rows[0], Stage::fragment), {64, 36});
        const reprise::Variant& last = plan.passes.back().variant;
        EXPECT_EQ(last.pass->name, "combine_lighting");
        EXPECT_EQ(reprise::switchValue(last, "LIGHTING"), value);
    }
    EXPECT_TRUE(combinedRows(Cached::shadow, true).empty());
}

TEST(Page, isOneFileWithItsDataAndNothingFromOutside) {
    const std::string html = pageHtml(smallReport());
    EXPECT_EQ(std::string::npos, html.find("http://"));
    EXPECT_EQ(std::string::npos, html.find("https://"));
    EXPECT_EQ(std::string::npos, html.find("src=\""));
    EXPECT_EQ(std::string::npos, html.find("a </script> device")); // data cannot end its element
    EXPECT_NE(std::string::npos, html.find("data:image/png;base64,AQID"));
    for (const char* mark : {"/*style*/", "/*charts*/", "/*script*/", "/*pictures*/", "/*data*/"})
        EXPECT_EQ(std::string::npos, html.find(mark)) << mark;
}

TEST(Page, base64FollowsItsStandard) {
    const auto encoded = [](std::string_view text) {
        return base64({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
    };
    EXPECT_EQ("", encoded(""));
    EXPECT_EQ("Zg==", encoded("f"));
    EXPECT_EQ("Zm8=", encoded("fo"));
    EXPECT_EQ("Zm9vYmFy", encoded("foobar"));
}

TEST(ProgressBar, showsShareAndTimeLeft) {
    EXPECT_EQ("[############............]  50 %  0:10 left  scene", progressLine(0.5, 10.0, "scene", true));
    EXPECT_EQ("100 %  1:05 in all", progressLine(1.0, 65.0, "", false));
    EXPECT_EQ("  0 %", progressLine(0.0, 1.0, "", false));
}

TEST(Arguments, sizesAreCheckedInOneSentence) {
    EXPECT_EQ(1280u, parseSize("1280x720").width);
    for (const char* bad : {"", "x", "0x4", "4x0", "12", "12x", "x12", "-1x4", "1e3x4", "4x4x4", "99999x9"}) {
        const std::string message = messageOf([&] { parseSize(bad); });
        EXPECT_NE(std::string::npos, message.find("--size")) << bad;
        EXPECT_EQ(std::string::npos, message.find('\n')) << bad;
    }
}

TEST(Arguments, unknownNamesListTheKnownOnes) {
    EXPECT_NE(std::string::npos, messageOf([] { findScene("no_such_scene"); }).find("thin_geometry"));
    EXPECT_NE(std::string::npos, messageOf([] { findScene("no_such_scene"); }).find("hall_removed"));
    EXPECT_EQ(findScene("hall_removed").name, "hall_removed");
    EXPECT_NE(
        std::string::npos,
        messageOf([] {
            renderCommand(
                {.scene = "hall_static", .size = "4x4", .device = "", .show = "depth", .out = "unused.png"});
        }).find("colour, occlusion, sun"));
    EXPECT_NE(std::string::npos, messageOf([] { parseStages("pixel"); }).find("fragment, compute, both"));
    ReportOptions options;
    options.technique = "magic";
    EXPECT_NE(std::string::npos, messageOf([&] { makePlan(options, pack()); }).find("temporal_aa"));
    EXPECT_NE(std::string::npos, messageOf([&] { makePlan(options, pack()); }).find("shadow, lighting"));
    options = {};
    options.flips = {"magic"};
    EXPECT_NE(std::string::npos, messageOf([&] { makePlan(options, pack()); }).find("inside"));
}

TEST(Arguments, quickIsSmallerThanTheDefault) {
    ReportOptions options;
    const Plan full = makePlan(options, pack());
    options.quick = true;
    const Plan quick = makePlan(options, pack());
    EXPECT_LT(quick.errorSize.width, full.errorSize.width);
    EXPECT_LT(quick.frames, full.frames);
    EXPECT_GE(quick.rounds, 9u);
    EXPECT_GE(full.rounds, 15u);
    EXPECT_GE(full.scenes.size(), 5u);
}

// A still scene without anti-aliasing whose occlusion has neither history nor filter.
PlanOptions occlusionAlone() {
    PlanOptions options;
    options.size = "64x64";
    options.needs.antiAliasing = options.needs.cameraMoves = options.needs.objectsMove = false;
    options.needs.ambientOcclusion = true;
    options.cache.history = options.cache.filter = false;
    return options;
}

PlanCost costOf(Shaders& shaders, const PlanOptions& options) {
    return costOf(shaders, planFor(shaders, options.needs, options), parseSize(options.size));
}

// Reads of docs/ambient_occlusion.md and docs/scalable_obscurance.md, each over its own texels.
TEST(PlanCommand, weighsReadsByThePixelsOfTheOutput) {
    Shaders shaders(findAssets());
    PlanOptions options = occlusionAlone();
    const auto reads = [&] { return costOf(shaders, options).readsPerPixel; };
    for (const char* stage : {"fragment", "compute"}) {
        options.stage = stage;
        options.size = "64x64";
        options.cache.ratio = 2;
        // Four pixels of the upsampling's compute form share its three reads.
        const double upsampling = std::string_view(stage) == "compute" ? 0.75 : 3.0;
        EXPECT_DOUBLE_EQ(reads(), (1 + 6) / 4.0 + upsampling);
        options.size = "7x5"; // 4x3 coarse texels
        EXPECT_DOUBLE_EQ(reads(), (1 + 6) * 12 / 35.0 + upsampling);
        options.size = "64x64";
        options.cache.ratio = 4;
        EXPECT_DOUBLE_EQ(reads(), (4 + 6) / 16.0 + upsampling);
    }
    // Of both in one cache with a history: depth, both with their cache, and what upsampling has of two
    // values.
    options.occlusion = "ambient_occlusion";
    options.stage = "compute";
    options.cache.ratio = 2;
    options.cache.history = true;
    options.packing = "two";
    options.needs.sunShadows = options.needs.cameraMoves = true;
    EXPECT_DOUBLE_EQ(reads(), (1 + 12) / 4.0 + 1.0);
    options = occlusionAlone();
    options.occlusion = "scalable_obscurance"; // its hierarchy is half as wide again
    EXPECT_DOUBLE_EQ(reads(), 1.5 + 9);
}

TEST(PlanCommand, countsTheReadsOfObjectsAsIfTheyCoveredTheFrame) {
    Shaders shaders(findAssets());
    PlanOptions options = occlusionAlone();
    options.needs.skinnedMeshes = true;
    options.needs.antiAliasing = true;
    const double still = costOf(shaders, options).readsPerPixel;
    options.needs.objectsMove = true;
    const auto plan = planFor(shaders, options.needs, options);
    double own = 0.0;
    for (const auto& pass : plan.passes)
        if (pass.variant.pass->name == "object_velocity")
            for (const Stage stage : {Stage::vertex, Stage::fragment})
                own += readsPerPixel(pass.variant, stage, shaders.get(pass.variant, stage).reflection);
    PlanOptions resolved = options;
    resolved.needs.engineWritesMotion = true;
    EXPECT_DOUBLE_EQ(costOf(shaders, options).readsPerPixel, costOf(shaders, resolved).readsPerPixel + own);
    EXPECT_GT(costOf(shaders, resolved).readsPerPixel, still) << "motion is read";
}

// The filter runs twice and is one module; what is drawn needs the triangle, once.
TEST(PlanCommand, countsTheBytesOfEachModuleOnce) {
    Shaders shaders(findAssets());
    PlanOptions options = occlusionAlone();
    options.cache.filter = true;
    for (const Stage stage : {Stage::fragment, Stage::compute}) {
        options.stage = stageText(stage);
        const auto plan = planFor(shaders, options.needs, options);
        ASSERT_EQ(stage == Stage::fragment ? 6u : 5u, plan.passes.size());
        uint64_t words = stage == Stage::fragment ? shaders.fullscreenVertex().size() : 0;
        size_t again = 0;
        for (const auto& pass : plan.passes)
            if (pass.run == "down")
                ++again;
            else
                words += shaders.get(pass.variant, stage).spirv.size();
        EXPECT_EQ(1u, again);
        EXPECT_EQ(4 * words, costOf(shaders, options).spirvBytes);
    }
}

// The least of a scene: nothing moves, nothing is cached.
TEST(PlanCommand, comparesASceneWithEverythingOn) {
    Shaders shaders(findAssets());
    PlanOptions options;
    options.size = "64x64";
    options.needs.cameraMoves = options.needs.objectsMove = false;
    const auto all = planOfEverything(shaders, options), scene = planFor(shaders, options.needs, options);
    std::multiset<std::string> names;
    for (const auto& pass : all.passes)
        names.emplace(pass.variant.pass->name);
    const std::multiset<std::string> expected{
        "camera_velocity",  "object_velocity",  "object_velocity",    "depth_downsample", "lighting_cache",
        "bilateral_filter", "bilateral_filter", "bilateral_upsample", "combine_lighting", "temporal_aa"};
    EXPECT_EQ(expected, names);
    ASSERT_EQ(1u, scene.passes.size());
    EXPECT_EQ(scene.passes.front().variant.pass->name, "temporal_aa");
    // 2 of rgba16f are left; coarse and motion images, the output and the fallback's target are gone.
    EXPECT_EQ(2u * 8 * 64 * 64, scene.bytes);
    EXPECT_GT(all.bytes, 2 * scene.bytes);
    const PlanCost allCost = costOf(shaders, all, {64, 64}), sceneCost = costOf(shaders, scene, {64, 64});
    EXPECT_GT(allCost.readsPerPixel, sceneCost.readsPerPixel + 6) << "6 of upsampling and motion alone";
    EXPECT_GT(allCost.spirvBytes, 2 * sceneCost.spirvBytes);
}

// The table of docs/runtime.md, row by row.
TEST(PlanCommand, savesWhatThePageSays) {
    Shaders shaders(findAssets());
    const std::string page = contents("docs/runtime.md");
    const auto expectRow = [&](const char* name, const reprise::FramePlan& plan) {
        const PlanCost cost = costOf(shaders, plan, parseSize(PlanOptions{}.size));
        const std::string row = fmt::format("| {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", name,
                                            plan.passes.size(), double(plan.bytes) / (1024 * 1024),
                                            double(cost.spirvBytes) / 1024, cost.readsPerPixel);
        EXPECT_NE(std::string::npos, page.find(row)) << row;
    };
    PlanOptions still, rigid, occlusion, both;
    still.needs.objectsMove = rigid.needs.objectsMove = both.needs.objectsMove = false;
    still.needs.cameraMoves = still.needs.hdr = rigid.needs.hdr = false;
    occlusion.needs.ambientOcclusion = both.needs.ambientOcclusion = both.needs.sunShadows = true;
    const auto planned = [&](const PlanOptions& options) { return planFor(shaders, options.needs, options); };
    expectRow("everything on", planOfEverything(shaders, {}));
    expectRow("`--ambient-occlusion --sun-shadows --static-objects`", planned(both));
    expectRow("`--ambient-occlusion`", planned(occlusion));
    expectRow("`--static-objects --no-hdr`", planned(rigid));
    expectRow("`--static-camera --static-objects --no-hdr`", planned(still));
}

struct Printed {
    int status; // as pclose() gives it: 0 where the program ended well
    std::string text;
};

Printed printed(const std::string& arguments) {
    const std::string command = std::string(REPRISE_PROGRAM) + " " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return {-1, "popen failed"};
    std::string text;
    char buffer[4096];
    for (size_t got = 0; (got = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        text.append(buffer, got);
    return {pclose(pipe), text};
}

std::string printedPlan(const std::string& options) {
    return printed("plan --size 64x64 " + options).text;
}

// Each option, with what it alone brings into the plan, or out of it.
TEST(PlanCommand, optionsReachThePlan) {
    const std::string merged = "--no-anti-aliasing --static-camera --static-objects --ambient-occlusion ",
                      occlusion = merged + "--no-merging ";
    const auto has = [](const std::string& text, const char* part) {
        return text.find(part) != std::string::npos;
    };
    const std::string usual = printedPlan(occlusion);
    const std::pair<const char*, const char*> brought[] = {
        {"--sun-shadows", "  sun_shadow--values-shadow_in_integer\n"},
        {"--sun-shadows --packing occlusion_in_integer", "  sun_shadow--values-occlusion_in_integer\n"},
        {"--sun-shadows --packing two", "  bilateral_filter--values-two, across\n"},
        {"--sun-shadows --cascades 2", "  sun_shadow--cascades-2--"},
        {"--sun-shadows --reversed-shadows", "--shadow_reversed-on"},
        {"--occlusion scalable_obscurance", "  scalable_obscurance--motion-off\n"},
        {"--ratio 4", "  depth_downsample--ratio-4\n"},
        {"--ratio 1", "without bilateral_upsample: CacheSettings::ratio is 1"},
        {"--samples 8", "  ambient_occlusion--samples-8\n"},
        {"--no-history", "  reprojection_cache--history-none\n"},
        {"--no-change-detection", "  reprojection_cache--history-still\n"},
        {"--no-filter", "without bilateral_filter: CacheSettings::filter is off"},
        {"--filter-history", "gOutFiltered                 rg16f    32x32  0.00 MiB, history"},
    };
    for (const auto& [option, line] : brought) {
        EXPECT_FALSE(has(usual, line)) << line;
        const std::string text = printedPlan(occlusion + option);
        EXPECT_TRUE(has(text, line)) << option << "\n" << text;
    }
    EXPECT_TRUE(has(usual, "without lighting_cache: CacheSettings::merges is off")) << usual;
    EXPECT_TRUE(has(printedPlan(merged), "without reprojection_cache: lighting_cache does it"));
    EXPECT_TRUE(has(printedPlan("--cached-channels 1"), "gInFresh"));
    EXPECT_TRUE(has(printedPlan("--cached-channels 3"), "  bilateral_filter--values-four, across\n"));
    EXPECT_TRUE(has(printedPlan("--cached-channels 5"), "cachedChannels is 0 to 4, not 5"));
    EXPECT_TRUE(has(usual, "  bilateral_filter, across\n  bilateral_filter, down\n")) << usual;
    EXPECT_TRUE(has(usual, "count by its output's share of the frame's pixels")) << usual;
    EXPECT_TRUE(has(printedPlan(occlusion + "--occlusion sun_shadow"), "ambient_occlusion or scalable"));
    EXPECT_TRUE(has(printedPlan(occlusion + "--occlusion nothing"), "--occlusion nothing is not one of"));
}

TEST(Parameters, areLaidOutByNameAndAMissingOneIsAnError) {
    reprisec::Reflection reflection;
    reflection.parameters = {{"gA", "float", 4, 4}};
    const auto bytes = packParameters(reflection, 16, {{"gA", {2.5f}}});
    float value = 0.0f;
    std::memcpy(&value, bytes.data() + 4, sizeof value);
    EXPECT_EQ(2.5f, value);
    EXPECT_NE(std::string::npos, messageOf([&] { packParameters(reflection, 16, {}); }).find("gA"));
}

TEST(ParallelFor, doesAllAndThrowsTheFirstFailure) {
    std::vector<int> done(1000);
    parallelFor(done.size(), [&](size_t i) { done[i] = 1; });
    EXPECT_EQ(1000, std::count(done.begin(), done.end(), 1));
    EXPECT_EQ("stop", messageOf([] {
                  parallelFor(9, [](size_t i) {
                      if (i == 5) throw std::runtime_error("stop");
                  });
              }));
    parallelFor(0, [](size_t) { FAIL(); });
}

// The whole command, on a file: small, so that many sections have all the turns of a round in one submission.
TEST(ReportCommand, measuresEveryTechniqueInBothFormsOnAFile) {
    const TemporaryFolder folder;
    const fs::path out = folder.path / "made";
    const Printed report =
        printed("report --quick --size 32x18 --frames 6 --stage both --scene 2CylinderEngine.glb --out " +
                out.string());
    ASSERT_EQ(report.status, 0) << report.text;
    EXPECT_NE(contents(out / "index.html").find("2CylinderEngine"), std::string::npos);
    const auto json = nlohmann::json::parse(contents(out / "report.json"));
    std::set<std::pair<std::string, std::string>> timed;
    std::map<std::string, std::vector<double>> flip;
    for (const auto& row : json.at("rows")) {
        if (row.at("technique") == "temporal_aa") {
            EXPECT_EQ(row.at("scene"), "2CylinderEngine") << row;
            EXPECT_GT(row.at("error").at("flip"), 0.0) << row;
            EXPECT_EQ(row.at("not_finite"), 0) << row;
            flip[row.at("variant")].push_back(row.at("error").at("flip"));
        }
        // Without a time: no anti-aliasing, which has no pass, and what W2 compares.
        if (row.at("gpu_ms").is_null()) continue;
        EXPECT_GT(row.at("gpu_ms").at("min"), 0.0) << row;
        timed.emplace(row.at("technique"), row.at("stage"));
    }
    for (const char* technique : {"temporal_aa", "camera_velocity", "occlusion", "shadow"})
        for (const char* stage : {"fragment", "compute"})
            EXPECT_TRUE(timed.contains({technique, stage})) << technique << ", " << stage;
    for (const auto& [variant, errors] : flip)
        EXPECT_NEAR(errors.front(), errors.back(), 1e-3) << variant << ", its two forms";
}

// What a user may get wrong ends in one sentence, and leaves nothing behind.
TEST(ReportCommand, wrongArgumentsEndInASentence) {
    const TemporaryFolder folder;
    const std::pair<const char*, const char*> wrong[] = {
        {"--scene nowhere.glb", "nowhere.glb is neither a file nor a built-in scene"},
        {"--technique none", "--technique none is not known"},
        {"--size 0x18", "--size 0x18 must have both sides from 1 to 16384"},
        {"--frames 0", "--frames: Value 0 not in range 1 to 10000"},
        {"--stage pixel", "--stage pixel is not one of fragment, compute, both"},
        {"--device nothing-like-this", "There is no Vulkan device 'nothing-like-this'"}};
    for (const auto& [arguments, sentence] : wrong) {
        const Printed report =
            printed("report " + std::string(arguments) + " --out " + (folder.path / "made").string());
        EXPECT_TRUE(WIFEXITED(report.status) && WEXITSTATUS(report.status) == 1) << arguments;
        EXPECT_NE(report.text.find(sentence), std::string::npos) << report.text;
        EXPECT_EQ(std::ranges::count(report.text, '\n'), 1) << report.text;
        EXPECT_FALSE(fs::exists(folder.path / "made")) << arguments;
    }
}

TEST(Render, writesTheGroundTruthWithoutADevice) {
    const TemporaryFolder folder;
    for (const char* what : {"occlusion", "sun"}) {
        const fs::path file = folder.path / (std::string(what) + ".png");
        renderCommand({.scene = "hall_static",
                       .size = "32x18",
                       .device = "no such device",
                       .show = what,
                       .rays = 4,
                       .out = file});
        EXPECT_EQ(contents(file).substr(1, 3), "PNG");
    }
    EXPECT_NE(contents(folder.path / "occlusion.png"), contents(folder.path / "sun.png"));
}

} // namespace
