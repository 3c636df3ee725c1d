// SPDX-License-Identifier: Apache-2.0
// What each pass is run on, and how its result is judged: the images and the oracle of the Vulkan tests.
#pragma once

#include "job_file.hpp"
#include "passes/comparison.hpp"

#include <memory>

namespace d3d {

using reprise::Variant;

// How far a device is from exact coordinates at one extent, in pixels: the weights of its linear filter, and
// what it interpolates over the screen.
struct DeviceError {
    double filterPx = 0.0, interpolationPx = 0.0;
    double coordinatePx() const { return filterPx + interpolationPx; }
};

struct NamedMatrices {
    std::string_view name;
    std::vector<glm::mat4> matrices;
};

struct Scene {
    std::string name;
    int width = 0, height = 0;
    std::vector<passes::NamedPixels> images;
    std::vector<std::byte> parameters; // as the constant buffer holds them
    std::vector<NamedMatrices> palettes;
    Vertices vertices;                    // empty: the full-screen triangle
    std::optional<passes::Pixels> before; // what the target holds before; NaN otherwise
    std::function<passes::Comparison(const std::vector<passes::Pixels>&, const DeviceError&)> judge;
    std::shared_ptr<const void> kept; // what the images point into
};

// The scenes of a variant, the one for controls, of 64x64, first; empty for a pass that is none of the table.
std::vector<Scene> scenesOf(const Variant& variant);

// The corners of the triangle that Direct3D 9 draws the full-screen passes with.
Vertices fullscreenCorners();

// Beside the passes: an engine's own shader with an interpolated texture coordinate, and a ramp of 64 texels
// read at 64x64 places.
Scene screenCopyScene();
Scene rampScene();
// Largest errors that results of position.hlsl and of the ramp show.
double interpolationErrorPx(const passes::Pixels& positions);
double filterErrorPx(const passes::Pixels& ramp);

} // namespace d3d
