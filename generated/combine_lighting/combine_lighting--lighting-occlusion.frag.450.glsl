#version 450

layout(binding = 0, std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

layout(binding = 1) uniform sampler2D gInLighting;
layout(binding = 2) uniform sampler2D gInAmbientLight;

layout(location = 0) out vec4 gOutLit;

void main()
{
    vec2 _40 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _44 = textureLod(gInLighting, _40, 0.0);
    vec4 _48 = textureLod(gInAmbientLight, _40, 0.0);
    float _49 = _48.x;
    float _52 = _48.y;
    float _55 = _48.z;
    float _60 = _44.x;
    gOutLit = vec4(min(min(vec3((_49 > 0.0) ? _49 : 0.0, (_52 > 0.0) ? _52 : 0.0, (_55 > 0.0) ? _55 : 0.0), vec3(65504.0)) * ((abs(_60) <= 9.9999996802856924650656260769173e+37) ? clamp(_60, 0.0, 1.0) : 1.0), vec3(65504.0)), 1.0);
}

