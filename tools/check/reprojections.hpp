// SPDX-License-Identifier: Apache-2.0
// Places under cameras that moved, over stiff projections, and how exactly a function can give them.
#pragma once

#include "cameras.hpp"
#include "check.hpp"

#include <memory>

namespace check {

// Three roundings and a reciprocal at the size of NDC or of 1. Denormals may be taken for 0, which matters
// where they are divided by each other.
inline constexpr double clipRoundings = 8.0;
Right clipRight(dvec4 clip, bool sharesY);

struct MovedCamera {
    functions::Projection projection;
    oracle::Camera current, previous;
};

struct Reprojections {
    std::vector<MovedCamera> cameras;
    std::vector<Row> rows; // in0 to in3 the matrix, in4 (uv, depth, number of the camera), in5 the view rays
};

// Depths over each projection, device depths or linear ones; no view rays if device depths.
std::shared_ptr<Reprojections> reprojections(const std::vector<functions::Projection>& projections,
                                             const Effort& effort, bool device);

// A matrix of binary32 and its product, at the sums of the absolute products, over w.
inline constexpr double matrixRoundings = 12.0;
Right placeFromDevice(const Row& in, const MovedCamera& camera);
Right placeFromLinear(const Row& in, const MovedCamera& camera);
// The sums themselves of the clip position of a row of linear depth: what its components are rounded at.
dvec4 clipSizes(const Row& in, const MovedCamera& camera);

} // namespace check
