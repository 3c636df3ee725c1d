// SPDX-License-Identifier: Apache-2.0
// Temporal reprojection anti-aliasing: history fetched along the motion, held to the neighbourhood of the
// current colour, blended, and kept for the next frame. INSIDE I4 to I9, step by step in the talk's order.
//
// gInColour       linear scene-referred colour, rendered with the jitter gJitterPx
// gInColourFiltered  the same image, for reads between texels (four taps, motion blur)
// gInDepth        R32F or D32F device depth of the same rendering (CLOSEST_FRAGMENT, MOTION_CAMERA)
// gInVelocity     motion, times gMotionToUv = currUv - prevUv without jitter (MOTION_VECTORS)
// gHistoryColour  gOutHistory of the frame before; any content where gHistoryValid is 0
// gOutHistory     the resolved colour, unjittered; also what is shown, without MOTION_BLUR_FALLBACK
// gOutColour      what is shown, with MOTION_BLUR_FALLBACK
// Colours are [0, 65504] in any float or unorm format; NaN, infinity and negatives are read as finite
// colours, so none reaches an output. Motion that is NaN or leaves the image drops history for that pixel.
// Longer than 250 lines: one body with three ways to read the neighbourhood (pixel alone, quad, column).

// The box compares colours as integers where none is negative.
#define COLOURS_NOT_NEGATIVE COLOUR_SPACE_RGB

#include "reprise/closest_fragment.hlsli"
#include "reprise/colour.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/feedback.hlsli"
#include "reprise/history_constraint.hlsli"
#include "reprise/motion_blur.hlsli"
#include "reprise/neighbourhood.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/quad_sharing.hlsli"
#include "reprise/reprojection.hlsli"
#include "reprise/resampling.hlsli"
#include "reprise/unjitter.hlsli"

BINDING(0) cbuffer TemporalAaParameters {
    float4 gOutputSize;   // width, height, 1 / width, 1 / height
    float2 gJitterPx;     // of this frame, [-0.5, 0.5]
    float2 gMotionToUv;   // (1, 1) for currUv - prevUv in UV
    float gHistoryValid;  // 1, or 0 on the first frame, after a cut, a gap or a resize
    float gFeedbackMin;   // history weight where luminances differ (FEEDBACK_LUMINANCE), [0, 1)
    float gFeedbackMax;   // history weight where they agree, or the constant one, [0, 1)
    float gBlurFromPx;    // motion up to which history is shown
    float gBlurToPx;      // motion from which motion blur alone is shown
    row_major float4x4 gReprojection;   // MOTION_CAMERA: NDC and device depth to prev clip
};

TEXTURE_POINT(gInColour, 1);
TEXTURE_POINT(gInDepth, 2);
TEXTURE_POINT(gInVelocity, 3);
TEXTURE_LINEAR(gHistoryColour, 4);
TEXTURE_LINEAR(gInColourFiltered, 5);

// --- The space in which neighbourhood, clip and blend work: shares of MAX_COLOUR, or compressed

float3 toWorkingSpace(float3 colour) {
#if HDR_WEIGHT
    colour = compressHdr(sanitize(colour));
#else
    colour = toUnitColour(colour);
#endif
#if COLOUR_SPACE_YCOCG
    colour = rgbToYcocg(colour);
#endif
    return colour;
}

float3 fromWorkingSpace(float3 colour) {
#if COLOUR_SPACE_YCOCG
    colour = saturate(ycocgToRgb(colour));   // luma of one texel and chroma of another may lie outside
#endif
#if HDR_WEIGHT
    return expandHdr(colour);
#else
    return fromUnitColour(colour);
#endif
}

#if HDR_WEIGHT
static const float WORKING_RANGE = 1.0;
#else
static const float WORKING_RANGE = MAX_COLOUR;
#endif

// In the unit that FEEDBACK_LUMINANCE_FLOOR is in.
float workingLuminance(float3 colour) {
#if COLOUR_SPACE_YCOCG
    return colour.x * WORKING_RANGE;
#else
    return dot(colour, LUMINANCE_WEIGHTS * WORKING_RANGE);
#endif
}

// --- Loads

float3 readColour(float2 uv) {
    return toWorkingSpace(SAMPLE(gInColour, uv).rgb);
}

float3 readColourFiltered(float2 uv) {
    return toWorkingSpace(SAMPLE(gInColourFiltered, uv).rgb);
}

// Whether 3x3 depths are read; else motion is that of the pixel itself.
#define SEEKS_CLOSEST (CLOSEST_FRAGMENT && !MOTION_OFF)

