// SPDX-License-Identifier: Apache-2.0
#include "truth.hpp"

#include "parallel.hpp"
#include "ray_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

namespace report {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Surface {
    glm::dvec3 position, normal; // normal towards the camera
    double linearDepth = 0.0;
    bool isSky = true;
    float offset = 0.0f; // along the normal, for rays that leave the surface
};

void requireGrid(PixelGrid grid) {
    if (grid.width == 0 || grid.height == 0 || grid.ratio == 0)
        throw std::runtime_error("The image of a ground truth must be at least 1x1, and so must its texels");
}

struct Texels {
    size_t width, height;
    size_t count() const { return width * height; }
};

Texels texelsOf(PixelGrid grid) {
    requireGrid(grid);
    return {(size_t{grid.width} + grid.ratio - 1) / grid.ratio,
            (size_t{grid.height} + grid.ratio - 1) / grid.ratio};
}

void requireRays(uint32_t rays) {
    if (rays == 0) throw std::runtime_error("A ground truth takes at least one ray a pixel");
}

// Where the camera of a frame stands and looks.
struct Viewer {
    glm::dvec3 eye, forward;
    glm::dmat3 viewToWorld;
    glm::dvec4 viewRay; // reprise::viewRay()
    double nearPlane, farPlane;
};

Viewer viewerAt(const scenes::Scene& scene, int frame, PixelGrid grid) {
    const auto camera =
        scenes::cameraAt(scene, frame, static_cast<double>(grid.width) / static_cast<double>(grid.height));
    const glm::dmat4 viewToWorld = glm::inverse(camera.worldToView);
    return {glm::dvec3(viewToWorld[3]),
            glm::dvec3(viewToWorld[2]),
            glm::dmat3(viewToWorld),
            reprise::viewRay(camera.viewToClip),
            scene.nearPlane,
            scene.farPlane};
}

Surface surfaceAt(const RayScene& rays, const Viewer& viewer, glm::dvec2 uv) {
    const glm::dvec2 xy = glm::dvec2(viewer.viewRay) * uv + glm::dvec2(viewer.viewRay.z, viewer.viewRay.w);
    const glm::dvec3 perDepth = viewer.viewToWorld * glm::dvec3(xy, 1.0);
    const double metres = glm::length(perDepth); // along the ray, a metre of depth
    const auto to = static_cast<float>(viewer.farPlane * metres);
    auto from = static_cast<float>(viewer.nearPlane * metres);
    RayHit hit;
    while (rays.nearest(viewer.eye, perDepth / metres, from, to, hit)) {
        if (hit.backFace) { // the renderer does not draw it
            from = hit.distance * (1.0f + 1e-6f);
            continue;
        }
        Surface surface;
        surface.position = hit.position;
        surface.normal = hit.normal;
        surface.linearDepth = glm::dot(hit.position - viewer.eye, viewer.forward);
        surface.isSky = false;
        // Positions and Embree's arithmetic are single precision: some units of the last place of both.
        const glm::dvec3 size = glm::abs(hit.position);
        surface.offset =
            2e-6f * static_cast<float>(std::max({size.x, size.y, size.z, 1.0})) + 2e-6f * hit.distance;
        return surface;
    }
    return {};
}

// A number that differs from pixel to pixel without a pattern. (The finaliser of MurmurHash3.)
uint32_t scrambled(uint32_t value) {
    value = (value ^ (value >> 16)) * 0x85ebca6bu;
    value = (value ^ (value >> 13)) * 0xc2b2ae35u;
    return value ^ (value >> 16);
}

uint32_t reversed(uint32_t bits) {
    bits = (bits >> 16) | (bits << 16);
    bits = ((bits & 0x00ff00ffu) << 8) | ((bits & 0xff00ff00u) >> 8);
    bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits & 0xf0f0f0f0u) >> 4);
    bits = ((bits & 0x33333333u) << 2) | ((bits & 0xccccccccu) >> 2);
    return ((bits & 0x55555555u) << 1) | ((bits & 0xaaaaaaaau) >> 1);
}

// Hammersley's points over the unit square, moved by another vector in each pixel and wrapped around
// (Cranley and Patterson). Integers wrap by themselves.
class PixelPoints {
public:
    PixelPoints(size_t pixel, uint32_t count)
        : step_((uint64_t{1} << 32) / count), moveX_(scrambled(static_cast<uint32_t>(2 * pixel + 1))),
          moveY_(scrambled(static_cast<uint32_t>(2 * pixel + 2))) {}
    glm::dvec2 operator[](uint32_t index) const {
        const auto x = static_cast<uint32_t>(step_ * index) + moveX_, y = reversed(index) + moveY_;
        return (glm::dvec2(x, y) + 0.5) * 0x1p-32;
    }

private:
    uint64_t step_;
    uint32_t moveX_, moveY_;
};

