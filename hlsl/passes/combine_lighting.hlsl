// SPDX-License-Identifier: Apache-2.0
// The light of a deferred renderer put together, with what the framework made of its visibility: Drobot, 7.3,
// whose ambient occlusion takes light away from the indirect and whose soft shadows from the sun's.
//
// gInLighting      RG8, RG16F or any with red a visibility in [0,1]: by occluders near by in red, of the sun
//                  in green, as bilateral_upsample writes both. LIGHTING says which of them there are; one
//                  alone is in red
// gInAmbientLight  LIGHTING occlusion, both: RGBA16F, the indirect light that occlusion takes away from
// gInSunLight      LIGHTING shadow, both: RGBA16F, the sun's light as if nothing stood before it
// gInOtherLight    OTHER_LIGHT: RGBA16F, what neither touches: emission, lamps, the sky's own colour. With
//                  one visibility alone, all the other's light too
// gOutLit          RGBA16F, ambient * occlusion + sun * shadow + other, and 1
// All are linear, scene-referred and of the frame's extent; the lights are already multiplied by the albedo.
// Of a light NaN and what is negative count as 0, infinity as MAX_COLOUR; a visibility that is no number
// counts as 1: light that leaks for a frame is seen less than a hole. The sum is at most MAX_COLOUR.

#include "reprise/colour.hlsli"
#include "reprise/coordinates.hlsli"
#include "reprise/finite.hlsli"
#include "reprise/platform.hlsli"

BINDING(0) cbuffer CombineLightingParameters {
    float4 gOutputSize;   // width, height, 1 / width, 1 / height
};

TEXTURE_POINT(gInLighting, 1);
#if !LIGHTING_SHADOW
TEXTURE_POINT(gInAmbientLight, 2);
#endif
#if !LIGHTING_OCCLUSION
TEXTURE_POINT(gInSunLight, 3);
#endif
#if OTHER_LIGHT
TEXTURE_POINT(gInOtherLight, 4);
#endif

float knownVisibility(float visibility) {
    return isNumber(visibility) ? saturate(visibility) : 1.0;
}

float4 litColour(float2 uv) {
    float4 lighting = SAMPLE(gInLighting, uv);
    float3 colour = 0.0;
#if !LIGHTING_SHADOW
    colour += sanitize(SAMPLE(gInAmbientLight, uv).rgb) * knownVisibility(lighting.r);
#endif
#if LIGHTING_SHADOW
    colour += sanitize(SAMPLE(gInSunLight, uv).rgb) * knownVisibility(lighting.r);
#elif LIGHTING_BOTH
    colour += sanitize(SAMPLE(gInSunLight, uv).rgb) * knownVisibility(lighting.g);
#endif
#if OTHER_LIGHT
    colour += sanitize(SAMPLE(gInOtherLight, uv).rgb);
#endif
    return float4(min(colour, MAX_COLOUR), 1.0);
}

#if STAGE_COMPUTE

BINDING(16) RWTexture2D<float4> gOutLit;

[numthreads(16, 16, 1)]
void mainCompute(uint3 thread : SV_DispatchThreadID) {
    gOutLit[thread.xy] = litColour(pxToUv(float2(thread.xy) + 0.5, gOutputSize.zw));
}

#else

float4 mainFragment(float4 positionPx : POSITION_PX) : SV_Target0 {
    return litColour(pxToUv(positionPx.xy, gOutputSize.zw));
}

#endif
