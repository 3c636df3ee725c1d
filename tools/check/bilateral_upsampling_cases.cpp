// SPDX-License-Identifier: Apache-2.0
// Listing 7.1.
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/bilateral_upsampling.hlsli";

// --- the four texels

// in0 is (position, coarse size), in1 the ratio.
std::vector<Row> finePixels(const Effort& effort) {
    Random random(1);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(20000); ++i) {
        const float ratio = i % 2 == 0 ? 2.0f : 4.0f;
        const float side = std::floor(std::exp2(random.in(0.0f, 12.0f)));
        const float coarse = std::ceil(side / ratio);
        const float x = std::floor(random.unit() * side), y = std::floor(random.unit() * side);
        rows.push_back({vec4(x + 0.5f, y + 0.5f, coarse, coarse), vec4(ratio)});
    }
    return rows;
}

std::vector<Right> footprintOracle(const Row& in) {
    const dvec2 size(in[0].z, in[0].w);
    const auto taps =
        oracle::coarseTaps(glm::ivec2(glm::floor(xy(in[0]))), static_cast<int>(in[1].x), glm::ivec2(size));
    dvec4 weights;
    std::array<dvec2, 4> uv;
    for (size_t i = 0; i < 4; ++i) {
        weights[static_cast<int>(i)] = taps[i].bilinear;
        uv[i] = (dvec2(taps[i].texel) + 0.5) / size;
    }
    const double texels = std::max(in[0].x, in[0].y) / in[1].x;
    return {right(dvec4(uv[0], uv[1]), 1.0), right(dvec4(uv[2], uv[3]), 1.0), right(weights, 1.0 + texels)};
}

// --- likeness of normals

// Relative. Vulkan lets log2 err by 2^-21 between 1/2 and 2 and by 3 steps elsewhere, which the exponent
// multiplies, and exp2 by 3 + 2 |x| steps; the cosine is a sum of three products.
double likenessError(double cosine, double contrast) {
    if (!(cosine > 0.0) || !(contrast > 0.0)) return 0.0;
    const double step = 2.0 * roundoff, exponent = std::min(contrast, 256.0);
    const double log = std::log2(std::min(cosine, 1.0)), power = std::abs(exponent * log);
    const double logError = cosine >= 0.5 ? 0x1p-21 : 3.0 * step * std::abs(log);
    return exponent * (std::log(2.0) * logError + 6.0 * roundoff / cosine) + (3.0 + 3.0 * power) * step;
}

glm::vec3 unitVector(Random& random) {
    const glm::vec3 v(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1));
    return glm::length(v) > 0.01f ? glm::normalize(v) : glm::vec3(0, 0, 1);
}

// From the same over all angles to the opposite.
glm::vec3 likeVector(Random& random, glm::vec3 normal) {
    const float spread = random.below(8) == 0 ? 0.0f : std::exp2(random.in(-12.0f, 2.0f));
    const glm::vec3 other = glm::normalize(normal + spread * unitVector(random) + glm::vec3(1e-6f));
    return random.below(8) == 0 ? -normal : other;
}

float contrastOf(Random& random) {
    static const std::vector<float> marks{-1.0f, 0.0f, 1e-40f, 1e-7f, 1.0f, 255.0f, 256.0f, 257.0f, 1e30f};
    return random.below(3) == 0 ? random.of(marks) : std::exp2(random.in(-3.0f, 8.0f));
}

Right likenessRight(dvec3 low, dvec3 high, double contrast) {
    const double weight = oracle::normalWeight(low, high, contrast), cosine = glm::dot(low, high);
    // Where the sign of the cosine is not certain, neither is a weight of a small exponent.
    if (std::abs(cosine) < 6.0 * roundoff || (contrast > 0.0 && contrast < smallestNormal)) return open(1);
    return right(weight, weight * likenessError(cosine, contrast) / roundoff);
}

// As printed, with a dot product of two vectors.
const Printed printedLikeness{"Listing 7.1, normalWeights", "out0.x = pow(dot(in0.xyz, in1.xyz), in1.w);",
                              ""};

Case likeness() {
    Case made{
        "cosines -1 to 1, contrast 0 to 256, 1e30",
        {"normalWeight", {header}, "out0.x = normalWeight(in0.xyz, in1.xyz, in1.w);", 2},
        {Unit::roundings, 1.0, "what Vulkan allows log2, times the exponent, and exp2"},
        [](const Effort& effort) {
            Random random(2);
            std::vector<Row> rows;
            for (size_t i = 0; i < effort.of(100000); ++i) {
                const glm::vec3 normal = unitVector(random);
                rows.push_back({vec4(likeVector(random, normal), 0.0f), vec4(normal, contrastOf(random))});
            }
            return Sweep{rows, [](const Row& in) {
                             return std::vector{likenessRight(xyz(in[0]), xyz(in[1]), in[1].w)};
                         }};
        }};
    made.printed = printedLikeness;
    return made;
}

