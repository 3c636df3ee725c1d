// SPDX-License-Identifier: Apache-2.0
// 3x3 neighbourhoods as rows of nine inputs.
#pragma once

#include "hlsl_functions.hpp"
#include "inputs.hpp"
#include "oracle.hpp"

namespace functions {

// in0 to in8 are the texels in rows from the upper left.
inline const std::string fillNeighbourhood =
    "Neighbourhood n;\n"
    "n.leftUp = in0.xyz; n.up = in1.xyz; n.rightUp = in2.xyz;\n"
    "n.left = in3.xyz; n.centre = in4.xyz; n.right = in5.xyz;\n"
    "n.leftDown = in6.xyz; n.down = in7.xyz; n.rightDown = in8.xyz;\n";

inline oracle::Square squareOf(const Row& row) {
    oracle::Square square;
    for (size_t i = 0; i < 9; ++i)
        square[i] = xyz(row[i]);
    return square;
}

// Smooth, HDR, flat and hostile ones; each texel is the extreme one in some.
inline std::vector<Row> squares(uint32_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    for (size_t texel = 0; texel < 9; ++texel)
        for (float value : {0.0f, 1.0f, 65504.0f}) {
            Row row(9, vec4(0.5f));
            row[texel] = vec4(value);
            rows.push_back(row);
        }
    for (int i = 0; i < 3000; ++i) {
        const float base = random.colourValue(), spread = random.of(std::vector{0.0f, 1e-4f, 0.1f, 1.0f});
        Row row;
        for (int texel = 0; texel < 9; ++texel)
            row.push_back(i % 3 == 0 ? random.colour()
                                     : glm::min(base * (1.0f + spread * random.in4(0, 1)), vec4(65504)));
        if (i % 5 == 0)
            row[random.below(9)] = vec4(random.of(hostileColour), random.of(hostileColour), 0.0f, 0.0f);
        rows.push_back(row);
    }
    return rows;
}

} // namespace functions