// Of the fragment at a texel, with its device depth. The camera's is what camera_velocity computes, without
// its image. A closest fragment is in the image: depths beyond an edge equal those at it, which win.
float2 motionOf(float2 uv, float depth) {
#if MOTION_VECTORS
    return SAMPLE(gInVelocity, uv).rg * gMotionToUv;
#elif MOTION_CAMERA
    float2 currUv = uv - gJitterPx * gOutputSize.zw;
    return currUv - reprojectDeviceDepth(currUv, depth, gReprojection);
#else
    return float2(0.0, 0.0);
#endif
}

// Of the pixel itself.
float2 ownMotion(float2 uv) {
#if MOTION_CAMERA
    return motionOf(uv, SAMPLE(gInDepth, uv).r);
#else
    return motionOf(uv, 0.0);
#endif
}

float3 readHistory(float2 uv) {
#if HISTORY_FILTER_BICUBIC
    return toWorkingSpace(sampleCatmullRom5(TEXTURE_ARGUMENT(gHistoryColour), uv, gOutputSize));
#else
    return toWorkingSpace(SAMPLE(gHistoryColour, uv).rgb);
#endif
}

// --- Steps

// The clip can do with the sum of the two boxes whose mean is the rounded one.
#define BOX_IS_SUM (NEIGHBOURHOOD_ROUNDED && CONSTRAINT_CLIP_CENTRE && COLOUR_SPACE_RGB)
#if BOX_IS_SUM
static const float BOX_TIMES = 2.0;
#else
static const float BOX_TIMES = 1.0;
#endif

ColourBox neighbourhoodBox(Neighbourhood n) {
#if BOX_IS_SUM
    ColourBox box = twiceBoxRounded(n);
#elif NEIGHBOURHOOD_ROUNDED
    ColourBox box = boxRounded(n);
#elif NEIGHBOURHOOD_VARIANCE
    ColourBox box = boxOfVariance(n);
#else
    ColourBox box = boxOfSquare(n);
#endif
#if COLOUR_SPACE_YCOCG
    box = shrinkChroma(box, n.centre);
#endif
    return box;
}

// `side` is the direction of +1 in a mirrored neighbourhood.
float3 unjitteredColour(Neighbourhood n, float2 side) {
    float2 jitterPx = gJitterPx * side;
#if UNJITTER_BILINEAR
    return weighNeighbourhood(n, unjitterWeightsBilinear(jitterPx.x), unjitterWeightsBilinear(jitterPx.y));
#elif UNJITTER_GAUSSIAN
    return weighNeighbourhood(n, unjitterWeightsGaussian(jitterPx.x), unjitterWeightsGaussian(jitterPx.y));
#else
    return n.centre;
#endif
}

float3 constrain(float3 history, float3 current, ColourBox box) {
#if CONSTRAINT_CLAMP
    return clampToBox(history, box);
#elif CONSTRAINT_CLIP_CENTRE
    return clipToBoxCentre(history, box, BOX_TIMES, MIN_BOX_EXTENT / WORKING_RANGE);
#elif CONSTRAINT_CLIP_LINE
    return clipToBoxLine(history, current, box);
#else
    return history;
#endif
}

struct Resolved {
    float3 history;
    float3 colour;
};

// Validate, constrain, blend. `history` is what was read at uv - motion.
Resolved resolve(float2 uv, float2 motion, float3 history, float3 current, ColourBox box) {
    history = constrain(history, current, box);

#if FEEDBACK_LUMINANCE
    float weight =
        luminanceFeedback(workingLuminance(current), workingLuminance(history), gFeedbackMin, gFeedbackMax);
#else
    float weight = gFeedbackMax;
#endif
    weight = isInsideUv(uv - motion) ? weight * gHistoryValid : 0.0;

    Resolved resolved;
    resolved.history = fromWorkingSpace(blendHistory(current, history, weight));
    resolved.colour = resolved.history;
#if MOTION_BLUR_FALLBACK
    // Fast fragments show no history at all: it trails where no neighbour forces it out. Without history, as
    // after a camera cut, motion leads nowhere and there is nothing to conceal.
    float trust = motionBlurTrust(length(motion * gOutputSize.xy), gBlurFromPx, gBlurToPx);
    trust = gHistoryValid > 0.0 ? trust : 1.0;
    float2 unjitteredUv = uv + gJitterPx * gOutputSize.zw;
    float3 blurred = sampleMotion(TEXTURE_ARGUMENT(gInColourFiltered), unjitteredUv, motion);
    resolved.colour = lerp(blurred, resolved.history, trust);
#endif
    return resolved;
}

