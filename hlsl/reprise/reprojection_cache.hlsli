// SPDX-License-Identifier: Apache-2.0
// The reprojection cache: Drobot, "Reprojection Caching", Listing 7.2 (D2), and Scherzer, "Determining cache
// coordinates" (S1). Where a pixel's value lies in the history, which depth stands there if it is the same
// surface, how much the history weighs, and the blend. It caches values of one, two or four components.
#ifndef REPRISE_REPROJECTION_CACHE_HLSLI
#define REPRISE_REPROJECTION_CACHE_HLSLI

#include "reprise/finite.hlsli"
#include "reprise/reprojection.hlsli"

// Where the history of a surface lies.
struct CachePlace {
    float2 prevUv;      // outside [0,1]² where it was not in view, at most 8 in magnitude
    float lastDepth;    // its linear depth in the previous view, metres; 0 where that is no number
};

// From the surface's clip position under the previous camera: PosPrev of the slides, an interpolant, which
// knows how objects moved. y runs as NDC_AND_UV_SHARE_Y says. Where w <= 0 it lies outside; the listings
// divide by w as it comes. clipToDepth makes linear depth of clip z and w: (0, 1) for a perspective
// projection, reprise::linearDepthCoefficients() of the previous one for an orthographic.
CachePlace cachePlaceFromClip(float4 prevPositionCS, float2 clipToDepth) {
    CachePlace place;
    place.prevUv = clipToUv(prevPositionCS);
    place.lastDepth = numberOrZero(dot(prevPositionCS.zw, clipToDepth));
    return place;
}

// From linear depth in metres and the corner ray, for what stands still ("camera reprojection"). uv is
// unjittered; viewRay and viewToPreviousClip as in reprojectLinearDepth().
CachePlace cachePlaceFromDepth(float2 uv, float linearDepth, float4 viewRay, float4x4 viewToPreviousClip,
                               float2 clipToDepth) {
    float4 positionVS = float4(viewPosition(uv, linearDepth, viewRay), 1.0);
    return cachePlaceFromClip(transform(viewToPreviousClip, positionVS), clipToDepth);
}

// From a motion vector, currUv - prevUv. It carries no depth: lastDepth, in metres, is the caller's, such as
// that of cachePlaceFromDepth(), which neglects the object's own motion along the view.
CachePlace cachePlaceFromMotion(float2 uv, float2 motion, float lastDepth) {
    float2 prevUv = uv - motion;
    CachePlace place;
    place.prevUv = all(abs(prevUv) <= 8.0) ? prevUv : BEHIND_CAMERA_UV;
    place.lastDepth = numberOrZero(lastDepth);
    return place;
}

// Weight of history in [0,1]: missRate of the listing, which uses it as this. As printed it grows with the
// difference of depths; "if the difference is bigger than an epsilon, then we consider it a cache miss", so
// the sign is turned: 0 from missThreshold (metres, above 0) on, below it convergenceTime for each metre.
// Their product is the weight at equal depths; below 1 it keeps fresh data flowing in, as w does in h(t) =
// h(t-1) w + r (1 - w). Out of bounds, and where a depth or the place is NaN, it is 0.
float cacheHistoryWeight(CachePlace place, float cacheDepth, float missThreshold, float convergenceTime) {
    float room = missThreshold - abs(place.lastDepth - cacheDepth);
    float missRate = room > 0.0 ? room * convergenceTime : 0.0;
    return missRate > 0.0 && isInsideUv(place.prevUv) ? min(missRate, 1.0) : 0.0;
}

// Of the four texels around the place, each by its own depth.
float4 cacheHistoryWeight(CachePlace place, float4 cacheDepths, float missThreshold, float convergenceTime) {
    float4 room = missThreshold - abs(place.lastDepth - cacheDepths);
    float4 missRate = room > 0.0 ? room * convergenceTime : 0.0;
    return missRate > 0.0 && isInsideUv(place.prevUv) ? min(missRate, 1.0) : 0.0;
}

// freshData moved towards reproData by the weight of history. A history that is no number is left out
// whatever its weight; fresh data that is none counts as 0, so that it does not stay.
float reproCache(float freshData, float reproData, float weight) {
    float fresh = numberOrZero(freshData);
    return isNumber(reproData) ? fresh + (reproData - fresh) * saturate(weight) : fresh;
}

float2 reproCache(float2 freshData, float2 reproData, float weight) {
    float2 fresh = numberOrZero(freshData);
    return isNumber(reproData) ? fresh + (reproData - fresh) * saturate(weight) : fresh;
}

float4 reproCache(float4 freshData, float4 reproData, float weight) {
    float4 fresh = numberOrZero(freshData);
    return isNumber(reproData) ? fresh + (reproData - fresh) * saturate(weight) : fresh;
}

#endif
