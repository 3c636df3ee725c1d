// SPDX-License-Identifier: Apache-2.0
// Ground truth by ray casting for occlusion and for the sun's shadow, on the triangles of a scene with
// Embree. Metres, radians; rows top to bottom; one value per pixel or coarse texel, at the first surface that
// the unjittered camera of scenes::cameraAt sees through its centre. Every function throws std::runtime_error
// with one sentence.
#pragma once

#include "scenes.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace report {

struct PixelGrid {
    uint32_t width = 0, height = 0; // of the frame
    // Pixels per texel along an axis: the image has ceil(extent / ratio) texels, and the camera looks through
    // their centres, of an odd extent's last ones beyond the frame.
    uint32_t ratio = 1;
};

// What a surface at distance d from the point, within the radius, takes away.
enum class Falloff {
    none,      // 1
    quadratic, // 1 - (d / radius)^2: what ambient_occlusion of the pack converges to
};

struct OcclusionRays {
    double radius = 1.0; // metres, above 0
    uint32_t rays = 256; // a pixel, at least 1
    Falloff falloff = Falloff::none;
};

struct SunRays {
    double discRadians = 0.00465; // angular radius of the sun, above 0 and below pi / 2; the real one's
    uint32_t rays = 256;          // a pixel, at least 1
};

struct SunTruth {
    std::vector<float> visibility; // share of the disc that is seen, in [0,1]; 1 in the sky
    // 1 where the whole disc stands above the surface's own plane, and in the sky. Elsewhere the surface
    // shades itself, which a shadow map shows in its own way: visibility is 0 there and stands for nothing.
    std::vector<uint8_t> facesSun;
};

// Called with the share of the work done since the last call, never from two threads at once; sums up to 1.
using OnPart = std::function<void(double share)>;

// Linear depth of the sky in metres, as depth_downsample of the pack writes it.
inline constexpr float skyLinearDepth = 65504.0f;

// Instances that stand still are built once, moving and skinned ones for each frame asked for. An alpha test
// reads the texture's finest mip, between texels as the renderer does: where that shows a coarser one, edges
// of leaves differ. The camera sees back faces of two-sided materials alone, rays are stopped by all.
class RayTruth {
public:
    explicit RayTruth(const scenes::Scene& scene); // which must outlive this
    ~RayTruth();
    RayTruth(const RayTruth&) = delete;
    RayTruth& operator=(const RayTruth&) = delete;

    // skyLinearDepth where the camera sees nothing between its near and far planes.
    std::vector<float> linearDepth(int frame, PixelGrid grid);
    // Visibility in [0,1], 1 in the sky: 1 - mean of the falloff over directions distributed as the cosine to
    // the normal of the triangle, on the side of the camera. The same rays in every frame: what stands still
    // does not flicker.
    std::vector<float> occlusion(int frame, PixelGrid grid, const OcclusionRays& settings,
                                 const OnPart& onPart = {});
    // Rays over the disc around scene.sunDirection, even in solid angle.
    SunTruth sun(int frame, PixelGrid grid, const SunRays& settings, const OnPart& onPart = {});

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace report
