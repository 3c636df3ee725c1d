#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutLit;
layout(binding = 1) uniform highp sampler2D gInLighting;
layout(binding = 2) uniform highp sampler2D gInAmbientLight;
layout(binding = 3) uniform highp sampler2D gInSunLight;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _60 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
        vec4 _64 = textureLod(gInLighting, _60, 0.0);
        vec4 _68 = textureLod(gInAmbientLight, _60, 0.0);
        float _69 = _68.x;
        float _72 = _68.y;
        float _75 = _68.z;
        float _80 = _64.x;
        vec4 _89 = textureLod(gInSunLight, _60, 0.0);
        float _90 = _89.x;
        float _93 = _89.y;
        float _96 = _89.z;
        float _101 = _64.y;
        imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min((min(vec3((_69 > 0.0) ? _69 : 0.0, (_72 > 0.0) ? _72 : 0.0, (_75 > 0.0) ? _75 : 0.0), vec3(65504.0)) * ((abs(_80) <= 9.9999996802856924650656260769173e+37) ? clamp(_80, 0.0, 1.0) : 1.0)) + (min(vec3((_90 > 0.0) ? _90 : 0.0, (_93 > 0.0) ? _93 : 0.0, (_96 > 0.0) ? _96 : 0.0), vec3(65504.0)) * ((abs(_101) <= 9.9999996802856924650656260769173e+37) ? clamp(_101, 0.0, 1.0) : 1.0)), vec3(65504.0)), 1.0));
        break;
    } while(false);
}

