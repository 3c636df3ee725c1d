// SPDX-License-Identifier: Apache-2.0
// What the pass sun_shadow takes of an engine's cascaded shadow map, computed in double precision.
#pragma once

#include "reprise/camera.hpp"
#include "reprise/pack_table.hpp"
#include "reprise/result.hpp"

#include <span>

namespace reprise {

// One column of the shadow map.
struct ShadowCascade {
    // World space to NDC of the column: x right, y up, both in [-1,1]; depth in [0,1] as the shadow map holds
    // it, standard or reversed. Orthographic.
    glm::dmat4 worldToClip{1.0};
    double farDepth = 0.0; // linear depth of the camera in metres at which it ends
};

struct SunShadowTuning {
    double radius = 0.1;          // of the disc that is sampled, metres
    double leastTexels = 1.5;     // the same in texels of any cascade, at least: hides their steps
    glm::dvec2 bias{0.01, 0.001}; // metres, and metres a metre of linear depth, that a shadow stands over
    double steepest = 8.0;        // metres of depth a metre across: a steeper surface counts as this steep
};

// All parameters but gOutputSize, gFrameIndex and gSubsetCount, which are left 0. frameToCoarse: extent of
// the frame / (ratio * extent of the pass's images), (1, 1) for even extents and at full resolution. mapWidth
// and mapHeight: texels of the whole shadow map. Fails for no or more than four cascades, a width that they
// do not divide, a matrix that is not orthographic, cascades that are not the first one scaled and moved, and
// far depths that do not ascend.
Result<SunShadowParameters> sunShadowParameters(const CameraFrame& camera, glm::dvec2 frameToCoarse,
                                                std::span<const ShadowCascade> cascades, uint32_t mapWidth,
                                                uint32_t mapHeight, const SunShadowTuning& tuning = {});

} // namespace reprise
