// SPDX-License-Identifier: Apache-2.0
// A clamp that NaN does not pass. clamp, saturate, min and max leave it open what they give for NaN; an
// ordered comparison is false for it. (Shader model 3 has no rule for NaN at all: there its compiler turns
// comparisons around, and on its devices the guard holds for infinity alone.)
#ifndef REPRISE_BOUNDED_HLSLI
#define REPRISE_BOUNDED_HLSLI

// v held to [low, high]; NaN gives low. low <= high, both numbers. In any unit; per component.
float bounded(float v, float low, float high) {
    return v > low ? min(v, high) : low;
}

float2 bounded(float2 v, float low, float high) {
    return float2(bounded(v.x, low, high), bounded(v.y, low, high));
}

float3 bounded(float3 v, float low, float high) {
    return float3(bounded(v.x, low, high), bounded(v.y, low, high), bounded(v.z, low, high));
}

float4 bounded(float4 v, float low, float high) {
    return float4(bounded(v.xy, low, high), bounded(v.zw, low, high));
}

#endif
