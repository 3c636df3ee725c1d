// SPDX-License-Identifier: Apache-2.0
#include "hlsl_functions.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace functions {

namespace {

constexpr float unbounded = std::numeric_limits<float>::infinity();

std::string formatted(const vec4& v) {
    std::ostringstream text;
    text.precision(9);
    text << "(" << v.x << ", " << v.y << ", " << v.z << ", " << v.w << ")";
    return text.str();
}

bool agrees(float actual, double expected, double bound) {
    if (bound == std::numeric_limits<double>::infinity()) return std::isfinite(actual);
    if (std::isnan(bound)) return true;
    return std::abs(static_cast<double>(actual) - expected) <= bound; // false for NaN
}

// What is wrong with one row, or nothing.
std::string mismatch(const std::vector<Expected>& expected, const Row& outputs) {
    std::ostringstream text;
    text.precision(12);
    for (size_t i = 0; i < expected.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const double value = expected[i].value[c], bound = expected[i].bound[c];
            if (agrees(outputs[i][c], value, bound)) continue;
            text << "\n    out" << i << "."
                 << "xyzw"[c] << " is " << outputs[i][c] << ", the oracle says " << value << " within "
                 << bound;
        }
    return text.str();
}

} // namespace

Expected near(dvec4 value, double bound) {
    return {value, dvec4(bound)};
}

Expected near(dvec3 value, dvec3 bound) {
    return {dvec4(value, 0.0), dvec4(bound, std::numeric_limits<double>::quiet_NaN())};
}

Expected near(dvec3 value, double bound) {
    return near(value, dvec3(bound));
}

Expected near(dvec2 value, double bound) {
    constexpr double any = std::numeric_limits<double>::quiet_NaN();
    return {dvec4(value, 0.0, 0.0), dvec4(bound, bound, any, any)};
}

Expected near(double value, double bound) {
    constexpr double any = std::numeric_limits<double>::quiet_NaN();
    return {dvec4(value, 0.0, 0.0, 0.0), dvec4(bound, any, any, any)};
}

Expected finite() {
    return {dvec4(0.0), dvec4(unbounded)};
}

std::string mismatches(const Bench& bench, const Comparison& comparison, const Mutation& mutation) {
    const Function& function = comparison.function;
    const std::vector<Row> outputs = run(bench, function, comparison.inputs, {.mutation = mutation});
    size_t wrong = 0;
    std::string first;
    for (size_t row = 0; row < outputs.size(); ++row) {
        const std::string text = mismatch(comparison.oracle(comparison.inputs[row]), outputs[row]);
        if (text.empty() || ++wrong > 3) continue;
        first += "\n  row " + std::to_string(row) + ":";
        for (const vec4& in : comparison.inputs[row])
            first += " " + formatted(in);
        first += text;
    }
    if (wrong == 0) return "";
    return function.name + ": " + std::to_string(wrong) + " of " + std::to_string(outputs.size()) +
           " rows differ" + first;
}

} // namespace functions
