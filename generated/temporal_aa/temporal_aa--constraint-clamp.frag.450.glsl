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

layout(binding = 2) uniform sampler2D gInDepth;
layout(binding = 3) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryColour;
layout(binding = 1) uniform sampler2D gInColour;
layout(binding = 5) uniform sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _82 = parameters.gOutputSize.zw * 0.5;
    vec4 _86 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_82));
    float _88 = _82.x;
    float _89 = _82.y;
    vec4 _93 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_88, -_89)));
    vec4 _98 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_88, _89)));
    vec4 _101 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _82));
    float _102 = _86.w;
    float _103 = _86.z;
    float _104 = _86.x;
    float _105 = _86.y;
    float _106 = _93.z;
    float _107 = _93.y;
    float _108 = _98.x;
    float _109 = _98.y;
    float _110 = _101.y;
    vec2 _115 = mix(vec2(_104, -1.0), vec2(_107, 1.0), bvec2(_107 < _104));
    vec2 _120 = mix(vec2(_105, 0.0), _115, bvec2(_115.x < _105));
    vec2 _125 = mix(vec2(_102, -1.0), vec2(_106, 1.0), bvec2(_106 < _102));
    vec2 _130 = mix(vec2(_103, 0.0), _125, bvec2(_125.x < _103));
    vec2 _135 = mix(vec2(_108, -1.0), vec2(_110, 1.0), bvec2(_110 < _108));
    vec2 _140 = mix(vec2(_109, 0.0), _135, bvec2(_135.x < _109));
    bool _143 = _140.x < _130.x;
    vec2 _145 = mix(_130, _140, bvec2(_143));
    vec2 _165 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_120.y, 0.0), vec2(_145.y, _143 ? 1.0 : (-1.0)), bvec2(_145.x < _120.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _167 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_165);
    vec3 _181 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _186 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _191 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _196 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _201 = clamp(textureLod(gInColour, _79, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _206 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _211 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _216 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _221 = clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _226 = max(-parameters.gJitterPx.x, 0.0);
    float _228 = 1.0 - abs(parameters.gJitterPx.x);
    float _229 = max(parameters.gJitterPx.x, 0.0);
    vec3 _255 = (((((_181 * _226) + (_186 * _228)) + (_191 * _229)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_196 * _226) + (_201 * _228)) + (_206 * _229)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_211 * _226) + (_216 * _228)) + (_221 * _229)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _256 = floatBitsToInt(_196);
    ivec3 _257 = floatBitsToInt(_206);
    ivec3 _259 = floatBitsToInt(_201);
    ivec3 _262 = floatBitsToInt(intBitsToFloat(min(min(_256, _257), _259)));
    ivec3 _263 = floatBitsToInt(_186);
    ivec3 _265 = floatBitsToInt(_216);
    ivec3 _271 = floatBitsToInt(intBitsToFloat(max(max(_256, _257), _259)));
    ivec3 _275 = floatBitsToInt(_181);
    ivec3 _276 = floatBitsToInt(_191);
    ivec3 _280 = floatBitsToInt(_211);
    ivec3 _281 = floatBitsToInt(_221);
    vec3 _320 = min((_255 + ((clamp(clamp(textureLod(gHistoryColour, _167, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)), (intBitsToFloat(min(min(_262, _263), _265)) + intBitsToFloat(min(min(_262, floatBitsToInt(intBitsToFloat(min(min(_275, _276), _263)))), floatBitsToInt(intBitsToFloat(min(min(_280, _281), _265)))))) * 0.5, (intBitsToFloat(max(max(_271, _263), _265)) + intBitsToFloat(max(max(_271, floatBitsToInt(intBitsToFloat(max(max(_275, _276), _263)))), floatBitsToInt(intBitsToFloat(max(max(_280, _281), _265)))))) * 0.5) - _255) * (all(lessThanEqual(abs(_167 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _336 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _339 = _165 * 0.083333335816860198974609375;
    vec4 _341 = textureLod(gInColourFiltered, _336, 0.0);
    float _342 = _341.x;
    float _345 = _341.y;
    float _348 = _341.z;
    vec2 _354 = _339 * 1.0;
    vec4 _356 = textureLod(gInColourFiltered, _336 + _354, 0.0);
    float _357 = _356.x;
    float _360 = _356.y;
    float _363 = _356.z;
    vec4 _371 = textureLod(gInColourFiltered, _336 - _354, 0.0);
    float _372 = _371.x;
    float _375 = _371.y;
    float _378 = _371.z;
    vec2 _385 = _339 * 2.0;
    vec4 _387 = textureLod(gInColourFiltered, _336 + _385, 0.0);
    float _388 = _387.x;
    float _391 = _387.y;
    float _394 = _387.z;
    vec4 _402 = textureLod(gInColourFiltered, _336 - _385, 0.0);
    float _403 = _402.x;
    float _406 = _402.y;
    float _409 = _402.z;
    vec2 _416 = _339 * 3.0;
    vec4 _418 = textureLod(gInColourFiltered, _336 + _416, 0.0);
    float _419 = _418.x;
    float _422 = _418.y;
    float _425 = _418.z;
    vec4 _433 = textureLod(gInColourFiltered, _336 - _416, 0.0);
    float _434 = _433.x;
    float _437 = _433.y;
    float _440 = _433.z;
    vec3 _445 = (((((min(vec3((_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0), vec3(65504.0)) + min(vec3((_357 > 0.0) ? _357 : 0.0, (_360 > 0.0) ? _360 : 0.0, (_363 > 0.0) ? _363 : 0.0), vec3(65504.0))) + min(vec3((_372 > 0.0) ? _372 : 0.0, (_375 > 0.0) ? _375 : 0.0, (_378 > 0.0) ? _378 : 0.0), vec3(65504.0))) + min(vec3((_388 > 0.0) ? _388 : 0.0, (_391 > 0.0) ? _391 : 0.0, (_394 > 0.0) ? _394 : 0.0), vec3(65504.0))) + min(vec3((_403 > 0.0) ? _403 : 0.0, (_406 > 0.0) ? _406 : 0.0, (_409 > 0.0) ? _409 : 0.0), vec3(65504.0))) + min(vec3((_419 > 0.0) ? _419 : 0.0, (_422 > 0.0) ? _422 : 0.0, (_425 > 0.0) ? _425 : 0.0), vec3(65504.0))) + min(vec3((_434 > 0.0) ? _434 : 0.0, (_437 > 0.0) ? _437 : 0.0, (_440 > 0.0) ? _440 : 0.0), vec3(65504.0));
    vec3 _449 = mix(min(_445 * vec3(0.14285714924335479736328125), vec3(65504.0)), _320, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_165 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_320, 1.0);
    gOutColour = vec4(_449, 1.0);
}

