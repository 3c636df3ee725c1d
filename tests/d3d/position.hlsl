// SPDX-License-Identifier: Apache-2.0
// Writes where each pixel is, for a look at coverage and interpolation.

#include "reprise/platform.hlsli"

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return float4(positionPx.xy, 0.0, 1.0);
}
