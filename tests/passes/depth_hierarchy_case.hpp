// SPDX-License-Identifier: Apache-2.0
// Frames for depth_hierarchy, its execution and its comparison with the oracle.
#pragma once

#include "depth_downsample_case.hpp"
#include "oracle/scalable_obscurance.hpp"

namespace passes {

struct DepthHierarchyCase {
    DepthDownsampleCase depths; // of which ratio and checkerboard have no say
    glm::ivec2 extent{0};       // of the hierarchy
    reprise::DepthHierarchyParameters parameters{};
};

// ceil(1.5 width) x height.
glm::ivec2 hierarchyExtent(int width, int height);
// Of a target that is wider than needed.
void setExtent(DepthHierarchyCase& frame, glm::ivec2 extent);
DepthHierarchyCase depthHierarchyCase(const Variant& variant, int width, int height, uint64_t seed,
                                      Depth kind = Depth::standard);
std::vector<Pixels> run(Pass& pass, const DepthHierarchyCase& frame);
Comparison compareWithOracle(const DepthHierarchyCase& frame, const Pixels& hierarchy);

} // namespace passes
