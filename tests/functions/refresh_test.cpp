// SPDX-License-Identifier: Apache-2.0
#include "function_runner.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace functions {
namespace {

using glm::ivec2;

const std::string header = "reprise/refresh.hlsli";

// One way to form groups. in0 is (position, frame, n), in1 (tile, block, height).
struct Scheme {
    std::string name, group;
};

const Scheme schemes[] = {{"sequence", "groupOfBand(in0.xy, in1.w, in0.w)"},
                          {"tiled", "groupOfTile(in0.xy, in1.xy)"},
                          {"random blocks", "groupOfBlock(in0.xy, in1.z, in1.xy)"}};

struct Period {
    int n;
    ivec2 tile;
};

const Period periods[] = {{1, {1, 1}}, {2, {2, 1}}, {2, {1, 2}}, {3, {3, 1}},
                          {4, {2, 2}}, {8, {4, 2}}, {9, {3, 3}}, {16, {4, 4}}};
const ivec2 sizes[] = {{1, 1}, {7, 5}, {33, 17}};

Function refreshing(const Scheme& scheme) {
    return {scheme.name,
            {header},
            "float group = " + scheme.group +
                "; out0.x = group; out0.y = isRefreshed(group, in0.z, in0.w) ? 1.0 : 0.0;",
            2};
}

Row pixelRow(ivec2 pixel, double frame, const Period& period, ivec2 size, float blockSize = 2.0f) {
    return {vec4(pixel.x + 0.5, pixel.y + 0.5, frame, period.n),
            vec4(glm::vec2(period.tile), blockSize, size.y)};
}

// How often each pixel is computed anew in `frames` frames from `first` on, the frame wrapped as the CPU
// does.
std::vector<int> refreshCounts(const Scheme& scheme, const Period& period, ivec2 size, double first,
                               int frames, double wrap, const Mutation& mutation = {}) {
    std::vector<Row> rows;
    for (int frame = 0; frame < frames; ++frame)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                rows.push_back(pixelRow({x, y}, std::fmod(first + frame, wrap), period, size));
    const auto out = run(refreshing(scheme), rows, {.mutation = mutation});
    const size_t pixels = static_cast<size_t>(size.x * size.y);
    std::vector<int> counts(pixels, 0);
    for (size_t i = 0; i < out.size(); ++i)
        counts[i % pixels] += out[i][0].y == 1.0f ? 1 : 0;
    return counts;
}

bool allOnce(const std::vector<int>& counts) {
    return std::all_of(counts.begin(), counts.end(), [](int count) { return count == 1; });
}

// A multiple of every n up to 16, as the header says.
const double wrapAt = 720720.0;

TEST(Refresh, everyTexelIsComputedOnceInNFrames) {
    for (const Scheme& scheme : schemes)
        for (const Period& period : periods)
            for (ivec2 size : sizes)
                for (double first : {0.0, 5.0, wrapAt - 3.0})
                    EXPECT_TRUE(allOnce(refreshCounts(scheme, period, size, first, period.n, wrapAt)))
                        << scheme.name << ", n " << period.n << ", " << size.x << "x" << size.y
                        << " from frame " << first;
}

TEST(Refresh, wrapIsAMultipleOfEveryPeriodUpToSixteen) {
    for (int n = 1; n <= 16; ++n)
        EXPECT_EQ(std::fmod(wrapAt, n), 0.0) << n;
    EXPECT_NE(hlslText(header).find("720720"), std::string::npos);
}

// From 2^24 on a binary32 does not hold every frame, and the guarantee is gone: hence the wrap.
TEST(Refresh, frameBeyondTheRangeIsCaught) {
    const Scheme& tiled = schemes[1];
    const Period four = periods[4];
    EXPECT_TRUE(allOnce(refreshCounts(tiled, four, {7, 5}, 16777216.0 - 8.0, 4, 1e9)));
    EXPECT_FALSE(allOnce(refreshCounts(tiled, four, {7, 5}, 16777216.0, 4, 1e9)));
    EXPECT_TRUE(allOnce(refreshCounts(tiled, four, {7, 5}, 16777216.0, 4, wrapAt)));
    // A wrap that is no multiple of n loses or repeats pixels.
    EXPECT_FALSE(allOnce(refreshCounts(tiled, periods[6], {7, 5}, 65536.0 - 3.0, 9, 65536.0)));
}

// Of every whole n and every a up to the limit, whatever the division rounds to.
Comparison modulo() {
    Random random(1);
    std::vector<Row> rows;
    for (int i = 0; i < 6000; ++i) {
        const int n =
            i % 2 == 0 ? 1 + static_cast<int>(random.below(32)) : 1 + static_cast<int>(random.below(4096));
        const int a = static_cast<int>(random.below(i % 3 == 0 ? 1000 : 16777216));
        rows.push_back({vec4(i % 5 == 0 ? a / n * n : a, n, 0, 0)});
        rows.push_back({vec4(-std::min(a, 16777215), n, 0, 0)});
    }
    return {{"wholeModulo", {header}, "out0.x = wholeModulo(in0.x, in0.y);", 1}, rows, [](const Row& in) {
                const auto a = static_cast<int64_t>(in[0].x), n = static_cast<int64_t>(in[0].y);
                return std::vector{near(static_cast<double>((a % n + n) % n), 0.0)};
            }};
}

TEST(Refresh, moduloIsExactUpToTwoToThe24) {
    expectAgrees(modulo());
}

// lavapipe divides exactly; a device whose quotient is a step too small or too large is played here.
TEST(Refresh, moduloSurvivesADivisionThatIsNotExact) {
    for (const char* quotient : {"floor(a / n * 0.9999999)", "floor(a / n * 1.0000001)"})
        EXPECT_EQ(mismatches(modulo(), {header, "floor(a / n)", quotient}), "") << quotient;
    expectCaught(modulo(), {header,
                            "    remainder = remainder < 0.0 ? remainder + n : remainder;\n"
                            "    remainder = remainder >= n ? remainder - n : remainder;\n"
                            "    return",
                            "    remainder = a - n * floor(a / n * 0.9999999);\n    return"});
    // As fmod does: what is left of a negative number is negative.
    expectCaught(modulo(), {header, "    float remainder = a - n * floor(a / n);",
                            "    return a - n * trunc(a / n);\n    float remainder = 0.0;"});
}

TEST(Refresh, groupsAgreeWithIntegers) {
    for (const Period& period : periods)
        for (ivec2 size : sizes) {
            std::vector<Row> rows;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x)
                    rows.push_back(pixelRow({x, y}, 3 * x + y, period, size));
            const auto pixelOf = [](const Row& in) { return ivec2(glm::floor(xy(in[0]))); };
            expectAgrees(
                {refreshing(schemes[0]), rows, [&](const Row& in) {
                     const int64_t n = static_cast<int64_t>(in[0].w);
                     const int64_t group =
                         oracle::groupOfBand(pixelOf(in).y, static_cast<int64_t>(in[1].w), n);
                     return std::vector{near(
                         dvec2(group, oracle::isRefreshed(group, static_cast<int64_t>(in[0].z), n)), 0.0)};
                 }});
            expectAgrees(
                {refreshing(schemes[1]), rows, [&](const Row& in) {
                     const int64_t n = static_cast<int64_t>(in[0].w);
                     const int64_t group = oracle::groupOfTile(pixelOf(in), ivec2(in[1].x, in[1].y));
                     return std::vector{near(
                         dvec2(group, oracle::isRefreshed(group, static_cast<int64_t>(in[0].z), n)), 0.0)};
                 }});
        }
}