#if NEIGHBOURHOOD_FOUR_TAP

// The first form of the talk: four taps whose distance falls with motion.
Resolved resolveFourTap(float2 uv, float2 motion, float3 history) {
    float2 reach = fourTapDistance(length(motion * gOutputSize.xy)) * gOutputSize.zw;
    float3 centre = readColour(uv);
    ColourBox box = boxOfFourTaps(centre, readColourFiltered(uv - reach),
                                  readColourFiltered(uv + float2(reach.x, -reach.y)),
                                  readColourFiltered(uv + float2(-reach.x, reach.y)),
                                  readColourFiltered(uv + reach));
#if COLOUR_SPACE_YCOCG
    box = shrinkChroma(box, centre);
#endif
#if UNJITTER_OFF
    return resolve(uv, motion, history, centre, box);
#else
    return resolve(uv, motion, history, readColourFiltered(uv + gJitterPx * gOutputSize.zw), box);
#endif
}

#endif

#if STAGE_COMPUTE

// --- Compute: a thread resolves a column of pixels, so that a row of texels is read once for the pixels
// above, on and below it; with QUAD_SHARING a row of the subgroup reads each texel once. docs/temporal_aa.md
// says what was measured. The chain of depth, motion and history goes first, its waits the longest; the
// colours are read before the history, which waits for motion. Places are sums of UV: literal offsets in a
// read take an H200 a tenth longer.

static const int COLUMN = 6;   // pixels_per_thread of the table
static const int ROWS = COLUMN + 2;   // of texels; row 0 is the one above the column

BINDING(16) RWTexture2D<float4> gOutHistory;
#if MOTION_BLUR_FALLBACK
BINDING(17) RWTexture2D<float4> gOutColour;
#endif

// Depths of two rows, the first at uv: left, centre and right in xyz. `side` is the direction of +1.
void readDepthRows(float2 uv, float2 side, out float3 upper, out float3 lower) {
    float2 halfTexel = 0.5 * gOutputSize.zw;
#if QUAD_SHARING
    float4 four = GATHER_RED(gInDepth, uv + float2(side.x * halfTexel.x, halfTexel.y));
    float2 own = side.x > 0.0 ? four.wx : four.zy;
    float2 outer = side.x > 0.0 ? four.zy : four.wx;
    float2 inner = quadSwapX(own, side);
    upper = float3(inner.x, own.x, outer.x);
    lower = float3(inner.y, own.y, outer.y);
#else
    float4 left = GATHER_RED(gInDepth, uv + float2(-halfTexel.x, halfTexel.y));
    float4 right = GATHER_RED(gInDepth, uv + halfTexel);
    upper = float3(left.w, left.z, right.z);
    lower = float3(left.x, left.y, right.y);
#endif
}

#if !NEIGHBOURHOOD_FOUR_TAP

#if QUAD_SHARING

// The texel beyond the left (even index) or right (odd) end of row index / 2; firstUv is the column's first
// pixel.
float3 readEnd(float2 firstUv, uint index) {
    float beyond = (index & 1u) != 0u ? float(SUBGROUP_ROW_WIDTH) : -1.0;
    float2 offset = float2(beyond - float(subgroupColumn()), float(index >> 1u) - 1.0);
    return readColour(firstUv + offset * gOutputSize.zw);
}

// Each invocation reads its own column, and one or two of the texels beyond the ends of the rows. Mirrored:
// +1 is outward.
void readColourRows(float2 firstUv, float2 side, out ColourRow rows[ROWS]) {
    uint column = subgroupColumn();
    // Those beyond the last row would be read for nothing, from memory perhaps.
    float3 ends = readEnd(firstUv, min(column, 2u * ROWS - 1u)), moreEnds = ends;
    if (SUBGROUP_ROW_WIDTH < 2u * ROWS) moreEnds = readEnd(firstUv, column + SUBGROUP_ROW_WIDTH);
    [unroll] for (uint y = 0; y < ROWS; ++y)
        rows[y].centre = readColour(firstUv + float2(0.0, (float(y) - 1.0) * gOutputSize.w));
    // The first invocation hands the right end of a row to the last, which hands it the left one.
    uint endLane = laneInRow(column == 0u ? 1u : 0u);
    [unroll] for (uint row = 0; row < ROWS; ++row) {
        uint lane = endLane + 2u * row;
        float3 end = 2u * row < SUBGROUP_ROW_WIDTH ? WaveReadLaneAt(ends, lane)
                                                   : WaveReadLaneAt(moreEnds, lane - SUBGROUP_ROW_WIDTH);
        rows[row].left = quadSwapX(rows[row].centre, side);
        rows[row].right = outerNeighbour(rows[row].centre, end);
    }
}

