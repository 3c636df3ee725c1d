// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

namespace functions {
namespace {

const std::string header = "reprise/finite.hlsli";

// Every value in every component, beside plain ones; the limit itself and what follows it.
std::vector<Row> values() {
    std::vector<float> all(std::begin(hostileAny), std::end(hostileAny));
    all.insert(all.end(), {1e38f, std::nextafter(1e38f, infinity), -1e38f, 3.4e38f, -3.4e38f});
    std::vector<Row> rows;
    for (float value : all)
        for (int component = 0; component < 4; ++component) {
            vec4 v(0.25f, -0.5f, 2.0f, -1e30f);
            v[component] = value;
            rows.push_back({v});
        }
    return rows;
}

bool isNumber(double v) {
    return std::abs(v) <= 1e38f; // the constant as binary32 holds it
}

bool areNumbers(const vec4& v, int components) {
    bool all = true;
    for (int c = 0; c < components; ++c)
        all = all && isNumber(v[c]);
    return all;
}

Comparison masks() {
    return {{"isNumber, numberMask",
             {header},
             "out0 = float4(isNumber(in0.x), isNumber(in0.xy), isNumber(in0), 0.0);\n"
             "out1 = numberMask(in0);",
             1,
             2},
            values(),
            [](const Row& in) {
                dvec4 mask;
                for (int c = 0; c < 4; ++c)
                    mask[c] = isNumber(in[0][c]);
                return std::vector{
                    near(dvec4(areNumbers(in[0], 1), areNumbers(in[0], 2), areNumbers(in[0], 4), 0.0), 0.0),
                    near(mask, 0.0)}; // 0 or 1, exact
            }};
}

Comparison repaired() {
    return {{"numberOrZero",
             {header},
             "out0 = float4(numberOrZero(in0.x), numberOrZero(in0.xy), 0.0); out1 = numberOrZero(in0);",
             1,
             2},
            values(),
            [](const Row& in) {
                const auto kept = [&](int components) {
                    return areNumbers(in[0], components) ? dvec4(in[0]) : dvec4(0.0);
                };
                // The value itself; a denormal may become 0.
                return std::vector{near(dvec4(kept(1).x, kept(2).x, kept(2).y, 0.0), flush),
                                   near(kept(4), flush)};
            }};
}

TEST(Finite, numbersAreToldFromNanAndInfinity) {
    expectAgrees(masks());
}

TEST(Finite, whatIsNoNumberBecomesZero) {
    expectAgrees(repaired());
}

TEST(Finite, testsThatNanPassesAreCaught) {
    expectCaught(masks(), {header, "bool isNumber(float v) {\n    return abs(v) <= LARGEST_NUMBER;",
                           "bool isNumber(float v) {\n    return !(abs(v) > LARGEST_NUMBER);"});
    expectCaught(masks(), {header, "return abs(v) <= LARGEST_NUMBER ? 1.0 : 0.0;",
                           "return abs(v) > LARGEST_NUMBER ? 0.0 : 1.0;"});
    expectCaught(repaired(), {header, "float4 numberOrZero(float4 v) {\n    return isNumber(v) ? v : 0.0;",
                              "float4 numberOrZero(float4 v) {\n    return v * numberMask(v);"});
}

TEST(Finite, limitThatLetsSumsOverflowIsCaught) {
    expectCaught(masks(), {header, "LARGEST_NUMBER = 1e38", "LARGEST_NUMBER = 3.4e38"});
}

} // namespace
} // namespace functions
