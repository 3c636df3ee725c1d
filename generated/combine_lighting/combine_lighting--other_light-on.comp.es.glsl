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
layout(binding = 4) uniform highp sampler2D gInOtherLight;

void main()
{
    vec2 _52 = (vec2(gl_GlobalInvocationID.xy) + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _56 = textureLod(gInLighting, _52, 0.0);
    vec4 _60 = textureLod(gInAmbientLight, _52, 0.0);
    float _61 = _60.x;
    float _64 = _60.y;
    float _67 = _60.z;
    float _72 = _56.x;
    vec4 _81 = textureLod(gInSunLight, _52, 0.0);
    float _82 = _81.x;
    float _85 = _81.y;
    float _88 = _81.z;
    float _93 = _56.y;
    vec4 _103 = textureLod(gInOtherLight, _52, 0.0);
    float _104 = _103.x;
    float _107 = _103.y;
    float _110 = _103.z;
    imageStore(gOutLit, ivec2(gl_GlobalInvocationID.xy), vec4(min(((min(vec3((_61 > 0.0) ? _61 : 0.0, (_64 > 0.0) ? _64 : 0.0, (_67 > 0.0) ? _67 : 0.0), vec3(65504.0)) * ((abs(_72) <= 9.9999996802856924650656260769173e+37) ? clamp(_72, 0.0, 1.0) : 1.0)) + (min(vec3((_82 > 0.0) ? _82 : 0.0, (_85 > 0.0) ? _85 : 0.0, (_88 > 0.0) ? _88 : 0.0), vec3(65504.0)) * ((abs(_93) <= 9.9999996802856924650656260769173e+37) ? clamp(_93, 0.0, 1.0) : 1.0))) + min(vec3((_104 > 0.0) ? _104 : 0.0, (_107 > 0.0) ? _107 : 0.0, (_110 > 0.0) ? _110 : 0.0), vec3(65504.0)), vec3(65504.0)), 1.0));
}