glm::dmat3 frameAround(glm::dvec3 axis) {
    const glm::dvec3 helper = std::abs(axis.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 side = glm::normalize(glm::cross(helper, axis));
    return {side, glm::cross(axis, side), axis};
}

// Of unit length, around +z: its z and its azimuth.
glm::dvec3 aroundZ(double z, double turn) {
    const double angle = 2.0 * std::numbers::pi * turn, ring = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {ring * std::cos(angle), ring * std::sin(angle), z};
}

double occlusionAt(const RayScene& rays, const Surface& surface, size_t pixel,
                   const OcclusionRays& settings) {
    const PixelPoints points(pixel, settings.rays);
    const glm::dmat3 frame = frameAround(surface.normal);
    const glm::vec3 origin(surface.position + static_cast<double>(surface.offset) * surface.normal);
    const auto radius = static_cast<float>(settings.radius);
    double occluded = 0.0;
    for (uint32_t i = 0; i < settings.rays; ++i) {
        const glm::dvec2 point = points[i];
        // The root of an even number is distributed as the cosine.
        const glm::vec3 direction(frame * aroundZ(std::sqrt(point.x), point.y));
        if (settings.falloff == Falloff::none) {
            occluded += rays.isBlocked(origin, direction, radius) ? 1.0 : 0.0;
        } else {
            const double share =
                static_cast<double>(rays.nearestDistance(origin, direction, radius)) / settings.radius;
            occluded += std::max(0.0, 1.0 - share * share);
        }
    }
    return occluded / settings.rays;
}

double sunAt(const RayScene& rays, const Surface& surface, size_t pixel, const SunRays& settings,
             const glm::dmat3& sunFrame) {
    const PixelPoints points(pixel, settings.rays);
    const glm::vec3 origin(surface.position + static_cast<double>(surface.offset) * surface.normal);
    const double least = std::cos(settings.discRadians);
    uint32_t seen = 0;
    for (uint32_t i = 0; i < settings.rays; ++i) {
        const glm::dvec2 point = points[i];
        const glm::vec3 direction(sunFrame * aroundZ(1.0 - point.x * (1.0 - least), point.y));
        seen += rays.isBlocked(origin, direction, infinity) ? 0 : 1;
    }
    return static_cast<double>(seen) / settings.rays;
}

} // namespace

struct RayTruth::State {
    explicit State(const scenes::Scene& from) : scene(from), rays(from) {}

    const scenes::Scene& scene;
    RayScene rays;

    // work(pixel, surface) for every pixel, rows on all cores.
    template <class Work>
    void forEachPixel(int frame, PixelGrid grid, const OnPart& onPart, const Work& work) {
        const Texels texels = texelsOf(grid);
        rays.setFrame(frame);
        const Viewer viewer = viewerAt(scene, frame, grid);
        std::mutex mutex;
        parallelFor(texels.height, [&](size_t row) {
            for (size_t column = 0; column < texels.width; ++column) {
                const glm::dvec2 px(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
                const glm::dvec2 uv =
                    px * static_cast<double>(grid.ratio) / glm::dvec2(grid.width, grid.height);
                work(row * texels.width + column, surfaceAt(rays, viewer, uv));
            }
            if (!onPart) return;
            const std::lock_guard lock(mutex);
            onPart(1.0 / static_cast<double>(texels.height));
        });
    }
};

RayTruth::RayTruth(const scenes::Scene& scene) : state_(std::make_unique<State>(scene)) {}
RayTruth::~RayTruth() = default;

std::vector<float> RayTruth::linearDepth(int frame, PixelGrid grid) {
    std::vector<float> depth(texelsOf(grid).count());
    state_->forEachPixel(frame, grid, {}, [&](size_t pixel, const Surface& surface) {
        depth[pixel] = surface.isSky ? skyLinearDepth : static_cast<float>(surface.linearDepth);
    });
    return depth;
}

std::vector<float> RayTruth::occlusion(int frame, PixelGrid grid, const OcclusionRays& settings,
                                       const OnPart& onPart) {
    requireRays(settings.rays);
    if (!(settings.radius > 0.0 && settings.radius < 1e6))
        throw std::runtime_error(
            fmt::format("The radius of occlusion is {}; it must be above 0 and finite", settings.radius));
    std::vector<float> visibility(texelsOf(grid).count());
    state_->forEachPixel(frame, grid, onPart, [&](size_t pixel, const Surface& surface) {
        const double occluded = surface.isSky ? 0.0 : occlusionAt(state_->rays, surface, pixel, settings);
        visibility[pixel] = static_cast<float>(1.0 - occluded);
    });
    return visibility;
}

SunTruth RayTruth::sun(int frame, PixelGrid grid, const SunRays& settings, const OnPart& onPart) {
    requireRays(settings.rays);
    if (!(settings.discRadians > 0.0 && settings.discRadians < std::numbers::pi / 2.0))
        throw std::runtime_error(fmt::format(
            "The sun's angular radius is {}; it must lie between 0 and pi / 2", settings.discRadians));
    const glm::dvec3 towardsSun = glm::normalize(glm::dvec3(state_->scene.sunDirection));
    const glm::dmat3 sunFrame = frameAround(towardsSun);
    const size_t count = texelsOf(grid).count();
    SunTruth truth{std::vector<float>(count), std::vector<uint8_t>(count)};
    state_->forEachPixel(frame, grid, onPart, [&](size_t pixel, const Surface& surface) {
        const bool facesSun =
            surface.isSky || glm::dot(surface.normal, towardsSun) > std::sin(settings.discRadians);
        truth.facesSun[pixel] = facesSun ? 1 : 0;
        const double seen = surface.isSky ? 1.0
                            : facesSun    ? sunAt(state_->rays, surface, pixel, settings, sunFrame)
                                          : 0.0;
        truth.visibility[pixel] = static_cast<float>(seen);
    });
    return truth;
}

} // namespace report
