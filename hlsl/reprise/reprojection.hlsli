// SPDX-License-Identifier: Apache-2.0
// Where a surface was in the previous frame. INSIDE, "Reprojection of static scenes"; Drobot, Listing 7.2.
#ifndef REPRISE_REPROJECTION_HLSLI
#define REPRISE_REPROJECTION_HLSLI

#include "reprise/conventions.hlsli"
#include "reprise/coordinates.hlsli"

// Returned for a surface that was on or behind the plane of the previous camera: outside every image, so that
// isInsideUv() rejects it, and small enough for a binary16 velocity. The listings divide by w as it comes.
static const float2 BEHIND_CAMERA_UV = float2(-8.0, -8.0);

// Clip coordinates to UV. A clip position is homogeneous only up to a positive factor. Where w <= 0, where a
// coordinate is NaN and from 8 images away on it is BEHIND_CAMERA_UV, so that neither NaN nor infinity
// reaches a velocity buffer: both comparisons are false for NaN.
float2 clipToUv(float4 positionCS) {
    bool inFront = positionCS.w > 0.0;
    float2 uv = ndcToUv(positionCS.xy * (1.0 / positionCS.w));
    return inFront && all(abs(uv) <= 8.0) ? uv : BEHIND_CAMERA_UV;
}

// Previous UV of the static surface seen at `uv` (unjittered) with device depth in [0,1].
// reprojection takes current NDC and device depth to previous clip space: reprise::reprojection().
float2 reprojectDeviceDepth(float2 uv, float deviceDepth, float4x4 reprojection) {
    return clipToUv(transform(reprojection, float4(uvToNdc(uv), deviceDepth, 1.0)));
}

// View-space position from the corner ray, lerped over the image, and linear depth in metres. viewRay.xy is
// the extent of the rays at depth 1 (perspective) or of the view volume (orthographic), viewRay.zw their
// value at uv = 0.
float3 viewPosition(float2 uv, float linearDepth, float4 viewRay) {
    float2 ray = uv * viewRay.xy + viewRay.zw;
#if ORTHOGRAPHIC
    return float3(ray, linearDepth);
#else
    return float3(ray * linearDepth, linearDepth);
#endif
}

// Previous UV of the static surface at `uv` (unjittered) with linear depth in metres.
// viewToPreviousClip is reprise::viewToPreviousClip().
float2 reprojectLinearDepth(float2 uv, float linearDepth, float4 viewRay, float4x4 viewToPreviousClip) {
#if ORTHOGRAPHIC
    return clipToUv(transform(viewToPreviousClip, float4(viewPosition(uv, linearDepth, viewRay), 1.0)));
#else
    // The ray through the transform, then along it: fewer products than the position through the transform.
    float4 alongRay = transform(viewToPreviousClip, float4(viewPosition(uv, 1.0, viewRay), 0.0));
    float4 originCS = transform(viewToPreviousClip, float4(0.0, 0.0, 0.0, 1.0));
    return clipToUv(alongRay * linearDepth + originCS);
#endif
}

// Motion of a surface point from its unjittered clip positions in both frames (compute_ssvel of INSIDE).
// Behind either camera it is so large that history is rejected.
float2 motionFromClip(float4 positionCS, float4 prevPositionCS) {
    return clipToUv(positionCS) - clipToUv(prevPositionCS);
}

#endif
