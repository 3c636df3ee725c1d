// SPDX-License-Identifier: Apache-2.0
// miss_detection.hlsli and refresh.hlsli.
#include "cases.hpp"
#include "stiff_projections.hpp"
#include "sweep.hpp"

namespace check {
namespace {

using Defines = std::map<std::string, int>;
using functions::Projection;
using oracle::DepthFormat;

const std::string misses = "reprise/miss_detection.hlsli", refresh = "reprise/refresh.hlsli";

// --- accuracy of depth

struct Storage {
    std::string name, constant;
    DepthFormat format;
};

const Storage storages[] = {{"float32", "DEPTH_ROUNDING_FLOAT32", DepthFormat::float32},
                            {"unorm24", "DEPTH_ROUNDING_UNORM24", DepthFormat::unorm24},
                            {"unorm16", "DEPTH_ROUNDING_UNORM16", DepthFormat::unorm16}};

// What it is for: a depth that is stored and read again is no farther off. in0 is (linear depth, device depth
// as stored, coefficients).
Case storedDepth(const std::string& kind, const std::vector<Projection>& projections,
                 const Storage& storage) {
    return {kind + ", " + storage.name + ", 1e-4 to 1e7 m: farther off",
            {"linearDepthError",
             {misses},
             "float error = linearDepthError(in0.x, in0.zw, " + storage.constant +
                 ");\n"
                 "out0.x = max(abs(linearDepthFromDevice(in0.y, in0.zw) - in0.x) - error, 0.0);",
             1,
             1,
             Defines{{"ORTHOGRAPHIC", projections.front().orthographic}}},
            {Unit::exact, 0.0, "the error is an upper bound"},
            [projections, storage](const Effort& effort) {
                std::vector<Row> rows;
                for (const Projection& projection : projections)
                    for (double linear : depthsOf(projection, effort.of(4000))) {
                        const float depth = static_cast<float>(linear);
                        const double device = oracle::deviceDepth(depth, projection.matrix);
                        rows.push_back({vec4(depth, oracle::storedDepth(device, storage.format),
                                             linearDepthCoefficients(projection))});
                    }
                return Sweep{rows, [](const Row&) { return std::vector{right(0.0)}; }};
            }};
}

Case anyDepth(const std::string& function, const std::string& body, bool orthographic) {
    return {std::string(orthographic ? "orthographic" : "perspective") + ", all to ±1e30",
            {function, {misses}, body, 2, 1, Defines{{"ORTHOGRAPHIC", orthographic}}},
            {Unit::finite, 0.0, "1e38 where a depth cannot be told from infinity"},
            [](const Effort& effort) {
                Random random(1);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(40000); ++i)
                    rows.push_back(
                        {vec4(anyValue(random), random.of(beyondMarks), anyValue(random), anyValue(random)),
                         vec4(anyValue(random), random.of(beyondMarks), 0, 0)});
                return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
            }};
}

// --- hits

// in0 is (uv, last depth, cache depth), in1 (threshold, object, cached object).
std::vector<Row> places(const Effort& effort) {
    Random random(2);
    const float broken[] = {notANumber, infinity, -infinity, 1e30f, -1e30f, 0.0f};
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float last = std::exp2(random.in(-13.3f, 23.2f));
        const float threshold = last * std::exp2(random.in(-24.0f, 1.0f));
        Row row{vec4(random.in(-0.1f, 1.1f), random.in(-0.1f, 1.1f), last,
                     last + threshold * random.in(-2.0f, 2.0f)),
                vec4(threshold, random.below(3), random.below(3), 0)};
        if (i % 4 == 0) row[0].x = random.of(std::vector{0.0f, 1.0f, 1.0000001f, -1e-7f, -8.0f});
        if (i % 5 == 0) row[0][static_cast<int>(random.below(4))] = random.of(broken);
        if (i % 7 == 0) row[1] = vec4(random.of(broken), 8388607.0f, random.of(broken), 0);
        rows.push_back(row);
    }
    return rows;
}

// One difference is rounded, at itself; a place may round onto the border.
bool isDecided(double a, double b, double threshold) {
    const double difference = std::abs(a - b);
    return !(std::abs(difference - threshold) <= 2.0 * roundoff * difference);
}

bool isDecided(dvec2 uv) {
    for (int axis = 0; axis < 2; ++axis)
        for (const double edge : {0.0, 1.0})
            if (uv[axis] != edge && std::abs(uv[axis] - edge) <= 0x1p-25) return false;
    return true;
}

