// SPDX-License-Identifier: Apache-2.0
// The conventions that every header and pass shares. docs/conventions.md has the same list at length.
//
// Names      Suffix: WS world, VS view, CS clip, NDC, UV, PX pixels. Prefix prev: the frame before.
// View space x right, y up, +z forward. Linear depth is view z in metres, positive in front of the camera.
// NDC        x right, y up, depth in [0,1]; standard (near 0), reversed (near 1) or reversed infinite.
// UV         origin top left, x right, y down; the centre of pixel (i, j) is ((i + 0.5) / W, (j + 0.5) / H).
// Motion     currUv - prevUv, without jitter, in UV (INSIDE, "Reprojection of dynamic scenes").
// Jitter     in pixels, x right, y down, within [-0.5, 0.5): the rendered image is moved by +jitter.
// Colour     linear and scene-referred, 0 to 65504, unless a name says otherwise.
#ifndef REPRISE_CONVENTIONS_HLSLI
#define REPRISE_CONVENTIONS_HLSLI

// The largest finite binary16: what a colour, and so a history, may hold.
static const float MAX_COLOUR = 65504.0;

// A matrix is stored as GLM stores it: column after column, to be multiplied by column vectors. Declared
// row_major, those bytes arrive transposed, so the vector stands on the left. An engine that stores
// row-vector matrices row after row has the same bytes; one that stores column-vector matrices row after row
// (or row-vector ones column after column) sets MATRIX_ROW_VECTORS.
float4 transform(float4x4 m, float4 v) {
#if MATRIX_ROW_VECTORS
    return mul(m, v);
#else
    return mul(v, m);
#endif
}

#endif
