// SPDX-License-Identifier: Apache-2.0
// Boxes of colours around a pixel, and history held to them. INSIDE I5 to I7.
#pragma once

#include "image.hpp"

#include <array>
#include <functional>

namespace oracle {

// 3x3 in rows from the upper left; the pixel itself is number 4.
using Square = std::array<dvec3, 9>;
inline constexpr size_t squareCentre = 4;
inline constexpr std::array<size_t, 5> plusOfSquare = {1, 3, 4, 5, 7};

struct Box {
    dvec3 minimum{0.0}, maximum{0.0};
};

// `working` is applied to each texel: sanitize, compression, colour space.
inline Square squareAt(const Image& image, int x, int y, const std::function<dvec3(dvec3)>& working = {}) {
    Square square;
    for (int i = 0; i < 9; ++i) {
        dvec3 colour(texelClamped(image, x + i % 3 - 1, y + i / 3 - 1));
        square[static_cast<size_t>(i)] = working ? working(colour) : colour;
    }
    return square;
}

inline Box extended(Box box, dvec3 colour) {
    return {glm::min(box.minimum, colour), glm::max(box.maximum, colour)};
}

inline Box boxOfPlus(const Square& square) {
    Box box{square[squareCentre], square[squareCentre]};
    for (size_t i : plusOfSquare)
        box = extended(box, square[i]);
    return box;
}

inline Box boxOfSquare(const Square& square) {
    Box box{square[squareCentre], square[squareCentre]};
    for (dvec3 colour : square)
        box = extended(box, colour);
    return box;
}

inline Box boxRounded(const Square& square) {
    Box whole = boxOfSquare(square), plus = boxOfPlus(square);
    return {(whole.minimum + plus.minimum) / 2.0, (whole.maximum + plus.maximum) / 2.0};
}

// Mean and standard deviation of the nine (of the population, not of a sample), in two passes.
inline Box boxOfVariance(const Square& square, double deviations = 1.0) {
    dvec3 mean(0.0), squares(0.0);
    for (dvec3 colour : square)
        mean += colour / 9.0;
    for (dvec3 colour : square)
        squares += (colour - mean) * (colour - mean) / 9.0;
    dvec3 reach = deviations * glm::sqrt(squares);
    return {mean - reach, mean + reach};
}

inline Box boxOfFourTaps(dvec3 centre, const std::array<dvec3, 4>& taps) {
    Box box{centre, centre};
    for (dvec3 tap : taps)
        box = extended(box, tap);
    return box;
}

// "sample offset 0.5-0.666 from texel center", nearer when faster; linear, ending at 10 px of motion.
inline double fourTapDistance(double motionPx) {
    double speed = std::clamp(motionPx / 10.0, 0.0, 1.0);
    return 0.666 - (0.666 - 0.5) * speed;
}

// Chroma sides reach an eighth of the luma side to either side of the centre's chroma.
inline Box shrinkChroma(Box box, dvec3 centreYcocg) {
    double reach = (box.maximum.x - box.minimum.x) / 8.0;
    return {{box.minimum.x, centreYcocg.y - reach, centreYcocg.z - reach},
            {box.maximum.x, centreYcocg.y + reach, centreYcocg.z + reach}};
}

inline dvec3 clampToBox(dvec3 history, Box box) {
    return glm::min(glm::max(history, box.minimum), box.maximum);
}

// Below this a side's half length counts as this.
inline constexpr double minBoxExtent = 1e-7;

// In the space where the box is [-1, 1]^3, divides by the largest coordinate if that is above 1. INSIDE,
// clip_aabb.
inline dvec3 clipToBoxCentre(dvec3 history, Box box) {
    dvec3 centre = (box.minimum + box.maximum) / 2.0;
    double largest = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        double halfLength = std::max((box.maximum[axis] - box.minimum[axis]) / 2.0, minBoxExtent);
        largest = std::max(largest, std::abs(history[axis] - centre[axis]) / halfLength);
    }
    return centre + (history - centre) / largest;
}

// The same with a fourth channel, which goes the same share of the way from p's. A q that is no number is the
// centre.
inline dvec4 clipAabb(Box box, dvec4 p, dvec4 q) {
    const dvec4 centre((box.minimum + box.maximum) / 2.0, p.w);
    double largest = 1.0;
    for (int channel = 0; channel < 4; ++channel)
        if (!std::isfinite(q[channel])) return centre;
    for (int axis = 0; axis < 3; ++axis) {
        const double halfLength = std::max((box.maximum[axis] - box.minimum[axis]) / 2.0, minBoxExtent);
        largest = std::max(largest, std::abs(q[axis] - centre[axis]) / halfLength);
    }
    return centre + (q - centre) / largest;
}

// The last point of the way from the current colour to history that lies in the box; the current colour is
// clamped into the box first.
inline dvec3 clipToBoxLine(dvec3 history, dvec3 current, Box box) {
    dvec3 start = clampToBox(current, box);
    double share = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        double way = history[axis] - start[axis];
        if (history[axis] > box.maximum[axis])
            share = std::min(share, (box.maximum[axis] - start[axis]) / way);
        if (history[axis] < box.minimum[axis])
            share = std::min(share, (box.minimum[axis] - start[axis]) / way);
    }
    return start + (history - start) * share;
}

} // namespace oracle
