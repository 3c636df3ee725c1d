// SPDX-License-Identifier: Apache-2.0
// Tone mapping that is taken back, T4.
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/tone_mapping.hlsli";

// 0, and 1e-4 to 65504 evenly over the logarithm, three a row.
std::vector<Row> range(const Effort& effort) {
    auto values = logarithmic(1e-4, 65504.0, effort.of(600000));
    values.back() = 65504.0f;
    values.insert(values.end(), {0.0f, 0.0f, 0.0f});
    std::vector<Row> rows;
    for (size_t i = 0; i + 2 < values.size(); i += 3)
        rows.push_back({vec4(values[i], values[i + 1], values[i + 2], 0.0f)});
    return rows;
}

Sweep toItself(const Effort& effort) {
    return {range(effort), [](const Row& in) { return std::vector{right(xyz(in[0]))}; }};
}

// The page's two inverses over A to F; each takes what its own toneMap gives.
const std::string constants =
    "static const float A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30;\n"
    "float3 slideMap(float3 x) {\n"
    "    return ((x * (A * x + C * B) + D * E) / (x * (A * x + B) + D * F)) - E / F;\n"
    "}\n";
const std::string firstInverse =
    "float3 firstInverse(float3 x) {\n"
    "    return (sqrt((4.0 * x - 4.0 * x * x) * A * D * F * F * F + (-4.0 * x * A * D * E + B * B * C * C\n"
    "        - 2.0 * x * B * B * C + x * x * B * B) * F * F + (2.0 * x * B * B - 2.0 * B * B * C) * E * F\n"
    "        + B * B * E * E) + (B * C - x * B) * F - B * E) / ((2.0 * x - 2.0) * A * F + 2.0 * A * E);\n"
    "}\n";
const std::string secondInverse =
    "float3 secondInverse(float3 x) {\n"
    "    return (sqrt((4.0 * x - 4.0 * x * x) * A * D * F * F * F + ((4.0 * x - 4.0) * A * D * E + B * B * C "
    "* C\n"
    "        + (2.0 * x - 2.0) * B * B * C + (x * x - 2.0 * x + 1.0) * B * B) * F * F\n"
    "        + ((2.0 - 2.0 * x) * B * B - 2.0 * B * B * C) * E * F + B * B * E * E)\n"
    "        + ((1.0 - x) * B - B * C) * F + B * E) / (2.0 * x * A * F - 2.0 * A * E);\n"
    "}\n";

Case hableTrip(const std::string& beside, const Printed& printed) {
    Case made{"round trip 0, 1e-4 to 65504, " + beside + " beside",
              {"inverseToneMapHable", {header}, "out0.xyz = inverseToneMapHable(toneMapHable(in0.xyz));"},
              {Unit::relative, 4e-6, "the bar of T4; exactly 0 at 0"},
              toItself};
    made.printed = printed;
    return made;
}

std::vector<Case> roundTrips() {
    return {
        {"round trip 0, 1e-4 to 65504",
         {"inverseToneMapReinhard", {header}, "out0.xyz = inverseToneMapReinhard(toneMapReinhard(in0.xyz));"},
         {Unit::relative, 3e-7,
          "a quotient of two numbers that are each exact to some roundings; exactly 0 at 0"},
         toItself},
        hableTrip("first inverse", {"HDR resolve, first inverse",
                                    "out0.xyz = firstInverse(slideMap(in0.xyz));", constants + firstInverse}),
        hableTrip("second inverse",
                  {"HDR resolve, second inverse", "out0.xyz = secondInverse(1.0 - slideMap(in0.xyz));",
                   constants + secondInverse})};
}

// --- both numbers

std::vector<Right> mappedOracle(const Row& in, double (*curve)(double), double (*complement)(double)) {
    dvec3 value, rest;
    for (int c = 0; c < 3; ++c) {
        const double x = oracle::sanitize(static_cast<double>(in[0][c]));
        value[c] = curve(x);
        rest[c] = complement(x);
    }
    // Hable's curve subtracts in the oracle, in 64-bit significands: 1e-19.
    return {right(value, value + 1e-12), right(rest, rest)};
}

double reinhardComplement(double x) {
    return 1.0 / (1.0 + x);
}

Case mapping(const std::string& function, double (*curve)(double), double (*complement)(double)) {
    return {
        "any colour, NaN and infinity too",
        {function,
         {header},
         "ToneMapped m = " + function + "(in0.xyz); out0.xyz = m.value; out1.xyz = m.complement;",
         1,
         2},
        {Unit::roundings, 15.0, "products and sums of one sign, their constants, and a division"},
        [curve, complement](const Effort& effort) {
            std::vector<Row> rows = triples(colourMarks + beyondMarks + std::vector{infinity, notANumber});
            for (const Row& row : colours(effort, 1))
                rows.push_back(row);
            return Sweep{rows,
                         [curve, complement](const Row& in) { return mappedOracle(in, curve, complement); }};
        }};
}

Case anyMapped(const std::string& function, const std::string& call) {
    return {
        "any value and complement, NaN: outside of [0, 65504]",
        {function,
         {header},
         "ToneMapped m; m.value = in0.xyz; m.complement = in1.xyz;\n"
         "float3 c = " +
             call +
             ";\n"
             "out0.xyz = float3(c.x >= 0.0 && c.x <= MAX_COLOUR, c.y >= 0.0 && c.y <= MAX_COLOUR,\n"
             "                  c.z >= 0.0 && c.z <= MAX_COLOUR);",
         2},
        {Unit::exact, 0.0, "a colour, whichever"},
        [](const Effort& effort) {
            const auto values = beyondMarks + std::vector{0.5f, 0.93333f, infinity, -infinity, notANumber};
            Random random(2);
            std::vector<Row> rows;
            for (size_t i = 0; i < effort.of(40000); ++i) {
                Row row;
                for (int k = 0; k < 2; ++k)
                    row.push_back(
                        vec4(random.of(values), anyValue(random), random.of(values), random.of(values)));
                rows.push_back(row);
            }
            return Sweep{rows, [](const Row&) { return std::vector{right(dvec3(1.0))}; }};
        }};
}

