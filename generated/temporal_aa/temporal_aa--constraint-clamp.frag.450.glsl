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
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _81 = parameters.gOutputSize.zw * 0.5;
    vec4 _85 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_81));
    float _87 = _81.x;
    float _88 = _81.y;
    vec4 _92 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_87, -_88)));
    vec4 _97 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_87, _88)));
    vec4 _100 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _81));
    float _101 = _85.w;
    float _102 = _85.z;
    float _103 = _85.x;
    float _104 = _85.y;
    float _105 = _92.z;
    float _106 = _92.y;
    float _107 = _97.x;
    float _108 = _97.y;
    float _109 = _100.y;
    vec2 _114 = mix(vec2(_103, -1.0), vec2(_106, 1.0), bvec2(_106 < _103));
    vec2 _119 = mix(vec2(_104, 0.0), _114, bvec2(_114.x < _104));
    vec2 _124 = mix(vec2(_101, -1.0), vec2(_105, 1.0), bvec2(_105 < _101));
    vec2 _129 = mix(vec2(_102, 0.0), _124, bvec2(_124.x < _102));
    vec2 _134 = mix(vec2(_107, -1.0), vec2(_109, 1.0), bvec2(_109 < _107));
    vec2 _139 = mix(vec2(_108, 0.0), _134, bvec2(_134.x < _108));
    bool _142 = _139.x < _129.x;
    vec2 _144 = mix(_129, _139, bvec2(_142));
    vec2 _164 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_119.y, 0.0), vec2(_144.y, _142 ? 1.0 : (-1.0)), bvec2(_144.x < _119.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _166 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_164);
    vec3 _180 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _185 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _190 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _195 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _200 = clamp(textureLod(gInColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _205 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _210 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _215 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _220 = clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _225 = max(-parameters.gJitterPx.x, 0.0);
    float _227 = 1.0 - abs(parameters.gJitterPx.x);
    float _228 = max(parameters.gJitterPx.x, 0.0);
    vec3 _254 = (((((_180 * _225) + (_185 * _227)) + (_190 * _228)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_195 * _225) + (_200 * _227)) + (_205 * _228)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_210 * _225) + (_215 * _227)) + (_220 * _228)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _255 = floatBitsToInt(_195);
    ivec3 _256 = floatBitsToInt(_205);
    ivec3 _258 = floatBitsToInt(_200);
    ivec3 _261 = floatBitsToInt(intBitsToFloat(min(min(_255, _256), _258)));
    ivec3 _262 = floatBitsToInt(_185);
    ivec3 _264 = floatBitsToInt(_215);
    ivec3 _270 = floatBitsToInt(intBitsToFloat(max(max(_255, _256), _258)));
    ivec3 _274 = floatBitsToInt(_180);
    ivec3 _275 = floatBitsToInt(_190);
    ivec3 _279 = floatBitsToInt(_210);
    ivec3 _280 = floatBitsToInt(_220);
    vec3 _319 = min((_254 + ((clamp(clamp(textureLod(gHistoryColour, _166, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)), (intBitsToFloat(min(min(_261, _262), _264)) + intBitsToFloat(min(min(_261, floatBitsToInt(intBitsToFloat(min(min(_274, _275), _262)))), floatBitsToInt(intBitsToFloat(min(min(_279, _280), _264)))))) * 0.5, (intBitsToFloat(max(max(_270, _262), _264)) + intBitsToFloat(max(max(_270, floatBitsToInt(intBitsToFloat(max(max(_274, _275), _262)))), floatBitsToInt(intBitsToFloat(max(max(_279, _280), _264)))))) * 0.5) - _254) * (all(lessThanEqual(abs(_166 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _334 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _337 = _164 * 0.083333335816860198974609375;
    vec4 _339 = textureLod(gInColourFiltered, _334, 0.0);
    float _340 = _339.x;
    float _343 = _339.y;
    float _346 = _339.z;
    vec2 _352 = _337 * 1.0;
    vec4 _354 = textureLod(gInColourFiltered, _334 + _352, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec4 _369 = textureLod(gInColourFiltered, _334 - _352, 0.0);
    float _370 = _369.x;
    float _373 = _369.y;
    float _376 = _369.z;
    vec2 _383 = _337 * 2.0;
    vec4 _385 = textureLod(gInColourFiltered, _334 + _383, 0.0);
    float _386 = _385.x;
    float _389 = _385.y;
    float _392 = _385.z;
    vec4 _400 = textureLod(gInColourFiltered, _334 - _383, 0.0);
    float _401 = _400.x;
    float _404 = _400.y;
    float _407 = _400.z;
    vec2 _414 = _337 * 3.0;
    vec4 _416 = textureLod(gInColourFiltered, _334 + _414, 0.0);
    float _417 = _416.x;
    float _420 = _416.y;
    float _423 = _416.z;
    vec4 _431 = textureLod(gInColourFiltered, _334 - _414, 0.0);
    float _432 = _431.x;
    float _435 = _431.y;
    float _438 = _431.z;
    vec3 _443 = (((((min(vec3((_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0), vec3(65504.0)) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_370 > 0.0) ? _370 : 0.0, (_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0), vec3(65504.0))) + min(vec3((_386 > 0.0) ? _386 : 0.0, (_389 > 0.0) ? _389 : 0.0, (_392 > 0.0) ? _392 : 0.0), vec3(65504.0))) + min(vec3((_401 > 0.0) ? _401 : 0.0, (_404 > 0.0) ? _404 : 0.0, (_407 > 0.0) ? _407 : 0.0), vec3(65504.0))) + min(vec3((_417 > 0.0) ? _417 : 0.0, (_420 > 0.0) ? _420 : 0.0, (_423 > 0.0) ? _423 : 0.0), vec3(65504.0))) + min(vec3((_432 > 0.0) ? _432 : 0.0, (_435 > 0.0) ? _435 : 0.0, (_438 > 0.0) ? _438 : 0.0), vec3(65504.0));
    vec3 _447 = mix(min(_443 * vec3(0.14285714924335479736328125), vec3(65504.0)), _319, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_164 * parameters.gOutputSize.xy)) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_319, 1.0);
    gOutColour = vec4(_447, 1.0);
}