#else

ColourRow readColourRow(float2 uv) {
    ColourRow row;
    row.left = readColour(uv - float2(gOutputSize.z, 0.0));
    row.centre = readColour(uv);
    row.right = readColour(uv + float2(gOutputSize.z, 0.0));
    return row;
}

#endif

#endif

// A store to no texel of the image has no effect.
void write(uint2 pixel, Resolved resolved) {
    gOutHistory[pixel] = float4(resolved.history, 1.0);
#if MOTION_BLUR_FALLBACK
    gOutColour[pixel] = float4(resolved.colour, 1.0);
#endif
}

// Two pixels below each other. With QUAD_SHARING the halves of a row of the subgroup exchange theirs, so that
// a store covers blocks of 2x2 texels: those of RGBA16F lie together in a sector of an H200's cache, and half
// a sector costs as much as a whole one.
void writePair(uint2 upperPixel, Resolved upper, Resolved lower) {
#if QUAD_SHARING
    uint halfWidth = SUBGROUP_ROW_WIDTH / 2u;
    bool inRightHalf = (upperPixel.x & halfWidth) != 0u;
    Resolved exchanged;
    exchanged.history = halfRowSwap(inRightHalf ? upper.history : lower.history);
    exchanged.colour = exchanged.history;
#if MOTION_BLUR_FALLBACK
    exchanged.colour = halfRowSwap(inRightHalf ? upper.colour : lower.colour);
#endif
    Resolved left = upper, right = exchanged;
    if (inRightHalf) {
        left = exchanged;
        right = lower;
    }
    uint2 leftPixel = uint2(upperPixel.x & ~halfWidth, upperPixel.y + (inRightHalf ? 1u : 0u));
    write(leftPixel, left);
    write(leftPixel + uint2(halfWidth, 0u), right);
#else
    write(upperPixel, upper);
    write(upperPixel + uint2(0u, 1u), lower);
#endif
}

