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
} parameters;

uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;
uniform highp sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _75 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec3 _89 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _94 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _99 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _104 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _109 = clamp(textureLod(gInColour, _75, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _114 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _119 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _124 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _129 = clamp(textureLodOffset(gInColour, _75, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _134 = max(-parameters.gJitterPx.x, 0.0);
    float _136 = 1.0 - abs(parameters.gJitterPx.x);
    float _137 = max(parameters.gJitterPx.x, 0.0);
    vec3 _163 = (((((_89 * _134) + (_94 * _136)) + (_99 * _137)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_104 * _134) + (_109 * _136)) + (_114 * _137)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_119 * _134) + (_124 * _136)) + (_129 * _137)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _164 = floatBitsToInt(_104);
    ivec3 _165 = floatBitsToInt(_114);
    ivec3 _167 = floatBitsToInt(_109);
    ivec3 _170 = floatBitsToInt(intBitsToFloat(min(min(_164, _165), _167)));
    ivec3 _171 = floatBitsToInt(_94);
    ivec3 _173 = floatBitsToInt(_124);
    ivec3 _179 = floatBitsToInt(intBitsToFloat(max(max(_164, _165), _167)));
    ivec3 _183 = floatBitsToInt(_89);
    ivec3 _184 = floatBitsToInt(_99);
    ivec3 _188 = floatBitsToInt(_119);
    ivec3 _189 = floatBitsToInt(_129);
    vec3 _213 = ((intBitsToFloat(max(max(_179, _171), _173)) + intBitsToFloat(max(max(_179, floatBitsToInt(intBitsToFloat(max(max(_183, _184), _171)))), floatBitsToInt(intBitsToFloat(max(max(_188, _189), _173)))))) * 0.5) * 0.5;
    vec3 _214 = ((intBitsToFloat(min(min(_170, _171), _173)) + intBitsToFloat(min(min(_170, floatBitsToInt(intBitsToFloat(min(min(_183, _184), _171)))), floatBitsToInt(intBitsToFloat(min(min(_188, _189), _173)))))) * 0.5) * 0.5;
    vec3 _215 = _213 + _214;
    vec3 _217 = max(_213 - _214, vec3(1.5258789240815695542607954848791e-12));
    vec3 _218 = clamp(textureLod(gHistoryColour, _75, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _215;
    vec3 _221 = _217 / max(abs(_218), _217);
    vec3 _243 = min((_163 + (((_215 + (_218 * min(_221.x, min(_221.y, _221.z)))) - _163) * (all(lessThanEqual(abs(gl_FragCoord.xy * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    float _244 = length(vec2(0.0));
    vec2 _257 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec4 _261 = textureLod(gInColourFiltered, _257, 0.0);
    float _262 = _261.x;
    float _265 = _261.y;
    float _268 = _261.z;
    vec4 _274 = textureLod(gInColourFiltered, _257, 0.0);
    float _275 = _274.x;
    float _278 = _274.y;
    float _281 = _274.z;
    vec4 _288 = textureLod(gInColourFiltered, _257, 0.0);
    float _289 = _288.x;
    float _292 = _288.y;
    float _295 = _288.z;
    vec4 _302 = textureLod(gInColourFiltered, _257, 0.0);
    float _303 = _302.x;
    float _306 = _302.y;
    float _309 = _302.z;
    vec4 _316 = textureLod(gInColourFiltered, _257, 0.0);
    float _317 = _316.x;
    float _320 = _316.y;
    float _323 = _316.z;
    vec4 _330 = textureLod(gInColourFiltered, _257, 0.0);
    float _331 = _330.x;
    float _334 = _330.y;
    float _337 = _330.z;
    vec4 _344 = textureLod(gInColourFiltered, _257, 0.0);
    float _345 = _344.x;
    float _348 = _344.y;
    float _351 = _344.z;
    vec3 _356 = (((((min(vec3((_262 > 0.0) ? _262 : 0.0, (_265 > 0.0) ? _265 : 0.0, (_268 > 0.0) ? _268 : 0.0), vec3(65504.0)) + min(vec3((_275 > 0.0) ? _275 : 0.0, (_278 > 0.0) ? _278 : 0.0, (_281 > 0.0) ? _281 : 0.0), vec3(65504.0))) + min(vec3((_289 > 0.0) ? _289 : 0.0, (_292 > 0.0) ? _292 : 0.0, (_295 > 0.0) ? _295 : 0.0), vec3(65504.0))) + min(vec3((_303 > 0.0) ? _303 : 0.0, (_306 > 0.0) ? _306 : 0.0, (_309 > 0.0) ? _309 : 0.0), vec3(65504.0))) + min(vec3((_317 > 0.0) ? _317 : 0.0, (_320 > 0.0) ? _320 : 0.0, (_323 > 0.0) ? _323 : 0.0), vec3(65504.0))) + min(vec3((_331 > 0.0) ? _331 : 0.0, (_334 > 0.0) ? _334 : 0.0, (_337 > 0.0) ? _337 : 0.0), vec3(65504.0))) + min(vec3((_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0, (_351 > 0.0) ? _351 : 0.0), vec3(65504.0));
    gOutHistory = vec4(_243, 1.0);
    gOutColour = vec4(mix(min(_356 * vec3(0.14285714924335479736328125), vec3(65504.0)), _243, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _244) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0)), 1.0);
}

