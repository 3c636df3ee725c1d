// SPDX-License-Identifier: Apache-2.0
#include "platforms.hpp"

#include <algorithm>

namespace d3d {

namespace {

constexpr std::string_view cannotMap = "X4532"; // cannot map expression to the instruction set
constexpr std::string_view fineDerivatives =
    "quads share reads through fine derivatives, which shader model 5 has; those of shader model 3 may be "
    "coarse, one for the whole quad";

constexpr Exception exceptionRows[] = {
    {9,
     Stage::fragment,
     "temporal_aa",
     {"QUAD_SHARING", "on"},
     "undeclared identifier 'LOAD'",
     "quads take colours from loads, depths from gathers and neighbours from fine derivatives, which shader "
     "model 3 has not"},
    {11,
     Stage::compute,
     "temporal_aa",
     {"QUAD_SHARING", "on"},
     "WaveGetLaneIndex",
     "subgroup operations in compute need shader model 6, which another compiler makes"},
};

constexpr HeaderException headerExceptionRows[] = {
    {9, "quad_sharing.hlsli", "quadSwapX(float3,float2)", cannotMap, fineDerivatives},
    {9, "quad_sharing.hlsli", "quadSwapY(float3,float2)", cannotMap, fineDerivatives},
};

constexpr std::string_view offsetLine =
    "    positionCS.xy += float2(-texelSize.x, texelSize.y) * positionCS.w;\n";

// In Direct3D 11 the full-screen triangle does not call the function and no pass has a size to give it, so
// the control hands them one: 64x64, the extent at which controls run.
const std::vector<Control>& controlRows() {
    static const std::vector<Control> rows = {
        {9, "uncorrected", "no half-pixel offset", {{"reprise/half_pixel.hlsli", offsetLine, ""}}},
        {9,
         "wrong_sign",
         "the offset to the right and down",
         {{"reprise/half_pixel.hlsli", "positionCS.xy += float2", "positionCS.xy -= float2"}}},
        {9,
         "wrong_sign_of_y",
         "the offset to the left and down",
         {{"reprise/half_pixel.hlsli", "float2(-texelSize.x, texelSize.y)", "-texelSize"}}},
        {11,
         "offset_present",
         "Direct3D 9's offset",
         {{"reprise/half_pixel.hlsli", "#if PLATFORM_D3D9", "#if PLATFORM_D3D11"},
          {"reprise/platform.hlsli", "float4(0.0, 0.0, 0.0, 0.0)",
           "float4(64.0, 64.0, 1.0, 1.0) / float4(1.0, 1.0, 64.0, 64.0)"},
          {"passes/fullscreen.hlsl",
           "return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);",
           "return halfPixelOffset(float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0), 1.0 "
           "/ 64.0);"}}},
    };
    return rows;
}

} // namespace

std::string_view profileOf(const Platform& platform, Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return platform.vertexProfile;
    case Stage::fragment:
        return platform.fragmentProfile;
    case Stage::compute:
        break;
    }
    return platform.computeProfile;
}

std::span<const Exception> exceptions() {
    return exceptionRows;
}

const Exception* exceptionOf(const Platform& platform, Stage stage, const Variant& variant) {
    const auto found = std::ranges::find_if(exceptionRows, [&](const Exception& row) {
        return row.version == platform.version && row.stage == stage && row.pass == variant.pass->name &&
               reprise::switchValue(variant, row.condition.switchName) == row.condition.value;
    });
    return found == std::end(exceptionRows) ? nullptr : found;
}

std::span<const HeaderException> headerExceptions() {
    return headerExceptionRows;
}

const HeaderException* exceptionOf(const Platform& platform, std::string_view header,
                                   std::string_view signature) {
    const auto found = std::ranges::find_if(headerExceptionRows, [&](const HeaderException& row) {
        return row.version == platform.version && row.header == header && row.function == signature;
    });
    return found == std::end(headerExceptionRows) ? nullptr : found;
}

std::span<const Control> controls() {
    return controlRows();
}

} // namespace d3d