// --- resolves

using Resolve = double (*)(const std::vector<double>&);

// One to four samples, their count in in0.w: dark, bright, and one light beside the dark.
std::vector<Row> samples(const Effort& effort) {
    Random random(3);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(6000); ++i) {
        Row row;
        for (int k = 0; k < 4; ++k)
            row.push_back(i % 3 == 0 ? random.in4(0.0f, 2.0f) : i % 3 == 1 ? random.colour() : vec4(0.0f));
        const auto count = 1 + random.below(4);
        if (i % 3 == 2) row[random.below(count)] = random.colour();
        row[0].w = static_cast<float>(count);
        rows.push_back(row);
    }
    return rows;
}

std::vector<Right> resolveOracle(const Row& in, Resolve resolve) {
    dvec3 value;
    for (int c = 0; c < 3; ++c) {
        std::vector<double> values;
        for (size_t k = 0; k < static_cast<size_t>(in[0].w); ++k)
            values.push_back(in[k][c]);
        value[c] = resolve(values);
    }
    return {right(value)};
}

functions::Function resolving(const std::string& function, const std::string& add,
                              const std::string& resolve) {
    return {function,
            {header},
            "float3 samples[4] = {in0.xyz, in1.xyz, in2.xyz, in3.xyz};\n"
            "ToneMapped sum = noSamples();\n"
            "for (int i = 0; i < 4; ++i)\n"
            "    if (float(i) < in0.w) " +
                add + "(sum, samples[i]);\nout0.xyz = " + resolve + ";",
            4};
}

Case resolved(const std::string& function, const std::string& add, const std::string& call, Resolve resolve,
              double relative) {
    return {
        "1 to 4 samples, 0 to 65504",
        resolving(function, add, call),
        {Unit::relative, relative,
         "sums of positive numbers and a division, beside the bar of the round trip"},
        [resolve](const Effort& effort) {
            return Sweep{samples(effort), [resolve](const Row& in) { return resolveOracle(in, resolve); }};
        }};
}

std::vector<Case> resolves() {
    const double sums = 4.0 * roundoff + divisionError;
    const std::string box = "resolveBox(sum, in0.w)", reinhard = "resolveReinhard(sum)",
                      hable = "resolveHable(sum, in0.w)";
    std::vector<Case> all;
    for (const char* function : {"addBox", "resolveBox"})
        all.push_back(resolved(function, "addBox", box, oracle::resolveBox, sums));
    for (const char* function : {"addReinhard", "resolveReinhard"})
        all.push_back(resolved(function, "addReinhard", reinhard, oracle::resolveReinhard, sums + 3e-7));
    for (const char* function : {"addHable", "resolveHable"})
        all.push_back(resolved(function, "addHable", hable, oracle::resolveHable, sums + 4e-6));
    all.push_back({"nothing added",
                   {"noSamples",
                    {header},
                    "ToneMapped sum = noSamples(); out0.xyz = sum.value; out1.xyz = sum.complement;\n"
                    "out2.xyz = resolveBox(sum, in0.x); out3.xyz = resolveReinhard(sum);\n"
                    "out4.xyz = resolveHable(sum, in0.x);",
                    1,
                    5},
                   {Unit::exact, 0.0, "0, also resolved over 0 samples"},
                   [](const Effort&) {
                       return Sweep{{{vec4(0.0f)}, {vec4(1.0f)}, {vec4(4096.0f)}},
                                    [](const Row&) { return std::vector(5, right(dvec3(0.0))); }};
                   }});
    all.push_back({"4096 times the same, 0 to 65504",
                   {"addToneMapped",
                    {header},
                    "ToneMapped sum = noSamples(), one = toneMapReinhard(in0.xyz);\n"
                    "for (int i = 0; i < 4096; ++i) addToneMapped(sum, one);\n"
                    "out0.xyz = resolveReinhard(sum);"},
                   {Unit::relative, 4096.0 * roundoff, "as many sums, each rounded at what it has come to"},
                   [](const Effort& effort) {
                       Random random(4);
                       std::vector<Row> rows;
                       for (size_t i = 0; i < effort.of(4000); ++i)
                           rows.push_back({random.colour()});
                       return Sweep{rows, [](const Row& in) { return std::vector{right(xyz(in[0]))}; }};
                   }});
    return all;
}

} // namespace

std::vector<Case> toneMappingCases() {
    std::vector<Case> all = roundTrips();
    all.push_back(mapping("toneMapReinhard", oracle::reinhard, reinhardComplement));
    all.push_back(mapping("toneMapHable", oracle::hable, oracle::hableComplement));
    all.push_back(anyMapped("inverseToneMapReinhard", "inverseToneMapReinhard(m)"));
    all.push_back(anyMapped("inverseToneMapHable", "inverseToneMapHable(m)"));
    all.push_back(anyMapped("resolveBox", "resolveBox(m, in1.w)"));
    all.push_back(anyMapped("resolveHable", "resolveHable(m, in1.w)"));
    for (Case& each : resolves())
        all.push_back(std::move(each));
    return all;
}

} // namespace check
