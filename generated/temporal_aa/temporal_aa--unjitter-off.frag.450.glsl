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
    vec2 _83 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _86 = parameters.gOutputSize.zw * 0.5;
    vec4 _90 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_86));
    float _92 = _86.x;
    float _93 = _86.y;
    vec4 _97 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_92, -_93)));
    vec4 _102 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_92, _93)));
    vec4 _105 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _86));
    float _106 = _90.w;
    float _107 = _90.z;
    float _108 = _90.x;
    float _109 = _90.y;
    float _110 = _97.z;
    float _111 = _97.y;
    float _112 = _102.x;
    float _113 = _102.y;
    float _114 = _105.y;
    vec2 _119 = mix(vec2(_108, -1.0), vec2(_111, 1.0), bvec2(_111 < _108));
    vec2 _124 = mix(vec2(_109, 0.0), _119, bvec2(_119.x < _109));
    vec2 _129 = mix(vec2(_106, -1.0), vec2(_110, 1.0), bvec2(_110 < _106));
    vec2 _134 = mix(vec2(_107, 0.0), _129, bvec2(_129.x < _107));
    vec2 _139 = mix(vec2(_112, -1.0), vec2(_114, 1.0), bvec2(_114 < _112));
    vec2 _144 = mix(vec2(_113, 0.0), _139, bvec2(_139.x < _113));
    bool _147 = _144.x < _134.x;
    vec2 _149 = mix(_134, _144, bvec2(_147));
    vec2 _169 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_124.y, 0.0), vec2(_149.y, _147 ? 1.0 : (-1.0)), bvec2(_149.x < _124.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _171 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_169);
    vec3 _205 = clamp(textureLod(gInColour, _83, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    ivec3 _226 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _227 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _229 = floatBitsToInt(_205);
    ivec3 _232 = floatBitsToInt(intBitsToFloat(min(min(_226, _227), _229)));
    ivec3 _233 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _235 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _241 = floatBitsToInt(intBitsToFloat(max(max(_226, _227), _229)));
    ivec3 _245 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _246 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _250 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _251 = floatBitsToInt(clamp(textureLodOffset(gInColour, _83, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _271 = intBitsToFloat(min(min(_232, _233), _235)) + intBitsToFloat(min(min(_232, floatBitsToInt(intBitsToFloat(min(min(_245, _246), _233)))), floatBitsToInt(intBitsToFloat(min(min(_250, _251), _235)))));
    vec3 _272 = intBitsToFloat(max(max(_241, _233), _235)) + intBitsToFloat(max(max(_241, floatBitsToInt(intBitsToFloat(max(max(_245, _246), _233)))), floatBitsToInt(intBitsToFloat(max(max(_250, _251), _235)))));
    vec3 _273 = _272 + _271;
    vec3 _275 = max(_272 - _271, vec3(6.1035156963262782170431819395162e-12));
    vec3 _277 = (clamp(textureLod(gHistoryColour, _171, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _273;
    vec3 _280 = _275 / max(abs(_277), _275);
    vec3 _303 = min((_205 + ((((_273 + (_277 * min(_280.x, min(_280.y, _280.z)))) * 0.25) - _205) * (all(lessThanEqual(abs(_171 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _321 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _324 = _169 * 0.083333335816860198974609375;
    vec4 _326 = textureLod(gInColourFiltered, _321, 0.0);
    float _327 = _326.x;
    float _330 = _326.y;
    float _333 = _326.z;
    vec2 _339 = _324 * 1.0;
    vec4 _341 = textureLod(gInColourFiltered, _321 + _339, 0.0);
    float _342 = _341.x;
    float _345 = _341.y;
    float _348 = _341.z;
    vec4 _356 = textureLod(gInColourFiltered, _321 - _339, 0.0);
    float _357 = _356.x;
    float _360 = _356.y;
    float _363 = _356.z;
    vec2 _370 = _324 * 2.0;
    vec4 _372 = textureLod(gInColourFiltered, _321 + _370, 0.0);
    float _373 = _372.x;
    float _376 = _372.y;
    float _379 = _372.z;
    vec4 _387 = textureLod(gInColourFiltered, _321 - _370, 0.0);
    float _388 = _387.x;
    float _391 = _387.y;
    float _394 = _387.z;
    vec2 _401 = _324 * 3.0;
    vec4 _403 = textureLod(gInColourFiltered, _321 + _401, 0.0);
    float _404 = _403.x;
    float _407 = _403.y;
    float _410 = _403.z;
    vec4 _418 = textureLod(gInColourFiltered, _321 - _401, 0.0);
    float _419 = _418.x;
    float _422 = _418.y;
    float _425 = _418.z;
    vec3 _430 = (((((min(vec3((_327 > 0.0) ? _327 : 0.0, (_330 > 0.0) ? _330 : 0.0, (_333 > 0.0) ? _333 : 0.0), vec3(65504.0)) + min(vec3((_342 > 0.0) ? _342 : 0.0, (_345 > 0.0) ? _345 : 0.0, (_348 > 0.0) ? _348 : 0.0), vec3(65504.0))) + min(vec3((_357 > 0.0) ? _357 : 0.0, (_360 > 0.0) ? _360 : 0.0, (_363 > 0.0) ? _363 : 0.0), vec3(65504.0))) + min(vec3((_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0, (_379 > 0.0) ? _379 : 0.0), vec3(65504.0))) + min(vec3((_388 > 0.0) ? _388 : 0.0, (_391 > 0.0) ? _391 : 0.0, (_394 > 0.0) ? _394 : 0.0), vec3(65504.0))) + min(vec3((_404 > 0.0) ? _404 : 0.0, (_407 > 0.0) ? _407 : 0.0, (_410 > 0.0) ? _410 : 0.0), vec3(65504.0))) + min(vec3((_419 > 0.0) ? _419 : 0.0, (_422 > 0.0) ? _422 : 0.0, (_425 > 0.0) ? _425 : 0.0), vec3(65504.0));
    vec3 _434 = mix(min(_430 * vec3(0.14285714924335479736328125), vec3(65504.0)), _303, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_169 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_303, 1.0);
    gOutColour = vec4(_434, 1.0);
}

