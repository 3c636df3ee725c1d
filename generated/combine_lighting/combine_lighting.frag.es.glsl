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

layout(location = 0) out vec4 gOutLit;

void main()
{
    vec2 _42 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _46 = textureLod(gInLighting, _42, 0.0);
    vec4 _50 = textureLod(gInAmbientLight, _42, 0.0);
    float _51 = _50.x;
    float _54 = _50.y;
    float _57 = _50.z;
    float _62 = _46.x;
    vec4 _71 = textureLod(gInSunLight, _42, 0.0);
    float _72 = _71.x;
    float _75 = _71.y;
    float _78 = _71.z;
    float _83 = _46.y;
    gOutLit = vec4(min((min(vec3((_51 > 0.0) ? _51 : 0.0, (_54 > 0.0) ? _54 : 0.0, (_57 > 0.0) ? _57 : 0.0), vec3(65504.0)) * ((abs(_62) <= 9.9999996802856924650656260769173e+37) ? clamp(_62, 0.0, 1.0) : 1.0)) + (min(vec3((_72 > 0.0) ? _72 : 0.0, (_75 > 0.0) ? _75 : 0.0, (_78 > 0.0) ? _78 : 0.0), vec3(65504.0)) * ((abs(_83) <= 9.9999996802856924650656260769173e+37) ? clamp(_83, 0.0, 1.0) : 1.0)), vec3(65504.0)), 1.0);
}

