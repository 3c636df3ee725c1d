#version 310 es
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutLit;
layout(binding = 1) uniform highp sampler2D gInLighting;
layout(binding = 3) uniform highp sampler2D gInSunLight;

void main()
{
    vec2 _48 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _52 = textureLod(gInLighting, _48, 0.0);
    vec4 _56 = textureLod(gInSunLight, _48, 0.0);
    float _57 = _56.x;
    float _60 = _56.y;
    float _63 = _56.z;
    float _68 = _52.x;
    imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min(min(vec3((_57 > 0.0) ? _57 : 0.0, (_60 > 0.0) ? _60 : 0.0, (_63 > 0.0) ? _63 : 0.0), vec3(65504.0)) * ((abs(_68) <= 9.9999996802856924650656260769173e+37) ? clamp(_68, 0.0, 1.0) : 1.0), vec3(65504.0)), 1.0));
}

