// SPDX-License-Identifier: Apache-2.0
// Errors between a picture and its reference. Pictures are display-linear RGB in [0,1], rows top to bottom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace report {

struct Picture {
    uint32_t width = 0, height = 0;
    std::vector<float> rgb; // 3 × width × height
};

// How many values are NaN or infinite. Every measure below takes finite pictures only: ask this first.
uint64_t countNotFinite(std::span<const float> values);

// FLIP for low dynamic range: P. Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
// 2020. The default viewing condition of the paper: 0.7 m from a 0.7 m wide display of 3840 pixels.
inline constexpr double flipPixelsPerDegree = 67.0206432766;

// What FLIP computes of one picture alone; the reference's is computed once and compared with every test.
struct FlipSide {
    uint32_t width = 0, height = 0;
    std::vector<float> lightness, a, b; // filtered by contrast sensitivity, Hunt-adjusted L*a*b*
    std::vector<float> edge, point;     // feature magnitudes
};
FlipSide flipSide(const Picture& picture, double pixelsPerDegree = flipPixelsPerDegree);
// FLIP per pixel, in [0,1]. Both sides have the same extent.
std::vector<float> flipMap(const FlipSide& reference, const FlipSide& test);
double flipMean(const FlipSide& reference, const FlipSide& test);

struct Difference {
    double rmse = 0.0;
    double max = 0.0;
};
// Over all values of two arrays of equal size.
Difference difference(std::span<const float> reference, std::span<const float> test);

// Flicker: root mean square over pixels, channels and frames of the change that the reference does not have.
class Flicker {
public:
    void add(std::span<const float> previousReference, std::span<const float> reference,
             std::span<const float> previousTest, std::span<const float> test);
    double value() const; // 0 before the first add

private:
    double sum_ = 0.0;
    uint64_t count_ = 0;
};

} // namespace report
