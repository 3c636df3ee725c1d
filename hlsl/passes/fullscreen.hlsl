// SPDX-License-Identifier: Apache-2.0
// The triangle that covers the viewport. Passes take their coordinates from SV_Position, so nothing is
// interpolated.

float4 mainVertex(uint vertex : SV_VertexID) : SV_Position {
    return float4(vertex == 1 ? 3.0 : -1.0, vertex == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
