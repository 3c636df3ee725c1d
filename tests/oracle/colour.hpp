// SPDX-License-Identifier: Apache-2.0
// Colour: repair, luminance, YCoCg and the compression of bright colours.
#pragma once

#include <algorithm>

#include <glm/glm.hpp>

namespace oracle {

using glm::dvec3;

// The largest finite binary16.
inline constexpr double maxColour = 65504.0;

// NaN and negative to 0, more than binary16 holds to its largest.
inline double sanitize(double value) {
    return value > 0.0 ? std::min(value, maxColour) : 0.0;
}

inline dvec3 sanitize(dvec3 colour) {
    return {sanitize(colour.r), sanitize(colour.g), sanitize(colour.b)};
}

// The same repair as a share of maxColour.
inline dvec3 unitColour(dvec3 colour) {
    return sanitize(colour) / maxColour;
}

// Rec. 709 primaries, linear.
inline double luminance(dvec3 colour) {
    return 0.2126 * colour.r + 0.7152 * colour.g + 0.0722 * colour.b;
}

// The lifting form: Co = R - B, Cg = G - (R + B) / 2, each halved to stay in [-1/2, 1/2]; Y = (R + 2 G + B)
// / 4.
inline dvec3 rgbToYcocg(dvec3 rgb) {
    double mean = (rgb.r + rgb.b) / 2.0;
    return {(mean + rgb.g) / 2.0, (rgb.r - rgb.b) / 2.0, (rgb.g - mean) / 2.0};
}

inline dvec3 ycocgToRgb(dvec3 ycocg) {
    double mean = ycocg.x - ycocg.z;
    return {mean + ycocg.y, ycocg.x + ycocg.z, mean - ycocg.y};
}

inline double maxComponent(dvec3 colour) {
    return std::max({colour.r, colour.g, colour.b});
}

// Reinhard's x / (1 + x) of the largest component, the same factor for all three.
inline dvec3 compressHdr(dvec3 colour) {
    return colour / (1.0 + maxComponent(colour));
}

// Solves compressHdr for its argument. Results end at maxColour: what would need more is as bright as that.
inline dvec3 expandHdr(dvec3 compressed) {
    double complementOfBrightest = 1.0 / (1.0 + maxColour);
    double complement = std::max(1.0 - maxComponent(compressed), complementOfBrightest);
    return glm::min(compressed / complement, dvec3(maxColour));
}

} // namespace oracle
