// SPDX-License-Identifier: Apache-2.0
// Every depth kind as a matrix, written out: view z forward, NDC y up, depth in [0, 1].
#pragma once

#include "oracle.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace functions {

struct Projection {
    std::string name;
    glm::dmat4 matrix{0.0};
    double nearM = 0.0, farM = 0.0;
    bool orthographic = false, reversed = false;
};

// device = (a z + b) / z, with the given values at the near and at the far plane. `shift` moves the centre,
// as an asymmetric frustum does.
inline Projection perspective(std::string name, double nearM, double farM, bool reversed,
                              glm::dvec2 shift = {0, 0}) {
    Projection made{std::move(name), glm::dmat4(0.0), nearM, farM, false, reversed};
    const double atNear = reversed ? 1.0 : 0.0, atFar = reversed ? 0.0 : 1.0;
    const bool infinite = std::isinf(farM);
    const double a = infinite ? atFar : (atFar * farM - atNear * nearM) / (farM - nearM);
    glm::dmat4& m = made.matrix;
    m[0][0] = 1.2;
    m[1][1] = 1.9;
    m[2] = {shift, a, 1.0};
    m[3][2] = (atNear - a) * nearM;
    return made;
}

inline Projection orthographic(std::string name, double nearM, double farM, bool reversed) {
    Projection made{std::move(name), glm::dmat4(0.0), nearM, farM, true, reversed};
    const double sign = reversed ? -1.0 : 1.0;
    glm::dmat4& m = made.matrix;
    m[0][0] = 0.05;
    m[1][1] = 0.08;
    m[2][2] = sign / (farM - nearM);
    m[3] = {0.1, -0.2, reversed ? farM / (farM - nearM) : -nearM / (farM - nearM), 1.0};
    return made;
}

inline std::vector<Projection> projections() {
    const double none = std::numeric_limits<double>::infinity();
    return {perspective("standard", 0.1, 1000.0, false),
            perspective("reversed", 0.1, 1000.0, true),
            perspective("standard infinite", 0.1, none, false),
            perspective("reversed infinite", 0.1, none, true),
            perspective("reversed, off centre", 0.5, 200.0, true, {0.3, -0.15}),
            orthographic("orthographic", 1.0, 100.0, false),
            orthographic("orthographic reversed", 1.0, 100.0, true)};
}

// The contract's two numbers: linear = 1 / (device x + y) in perspective, device x + y in orthographic.
inline glm::dvec2 linearDepthCoefficients(const Projection& projection) {
    const glm::dmat4& m = projection.matrix;
    if (projection.orthographic) return {1.0 / m[2][2], -m[3][2] / m[2][2]};
    return {1.0 / m[3][2], -m[2][2] / m[3][2]};
}

} // namespace functions
