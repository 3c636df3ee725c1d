// SPDX-License-Identifier: Apache-2.0
#include "ambient_occlusion.hpp"
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <set>

namespace functions {
namespace {

const std::string header = "reprise/sample_pattern.hlsli";

// Every pixel of a square, and of squares far out, to the contract's end.
std::vector<Row> pixels() {
    std::vector<Row> rows;
    for (const glm::ivec2 first : {glm::ivec2(0), {16367, 1021}, {4194288, 4194288}})
        for (int i = 0; i < 16 * 16; ++i)
            rows.push_back({vec4(first.x + i % 16, first.y + i / 16, 0, 0)});
    return rows;
}

Function call() {
    return {"pixelOffsets", {header}, "out0.xy = pixelOffsets(in0.xy);"};
}

// Sixteenths are exact.
Comparison offsets() {
    return {call(), pixels(), [](const Row& in) {
                const auto x = static_cast<int>(in[0].x), y = static_cast<int>(in[0].y);
                return std::vector{
                    near(dvec2(oracle::orderedOffset(x, y), oracle::orderedOffset(y + 1, x)), 0.0)};
            }};
}

TEST(SamplePattern, isAnOrderedDitherAndItsMirrorARowBelow) {
    expectAgrees(offsets());
}

TEST(SamplePattern, wrongDithersAreCaught) {
    const Comparison right = offsets();
    expectCaught(right, {header, "8.0 * isUnlike + 4.0 * fine.y", "8.0 * fine.y + 4.0 * isUnlike"});
    expectCaught(right, {header, "abs(coarse.x - coarse.y)", "coarse.x"});
    expectCaught(right, {header, "8.0 - 8.0 * isUnlike", "8.0 * isUnlike"});
    expectCaught(right, {header, "abs(coarse.y - fine.y)", "coarse.y"}); // no row below
    // The halves of what lies far out.
    expectCaught(right, {header, "floor(0.5 * pixel)", "floor(0.5 * fmod(pixel, 1024.0))"});
}

// Without the oracle: each of the sixteen once over any aligned 4x4, and a quarter at least between any two
// of an aligned 2x2, which for the second number begins a row lower.
std::string faults(const Mutation& mutation = {}) {
    const int side = 12;
    std::vector<Row> rows;
    for (int i = 0; i < side * side; ++i)
        rows.push_back({vec4(i % side, i / side, 0, 0)});
    const auto out = run(call(), rows, {.mutation = mutation});
    std::string found;
    for (int which = 0; which < 2; ++which) {
        const auto numbersOf = [&](int x, int y, int size) {
            std::multiset<float> numbers;
            for (int i = 0; i < size * size; ++i)
                numbers.insert(16.0f *
                               out[static_cast<size_t>(side * (y + i / size) + x + i % size)][0][which]);
            return numbers;
        };
        std::multiset<float> all;
        for (int k = 0; k < 16; ++k)
            all.insert(static_cast<float>(k));
        for (int y = 0; y + 4 <= side; y += 4)
            for (int x = 0; x + 4 <= side; x += 4)
                if (numbersOf(x, y, 4) != all) found += "not each once; ";
        for (int y = which; y + 2 <= side; y += 2)
            for (int x = 0; x + 2 <= side; x += 2) {
                float last = -4.0f;
                for (const float number : numbersOf(x, y, 2)) {
                    if (number - last < 4.0f) found += "closer than a quarter; ";
                    last = number;
                }
            }
    }
    return found;
}

TEST(SamplePattern, hasEachNumberOnceAndNeighboursFarApart) {
    EXPECT_EQ(faults(), "");
    EXPECT_NE(faults({header, "2.0 * abs(coarse.x - coarse.y) + coarse.y", "2.0 * coarse.x + coarse.x"}), "");
    // Each once, but neighbours close to each other: the coarse place counts most.
    EXPECT_NE(faults({header, "8.0 * isUnlike + 4.0 * fine.y + 2.0 * abs(coarse.x - coarse.y) + coarse.y",
                      "2.0 * isUnlike + fine.y + 8.0 * abs(coarse.x - coarse.y) + 4.0 * coarse.y"}),
              "");
    EXPECT_NE(
        faults({header, "8.0 - 8.0 * isUnlike + 4.0 * fine.x", "8.0 - 8.0 * isUnlike + 4.0 * isUnlike"}), "");
}

} // namespace
} // namespace functions
