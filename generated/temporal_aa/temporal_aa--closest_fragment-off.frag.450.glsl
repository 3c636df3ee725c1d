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

layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _86 = textureLod(gInVelocity, _78, 0.0).xy * parameters.gMotionToUv;
    vec2 _88 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_86);
    vec3 _102 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _107 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _112 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _117 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _122 = clamp(textureLod(gInColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _127 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _132 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _137 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _142 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _147 = max(-parameters.gJitterPx.x, 0.0);
    float _149 = 1.0 - abs(parameters.gJitterPx.x);
    float _150 = max(parameters.gJitterPx.x, 0.0);
    vec3 _176 = (((((_102 * _147) + (_107 * _149)) + (_112 * _150)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_117 * _147) + (_122 * _149)) + (_127 * _150)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_132 * _147) + (_137 * _149)) + (_142 * _150)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _177 = floatBitsToInt(_117);
    ivec3 _178 = floatBitsToInt(_127);
    ivec3 _180 = floatBitsToInt(_122);
    ivec3 _183 = floatBitsToInt(intBitsToFloat(min(min(_177, _178), _180)));
    ivec3 _184 = floatBitsToInt(_107);
    ivec3 _186 = floatBitsToInt(_137);
    ivec3 _192 = floatBitsToInt(intBitsToFloat(max(max(_177, _178), _180)));
    ivec3 _196 = floatBitsToInt(_102);
    ivec3 _197 = floatBitsToInt(_112);
    ivec3 _201 = floatBitsToInt(_132);
    ivec3 _202 = floatBitsToInt(_142);
    vec3 _226 = ((intBitsToFloat(max(max(_192, _184), _186)) + intBitsToFloat(max(max(_192, floatBitsToInt(intBitsToFloat(max(max(_196, _197), _184)))), floatBitsToInt(intBitsToFloat(max(max(_201, _202), _186)))))) * 0.5) * 0.5;
    vec3 _227 = ((intBitsToFloat(min(min(_183, _184), _186)) + intBitsToFloat(min(min(_183, floatBitsToInt(intBitsToFloat(min(min(_196, _197), _184)))), floatBitsToInt(intBitsToFloat(min(min(_201, _202), _186)))))) * 0.5) * 0.5;
    vec3 _228 = _226 + _227;
    vec3 _230 = max(_226 - _227, vec3(1.5258789240815695542607954848791e-12));
    vec3 _231 = clamp(textureLod(gHistoryColour, _88, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _228;
    vec3 _234 = _230 / max(abs(_231), _230);
    vec3 _256 = min((_176 + (((_228 + (_231 * min(_234.x, min(_234.y, _234.z)))) - _176) * (all(lessThanEqual(abs(_88 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _272 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _275 = _86 * 0.083333335816860198974609375;
    vec4 _277 = textureLod(gInColourFiltered, _272, 0.0);
    float _278 = _277.x;
    float _281 = _277.y;
    float _284 = _277.z;
    vec2 _290 = _275 * 1.0;
    vec4 _292 = textureLod(gInColourFiltered, _272 + _290, 0.0);
    float _293 = _292.x;
    float _296 = _292.y;
    float _299 = _292.z;
    vec4 _307 = textureLod(gInColourFiltered, _272 - _290, 0.0);
    float _308 = _307.x;
    float _311 = _307.y;
    float _314 = _307.z;
    vec2 _321 = _275 * 2.0;
    vec4 _323 = textureLod(gInColourFiltered, _272 + _321, 0.0);
    float _324 = _323.x;
    float _327 = _323.y;
    float _330 = _323.z;
    vec4 _338 = textureLod(gInColourFiltered, _272 - _321, 0.0);
    float _339 = _338.x;
    float _342 = _338.y;
    float _345 = _338.z;
    vec2 _352 = _275 * 3.0;
    vec4 _354 = textureLod(gInColourFiltered, _272 + _352, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec4 _369 = textureLod(gInColourFiltered, _272 - _352, 0.0);
    float _370 = _369.x;
    float _373 = _369.y;
    float _376 = _369.z;
    vec3 _381 = (((((min(vec3((_278 > 0.0) ? _278 : 0.0, (_281 > 0.0) ? _281 : 0.0, (_284 > 0.0) ? _284 : 0.0), vec3(65504.0)) + min(vec3((_293 > 0.0) ? _293 : 0.0, (_296 > 0.0) ? _296 : 0.0, (_299 > 0.0) ? _299 : 0.0), vec3(65504.0))) + min(vec3((_308 > 0.0) ? _308 : 0.0, (_311 > 0.0) ? _311 : 0.0, (_314 > 0.0) ? _314 : 0.0), vec3(65504.0))) + min(vec3((_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0, (_330 > 0.0) ? _330 : 0.0), vec3(65504.0))) + min(vec3((_339 > 0.0) ? _339 : 0.0, (_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0), vec3(65504.0))) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_370 > 0.0) ? _370 : 0.0, (_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0), vec3(65504.0));
    vec3 _385 = mix(min(_381 * vec3(0.14285714924335479736328125), vec3(65504.0)), _256, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_86 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_256, 1.0);
    gOutColour = vec4(_385, 1.0);
}

