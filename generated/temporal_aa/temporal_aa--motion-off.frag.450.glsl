#version 450

layout(binding = 0, std140) uniform TemporalAaParameters
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

layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec3 _91 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _96 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _101 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _106 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _111 = clamp(textureLod(gInColour, _77, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _116 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _121 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _126 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _131 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    float _136 = max(-parameters.gJitterPx.x, 0.0);
    float _138 = 1.0 - abs(parameters.gJitterPx.x);
    float _139 = max(parameters.gJitterPx.x, 0.0);
    vec3 _165 = (((((_91 * _136) + (_96 * _138)) + (_101 * _139)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_106 * _136) + (_111 * _138)) + (_116 * _139)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_121 * _136) + (_126 * _138)) + (_131 * _139)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _166 = floatBitsToInt(_106);
    ivec3 _167 = floatBitsToInt(_116);
    ivec3 _169 = floatBitsToInt(_111);
    ivec3 _172 = floatBitsToInt(intBitsToFloat(min(min(_166, _167), _169)));
    ivec3 _173 = floatBitsToInt(_96);
    ivec3 _175 = floatBitsToInt(_126);
    ivec3 _181 = floatBitsToInt(intBitsToFloat(max(max(_166, _167), _169)));
    ivec3 _185 = floatBitsToInt(_91);
    ivec3 _186 = floatBitsToInt(_101);
    ivec3 _190 = floatBitsToInt(_121);
    ivec3 _191 = floatBitsToInt(_131);
    vec3 _211 = intBitsToFloat(min(min(_172, _173), _175)) + intBitsToFloat(min(min(_172, floatBitsToInt(intBitsToFloat(min(min(_185, _186), _173)))), floatBitsToInt(intBitsToFloat(min(min(_190, _191), _175)))));
    vec3 _212 = intBitsToFloat(max(max(_181, _173), _175)) + intBitsToFloat(max(max(_181, floatBitsToInt(intBitsToFloat(max(max(_185, _186), _173)))), floatBitsToInt(intBitsToFloat(max(max(_190, _191), _175)))));
    vec3 _213 = _212 + _211;
    vec3 _217 = (clamp(textureLod(gHistoryColour, _77, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _213;
    vec3 _220 = clamp(max(_212 - _211, vec3(6.1064972523006133542367024347186e-12)) / abs(_217), vec3(0.0), vec3(1.0));
    vec3 _241 = (_165 + ((((_213 + (_217 * min(_220.x, min(_220.y, _220.z)))) * 0.25) - _165) * (all(lessThanEqual(floatBitsToUint(_77), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _255 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec4 _259 = textureLod(gInColourFiltered, _255, 0.0);
    float _260 = _259.x;
    float _263 = _259.y;
    float _266 = _259.z;
    vec4 _272 = textureLod(gInColourFiltered, _255, 0.0);
    float _273 = _272.x;
    float _276 = _272.y;
    float _279 = _272.z;
    vec4 _286 = textureLod(gInColourFiltered, _255, 0.0);
    float _287 = _286.x;
    float _290 = _286.y;
    float _293 = _286.z;
    vec4 _300 = textureLod(gInColourFiltered, _255, 0.0);
    float _301 = _300.x;
    float _304 = _300.y;
    float _307 = _300.z;
    vec4 _314 = textureLod(gInColourFiltered, _255, 0.0);
    float _315 = _314.x;
    float _318 = _314.y;
    float _321 = _314.z;
    vec4 _328 = textureLod(gInColourFiltered, _255, 0.0);
    float _329 = _328.x;
    float _332 = _328.y;
    float _335 = _328.z;
    vec4 _342 = textureLod(gInColourFiltered, _255, 0.0);
    float _343 = _342.x;
    float _346 = _342.y;
    float _349 = _342.z;
    vec3 _354 = (((((min(vec3((_260 > 0.0) ? _260 : 0.0, (_263 > 0.0) ? _263 : 0.0, (_266 > 0.0) ? _266 : 0.0), vec3(65504.0)) + min(vec3((_273 > 0.0) ? _273 : 0.0, (_276 > 0.0) ? _276 : 0.0, (_279 > 0.0) ? _279 : 0.0), vec3(65504.0))) + min(vec3((_287 > 0.0) ? _287 : 0.0, (_290 > 0.0) ? _290 : 0.0, (_293 > 0.0) ? _293 : 0.0), vec3(65504.0))) + min(vec3((_301 > 0.0) ? _301 : 0.0, (_304 > 0.0) ? _304 : 0.0, (_307 > 0.0) ? _307 : 0.0), vec3(65504.0))) + min(vec3((_315 > 0.0) ? _315 : 0.0, (_318 > 0.0) ? _318 : 0.0, (_321 > 0.0) ? _321 : 0.0), vec3(65504.0))) + min(vec3((_329 > 0.0) ? _329 : 0.0, (_332 > 0.0) ? _332 : 0.0, (_335 > 0.0) ? _335 : 0.0), vec3(65504.0))) + min(vec3((_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0, (_349 > 0.0) ? _349 : 0.0), vec3(65504.0));
    gOutHistory = vec4(_241, 1.0);
    gOutColour = vec4(mix(min(_354 * vec3(0.14285714924335479736328125), vec3(65504.0)), _241, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(vec2(0.0))) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0)), 1.0);
}