Right decision(bool yes, bool decided) {
    return decided ? right(yes ? 1.0 : 0.0) : open(1);
}

std::vector<Right> hitOracle(const Row& in) {
    const bool decided = isDecided(xy(in[0])) && isDecided(in[0].z, in[0].w, in[1].x);
    const bool hit = oracle::isCacheHit(xy(in[0]), in[0].z, in[0].w, in[1].x);
    const bool same = std::abs(static_cast<double>(in[1].y) - in[1].z) < 0.5;
    return {decision(hit, decided), decision(hit && same, decided)};
}

std::vector<Case> hits() {
    return {{"depth 1e-4 to 1e7 m, NaN and infinity too",
             {"isCacheHit",
              {misses},
              "out0.x = isCacheHit(in0.xy, in0.z, in0.w, in1.x) ? 1.0 : 0.0;\n"
              "out1.x = isCacheHit(in0.xy, in0.z, in0.w, in1.x, in1.y, in1.z) ? 1.0 : 0.0;",
              2,
              2},
             {Unit::exact, 0.0, "decisions; open within a rounding of the threshold or of the border"},
             [](const Effort& effort) {
                 return Sweep{places(effort), hitOracle};
             }},
            {"depth 1e-4 to 1e7 m, NaN and infinity too",
             {"isSameDepth", {misses}, "out0.x = isSameDepth(in0.z, in0.w, in1.x) ? 1.0 : 0.0;", 2},
             {Unit::exact, 0.0, "a decision; open within a rounding of the threshold"},
             [](const Effort& effort) {
                 return Sweep{places(effort), [](const Row& in) {
                                  return std::vector{
                                      decision(std::abs(static_cast<double>(in[0].z) - in[0].w) < in[1].x,
                                               isDecided(in[0].z, in[0].w, in[1].x))};
                              }};
             }},
            {"IDs to 2^23, NaN and infinity too",
             {"isSameObject", {misses}, "out0.x = isSameObject(in1.y, in1.z) ? 1.0 : 0.0;", 2},
             {Unit::exact, 0.0, "a decision between whole numbers"},
             [](const Effort& effort) {
                 return Sweep{places(effort), [](const Row& in) {
                                  return std::vector{
                                      decision(std::abs(static_cast<double>(in[1].y) - in[1].z) < 0.5, true)};
                              }};
             }}};
}

// --- magnification

// in0 is (place, ddx), in1 ddy: rolled, stretched, sheared, 1/1000 to 1.2 pixels large.
std::vector<Row> footprints(const Effort& effort) {
    Random random(3);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(40000); ++i) {
        const double angle = i % 3 == 0 ? 0.0 : random.in(-4.0f, 4.0f),
                     scale = std::exp2(random.in(-10.0f, 0.25f));
        const double shear = i % 5 == 0 ? random.in(-0.4f, 0.4f) : 0.0, stretch = random.in(0.3f, 1.0f);
        const dvec2 ddx = scale * dvec2(std::cos(angle), std::sin(angle));
        const dvec2 ddy =
            stretch * scale *
            dvec2(-std::sin(angle) + shear * std::cos(angle), std::cos(angle) + shear * std::sin(angle));
        rows.push_back({vec4(random.in(2.0f, 60.0f), random.in(2.0f, 60.0f), ddx), vec4(ddy, 0, 0)});
    }
    return rows;
}

// A pixel farther than half an edge by less than 1/256 of a pixel may count as covered.
std::vector<Right> coverageOracle(const Row& in) {
    const dvec2 ddx(in[0].z, in[0].w), ddy = xy(in[1]);
    const double distance = oracle::centreDistance(xy(in[0]), ddx, ddy, 3);
    const double area = std::abs(ddx.x * ddy.y - ddx.y * ddy.x);
    const double longer = std::max(std::abs(ddx.x) + std::abs(ddx.y), std::abs(ddy.x) + std::abs(ddy.y));
    const double slack = longer / 256.0 / area;
    return {decision(distance <= 0.5, distance <= 0.5 - 1e-5 || distance >= 0.5 + slack * 1.001 + 1e-5)};
}

const functions::Function covers{
    "coversPixelCentre", {misses}, "out0.x = coversPixelCentre(in0.xy, in0.zw, in1.xy) ? 1.0 : 0.0;", 2};

