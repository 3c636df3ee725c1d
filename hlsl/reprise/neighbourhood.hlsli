// SPDX-License-Identifier: Apache-2.0
// The box of colours around a pixel that history must stay in. INSIDE I5 to I7.
#ifndef REPRISE_NEIGHBOURHOOD_HLSLI
#define REPRISE_NEIGHBOURHOOD_HLSLI

// A shader whose colours are never negative defines this as 1 before the include: minimum and maximum then
// compare bits, which order as the floats >= 0 do, and some GPUs have an integer minimum of three in one
// instruction. Not for shader model 3, which has no bits.
#ifndef COLOURS_NOT_NEGATIVE
#define COLOURS_NOT_NEGATIVE 0
#endif

// Smallest and largest of three, per channel.
#if COLOURS_NOT_NEGATIVE
float3 min3(float3 a, float3 b, float3 c) {
    return asfloat(min(min(asint(a), asint(b)), asint(c)));
}

float3 max3(float3 a, float3 b, float3 c) {
    return asfloat(max(max(asint(a), asint(b)), asint(c)));
}
#else
float3 min3(float3 a, float3 b, float3 c) {
    return min(min(a, b), c);
}

float3 max3(float3 a, float3 b, float3 c) {
    return max(max(a, b), c);
}
#endif

// The 3x3 texels around a pixel. x and y run away from the pixel's own texel; which of the two directions is
// +1 does not matter to a box, so that quads and tiles can fill it mirrored.
struct Neighbourhood {
    float3 centre;
    float3 left, right, up, down;                        // (-1,0) (1,0) (0,-1) (0,1)
    float3 leftUp, rightUp, leftDown, rightDown;
};

// Three texels beside each other. In a mirrored row `right` is the outer one.
struct ColourRow {
    float3 left, centre, right;
};

Neighbourhood neighbourhoodOf(ColourRow up, ColourRow own, ColourRow down) {
    Neighbourhood n;
    n.leftUp = up.left;
    n.up = up.centre;
    n.rightUp = up.right;
    n.left = own.left;
    n.centre = own.centre;
    n.right = own.right;
    n.leftDown = down.left;
    n.down = down.centre;
    n.rightDown = down.right;
    return n;
}

struct ColourBox {
    float3 minimum, maximum;
};

// Smallest and largest of centre, left, right, up, down, per channel. Rows come first, here and in the
// square: a thread that resolves a column of pixels shares them.
ColourBox boxOfPlus(Neighbourhood n) {
    ColourBox box;
    box.minimum = min3(min3(n.left, n.right, n.centre), n.up, n.down);
    box.maximum = max3(max3(n.left, n.right, n.centre), n.up, n.down);
    return box;
}

// Smallest and largest of the 3x3, per channel.
ColourBox boxOfSquare(Neighbourhood n) {
    ColourBox box;
    box.minimum = min3(min3(n.left, n.right, n.centre), min3(n.leftUp, n.rightUp, n.up),
                       min3(n.leftDown, n.rightDown, n.down));
    box.maximum = max3(max3(n.left, n.right, n.centre), max3(n.leftUp, n.rightUp, n.up),
                       max3(n.leftDown, n.rightDown, n.down));
    return box;
}

// "Rounded": the mean of the box of the 3x3 and of the box of its plus (I6).
ColourBox boxRounded(Neighbourhood n) {
    ColourBox plus = boxOfPlus(n);
    ColourBox square = boxOfSquare(n);
    ColourBox box;
    box.minimum = 0.5 * (plus.minimum + square.minimum);
    box.maximum = 0.5 * (plus.maximum + square.maximum);
    return box;
}

// Mean of the 3x3 ± VARIANCE_BOX_DEVIATIONS standard deviations. Not of the talk.
static const float VARIANCE_BOX_DEVIATIONS = 1.0;
// The largest variance: colours that differ by more than 1e19 have squares that binary32 does not hold.
static const float MAX_VARIANCE = 1e38;
ColourBox boxOfVariance(Neighbourhood n) {
    float3 mean = (n.centre + ((n.left + n.right) + (n.up + n.down)) +
                   ((n.leftUp + n.rightUp) + (n.leftDown + n.rightDown))) / 9.0;
    // Moments about the centre texel: about 0 they would cancel in dark detail beside bright.
    float3 square = (n.left - n.centre) * (n.left - n.centre) + (n.right - n.centre) * (n.right - n.centre) +
                    (n.up - n.centre) * (n.up - n.centre) + (n.down - n.centre) * (n.down - n.centre) +
                    (n.leftUp - n.centre) * (n.leftUp - n.centre) +
                    (n.rightUp - n.centre) * (n.rightUp - n.centre) +
                    (n.leftDown - n.centre) * (n.leftDown - n.centre) +
                    (n.rightDown - n.centre) * (n.rightDown - n.centre);
    float3 variance = square / 9.0 - (mean - n.centre) * (mean - n.centre);
    // Rounding may leave less than 0; the comparison is false for the NaN of two infinite squares.
    variance = variance > 0.0 ? min(variance, MAX_VARIANCE) : 0.0;
    float3 deviation = sqrt(variance) * VARIANCE_BOX_DEVIATIONS;
    ColourBox box;
    box.minimum = mean - deviation;
    box.maximum = mean + deviation;
    return box;
}

// Four taps and the centre (I5).
ColourBox boxOfFourTaps(float3 centre, float3 a, float3 b, float3 c, float3 d) {
    ColourBox box;
    box.minimum = min(centre, min(min(a, b), min(c, d)));
    box.maximum = max(centre, max(max(a, b), max(c, d)));
    return box;
}

// Distance of the four taps in texels: 0.666 at rest, 0.5 from a motion of FOUR_TAP_STRICT_PX on: "higher
// velocity, closer to centre texel". The talk gives the two distances, not the motion: 10 px is empirical.
static const float FOUR_TAP_STRICT_PX = 10.0;
float fourTapDistance(float motionPx) {
    return lerp(0.666, 0.5, saturate(motionPx / FOUR_TAP_STRICT_PX));
}

// I7: in YCoCg the chroma sides of the box shrink to an eighth of the luma side, around the centre's chroma.
ColourBox shrinkChroma(ColourBox box, float3 centreYcocg) {
    float extent = 0.125 * (box.maximum.x - box.minimum.x);
    box.minimum.yz = centreYcocg.yz - extent;
    box.maximum.yz = centreYcocg.yz + extent;
    return box;
}

#endif
