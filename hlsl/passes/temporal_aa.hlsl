// SPDX-License-Identifier: Apache-2.0
// Temporal reprojection anti-aliasing: history fetched along the motion, held to the neighbourhood of the current
// colour, blended, and kept for the next frame. INSIDE I4 to I9, step by step in the talk's order.
//
// gInColour       linear scene-referred colour, rendered with the jitter gJitterPx
// gInColourFiltered  the same image, for reads between texels (four taps, motion blur)
// gInDepth        R32F or D32F device depth of the same rendering (CLOSEST_FRAGMENT)
// gInVelocity     motion, times gMotionToUv = currUv - prevUv without jitter (MOTION)
// gHistoryColour  gOutHistory of the frame before; any content where gHistoryValid is 0
// gOutHistory     the resolved colour, unjittered; also what is shown, without MOTION_BLUR_FALLBACK
// gOutColour      what is shown, with MOTION_BLUR_FALLBACK
// Colours are [0, 65504] in any float or unorm format; NaN, infinity and negatives are read as finite colours, so
// none reaches an output. Motion that is NaN or leaves the image drops history for that pixel.

#include "reprise/closest_fragment.hlsli"
#include "reprise/colour.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/feedback.hlsli"
#include "reprise/history_constraint.hlsli"
#include "reprise/motion_blur.hlsli"
#include "reprise/neighbourhood.hlsli"
#include "reprise/platform.hlsli"
#include "reprise/quad_sharing.hlsli"
#include "reprise/resampling.hlsli"
#include "reprise/unjitter.hlsli"

[[vk::binding(0)]] cbuffer TemporalAaParameters {
    float4 gOutputSize;   // width, height, 1 / width, 1 / height
    float2 gJitterPx;     // of this frame, [-0.5, 0.5]
    float2 gMotionToUv;   // (1, 1) for currUv - prevUv in UV
    float gHistoryValid;  // 1, or 0 on the first frame, after a cut, a gap or a resize
    float gFeedbackMin;   // history weight where luminances differ (FEEDBACK_LUMINANCE), [0, 1)
    float gFeedbackMax;   // history weight where they agree, or the constant one, [0, 1)
    float gBlurFromPx;    // motion up to which history is shown
    float gBlurToPx;      // motion from which motion blur alone is shown
};

TEXTURE_POINT(gInColour, 1);
TEXTURE_POINT(gInDepth, 2);
TEXTURE_POINT(gInVelocity, 3);
TEXTURE_LINEAR(gHistoryColour, 4);
TEXTURE_LINEAR(gInColourFiltered, 5);

// --- The space in which neighbourhood, clip and blend work

float3 toWorkingSpace(float3 colour) {
    colour = sanitize(colour);
#if HDR_WEIGHT
    colour = compressHdr(colour);
#endif
#if COLOUR_SPACE_YCOCG
    colour = rgbToYcocg(colour);
#endif
    return colour;
}

float3 fromWorkingSpace(float3 colour) {
#if COLOUR_SPACE_YCOCG
    colour = max(ycocgToRgb(colour), 0.0);
#endif
#if HDR_WEIGHT
    colour = expandHdr(colour);
#endif
    return min(colour, MAX_COLOUR);
}

float workingLuminance(float3 colour) {
#if COLOUR_SPACE_YCOCG
    return colour.x;
#else
    return luminance(colour);
#endif
}

// --- Loads

float3 readColour(float2 uv) {
    return toWorkingSpace(SAMPLE(gInColour, uv).rgb);
}

float3 readColourFiltered(float2 uv) {
    return toWorkingSpace(SAMPLE(gInColourFiltered, uv).rgb);
}

