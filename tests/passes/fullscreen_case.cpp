// SPDX-License-Identifier: Apache-2.0
#include "fullscreen_case.hpp"

namespace passes {

namespace {

constexpr const char* positionText = R"(
float2 mainFragment(float4 positionPx : SV_Position) : SV_Target0 { return positionPx.xy; }
)";

const std::vector<uint32_t>& positionSpirv() {
    static const auto compiled = reprisec::compileSource({.name = "position",
                                                          .text = positionText,
                                                          .entry = "mainFragment",
                                                          .stage = Stage::fragment,
                                                          .defines = {},
                                                          .includeDirectories = {}});
    if (!compiled) throw std::runtime_error(compiled.error().message);
    return compiled->spirv;
}

// A pass of no inputs and one output.
const reprise::PassInfo& positionPass() {
    static constexpr Stage stages[] = {Stage::fragment};
    static constexpr reprise::ImageInfo outputs[] = {{"gOutPosition", "", "rg32f", 1.0f, "", {}, ""}};
    static const reprise::PassInfo info = [] {
        reprise::PassInfo pass{};
        pass.name = "position";
        pass.stages = stages;
        pass.fullscreen = true;
        pass.outputs = outputs;
        return pass;
    }();
    return info;
}

} // namespace

Comparison comparePositions(int width, int height) {
    Pass pass({&positionPass(), {}}, Stage::fragment, {rg32f}, positionSpirv());
    const Pixels positions = pass.run({}, {}, width, height)[0];
    return compare(
        positions,
        [](int x, int y, bool) {
            return Expected{{x + 0.5, y + 0.5, 0.0}, glm::dvec3(0.0)};
        },
        2);
}

} // namespace passes
