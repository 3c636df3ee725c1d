// SPDX-License-Identifier: Apache-2.0
// Holds history to the box of its neighbourhood. INSIDE, "Constraining history sample".
#ifndef REPRISE_HISTORY_CONSTRAINT_HLSLI
#define REPRISE_HISTORY_CONSTRAINT_HLSLI

#include "reprise/neighbourhood.hlsli"

// Below this, a side of a box counts as this long: far under a step of a binary16 history. It keeps 0/0 out
// of the clip, which the printed form has for a box without extent.
static const float MIN_BOX_EXTENT = 1e-7;
// Turns 0/0 into 1 and is lost in any other sum (line clip).
static const float TINY = 1e-30;

// Each channel for itself: hue may shift, and colours gather in the corners of the box.
float3 clampToBox(float3 history, ColourBox box) {
    return clamp(history, box.minimum, box.maximum);
}

// Moves history along the line to the centre of the box until it is inside: clip_aabb of the talk (I6), with
// `ax` read as max and the zero extent guarded. `box` is the box times `times`, so that a mean of two boxes
// needs no product. minExtent > 0 is what a side counts as at least, in the unit of the colours.
float3 clipToBoxCentre(float3 history, ColourBox box, float times, float minExtent) {
    float3 centre = box.maximum + box.minimum;   // as all that follows, 2 * times what it is
    float3 extent = max(box.maximum - box.minimum, 2.0 * times * minExtent);
    float3 offset = history * (2.0 * times) - centre;
    float3 share = saturate(extent / abs(offset));   // of the way that is inside, per axis; x / 0 is 1
    return (centre + offset * min(share.x, min(share.y, share.z))) * (0.5 / times);
}

float3 clipToBoxCentre(float3 history, ColourBox box) {
    return clipToBoxCentre(history, box, 1.0, MIN_BOX_EXTENT);
}

// Moves history along the line to the current colour until it is inside: the line clip that the talk calls
// proper and slow. A current colour outside the box, as the rounded one allows, is clamped first.
float3 clipToBoxLine(float3 history, float3 current, ColourBox box) {
    float3 start = clampToBox(current, box);
    float3 direction = history - start;
    float3 room = float3(direction.x > 0.0 ? box.maximum.x : box.minimum.x,
                         direction.y > 0.0 ? box.maximum.y : box.minimum.y,
                         direction.z > 0.0 ? box.maximum.z : box.minimum.z) - start;
    // Per axis the share of the way that is inside: 1 where the way ends before the side, also for 0/0.
    float3 share = (abs(room) + TINY) / (max(abs(direction), abs(room)) + TINY);
    return start + direction * min(share.x, min(share.y, share.z));
}

// clip_aabb of the talk by its own name, with its fourth channel: history q slides towards the box's centre
// and p.w, all four channels by the same share of the way; the box alone says how far. p is the current
// colour. Guarded as above; a q that is no number in any channel gives the centre and p.w. All else up to
// 1e30, aabb_min <= aabb_max.
float4 clip_aabb(float3 aabb_min, float3 aabb_max, float4 p, float4 q) {
    float4 p_clip = float4(0.5 * aabb_max + 0.5 * aabb_min, p.w);
    float3 e_clip = max(0.5 * aabb_max - 0.5 * aabb_min, MIN_BOX_EXTENT);
    if (!all(abs(q) <= 1e38)) {
        return p_clip;
    }
    float4 v_clip = q - p_clip;
    float3 share = e_clip / (abs(v_clip.xyz) + TINY);
    float smallest = min(share.x, min(share.y, share.z));
    return smallest < 1.0 ? p_clip + v_clip * smallest : q;
}

#endif