float2 readMotion(float2 uv) {
#if MOTION
    return SAMPLE(gInVelocity, uv).rg * gMotionToUv;
#else
    return float2(0.0, 0.0);
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

ColourBox neighbourhoodBox(Neighbourhood n) {
#if NEIGHBOURHOOD_ROUNDED
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
    return clipToBoxCentre(history, box);
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

// Reproject, validate, constrain, blend.
Resolved resolve(float2 uv, float2 motion, float3 current, ColourBox box) {
    float2 prevUv = uv - motion;
    float3 history = constrain(readHistory(prevUv), current, box);

#if FEEDBACK_LUMINANCE
    float weight =
        luminanceFeedback(workingLuminance(current), workingLuminance(history), gFeedbackMin, gFeedbackMax);
#else
    float weight = gFeedbackMax;
#endif
    weight = isInsideUv(prevUv) ? weight * gHistoryValid : 0.0;

    Resolved resolved;
    resolved.history = fromWorkingSpace(blendHistory(current, history, weight));
    resolved.colour = resolved.history;
#if MOTION_BLUR_FALLBACK
    // Fast fragments show no history at all: it trails where no neighbour forces it out.
    float trust = motionBlurTrust(length(motion * gOutputSize.xy), gBlurFromPx, gBlurToPx);
    float2 unjitteredUv = uv + gJitterPx * gOutputSize.zw;
    float3 blurred = sampleMotion(TEXTURE_ARGUMENT(gInColourFiltered), unjitteredUv, motion);
    resolved.colour = lerp(blurred, resolved.history, trust);
#endif
    return resolved;
}

#if NEIGHBOURHOOD_FOUR_TAP

// The first form of the talk: four taps whose distance falls with motion.
Resolved resolveFourTap(float2 uv, float2 motion) {
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
    return resolve(uv, motion, centre, box);
#else
    return resolve(uv, motion, readColourFiltered(uv + gJitterPx * gOutputSize.zw), box);
#endif
}

#endif

#if STAGE_COMPUTE

// --- Compute: a thread resolves 2x2 pixels from the 4x4 texels around them, all in registers.

[[vk::binding(16)]] RWTexture2D<float4> gOutHistory;
#if MOTION_BLUR_FALLBACK
[[vk::binding(17)]] RWTexture2D<float4> gOutColour;
#endif

void write(uint2 pixel, Resolved resolved) {
    if (any(pixel >= uint2(gOutputSize.xy))) return;
    gOutHistory[pixel] = float4(resolved.history, 1.0);
#if MOTION_BLUR_FALLBACK
    gOutColour[pixel] = float4(resolved.colour, 1.0);
#endif
}

#if !NEIGHBOURHOOD_FOUR_TAP

// The 3x3 around texel (x, y) of the inner 2x2, x and y in {1, 2}, of 4x4 texels in rows.
Neighbourhood neighbourhoodOf(float3 texels[16], int x, int y) {
    Neighbourhood n;
    n.leftUp = texels[(y - 1) * 4 + x - 1];
    n.up = texels[(y - 1) * 4 + x];
    n.rightUp = texels[(y - 1) * 4 + x + 1];
    n.left = texels[y * 4 + x - 1];
    n.centre = texels[y * 4 + x];
    n.right = texels[y * 4 + x + 1];
    n.leftDown = texels[(y + 1) * 4 + x - 1];
    n.down = texels[(y + 1) * 4 + x];
    n.rightDown = texels[(y + 1) * 4 + x + 1];
    return n;
}

#endif

#if MOTION && CLOSEST_FRAGMENT

DepthSquare depthSquareOf(float texels[16], int x, int y) {
    DepthSquare d;
    d.leftUp = texels[(y - 1) * 4 + x - 1];
    d.up = texels[(y - 1) * 4 + x];
    d.rightUp = texels[(y - 1) * 4 + x + 1];
    d.left = texels[y * 4 + x - 1];
    d.centre = texels[y * 4 + x];
    d.right = texels[y * 4 + x + 1];
    d.leftDown = texels[(y + 1) * 4 + x - 1];
    d.down = texels[(y + 1) * 4 + x];
    d.rightDown = texels[(y + 1) * 4 + x + 1];
    return d;
}

#endif

[numthreads(8, 8, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    float2 firstPx = float2(thread.xy) * 2.0;   // upper left corner of the 2x2
    if (any(firstPx >= gOutputSize.xy)) return;

#if MOTION && CLOSEST_FRAGMENT
    float depths[16];
    [unroll] for (int block = 0; block < 4; ++block) {
        int column = (block & 1) * 2, row = (block >> 1) * 2;
        float4 four = GATHER_RED(gInDepth, pxToUv(firstPx + float2(column, row), gOutputSize.zw));
        depths[row * 4 + column] = four.w;
        depths[row * 4 + column + 1] = four.z;
        depths[row * 4 + column + 4] = four.x;
        depths[row * 4 + column + 5] = four.y;
    }
#endif
#if !NEIGHBOURHOOD_FOUR_TAP
    float3 colours[16];
    [unroll] for (int texel = 0; texel < 16; ++texel) {
        colours[texel] = readColour(pxToUv(firstPx + float2(texel & 3, texel >> 2) - 0.5, gOutputSize.zw));
    }
#endif

    [unroll] for (int pixel = 0; pixel < 4; ++pixel) {
        int x = pixel & 1, y = pixel >> 1;
        float2 uv = pxToUv(firstPx + float2(x, y) + 0.5, gOutputSize.zw);
#if MOTION && CLOSEST_FRAGMENT
        float2 closest = closestFragment(depthSquareOf(depths, x + 1, y + 1));
        float2 motion = readMotion(uv + closest * gOutputSize.zw);
#else
        float2 motion = readMotion(uv);
#endif
#if NEIGHBOURHOOD_FOUR_TAP
        Resolved resolved = resolveFourTap(uv, motion);
#else
        Neighbourhood n = neighbourhoodOf(colours, x + 1, y + 1);
        float3 current = unjitteredColour(n, float2(1.0, 1.0));
        Resolved resolved = resolve(uv, motion, current, neighbourhoodBox(n));
#endif
        write(thread.xy * 2 + uint2(x, y), resolved);
    }
}

#else

// --- Fragment: a pixel reads its 3x3, or shares it with its quad.

#if QUAD_SHARING

// Reads the texel itself and three on the outer side; the other five come from the quad. Mirrored: +1 is outward.
Neighbourhood readNeighbourhood(float2 uv, float2 side) {
    float2 outward = side * gOutputSize.zw;
    Neighbourhood n;
    n.centre = readColour(uv);
    n.right = readColour(uv + float2(outward.x, 0.0));
    n.down = readColour(uv + float2(0.0, outward.y));
    n.rightDown = readColour(uv + outward);
    n.left = quadSwapX(n.centre, side);
    n.leftDown = quadSwapX(n.down, side);
    n.up = quadSwapY(n.centre, side);
    n.rightUp = quadSwapY(n.right, side);
    n.leftUp = quadSwapX(n.up, side);
    return n;
}

float2 readClosestOffset(float2 uv, float2 side) {
    // One gather around the outer corner, turned so that x: own column, outer row; and so on.
    float4 four = GATHER_RED(gInDepth, uv + 0.5 * side * gOutputSize.zw);
    float4 turnedX = side.x > 0.0 ? four : four.yxwz;
    float4 own = side.y > 0.0 ? turnedX : turnedX.wzyx;
    float3 swappedX = quadSwapX(own.wxx, side);
    float3 swappedY = quadSwapY(float3(own.w, own.z, swappedX.x), side);
    DepthSquare d;
    d.centre = own.w;
    d.right = own.z;
    d.down = own.x;
    d.rightDown = own.y;
    d.left = swappedX.x;
    d.leftDown = swappedX.y;
    d.up = swappedY.x;
    d.rightUp = swappedY.y;
    d.leftUp = swappedY.z;
    return closestFragment(d) * side;
}

#else

Neighbourhood readNeighbourhood(float2 uv, float2 side) {
    float2 texel = gOutputSize.zw;
    Neighbourhood n;
    n.leftUp = readColour(uv - texel);
    n.up = readColour(uv + float2(0.0, -texel.y));
    n.rightUp = readColour(uv + float2(texel.x, -texel.y));
    n.left = readColour(uv + float2(-texel.x, 0.0));
    n.centre = readColour(uv);
    n.right = readColour(uv + float2(texel.x, 0.0));
    n.leftDown = readColour(uv + float2(-texel.x, texel.y));
    n.down = readColour(uv + float2(0.0, texel.y));
    n.rightDown = readColour(uv + texel);
    return n;
}

float2 readClosestOffset(float2 uv, float2 side) {
    return closestFragment(readDepthSquare(TEXTURE_ARGUMENT(gInDepth), uv, gOutputSize.zw));
}

#endif

struct Outputs {
    float4 history : SV_Target0;
#if MOTION_BLUR_FALLBACK
    float4 colour : SV_Target1;
#endif
};

Outputs mainFragment(float4 positionPx : SV_Position) {
    float2 uv = pxToUv(positionPx.xy, gOutputSize.zw);
#if QUAD_SHARING
    float2 side = quadSide(positionPx.xy);
#else
    float2 side = float2(1.0, 1.0);
#endif

#if MOTION && CLOSEST_FRAGMENT
    float2 motion = readMotion(uv + readClosestOffset(uv, side) * gOutputSize.zw);
#else
    float2 motion = readMotion(uv);
#endif

#if NEIGHBOURHOOD_FOUR_TAP
    Resolved resolved = resolveFourTap(uv, motion);
#else
    Neighbourhood n = readNeighbourhood(uv, side);
    Resolved resolved = resolve(uv, motion, unjitteredColour(n, side), neighbourhoodBox(n));
#endif

    Outputs outputs;
    outputs.history = float4(resolved.history, 1.0);
#if MOTION_BLUR_FALLBACK
    outputs.colour = float4(resolved.colour, 1.0);
#endif
    return outputs;
}

#endif
