// SPDX-License-Identifier: Apache-2.0
// Every pass of the table has a check that executes it, in every stage that it has. A pass without one does
// not compile; a check that compares nothing does not pass.
#include "ambient_occlusion_case.hpp"
#include "bilateral_upsample_case.hpp"
#include "camera_case.hpp"
#include "combine_lighting_case.hpp"
#include "depth_downsample_case.hpp"
#include "depth_hierarchy_case.hpp"
#include "fullscreen_case.hpp"
#include "lighting_cache_case.hpp"
#include "object_case.hpp"
#include "reprojection_cache_case.hpp"
#include "scalable_obscurance_case.hpp"
#include "sun_shadow_case.hpp"
#include "temporal_aa_case.hpp"

#include <algorithm>

namespace passes {
namespace {

Comparison checkFullscreen(Stage) {
    return comparePositions(33, 17);
}

Comparison checkCameraVelocity(Stage stage) {
    Pass pass(variantOf(pack(), "camera_velocity"), stage);
    const CameraCase frame = randomCameraCase({}, false, 33, 17, 51);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkDepthDownsample(Stage stage) {
    const Variant variant = variantOf(pack(), "depth_downsample");
    Pass pass(variant, stage);
    const DepthDownsampleCase frame = randomDepthDownsampleCase(variant, 33, 17, 53);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkAmbientOcclusion(Stage stage) {
    const Variant variant = variantOf(pack(), "ambient_occlusion");
    Pass pass(variant, stage);
    const AmbientOcclusionCase frame = ambientOcclusionCase(variant, Surfaces::corner, 33, 17, 54);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkReprojectionCache(Stage stage) {
    const Variant variant = variantOf(pack(), "reprojection_cache");
    Pass pass(variant, stage);
    const ReprojectionCacheCase frame = reprojectionCacheCase(variant, 33, 17, 55);
    return compareWithOracle(frame, run(pass, frame));
}

Comparison checkBilateralFilter(Stage stage) {
    const Variant variant = variantOf(pack(), "bilateral_filter");
    Pass pass(variant, stage);
    const BilateralFilterCase frame = bilateralFilterCase(variant, 33, 17, {1, 0}, 56);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkBilateralUpsample(Stage stage) {
    const Variant variant = variantOf(pack(), "bilateral_upsample");
    Pass pass(variant, stage);
    const BilateralUpsampleCase frame = bilateralUpsampleCase(variant, 33, 17, 57);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkSunShadow(Stage stage) {
    const Variant variant = variantOf(pack(), "sun_shadow");
    Pass pass(variant, stage);
    const SunShadowCase frame = sunShadowCase(variant, Surfaces::corner, 33, 17, 58);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkLightingCache(Stage stage) {
    const Variant variant = variantOf(pack(), "lighting_cache");
    Pass pass(variant, stage);
    const LightingCacheCase frame = lightingCacheCase(variant, 33, 17, 62);
    return compareWithSeparate(frame, run(pass, frame), SeparatePasses(variant)(frame));
}

Comparison checkDepthHierarchy(Stage stage) {
    const Variant variant = variantOf(pack(), "depth_hierarchy");
    Pass pass(variant, stage);
    const DepthHierarchyCase frame = depthHierarchyCase(variant, 33, 17, 58);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkScalableObscurance(Stage stage) {
    const Variant variant = variantOf(pack(), "scalable_obscurance");
    Pass pass(variant, stage);
    const ScalableObscuranceCase frame = scalableObscuranceCase(variant, Surfaces::corner, 33, 17, 59);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkObscuranceFilter(Stage stage) {
    Pass pass(variantOf(pack(), "obscurance_filter"), stage);
    const ObscuranceFilterCase frame = obscuranceFilterCase(33, 17, {1, 0}, 60);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison checkCombineLighting(Stage stage) {
    const Variant variant = variantOf(pack(), "combine_lighting");
    Pass pass(variant, stage);
    const CombineLightingCase frame = combineLightingCase(variant, 33, 17, 61);
    return compareWithOracle(frame, run(pass, frame)[0]);
}

// Its two stages are executed together.
Comparison checkObjectVelocity(Stage) {
    const ObjectCase object;
    return compareWithOracle(object, recordedMotion(object));
}

Comparison checkTemporalAa(Stage stage) {
    const Variant variant = variantOf(pack(), "temporal_aa");
    Pass pass(variant, stage);
    const TemporalAaFrame frame = randomFrame(33, 17, 52);
    return compareWithOracle(variant, frame, run(pass, frame));
}

struct PassCheck {
    std::string_view pass;
    Comparison (*run)(Stage);
};

// One line for each pass of pack.toml.
constexpr PassCheck checks[] = {
    {"fullscreen", checkFullscreen},
    {"camera_velocity", checkCameraVelocity},
    {"object_velocity", checkObjectVelocity},
    {"depth_downsample", checkDepthDownsample},
    {"ambient_occlusion", checkAmbientOcclusion},
    {"reprojection_cache", checkReprojectionCache},
    {"bilateral_filter", checkBilateralFilter},
    {"bilateral_upsample", checkBilateralUpsample},
    {"sun_shadow", checkSunShadow},
    {"lighting_cache", checkLightingCache},
    {"depth_hierarchy", checkDepthHierarchy},
    {"scalable_obscurance", checkScalableObscurance},
    {"obscurance_filter", checkObscuranceFilter},
    {"combine_lighting", checkCombineLighting},
    {"temporal_aa", checkTemporalAa},
};

constexpr const PassCheck* checkOf(std::string_view pass) {
    for (const PassCheck& check : checks)
        if (check.pass == pass) return &check;
    return nullptr;
}

constexpr bool everyPassHasACheck() {
    for (const auto& pass : reprise::generated::passes)
        if (checkOf(pass.name) == nullptr) return false;
    return true;
}
static_assert(everyPassHasACheck(),
              "A pass of generated/include/reprise/pack_table.hpp has no line in `checks`.");

class EveryPass : public PassTest {};

TEST_F(EveryPass, isExecutedInEachOfItsStages) {
    for (const auto& pass : pack().passes()) {
        const PassCheck* check = checkOf(pass.name);
        ASSERT_NE(check, nullptr) << pass.name
                                  << " is in pack.toml and has no line in `checks`; run reprisec too";
        EXPECT_FALSE(pass.stages.empty()) << pass.name;
        for (const Stage stage : pass.stages) {
            const Comparison result = check->run(stage);
            EXPECT_TRUE(result.holds()) << pass.name << ", " << stageText(stage) << ": " << text(result);
        }
    }
}

TEST_F(EveryPass, ofTheChecksIsInTheTable) {
    for (const PassCheck& check : checks)
        EXPECT_TRUE(std::ranges::any_of(pack().passes(), [&](const auto& pass) {
            return pass.name == check.pass;
        })) << check.pass;
}

// A control: silence means something only if the layer, with synchronization validation, would have spoken.
TEST_F(EveryPass, isWatchedByTheValidationLayer) {
    const harness::Buffer buffer = gpu().buffer(256, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    gpu().run([&](VkCommandBuffer commands) {
        vkCmdFillBuffer(commands, buffer.buffer, 0, 256, 1);
        vkCmdFillBuffer(commands, buffer.buffer, 0, 256, 2); // no barrier between two writes
    });
    std::string messages;
    for (const std::string& message : gpu().takeValidationMessages())
        messages += message;
    EXPECT_NE(messages.find("SYNC-HAZARD-WRITE-AFTER-WRITE"), std::string::npos) << messages;
}

} // namespace
} // namespace passes
