// SPDX-License-Identifier: Apache-2.0
// The Direct3D 9 form of every fragment pass under Direct3D 9's rasterisation rule: pixel centres at whole
// numbers of the viewport, which the viewport is moved for. What is interpolated over the screen is then that
// of the texels' centres only with the half-pixel offset, and the passes equal the oracle; without it or with
// a wrong sign they do not. On real devices: ./run d3d.
//
// The texts are the pack's under PLATFORM_D3D9, with textures spelled as Vulkan wants them, and with corners
// by vertex number in place of a vertex buffer.
#include "ambient_occlusion_case.hpp"
#include "bilateral_upsample_case.hpp"
#include "camera_case.hpp"
#include "changed_pack.hpp"
#include "combine_lighting_case.hpp"
#include "depth_downsample_case.hpp"
#include "depth_hierarchy_case.hpp"
#include "object_case.hpp"
#include "reprojection_cache_case.hpp"
#include "scalable_obscurance_case.hpp"
#include "sun_shadow_case.hpp"
#include "temporal_aa_case.hpp"
#include "viewport_shift.hpp"

#include <algorithm>
#include <cmath>

namespace passes {
namespace {

const PlatformSwitches d3d9 = {{"PLATFORM_D3D9", 1}};

struct Size {
    int width, height;
};
constexpr Size sizes[] = {{64, 64}, {33, 17}};

std::string text(Size size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

// A wrong form of the half-pixel offset; none of an empty file.
struct Wrong {
    std::string_view name;
    TextChange change;
};
constexpr std::string_view halfPixel = "reprise/half_pixel.hlsli";
constexpr Wrong right{"right", {}};
constexpr Wrong wrongForms[] = {
    {"uncorrected",
     {halfPixel, "    positionCS.xy += float2(-texelSize.x, texelSize.y) * positionCS.w;\n", ""}},
    {"wrongSign", {halfPixel, "positionCS.xy += float2", "positionCS.xy -= float2"}},
    {"wrongSignOfY", {halfPixel, "float2(-texelSize.x, texelSize.y)", "-texelSize"}},
};

// The pack with Vulkan's textures under PLATFORM_D3D9, for targets of one size.
class D3d9Pack {
public:
    D3d9Pack(Size size, const Wrong& wrong)
        : targetSize_("#define TARGET_SIZE(name) static const float4 name = float4(" + floats(size) + ")"),
          changed_(changes(wrong)) {
        if (!changed_.missing().empty()) throw std::runtime_error(changed_.missing());
    }

    const reprisec::Pack& pack() const { return changed_.pack(); }

    // A shader of the test's own.
    std::vector<uint32_t> compile(const std::string& source, Stage stage) const {
        auto compiled =
            reprisec::compileSource({.name = "d3d9_test",
                                     .text = source,
                                     .entry = stage == Stage::vertex ? "mainCorner" : "mainFragment",
                                     .stage = stage,
                                     .defines = d3d9,
                                     .includeDirectories = {changed_.directory()}});
        if (!compiled) throw std::runtime_error(compiled.error().message);
        return compiled->spirv;
    }

    // The pass fullscreen's vertex stage, its corner by the number of the vertex.
    std::vector<uint32_t> fullscreenVertex() const {
        return compile("#include \"passes/fullscreen.hlsl\"\n"
                       "Varyings mainCorner(uint vertex : SV_VertexID) {\n"
                       "    return mainVertex(float2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0));\n"
                       "}\n",
                       Stage::vertex);
    }

private:
    static std::string floats(Size size) {
        const std::string width = std::to_string(size.width) + ".0",
                          height = std::to_string(size.height) + ".0";
        return width + ", " + height + ", 1.0 / " + width + ", 1.0 / " + height;
    }
    std::vector<TextChange> changes(const Wrong& wrong) const {
        constexpr std::string_view platform = "reprise/platform.hlsli";
        std::vector<TextChange> list = {
            {platform, "#if PLATFORM_D3D9\n", "#if PLATFORM_D3D9 && PLATFORM_D3D11\n"},
            {platform, "#if !PLATFORM_D3D9\n", "#if !PLATFORM_D3D9 || !PLATFORM_D3D11\n"},
            {platform, "#define TARGET_SIZE(name) float4 name", targetSize_},
        };
        if (!wrong.change.file.empty()) list.push_back(wrong.change);
        return list;
    }

    std::string targetSize_;
    ChangedPack changed_;
};

Pass fullscreenPass(const D3d9Pack& pack, const Variant& variant, std::vector<VkFormat> formats) {
    const auto vertex = pack.fullscreenVertex();
    return Pass(variant, Stage::fragment, std::move(formats),
                spirvOf(pack.pack(), variant, Stage::fragment, d3d9), vertex);
}

// --- What an engine's own shader sees

reprise::PassInfo ownPass(std::span<const reprise::ImageInfo> inputs,
                          std::span<const reprise::BindingInfo> bindings) {
    static constexpr Stage stages[] = {Stage::fragment};
    static constexpr reprise::ImageInfo outputs[] = {{"gOutColour", "", "rgba32f", 1.0f, "", {}, ""}};
    reprise::PassInfo info{};
    info.name = "own";
    info.stages = stages;
    info.fullscreen = true;
    info.inputs = inputs;
    info.bindings = bindings;
    info.outputs = outputs;
    return info;
}

// POSITION_PX of every pixel.
Pixels positions(const D3d9Pack& pack, Size size) {
    const auto fragment = pack.compile("#include \"reprise/platform.hlsli\"\n"
                                       "float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {\n"
                                       "    return float4(positionPx.xy, 0.0, 1.0);\n"
                                       "}\n",
                                       Stage::fragment);
    static const reprise::PassInfo info = ownPass({}, {});
    Pass pass({&info, {}}, Stage::fragment, {rgba32f}, fragment, pack.fullscreenVertex());
    return pass.run({}, {}, size.width, size.height)[0];
}

// NaN, as of a pixel that is not covered, is infinitely far.
double interpolationErrorPx(const D3d9Pack& pack, Size size) {
    const Pixels found = positions(pack, size);
    double error = 0.0;
    for (int i = 0; i < size.width * size.height; ++i)
        for (int c = 0; c < 2; ++c) {
            const double centre = (c == 0 ? i % size.width : i / size.width) + 0.5;
            const double off = std::abs(found.at(i % size.width, i / size.width, c) - centre);
            error = off <= error ? error : std::isnan(off) ? HUGE_VAL : off;
        }
    return error;
}

// A texture coordinate that is interpolated over the screen, as the listings have it, and a linear filter.
Comparison copyOfNoise(const D3d9Pack& pack, Size size) {
    static constexpr reprise::ImageInfo inputs[] = {{"gInColour", "", "rgba32f", 1.0f, "", {}, ""}};
    static constexpr reprise::BindingInfo bindings[] = {
        {"gInColour", 1, reprise::BindingKind::sampledImage},
        {"gInColour_sampler", 33, reprise::BindingKind::linearSampler}};
    const std::string vertex =
        "#include \"reprise/coordinates.hlsli\"\n"
        "#include \"reprise/half_pixel.hlsli\"\n"
        "#include \"reprise/platform.hlsli\"\n"
        "TARGET_SIZE(gOutputSize);\n"
        "void mainCorner(uint vertex : SV_VertexID, out float4 positionCS : SV_Position,\n"
        "                out float2 uv : TEXCOORD0) {\n"
        "    float2 corner = float2(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0);\n"
        "    positionCS = halfPixelOffset(float4(corner, 0.0, 1.0), gOutputSize.zw);\n"
        "    uv = ndcToUv(corner);\n"
        "}\n";
    const std::string fragment = "#include \"reprise/platform.hlsli\"\n"
                                 "TEXTURE_LINEAR(gInColour, 1);\n"
                                 "float4 mainFragment(float2 uv : TEXCOORD0) : SV_Target0 {\n"
                                 "    return SAMPLE(gInColour, uv);\n"
                                 "}\n";
    const Pixels noise = highContrastNoise(rgba32f, size.width, size.height, 71);
    static const reprise::PassInfo info = ownPass(inputs, bindings);
    Pass pass({&info, {}}, Stage::fragment, {rgba32f}, pack.compile(fragment, Stage::fragment),
              pack.compile(vertex, Stage::vertex));
    const NamedPixels named[] = {{"gInColour", &noise}};
    // A coordinate that is off by a share of a texel changes the copy by up to that in x and in y: 2^-9 each,
    // half a step of an 8-bit filter, and 1/256 of the half texel that is looked for.
    return compare(
        pass.run(named, {}, size.width, size.height)[0],
        [&](int x, int y, bool) {
            return Expected{{noise.at(x, y, 0), noise.at(x, y, 1), noise.at(x, y, 2)}, glm::dvec3(0x1p-8)};
        },
        3);
}

// --- The passes

Comparison cameraVelocity(const D3d9Pack& pack, const Variant& variant, Size size) {
    CameraKind kind;
    if (reprise::switchValue(variant, "ORTHOGRAPHIC") == "on") kind.projection = Projection::orthographic;
    const bool linear = reprise::switchValue(variant, "DEPTH_LINEAR") == "on";
    const CameraCase frame = randomCameraCase(kind, linear, size.width, size.height, 72);
    Pass pass = fullscreenPass(pack, variant, {rg32f});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison temporalAa(const D3d9Pack& pack, const Variant& variant, Size size) {
    const bool blurs = reprise::switchValue(variant, "MOTION_BLUR_FALLBACK") == "on";
    const TemporalAaFrame frame = randomFrame(
        size.width, size.height, 73, size.width == sizes[0].width ? Contrast::moderate : Contrast::extreme);
    Pass pass = fullscreenPass(pack, variant, std::vector<VkFormat>(blurs ? 2 : 1, rgba32f));
    // That of the right form: a wrong one is not to widen its own bound.
    static std::map<int, double> interpolationPx;
    if (!interpolationPx.contains(size.width))
        interpolationPx[size.width] = interpolationErrorPx(D3d9Pack(size, right), size);
    return compareWithOracle(variant, frame, run(pass, frame),
                             linearFilterError() + interpolationPx[size.width]);
}

Comparison objectVelocity(const D3d9Pack& pack, const Variant& variant, Size size) {
    ObjectCase object;
    object.skinned = reprise::switchValue(variant, "SKINNING") == "on";
    object.width = size.width;
    object.height = size.height;
    return compareWithOracle(object, recordedMotion(object, pack.pack(), d3d9));
}

// The framework's: `size` is that of the target, whatever the ratio.
Comparison depthDownsample(const D3d9Pack& pack, const Variant& variant, Size size) {
    const int ratio = reprise::switchValue(variant, "RATIO").front() - '0';
    const auto frame = randomDepthDownsampleCase(variant, ratio * size.width, ratio * size.height, 74);
    Pass pass = fullscreenPass(pack, variant, wideFormats(variant));
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison occlusionOf(const D3d9Pack& pack, const Variant& variant, Size size, Surfaces surfaces) {
    const auto frame = ambientOcclusionCase(variant, surfaces, size.width, size.height, 75);
    Pass pass = fullscreenPass(pack, variant, {rg32f});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

// Random depths differ from texel to texel, which wrong forms show; their bounds are wide.
Comparison ambientOcclusion(const D3d9Pack& pack, const Variant& variant, Size size) {
    return occlusionOf(pack, variant, size, Surfaces::random);
}

Comparison reprojectionCache(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = reprojectionCacheCase(variant, 2 * size.width, 2 * size.height, 76);
    Pass pass = fullscreenPass(pack, variant, wideFormats(variant));
    return compareWithOracle(frame, run(pass, frame));
}

Comparison bilateralFilter(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = bilateralFilterCase(variant, size.width, size.height, {1, 0}, 77);
    Pass pass = fullscreenPass(pack, variant, wideFormats(variant));
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison bilateralUpsample(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = bilateralUpsampleCase(variant, size.width, size.height, 78);
    Pass pass = fullscreenPass(pack, variant, wideFormats(variant));
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison sunShadow(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = sunShadowCase(variant, Surfaces::corner, size.width, size.height, 79);
    Pass pass = fullscreenPass(pack, variant, {rg32f});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison depthHierarchy(const D3d9Pack& pack, const Variant& variant, Size size) {
    auto frame = depthHierarchyCase(variant, 2 * size.width / 3, size.height, 79);
    setExtent(frame, {size.width, size.height});
    Pass pass = fullscreenPass(pack, variant, {r32f});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison scalableObscurance(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = scalableObscuranceCase(variant, Surfaces::random, size.width, size.height, 80);
    Pass pass = fullscreenPass(pack, variant, {rgba8});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison obscuranceFilter(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = obscuranceFilterCase(size.width, size.height, {1, 0}, 81);
    Pass pass = fullscreenPass(pack, variant, {rgba8});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

Comparison combineLighting(const D3d9Pack& pack, const Variant& variant, Size size) {
    const auto frame = combineLightingCase(variant, size.width, size.height, 82);
    Pass pass = fullscreenPass(pack, variant, {rgba32f});
    return compareWithOracle(frame, run(pass, frame)[0]);
}

struct PassCheck {
    std::string_view pass;
    Comparison (*run)(const D3d9Pack&, const Variant&, Size);
    // It takes the position for that of a whole texel and reads texels alone: half a pixel does not show.
    bool readsWholeTexels = false;
};
// One line for each pass of pack.toml with a fragment stage.
constexpr PassCheck checks[] = {
    {"camera_velocity", cameraVelocity},
    {"object_velocity", objectVelocity},
    {"depth_downsample", depthDownsample},
    {"ambient_occlusion", ambientOcclusion},
    {"reprojection_cache", reprojectionCache},
    {"bilateral_filter", bilateralFilter},
    {"bilateral_upsample", bilateralUpsample},
    {"sun_shadow", sunShadow},
    {"depth_hierarchy", depthHierarchy, true},
    {"scalable_obscurance", scalableObscurance},
    {"obscurance_filter", obscuranceFilter, true},
    {"combine_lighting", combineLighting, true},
    {"temporal_aa", temporalAa},
};

constexpr bool everyFragmentPassHasACheck() {
    for (const auto& pass : reprise::generated::passes)
        for (const Stage stage : pass.stages) {
            bool found = stage != Stage::fragment;
            for (const PassCheck& check : checks)
                found = found || check.pass == pass.name;
            if (!found) return false;
        }
    return true;
}
static_assert(everyFragmentPassHasACheck(),
              "A pass of generated/include/reprise/pack_table.hpp has no line in `checks`.");

class D3d9Rasterisation : public PassTest {
protected:
    ViewportShift shift{d3d9Shift};
};

TEST_F(D3d9Rasterisation, everyVariantEqualsTheOracle) {
    for (const Size size : sizes) {
        const D3d9Pack pack(size, right);
        for (const PassCheck& check : checks)
            for (const Variant& variant : committedVariants(check.pass)) {
                const Comparison result = check.run(pack, variant, size);
                EXPECT_TRUE(result.holds())
                    << describe(variant, Stage::fragment, size.width, size.height) << ": " << text(result);
            }
    }
}

// Where the bounds are narrow.
TEST_F(D3d9Rasterisation, occlusionInTheCornerOfARoomEqualsTheOracle) {
    for (const Size size : sizes) {
        const D3d9Pack pack(size, right);
        for (const Variant& variant : committedVariants("ambient_occlusion")) {
            const Comparison result = occlusionOf(pack, variant, size, Surfaces::corner);
            EXPECT_TRUE(result.holds())
                << describe(variant, Stage::fragment, size.width, size.height) << ": " << text(result);
        }
    }
}

TEST_F(D3d9Rasterisation, uncorrectedAndWrongSignsAreCaughtInEveryPass) {
    for (const Wrong& wrong : wrongForms) {
        const D3d9Pack pack(sizes[0], wrong);
        for (const PassCheck& check : checks) {
            const Comparison result = check.run(pack, variantOf(passes::pack(), check.pass), sizes[0]);
            if (check.readsWholeTexels && &wrong == &wrongForms[0]) continue;
            // Objects cover a quarter of their image.
            EXPECT_GT(result.outside, result.pixels / 8) << check.pass << ", " << wrong.name;
        }
    }
}

TEST_F(D3d9Rasterisation, positionsAreThoseOfPixelCentres) {
    for (const Size size : {sizes[0], sizes[1], Size{1, 1}, Size{641, 359}, Size{1, 97}}) {
        // 1/1024 px: far from the half pixel that is looked for.
        EXPECT_LE(interpolationErrorPx(D3d9Pack(size, right), size), 0x1p-10) << text(size);
        for (const Wrong& wrong : wrongForms)
            EXPECT_GE(interpolationErrorPx(D3d9Pack(size, wrong), size), 0.49) << wrong.name << text(size);
    }
}

TEST_F(D3d9Rasterisation, interpolatedTextureCoordinateCopiesTheImageTexelByTexel) {
    // Of a row at an edge a wrong form may be right, for its reads beyond the edge are clamped to it.
    for (const Size size : sizes) {
        const Comparison copied = copyOfNoise(D3d9Pack(size, right), size);
        EXPECT_TRUE(copied.holds()) << text(size) << ": " << text(copied);
        for (const Wrong& wrong : wrongForms) {
            const Comparison caught = copyOfNoise(D3d9Pack(size, wrong), size);
            EXPECT_GE(caught.outside, caught.pixels - static_cast<size_t>(size.width))
                << wrong.name << ", " << text(size);
        }
    }
}

// Where pixel centres lie at halves, as in Direct3D 11 and Vulkan, the same offset is wrong.
TEST_F(PassTest, halfPixelOffsetIsCaughtWhereCentresAgree) {
    const D3d9Pack pack(sizes[0], right);
    for (const PassCheck& check : checks) {
        const Comparison result = check.run(pack, variantOf(passes::pack(), check.pass), sizes[0]);
        EXPECT_GT(result.outside, result.pixels / 8) << check.pass;
    }
    EXPECT_GE(copyOfNoise(pack, sizes[0]).outside, size_t{64 * 64 - 1});
}

} // namespace
} // namespace passes