// --- shares and the mean

// in0 samples, in1 bilinear weights, in2 depths, in3 (depth of the pixel, contrast), in4 to in7 the normals,
// in8 that of the pixel.
enum class Kind { any, withoutWeight, broken };

Row upsamplingRow(Random& random, Kind kind, size_t i) {
    Row row(9, vec4(0.0f));
    row[0] = random.colour();
    row[0].w = random.colourValue();
    const float x = 0.125f + 0.25f * static_cast<float>(random.below(4)), y = random.unit();
    row[1] = vec4((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y);
    const float depth = std::exp2(random.in(-13.3f, 23.2f)); // 1e-4 to 1e7 m
    for (int c = 0; c < 4; ++c)
        row[2][c] = i % 3 == 0 ? depth * (1.0f + std::exp2(random.in(-24.0f, 0.0f)))
                               : std::exp2(random.in(-13.3f, 23.2f));
    row[3] = vec4(depth, contrastOf(random), 0.0f, 0.0f);
    const glm::vec3 normal = unitVector(random);
    row[8] = vec4(normal, 0.0f);
    for (size_t n = 4; n < 8; ++n)
        row[n] = vec4(kind == Kind::withoutWeight ? -normal : likeVector(random, normal), 0.0f);
    if (kind == Kind::withoutWeight) row[3].y = 8.0f;
    if (kind == Kind::broken)
        for (size_t input : {0, 2})
            for (int c = 0; c < 4; ++c)
                if (random.below(4) == 0)
                    row[input][c] = random.of(std::vector{notANumber, infinity, -infinity});
    return row;
}

struct Weighed {
    oracle::BilateralShares shares;
    dvec4 size{0.0}; // of each share, in roundings
    bool decided = true;
};

// Each weight errs by its own relative error and by what is a denormal in it, each share by that of all.
// Which samples are nearest, and whether there is weight at all, is not decided by less than a rounding.
Weighed weighed(const Row& in) {
    std::array<bool, 4> usable{};
    dvec4 normal(1.0);
    double relative = 0.0, nearest = HUGE_VAL;
    bool decided = true;
    for (size_t i = 0; i < 4; ++i) {
        const int c = static_cast<int>(i);
        usable[i] = std::abs(in[0][c]) <= 1e38f;
        const Right likeness = likenessRight(xyz(in[4 + i]), xyz(in[8]), in[3].y);
        decided = decided && std::isfinite(likeness.size.x);
        normal[c] = likeness.value.x;
        relative = std::max(relative, normal[c] > 0.0 ? likeness.size.x / normal[c] : 0.0);
        if (usable[i] && std::isfinite(in[2][c]))
            nearest = std::min(nearest, std::abs(static_cast<double>(in[3].x) - in[2][c]));
    }
    Weighed result{oracle::bilateralShares(dvec4(in[1]), normal, dvec4(in[2]), in[3].x, usable), {}, decided};
    const double total = result.shares.totalWeight;
    const double lost = total > 0.0 ? 1e5 * smallestNormal / total / roundoff : 0.0;
    if (total < 1.01e-30) {
        for (int c = 0; c < 4; ++c) {
            const double farther = std::abs(static_cast<double>(in[3].x) - in[2][c]) - nearest;
            if (farther > 0.0 && farther <= 4.0 * roundoff * (nearest + farther)) result.decided = false;
        }
        if (total > 0.99e-30 || (total > 0.0 && lost * roundoff > 0.001)) result.decided = false;
    }
    for (int c = 0; c < 4; ++c)
        result.size[c] =
            result.shares.of[static_cast<size_t>(c)] * (26.0 + 2.0 * relative + 2.0 * lost) + lost;
    return result;
}

std::vector<Right> sharesOracle(const Row& in) {
    const Weighed w = weighed(in);
    if (!w.decided) return {open(4)};
    return {{dvec4(w.shares.of[0], w.shares.of[1], w.shares.of[2], w.shares.of[3]), w.size, 4}};
}

std::vector<Right> upsampledOracle(const Row& in) {
    const Weighed w = weighed(in);
    if (!w.decided) return {open(1)};
    double value = 0.0, size = 0.0;
    for (int c = 0; c < 4; ++c) {
        if (!(std::abs(in[0][c]) <= 1e38f)) continue;
        value += w.shares.of[static_cast<size_t>(c)] * in[0][c];
        size +=
            (w.size[c] + 4.0 * w.shares.of[static_cast<size_t>(c)]) * std::abs(static_cast<double>(in[0][c]));
    }
    return {right(value, size)};
}

const std::string normals =
    "float4 n = normalWeightsOf(in4.xyz, in5.xyz, in6.xyz, in7.xyz, in8.xyz, in3.y);\n";

functions::Function shares() {
    return {"bilateralShares",
            {header},
            normals + "out0 = bilateralShares(in1, n, in2, in3.x, numberMask(in0));",
            9};
}

functions::Function upsampling() {
    return {
        "bilateralUpsample", {header}, normals + "out0.x = bilateralUpsample(in0, in1, n, in2, in3.x);", 9};
}

// The listing with a dot product of two, its names declared and its sums begun at 0.
const Printed printedListing{
    "Listing 7.1, made to compile",
    "float3 normalsLow[4] = {in4.xyz, in5.xyz, in6.xyz, in7.xyz};\n"
    "float total = 0.0, sum = 0.0;\n"
    "for (int i = 0; i < 4; ++i) {\n"
    "    float weight = pow(dot(normalsLow[i], in8.xyz), in3.y) / (0.0001 + abs(in3.x - in2[i])) * in1[i];\n"
    "    total += weight;\n"
    "    sum += in0[i] * weight;\n"
    "}\n"
    "out0.x = sum / total;",
    ""};

Case weighing(const functions::Function& call, Oracle oracle, Kind kind) {
    const std::string sweep = kind == Kind::any             ? "depth 1e-4 to 1e7 m, contrast to 256"
                              : kind == Kind::withoutWeight ? "all weights zero: normals that face away"
                                                            : "samples and depths NaN and infinite";
    return {sweep,
            call,
            {Unit::roundings, 1.0,
             "each weight by what Vulkan allows pow and a division, and by what is a denormal in it; open "
             "where a "
             "rounding decides which sample is nearest"},
            [kind, oracle](const Effort& effort) {
                Random random(3);
                std::vector<Row> rows;
                for (size_t i = 0; i < effort.of(60000); ++i)
                    rows.push_back(upsamplingRow(random, kind, i));
                return Sweep{rows, oracle};
            }};
}

// The forms of two and four components, and those without normals, over values and depths of any size.
Case otherForms() {
    return {
        "two and four components, by depth alone, all to ±1e30",
        {"bilateralUpsample",
         {header},
         normals + "float4 a = in0, b = in0.yzwx, c = in0.zwxy, d = in0.wxyz;\n"
                   "out0.xy = bilateralUpsample(a.xy, b.xy, c.xy, d.xy, in1, n, in2, in3.x);\n"
                   "out0.zw = bilateralUpsample(a.xy, b.xy, c.xy, d.xy, in1, in2, in3.x);\n"
                   "out1 = bilateralUpsample(a, b, c, d, in1, n, in2, in3.x);\n"
                   "out2 = bilateralUpsample(a, b, c, d, in1, in2, in3.x);\n"
                   "out3.x = bilateralUpsample(in0, in1, in2, in3.x);",
         9,
         4},
        {Unit::finite, 0.0, "shares of at most 1 of numbers"},
        [](const Effort& effort) {
            Random random(4);
            std::vector<Row> rows;
            for (size_t i = 0; i < effort.of(20000); ++i) {
                Row row = upsamplingRow(random, Kind::broken, i);
                for (size_t input : {0, 1, 2})
                    for (int c = 0; c < 4; ++c)
                        if (random.below(2) == 0) row[input][c] = anyValue(random);
                if (i % 3 == 0) row[3].x = anyValue(random);
                rows.push_back(row);
            }
            return Sweep{rows, [](const Row&) { return std::vector{open(4), open(4), open(4), open(1)}; }};
        }};
}

// --- by depth alone, without a fallback

// in0 bilinear weights, in1 depths, in2 which are usable, in3.x the depth of the pixel.
std::vector<Row> depthRows(const Effort& effort) {
    Random random(6);
    std::vector<Row> rows;
    const auto depth = [&] { return random.below(8) == 0 ? 65504.0f : std::exp2(random.in(-13.3f, 15.9f)); };
    for (size_t i = 0; i < effort.of(60000); ++i) {
        const float x = 0.125f + 0.25f * static_cast<float>(random.below(4)), y = random.in(0.125f, 0.875f);
        Row row{vec4((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y), vec4(0.0f), vec4(1.0f),
                vec4(depth())};
        for (int c = 0; c < 4; ++c) {
            row[1][c] = i % 3 == 0
                            ? std::min(row[3].x * (1.0f + std::exp2(random.in(-24.0f, 0.0f))), 65504.0f)
                            : depth();
            if (i % 2 == 0) row[2][c] = random.below(2) == 0 ? 1.0f : 0.0f;
        }
        rows.push_back(row);
    }
    return rows;
}

std::vector<Right> depthSharesOracle(const Row& in) {
    std::array<bool, 4> usable{};
    for (int c = 0; c < 4; ++c)
        usable[static_cast<size_t>(c)] = in[2][c] > 0.5f;
    const auto shares = oracle::bilateralShares(dvec4(in[0]), dvec4(1.0), dvec4(in[1]), in[3].x, usable);
    const dvec4 value(shares.of[0], shares.of[1], shares.of[2], shares.of[3]);
    return {{value, 40.0 * value, 4}};
}

std::vector<Right> weightsOracle(const Row& in) {
    const double x = in[0].x, y = in[0].y;
    const dvec4 value((1 - x) * (1 - y), x * (1 - y), (1 - x) * y, x * y);
    return {{value, 3.0 * value, 4}};
}

std::vector<Case> depthAlone() {
    return {
        {"depth 1e-4 to 65504 m, any of four usable",
         {"bilateralSharesOfDepths", {header}, "out0 = bilateralSharesOfDepths(in0, in1, in3.x, in2);", 4},
         {Unit::roundings, 1.0, "three denominators a weight, the total's, and a division"},
         [](const Effort& effort) {
             return Sweep{depthRows(effort), depthSharesOracle};
         }},
        {"places 0 to 1",
         {"bilinearWeightsAt", {header}, "out0 = bilinearWeightsAt(in0.xy);"},
         {Unit::roundings, 1.0, "two differences from 1 and a product"},
         [](const Effort& effort) {
             Random random(7);
             std::vector<Row> rows;
             for (const float x : {0.0f, 0.25f, 0.625f, 1.0f})
                 for (const float y : {0.0f, 0.25f, 0.625f, 1.0f})
                     rows.push_back({vec4(x, y, 0, 0)});
             for (size_t i = 0; i < effort.of(20000); ++i)
                 rows.push_back({vec4(random.unit(), random.unit(), 0, 0)});
             return Sweep{rows, weightsOracle};
         }}};
}

} // namespace

std::vector<Case> bilateralUpsamplingCases() {
    std::vector<Case> all;
    all.push_back(
        {"ratio 2 and 4, images of 1 to 4096 pixels",
         {"coarseFootprint",
          {header},
          "CoarseFootprint f = coarseFootprint(in0.xy, in1.x, in0.zw);\n"
          "out0 = float4(f.leftUp, f.rightUp); out1 = float4(f.leftDown, f.rightDown);\n"
          "out2 = f.bilinearWeights;",
          2,
          3},
         {Unit::roundings, 14.0, "a division by the ratio, at the place in texels; one by the size"},
         [](const Effort& effort) {
             return Sweep{finePixels(effort), footprintOracle};
         }});
    all.push_back(likeness());
    all.push_back({"four normals, contrast to 256",
                   {"normalWeightsOf", {header}, normals + "out0 = n;", 9},
                   {Unit::roundings, 1.0, "as normalWeight"},
                   [](const Effort& effort) {
                       Random random(5);
                       std::vector<Row> rows;
                       for (size_t i = 0; i < effort.of(30000); ++i)
                           rows.push_back(upsamplingRow(random, Kind::any, i));
                       return Sweep{rows, [](const Row& in) {
                                        Right all4;
                                        for (int c = 0; c < 4; ++c) {
                                            const Right one = likenessRight(
                                                xyz(in[4 + static_cast<size_t>(c)]), xyz(in[8]), in[3].y);
                                            all4.value[c] = one.value.x;
                                            all4.size[c] = one.size.x;
                                        }
                                        return std::vector{all4};
                                    }};
                   }});
    for (Kind kind : {Kind::any, Kind::withoutWeight, Kind::broken}) {
        all.push_back(weighing(shares(), sharesOracle, kind));
        all.push_back(weighing(upsampling(), upsampledOracle, kind));
        all.back().printed = printedListing;
    }
    all.push_back(otherForms());
    for (const Case& each : depthAlone())
        all.push_back(each);
    return all;
}

} // namespace check
