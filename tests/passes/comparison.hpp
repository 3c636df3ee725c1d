// SPDX-License-Identifier: Apache-2.0
// A whole output image against expected values, each with a bound of its own.
#pragma once

#include "bench.hpp"

namespace passes {

struct Expected {
    glm::dvec3 value{0.0};
    glm::dvec3 bound{0.0};
};

// Expected value of a pixel, first with the bound that is cheap to have; where it does not suffice, with the
// one that is worth its time.
using ExpectedAt = std::function<Expected(int x, int y, bool careful)>;

struct Comparison {
    size_t pixels = 0, outside = 0;
    double largestExcess = 0.0; // |got - expected| / bound of the worst pixel outside
    std::string worst;          // that pixel in words
    double largestError = 0.0;  // |got - expected| of all pixels whose bound is below 1e6
    double boundThere = 0.0;    // the bound of that value

    bool holds() const { return pixels > 0 && outside == 0; }
};

// Joins the comparison of another image, whose worst pixel is called by `name`.
void join(Comparison& all, const Comparison& other, std::string_view name);
Comparison compare(const Pixels& got, const ExpectedAt& expectedAt, int channels);
std::string text(const Comparison& comparison);

} // namespace passes
