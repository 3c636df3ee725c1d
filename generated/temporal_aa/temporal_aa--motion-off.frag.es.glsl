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

uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;
uniform highp sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec3 _92 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _97 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _102 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _107 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _112 = clamp(textureLod(gInColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _117 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _122 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _127 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _132 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _137 = max(-parameters.gJitterPx.x, 0.0);
    float _139 = 1.0 - abs(parameters.gJitterPx.x);
    float _140 = max(parameters.gJitterPx.x, 0.0);
    vec3 _166 = (((((_92 * _137) + (_97 * _139)) + (_102 * _140)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_107 * _137) + (_112 * _139)) + (_117 * _140)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_122 * _137) + (_127 * _139)) + (_132 * _140)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _167 = floatBitsToInt(_107);
    ivec3 _168 = floatBitsToInt(_117);
    ivec3 _170 = floatBitsToInt(_112);
    ivec3 _173 = floatBitsToInt(intBitsToFloat(min(min(_167, _168), _170)));
    ivec3 _174 = floatBitsToInt(_97);
    ivec3 _176 = floatBitsToInt(_127);
    ivec3 _182 = floatBitsToInt(intBitsToFloat(max(max(_167, _168), _170)));
    ivec3 _186 = floatBitsToInt(_92);
    ivec3 _187 = floatBitsToInt(_102);
    ivec3 _191 = floatBitsToInt(_122);
    ivec3 _192 = floatBitsToInt(_132);
    vec3 _212 = intBitsToFloat(min(min(_173, _174), _176)) + intBitsToFloat(min(min(_173, floatBitsToInt(intBitsToFloat(min(min(_186, _187), _174)))), floatBitsToInt(intBitsToFloat(min(min(_191, _192), _176)))));
    vec3 _213 = intBitsToFloat(max(max(_182, _174), _176)) + intBitsToFloat(max(max(_182, floatBitsToInt(intBitsToFloat(max(max(_186, _187), _174)))), floatBitsToInt(intBitsToFloat(max(max(_191, _192), _176)))));
    vec3 _214 = _213 + _212;
    vec3 _216 = max(_213 - _212, vec3(6.1035156963262782170431819395162e-12));
    vec3 _218 = (clamp(textureLod(gHistoryColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _214;
    vec3 _221 = _216 / max(abs(_218), _216);
    vec3 _244 = min((_166 + ((((_214 + (_218 * min(_221.x, min(_221.y, _221.z)))) * 0.25) - _166) * (all(lessThanEqual(abs(gl_FragCoord.xy * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    float _245 = length(vec2(0.0));
    vec2 _258 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec4 _262 = textureLod(gInColourFiltered, _258, 0.0);
    float _263 = _262.x;
    float _266 = _262.y;
    float _269 = _262.z;
    vec4 _275 = textureLod(gInColourFiltered, _258, 0.0);
    float _276 = _275.x;
    float _279 = _275.y;
    float _282 = _275.z;
    vec4 _289 = textureLod(gInColourFiltered, _258, 0.0);
    float _290 = _289.x;
    float _293 = _289.y;
    float _296 = _289.z;
    vec4 _303 = textureLod(gInColourFiltered, _258, 0.0);
    float _304 = _303.x;
    float _307 = _303.y;
    float _310 = _303.z;
    vec4 _317 = textureLod(gInColourFiltered, _258, 0.0);
    float _318 = _317.x;
    float _321 = _317.y;
    float _324 = _317.z;
    vec4 _331 = textureLod(gInColourFiltered, _258, 0.0);
    float _332 = _331.x;
    float _335 = _331.y;
    float _338 = _331.z;
    vec4 _345 = textureLod(gInColourFiltered, _258, 0.0);
    float _346 = _345.x;
    float _349 = _345.y;
    float _352 = _345.z;
    vec3 _357 = (((((min(vec3((_263 > 0.0) ? _263 : 0.0, (_266 > 0.0) ? _266 : 0.0, (_269 > 0.0) ? _269 : 0.0), vec3(65504.0)) + min(vec3((_276 > 0.0) ? _276 : 0.0, (_279 > 0.0) ? _279 : 0.0, (_282 > 0.0) ? _282 : 0.0), vec3(65504.0))) + min(vec3((_290 > 0.0) ? _290 : 0.0, (_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0), vec3(65504.0))) + min(vec3((_304 > 0.0) ? _304 : 0.0, (_307 > 0.0) ? _307 : 0.0, (_310 > 0.0) ? _310 : 0.0), vec3(65504.0))) + min(vec3((_318 > 0.0) ? _318 : 0.0, (_321 > 0.0) ? _321 : 0.0, (_324 > 0.0) ? _324 : 0.0), vec3(65504.0))) + min(vec3((_332 > 0.0) ? _332 : 0.0, (_335 > 0.0) ? _335 : 0.0, (_338 > 0.0) ? _338 : 0.0), vec3(65504.0))) + min(vec3((_346 > 0.0) ? _346 : 0.0, (_349 > 0.0) ? _349 : 0.0, (_352 > 0.0) ? _352 : 0.0), vec3(65504.0));
    gOutHistory = vec4(_244, 1.0);
    gOutColour = vec4(mix(min(_357 * vec3(0.14285714924335479736328125), vec3(65504.0)), _244, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _245) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0)), 1.0);
}

