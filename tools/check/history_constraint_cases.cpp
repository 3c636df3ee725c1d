// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"
#include "sweep.hpp"

namespace check {
namespace {

const std::string header = "reprise/history_constraint.hlsli";
const std::string fillBox = "ColourBox box; box.minimum = in1.xyz; box.maximum = in2.xyz;\n";

oracle::Box boxOf(const Row& in) {
    return {xyz(in[1]), xyz(in[2])};
}

// history, minimum, maximum, current
Row constraintRow(vec4 history, vec4 a, vec4 b, vec4 current) {
    return {history, glm::min(a, b), glm::max(a, b), current};
}

// Boxes of every size from none to all colours, history in them, beside them and far outside. Current colours
// may lie outside too, as the rounded box allows.
std::vector<Row> boxes(const Effort& effort, uint32_t seed, float farthest) {
    Random random(seed);
    const std::vector<float> marks{0.0f, 6e-8f, 1e-7f, 0.5f, 1.0f, 65504.0f, -1.0f};
    const std::vector<float> far{0.0f, 0.5f, 1.0f, 65504.0f, -65504.0f, farthest, -farthest};
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(30000); ++i) {
        vec4 a(0.0f), b(0.0f), history(0.0f), current(0.0f);
        for (int c = 0; c < 3; ++c) {
            a[c] = random.of(marks);
            b[c] = random.below(3) == 0 ? a[c] : random.of(marks);
            history[c] = random.of(far);
            current[c] = random.of(marks);
        }
        rows.push_back(constraintRow(history, a, b, current));
        const vec4 base = random.colour();
        const float extent = random.below(4) == 0 ? 0.0f : std::exp2(random.in(-24.0f, 0.0f));
        const vec4 end = base * (1.0f + extent * random.in4(0.0f, 1.0f));
        rows.push_back(
            constraintRow(base * (1.0f + std::exp2(random.in(-24.0f, 4.0f)) * random.in4(-1.0f, 1.0f)), base,
                          end, glm::mix(base, end, random.unit())));
        rows.push_back(constraintRow(random.colour(), random.colour(), random.colour(), random.colour()));
    }
    return rows;
}

std::vector<Row> invertedBoxes(const Effort& effort) {
    Random random(4);
    std::vector<Row> rows;
    for (size_t i = 0; i < effort.of(30000); ++i) {
        const vec4 low = i % 2 == 0 ? random.colour() : anyColour(random);
        const vec4 high = i % 2 == 0 ? random.colour() : anyColour(random);
        rows.push_back({anyColour(random), glm::max(low, high), glm::min(low, high), random.colour()});
    }
    return rows;
}

// Sides are rounded at the size of the ends. The centre is, too, so that a side about as short as that makes
// uncertain how many sides away history lies, and with it how far along the longest side it ends.
Right centreRight(dvec3 history, oracle::Box box) {
    const dvec3 centre = glm::abs(box.maximum + box.minimum) / 2.0;
    double longest = oracle::minBoxExtent, uncertain = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double side = std::max((box.maximum[c] - box.minimum[c]) / 2.0, oracle::minBoxExtent);
        longest = std::max(longest, side);
        if (box.maximum[c] != box.minimum[c]) uncertain = std::max(uncertain, centre[c] / side);
    }
    const double size = largest(centre) + longest + std::min(uncertain, 1.0 / roundoff) * longest;
    return right(oracle::clipToBoxCentre(history, box), size);
}

// The slide, with `ax` read as max, without which it does not compile.
const std::string slideClip = "float4 slideClip(float3 low, float3 high, float4 inside, float4 history) {\n"
                              "    float3 middle = 0.5 * (high + low);\n"
                              "    float4 way = history - float4(middle, inside.w);\n"
                              "    float3 sides = abs(way.xyz / (0.5 * (high - low)));\n"
                              "    float most = max(sides.x, max(sides.y, sides.z));\n"
                              "    return most > 1.0 ? float4(middle, inside.w) + way / most : history;\n"
                              "}\n";

