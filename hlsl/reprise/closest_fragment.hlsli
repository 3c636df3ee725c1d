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

// From three rows, left, centre and right in xyz.
DepthSquare depthSquareOf(float3 up, float3 own, float3 down) {
    DepthSquare d;
    d.leftUp = up.x;
    d.up = up.y;
    d.rightUp = up.z;
    d.left = own.x;
    d.centre = own.y;
    d.right = own.z;
    d.leftDown = down.x;
    d.down = down.y;
    d.rightDown = down.z;
    return d;
}

// Depth in x and offset in y of the closest in a row: 0, or step towards the right one, or -step; the centre
// wins against equals.
float2 closestInRow(float left, float centre, float right, float step) {
    float2 side = isCloser(right, left) ? float2(right, step) : float2(left, -step);
    return isCloser(side.x, centre) ? side : float2(centre, 0.0);
}

// Offset of the closest of nine, in each direction 0 or a step, and its depth. `step` goes from the centre to
// the one at the right below, in what the offset is wanted in: (1, 1) gives texels. The own row wins against
// equals, and in it the centre. Row by row: a thread that resolves a column of pixels shares the rows.
float2 closestFragment(DepthSquare d, float2 step, out float depth) {
    float2 own = closestInRow(d.left, d.centre, d.right, step.x);
    float2 up = closestInRow(d.leftUp, d.up, d.rightUp, step.x);
    float2 down = closestInRow(d.leftDown, d.down, d.rightDown, step.x);
    float2 outer = isCloser(down.x, up.x) ? down : up;
    float outerY = isCloser(down.x, up.x) ? step.y : -step.y;
    depth = isCloser(outer.x, own.x) ? outer.x : own.x;
    return isCloser(outer.x, own.x) ? float2(outer.y, outerY) : float2(own.y, 0.0);
}

float2 closestFragment(DepthSquare d, float2 step) {
    float depth;
    return closestFragment(d, step, depth);
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
    d.leftUp = SAMPLE_OFFSET(depth, uv, texelSize, -1, -1).r;
    d.up = SAMPLE_OFFSET(depth, uv, texelSize, 0, -1).r;
    d.rightUp = SAMPLE_OFFSET(depth, uv, texelSize, 1, -1).r;
    d.left = SAMPLE_OFFSET(depth, uv, texelSize, -1, 0).r;
    d.centre = SAMPLE(depth, uv).r;
    d.right = SAMPLE_OFFSET(depth, uv, texelSize, 1, 0).r;
    d.leftDown = SAMPLE_OFFSET(depth, uv, texelSize, -1, 1).r;
    d.down = SAMPLE_OFFSET(depth, uv, texelSize, 0, 1).r;
    d.rightDown = SAMPLE_OFFSET(depth, uv, texelSize, 1, 1).r;
    return d;
}
#endif

#endif
