// SPDX-License-Identifier: Apache-2.0
// Counts errors.
#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace check {
namespace {

constexpr double smallestNormal = 0x1p-126, flushed = 4.0 * smallestNormal;
constexpr double unbounded = std::numeric_limits<double>::infinity();

double stepAt(double value) {
    return std::ldexp(1.0, std::max(std::ilogb(std::max(std::abs(value), smallestNormal)), -126) - 23);
}

double allowed(const Bound& bound, double expected, double size) {
    switch (bound.unit) {
    case Unit::exact:
        return 0.0;
    case Unit::absolute:
        return bound.value;
    case Unit::relative:
        return bound.value * std::abs(expected);
    case Unit::ulp:
        return bound.value * stepAt(expected);
    case Unit::roundings:
        return bound.value * functions::roundoff * size;
    case Unit::finite:
        break;
    }
    return unbounded;
}

void keep(Worst& worst, double value, const Row& input, float actual, double expected) {
    if (value > worst.value || (worst.input.empty() && value >= worst.value))
        worst = {value, expected, actual, input};
}

// One finite value.
void count(Tally& tally, const Bound& bound, const Row& input, float actual, double expected, double size) {
    double error = std::abs(static_cast<double>(actual) - expected);
    if (error <= flushed) error = 0.0;
    keep(tally.absolute, error, input, actual, expected);
    if (std::abs(expected) >= smallestNormal) {
        keep(tally.relative, error / std::abs(expected), input, actual, expected);
        keep(tally.ulp, error / stepAt(expected), input, actual, expected);
    }
    const double most = allowed(bound, expected, size);
    keep(tally.share, error == 0.0 ? 0.0 : error / most, input, actual, expected);
}

} // namespace

double ulpDistance(float actual, double expected) {
    return std::abs(static_cast<double>(actual) - expected) / stepAt(expected);
}

Tally tally(const std::vector<Row>& inputs, const std::vector<Row>& outputs, const Oracle& oracle,
            const Bound& bound) {
    Tally result;
    result.inputs = inputs.size();
    for (size_t row = 0; row < inputs.size(); ++row) {
        const std::vector<Right> rights = oracle(inputs[row]);
        bool isNaN = false, isInfinite = false, isOpen = false;
        for (size_t output = 0; output < rights.size(); ++output)
            for (int c = 0; c < rights[output].components; ++c) {
                const float actual = outputs[row][output][c];
                const double expected = rights[output].value[c], size = rights[output].size[c];
                if (!std::isfinite(expected))
                    throw std::runtime_error("the oracle itself is not finite for an input of a sweep");
                isNaN = isNaN || std::isnan(actual);
                isInfinite = isInfinite || std::isinf(actual);
                isOpen = isOpen || size == unbounded;
                if (std::isfinite(actual) && size != unbounded && bound.unit != Unit::finite)
                    count(result, bound, inputs[row], actual, expected, size);
            }
        result.nan += isNaN;
        result.infinity += isInfinite;
        result.open += isOpen;
        if ((isNaN || isInfinite) && result.firstNotFinite.empty()) result.firstNotFinite = inputs[row];
    }
    return result;
}

Right right(double value, double size) {
    return {dvec4(value, 0.0, 0.0, 0.0), dvec4(size), 1};
}

Right right(dvec2 value, double size) {
    return {dvec4(value, 0.0, 0.0), dvec4(size), 2};
}

Right right(dvec3 value, double size) {
    return {dvec4(value, 0.0), dvec4(size), 3};
}

Right right(dvec3 value, dvec3 size) {
    return {dvec4(value, 0.0), dvec4(size, 0.0), 3};
}

Right right(dvec4 value, double size) {
    return {value, dvec4(size), 4};
}

Right open(int components) {
    return {dvec4(0.0), dvec4(unbounded), components};
}

} // namespace check
