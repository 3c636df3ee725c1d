#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform CombineLightingParameters
{
    vec4 gOutputSize;
} parameters;

uniform highp sampler2D gInLighting;
uniform highp sampler2D gInAmbientLight;
uniform highp sampler2D gInSunLight;
uniform highp sampler2D gInOtherLight;

layout(location = 0) out vec4 gOutLit;

void main()
{
    vec2 _44 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _48 = textureLod(gInLighting, _44, 0.0);
    vec4 _52 = textureLod(gInAmbientLight, _44, 0.0);
    float _53 = _52.x;
    float _56 = _52.y;
    float _59 = _52.z;
    float _64 = _48.x;
    vec4 _73 = textureLod(gInSunLight, _44, 0.0);
    float _74 = _73.x;
    float _77 = _73.y;
    float _80 = _73.z;
    float _85 = _48.y;
    vec4 _95 = textureLod(gInOtherLight, _44, 0.0);
    float _96 = _95.x;
    float _99 = _95.y;
    float _102 = _95.z;
    gOutLit = vec4(min(((min(vec3((_53 > 0.0) ? _53 : 0.0, (_56 > 0.0) ? _56 : 0.0, (_59 > 0.0) ? _59 : 0.0), vec3(65504.0)) * ((abs(_64) <= 9.9999996802856924650656260769173e+37) ? clamp(_64, 0.0, 1.0) : 1.0)) + (min(vec3((_74 > 0.0) ? _74 : 0.0, (_77 > 0.0) ? _77 : 0.0, (_80 > 0.0) ? _80 : 0.0), vec3(65504.0)) * ((abs(_85) <= 9.9999996802856924650656260769173e+37) ? clamp(_85, 0.0, 1.0) : 1.0))) + min(vec3((_96 > 0.0) ? _96 : 0.0, (_99 > 0.0) ? _99 : 0.0, (_102 > 0.0) ? _102 : 0.0), vec3(65504.0)), vec3(65504.0)), 1.0);
}