Case coverage() {
    Case made{"footprints of 1/1000 to 1.2 pixels, rolled and sheared",
              covers,
              {Unit::exact, 0.0, "a decision; open within 1/256 of a pixel outside of the footprint"},
              [](const Effort& effort) {
                  return Sweep{footprints(effort), coverageOracle};
              }};
    made.printed = {"Scherzer, PixR",
                    "float2 place = in0.xy - 0.5;\n"
                    "float2 reach = max(abs(in0.zw), abs(in1.xy)) * 0.5;\n"
                    "out0.x = all(abs(place - round(place)) <= reach) ? 1.0 : 0.0;",
                    ""};
    return made;
}

Case brokenFootprints() {
    return {"NaN in the place or a derivative, no area",
            covers,
            {Unit::exact, 0.0, "covers nothing"},
            [](const Effort& effort) {
                std::vector<Row> rows = footprints(effort);
                Random random(4);
                for (Row& row : rows) {
                    const size_t component = random.below(7);
                    if (component == 6)
                        row[1] = vec4(2.0f * row[0].z, 2.0f * row[0].w, 0, 0);
                    else
                        row[component / 4][static_cast<int>(component % 4)] = notANumber;
                }
                return Sweep{rows, [](const Row&) { return std::vector{right(0.0)}; }};
            }};
}

// --- refresh

int64_t whole(float value) {
    return static_cast<int64_t>(value);
}

int64_t modulo(int64_t a, int64_t n) {
    return (a % n + n) % n;
}

// a within ±2^24, n to 4096, multiples of n among them.
std::vector<Row> quotients(const Effort& effort) {
    Random random(5);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(100000); ++i) {
        const int n = 1 + static_cast<int>(random.below(i % 2 == 0 ? 32 : 4096));
        const int a = static_cast<int>(random.below(i % 3 == 0 ? 1000 : 16777216));
        rows.push_back({vec4((i % 5 == 0 ? a / n * n : a) * (i % 4 == 0 ? -1 : 1), n, 0, 0)});
    }
    return rows;
}

const Bound wholeNumbers{Unit::exact, 0.0, "whole numbers below 2^24"};

std::vector<Case> periods() {
    return {{"to ±2^24, n to 4096",
             {"wholeModulo", {refresh}, "out0.x = wholeModulo(in0.x, in0.y);"},
             wholeNumbers,
             [](const Effort& effort) {
                 return Sweep{quotients(effort), [](const Row& in) {
                                  return std::vector{
                                      right(static_cast<double>(modulo(whole(in[0].x), whole(in[0].y))))};
                              }};
             }},
            {"0 to 4096, beyond, to ±1e30",
             {"wholePeriod", {refresh}, "out0.x = wholePeriod(in0.x);"},
             wholeNumbers,
             [](const Effort& effort) {
                 std::vector<Row> rows;
                 for (float n : ofBothSigns(logarithmic(1e-30, 1e30, effort.of(20000))))
                     rows.push_back({vec4(n)});
                 Random random(6);
                 for (size_t i = 0; i < effort.of(20000); ++i)
                     rows.push_back({vec4(random.in(0.0f, 5000.0f))});
                 return Sweep{rows, [](const Row& in) {
                                  const double n = std::clamp(static_cast<double>(in[0].x), 1.0, 4096.0);
                                  return std::vector{right(std::floor(n + 0.5))};
                              }};
             }},
            {"frames to 2^24 - n, groups to n",
             {"isRefreshed", {refresh}, "out0.x = isRefreshed(in0.z, in0.x, in0.y) ? 1.0 : 0.0;"},
             wholeNumbers,
             [](const Effort& effort) {
                 std::vector<Row> rows = quotients(effort);
                 Random random(7);
                 for (Row& row : rows) {
                     row[0].x = std::min(std::abs(row[0].x), 16777216.0f - row[0].y);
                     row[0].z = std::floor(random.unit() * row[0].y);
                 }
                 return Sweep{rows, [](const Row& in) {
                                  return std::vector{right(
                                      oracle::isRefreshed(whole(in[0].z), whole(in[0].x), whole(in[0].y))
                                          ? 1.0
                                          : 0.0)};
                              }};
             }},
            {"0 to 577",
             {"scrambled", {refresh}, "out0.x = scrambled(in0.x);"},
             wholeNumbers,
             [](const Effort&) {
                 std::vector<Row> rows;
                 for (int value = 0; value <= 577; ++value)
                     rows.push_back({vec4(static_cast<float>(value))});
                 return Sweep{rows, [](const Row& in) {
                                  const int64_t v = whole(in[0].x);
                                  return std::vector{right(static_cast<double>((34 * v + 1) * v % 289))};
                              }};
             }},
            {"tiles to ±2^20: whole and in [0, 289)",
             {"scrambled",
              {refresh},
              "float s = scrambled(in0.xy, in0.z); out0.x = s - floor(s); out0.y = s >= 0.0 && s < 289.0 ? "
              "1.0 : 0.0;"},
             wholeNumbers,
             [](const Effort& effort) {
                 Random random(8);
                 std::vector<Row> rows;
                 for (size_t i = 0; i < effort.of(40000); ++i)
                     rows.push_back({vec4(glm::floor(random.in4(-1048576.0f, 1048576.0f)))});
                 return Sweep{rows, [](const Row&) { return std::vector{right(dvec2(0.0, 1.0))}; }};
             }}};
}

