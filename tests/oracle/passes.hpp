// SPDX-License-Identifier: Apache-2.0
// Whole passes in double precision, composed of the oracle's functions, one pixel at a time.
//
// A device does not get every quantity exactly: coordinates are rounded, filters have weights of few bits,
// sums are rounded. Each such quantity of a pixel is numbered in the order of use, and `Disturbance` moves
// one of them by its error. The sum of what each moves the result by is the bound to which a device's result
// is held: it is small where the pass is well conditioned and says by itself where it is not.
#pragma once

#include "oracle.hpp"

#include <limits>

namespace oracle {

class Disturbance {
public:
    // Moves quantity number `target` by `sign` times its error; -1 moves none.
    explicit Disturbance(int target = -1, double sign = 0.0) : target_(target), sign_(sign) {}

    double operator()(double value, double error) { return next() ? value + sign_ * error : value; }
    dvec2 operator()(dvec2 value, dvec2 error) {
        return {(*this)(value.x, error.x), (*this)(value.y, error.y)};
    }
    dvec3 operator()(dvec3 value, dvec3 error) {
        return {(*this)(value.x, error.x), (*this)(value.y, error.y), (*this)(value.z, error.z)};
    }
    int count() const { return count_; }

private:
    bool next() { return count_++ == target_; }
    int target_;
    double sign_;
    int count_ = 0;
};

// --- Temporal anti-aliasing

struct TemporalAa {
    enum class Neighbourhood { fourTap, square, rounded, variance };
    enum class Constraint { none, clamp, clipCentre, clipLine };
    enum class Unjitter { off, bilinear, gaussian };
    bool motion = true, closestFragment = true, ycocg = false, luminanceFeedback = false, motionBlur = true;
    bool hdrWeight = false, bicubic = false, depthReversed = false;
    Neighbourhood neighbourhood = Neighbourhood::rounded;
    Constraint constraint = Constraint::clipCentre;
    Unjitter unjitter = Unjitter::bilinear;

    dvec2 jitterPx{0.0}, motionToUv{1.0};
    double historyValid = 1.0, feedbackMin = 0.88, feedbackMax = 0.97, blurFromPx = 2.0, blurToPx = 15.0;

    const Image* colour = nullptr;
    const Image* depth = nullptr;
    const Image* velocity = nullptr;
    const Image* history = nullptr;
    // Of MOTION_CAMERA: velocity is then what cameraVelocity() gives, and this its error in float32.
    const Image* velocityError = nullptr;

