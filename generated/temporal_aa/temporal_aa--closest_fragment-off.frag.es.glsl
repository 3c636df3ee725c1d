#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform TemporalAaParameters
{
    vec4 gOutputSize;
    vec2 gJitterPx;
    vec2 gMotionToUv;
    float gHistoryValid;
    float gFeedbackMin;
    float gFeedbackMax;
    float gBlurFromPx;
    float gBlurToPx;
    mat4 gReprojection;
} parameters;

uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;
uniform highp sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _81 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _89 = textureLod(gInVelocity, _81, 0.0).xy * parameters.gMotionToUv;
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_89);
    vec3 _105 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _110 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _115 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _120 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _125 = clamp(textureLod(gInColour, _81, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _130 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _135 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _140 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _145 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _150 = max(-parameters.gJitterPx.x, 0.0);
    float _152 = 1.0 - abs(parameters.gJitterPx.x);
    float _153 = max(parameters.gJitterPx.x, 0.0);
    vec3 _179 = (((((_105 * _150) + (_110 * _152)) + (_115 * _153)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_120 * _150) + (_125 * _152)) + (_130 * _153)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_135 * _150) + (_140 * _152)) + (_145 * _153)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _180 = floatBitsToInt(_120);
    ivec3 _181 = floatBitsToInt(_130);
    ivec3 _183 = floatBitsToInt(_125);
    ivec3 _186 = floatBitsToInt(intBitsToFloat(min(min(_180, _181), _183)));
    ivec3 _187 = floatBitsToInt(_110);
    ivec3 _189 = floatBitsToInt(_140);
    ivec3 _195 = floatBitsToInt(intBitsToFloat(max(max(_180, _181), _183)));
    ivec3 _199 = floatBitsToInt(_105);
    ivec3 _200 = floatBitsToInt(_115);
    ivec3 _204 = floatBitsToInt(_135);
    ivec3 _205 = floatBitsToInt(_145);
    vec3 _225 = intBitsToFloat(min(min(_186, _187), _189)) + intBitsToFloat(min(min(_186, floatBitsToInt(intBitsToFloat(min(min(_199, _200), _187)))), floatBitsToInt(intBitsToFloat(min(min(_204, _205), _189)))));
    vec3 _226 = intBitsToFloat(max(max(_195, _187), _189)) + intBitsToFloat(max(max(_195, floatBitsToInt(intBitsToFloat(max(max(_199, _200), _187)))), floatBitsToInt(intBitsToFloat(max(max(_204, _205), _189)))));
    vec3 _227 = _226 + _225;
    vec3 _229 = max(_226 - _225, vec3(6.1035156963262782170431819395162e-12));
    vec3 _231 = (clamp(textureLod(gHistoryColour, _91, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _227;
    vec3 _234 = _229 / max(abs(_231), _229);
    vec3 _257 = min((_179 + ((((_227 + (_231 * min(_234.x, min(_234.y, _234.z)))) * 0.25) - _179) * (all(lessThanEqual(abs(_91 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _273 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _276 = _89 * 0.083333335816860198974609375;
    vec4 _278 = textureLod(gInColourFiltered, _273, 0.0);
    float _279 = _278.x;
    float _282 = _278.y;
    float _285 = _278.z;
    vec2 _291 = _276 * 1.0;
    vec4 _293 = textureLod(gInColourFiltered, _273 + _291, 0.0);
    float _294 = _293.x;
    float _297 = _293.y;
    float _300 = _293.z;
    vec4 _308 = textureLod(gInColourFiltered, _273 - _291, 0.0);
    float _309 = _308.x;
    float _312 = _308.y;
    float _315 = _308.z;
    vec2 _322 = _276 * 2.0;
    vec4 _324 = textureLod(gInColourFiltered, _273 + _322, 0.0);
    float _325 = _324.x;
    float _328 = _324.y;
    float _331 = _324.z;
    vec4 _339 = textureLod(gInColourFiltered, _273 - _322, 0.0);
    float _340 = _339.x;
    float _343 = _339.y;
    float _346 = _339.z;
    vec2 _353 = _276 * 3.0;
    vec4 _355 = textureLod(gInColourFiltered, _273 + _353, 0.0);
    float _356 = _355.x;
    float _359 = _355.y;
    float _362 = _355.z;
    vec4 _370 = textureLod(gInColourFiltered, _273 - _353, 0.0);
    float _371 = _370.x;
    float _374 = _370.y;
    float _377 = _370.z;
    vec3 _382 = (((((min(vec3((_279 > 0.0) ? _279 : 0.0, (_282 > 0.0) ? _282 : 0.0, (_285 > 0.0) ? _285 : 0.0), vec3(65504.0)) + min(vec3((_294 > 0.0) ? _294 : 0.0, (_297 > 0.0) ? _297 : 0.0, (_300 > 0.0) ? _300 : 0.0), vec3(65504.0))) + min(vec3((_309 > 0.0) ? _309 : 0.0, (_312 > 0.0) ? _312 : 0.0, (_315 > 0.0) ? _315 : 0.0), vec3(65504.0))) + min(vec3((_325 > 0.0) ? _325 : 0.0, (_328 > 0.0) ? _328 : 0.0, (_331 > 0.0) ? _331 : 0.0), vec3(65504.0))) + min(vec3((_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0), vec3(65504.0))) + min(vec3((_356 > 0.0) ? _356 : 0.0, (_359 > 0.0) ? _359 : 0.0, (_362 > 0.0) ? _362 : 0.0), vec3(65504.0))) + min(vec3((_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0, (_377 > 0.0) ? _377 : 0.0), vec3(65504.0));
    vec3 _386 = mix(min(_382 * vec3(0.14285714924335479736328125), vec3(65504.0)), _257, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_89 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_257, 1.0);
    gOutColour = vec4(_386, 1.0);
}

