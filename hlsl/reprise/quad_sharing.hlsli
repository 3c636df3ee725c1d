// SPDX-License-Identifier: Apache-2.0
// Reads shared between the four invocations of a quad. Each reads itself and the texels on its outer side;
// the inner ones are read by its neighbours and come over.
//
// Fragment: they come as fine derivatives, own + (neighbour - own), exact to two roundings of the larger
// of the two. A NaN or an infinity in one pixel reaches the other three, so values are made finite first.
// Compute: they come through quad operations, exactly. Neighbours in a row are neighbours in the group, all
// four must be running, and the device must have quad operations in compute.
#ifndef REPRISE_QUAD_SHARING_HLSLI
#define REPRISE_QUAD_SHARING_HLSLI

// Direction of a pixel's outer side: -1 in the left column or upper row of its quad, +1 in the other.
float2 quadSide(float2 positionPx) {
    return frac(floor(positionPx) * 0.5) * 4.0 - 1.0;
}

#if STAGE_COMPUTE

// Shader model 5 has no quad operations: there only who asks for them meets the compiler's refusal.
#if !PLATFORM_D3D11 || QUAD_SHARING

// The value of the other invocation in the row.
float2 quadSwapX(float2 value, float2 side) {
    return QuadReadAcrossX(value);
}

float3 quadSwapX(float3 value, float2 side) {
    return QuadReadAcrossX(value);
}

#endif

#else

// The value of the other pixel in the row.
float3 quadSwapX(float3 value, float2 side) {
    return value - ddx_fine(value) * side.x;
}

// The value of the other pixel in the column.
float3 quadSwapY(float3 value, float2 side) {
    return value - ddy_fine(value) * side.y;
}

#endif

#endif
