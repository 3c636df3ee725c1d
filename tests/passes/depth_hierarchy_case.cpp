// SPDX-License-Identifier: Apache-2.0
#include "depth_hierarchy_case.hpp"

namespace passes {

glm::ivec2 hierarchyExtent(int width, int height) {
    return {(3 * width + 1) / 2, height};
}

void setExtent(DepthHierarchyCase& frame, glm::ivec2 extent) {
    frame.extent = extent;
    for (int i = 0; i < 2; ++i) {
        frame.parameters.gOutputSize[i] = static_cast<float>(extent[i]);
        frame.parameters.gOutputSize[i + 2] = 1.0f / static_cast<float>(extent[i]);
    }
}

DepthHierarchyCase depthHierarchyCase(const Variant& variant, int width, int height, uint64_t seed,
                                      Depth kind) {
    DepthHierarchyCase frame;
    const Variant depths = variantOf(pack(), "depth_downsample",
                                     {{"DEPTH_LINEAR", reprise::switchValue(variant, "DEPTH_LINEAR")},
                                      {"ORTHOGRAPHIC", reprise::switchValue(variant, "ORTHOGRAPHIC")},
                                      {"DEPTH_REVERSED", kind == Depth::standard ? "off" : "on"}});
    frame.depths = randomDepthDownsampleCase(depths, width, height, seed, kind == Depth::reversedInfinite);
    const auto& from = frame.depths.parameters;
    auto& p = frame.parameters;
    std::copy(std::begin(from.gInputSize), std::end(from.gInputSize), p.gInputSize);
    std::copy(std::begin(from.gLinearDepth), std::end(from.gLinearDepth), p.gLinearDepth);
    p.gSkyDepth = from.gSkyDepth;
    setExtent(frame, hierarchyExtent(width, height));
    return frame;
}

std::vector<Pixels> run(Pass& pass, const DepthHierarchyCase& frame) {
    const NamedPixels inputs[] = {{"gInDepth", &frame.depths.depth}};
    return pass(inputs, frame.parameters, frame.extent.x, frame.extent.y);
}

Comparison compareWithOracle(const DepthHierarchyCase& frame, const Pixels& hierarchy) {
    const Pixels& depth = frame.depths.depth;
    return compare(
        hierarchy,
        [&](int x, int y, bool) {
            const auto shown = oracle::hierarchySource({depth.width, depth.height}, {x, y});
            // Of no level: some number, which asks for nothing.
            if (!shown) return Expected{glm::dvec3(0.0), glm::dvec3(1e6)};
            const double linear = oracle::knownDepth(frame.depths.pass, depth.at(shown->x, shown->y, 0));
            return Expected{{linear, 0.0, 0.0}, {linearDepthBound(frame.depths, linear), 0.0, 0.0}};
        },
        1);
}

} // namespace passes
