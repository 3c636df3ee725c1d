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
    vec2 _117 = mix(vec2(_106, -1.0), vec2(_109, 1.0), bvec2(_109 < _106));
    vec2 _122 = mix(vec2(_107, 0.0), _117, bvec2(_117.x < _107));
    vec2 _127 = mix(vec2(_104, -1.0), vec2(_108, 1.0), bvec2(_108 < _104));
    vec2 _132 = mix(vec2(_105, 0.0), _127, bvec2(_127.x < _105));
    vec2 _137 = mix(vec2(_110, -1.0), vec2(_112, 1.0), bvec2(_112 < _110));
    vec2 _142 = mix(vec2(_111, 0.0), _137, bvec2(_137.x < _111));
    bool _145 = _142.x < _132.x;
    vec2 _147 = mix(_132, _142, bvec2(_145));
    vec2 _167 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_122.y, 0.0), vec2(_147.y, _145 ? 1.0 : (-1.0)), bvec2(_147.x < _122.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _169 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_167);
    vec3 _203 = clamp(textureLod(gInColour, _81, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    ivec3 _224 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _225 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _227 = floatBitsToInt(_203);
    ivec3 _230 = floatBitsToInt(intBitsToFloat(min(min(_224, _225), _227)));
    ivec3 _231 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _233 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _239 = floatBitsToInt(intBitsToFloat(max(max(_224, _225), _227)));
    ivec3 _243 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _244 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _248 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _249 = floatBitsToInt(clamp(textureLodOffset(gInColour, _81, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _273 = ((intBitsToFloat(max(max(_239, _231), _233)) + intBitsToFloat(max(max(_239, floatBitsToInt(intBitsToFloat(max(max(_243, _244), _231)))), floatBitsToInt(intBitsToFloat(max(max(_248, _249), _233)))))) * 0.5) * 0.5;
    vec3 _274 = ((intBitsToFloat(min(min(_230, _231), _233)) + intBitsToFloat(min(min(_230, floatBitsToInt(intBitsToFloat(min(min(_243, _244), _231)))), floatBitsToInt(intBitsToFloat(min(min(_248, _249), _233)))))) * 0.5) * 0.5;
    vec3 _275 = _273 + _274;
    vec3 _277 = max(_273 - _274, vec3(1.5258789240815695542607954848791e-12));
    vec3 _278 = clamp(textureLod(gHistoryColour, _169, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _275;
    vec3 _281 = _277 / max(abs(_278), _277);
    vec3 _303 = min((_203 + (((_275 + (_278 * min(_281.x, min(_281.y, _281.z)))) - _203) * (all(lessThanEqual(abs(_169 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _321 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _324 = _167 * 0.083333335816860198974609375;
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
    vec3 _434 = mix(min(_430 * vec3(0.14285714924335479736328125), vec3(65504.0)), _303, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_167 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_303, 1.0);
    gOutColour = vec4(_434, 1.0);
}

