// SPDX-License-Identifier: Apache-2.0
// Every binary16 as inputs, stores into 16 and 8 bits, and digits of 8 bits.
#pragma once

#include "harness.hpp"
#include "sweep.hpp"

namespace check {

// Every bit pattern, NaN, infinities and negatives among them.
inline std::vector<float> everyHalf() {
    std::vector<float> values;
    for (uint32_t bits = 0; bits < 65536; ++bits)
        values.push_back(harness::halfToFloat(static_cast<uint16_t>(bits)));
    return values;
}

// Two others at random beside each.
inline std::vector<Row> halfRows(uint32_t seed) {
    const std::vector<float> halves = everyHalf();
    Random random(seed);
    std::vector<Row> rows;
    for (float half : halves)
        rows.push_back({vec4(half, random.of(halves), random.unit(), random.of(halves))});
    return rows;
}

inline std::vector<Row> justHalves() {
    std::vector<Row> rows;
    for (float half : everyHalf())
        rows.push_back({vec4(half)});
    return rows;
}

inline const std::string everyHalfName = "every binary16";

// Helpers: what a store to nearest makes of a value from 2^-14 on, and of channels of 8 bits.
inline const std::string stores =
    "float storedHalf(float v) {\n"
    "    uint bits = asuint(v);\n"
    "    return v < 0.00006103515625 ? floor(v * 16777216.0 + 0.5) / 16777216.0\n"
    "                                : asfloat((bits + 0xFFFu + ((bits >> 13) & 1u)) & 0xFFFFE000u);\n"
    "}\n"
    "float4 storedUnorm8(float4 v) { return floor(saturate(v) * 255.0 + 0.5) / 255.0; }\n";

// A function with the helpers.
inline functions::Function storing(const std::string& name, const std::string& header,
                                   const std::string& body, int inputs = 1, int outputs = 1) {
    functions::Function made{name, {header}, body, inputs, outputs};
    made.helpers = stores;
    return made;
}

// Digits over 255; half a code away from the next, rounding decides.
template <size_t Count> Right digitsRight(double scaled, bool rounds, double slack) {
    const double above = scaled - std::floor(scaled);
    if (rounds && std::abs(above - 0.5) < slack) return open(static_cast<int>(Count));
    const auto digits =
        oracle::digits<Count>(static_cast<uint64_t>(std::floor(scaled + (rounds ? 0.5 : 0.0))));
    Right made;
    made.components = static_cast<int>(Count);
    for (size_t i = 0; i < Count; ++i)
        made.value[static_cast<int>(i)] = made.size[static_cast<int>(i)] = digits[i] / 255.0;
    return made;
}

} // namespace check
