// SPDX-License-Identifier: Apache-2.0
// The triangle that draws the fragment form of every full-screen pass: it covers each pixel, at its centre.
#include "fullscreen_case.hpp"

namespace passes {
namespace {

class Fullscreen : public PassTest {};

TEST_F(Fullscreen, everyPixelIsCoveredAtItsCentre) {
    for (const auto& [width, height] :
         {std::pair(1, 1), {2, 2}, {7, 5}, {64, 64}, {641, 359}, {1, 97}, {2048, 3}}) {
        const Comparison result = comparePositions(width, height);
        EXPECT_TRUE(result.holds()) << width << "x" << height << ": " << text(result);
    }
}

} // namespace
} // namespace passes