// in0 is (position, size or block, n), in1 the tile.
std::vector<Row> groupRows(const Effort& effort) {
    Random random(9);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float side = std::floor(std::exp2(random.in(0.0f, 14.0f)));
        const float n = std::floor(std::exp2(random.in(0.0f, 9.99f)));
        rows.push_back(
            {vec4(std::floor(random.unit() * side) + 0.5f, std::floor(random.unit() * side) + 0.5f, side, n),
             vec4(1 + random.below(16), 1 + random.below(16), 1 + random.below(8), 0)});
    }
    return rows;
}

Case anyGroup(const std::string& function, const std::string& arguments) {
    return {"all to ±1e30",
            {function, {refresh}, "out0.x = " + function + "(" + arguments + ");", 2},
            {Unit::finite, 0.0, "a group, whichever"},
            [](const Effort& effort) {
                Random random(10);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(20000); ++i)
                    rows.push_back(
                        {vec4(anyValue(random), random.of(beyondMarks), anyValue(random), anyValue(random)),
                         vec4(random.of(beyondMarks), anyValue(random), anyValue(random), 0)});
                return Sweep{rows, [](const Row&) { return std::vector{open(1)}; }};
            }};
}

std::vector<Case> groups() {
    const std::string band = "in0.xy, in0.z, in0.w", tile = "in0.xy, in1.xy", block = "in0.xy, in1.z, in1.xy";
    return {
        {"heights to 16384, n to 1024",
         {"groupOfBand", {refresh}, "out0.x = groupOfBand(" + band + ");", 2},
         wholeNumbers,
         [](const Effort& effort) {
             return Sweep{groupRows(effort), [](const Row& in) {
                              return std::vector{right(static_cast<double>(
                                  oracle::groupOfBand(whole(in[0].y), whole(in[0].z), whole(in[0].w))))};
                          }};
         }},
        {"images to 16384, tiles to 16x16",
         {"groupOfTile", {refresh}, "out0.x = groupOfTile(" + tile + ");", 2},
         wholeNumbers,
         [](const Effort& effort) {
             return Sweep{groupRows(effort), [](const Row& in) {
                              const glm::ivec2 pixel(glm::floor(xy(in[0]))), size(xy(in[1]));
                              return std::vector{
                                  right(static_cast<double>(oracle::groupOfTile(pixel, size)))};
                          }};
         }},
        {"images to 16384, tiles to 16x16: whole and in [0, n)",
         {"groupOfBlock",
          {refresh},
          "float g = groupOfBlock(" + block +
              "); out0.x = g - floor(g); out0.y = g >= 0.0 && g < in1.x * in1.y ? 1.0 : 0.0;",
          2},
         wholeNumbers,
         [](const Effort& effort) {
             return Sweep{groupRows(effort), [](const Row&) { return std::vector{right(dvec2(0.0, 1.0))}; }};
         }},
        anyGroup("groupOfBand", band),
        anyGroup("groupOfTile", tile),
        anyGroup("groupOfBlock", block)};
}

} // namespace

std::vector<Case> missDetectionCases() {
    std::vector<Case> all;
    for (const Storage& storage : storages) {
        all.push_back(storedDepth("standard", standardDepth(), storage));
        all.push_back(storedDepth("reversed", reversedDepth(), storage));
        all.push_back(storedDepth("orthographic", parallelDepth(), storage));
    }
    const std::string error = "out0.x = linearDepthError(in0.x, in0.zw, in1.xy);";
    const std::string threshold = "out0.x = depthThreshold(in0.x, in0.zw, in1.xy, in0.y);";
    for (bool orthographic : {false, true}) {
        all.push_back(anyDepth("linearDepthError", error, orthographic));
        all.push_back(anyDepth("depthThreshold", threshold, orthographic));
    }
    for (const auto& more : {hits(), std::vector{coverage(), brokenFootprints()}, periods(), groups()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace check
