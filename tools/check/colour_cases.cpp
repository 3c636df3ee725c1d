// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/colour.hlsli";

functions::Function call(const std::string& name, const std::string& body) {
    return {name, {header}, body};
}

Sweep over(std::vector<Row> rows, std::vector<Right> (*oracle)(const Row&)) {
    return {std::move(rows), oracle};
}

std::vector<Row> anyColours(const Effort& effort) {
    return triples(colourValues(effort) + beyondMarks + std::vector{infinity, -infinity, notANumber});
}

std::vector<Right> shareOf(const Row& in) {
    const dvec3 share = oracle::unitColour(xyz(in[0]));
    return {right(share, share)};
}

// A share below the normal numbers may be taken for 0: as a rounding, of a size 2^24 times its colour's.
std::vector<Right> throughUnit(const Row& in) {
    const dvec3 colour = oracle::sanitize(xyz(in[0]));
    return {right(colour, colour + oracle::maxColour * 0x1p-102)};
}

std::vector<Case> repairs() {
    return {
        {"any value, NaN and infinity too",
         call("sanitize", "out0.xyz = sanitize(in0.xyz);"),
         {Unit::exact, 0.0, "comparisons and copies"},
         [](const Effort& effort) {
             return over(anyColours(effort),
                         [](const Row& in) { return std::vector{right(oracle::sanitize(xyz(in[0])))}; });
         }},
        {"any value, NaN and infinity too",
         call("toUnitColour", "out0.xyz = toUnitColour(in0.xyz);"),
         {Unit::roundings, 3.0, "a product by a constant up to a step above"},
         [](const Effort& effort) { return over(anyColours(effort), shareOf); }},
        {"unit colours of any value, NaN and infinity too",
         call("fromUnitColour", "out0.xyz = fromUnitColour(toUnitColour(in0.xyz));"),
         {Unit::roundings, 4.0, "two products, one by a constant up to a step above"},
         [](const Effort& effort) { return over(anyColours(effort) + colours(effort, 12), throughUnit); }},
        {"to ±1e30",
         call("maxComponent", "out0.x = maxComponent(in0.xyz);"),
         {Unit::exact, 0.0, "chooses"},
         [](const Effort& effort) {
             return over(beyondColours(effort, 1),
                         [](const Row& in) { return std::vector{right(oracle::maxComponent(xyz(in[0])))}; });
         }}};
}

std::vector<Right> luminanceOracle(const Row& in) {
    const dvec3 colour = xyz(in[0]);
    return {right(oracle::luminance(colour), oracle::luminance(glm::abs(colour)))};
}

std::vector<Case> luminances() {
    const auto luminance = call("luminance", "out0.x = luminance(in0.xyz);");
    return {{"0 to 65504",
             luminance,
             {Unit::relative, 5.0 * roundoff, "three products and two sums of one sign"},
             [](const Effort& effort) { return over(colours(effort, 2), luminanceOracle); }},
            {"to ±1e30",
             luminance,
             {Unit::roundings, 5.0, "the same at the sum of the absolute terms, which may cancel"},
             [](const Effort& effort) { return over(beyondColours(effort, 3), luminanceOracle); }}};
}

