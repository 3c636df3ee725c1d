// SPDX-License-Identifier: Apache-2.0
// What the framework's cache holds of a texel, by the switch VALUES of the pass that includes this: Drobot,
// "Reprojection Caching" and "Shadows and Ambient Occlusion Combined" (D2, D10).
//
//   VALUES                        CachedValues   the image of values            the image of state
//   one                           float          value, depth                   frames
//   occlusion_in_, shadow_in_..   float2         both packed in one, depth      frames
//   two                           float2         value, value                   frames, depth
//   four                          float4         four values                    frames, depth
//   with_frames                   float2         both and the frames packed     none; depth is coarse depth
//
// Frames: how many the history holds (exponential_history.hlsli). Depth: linear, metres. What is fresh comes
// as two values where the cache packs frames beside them.
#ifndef REPRISE_CACHED_VALUES_HLSLI
#define REPRISE_CACHED_VALUES_HLSLI

#include "reprise/conventions.hlsli"
#include "reprise/finite.hlsli"
#include "reprise/occlusion_shadow_packing.hlsli"

#define VALUES_PACKED (VALUES_OCCLUSION_IN_INTEGER || VALUES_SHADOW_IN_INTEGER)
// Depth lies beside the frames, and fresh values bring none.
#define DEPTH_APART (VALUES_TWO || VALUES_FOUR || VALUES_WITH_FRAMES)

#if VALUES_FOUR
typedef float4 CachedValues;
static const int VALUE_COUNT = 4;
#elif VALUES_ONE
typedef float CachedValues;
static const int VALUE_COUNT = 1;
#else
typedef float2 CachedValues;
static const int VALUE_COUNT = 2;
#endif

// Whether a cache can hold them: the finite values of a binary16.
bool areCacheable(CachedValues values) {
#if VALUES_ONE
    return abs(values) <= MAX_COLOUR;
#elif VALUES_PACKED
    return abs(values.x) <= MAX_COLOUR;   // a texel holds both or neither
#else
    return all(abs(values) <= MAX_COLOUR);
#endif
}

// Of a texel that holds nothing packed what is no number, so that means leave it out.
CachedValues unpackValues(float4 texel) {
#if VALUES_OCCLUSION_IN_INTEGER
    return abs(texel.r) <= MAX_COLOUR ? unpackOcclusionInInteger(texel.r) : 2.0 * LARGEST_NUMBER;
#elif VALUES_SHADOW_IN_INTEGER
    return abs(texel.r) <= MAX_COLOUR ? unpackShadowInInteger(texel.r) : 2.0 * LARGEST_NUMBER;
#elif VALUES_ONE
    return texel.r;
#elif VALUES_TWO
    return texel.rg;
#elif VALUES_WITH_FRAMES
    VisibilitiesOfFour same = unpackWithFrames(texel.rrrr);
    return same.usable.x > 0.5 ? float2(same.occlusion.x, same.shadow.x) : 2.0 * LARGEST_NUMBER;
#else
    return texel;
#endif
}

#if VALUES_PACKED
// Of four packed pairs the sum of the values, each times its share.
float2 sumOfPacked(float4 packed, float4 shares) {
#if VALUES_OCCLUSION_IN_INTEGER
    return sumOfUnitPairs(packed, shares);
#else
    return sumOfUnitPairs(packed, shares).yx;
#endif
}
#endif

// Of a fresh texel, as a cache takes them: what it cannot hold counts as 0.
CachedValues knownValues(float4 texel) {
#if VALUES_WITH_FRAMES
    CachedValues values = texel.rg;
#else
    CachedValues values = unpackValues(texel);
#endif
    return abs(values) <= MAX_COLOUR ? values : 0.0;
}

float channelOf(CachedValues values, int channel) {
#if VALUES_ONE
    return values;
#else
    return values[channel];
#endif
}

float smallest(CachedValues values) {
#if VALUES_FOUR
    return min(min(values.x, values.y), min(values.z, values.w));
#elif VALUES_ONE
    return values;
#else
    return min(values.x, values.y);
#endif
}

// The texel of values: depth has its place beside one or a packed pair, frames in with_frames.
float4 packValues(CachedValues values, float frames, float depth) {
#if VALUES_OCCLUSION_IN_INTEGER
    return float4(packOcclusionInInteger(values.x, values.y), depth, 0.0, 0.0);
#elif VALUES_SHADOW_IN_INTEGER
    return float4(packShadowInInteger(values.x, values.y), depth, 0.0, 0.0);
#elif VALUES_ONE
    return float4(values, depth, 0.0, 0.0);
#elif VALUES_TWO
    return float4(values, 0.0, 0.0);
#elif VALUES_WITH_FRAMES
    return float4(packWithFrames(values, frames), 0.0, 0.0, 0.0);
#else
    return values;
#endif
}

// The texel of state, of what has one.
float4 packState(float frames, float depth) {
#if DEPTH_APART
    return float4(frames, depth, 0.0, 0.0);
#else
    return float4(frames, 0.0, 0.0, 0.0);
#endif
}

float depthOf(float4 values, float4 state) {
#if DEPTH_APART
    return state.g;
#else
    return values.g;
#endif
}

#endif
