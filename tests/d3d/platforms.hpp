// SPDX-License-Identifier: Apache-2.0
// The two Direct3D versions, what each cannot express and why, and the wrong forms that a test must catch.
#pragma once

#include "reprisec.hpp"

namespace d3d {

using reprise::Stage;
using reprise::Variant;

struct Platform {
    int version;
    std::string_view name, macro;
    std::string_view vertexProfile, fragmentProfile, computeProfile; // empty: there is no such stage
};
inline constexpr Platform platforms[] = {
    {9, "d3d9", "PLATFORM_D3D9", "vs_3_0", "ps_3_0", ""},
    {11, "d3d11", "PLATFORM_D3D11", "vs_5_0", "ps_5_0", "cs_5_0"},
};
std::string_view profileOf(const Platform& platform, Stage stage);

// A pass under a switch that a platform cannot express. The compiler's refusal must hold `compilerSays`: the
// row is wrong where it compiles, and where it fails for another reason.
struct Exception {
    int version;
    Stage stage;
    std::string_view pass;
    reprise::Condition condition;
    std::string_view compilerSays, reason;
};
std::span<const Exception> exceptions();
const Exception* exceptionOf(const Platform& platform, Stage stage, const Variant& variant);

// A function of a header that a platform cannot express.
struct HeaderException {
    int version;
    std::string_view header, function, compilerSays, reason;
};
std::span<const HeaderException> headerExceptions();
const HeaderException* exceptionOf(const Platform& platform, std::string_view header,
                                   std::string_view signature);

// The half-pixel offset in a wrong form: texts of files below hlsl/ replaced.
struct Replacement {
    std::string_view file, original, wrong;
};
struct Control {
    int version;
    std::string_view name, summary;
    std::vector<Replacement> replacements;
};
std::span<const Control> controls();

} // namespace d3d
