// SPDX-License-Identifier: Apache-2.0
// The fragment closest to the camera in 3x3, whose motion an edge travels with. INSIDE I4.
#ifndef REPRISE_CLOSEST_FRAGMENT_HLSLI
#define REPRISE_CLOSEST_FRAGMENT_HLSLI

#include "reprise/depth.hlsli"
#include "reprise/platform.hlsli"

// Device depths of the 3x3 around a pixel.
struct DepthSquare {
    float centre;
    float left, right, up, down;
    float leftUp, rightUp, leftDown, rightDown;
};

// Depth in x, offset in texels in yz.
float3 closerOf(float3 a, float3 b) {
    return isCloser(b.x, a.x) ? b : a;
}

// Offset in texels, each in {-1, 0, 1}, of the closest of nine. The centre wins against equals; NaN never wins
// over it.
float2 closestFragment(DepthSquare d) {
    float3 row = closerOf(float3(d.left, -1.0, 0.0), float3(d.right, 1.0, 0.0));
    float3 up = closerOf(float3(d.up, 0.0, -1.0), closerOf(float3(d.leftUp, -1.0, -1.0), float3(d.rightUp, 1.0, -1.0)));
    float3 down =
        closerOf(float3(d.down, 0.0, 1.0), closerOf(float3(d.leftDown, -1.0, 1.0), float3(d.rightDown, 1.0, 1.0)));
    return closerOf(float3(d.centre, 0.0, 0.0), closerOf(row, closerOf(up, down))).yz;
}

#if HAS_GATHER
// Four gathers, each around a corner of the pixel.
DepthSquare readDepthSquare(TEXTURE_PARAMETER(depth), float2 uv, float2 texelSize) {
    float2 halfTexel = 0.5 * texelSize;
    float4 leftUp = GATHER_RED(depth, uv - halfTexel);
    float4 rightUp = GATHER_RED(depth, uv + float2(halfTexel.x, -halfTexel.y));
    float4 leftDown = GATHER_RED(depth, uv + float2(-halfTexel.x, halfTexel.y));
    float4 rightDown = GATHER_RED(depth, uv + halfTexel);
    DepthSquare d;
    d.leftUp = leftUp.w;
    d.up = leftUp.z;
    d.left = leftUp.x;
    d.centre = leftUp.y;
    d.rightUp = rightUp.z;
    d.right = rightUp.y;
    d.leftDown = leftDown.x;
    d.down = leftDown.y;
    d.rightDown = rightDown.y;
    return d;
}
#else
DepthSquare readDepthSquare(TEXTURE_PARAMETER(depth), float2 uv, float2 texelSize) {
    DepthSquare d;
    d.centre = SAMPLE(depth, uv).r;
    d.left = SAMPLE(depth, uv + float2(-texelSize.x, 0.0)).r;
    d.right = SAMPLE(depth, uv + float2(texelSize.x, 0.0)).r;
    d.up = SAMPLE(depth, uv + float2(0.0, -texelSize.y)).r;
    d.down = SAMPLE(depth, uv + float2(0.0, texelSize.y)).r;
    d.leftUp = SAMPLE(depth, uv + float2(-texelSize.x, -texelSize.y)).r;
    d.rightUp = SAMPLE(depth, uv + float2(texelSize.x, -texelSize.y)).r;
    d.leftDown = SAMPLE(depth, uv + float2(-texelSize.x, texelSize.y)).r;
    d.rightDown = SAMPLE(depth, uv + texelSize).r;
    return d;
}
#endif

#endif
