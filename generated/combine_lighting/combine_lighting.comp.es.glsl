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
    vec2 _50 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _54 = textureLod(gInLighting, _50, 0.0);
    vec4 _58 = textureLod(gInAmbientLight, _50, 0.0);
    float _59 = _58.x;
    float _62 = _58.y;
    float _65 = _58.z;
    float _70 = _54.x;
    vec4 _79 = textureLod(gInSunLight, _50, 0.0);
    float _80 = _79.x;
    float _83 = _79.y;
    float _86 = _79.z;
    float _91 = _54.y;
    imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min((min(vec3((_59 > 0.0) ? _59 : 0.0, (_62 > 0.0) ? _62 : 0.0, (_65 > 0.0) ? _65 : 0.0), vec3(65504.0)) * ((abs(_70) <= 9.9999996802856924650656260769173e+37) ? clamp(_70, 0.0, 1.0) : 1.0)) + (min(vec3((_80 > 0.0) ? _80 : 0.0, (_83 > 0.0) ? _83 : 0.0, (_86 > 0.0) ? _86 : 0.0), vec3(65504.0)) * ((abs(_91) <= 9.9999996802856924650656260769173e+37) ? clamp(_91, 0.0, 1.0) : 1.0)), vec3(65504.0)), 1.0));
}