// The slide's own tile.
TEST(Refresh, tileOfFourIsThatOfTheSlide) {
    std::vector<Row> rows;
    for (int i = 0; i < 4; ++i)
        rows.push_back(pixelRow({10 + i % 2, 6 + i / 2}, 0, periods[4], {33, 17}));
    const auto out = run(refreshing(schemes[1]), rows);
    for (size_t i = 0; i < 4; ++i)
        EXPECT_EQ(out[i][0].x, static_cast<float>(i));
}

std::vector<float> blockGroups(const Period& period, ivec2 size, float blockSize) {
    std::vector<Row> rows;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            rows.push_back(pixelRow({x, y}, 0, period, size, blockSize));
    std::vector<float> groups;
    for (const Row& out : run(refreshing(schemes[2]), rows))
        groups.push_back(out[0].x);
    return groups;
}

// Blocks are at least 2x2, whatever is asked; a tile of blocks holds each group once; tiles differ.
TEST(Refresh, blocksAreWholeAndTilesHoldEachGroupOnce) {
    for (const Period& period : periods)
        for (float blockSize : {0.0f, 1.0f, 2.0f, 3.0f}) {
            const int side = std::max(static_cast<int>(blockSize), 2);
            const ivec2 tiles(5, 4), size = tiles * period.tile * side;
            const auto groups = blockGroups(period, size, blockSize);
            const auto at = [&](ivec2 pixel) {
                return groups[static_cast<size_t>(pixel.y * size.x + pixel.x)];
            };
            std::set<std::vector<float>> permutations;
            for (int tile = 0; tile < tiles.x * tiles.y; ++tile) {
                const ivec2 corner = ivec2(tile % tiles.x, tile / tiles.x) * period.tile * side;
                std::vector<float> own;
                for (int block = 0; block < period.n; ++block) {
                    const ivec2 first = corner + ivec2(block % period.tile.x, block / period.tile.x) * side;
                    own.push_back(at(first));
                    for (int inside = 0; inside < side * side; ++inside)
                        ASSERT_EQ(at(first + ivec2(inside % side, inside / side)), own.back());
                }
                permutations.insert(own);
                std::sort(own.begin(), own.end());
                for (int group = 0; group < period.n; ++group)
                    ASSERT_EQ(own[static_cast<size_t>(group)], static_cast<float>(group)) << "n " << period.n;
            }
            // 20 tiles draw from 2, 4 or many orders.
            const size_t orders = period.n == 1   ? 1
                                  : period.n == 2 ? 2
                                  : period.n == 3 ? 3
                                  : period.n == 4 ? 6
                                                  : 15;
            EXPECT_GE(permutations.size(), orders) << "n " << period.n;
        }
}

