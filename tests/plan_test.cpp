// SPDX-License-Identifier: Apache-2.0
// What the frame plan keeps, leaves out and why, with the table of the repository.
#include "reprise/plan.hpp"

#include "reprisec.hpp"

#include <algorithm>
#include <fstream>

#include <gtest/gtest.h>

namespace {

using namespace reprise;

const reprisec::Pack& pack() {
    static const auto loaded = reprisec::Pack::load("hlsl/pack.toml");
    if (!loaded) throw std::runtime_error(loaded.error().message);
    return *loaded;
}

Result<FramePlan> tryPlan(const SceneNeeds& needs, const Settings& settings = {},
                          Extent extent = {640, 360}) {
    return plan(pack().passes(), pack().presets("temporal_aa"), needs, settings, extent);
}

FramePlan planned(const SceneNeeds& needs, const Settings& settings = {}) {
    auto result = tryPlan(needs, settings);
    if (!result) throw std::runtime_error(result.error().message);
    return *result;
}

std::vector<std::string> passNames(const FramePlan& plan) {
    std::vector<std::string> names;
    for (const PlannedPass& pass : plan.passes)
        names.emplace_back(pass.variant.pass->name);
    return names;
}

const PlannedImage* imageOf(const FramePlan& plan, std::string_view name) {
    const auto found = std::ranges::find(plan.images, name, &PlannedImage::name);
    return found == plan.images.end() ? nullptr : &*found;
}

std::string reasonFor(const FramePlan& plan, std::string_view pass) {
    const auto found = std::ranges::find(plan.dropped, pass, &Dropped::pass);
    return found == plan.dropped.end() ? "" : found->reason;
}

std::string valueOf(const FramePlan& plan, std::string_view switchName) {
    return std::string(switchValue(plan.passes.back().variant, switchName));
}

using Names = std::vector<std::string>;

TEST(Plan, passesFollowFromTheNeeds) {
    struct Row {
        SceneNeeds needs;
        Names passes;
    };
    const Row rows[] = {
        {{}, {"camera_velocity", "object_velocity", "temporal_aa"}},
        {{.objectsMove = false}, {"temporal_aa"}},
        {{.objectsMove = false, .linearDepth = true}, {"camera_velocity", "temporal_aa"}},
        {{.cameraMoves = false}, {"object_velocity", "temporal_aa"}},
        {{.cameraMoves = false, .objectsMove = false}, {"temporal_aa"}},
        {{.engineWritesMotion = true}, {"temporal_aa"}},
        {{.skinnedMeshes = true}, {"camera_velocity", "object_velocity", "object_velocity", "temporal_aa"}},
        {{.antiAliasing = false}, {}},
    };
    for (const Row& row : rows) {
        for (const Stage stage : {Stage::fragment, Stage::compute}) {
            const FramePlan plan = planned(row.needs, {.stage = stage});
            EXPECT_EQ(passNames(plan), row.passes);
            for (const PlannedPass& pass : plan.passes)
                EXPECT_EQ(pass.stage, pass.variant.pass->fullscreen ? stage : Stage::fragment);
        }
    }
}

TEST(Plan, everyPassOfTheTableIsPlannedOrDroppedWithASentence) {
    for (int bits = 0; bits < 32; ++bits) {
        const SceneNeeds needs{.antiAliasing = (bits & 1) != 0,
                               .cameraMoves = (bits & 2) != 0,
                               .objectsMove = (bits & 4) != 0,
                               .skinnedMeshes = (bits & 8) != 0,
                               .engineWritesMotion = (bits & 16) != 0};
        const FramePlan plan = planned(needs);
        const Names names = passNames(plan);
        for (const PassInfo& pass : pack().passes()) {
            if (pass.outputs.empty()) continue;
            const bool kept = std::ranges::find(names, pass.name) != names.end();
            const std::string reason = reasonFor(plan, pass.name);
            EXPECT_NE(kept, !reason.empty()) << pass.name << " with needs " << bits;
            EXPECT_TRUE(kept || reason.ends_with('.'));
        }
    }
}

TEST(Plan, nothingMovingTakesMotionOutOfTheShader) {
    const FramePlan plan = planned({.cameraMoves = false, .objectsMove = false});
    EXPECT_EQ(valueOf(plan, "MOTION"), "off");
    EXPECT_EQ(valueOf(plan, "CLOSEST_FRAGMENT"), "off");
    EXPECT_EQ(imageOf(plan, "gOutVelocity"), nullptr);
    EXPECT_EQ(imageOf(plan, "gInDepth"), nullptr) << "depth is read for the closest fragment only";
    EXPECT_NE(reasonFor(plan, "temporal_aa: MOTION"), "");
}

// One pass, no image of motion: depth is read in any case.
TEST(Plan, theCamerasMotionAloneIsComputedWhereItIsUsed) {
    for (const Stage stage : {Stage::fragment, Stage::compute})
        for (const char* preset : {"inside", "best", "lean"}) {
            const FramePlan plan = planned({.objectsMove = false}, {.stage = stage, .preset = preset});
            EXPECT_EQ(passNames(plan), Names{"temporal_aa"});
            EXPECT_EQ(valueOf(plan, "MOTION"), "camera");
            EXPECT_EQ(valueOf(plan, "CLOSEST_FRAGMENT"), "on");
            EXPECT_EQ(imageOf(plan, "gOutVelocity"), nullptr);
            EXPECT_EQ(imageOf(plan, "gInVelocity"), nullptr);
            ASSERT_NE(imageOf(plan, "gInDepth"), nullptr);
            EXPECT_TRUE(imageOf(plan, "gInDepth")->external);
            EXPECT_EQ(plan.bytes, 2u * 640 * 360 * 8) << "two histories of RGBA16F";
            EXPECT_EQ(reasonFor(plan, "camera_velocity"),
                      "temporal_aa alone needs the camera's motion, and computes it from depth.");
        }
    const FramePlan own = planned({.objectsMove = false}, {.overrides = {{"CLOSEST_FRAGMENT", "off"}}});
    EXPECT_NE(imageOf(own, "gInDepth"), nullptr) << "of the pixel itself";
    EXPECT_EQ(own.passes.back().reads,
              (Names{"gInColour", "gInColourFiltered", "gInDepth", "gHistoryColour"}));
}

TEST(Plan, vectorsAreMadeWhereTheCamerasMotionDoesNotSuffice) {
    const SceneNeeds cameraAlone{.objectsMove = false};
    const auto motionOf = [](const SceneNeeds& needs, const Settings& settings = {}) {
        return valueOf(planned(needs, settings), "MOTION");
    };
    EXPECT_EQ(motionOf({}), "vectors") << "objects move";
    EXPECT_EQ(motionOf({.cameraMoves = false}), "vectors");
    EXPECT_EQ(motionOf({.objectsMove = false, .engineWritesMotion = true}), "vectors");
    EXPECT_EQ(motionOf({.objectsMove = false, .linearDepth = true}), "vectors");
    // Another pass reads the image, so that there is one.
    const SceneNeeds obscurance{.objectsMove = false, .ambientOcclusion = true};
    const CacheSettings wronski{.occlusion = "scalable_obscurance", .samples = 7};
    const FramePlan shared = planned(obscurance, {.cache = wronski});
    EXPECT_EQ(valueOf(shared, "MOTION"), "vectors");
    EXPECT_NE(imageOf(shared, "gOutVelocity"), nullptr);
    EXPECT_EQ(motionOf(obscurance, {.overrides = {{"scalable_obscurance.MOTION", "off"}}, .cache = wronski}),
              "camera");
    EXPECT_EQ(motionOf(obscurance), "camera") << "the framework's cache reprojects by itself";
    EXPECT_EQ(motionOf(obscurance, {.overrides = {{"lighting_cache.HISTORY", "motion"}}}), "vectors");
    EXPECT_EQ(motionOf(cameraAlone, {.overrides = {{"reprojection_cache.HISTORY", "motion"}}}), "camera")
        << "of a pass that is left out";
}

TEST(Plan, overridesOfMotionGivePlansThatAreRight) {
    for (const char* name : {"MOTION", "temporal_aa.MOTION"}) {
        const FramePlan vectors = planned({.objectsMove = false}, {.overrides = {{name, "vectors"}}});
        EXPECT_EQ(passNames(vectors), (Names{"camera_velocity", "temporal_aa"}));
        EXPECT_NE(imageOf(vectors, "gOutVelocity"), nullptr);
        for (const SceneNeeds& needs :
             {SceneNeeds{}, SceneNeeds{.engineWritesMotion = true}, SceneNeeds{.cameraMoves = false}}) {
            const FramePlan camera = planned(needs, {.overrides = {{name, "camera"}}});
            EXPECT_EQ(passNames(camera), Names{"temporal_aa"});
            EXPECT_EQ(valueOf(camera, "MOTION"), "camera");
            EXPECT_EQ(imageOf(camera, "gInVelocity"), nullptr);
            EXPECT_NE(imageOf(camera, "gInDepth"), nullptr);
        }
        const auto linear =
            tryPlan({.objectsMove = false, .linearDepth = true}, {.overrides = {{name, "camera"}}});
        ASSERT_FALSE(linear);
        EXPECT_EQ(linear.error().code, ErrorCode::invalidArgument);
        EXPECT_NE(linear.error().message.find("linearDepth"), std::string::npos) << linear.error().message;
        const FramePlan off = planned({.objectsMove = false}, {.overrides = {{name, "off"}}});
        EXPECT_EQ(passNames(off), Names{"temporal_aa"});
        EXPECT_EQ(imageOf(off, "gInDepth"), nullptr);
    }
}

TEST(Plan, needsChooseTheSwitches) {
    EXPECT_EQ(valueOf(planned({.hdr = true}, {.preset = "best"}), "HDR_WEIGHT"), "on");
    EXPECT_EQ(valueOf(planned({.hdr = false}, {.preset = "best"}), "HDR_WEIGHT"), "off");
    EXPECT_EQ(valueOf(planned({.fastMotion = false}, {.preset = "inside"}), "MOTION_BLUR_FALLBACK"), "off");
    EXPECT_EQ(valueOf(planned({.fastMotion = true}, {.preset = "best"}), "MOTION_BLUR_FALLBACK"), "on");
    EXPECT_EQ(valueOf(planned({.reversedDepth = true}), "DEPTH_REVERSED"), "on");
    EXPECT_EQ(valueOf(planned({.reversedDepth = true, .linearDepth = true}), "DEPTH_REVERSED"), "off");
    const FramePlan plan = planned({.orthographic = true, .linearDepth = true});
    EXPECT_EQ(switchValue(plan.passes.front().variant, "ORTHOGRAPHIC"), "on");
    EXPECT_EQ(switchValue(plan.passes.front().variant, "DEPTH_LINEAR"), "on");
}

TEST(Plan, quadsShareReadsInComputeWhereTheDeviceLetsThem) {
    const std::vector<Condition> shared{{"QUAD_SHARING", "on"}};
    const auto plannedFor = [&](Stage stage, bool quads) {
        return planned({}, {.stage = stage, .overrides = shared, .quadOperations = quads});
    };
    EXPECT_EQ(valueOf(plannedFor(Stage::fragment, false), "QUAD_SHARING"), "on") << "by derivatives";
    EXPECT_EQ(valueOf(plannedFor(Stage::compute, true), "QUAD_SHARING"), "on");
    EXPECT_EQ(valueOf(plannedFor(Stage::compute, false), "QUAD_SHARING"), "off");
    EXPECT_NE(reasonFor(plannedFor(Stage::compute, false), "temporal_aa: QUAD_SHARING"), "");
}

TEST(Plan, overridesComeAfterPresetAndNeeds) {
    const Settings settings{.overrides = {{"NEIGHBOURHOOD", "square"}, {"MOTION_BLUR_FALLBACK", "on"}}};
    const FramePlan plan = planned({}, settings);
    EXPECT_EQ(valueOf(plan, "NEIGHBOURHOOD"), "square");
    ASSERT_NE(imageOf(plan, "gOutColour"), nullptr);
    EXPECT_FALSE(imageOf(plan, "gOutColour")->history);
}

TEST(Plan, motionThatNobodyWritesIsCleared) {
    const FramePlan still = planned({.cameraMoves = false});
    ASSERT_NE(imageOf(still, "gOutVelocity"), nullptr);
    EXPECT_TRUE(imageOf(still, "gOutVelocity")->cleared) << "objects are drawn over zero";
    EXPECT_FALSE(imageOf(planned({}), "gOutVelocity")->cleared) << "the camera's motion covers it";
    const FramePlan forced =
        planned({.cameraMoves = false, .objectsMove = false}, {.overrides = {{"MOTION", "vectors"}}});
    ASSERT_NE(imageOf(forced, "gOutVelocity"), nullptr);
    EXPECT_TRUE(imageOf(forced, "gOutVelocity")->cleared);
}

TEST(Plan, theEnginesImagesCostNothing) {
    const FramePlan plan = planned({.engineWritesMotion = true});
    for (const auto* name : {"gInColour", "gInDepth", "gInVelocity"}) {
        ASSERT_NE(imageOf(plan, name), nullptr) << name;
        EXPECT_TRUE(imageOf(plan, name)->external) << name;
    }
    EXPECT_EQ(plan.bytes, 2u * 640 * 360 * 8) << "two histories of RGBA16F";
}

TEST(Plan, bytesAreThoseOfHistoryAndTransients) {
    const FramePlan plan = planned({.fastMotion = true});
    EXPECT_TRUE(imageOf(plan, "gOutHistory")->history);
    EXPECT_EQ(plan.bytesWithoutAliasing, 640u * 360 * (2 * 8 + 8 + 4))
        << "history, shown colour, RG16F motion";
    EXPECT_EQ(plan.bytes, plan.bytesWithoutAliasing) << "both transients live in the last pass";
    EXPECT_EQ(planned({}, {.colourFormat = "rgba32f"}).bytes, 640u * 360 * (2 * 16 + 4));
}

TEST(Plan, theSameNeedsGiveTheSamePlan) {
    const FramePlan a = planned({.skinnedMeshes = true, .fastMotion = true});
    const FramePlan b = planned({.skinnedMeshes = true, .fastMotion = true});
    EXPECT_EQ(passNames(a), passNames(b));
    ASSERT_EQ(a.images.size(), b.images.size());
    for (size_t i = 0; i < a.images.size(); ++i) {
        EXPECT_EQ(a.images[i].name, b.images[i].name);
        EXPECT_EQ(a.images[i].memory, b.images[i].memory);
    }
}

TEST(Plan, mistakesAreSentences) {
    const auto message = [](const Result<FramePlan>& result) { return result ? "" : result.error().message; };
    EXPECT_EQ(tryPlan({}, {}, {0, 360}).error().code, ErrorCode::zeroExtent);
    EXPECT_NE(message(tryPlan({}, {.preset = "nicest"})).find("choose one of: inside, best, lean"),
              std::string::npos)
        << message(tryPlan({}, {.preset = "nicest"}));
    EXPECT_NE(message(tryPlan({}, {.overrides = {{"SPEED", "on"}}})).find("SPEED"), std::string::npos);
    EXPECT_NE(message(tryPlan({}, {.overrides = {{"CONSTRAINT", "tight"}}})).find("tight"),
              std::string::npos);
    EXPECT_EQ(tryPlan({}, {.stage = Stage::vertex}).error().code, ErrorCode::invalidArgument);
    EXPECT_NE(message(tryPlan({}, {.colourFormat = "rgb5"})).find("rgb5"), std::string::npos);
}

// --- The framework

SceneNeeds lighting(SceneNeeds needs = {}) {
    needs.antiAliasing = false;
    needs.ambientOcclusion = true;
    return needs;
}

const PlannedPass* passOf(const FramePlan& plan, std::string_view name) {
    const auto found = std::ranges::find_if(
        plan.passes, [&](const PlannedPass& pass) { return pass.variant.pass->name == name; });
    return found == plan.passes.end() ? nullptr : &*found;
}

std::string switchOf(const FramePlan& plan, std::string_view pass, std::string_view name) {
    const PlannedPass* found = passOf(plan, pass);
    return found ? std::string(switchValue(found->variant, name)) : "no such pass";
}

TEST(Plan, theFrameworksStepsFollowFromNeedsAndSettings) {
    struct Row {
        SceneNeeds needs;
        CacheSettings cache;
        Names passes;
    };
    const Names first{"depth_downsample", "ambient_occlusion"};
    const auto after = [&](Names names, Names more) {
        names.insert(names.end(), more.begin(), more.end());
        return names;
    };
    const Names cached{"reprojection_cache"}, filtered{"bilateral_filter", "bilateral_filter"};
    const Names all = after(after(after(first, cached), filtered), {"bilateral_upsample"});
    const Row rows[] = {
        {lighting({.objectsMove = false}), {}, all},
        {lighting({.cameraMoves = false, .objectsMove = false}), {}, all},
        {lighting(), {}, after({"camera_velocity", "object_velocity"}, all)},
        {lighting({.engineWritesMotion = true}), {}, all},
        {lighting({.objectsMove = false}),
         {.filter = false},
         after(first, {"reprojection_cache", "bilateral_upsample"})},
        {lighting(), {.history = false}, all},
        {lighting(), {.history = false, .filter = false}, after(first, {"bilateral_upsample"})},
        {{.antiAliasing = false, .objectsMove = false, .cachedChannels = 1},
         {},
         {"depth_downsample", "reprojection_cache", "bilateral_filter", "bilateral_filter",
          "bilateral_upsample"}},
        {{.objectsMove = false, .ambientOcclusion = true}, {}, after(all, {"temporal_aa"})},
    };
    for (const Row& row : rows)
        for (const Stage stage : {Stage::fragment, Stage::compute}) {
            CacheSettings cache = row.cache;
            cache.merges = stage == Stage::fragment; // where it has no say
            const FramePlan plan = planned(row.needs, {.stage = stage, .cache = cache});
            EXPECT_EQ(passNames(plan), row.passes);
            for (const PassInfo& pass : pack().passes())
                if (!pass.outputs.empty() && passOf(plan, pass.name) == nullptr) {
                    EXPECT_TRUE(reasonFor(plan, pass.name).ends_with('.')) << pass.name;
                }
        }
}

// What computes a visibility and what accumulates it are one pass in compute, unless there is nothing to
// accumulate, or what is cached is the engine's.
TEST(Plan, computeMergesWhatIsCachedWithItsCache) {
    struct Row {
        SceneNeeds needs;
        std::string_view fresh, values;
    };
    const Row rows[] = {
        {lighting({.objectsMove = false}), "occlusion", "one"},
        {{.antiAliasing = false, .objectsMove = false, .sunShadows = true}, "shadow", "one"},
        {lighting({.objectsMove = false, .sunShadows = true}), "both", "two"},
    };
    for (const Row& row : rows) {
        const FramePlan plan = planned(row.needs, {.cache = {.samples = 8, .packing = "two"}});
        EXPECT_EQ(passNames(plan), (Names{"depth_downsample", "lighting_cache", "bilateral_filter",
                                          "bilateral_filter", "bilateral_upsample"}));
        EXPECT_EQ(switchOf(plan, "lighting_cache", "FRESH"), row.fresh);
        EXPECT_EQ(switchOf(plan, "lighting_cache", "VALUES"), row.values);
        EXPECT_EQ(switchOf(plan, "lighting_cache", "SAMPLES"), "8");
        EXPECT_EQ(switchOf(plan, "lighting_cache", "CHANGE_DETECTION"), "on");
        EXPECT_EQ(reasonFor(plan, "reprojection_cache"), "lighting_cache does it.");
        EXPECT_EQ(reasonFor(plan, "ambient_occlusion") == "lighting_cache does it.", row.fresh != "shadow");
        EXPECT_EQ(reasonFor(plan, "sun_shadow") == "lighting_cache does it.", row.fresh != "occlusion");
        // 16 bits of depth are for the points that occlusion checks.
        const bool halves = row.fresh != "shadow";
        for (const char* pass : {"depth_downsample", "lighting_cache"})
            EXPECT_EQ(switchOf(plan, pass, "HALF_DEPTH"), halves ? "on" : "off") << row.fresh;
        EXPECT_EQ(imageOf(plan, "gOutHalfDepth") != nullptr, halves);
    }
    for (const uint32_t samples : {1u, 2u, 4u}) {
        const FramePlan plan = planned(rows[0].needs, {.cache = {.samples = samples}});
        for (const char* pass : {"depth_downsample", "lighting_cache"})
            EXPECT_EQ(switchOf(plan, pass, "HALF_DEPTH"), samples < 4 ? "off" : "on") << samples;
    }
    const SceneNeeds occlusion = lighting({.objectsMove = false});
    const SceneNeeds value{.antiAliasing = false, .objectsMove = false, .cachedChannels = 1};
    // Why it is left out; empty where it is not.
    const auto apart = [](const SceneNeeds& needs, const Settings& settings) -> std::string {
        const FramePlan plan = planned(needs, settings);
        const PlannedPass* depth = passOf(plan, "depth_downsample");
        if (passOf(plan, "lighting_cache") != nullptr) return {};
        EXPECT_TRUE(depth == nullptr || switchValue(depth->variant, "HALF_DEPTH") == "off");
        return reasonFor(plan, "lighting_cache");
    };
    EXPECT_EQ(apart(occlusion, {}), "");
    EXPECT_EQ(apart(occlusion, {.cache = {.ratio = 1}}), "");
    EXPECT_EQ(apart(occlusion, {.cache = {.history = false}}), "") << "the filter's layout";
    EXPECT_EQ(apart(occlusion, {.cache = {.filter = false}}), "");
    EXPECT_EQ(apart(occlusion, {.stage = Stage::fragment}),
              "In fragment shaders occlusion, shadow and cache are passes of their own.");
    EXPECT_EQ(apart(occlusion, {.cache = {.merges = false}}), "CacheSettings::merges is off.");
    EXPECT_EQ(apart(occlusion, {.cache = {.history = false, .filter = false}}),
              "CacheSettings::history and filter are off: what is computed is upsampled.");
    EXPECT_EQ(apart(occlusion, {.cache = {.occlusion = "scalable_obscurance", .samples = 7}}),
              "scalable_obscurance accumulates by itself.");
    EXPECT_EQ(apart(value, {}), "Neither occlusion nor shadows are asked for.");
    // The engine's normals are for occlusion: shadows alone ask for none.
    EXPECT_EQ(
        imageOf(planned({.antiAliasing = false, .objectsMove = false, .sunShadows = true, .normals = true},
                        {.cache = {.ratio = 1}}),
                "gInNormal"),
        nullptr);
}

// One value has its depth beside it, more have the frame's; each image has the format of that.
TEST(Plan, channelsOfTheEnginesChooseValuesAndFormats) {
    struct Row {
        uint32_t channels;
        std::string_view values, cache, state, upsampled;
    };
    const Row rows[] = {{1, "one", "rg16f", "r16f", "r16f"},
                        {2, "two", "rg16f", "rg16f", "rg16f"},
                        {3, "four", "rgba16f", "rg16f", "rgba16f"},
                        {4, "four", "rgba16f", "rg16f", "rgba16f"}};
    for (const Row& row : rows)
        for (const Stage stage : {Stage::fragment, Stage::compute})
            for (const bool filtersHistory : {false, true}) {
                const FramePlan plan =
                    planned({.antiAliasing = false, .objectsMove = false, .cachedChannels = row.channels},
                            {.stage = stage, .cache = {.filtersHistory = filtersHistory}});
                for (const char* pass : {"reprojection_cache", "bilateral_filter", "bilateral_upsample"})
                    EXPECT_EQ(switchOf(plan, pass, "VALUES"), row.values) << pass << row.channels;
                for (const char* image : {"gInFresh", "gOutCache", "gOutFilteredAcross", "gOutFiltered"})
                    EXPECT_EQ(imageOf(plan, image)->format, row.cache) << image << row.channels;
                EXPECT_EQ(imageOf(plan, "gOutCacheState")->format, row.state);
                EXPECT_EQ(imageOf(plan, "gOutUpsampled")->format, row.upsampled);
                EXPECT_TRUE(imageOf(plan, "gInFresh")->external);
                EXPECT_TRUE(imageOf(plan, "gOutCacheState")->history);
            }
}

TEST(Plan, formatsFollowTheirSwitch) {
    auto variant = makeVariant(pack().passes(), "reprojection_cache");
    ASSERT_TRUE(variant);
    const auto formats = [&](std::string_view values) {
        EXPECT_TRUE(setSwitch(*variant, "VALUES", values));
        Names found;
        for (const ImageInfo& output : variant->pass->outputs)
            found.emplace_back(formatOf(*variant, output));
        return found;
    };
    EXPECT_EQ(formats("one"), (Names{"rg16f", "r16f"}));
    EXPECT_EQ(formats("two"), (Names{"rg16f", "rg16f"}));
    EXPECT_EQ(formats("four"), (Names{"rgba16f", "rg16f"}));
    EXPECT_EQ(formats("shadow_in_integer"), (Names{"rg16f", "r16f"}));
    for (const ImageInfo& input : variant->pass->inputs)
        if (input.formatBy.empty()) {
            EXPECT_EQ(formatOf(*variant, input), input.format) << input.name;
        }
}

// Taps that do not lie a texel apart cannot be gathered.
TEST(Plan, stepsOfTheFilterChooseItsForm) {
    for (const auto& [step, form] :
         {std::pair{1.0f, "one"}, std::pair{2.0f, "any"}, std::pair{0.5f, "any"}}) {
        const FramePlan plan = planned(lighting(), {.cache = {.filterStep = step}});
        EXPECT_EQ(switchOf(plan, "bilateral_filter", "STEP"), form) << step;
        EXPECT_EQ(plan.cache.filterStep, step);
        const FramePlan fragment =
            planned(lighting(), {.stage = Stage::fragment, .cache = {.filterStep = step}});
        EXPECT_EQ(switchOf(fragment, "bilateral_filter", "STEP"), "one") << "one form for any step";
    }
}

TEST(Plan, historyIsFoundAsTheSceneAllows) {
    for (const bool merges : {false, true}) {
        const std::string cache = merges ? "lighting_cache" : "reprojection_cache";
        const auto found = [&](const SceneNeeds& needs, bool history = true) {
            return switchOf(planned(lighting(needs), {.cache = {.history = history, .merges = merges}}),
                            cache, "HISTORY");
        };
        EXPECT_EQ(found({}), "motion");
        EXPECT_EQ(found({.objectsMove = false}), "camera");
        EXPECT_EQ(found({.cameraMoves = false}), "motion");
        EXPECT_EQ(found({.cameraMoves = false, .objectsMove = false}), "still");
        EXPECT_EQ(found({}, false), "none");
        const FramePlan camera = planned(lighting({.objectsMove = false}), {.cache = {.merges = merges}});
        EXPECT_EQ(imageOf(camera, "gOutVelocity"), nullptr);
        EXPECT_NE(reasonFor(camera, cache + ": HISTORY"), "");
    }
}

// Image that a pass reads as this input.
std::string source(const FramePlan& plan, size_t pass, std::string_view input) {
    const PlannedPass& planned = plan.passes[pass];
    for (size_t i = 0; i < planned.reads.size(); ++i)
        if (planned.reads[i] == input) return plan.images[static_cast<size_t>(planned.readImages[i])].name;
    return "nothing";
}

TEST(Plan, eachStepReadsWhatTheOneBeforeWrote) {
    const SceneNeeds needs = lighting({.objectsMove = false});
    for (const bool filtersHistory : {false, true}) {
        const FramePlan plan = planned(needs, {.cache = {.merges = false, .filtersHistory = filtersHistory}});
        EXPECT_EQ(source(plan, 1, "gInCoarseDepth"), "gOutCoarseDepth");
        EXPECT_EQ(source(plan, 2, "gInFresh"), "gOutOcclusion");
        EXPECT_EQ(source(plan, 2, "gHistoryCache"), filtersHistory ? "gOutFiltered" : "gOutCache");
        EXPECT_EQ(source(plan, 2, "gHistoryCacheState"), "gOutCacheState");
        EXPECT_EQ(source(plan, 3, "gInCache"), "gOutCache");
        EXPECT_EQ(source(plan, 4, "gInCache"), "gOutFilteredAcross");
        EXPECT_EQ(source(plan, 4, "gInCacheFiltered"), "gOutFilteredAcross");
        for (const size_t filter : {3, 4})
            EXPECT_EQ(source(plan, filter, "gInCacheState"), "gOutCacheState");
        const FramePlan merged = planned(needs, {.cache = {.filtersHistory = filtersHistory}});
        EXPECT_EQ(source(merged, 1, "gInHalfDepth"), "gOutHalfDepth");
        EXPECT_EQ(source(merged, 1, "gHistoryCache"), filtersHistory ? "gOutFiltered" : "gOutCache");
        EXPECT_EQ(source(merged, 2, "gInCache"), "gOutCache");
        EXPECT_EQ(source(plan, 5, "gInFiltered"), "gOutFiltered");
        EXPECT_EQ(imageOf(plan, "gOutCache")->history, !filtersHistory);
        EXPECT_EQ(imageOf(plan, "gOutFiltered")->history, filtersHistory);
        EXPECT_TRUE(imageOf(plan, "gOutCacheState")->history);
    }
    const FramePlan unfiltered =
        planned(needs, {.cache = {.filter = false, .merges = false, .filtersHistory = true}});
    EXPECT_EQ(source(unfiltered, 3, "gInFiltered"), "gOutCache");
    EXPECT_TRUE(imageOf(unfiltered, "gOutCache")->history);
    const FramePlan fresh = planned(needs, {.cache = {.history = false, .filter = false}});
    EXPECT_EQ(source(fresh, 2, "gInFiltered"), "gOutOcclusion");
    for (const PlannedImage& image : fresh.images)
        EXPECT_FALSE(image.history) << image.name;
    EXPECT_EQ(source(planned({.antiAliasing = false, .cachedChannels = 1}), 3, "gInFresh"), "gInFresh");
}

// Both share one cache: packed, and at the ratio that upsampling unpacks, or as two values.
TEST(Plan, occlusionAndShadowsShareACache) {
    const Settings apart{.cache = {.merges = false}};
    const FramePlan plan = planned(lighting({.objectsMove = false, .sunShadows = true}), apart);
    EXPECT_EQ(passNames(plan),
              (Names{"depth_downsample", "ambient_occlusion", "sun_shadow", "reprojection_cache",
                     "bilateral_filter", "bilateral_filter", "bilateral_upsample"}));
    for (const char* pass : {"sun_shadow", "reprojection_cache", "bilateral_filter", "bilateral_upsample"})
        EXPECT_EQ(switchOf(plan, pass, "VALUES"), "shadow_in_integer") << pass;
    const FramePlan two = planned(lighting({.objectsMove = false, .sunShadows = true}),
                                  {.cache = {.merges = false, .packing = "two"}});
    for (const char* pass : {"sun_shadow", "reprojection_cache", "bilateral_filter", "bilateral_upsample"})
        EXPECT_EQ(switchOf(two, pass, "VALUES"), "two") << pass;
    EXPECT_EQ(imageOf(two, "gOutCacheState")->format, "rg16f");
    EXPECT_EQ(source(two, 3, "gInCoarseDepth"), "gOutCoarseDepth") << "no depth beside the values";
    // With frames there is no state, and depth has a history of its own.
    for (const bool merges : {false, true}) {
        const FramePlan framed =
            planned(lighting({.objectsMove = false, .sunShadows = true}),
                    {.cache = {.filter = false, .merges = merges, .packing = "with_frames"}});
        const int cache = merges ? 1 : 3;
        EXPECT_EQ(switchOf(framed, merges ? "lighting_cache" : "reprojection_cache", "VALUES"),
                  "with_frames");
        EXPECT_EQ(switchOf(framed, "bilateral_upsample", "VALUES"), "with_frames");
        if (!merges) {
            EXPECT_EQ(switchOf(framed, "sun_shadow", "VALUES"), "two") << "what is fresh has no frames";
        }
        EXPECT_EQ(source(framed, cache, "gHistoryCache"), "gOutCache");
        EXPECT_EQ(source(framed, cache, "gHistoryCoarseDepth"), "gOutCoarseDepth");
        EXPECT_EQ(imageOf(framed, "gOutCache")->format, "r32f");
        EXPECT_TRUE(imageOf(framed, "gOutCoarseDepth")->history);
        EXPECT_EQ(imageOf(framed, "gOutCacheState"), nullptr);
        EXPECT_EQ(imageOf(framed, "gOutUpsampled")->format, "rg8");
    }
    const FramePlan shadows =
        planned({.antiAliasing = false, .objectsMove = false, .sunShadows = true, .reversedShadows = true},
                {.cache = {.cascades = 2, .merges = false}});
    EXPECT_EQ(switchOf(shadows, "sun_shadow", "VALUES"), "one");
    EXPECT_EQ(switchOf(shadows, "sun_shadow", "CASCADES"), "2");
    EXPECT_EQ(switchOf(shadows, "sun_shadow", "SHADOW_REVERSED"), "on");
    EXPECT_EQ(passOf(shadows, "ambient_occlusion"), nullptr);
    EXPECT_TRUE(imageOf(shadows, "gInShadowMap")->external);
    EXPECT_EQ(imageOf(shadows, "gInShadowMap")->extent.width, 0u) << "an extent of its own";
}

TEST(Plan, scalableObscuranceIsAPlanOfItsOwn) {
    const CacheSettings cache{.occlusion = "scalable_obscurance", .samples = 7};
    const FramePlan plan = planned(lighting({.objectsMove = false}), {.cache = cache});
    EXPECT_EQ(passNames(plan), (Names{"camera_velocity", "depth_hierarchy", "scalable_obscurance",
                                      "obscurance_filter", "obscurance_filter"}));
    EXPECT_EQ(imageOf(plan, "gOutDepthHierarchy")->extent.width, 960u);
    EXPECT_TRUE(imageOf(plan, "gOutObscurance")->history);
    const FramePlan alone = planned(
        lighting({.cameraMoves = false, .objectsMove = false}),
        {.cache = {.occlusion = "scalable_obscurance", .samples = 7, .history = false, .filter = false}});
    EXPECT_EQ(passNames(alone), (Names{"depth_hierarchy", "scalable_obscurance"}));
    EXPECT_EQ(switchOf(alone, "scalable_obscurance", "TEMPORAL"), "off");
    EXPECT_FALSE(tryPlan(lighting({.sunShadows = true}), {.cache = cache}));
    EXPECT_FALSE(tryPlan(lighting(), {.cache = {.occlusion = "sun_shadow"}}));
}

// The engine's normals at the frame's extent, in the two passes that take them, or nowhere.
TEST(Plan, normalsAreReadWhereTheEngineHasThem) {
    const FramePlan with =
        planned(lighting({.objectsMove = false, .normals = true}), {.cache = {.ratio = 4}});
    EXPECT_EQ(switchOf(with, "lighting_cache", "NORMALS"), "read");
    EXPECT_EQ(switchOf(with, "bilateral_upsample", "NORMAL_WEIGHTS"), "on");
    ASSERT_NE(imageOf(with, "gInNormal"), nullptr);
    EXPECT_TRUE(imageOf(with, "gInNormal")->external);
    EXPECT_EQ(imageOf(with, "gInNormal")->extent.width, 640u);
    const FramePlan without = planned(lighting({.objectsMove = false}));
    EXPECT_EQ(switchOf(without, "lighting_cache", "NORMALS"), "reconstructed");
    EXPECT_EQ(switchOf(without, "bilateral_upsample", "NORMAL_WEIGHTS"), "off");
    EXPECT_EQ(imageOf(without, "gInNormal"), nullptr);
    EXPECT_EQ(imageOf(planned({.normals = true}), "gInNormal"), nullptr) << "anti-aliasing asks for none";
}

TEST(Plan, lightIsCombinedAfterTheFrameworkAndBeforeAntiAliasing) {
    const SceneNeeds needs{.objectsMove = false,
                           .ambientOcclusion = true,
                           .sunShadows = true,
                           .combinesLighting = true,
                           .otherLight = true};
    const FramePlan plan = planned(needs);
    EXPECT_EQ(passNames(plan),
              (Names{"depth_downsample", "lighting_cache", "bilateral_filter", "bilateral_filter",
                     "bilateral_upsample", "combine_lighting", "temporal_aa"}));
    EXPECT_EQ(source(plan, 5, "gInLighting"), "gOutUpsampled");
    EXPECT_EQ(source(plan, 6, "gInColour"), "gOutLit");
    EXPECT_EQ(imageOf(plan, "gInColour"), nullptr) << "the engine hands over no colour";
    EXPECT_EQ(switchOf(plan, "combine_lighting", "LIGHTING"), "both");
    for (const char* light : {"gInAmbientLight", "gInSunLight", "gInOtherLight"}) {
        ASSERT_NE(imageOf(plan, light), nullptr) << light;
        EXPECT_TRUE(imageOf(plan, light)->external) << light;
    }
    const FramePlan without = planned({.ambientOcclusion = true});
    EXPECT_NE(reasonFor(without, "combine_lighting"), "");
    EXPECT_TRUE(imageOf(without, "gInColour")->external);
}

// One visibility takes away from one light, and the others are not asked for.
TEST(Plan, whatIsNotCachedAsksForNoLight) {
    const auto combined = [](SceneNeeds needs) {
        needs.antiAliasing = false;
        needs.objectsMove = false;
        needs.combinesLighting = true;
        return planned(needs);
    };
    for (const SceneNeeds needs : {SceneNeeds{.ambientOcclusion = true}, SceneNeeds{.cachedChannels = 1}}) {
        const FramePlan plan = combined(needs);
        EXPECT_EQ(passNames(plan).back(), "combine_lighting");
        EXPECT_EQ(switchOf(plan, "combine_lighting", "LIGHTING"), "occlusion");
        EXPECT_NE(imageOf(plan, "gInAmbientLight"), nullptr);
        EXPECT_EQ(imageOf(plan, "gInSunLight"), nullptr);
        EXPECT_EQ(imageOf(plan, "gInOtherLight"), nullptr);
        EXPECT_EQ(switchOf(plan, "combine_lighting", "OTHER_LIGHT"), "off");
    }
    const FramePlan sun = combined({.sunShadows = true});
    EXPECT_EQ(switchOf(sun, "combine_lighting", "LIGHTING"), "shadow");
    EXPECT_EQ(imageOf(sun, "gInAmbientLight"), nullptr);
    EXPECT_NE(imageOf(sun, "gInSunLight"), nullptr);
}

// Whichever step is the last, its image is what light is combined with.
TEST(Plan, lightIsCombinedWithTheLastStepThatThereIs) {
    const auto combinedWith = [](const CacheSettings& cache, SceneNeeds needs = lighting()) {
        needs.objectsMove = false;
        needs.combinesLighting = true;
        const FramePlan plan = planned(needs, {.cache = cache});
        return source(plan, plan.passes.size() - 1, "gInLighting");
    };
    EXPECT_EQ(combinedWith({.filter = false}), "gOutUpsampled");
    EXPECT_EQ(combinedWith({.ratio = 1}), "gOutFiltered");
    EXPECT_EQ(combinedWith({.ratio = 1, .filter = false}), "gOutCache");
    EXPECT_EQ(combinedWith({.ratio = 1, .history = false, .filter = false}), "gOutOcclusion");
    const SceneNeeds value{.antiAliasing = false, .cachedChannels = 1};
    EXPECT_EQ(combinedWith({.ratio = 1, .history = false, .filter = false}, value), "gInFresh");
    EXPECT_EQ(combinedWith({.occlusion = "scalable_obscurance", .samples = 7}), "gOutFilteredObscurance");
    EXPECT_EQ(combinedWith({.occlusion = "scalable_obscurance", .samples = 7, .filter = false}),
              "gOutObscurance");
}

// At a ratio of 1 the last step's image is the lighting.
TEST(Plan, fullResolutionIsNotUpsampled) {
    const FramePlan plan =
        planned(lighting({.objectsMove = false}), {.cache = {.ratio = 1, .history = false, .filter = false}});
    EXPECT_EQ(passNames(plan), (Names{"depth_downsample", "ambient_occlusion"}));
    EXPECT_EQ(imageOf(plan, "gOutOcclusion")->extent.width, 640u);
    const FramePlan filtered = planned(lighting({.objectsMove = false}), {.cache = {.ratio = 1}});
    EXPECT_EQ(passNames(filtered).back(), "bilateral_filter");
    EXPECT_NE(reasonFor(filtered, "bilateral_upsample"), "");
}

// Odd sizes round up, and every coarse image follows the ratio, of passes too that do not know it.
TEST(Plan, coarseImagesFollowTheRatio) {
    for (const uint32_t ratio : {2u, 4u}) {
        const auto apart = tryPlan(lighting(), {.cache = {.ratio = ratio, .merges = false}}, {641, 359});
        const auto plan = tryPlan(lighting(), {.cache = {.ratio = ratio}}, {641, 359});
        ASSERT_TRUE(plan) << plan.error().message;
        ASSERT_TRUE(apart) << apart.error().message;
        for (const char* name : {"gOutCoarseDepth", "gOutHalfDepth", "gOutOcclusion", "gOutCache",
                                 "gOutCacheState", "gOutFilteredAcross", "gOutFiltered"}) {
            const PlannedImage* image = imageOf(*plan, name) ? imageOf(*plan, name) : imageOf(*apart, name);
            ASSERT_NE(image, nullptr) << name;
            EXPECT_EQ(image->extent.width, (641 + ratio - 1) / ratio) << name;
            EXPECT_EQ(image->extent.height, (359 + ratio - 1) / ratio) << name;
        }
        EXPECT_EQ(imageOf(*plan, "gOutUpsampled")->extent.width, 641u);
        EXPECT_EQ(switchOf(*plan, "depth_downsample", "RATIO"), std::to_string(ratio));
        EXPECT_EQ(switchOf(*plan, "bilateral_upsample", "RATIO"), std::to_string(ratio));
    }
}

// What a scene does not need costs it no memory.
TEST(Plan, leavingStepsOutSavesMemory) {
    const auto bytes = [](const CacheSettings& cache, const SceneNeeds& needs = {.objectsMove = false}) {
        return planned(lighting(needs), {.cache = cache}).bytes;
    };
    EXPECT_LT(bytes({.filter = false}), bytes({}));
    EXPECT_LT(bytes({.history = false}), bytes({}));
    EXPECT_LT(bytes({.history = false, .filter = false}), bytes({.history = false}));
    EXPECT_LT(bytes({.ratio = 4}), bytes({}));
    EXPECT_LT(bytes({}), bytes({}, {})) << "motion vectors";
}

TEST(Plan, overridesNameThePassTheyAreOf) {
    const auto plan = planned(
        lighting(), {.overrides = {{"bilateral_filter.TAPS", "point"}, {"lighting_cache.SAMPLES", "16"}}});
    EXPECT_EQ(switchOf(plan, "bilateral_filter", "TAPS"), "point");
    EXPECT_EQ(switchOf(plan, "lighting_cache", "SAMPLES"), "16");
    EXPECT_FALSE(tryPlan(lighting(), {.overrides = {{"bilateral_filter.TAPES", "point"}}}));
    EXPECT_FALSE(tryPlan(lighting(), {.overrides = {{"bilateral_fitler.TAPS", "point"}}}));
}

TEST(Plan, mistakesOfTheCacheAreSentences) {
    const auto says = [](const Result<FramePlan>& result, std::string_view text) {
        return !result && result.error().code == ErrorCode::invalidArgument &&
               result.error().message.find(text) != std::string::npos;
    };
    EXPECT_TRUE(says(tryPlan(lighting(), {.cache = {.ratio = 3}}), "ratio is 1, 2 or 4"));
    EXPECT_TRUE(
        says(tryPlan(lighting({.sunShadows = true}), {.cache = {.ratio = 1}}), "a recorder for each"));
    EXPECT_TRUE(says(tryPlan(lighting({.sunShadows = true}), {.cache = {.cascades = 5}}), "CASCADES"));
    EXPECT_TRUE(says(tryPlan(lighting(), {.cache = {.samples = 5}}), "SAMPLES"));
    // A value of the switch VALUES, but not for two values.
    EXPECT_TRUE(says(tryPlan(lighting({.sunShadows = true}), {.cache = {.packing = "one"}}), "packing is"));
    EXPECT_TRUE(says(tryPlan(lighting({.sunShadows = true}), {.cache = {.packing = "with_frames"}}),
                     "takes history and no filter"));
    EXPECT_TRUE(says(tryPlan(lighting({.sunShadows = true}),
                             {.cache = {.history = false, .filter = false, .packing = "with_frames"}}),
                     "takes history and no filter"));
    EXPECT_TRUE(says(tryPlan(lighting({.cachedChannels = 1})), "a recorder for each"));
    EXPECT_TRUE(says(tryPlan({.cachedChannels = 5}), "SceneNeeds::cachedChannels is 0 to 4, not 5."));
    EXPECT_TRUE(says(tryPlan({.combinesLighting = true}), "combinesLighting"));
}

PlannedImage transient(std::string name, int first, int last, uint64_t bytes) {
    PlannedImage image;
    image.name = std::move(name);
    image.firstPass = first;
    image.lastPass = last;
    image.bytes = bytes;
    return image;
}

// a 0..1, b 1..2, c 2..3, d 3..3: a and c never meet, nor b and d, nor a and d.
TEST(Plan, imagesWhoseLivesDoNotMeetShareMemory) {
    FramePlan plan;
    plan.images = {transient("a", 0, 1, 100), transient("b", 1, 2, 80), transient("c", 2, 3, 60),
                   transient("d", 3, 3, 40)};
    shareMemory(plan);
    for (size_t i = 0; i < plan.images.size(); ++i)
        for (size_t j = i + 1; j < plan.images.size(); ++j) {
            const PlannedImage &x = plan.images[i], &y = plan.images[j];
            const bool meet = x.firstPass <= y.lastPass && y.firstPass <= x.lastPass;
            EXPECT_FALSE(meet && x.memory == y.memory) << x.name << y.name;
        }
    EXPECT_EQ(plan.bytesWithoutAliasing, 280u);
    EXPECT_EQ(plan.bytes, 180u) << "a with c in 100, b with d in 80";
}

} // namespace
