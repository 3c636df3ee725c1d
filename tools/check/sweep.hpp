// SPDX-License-Identifier: Apache-2.0
// Logarithmic grids and special values, of which the sweeps are made.
#pragma once

#include "check.hpp"
#include "inputs.hpp"
#include "oracle.hpp"

#include <cmath>

namespace check {

using functions::divisionError;
using functions::infinity;
using functions::largest;
using functions::notANumber;
using functions::Random;
using functions::roundoff;
using functions::triples;
using functions::xy;
using functions::xyz;

inline constexpr double unbounded = std::numeric_limits<double>::infinity();
// The smallest number that is no denormal.
inline constexpr double smallestNormal = 0x1p-126;

inline std::vector<float> logarithmic(double low, double high, size_t count) {
    std::vector<float> values;
    for (size_t i = 0; i < count; ++i)
        values.push_back(static_cast<float>(
            low * std::pow(high / low, static_cast<double>(i) / static_cast<double>(count - 1))));
    return values;
}

template <class T> std::vector<T> operator+(std::vector<T> a, const std::vector<T>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

inline std::vector<float> ofBothSigns(const std::vector<float>& values) {
    std::vector<float> all = values;
    for (float value : values)
        all.push_back(-value);
    return all;
}

// 2^-first ... 2^-last
inline std::vector<float> powersOfHalf(int first, int last) {
    std::vector<float> values;
    for (int k = first; k <= last; ++k)
        values.push_back(std::ldexp(1.0f, -k));
    return values;
}

// 0, 1, 2^-k and 1 - 2^-k.
inline std::vector<float> weights() {
    std::vector<float> all{0.0f, 1.0f};
    for (float share : powersOfHalf(1, 24)) {
        all.push_back(share);
        all.push_back(1.0f - share);
    }
    return all;
}

// As the headers count them: neither NaN nor beyond 1e38.
inline bool isNumber(double v) {
    return std::abs(v) <= 1e38;
}

inline bool areNumbers(const vec4& v, int components) {
    for (int c = 0; c < components; ++c)
        if (!isNumber(v[c])) return false;
    return true;
}

// 0, denormals, what binary16 holds least, the ends of the colours.
inline const std::vector<float> colourMarks = {
    0.0f, 1e-40f, 1.17549435e-38f, 1e-30f, 1e-20f,  5.9604645e-8f, 6.1035156e-5f,
    0.2f, 1.0f,   1.0000001f,      2.0f,   1000.0f, 65503.996f,    65504.0f};
// Beyond: negative, and more than a colour may have.
inline const std::vector<float> beyondMarks =
    ofBothSigns({0.0f, 1e-40f, 1e-30f, 1e-7f, 1.0f, 65504.0f, 65520.0f, 1e30f});

inline std::vector<float> colourValues(const Effort& effort) {
    return colourMarks + logarithmic(1e-6, 65504.0, effort.quick ? 6 : 26);
}

// Either sign, every order of magnitude from 1e-30 to 1e30 as likely as another.
inline float anyValue(Random& random) {
    const float value = static_cast<float>(std::pow(10.0, random.in(-30.0f, 30.0f)));
    return random.below(2) == 0 ? value : -value;
}

inline vec4 anyColour(Random& random) {
    return {anyValue(random), anyValue(random), anyValue(random), 0.0f};
}

// Every combination of three colour values, and random ones.
inline std::vector<Row> colours(const Effort& effort, uint32_t seed) {
    std::vector<Row> rows = triples(colourValues(effort));
    Random random(seed);
    for (size_t i = 0; i < effort.of(20000); ++i)
        rows.push_back({random.colour()});
    return rows;
}

// Of either sign, up to 1e30.
inline std::vector<Row> beyondColours(const Effort& effort, uint32_t seed) {
    std::vector<Row> rows = triples(beyondMarks);
    Random random(seed);
    for (size_t i = 0; i < effort.of(20000); ++i)
        rows.push_back({anyColour(random)});
    return rows;
}

} // namespace check
