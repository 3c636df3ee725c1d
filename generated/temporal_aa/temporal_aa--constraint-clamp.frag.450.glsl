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
    vec2 _81 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _84 = parameters.gOutputSize.zw * 0.5;
    vec4 _88 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_84));
    float _90 = _84.x;
    float _91 = _84.y;
    vec4 _95 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_90, -_91)));
    vec4 _100 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_90, _91)));
    vec4 _103 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _84));
    float _104 = _88.w;
    float _105 = _88.z;
    float _106 = _88.x;
    float _107 = _88.y;
    float _108 = _95.z;
    float _109 = _95.y;
    float _110 = _100.x;
    float _111 = _100.y;
    float _112 = _103.y;
    float _116 = -parameters.gOutputSize.z;
    vec2 _119 = mix(vec2(_106, _116), vec2(_109, parameters.gOutputSize.z), bvec2(_109 < _106));
    vec2 _124 = mix(vec2(_107, 0.0), _119, bvec2(_119.x < _107));
    vec2 _129 = mix(vec2(_104, _116), vec2(_108, parameters.gOutputSize.z), bvec2(_108 < _104));
    vec2 _134 = mix(vec2(_105, 0.0), _129, bvec2(_129.x < _105));
    vec2 _139 = mix(vec2(_110, _116), vec2(_112, parameters.gOutputSize.z), bvec2(_112 < _110));
    vec2 _144 = mix(vec2(_111, 0.0), _139, bvec2(_139.x < _111));
    bool _147 = _144.x < _134.x;
    vec2 _149 = mix(_134, _144, bvec2(_147));
    vec2 _170 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_124.y, 0.0), vec2(_149.y, _147 ? parameters.gOutputSize.w : (-parameters.gOutputSize.w)), bvec2(_149.x < _124.x))), 0.0).xy * parameters.gMotionToUv;
    vec2 _172 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_170);
    vec3 _186 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _191 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _196 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, -1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _201 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _206 = clamp(textureLod(gInColour, _81, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _211 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, 0)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _216 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _221 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, 1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    vec3 _226 = clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1)).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0));
    float _231 = max(-parameters.gJitterPx.x, 0.0);
    float _233 = 1.0 - abs(parameters.gJitterPx.x);
    float _234 = max(parameters.gJitterPx.x, 0.0);
    vec3 _260 = (((((_186 * _231) + (_191 * _233)) + (_196 * _234)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_201 * _231) + (_206 * _233)) + (_211 * _234)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_216 * _231) + (_221 * _233)) + (_226 * _234)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _261 = floatBitsToInt(_201);
    ivec3 _262 = floatBitsToInt(_211);
    ivec3 _264 = floatBitsToInt(_206);
    ivec3 _267 = floatBitsToInt(intBitsToFloat(min(min(_261, _262), _264)));
    ivec3 _268 = floatBitsToInt(_191);
    ivec3 _270 = floatBitsToInt(_221);
    ivec3 _276 = floatBitsToInt(intBitsToFloat(max(max(_261, _262), _264)));
    ivec3 _280 = floatBitsToInt(_186);
    ivec3 _281 = floatBitsToInt(_196);
    ivec3 _285 = floatBitsToInt(_216);
    ivec3 _286 = floatBitsToInt(_226);
    vec3 _323 = (_260 + ((clamp(clamp(textureLod(gHistoryColour, _172, 0.0).xyz * 1.5266245100065134465694427490234e-05, vec3(0.0), vec3(1.0)), (intBitsToFloat(min(min(_267, _268), _270)) + intBitsToFloat(min(min(_267, floatBitsToInt(intBitsToFloat(min(min(_280, _281), _268)))), floatBitsToInt(intBitsToFloat(min(min(_285, _286), _270)))))) * 0.5, (intBitsToFloat(max(max(_276, _268), _270)) + intBitsToFloat(max(max(_276, floatBitsToInt(intBitsToFloat(max(max(_280, _281), _268)))), floatBitsToInt(intBitsToFloat(max(max(_285, _286), _270)))))) * 0.5) - _260) * (all(lessThanEqual(floatBitsToUint(_172), uvec2(1065353216u))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65504.0;
    vec2 _339 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _342 = _170 * 0.083333335816860198974609375;
    vec4 _344 = textureLod(gInColourFiltered, _339, 0.0);
    float _345 = _344.x;
    float _348 = _344.y;
    float _351 = _344.z;
    vec2 _357 = _342 * 1.0;
    vec4 _359 = textureLod(gInColourFiltered, _339 + _357, 0.0);
    float _360 = _359.x;
    float _363 = _359.y;
    float _366 = _359.z;
    vec4 _374 = textureLod(gInColourFiltered, _339 - _357, 0.0);
    float _375 = _374.x;
    float _378 = _374.y;
    float _381 = _374.z;
    vec2 _388 = _342 * 2.0;
    vec4 _390 = textureLod(gInColourFiltered, _339 + _388, 0.0);
    float _391 = _390.x;
    float _394 = _390.y;
    float _397 = _390.z;
    vec4 _405 = textureLod(gInColourFiltered, _339 - _388, 0.0);
    float _406 = _405.x;
    float _409 = _405.y;
    float _412 = _405.z;
    vec2 _419 = _342 * 3.0;
    vec4 _421 = textureLod(gInColourFiltered, _339 + _419, 0.0);
    float _422 = _421.x;
    float _425 = _421.y;
    float _428 = _421.z;
    vec4 _436 = textureLod(gInColourFiltered, _339 - _419, 0.0);
    float _437 = _436.x;
    float _440 = _436.y;
    float _443 = _436.z;
    vec3 _448 = (((((min(vec3((_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0, (_351 > 0.0) ? _351 : 0.0), vec3(65504.0)) + min(vec3((_360 > 0.0) ? _360 : 0.0, (_363 > 0.0) ? _363 : 0.0, (_366 > 0.0) ? _366 : 0.0), vec3(65504.0))) + min(vec3((_375 > 0.0) ? _375 : 0.0, (_378 > 0.0) ? _378 : 0.0, (_381 > 0.0) ? _381 : 0.0), vec3(65504.0))) + min(vec3((_391 > 0.0) ? _391 : 0.0, (_394 > 0.0) ? _394 : 0.0, (_397 > 0.0) ? _397 : 0.0), vec3(65504.0))) + min(vec3((_406 > 0.0) ? _406 : 0.0, (_409 > 0.0) ? _409 : 0.0, (_412 > 0.0) ? _412 : 0.0), vec3(65504.0))) + min(vec3((_422 > 0.0) ? _422 : 0.0, (_425 > 0.0) ? _425 : 0.0, (_428 > 0.0) ? _428 : 0.0), vec3(65504.0))) + min(vec3((_437 > 0.0) ? _437 : 0.0, (_440 > 0.0) ? _440 : 0.0, (_443 > 0.0) ? _443 : 0.0), vec3(65504.0));
    vec3 _452 = mix(min(_448 * vec3(0.14285714924335479736328125), vec3(65504.0)), _323, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_170 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_323, 1.0);
    gOutColour = vec4(_452, 1.0);
}

