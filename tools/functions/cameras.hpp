// SPDX-License-Identifier: Apache-2.0
// Pairs of cameras in every convention, and how far a place under the previous one may be off.
#pragma once

#include "hlsl_functions.hpp"
#include "inputs.hpp"
#include "projections.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace functions {

struct Convention {
    Projection projection;
    bool sharesY = false;
    std::map<std::string, int> defines() const {
        return {{"ORTHOGRAPHIC", projection.orthographic}, {"NDC_AND_UV_SHARE_Y", sharesY}};
    }
};

inline std::vector<Convention> conventions() {
    std::vector<Convention> all;
    for (const Projection& projection : projections())
        for (bool sharesY : {false, true})
            all.push_back({projection, sharesY});
    return all;
}

// Turned and moved a little between the frames, sometimes much; the previous projection may have zoomed.
struct CameraPair {
    oracle::Camera current, previous;
};

inline glm::dmat4 randomView(Random& random, double angle, double distance) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(random.in(-1, 1), 2.0, random.in(-1, 1)));
    const glm::dvec3 move(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    return glm::rotate(glm::dmat4(1.0), angle * random.in(-1, 1), axis) *
           glm::translate(glm::dmat4(1.0), distance * move);
}

inline CameraPair randomCameras(Random& random, const Projection& projection) {
    const bool cut = random.below(4) == 0;
    CameraPair pair;
    pair.current = {randomView(random, 3.0, 5.0), projection.matrix};
    pair.previous = {randomView(random, cut ? 3.0 : 0.05, cut ? 20.0 : 0.3) * pair.current.worldToView,
                     projection.matrix};
    if (random.below(2) == 0) {
        pair.previous.viewToClip[0][0] *= 1.1;
        pair.previous.viewToClip[1][1] *= 1.1;
    }
    return pair;
}

inline void push(Row& row, const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column)
        row.push_back(vec4(m[column]));
}

inline glm::dmat4 matrixOf(const Row& in) {
    return {dvec4(in[0]), dvec4(in[1]), dvec4(in[2]), dvec4(in[3])};
}

// Whether a place may come out on either side of the limit of eight images; y may run either way.
inline bool isAtLimit(dvec2 ndc, double bound) {
    bool at = false;
    for (const double extent : {std::abs(ndc.x), std::abs(ndc.y)})
        for (const double shift : {-0.5, 0.5})
            at = at || std::abs(0.5 * extent + shift - 8.0) <= bound;
    return at;
}

// The matrix is stored in binary32 and multiplied there: each component of the clip position errs by some ten
// roundings at the sum of its absolute products. `sizes` are what the point's coordinates were rounded at.
// Divided by w, that is what uv errs by. Where w is not clear of its own error, either answer is right.
inline Expected nearClip(const glm::dmat4& m, dvec4 point, dvec4 sizes, dvec2 uv) {
    dvec4 sums(0.0);
    for (int c = 0; c < 4; ++c)
        sums += glm::abs(m[c] * sizes[c]);
    const dvec4 clip = m * point, error = 12.0 * roundoff * sums;
    if (std::abs(clip.w) <= 2.0 * error.w) return finite();
    if (clip.w < 0.0) return near(uv, 0.0);
    const double ndc = std::max(std::abs(clip.x), std::abs(clip.y)) / clip.w;
    const double bound =
        (std::max(error.x, error.y) + ndc * error.w) / (clip.w - error.w) + divisionError * ndc;
    if (isAtLimit(dvec2(clip) / clip.w, bound + 32.0 * roundoff)) return finite();
    return near(uv, bound + 4.0 * roundoff * std::max(1.0, largest(dvec3(uv, 0.0))));
}

inline double randomDepth(Random& random, const Projection& projection) {
    const double far = std::isinf(projection.farM) ? 1e5 : projection.farM;
    return projection.nearM * std::pow(far / projection.nearM, random.unit());
}

// Rays at the upper left and the lower right corner; the shader goes linearly between them.
inline dvec4 viewRays(const Convention& convention) {
    const auto ray = [&](dvec2 uv) {
        return dvec2(
            oracle::viewPoint(oracle::uvToNdc(uv, convention.sharesY), 1.0, convention.projection.matrix));
    };
    return {ray({1, 1}) - ray({0, 0}), ray({0, 0})};
}

} // namespace functions