TEST(Refresh, wrongGroupsAreCaught) {
    const auto isWhole = [](const Mutation& mutation) {
        return allOnce(refreshCounts(schemes[2], periods[6], {33, 17}, 0.0, 9, wrapAt, mutation));
    };
    ASSERT_TRUE(isWhole({}));
    // The naive forms: a group drawn anew in every frame, and a frame compared instead of counted.
    const std::string rule = "wholeModulo(frame + group, wholePeriod(n)) < 0.5";
    EXPECT_FALSE(isWhole(
        {header, rule, "wholeModulo(wholeModulo((34.0 * frame + 1.0) * (group + frame), 289.0), n) < 0.5"}));
    EXPECT_FALSE(isWhole({header, rule, "wholeModulo(frame, wholePeriod(n)) <= group"}));
}

TEST(Refresh, groupsThatCostUnevenlyAreCaught) {
    const auto frameCosts = [](const Mutation& mutation) {
        std::vector<Row> rows;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x)
                rows.push_back(pixelRow({x, y}, 0, periods[6], {24, 24}));
        std::vector<int> costs(9, 0);
        for (const Row& out : run(refreshing(schemes[2]), rows, {.mutation = mutation}))
            ++costs[static_cast<size_t>(out[0].x)];
        return std::set<int>(costs.begin(), costs.end());
    };
    EXPECT_EQ(frameCosts({}), std::set<int>{64}); // 24 · 24 / 9
    // A hash alone keeps the guarantee, but not the cost of a frame.
    EXPECT_NE(frameCosts({header, "return x + size.x * y;",
                          "return wholeModulo(scrambled(block, 0.0), size.x * size.y);"}),
              std::set<int>{64});
    EXPECT_NE(frameCosts({header, "scrambled(tile, size.y + x)", "scrambled(tile, place.x)"}),
              std::set<int>{64});
}

// n of a pixel that changes: within the least common multiple of its values, here the largest power of 2.
TEST(Refresh, pixelWhosePeriodChangesIsComputedWithinTheLargestPowerOfTwo) {
    Random random(2);
    const float values[] = {1.0f, 2.0f, 4.0f, 8.0f, 16.0f};
    std::vector<Row> rows;
    for (int pixel = 0; pixel < 200; ++pixel)
        for (int frame = 0; frame < 16; ++frame) {
            Row row = pixelRow({pixel, pixel / 7}, frame, periods[7], {33, 17});
            row[0].w = random.of(values);
            rows.push_back(row);
        }
    const auto out = run(refreshing(schemes[2]), rows);
    for (size_t pixel = 0; pixel < 200; ++pixel) {
        int count = 0;
        for (size_t frame = 0; frame < 16; ++frame)
            count += out[16 * pixel + frame][0].y == 1.0f ? 1 : 0;
        EXPECT_GE(count, 1) << pixel;
    }
}

TEST(Refresh, hostileInputsGiveNumbers) {
    Random random(3);
    std::vector<float> values(std::begin(hostileFinite), std::end(hostileFinite));
    values.insert(values.end(), {3.4e38f, -3.4e38f, 16777216.0f});
    std::vector<Row> rows;
    for (int i = 0; i < 1000; ++i)
        rows.push_back({vec4(random.of(values), random.of(values), random.of(values), random.of(values)),
                        vec4(random.of(values), random.of(values), random.of(values), random.of(values))});
    for (const Scheme& scheme : schemes)
        expectAgrees({refreshing(scheme), rows, [](const Row&) { return std::vector{finite()}; }});
    // A period below 1 or none at all means every frame.
    const auto out = run(refreshing(schemes[1]), {pixelRow({3, 4}, 7, {0, {1, 1}}, {7, 5})});
    EXPECT_EQ(out[0][0].y, 1.0f);
}

} // namespace
} // namespace functions
