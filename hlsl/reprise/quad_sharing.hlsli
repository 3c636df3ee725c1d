// SPDX-License-Identifier: Apache-2.0
// Reads shared between the four pixels of a fragment quad. Each pixel reads itself and the texels on its
// outer side; the inner ones are read by its neighbours and come over as derivatives. Needs fine derivatives.
//
// A value that comes over is own + (neighbour - own): exact to one rounding of the larger of the two. A NaN
// or an infinity in one pixel reaches the other three of its quad, so values are made finite first.
#ifndef REPRISE_QUAD_SHARING_HLSLI
#define REPRISE_QUAD_SHARING_HLSLI

// Direction of a pixel's outer side: -1 in the left column or upper row of its quad, +1 in the other.
float2 quadSide(float2 positionPx) {
    return frac(floor(positionPx) * 0.5) * 4.0 - 1.0;
}

// The value of the other pixel in the row.
float3 quadSwapX(float3 value, float2 side) {
    return value - ddx_fine(value) * side.x;
}

// The value of the other pixel in the column.
float3 quadSwapY(float3 value, float2 side) {
    return value - ddy_fine(value) * side.y;
}

#endif