    double filterErrorPx = 0.0; // of the weights of the device's linear filter
};

struct TemporalAaPixel {
    dvec3 history{0.0}, colour{0.0};
};

// Of float32, in the working space: eight roundings of half a unit in the last place of the largest operand.
inline constexpr double roundings = 0x1p-21;

inline dvec3 toWorking(const TemporalAa& taa, dvec3 colour) {
    colour = sanitize(colour);
    if (taa.hdrWeight) colour = compressHdr(colour);
    return taa.ycocg ? rgbToYcocg(colour) : colour;
}

inline dvec3 fromWorking(const TemporalAa& taa, dvec3 colour) {
    if (taa.ycocg) colour = glm::max(ycocgToRgb(colour), dvec3(0.0));
    if (taa.hdrWeight) colour = expandHdr(colour);
    return glm::min(colour, dvec3(maxColour));
}

// Error of a coordinate in UV: three roundings of a number of up to 1 or |uv|, and the filter's weights.
inline dvec2 uvError(const TemporalAa& taa, dvec2 uv) {
    return 3.0 * 0x1p-24 * glm::max(glm::abs(uv), dvec2(1.0)) + taa.filterErrorPx / taa.colour->extent();
}

inline dvec2 disturbedUv(const TemporalAa& taa, dvec2 uv, Disturbance& disturb) {
    return disturb(uv, uvError(taa, uv));
}

inline dvec2 motionAt(const TemporalAa& taa, int x, int y, Disturbance& disturb) {
    if (!taa.motion) return dvec2(0.0);
    ivec2 offset(0);
    if (taa.closestFragment) offset = closestFragment(depthSquareAt(*taa.depth, x, y), taa.depthReversed);
    dvec2 motion = dvec2(texelClamped(*taa.velocity, x + offset.x, y + offset.y)) * taa.motionToUv;
    if (!taa.velocityError) return motion;
    return disturb(motion, dvec2(texelClamped(*taa.velocityError, x + offset.x, y + offset.y)));
}

// What the neighbourhood gives: the box, the current colour to blend with, and the largest number in reach,
// to which roundings are relative.
struct Surroundings {
    Box box;
    dvec3 current{0.0};
    double largest = 0.0;
};

inline Surroundings surroundingsFourTap(const TemporalAa& taa, int x, int y, dvec2 uv, dvec2 motionPx,
                                        Disturbance& disturb) {
    dvec2 texel = 1.0 / taa.colour->extent();
    auto read = [&](dvec2 place) {
        return toWorking(taa, dvec3(sampleLinear(*taa.colour, disturbedUv(taa, place, disturb))));
    };
    double reach = fourTapDistance(glm::length(motionPx));
    std::array<dvec3, 4> taps;
    for (size_t i = 0; i < 4; ++i)
        taps[i] = read(uv + texel * reach * dvec2(i % 2 ? 1.0 : -1.0, i < 2 ? -1.0 : 1.0));
    dvec3 centre = toWorking(taa, dvec3(texelClamped(*taa.colour, x, y)));
    Surroundings result;
    result.box = boxOfFourTaps(centre, taps);
    if (taa.ycocg) result.box = shrinkChroma(result.box, centre);
    bool unjittered = taa.unjitter != TemporalAa::Unjitter::off;
    result.current = unjittered ? read(uv + taa.jitterPx * texel) : centre;
    return result;
}

inline dvec3 unjittered(const TemporalAa& taa, const Square& square) {
    using Unjitter = TemporalAa::Unjitter;
    if (taa.unjitter == Unjitter::off) return square[squareCentre];
    auto weights = [&](double jitter) {
        return taa.unjitter == Unjitter::bilinear ? unjitterWeightsBilinear(jitter)
                                                  : unjitterWeightsGaussian(jitter);
    };
    return weighSquare(square, weights(taa.jitterPx.x), weights(taa.jitterPx.y));
}

inline Surroundings surroundingsSquare(const TemporalAa& taa, int x, int y) {
    using Neighbourhood = TemporalAa::Neighbourhood;
    Square square = squareAt(*taa.colour, x, y, [&](dvec3 colour) { return toWorking(taa, colour); });
    Surroundings result;
    result.box = taa.neighbourhood == Neighbourhood::rounded    ? boxRounded(square)
                 : taa.neighbourhood == Neighbourhood::variance ? boxOfVariance(square)
                                                                : boxOfSquare(square);
    if (taa.ycocg) result.box = shrinkChroma(result.box, square[squareCentre]);
    result.current = unjittered(taa, square);
    return result;
}

// The 5x5 around the pixel holds the 4x4 whose reads a quad or a thread shares.
inline double largestAround(const TemporalAa& taa, int x, int y) {
    double largest = 0.0;
    for (int i = 0; i < 25; ++i) {
        dvec3 colour =
            glm::abs(toWorking(taa, dvec3(texelClamped(*taa.colour, x + i % 5 - 2, y + i / 5 - 2))));
        largest = std::max({largest, colour.x, colour.y, colour.z});
    }
    return largest;
}

inline dvec3 constrained(const TemporalAa& taa, dvec3 history, const Surroundings& around) {
    using Constraint = TemporalAa::Constraint;
    switch (taa.constraint) {
    case Constraint::clamp:
        return clampToBox(history, around.box);
    case Constraint::clipCentre:
        return clipToBoxCentre(history, around.box);
    case Constraint::clipLine:
        return clipToBoxLine(history, around.current, around.box);
    case Constraint::none:
        break;
    }
    return history;
}

inline double feedback(const TemporalAa& taa, dvec3 current, dvec3 history) {
    if (!taa.luminanceFeedback) return taa.feedbackMax;
    auto brightness = [&](dvec3 colour) { return taa.ycocg ? colour.x : luminance(colour); };
    return luminanceFeedback(brightness(current), brightness(history), taa.feedbackMin, taa.feedbackMax);
}

// How far apart the texels are that a cubic read at uv weighs.
inline dvec3 rangeAround(const Image& image, dvec2 uv) {
    Box box{dvec3(maxColour), dvec3(0.0)};
    ivec2 first(glm::floor(glm::clamp(uv, -1.0, 2.0) * image.extent() - 0.5));
    for (int i = 0; i < 16; ++i)
        box = extended(box, dvec3(texelClamped(image, first.x + i % 4 - 1, first.y + i / 4 - 1)));
    return box.maximum - box.minimum;
}

inline dvec3 historyAt(const TemporalAa& taa, dvec2 uv) {
    return toWorking(taa, taa.bicubic ? sampleCatmullRom5(*taa.history, uv)
                                      : dvec3(sampleLinear(*taa.history, uv)));
}

// Mean of the seven reads along the motion, each with the error of its own coordinate.
inline dvec3 blurredAt(const TemporalAa& taa, dvec2 uv, dvec2 motion, Disturbance& disturb) {
    dvec3 sum(0.0);
    for (int tap = -3; tap <= 3; ++tap) {
        dvec2 place = disturbedUv(taa, uv + motion * (0.5 * tap / 6.0), disturb);
        sum += sanitize(dvec3(sampleLinear(*taa.colour, place))) / 7.0;
    }
    return sum;
}

inline TemporalAaPixel temporalAa(const TemporalAa& taa, int x, int y, Disturbance disturb,
                                  int* count = nullptr) {
    dvec2 extent = taa.colour->extent();
    dvec2 uv = dvec2(x + 0.5, y + 0.5) / extent;
    dvec2 motion = motionAt(taa, x, y, disturb);
    bool fourTap = taa.neighbourhood == TemporalAa::Neighbourhood::fourTap;
    Surroundings around = fourTap ? surroundingsFourTap(taa, x, y, uv, motion * extent, disturb)
                                  : surroundingsSquare(taa, x, y);
    dvec3 rounding(roundings * largestAround(taa, x, y));
    around.box.minimum = disturb(around.box.minimum, rounding);
    around.box.maximum = disturb(around.box.maximum, rounding);
    around.current = disturb(around.current, rounding);

    dvec2 prevUv = disturbedUv(taa, uv - motion, disturb);
    dvec3 raw = historyAt(taa, prevUv);
    dvec3 rawError = roundings * glm::abs(raw);
    // The five reads of a cubic have coordinates of their own; moving all alike moves less than moving each.
    dvec2 errorPx = uvError(taa, prevUv) * extent;
    if (taa.bicubic) rawError += 2.0 * (errorPx.x + errorPx.y) * rangeAround(*taa.history, prevUv);
    dvec3 history = constrained(taa, disturb(raw, rawError), around);
    double weight = isInsideUv(prevUv) ? feedback(taa, around.current, history) * taa.historyValid : 0.0;
    TemporalAaPixel pixel;
    dvec3 blended = blendHistory(around.current, history, weight);
    pixel.history = fromWorking(taa, disturb(blended, rounding + roundings * glm::abs(history)));
    pixel.colour = pixel.history;
    if (taa.motionBlur) {
        double trust = motionBlurTrust(glm::length(motion * extent), taa.blurFromPx, taa.blurToPx);
        trust = taa.historyValid > 0.0 ? std::clamp(disturb(trust, roundings), 0.0, 1.0) : 1.0;
        dvec3 blurred = blurredAt(taa, uv + taa.jitterPx / extent, motion, disturb);
        pixel.colour = blurred * (1.0 - trust) + pixel.history * trust;
    }
    if (count) *count = disturb.count();
    return pixel;
}

inline TemporalAaPixel temporalAa(const TemporalAa& taa, int x, int y) {
    return temporalAa(taa, x, y, Disturbance());
}

// The bound of the pixel: the sum over the disturbances of the larger of the two changes that each makes.
inline TemporalAaPixel temporalAaError(const TemporalAa& taa, int x, int y) {
    int count = 0;
    TemporalAaPixel exact = temporalAa(taa, x, y, Disturbance(), &count), error;
    for (int target = 0; target < count; ++target) {
        TemporalAaPixel up = temporalAa(taa, x, y, Disturbance(target, 1.0));
        TemporalAaPixel down = temporalAa(taa, x, y, Disturbance(target, -1.0));
        error.history +=
            glm::max(glm::abs(up.history - exact.history), glm::abs(down.history - exact.history));
        error.colour += glm::max(glm::abs(up.colour - exact.colour), glm::abs(down.colour - exact.colour));
    }
    return error;
}

// --- Velocity

// Where a device works in float32, the error of a motion in pixels is that of two coordinates in NDC: a
// matrix product of four terms and a division, each relative to the largest term, which a test states.
struct CameraVelocity {
    Camera current, previous;
    dvec2 jitterPx{0.0}, extent{1.0};
    bool depthLinear = false, sharesY = false;
};

// currUv - prevUv of the static surface of depth `depth` that pixel (x, y) of the jittered rendering shows.
inline dvec2 cameraVelocity(const CameraVelocity& pass, int x, int y, double depth) {
    dvec2 uv = (dvec2(x + 0.5, y + 0.5) - pass.jitterPx) / pass.extent;
    double linear = pass.depthLinear ? depth : linearDepth(depth, pass.current.viewToClip);
    return uv - reprojectLinearDepth(uv, linear, pass.current, pass.previous, pass.sharesY);
}

// Unjittered clip positions of a triangle in both frames, each with w > 0.
struct MovingTriangle {
    std::array<dvec4, 3> clip, prevClip;
};

// Perspective-correct weights of the vertices at a place of the image: sum b (xy - ndc w) = 0, sum b = 1.
inline dvec3 barycentrics(const MovingTriangle& triangle, dvec2 ndc) {
    glm::dmat3 rows(1.0);
    for (int i = 0; i < 3; ++i) {
        dvec4 clip = triangle.clip[static_cast<size_t>(i)];
        rows[i] = {clip.x - ndc.x * clip.w, clip.y - ndc.y * clip.w, 1.0};
    }
    return glm::inverse(rows) * dvec3(0.0, 0.0, 1.0);
}

inline bool covers(const MovingTriangle& triangle, dvec2 ndc) {
    dvec3 weights = barycentrics(triangle, ndc);
    return weights.x >= 0.0 && weights.y >= 0.0 && weights.z >= 0.0;
}

inline dvec4 interpolated(const std::array<dvec4, 3>& vertices, dvec3 weights) {
    return weights.x * vertices[0] + weights.y * vertices[1] + weights.z * vertices[2];
}

// currUv - prevUv of the point of the triangle seen at ndc (unjittered).
inline dvec2 objectVelocity(const MovingTriangle& triangle, dvec2 ndc) {
    dvec3 weights = barycentrics(triangle, ndc);
    return motionFromClip(interpolated(triangle.clip, weights), interpolated(triangle.prevClip, weights));
}

} // namespace oracle
