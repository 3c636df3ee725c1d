// SPDX-License-Identifier: Apache-2.0
#include "footprint.hpp"

namespace passes {

namespace {

bool within(glm::ivec2 texel, glm::ivec2 first, glm::ivec2 last) {
    return texel.x >= first.x && texel.x <= last.x && texel.y >= first.y && texel.y <= last.y;
}

// 3x3; with shared reads the 4x4 around the quad, whose pixels take each other's values through a difference.
bool inNeighbourhood(const Variant& variant, Stage stage, glm::ivec2 texel, glm::ivec2 pixel) {
    const bool shared = stage == Stage::fragment && reprise::switchValue(variant, "QUAD_SHARING") == "on";
    if (!shared) return within(texel, pixel - 1, pixel + 1);
    const glm::ivec2 quad = pixel / 2 * 2;
    return within(texel, quad - 1, quad + 2);
}

glm::dvec2 motionAt(const Variant& variant, const TemporalAaFrame& frame, glm::ivec2 pixel) {
    if (reprise::switchValue(variant, "MOTION") == "off") return glm::dvec2(0.0);
    glm::ivec2 from = pixel;
    if (reprise::switchValue(variant, "CLOSEST_FRAGMENT") == "on") {
        const bool reversed = reprise::switchValue(variant, "DEPTH_REVERSED") == "on";
        from += oracle::closestFragment(oracle::depthSquareAt(oracleImage(frame.depth), pixel.x, pixel.y),
                                        reversed);
        from = glm::clamp(from, glm::ivec2(0), glm::ivec2(frame.width() - 1, frame.height() - 1));
    }
    return motionOf(variant, frame, from.x, from.y);
}

// First texel of the 2x2 that a linear read at `px` takes, clamped as the sampler does.
glm::ivec2 firstTexel(glm::dvec2 px) {
    return glm::ivec2(glm::floor(glm::clamp(px, -1e6, 1e6) - 0.5));
}

// The filter multiplies a texel of weight 0 too, and rounding may put a read at a texel's centre on either
// side of it: so one texel to each side more than the weights say.
bool inLinearRead(const TemporalAaFrame& frame, glm::ivec2 texel, glm::dvec2 px, int reach) {
    const glm::ivec2 last(frame.width() - 1, frame.height() - 1);
    const glm::ivec2 first = firstTexel(px);
    const glm::ivec2 from = glm::clamp(first - reach, glm::ivec2(0), last);
    return within(texel, from, glm::clamp(first + 1 + reach, glm::ivec2(0), last));
}

bool inHistoryRead(const Variant& variant, const TemporalAaFrame& frame, glm::ivec2 texel, glm::ivec2 pixel) {
    const glm::dvec2 extent(frame.width(), frame.height());
    const glm::dvec2 px = glm::dvec2(pixel) + 0.5 - motionAt(variant, frame, pixel) * extent;
    const bool bicubic = reprise::switchValue(variant, "HISTORY_FILTER") == "bicubic";
    return inLinearRead(frame, texel, px, bicubic ? 2 : 1);
}

bool inBlur(const Variant& variant, const TemporalAaFrame& frame, glm::ivec2 texel, glm::ivec2 pixel) {
    const glm::dvec2 motionPx = motionAt(variant, frame, pixel) * glm::dvec2(frame.width(), frame.height());
    const glm::dvec2 jitter(frame.parameters.gJitterPx[0], frame.parameters.gJitterPx[1]);
    for (int tap = -3; tap <= 3; ++tap)
        if (inLinearRead(frame, texel, glm::dvec2(pixel) + 0.5 + jitter + motionPx * (tap / 12.0), 1))
            return true;
    return false;
}

} // namespace

bool mayReach(const Variant& variant, Stage stage, const TemporalAaFrame& frame, std::string_view input,
              glm::ivec2 texel, int x, int y, Reached output) {
    const glm::ivec2 pixel(x, y);
    if (input == "gHistoryColour") return inHistoryRead(variant, frame, texel, pixel);
    if (inNeighbourhood(variant, stage, texel, pixel)) return true;
    return input == "gInColour" && output == Reached::colourOutput && inBlur(variant, frame, texel, pixel);
}

} // namespace passes
