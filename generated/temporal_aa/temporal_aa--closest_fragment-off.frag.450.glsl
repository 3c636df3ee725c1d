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

layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _90 = textureLod(gInVelocity, _82, 0.0).xy * parameters.gMotionToUv;
    vec2 _92 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_90);
    vec3 _106 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _111 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _116 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _121 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _126 = clamp(textureLod(gInColour, _82, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _131 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _136 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _141 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _146 = clamp(textureLodOffset(gInColour, _82, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    float _151 = max(-parameters.gJitterPx.x, 0.0);
    float _153 = 1.0 - abs(parameters.gJitterPx.x);
    float _154 = max(parameters.gJitterPx.x, 0.0);
    vec3 _180 = (((((_106 * _151) + (_111 * _153)) + (_116 * _154)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_121 * _151) + (_126 * _153)) + (_131 * _154)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_136 * _151) + (_141 * _153)) + (_146 * _154)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _181 = floatBitsToInt(_121);
    ivec3 _182 = floatBitsToInt(_131);
    ivec3 _184 = floatBitsToInt(_126);
    ivec3 _187 = floatBitsToInt(intBitsToFloat(min(min(_181, _182), _184)));
    ivec3 _188 = floatBitsToInt(_111);
    ivec3 _190 = floatBitsToInt(_141);
    ivec3 _196 = floatBitsToInt(intBitsToFloat(max(max(_181, _182), _184)));
    ivec3 _200 = floatBitsToInt(_106);
    ivec3 _201 = floatBitsToInt(_116);
    ivec3 _205 = floatBitsToInt(_136);
    ivec3 _206 = floatBitsToInt(_146);
    vec3 _226 = intBitsToFloat(min(min(_187, _188), _190)) + intBitsToFloat(min(min(_187, floatBitsToInt(intBitsToFloat(min(min(_200, _201), _188)))), floatBitsToInt(intBitsToFloat(min(min(_205, _206), _190)))));
    vec3 _227 = intBitsToFloat(max(max(_196, _188), _190)) + intBitsToFloat(max(max(_196, floatBitsToInt(intBitsToFloat(max(max(_200, _201), _188)))), floatBitsToInt(intBitsToFloat(max(max(_205, _206), _190)))));
    vec3 _228 = _227 + _226;
    vec3 _232 = (clamp(textureLod(gHistoryColour, _92, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _228;
    vec3 _235 = clamp(max(_227 - _226, vec3(6.1064972523006133542367024347186e-12)) / abs(_232), vec3(0.0), vec3(1.0));
    vec3 _256 = (_180 + ((((_228 + (_232 * min(_235.x, min(_235.y, _235.z)))) * 0.25) - _180) * (all(lessThanEqual(floatBitsToUint(_92), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _272 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _275 = _90 * 0.083333335816860198974609375;
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
    vec3 _385 = mix(min(_381 * vec3(0.14285714924335479736328125), vec3(65504.0)), _256, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_90 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_256, 1.0);
    gOutColour = vec4(_385, 1.0);
}

