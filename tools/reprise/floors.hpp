// SPDX-License-Identifier: Apache-2.0
// Floors: shaders that only move data, to hold a pass's time against. The HLSL is generated, because a pass's
// own floor follows its reflection: same bindings, as many reads of the same kind and as many writes, nothing
// else.
#pragma once

#include "reprisec.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace report {

struct Offset {
    int x = 0, y = 0;
    bool operator==(const Offset&) const = default;
};

// Where `count` reads of one invocation go, in texels from its first pixel: spread over the pixels it covers
// and a border of one, the middle first, no two alike while there is room. Step 2 is for gathers, which cover
// 2x2.
std::vector<Offset> readOffsets(uint32_t count, const uint32_t (&pixelsPerThread)[2], int step);

// Reads of all kinds per pixel of the output.
double readsPerPixel(const reprise::Variant& variant, reprise::Stage stage,
                     const reprisec::Reflection& reflection);

std::string floorSource(const reprise::Variant& variant, reprise::Stage stage,
                        const reprisec::Reflection& reflection, uint32_t width, uint32_t height);

// The floors that every report has: gIn (RGBA16F) to gOut (RGBA16F), one tap, or nine with their min and max.
// Their table entry, for a pipeline, is `simpleFloorPass()`.
std::string copySource(reprise::Stage stage, uint32_t width, uint32_t height);
std::string nineTapsSource(reprise::Stage stage, uint32_t width, uint32_t height);
const reprise::PassInfo& simpleFloorPass();

} // namespace report
