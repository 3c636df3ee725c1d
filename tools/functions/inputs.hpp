// SPDX-License-Identifier: Apache-2.0
// Random and hostile inputs. The same on every machine: the standard's distributions are not.
#pragma once

#include "hlsl_functions.hpp"

#include <cmath>
#include <limits>
#include <random>

namespace functions {

inline constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
inline constexpr float infinity = std::numeric_limits<float>::infinity();
inline constexpr float denormal = 1e-40f;

class Random {
public:
    explicit Random(uint32_t seed) : engine_(seed) {}

    float unit() { return static_cast<float>(engine_() >> 8) * 0x1p-24f; } // [0, 1)
    float in(float low, float high) { return low + (high - low) * unit(); }
    size_t below(size_t count) { return engine_() % count; }
    // Every order of magnitude from 1e-4 to the largest binary16 as likely as another.
    float colourValue() { return std::min(std::exp(in(-9.2f, 11.09f)), 65504.0f); }
    vec4 colour() { return {colourValue(), colourValue(), colourValue(), 0.0f}; }
    vec4 in4(float low, float high) { return {in(low, high), in(low, high), in(low, high), in(low, high)}; }
    template <class List> auto of(const List& list) { return list[below(std::size(list))]; }

private:
    std::mt19937 engine_;
};

// Finite values at which something may break.
inline constexpr float hostileFinite[] = {0.0f, -0.0f,    denormal, -denormal, 1.17549435e-38f, 1e-7f, 0.5f,
                                          1.0f, 65504.0f, 65536.0f, -1.0f,     1e30f,           -1e30f};
// The colours among them.
inline constexpr float hostileColour[] = {0.0f, denormal,   1e-30f,     1e-7f,   0.2f,
                                          1.0f, 1.0000001f, 65503.996f, 65504.0f};
// All of them, with what a broken renderer can write.
inline constexpr float hostileAny[] = {0.0f,     -0.0f, denormal, -denormal, 1.0f,      -1.0f,     65504.0f,
                                       65520.0f, 1e30f, -1e30f,   infinity,  -infinity, notANumber};

// Every combination of the list in x, y and z.
template <class List> std::vector<Row> triples(const List& list) {
    std::vector<Row> rows;
    for (float x : list)
        for (float y : list)
            for (float z : list)
                rows.push_back({vec4(x, y, z, 0.0f)});
    return rows;
}

inline dvec3 xyz(const vec4& v) {
    return dvec3(v.x, v.y, v.z);
}
inline dvec2 xy(const vec4& v) {
    return dvec2(v.x, v.y);
}
inline double largest(dvec3 v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

// Denormals may be flushed to 0 by a GPU: no bound is tighter than what that costs.
inline constexpr double flush = 1.2e-38;

} // namespace functions