std::vector<Case> ycocg() {
    const auto fromRgb = call("rgbToYcocg", "out0.xyz = rgbToYcocg(in0.xyz);");
    const auto toRgb = call("ycocgToRgb", "out0.xyz = ycocgToRgb(in0.xyz);");
    const auto forth = [](const Row& in) {
        const dvec3 colour = xyz(in[0]);
        return std::vector{right(oracle::rgbToYcocg(colour), largest(colour))};
    };
    const auto back = [](const Row& in) {
        const dvec3 colour = xyz(in[0]);
        return std::vector{right(oracle::ycocgToRgb(colour), largest(colour))};
    };
    return {{"0 to 65504",
             fromRgb,
             {Unit::roundings, 3.0, "two sums at the largest channel; products by powers of two are exact"},
             [forth](const Effort& effort) { return over(colours(effort, 4), forth); }},
            {"to ±1e30",
             fromRgb,
             {Unit::roundings, 3.0, "two sums at the largest channel"},
             [forth](const Effort& effort) { return over(beyondColours(effort, 5), forth); }},
            {"to ±1e30",
             toRgb,
             {Unit::roundings, 5.0, "two sums, each at up to twice the largest component"},
             [back](const Effort& effort) { return over(beyondColours(effort, 6), back); }},
            {"round trip, 0 to 65504",
             call("ycocgToRgb", "out0.xyz = ycocgToRgb(rgbToYcocg(in0.xyz));"),
             {Unit::roundings, 6.0, "four sums at the largest channel, and their slack"},
             [](const Effort& effort) {
                 return over(colours(effort, 7), [](const Row& in) {
                     return std::vector{right(xyz(in[0]), largest(xyz(in[0])))};
                 });
             }}};
}

// Without a component above -1 the contract says nothing but that the result is finite.
std::vector<Right> compressOracle(const Row& in) {
    const dvec3 colour = xyz(in[0]);
    if (oracle::maxComponent(colour) < 0.0) return {open(3)};
    const dvec3 value = oracle::compressHdr(colour);
    return {right(value, glm::abs(value))};
}

constexpr double expandRoundings = 12.0;

// A denormal may be taken for 0, and what it would have been divided by is at least 1 / 65505.
std::vector<Right> expandOracle(const Row& in) {
    const dvec3 value = oracle::expandHdr(xyz(in[0]));
    return {right(value, glm::abs(value) + 65505.0 * 0x1p-126 / (expandRoundings * roundoff))};
}

std::vector<Row> compressedColours(const Effort& effort) {
    std::vector<float> values = {0.0f,       1e-40f, 1e-30f, 1e-7f,  0.1f,  0.5f,      1.0f,
                                 1.0000001f, 2.0f,   1e30f,  -1e-7f, -1.0f, -65504.0f, -1e30f};
    for (float complement : powersOfHalf(1, 24))
        values.push_back(1.0f - complement);
    std::vector<Row> rows = triples(values);
    Random random(8);
    for (size_t i = 0; i < effort.of(40000); ++i)
        rows.push_back({i % 2 == 0 ? random.in4(0.0f, 1.0f) : random.in4(0.9999f, 1.0001f)});
    return rows;
}

std::vector<Case> compression() {
    const auto compress = call("compressHdr", "out0.xyz = compressHdr(in0.xyz);");
    return {
        {"0 to 65504",
         compress,
         {Unit::relative, divisionError + 2.0 * roundoff, "a sum of one sign and a division"},
         [](const Effort& effort) { return over(colours(effort, 9), compressOracle); }},
        {"to ±1e30",
         compress,
         {Unit::roundings, 7.0, "a sum of one sign and a division; open where all are negative"},
         [](const Effort& effort) { return over(beyondColours(effort, 10), compressOracle); }},
        {"complements 2^-k, and to ±1e30",
         call("expandHdr", "out0.xyz = expandHdr(in0.xyz);"),
         {Unit::roundings, expandRoundings,
          "two divisions, of which one gives the least complement, and a sum"},
         [](const Effort& effort) { return over(compressedColours(effort), expandOracle); }},
        {"round trip, 0 to 65504",
         call("expandHdr", "out0.xyz = expandHdr(compressHdr(in0.xyz));"),
         {Unit::roundings, 12.0,
          "the complement 1 / (1 + max) carries the error of the largest component: (2 + max) times as much"},
         [](const Effort& effort) {
             return over(colours(effort, 11), [](const Row& in) {
                 const dvec3 colour = xyz(in[0]);
                 return std::vector{right(colour, (2.0 + largest(colour)) * colour)};
             });
         }}};
}

} // namespace

std::vector<Case> colourCases() {
    std::vector<Case> all;
    for (const auto group : {repairs, luminances, ycocg, compression})
        for (Case& each : group())
            all.push_back(std::move(each));
    return all;
}

} // namespace check
