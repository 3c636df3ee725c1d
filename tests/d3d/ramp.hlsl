// SPDX-License-Identifier: Apache-2.0
// Reads 64x64 places of a row of 64 texels, whose texel x holds x, with the linear filter: what comes back is
// the place, but for the error of the filter's weights.

#include "reprise/platform.hlsli"

TEXTURE_LINEAR(gInRamp, 0);

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    float index = floor(positionPx.y) * 64.0 + floor(positionPx.x);
    return SAMPLE(gInRamp, float2((index + 0.5) / 4096.0, 0.5));
}