functions::Function clip(const std::string& name, const std::string& arguments) {
    return {name, {header}, fillBox + "out0.xyz = " + name + "(" + arguments + ", box);", 4};
}

Case clippingToCentre() {
    Case made{"boxes of any size and none, history to ±1e30",
              clip("clipToBoxCentre", "in0.xyz"),
              {Unit::roundings, 13.0, "centre, side, quotient and product at the size of centre and side"},
              [](const Effort& effort) {
                  return Sweep{boxes(effort, 1, 1e30f),
                               [](const Row& in) { return std::vector{centreRight(xyz(in[0]), boxOf(in))}; }};
              }};
    made.printed = {"INSIDE, clip_aabb", "out0.xyz = slideClip(in1.xyz, in2.xyz, in3, in0).xyz;", slideClip};
    return made;
}

Case clippingToLine() {
    return {"boxes of any size and none, history to ±131008",
            clip("clipToBoxLine", "in0.xyz, in3.xyz"),
            {Unit::roundings, 13.0, "eight roundings and a division at the ends of the box"},
            [](const Effort& effort) {
                return Sweep{boxes(effort, 2, 131008.0f), [](const Row& in) {
                                 const oracle::Box box = boxOf(in);
                                 // The guard against 0/0 adds 1e-30 to shares of the way.
                                 const double size = largest(box.minimum) + largest(box.maximum) + 1e-22;
                                 return std::vector{
                                     right(oracle::clipToBoxLine(xyz(in[0]), xyz(in[3]), box), size)};
                             }};
            }};
}

// How far outside of the box the result lies, 0 inside.
Case staysInBox(const std::string& function, const std::string& arguments) {
    const std::string outside = "float3 held = out0.xyz;\n"
                                "out0.xyz = max(max(box.minimum - held, held - box.maximum), 0.0);";
    return {
        "history to ±1e30: how far outside of the box",
        {function, {header}, fillBox + "out0.xyz = " + function + "(" + arguments + ", box);\n" + outside, 4},
        {Unit::roundings, 13.0, "eight roundings and a division at the ends of the box"},
        [](const Effort& effort) {
            return Sweep{boxes(effort, 3, 1e30f), [](const Row& in) {
                             const oracle::Box box = boxOf(in);
                             const double size = largest(box.minimum) + largest(box.maximum);
                             // A side without extent counts as 1e-7.
                             return std::vector{right(dvec3(0.0), size + oracle::minBoxExtent / roundoff)};
                         }};
        }};
}

Case inverted(const functions::Function& call) {
    return {"inverted boxes, all to ±1e30",
            call,
            {Unit::finite, 0.0, "there is no inside to hold history to"},
            [](const Effort& effort) {
                return Sweep{invertedBoxes(effort), [](const Row&) { return std::vector{open(3)}; }};
            }};
}

} // namespace

std::vector<Case> historyConstraintCases() {
    const auto clamp = clip("clampToBox", "in0.xyz");
    std::vector<Case> all;
    all.push_back({"boxes of any size and none, history to ±1e30",
                   clamp,
                   {Unit::exact, 0.0, "chooses"},
                   [](const Effort& effort) {
                       return Sweep{boxes(effort, 5, 1e30f), [](const Row& in) {
                                        return std::vector{right(oracle::clampToBox(xyz(in[0]), boxOf(in)))};
                                    }};
                   }});
    all.push_back(clippingToCentre());
    all.push_back(clippingToLine());
    all.push_back(staysInBox("clipToBoxCentre", "in0.xyz"));
    all.push_back(staysInBox("clipToBoxLine", "in0.xyz, in3.xyz"));
    for (const auto& call :
         {clamp, clip("clipToBoxCentre", "in0.xyz"), clip("clipToBoxLine", "in0.xyz, in3.xyz")})
        all.push_back(inverted(call));
    return all;
}

} // namespace check
