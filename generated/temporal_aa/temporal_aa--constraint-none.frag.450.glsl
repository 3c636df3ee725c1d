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

layout(binding = 2) uniform sampler2D gInDepth;
layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _80 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _83 = parameters.gOutputSize.zw * 0.5;
    vec4 _87 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_83));
    float _89 = _83.x;
    float _90 = _83.y;
    vec4 _94 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_89, -_90)));
    vec4 _99 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_89, _90)));
    vec4 _102 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _83));
    float _103 = _87.w;
    float _104 = _87.z;
    float _105 = _87.x;
    float _106 = _87.y;
    float _107 = _94.z;
    float _108 = _94.y;
    float _109 = _99.x;
    float _110 = _99.y;
    float _111 = _102.y;
    float _115 = -parameters.gOutputSize.z;
    vec2 _118 = mix(vec2(_105, _115), vec2(_108, parameters.gOutputSize.z), bvec2(_108 < _105));
    vec2 _123 = mix(vec2(_106, 0.0), _118, bvec2(_118.x < _106));
    vec2 _128 = mix(vec2(_103, _115), vec2(_107, parameters.gOutputSize.z), bvec2(_107 < _103));
    vec2 _133 = mix(vec2(_104, 0.0), _128, bvec2(_128.x < _104));
    vec2 _138 = mix(vec2(_109, _115), vec2(_111, parameters.gOutputSize.z), bvec2(_111 < _109));
    vec2 _143 = mix(vec2(_110, 0.0), _138, bvec2(_138.x < _110));
    bool _146 = _143.x < _133.x;
    vec2 _148 = mix(_133, _143, bvec2(_146));
    vec2 _169 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_123.y, 0.0), vec2(_148.y, _146 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w)), bvec2(_148.x < _123.x))), 0.0).xy * parameters.gMotionToUv;
    vec2 _171 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_169);
    float _230 = max(-parameters.gJitterPx.x, 0.0);
    float _232 = 1.0 - abs(parameters.gJitterPx.x);
    float _233 = max(parameters.gJitterPx.x, 0.0);
    vec3 _259 = (((((clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _230) + (clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _232)) + (clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _233)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _230) + (clamp(textureLod(gInColour, _80, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _232)) + (clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _233)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _230) + (clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _232)) + (clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * _233)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _272 = (_259 + ((clamp(textureLod(gHistoryColour, _171, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) - _259) * (all(lessThanEqual(floatBitsToUint(_171), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _288 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _291 = _169 * 0.083333335816860198974609375;
    vec4 _293 = textureLod(gInColourFiltered, _288, 0.0);
    float _294 = _293.x;
    float _297 = _293.y;
    float _300 = _293.z;
    vec2 _306 = _291 * 1.0;
    vec4 _308 = textureLod(gInColourFiltered, _288 + _306, 0.0);
    float _309 = _308.x;
    float _312 = _308.y;
    float _315 = _308.z;
    vec4 _323 = textureLod(gInColourFiltered, _288 - _306, 0.0);
    float _324 = _323.x;
    float _327 = _323.y;
    float _330 = _323.z;
    vec2 _337 = _291 * 2.0;
    vec4 _339 = textureLod(gInColourFiltered, _288 + _337, 0.0);
    float _340 = _339.x;
    float _343 = _339.y;
    float _346 = _339.z;
    vec4 _354 = textureLod(gInColourFiltered, _288 - _337, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec2 _368 = _291 * 3.0;
    vec4 _370 = textureLod(gInColourFiltered, _288 + _368, 0.0);
    float _371 = _370.x;
    float _374 = _370.y;
    float _377 = _370.z;
    vec4 _385 = textureLod(gInColourFiltered, _288 - _368, 0.0);
    float _386 = _385.x;
    float _389 = _385.y;
    float _392 = _385.z;
    vec3 _397 = (((((min(vec3((_294 > 0.0) ? _294 : 0.0, (_297 > 0.0) ? _297 : 0.0, (_300 > 0.0) ? _300 : 0.0), vec3(65504.0)) + min(vec3((_309 > 0.0) ? _309 : 0.0, (_312 > 0.0) ? _312 : 0.0, (_315 > 0.0) ? _315 : 0.0), vec3(65504.0))) + min(vec3((_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0, (_330 > 0.0) ? _330 : 0.0), vec3(65504.0))) + min(vec3((_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0), vec3(65504.0))) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0, (_377 > 0.0) ? _377 : 0.0), vec3(65504.0))) + min(vec3((_386 > 0.0) ? _386 : 0.0, (_389 > 0.0) ? _389 : 0.0, (_392 > 0.0) ? _392 : 0.0), vec3(65504.0));
    vec3 _401 = mix(min(_397 * vec3(0.14285714924335479736328125), vec3(65504.0)), _272, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_169 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_272, 1.0);
    gOutColour = vec4(_401, 1.0);
}

