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
} parameters;

layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec3 _91 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _96 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _101 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _106 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _111 = clamp(textureLod(gInColour, _77, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _116 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _121 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _126 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _131 = clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
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
    vec3 _215 = max(_212 - _211, vec3(6.1035156963262782170431819395162e-12));
    vec3 _217 = (clamp(textureLod(gHistoryColour, _77, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _213;
    vec3 _220 = _215 / max(abs(_217), _215);
    vec3 _243 = min((_165 + ((((_213 + (_217 * min(_220.x, min(_220.y, _220.z)))) * 0.25) - _165) * (all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _257 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
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
    gOutColour = vec4(mix(min(_356 * vec3(0.14285714924335479736328125), vec3(65504.0)), _243, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(vec2(0.0))) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0)), 1.0);
}

