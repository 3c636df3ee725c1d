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
    vec2 _74 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec3 _88 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _93 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _98 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _103 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _108 = clamp(textureLod(gInColour, _74, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _113 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _118 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _123 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _128 = clamp(textureLodOffset(gInColour, _74, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _133 = max(-parameters.gJitterPx.x, 0.0);
    float _135 = 1.0 - abs(parameters.gJitterPx.x);
    float _136 = max(parameters.gJitterPx.x, 0.0);
    vec3 _162 = (((((_88 * _133) + (_93 * _135)) + (_98 * _136)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_103 * _133) + (_108 * _135)) + (_113 * _136)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_118 * _133) + (_123 * _135)) + (_128 * _136)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _163 = floatBitsToInt(_103);
    ivec3 _164 = floatBitsToInt(_113);
    ivec3 _166 = floatBitsToInt(_108);
    ivec3 _169 = floatBitsToInt(intBitsToFloat(min(min(_163, _164), _166)));
    ivec3 _170 = floatBitsToInt(_93);
    ivec3 _172 = floatBitsToInt(_123);
    ivec3 _178 = floatBitsToInt(intBitsToFloat(max(max(_163, _164), _166)));
    ivec3 _182 = floatBitsToInt(_88);
    ivec3 _183 = floatBitsToInt(_98);
    ivec3 _187 = floatBitsToInt(_118);
    ivec3 _188 = floatBitsToInt(_128);
    vec3 _212 = ((intBitsToFloat(max(max(_178, _170), _172)) + intBitsToFloat(max(max(_178, floatBitsToInt(intBitsToFloat(max(max(_182, _183), _170)))), floatBitsToInt(intBitsToFloat(max(max(_187, _188), _172)))))) * 0.5) * 0.5;
    vec3 _213 = ((intBitsToFloat(min(min(_169, _170), _172)) + intBitsToFloat(min(min(_169, floatBitsToInt(intBitsToFloat(min(min(_182, _183), _170)))), floatBitsToInt(intBitsToFloat(min(min(_187, _188), _172)))))) * 0.5) * 0.5;
    vec3 _214 = _212 + _213;
    vec3 _216 = max(_212 - _213, vec3(1.5258789240815695542607954848791e-12));
    vec3 _217 = clamp(textureLod(gHistoryColour, _74, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _214;
    vec3 _220 = _216 / max(abs(_217), _216);
    vec3 _242 = min((_162 + (((_214 + (_217 * min(_220.x, min(_220.y, _220.z)))) - _162) * (all(lessThanEqual(abs(gl_FragCoord.xy * parameters.gOutputSize.zw + vec2(-0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    float _243 = length(vec2(0.0));
    vec2 _255 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
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
    gOutHistory = vec4(_242, 1.0);
    gOutColour = vec4(mix(min(_354 * vec3(0.14285714924335479736328125), vec3(65504.0)), _242, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - _243) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0)), 1.0);
}

