// SPDX-License-Identifier: Apache-2.0
// Reads shared between neighbouring invocations: each reads its own texels, others' come over.
//
// Fragment: the four of a 2x2 quad. Values come as fine derivatives, own + (neighbour - own), exact to two
// roundings of the larger of the two. A NaN or an infinity in one pixel reaches the other three, so values
// are made finite first.
// Compute: a row of the subgroup, SUBGROUP_ROW_WIDTH invocations beside each other. Values come exactly.
// Groups are a multiple of it wide, all invocations must be running, and the device must have quad and
// shuffle operations in compute and subgroups of at least 8.
#ifndef REPRISE_QUAD_SHARING_HLSLI
#define REPRISE_QUAD_SHARING_HLSLI

#include "reprise/platform.hlsli"

// Direction of a pixel's outer side: -1 in the left column or upper row of its quad, +1 in the other.
float2 quadSide(float2 positionPx) {
    return frac(floor(positionPx) * 0.5) * 4.0 - 1.0;
}

#if STAGE_COMPUTE

// Shader model 5 has no quad operations: there only who asks for them meets the compiler's refusal.
#if !PLATFORM_D3D11 || QUAD_SHARING

// A power of two, 8 to 32, not above the least size of the device's subgroups. The runtime gives the largest.
CONSTANT_ID(0) const uint SUBGROUP_ROW_WIDTH = 8;

// Place in the row, from 0 on.
uint subgroupColumn() {
    return WaveGetLaneIndex() & (SUBGROUP_ROW_WIDTH - 1u);
}

// The row's invocation `column`, as WaveReadLaneAt() counts them.
uint laneInRow(uint column) {
    return WaveGetLaneIndex() - subgroupColumn() + column;
}

// The value of the row's invocation `column`.
float3 valueInRow(float3 value, uint column) {
    return WaveReadLaneAt(value, laneInRow(column));
}

// The value of the neighbour on the outer side; quadSwapX() has the one on the inner side. The first and the
// last invocation, which have none in the row, get each other's `end`; nobody else reads what those two give.
float3 outerNeighbour(float3 value, float3 end) {
    uint column = subgroupColumn(), last = SUBGROUP_ROW_WIDTH - 1u;
    uint outerColumn = (column & 1u) != 0u ? column + 1u : column - 1u;
    return valueInRow(column == 0u || column == last ? end : value, outerColumn & last);
}

// The value of the invocation half a row away.
float3 halfRowSwap(float3 value) {
    return WaveReadLaneAt(value, WaveGetLaneIndex() ^ (SUBGROUP_ROW_WIDTH / 2u));
}

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
