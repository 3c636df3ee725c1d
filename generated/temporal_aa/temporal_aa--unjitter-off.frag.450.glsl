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
    vec2 _85 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _88 = parameters.gOutputSize.zw * 0.5;
    vec4 _92 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_88));
    float _94 = _88.x;
    float _95 = _88.y;
    vec4 _99 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_94, -_95)));
    vec4 _104 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_94, _95)));
    vec4 _107 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _88));
    float _108 = _92.w;
    float _109 = _92.z;
    float _110 = _92.x;
    float _111 = _92.y;
    float _112 = _99.z;
    float _113 = _99.y;
    float _114 = _104.x;
    float _115 = _104.y;
    float _116 = _107.y;
    float _120 = -parameters.gOutputSize.z;
    vec2 _123 = mix(vec2(_110, _120), vec2(_113, parameters.gOutputSize.z), bvec2(_113 < _110));
    vec2 _128 = mix(vec2(_111, 0.0), _123, bvec2(_123.x < _111));
    vec2 _133 = mix(vec2(_108, _120), vec2(_112, parameters.gOutputSize.z), bvec2(_112 < _108));
    vec2 _138 = mix(vec2(_109, 0.0), _133, bvec2(_133.x < _109));
    vec2 _143 = mix(vec2(_114, _120), vec2(_116, parameters.gOutputSize.z), bvec2(_116 < _114));
    vec2 _148 = mix(vec2(_115, 0.0), _143, bvec2(_143.x < _115));
    bool _151 = _148.x < _138.x;
    vec2 _153 = mix(_138, _148, bvec2(_151));
    vec2 _174 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_128.y, 0.0), vec2(_153.y, _151 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w)), bvec2(_153.x < _128.x))), 0.0).xy * parameters.gMotionToUv;
    vec2 _176 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_174);
    vec3 _210 = clamp(textureLod(gInColour, _85, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    ivec3 _231 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _232 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _234 = floatBitsToInt(_210);
    ivec3 _237 = floatBitsToInt(intBitsToFloat(min(min(_231, _232), _234)));
    ivec3 _238 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _240 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _246 = floatBitsToInt(intBitsToFloat(max(max(_231, _232), _234)));
    ivec3 _250 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _251 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _255 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    ivec3 _256 = floatBitsToInt(clamp(textureLodOffset(gInColour, _85, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)));
    vec3 _276 = intBitsToFloat(min(min(_237, _238), _240)) + intBitsToFloat(min(min(_237, floatBitsToInt(intBitsToFloat(min(min(_250, _251), _238)))), floatBitsToInt(intBitsToFloat(min(min(_255, _256), _240)))));
    vec3 _277 = intBitsToFloat(max(max(_246, _238), _240)) + intBitsToFloat(max(max(_246, floatBitsToInt(intBitsToFloat(max(max(_250, _251), _238)))), floatBitsToInt(intBitsToFloat(max(max(_255, _256), _240)))));
    vec3 _278 = _277 + _276;
    vec3 _282 = (clamp(textureLod(gHistoryColour, _176, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)) * 4.0) - _278;
    vec3 _285 = clamp(max(_277 - _276, vec3(6.1064972523006133542367024347186e-12)) / abs(_282), vec3(0.0), vec3(1.0));
    vec3 _306 = (_210 + ((((_278 + (_282 * min(_285.x, min(_285.y, _285.z)))) * 0.25) - _210) * (all(lessThanEqual(floatBitsToUint(_176), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _324 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _327 = _174 * 0.083333335816860198974609375;
    vec4 _329 = textureLod(gInColourFiltered, _324, 0.0);
    float _330 = _329.x;
    float _333 = _329.y;
    float _336 = _329.z;
    vec2 _342 = _327 * 1.0;
    vec4 _344 = textureLod(gInColourFiltered, _324 + _342, 0.0);
    float _345 = _344.x;
    float _348 = _344.y;
    float _351 = _344.z;
    vec4 _359 = textureLod(gInColourFiltered, _324 - _342, 0.0);
    float _360 = _359.x;
    float _363 = _359.y;
    float _366 = _359.z;
    vec2 _373 = _327 * 2.0;
    vec4 _375 = textureLod(gInColourFiltered, _324 + _373, 0.0);
    float _376 = _375.x;
    float _379 = _375.y;
    float _382 = _375.z;
    vec4 _390 = textureLod(gInColourFiltered, _324 - _373, 0.0);
    float _391 = _390.x;
    float _394 = _390.y;
    float _397 = _390.z;
    vec2 _404 = _327 * 3.0;
    vec4 _406 = textureLod(gInColourFiltered, _324 + _404, 0.0);
    float _407 = _406.x;
    float _410 = _406.y;
    float _413 = _406.z;
    vec4 _421 = textureLod(gInColourFiltered, _324 - _404, 0.0);
    float _422 = _421.x;
    float _425 = _421.y;
    float _428 = _421.z;
    vec3 _433 = (((((min(vec3((_330 > 0.0) ? _330 : 0.0, (_333 > 0.0) ? _333 : 0.0, (_336 > 0.0) ? _336 : 0.0), vec3(65504.0)) + min(vec3((_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0, (_351 > 0.0) ? _351 : 0.0), vec3(65504.0))) + min(vec3((_360 > 0.0) ? _360 : 0.0, (_363 > 0.0) ? _363 : 0.0, (_366 > 0.0) ? _366 : 0.0), vec3(65504.0))) + min(vec3((_376 > 0.0) ? _376 : 0.0, (_379 > 0.0) ? _379 : 0.0, (_382 > 0.0) ? _382 : 0.0), vec3(65504.0))) + min(vec3((_391 > 0.0) ? _391 : 0.0, (_394 > 0.0) ? _394 : 0.0, (_397 > 0.0) ? _397 : 0.0), vec3(65504.0))) + min(vec3((_407 > 0.0) ? _407 : 0.0, (_410 > 0.0) ? _410 : 0.0, (_413 > 0.0) ? _413 : 0.0), vec3(65504.0))) + min(vec3((_422 > 0.0) ? _422 : 0.0, (_425 > 0.0) ? _425 : 0.0, (_428 > 0.0) ? _428 : 0.0), vec3(65504.0));
    vec3 _437 = mix(min(_433 * vec3(0.14285714924335479736328125), vec3(65504.0)), _306, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_174 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_306, 1.0);
    gOutColour = vec4(_437, 1.0);
}

