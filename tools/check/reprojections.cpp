// SPDX-License-Identifier: Apache-2.0
#include "reprojections.hpp"

#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using functions::isAtLimit;
using functions::matrixOf;
using functions::nearClip;
using functions::Projection;
using functions::push;
using functions::randomView;
using functions::viewRays;

// Between the frames the camera stands still, turns and moves a little, zooms, or is cut to elsewhere, the
// place behind it included. Worlds away from the origin are moved there: views hold no more than 100 m.
MovedCamera randomCamera(Random& random, const Projection& projection) {
    const size_t kind = random.below(4);
    MovedCamera made{projection, {randomView(random, 3.0, 100.0), projection.matrix}, {}};
    made.previous = made.current;
    if (kind > 0)
        made.previous.worldToView =
            randomView(random, kind == 3 ? 3.0 : 0.05, kind == 3 ? 20.0 : 0.3) * made.current.worldToView;
    if (kind == 2) {
        made.previous.viewToClip[0][0] *= 1.1;
        made.previous.viewToClip[1][1] *= 1.1;
    }
    return made;
}

// What nearClip() allows, as the size of as many roundings.
Right inRoundings(const functions::Expected& expected) {
    Right made{expected.value, expected.bound / (matrixRoundings * roundoff), 2};
    if (std::isinf(expected.bound.x)) made = open(2);
    return made;
}

} // namespace

Right clipRight(dvec4 clip, bool sharesY) {
    const bool denormal =
        (clip.w != 0.0 && std::abs(clip.w) < smallestNormal) ||
        (std::abs(clip.w) < 1e-25 && glm::any(glm::lessThan(glm::abs(dvec2(clip)), dvec2(1e-37))));
    if (denormal) return open(2);
    const dvec2 uv = oracle::clipToUv(clip, sharesY);
    if (!(clip.w > 0.0)) return right(uv);
    const dvec2 ndc = dvec2(clip) / clip.w;
    const double size = 1.0 + std::max(std::abs(ndc.x), std::abs(ndc.y));
    return isAtLimit(ndc, clipRoundings * roundoff * std::min(size, 32.0)) ? open(2) : right(uv, size);
}

std::shared_ptr<Reprojections> reprojections(const std::vector<Projection>& projections, const Effort& effort,
                                             bool device) {
    auto made = std::make_shared<Reprojections>();
    Random random(3);
    const std::vector<float> oddDepths{0.0f, 1.0f, 1e-40f, 1e-30f, 0.99999994f};
    for (size_t i = 0; i < effort.of(4000); ++i) {
        const Projection& projection = projections[i % projections.size()];
        const MovedCamera camera = randomCamera(random, projection);
        Row start;
        glm::dmat4 m = camera.previous.viewToClip * camera.previous.worldToView *
                       glm::inverse(camera.current.worldToView);
        push(start, device ? m * glm::inverse(camera.current.viewToClip) : m);
        const std::vector<double> depths = depthsOf(projection, 25);
        for (size_t k = 0; k < depths.size(); ++k) {
            Row row = start;
            float depth =
                static_cast<float>(device ? oracle::deviceDepth(depths[k], projection.matrix) : depths[k]);
            if (device && k % 5 == 0) depth = oddDepths[k / 5];
            row.push_back(vec4(random.unit(), random.unit(), depth, made->cameras.size()));
            if (!device) row.push_back(vec4(viewRays({projection})));
            made->rows.push_back(row);
        }
        made->cameras.push_back(camera);
    }
    return made;
}

Right placeFromDevice(const Row& in, const MovedCamera& camera) {
    const dvec2 uv = oracle::reprojectDeviceDepth(xy(in[4]), in[4].z, camera.current, camera.previous);
    const dvec4 point(oracle::uvToNdc(xy(in[4])), in[4].z, 1.0);
    // uv - 1/2 is rounded at 1/2, so NDC at 1.
    return inRoundings(nearClip(matrixOf(in), point, glm::max(glm::abs(point), dvec4(1, 1, 0, 1)), uv));
}

namespace {

dvec4 pointOf(const Row& in, const MovedCamera& camera) {
    return oracle::viewPoint(oracle::uvToNdc(xy(in[4])), in[4].z, camera.projection.matrix);
}

// The ray is rounded at the size of its extent and its origin, not at its own.
dvec4 pointSizes(const Row& in, const MovedCamera& camera) {
    const dvec4 rays = glm::abs(viewRays({camera.projection}));
    const double depth = in[4].z, scale = camera.projection.orthographic ? 1.0 : depth;
    return {scale * (rays.x + rays.z), scale * (rays.y + rays.w), depth, 1.0};
}

} // namespace

Right placeFromLinear(const Row& in, const MovedCamera& camera) {
    const dvec2 uv = oracle::reprojectLinearDepth(xy(in[4]), in[4].z, camera.current, camera.previous);
    return inRoundings(nearClip(matrixOf(in), pointOf(in, camera), pointSizes(in, camera), uv));
}

dvec4 clipSizes(const Row& in, const MovedCamera& camera) {
    const glm::dmat4 m = matrixOf(in);
    const dvec4 sizes = pointSizes(in, camera);
    dvec4 sums(0.0);
    for (int c = 0; c < 4; ++c)
        sums += glm::abs(m[c] * sizes[c]);
    return sums;
}

} // namespace check
