// SPDX-License-Identifier: Apache-2.0
// Lit colour of the scene, and with GBUFFER what temporal passes read beside it.
// Switches: SKINNED, TEXTURED, GBUFFER, POINT_LIGHTS (their number), DEPTH_ONLY (alpha test and nothing else;
// what is drawn after it needs no test).
#include "scene_common.hlsli"

[[vk::binding(4, 0)]] Texture2D gShadows;
[[vk::binding(5, 0)]] SamplerComparisonState gShadows_sampler;

static const float DIELECTRIC_REFLECTANCE = 0.04;
// The sun is half a degree wide; a sharper lobe than this would show a highlight that is smaller than it.
static const float MIN_ROUGHNESS = 0.18;
static const float OFF_SCREEN = 4.0;   // motion of what was behind the previous camera, in UV

struct Varyings {
    float4 positionPx : SV_Position;
    [[vk::location(0)]] float3 positionWS : TEXCOORD0;
    [[vk::location(1)]] float3 normalWS : TEXCOORD1;
    [[vk::location(2)]] float2 uv : TEXCOORD2;
#if GBUFFER
    [[vk::location(3)]] float3 prevClip : TEXCOORD3;   // x, y, w
#endif
};

Varyings mainVertex(VertexInput input) {
    float4 position = float4(input.position, 1.0);
    float4 prevPosition = position;
    float3 normal = input.normal;
#if SKINNED
    uint firstJoint = gIdentity.y;
    float4x4 skin = skinMatrix(firstJoint, input.joints, input.weights);
    position = mul(position, skin);
    normal = mul(normal, (float3x3)skin);
    prevPosition = mul(prevPosition, prevSkinMatrix(firstJoint, input.joints, input.weights));
#endif
    Varyings output;
    output.positionWS = mul(position, gObjectToWorld).xyz;
    output.normalWS = gNormalToWorld[0].xyz * normal.x + gNormalToWorld[1].xyz * normal.y +
                      gNormalToWorld[2].xyz * normal.z;
    output.uv = input.uv;
    // Precise: the depth pass and the pass after it must agree to the bit.
    precise float4 positionCS = mul(position, gObjectToClip);
    positionCS.xy += gRender.jitterNdc * positionCS.w;
    output.positionPx = positionCS;
#if GBUFFER
    output.prevClip = mul(prevPosition, gPrevObjectToClip).xyw;
#endif
    return output;
}

// One hardware comparison with linear filtering is a 2×2 percentage-closer filter.
float sunVisibility(float3 positionWS, float3 normalWS) {
    float linearDepth = dot(positionWS - gCameraWS.xyz, gForwardWS.xyz);
    uint cascade = linearDepth > gCascadeFar.x ? (linearDepth > gCascadeFar.y ? 2 : 1) : 0;
    // Offset along the normal by more than a texel, so that a surface does not shadow itself.
    float3 receiver = positionWS + normalWS * gCascadeTexel[cascade] * 1.8;
    float3 light = mul(float4(receiver, 1.0), gWorldToLightClip[cascade]).xyz;
    float2 uv = float2((light.x * 0.5 + 0.5 + float(cascade)) / 3.0, 0.5 - light.y * 0.5);
    float lit = gShadows.SampleCmpLevelZero(gShadows_sampler, uv, light.z);
    return linearDepth > gCascadeFar.z ? 1.0 : lit;
}

float fresnelSchlick(float cosine) {
    return DIELECTRIC_REFLECTANCE + (1.0 - DIELECTRIC_REFLECTANCE) * pow(1.0 - cosine, 5.0);
}