[numthreads(32, 4, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    uint2 firstPixel = uint2(thread.x, thread.y * COLUMN);
    float2 firstUv = pxToUv(float2(firstPixel) + 0.5, gOutputSize.zw);
    float2 below = float2(0.0, gOutputSize.w);
#if QUAD_SHARING
    float2 side = float2(quadSide(float2(firstPixel)).x, 1.0);   // every thread of a subgroup runs to its end
#else
    float2 side = float2(1.0, 1.0);
#endif

    float2 motions[COLUMN];
#if SEEKS_CLOSEST
    float3 depthRows[ROWS];
    [unroll] for (int pair = 0; pair < ROWS; pair += 2)
        readDepthRows(firstUv + below * float(pair - 1), side, depthRows[pair], depthRows[pair + 1]);
#endif
    [unroll] for (int y = 0; y < COLUMN; ++y) {
        float2 uv = firstUv + below * float(y);
#if SEEKS_CLOSEST
        DepthSquare depths = depthSquareOf(depthRows[y], depthRows[y + 1], depthRows[y + 2]);
        float depth;
        uv += closestFragment(depths, side * gOutputSize.zw, depth);
        motions[y] = motionOf(uv, depth);
#else
        motions[y] = ownMotion(uv);
#endif
    }
#if !NEIGHBOURHOOD_FOUR_TAP
    ColourRow rows[ROWS];
#if QUAD_SHARING
    readColourRows(firstUv, side, rows);
#else
    rows[0] = readColourRow(firstUv - below);
    rows[1] = readColourRow(firstUv);
#endif
#endif
    float3 histories[COLUMN];
    [unroll] for (int i = 0; i < COLUMN; ++i)
        histories[i] = readHistory(firstUv + below * float(i) - motions[i]);

    Resolved upper;
    [unroll] for (int row = 0; row < COLUMN; ++row) {
        float2 uv = firstUv + below * float(row);
#if NEIGHBOURHOOD_FOUR_TAP
        Resolved resolved = resolveFourTap(uv, motions[row], histories[row]);
#else
#if !QUAD_SHARING
        rows[row + 2] = readColourRow(uv + below);
#endif
        Neighbourhood n = neighbourhoodOf(rows[row], rows[row + 1], rows[row + 2]);
        float3 current = unjitteredColour(n, side);
        Resolved resolved = resolve(uv, motions[row], histories[row], current, neighbourhoodBox(n));
#endif
        if (row % 2 == 1) writePair(firstPixel + uint2(0, row - 1), upper, resolved);
        upper = resolved;
    }
}

#else

// --- Fragment: a pixel reads its 3x3, or shares it with its quad.

#if QUAD_SHARING

float3 loadColour(int x, int y) {
    return toWorkingSpace(LOAD(gInColour, int2(x, y)).rgb);
}

// Reads the texel itself and three on the outer side; the other five come from the quad. Mirrored: +1 is
// outward. A pixel of the quad beyond the image has its edge. Loads: samples cost the CPU driver more.
Neighbourhood readNeighbourhood(float2 uv, float2 side) {
    int2 last = int2(gOutputSize.xy) - 1;
    int2 place = int2(uvToPx(uv, gOutputSize.xy));
    int2 own = min(place, last), outer = clamp(place + int2(side), int2(0, 0), last);
    Neighbourhood n;
    n.centre = loadColour(own.x, own.y);
    n.right = loadColour(outer.x, own.y);
    n.down = loadColour(own.x, outer.y);
    n.rightDown = loadColour(outer.x, outer.y);
    n.left = quadSwapX(n.centre, side);
    n.leftDown = quadSwapX(n.down, side);
    n.up = quadSwapY(n.centre, side);
    n.rightUp = quadSwapY(n.right, side);
    n.leftUp = quadSwapX(n.up, side);
    return n;
}

float2 readClosestFragment(float2 uv, float2 side, out float depth) {
    // One gather around the outer corner, turned so that x: own column, outer row; and so on.
    float4 four = GATHER_RED(gInDepth, uv + 0.5 * side * gOutputSize.zw);
    float4 turnedX = side.x > 0.0 ? four : four.yxwz;
    float4 own = side.y > 0.0 ? turnedX : turnedX.wzyx;
    float3 swappedX = quadSwapX(own.wxx, side);
    float3 swappedY = quadSwapY(float3(own.w, own.z, swappedX.x), side);
    DepthSquare depths =
        depthSquareOf(swappedY.zxy, float3(swappedX.x, own.wz), float3(swappedX.y, own.xy));
    return closestFragment(depths, side * gOutputSize.zw, depth);
}

#else

Neighbourhood readNeighbourhood(float2 uv, float2 side) {
    Neighbourhood n;
    n.leftUp = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, -1, -1).rgb);
    n.up = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, 0, -1).rgb);
    n.rightUp = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, 1, -1).rgb);
    n.left = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, -1, 0).rgb);
    n.centre = readColour(uv);
    n.right = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, 1, 0).rgb);
    n.leftDown = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, -1, 1).rgb);
    n.down = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, 0, 1).rgb);
    n.rightDown = toWorkingSpace(SAMPLE_OFFSET(gInColour, uv, gOutputSize.zw, 1, 1).rgb);
    return n;
}

float2 readClosestFragment(float2 uv, float2 side, out float depth) {
    DepthSquare depths = readDepthSquare(TEXTURE_ARGUMENT(gInDepth), uv, gOutputSize.zw);
    return closestFragment(depths, gOutputSize.zw, depth);
}

#endif

struct Outputs {
    float4 history : SV_Target0;
#if MOTION_BLUR_FALLBACK
    float4 colour : SV_Target1;
#endif
};

Outputs mainFragment(float4 positionPx : POSITION_PX) {
    float2 uv = pxToUv(positionPx.xy, gOutputSize.zw);
#if QUAD_SHARING
    float2 side = quadSide(positionPx.xy);
#else
    float2 side = float2(1.0, 1.0);
#endif

#if SEEKS_CLOSEST
    float depth;
    float2 offset = readClosestFragment(uv, side, depth);
    float2 motion = motionOf(uv + offset, depth);
#else
    float2 motion = ownMotion(uv);
#endif

    float3 history = readHistory(uv - motion);

#if NEIGHBOURHOOD_FOUR_TAP
    Resolved resolved = resolveFourTap(uv, motion, history);
#else
    Neighbourhood n = readNeighbourhood(uv, side);
    Resolved resolved = resolve(uv, motion, history, unjitteredColour(n, side), neighbourhoodBox(n));
#endif

    Outputs outputs;
    outputs.history = float4(resolved.history, 1.0);
#if MOTION_BLUR_FALLBACK
    outputs.colour = float4(resolved.colour, 1.0);
#endif
    return outputs;
}

#endif