// GGX with the height-correlated visibility term in its common approximation by Hammon.
float3 reflected(float3 albedo, float3 normal, float3 view, float3 light, float roughness) {
    float3 halfway = normalize(view + light);
    float nl = saturate(dot(normal, light)), nv = abs(dot(normal, view)) + 1e-4;
    float nh = saturate(dot(normal, halfway)), vh = saturate(dot(view, halfway));
    float a = roughness * roughness, a2 = a * a;
    float spread = nh * nh * (a2 - 1.0) + 1.0;
    float distribution = a2 / (PI * spread * spread);
    float visibility = 0.5 / lerp(2.0 * nl * nv, nl + nv, a);
    float fresnel = fresnelSchlick(vh);
    // Radiance is given for a white diffuse surface: irradiance over pi.
    return (albedo + PI * distribution * visibility * fresnel) * nl;
}

float3 ambient(float3 albedo, float3 normal, float3 view, float roughness) {
    float3 hemisphere = lerp(gGroundRadiance.rgb, gSkyRadiance.rgb, normal.y * 0.5 + 0.5);
    float fresnel = fresnelSchlick(saturate(dot(normal, view)));
    float smoothness = (1.0 - roughness) * (1.0 - roughness);
    return albedo * hemisphere + skyColour(reflect(-view, normal)) * fresnel * smoothness;
}

float3 shade(float3 albedo, float3 emission, float roughness, float3 position, float3 normal) {
    float3 view = normalize(gCameraWS.xyz - position);
    roughness = max(roughness, MIN_ROUGHNESS);
    float3 colour = emission + ambient(albedo, normal, view, roughness);
    colour += gSunRadiance.rgb * sunVisibility(position, normal) *
              reflected(albedo, normal, view, gSunDirection.xyz, roughness);
#if POINT_LIGHTS
    [unroll] for (uint i = 0; i < POINT_LIGHTS; ++i) {
        float3 toLight = gLightPosition[i].xyz - position;
        float squared = dot(toLight, toLight) + 0.01;
        colour += gLightIntensity[i].rgb / squared *
                  reflected(albedo, normal, view, toLight * rsqrt(squared), roughness);
    }
#endif
    return min(colour, 60000.0);   // within binary16
}

#if GBUFFER
struct Targets {
    float4 colour : SV_Target0;
    float depth : SV_Target1;
    float4 normal : SV_Target2;
    float2 motion : SV_Target3;
    uint2 ids : SV_Target4;
};

float2 motionUv(float2 positionPx, float3 prevClip) {
    float2 currUv = (positionPx - gRender.jitterPx) * gSize.zw;
    float2 prevNdc = prevClip.xy / max(prevClip.z, 1e-6);
    float2 prevUv = float2(prevNdc.x * 0.5 + 0.5, 0.5 - prevNdc.y * 0.5);
    return prevClip.z > 1e-6 ? clamp(currUv - prevUv, -OFF_SCREEN, OFF_SCREEN) : OFF_SCREEN;
}
#else
struct Targets {
    float4 colour : SV_Target0;
};
#endif

#if DEPTH_ONLY
void mainFragment(Varyings input) {
    float alpha = gAlpha.SampleBias(gAlpha_sampler, input.uv, gRender.lodBias).a;
    if (alpha * gBaseColour.a < gAlphaCutoff.x) discard;
}
#else
Targets mainFragment(Varyings input
#if GBUFFER
                     , uint primitive : SV_PrimitiveID
#endif
) {
    float4 base = gBaseColour;
#if TEXTURED
    base *= gAlbedo.SampleBias(gAlbedo_sampler, input.uv, gRender.lodBias);
#endif
    float3 normal = normalize(input.normalWS);
    // Back faces are drawn only where a material has two sides: light them from behind their normal too.
    normal = gAlphaCutoff.y > 0.0 && dot(normal, input.positionWS - gCameraWS.xyz) > 0.0 ? -normal : normal;
    Targets output;
    output.colour = float4(shade(base.rgb, gEmission.rgb, gEmission.a, input.positionWS, normal), 1.0);
#if GBUFFER
    output.depth = input.positionPx.z;
    output.normal = float4(normal, 0.0);
    output.motion = motionUv(input.positionPx.xy, input.prevClip);
    output.ids = uint2(gIdentity.x, primitive + 1);
#endif
    return output;
}
#endif
