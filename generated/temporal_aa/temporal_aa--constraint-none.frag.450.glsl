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
    float _225 = max(-parameters.gJitterPx.x, 0.0);
    float _227 = 1.0 - abs(parameters.gJitterPx.x);
    float _228 = max(parameters.gJitterPx.x, 0.0);
    vec3 _254 = (((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225) + (clamp(textureLod(gInColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _269 = min((_254 + ((clamp(textureLod(gHistoryColour, _166, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _254) * (all(lessThanEqual(abs(_166 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _285 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _288 = _164 * 0.083333335816860198974609375;
    vec4 _290 = textureLod(gInColourFiltered, _285, 0.0);
    float _291 = _290.x;
    float _294 = _290.y;
    float _297 = _290.z;
    vec2 _303 = _288 * 1.0;
    vec4 _305 = textureLod(gInColourFiltered, _285 + _303, 0.0);
    float _306 = _305.x;
    float _309 = _305.y;
    float _312 = _305.z;
    vec4 _320 = textureLod(gInColourFiltered, _285 - _303, 0.0);
    float _321 = _320.x;
    float _324 = _320.y;
    float _327 = _320.z;
    vec2 _334 = _288 * 2.0;
    vec4 _336 = textureLod(gInColourFiltered, _285 + _334, 0.0);
    float _337 = _336.x;
    float _340 = _336.y;
    float _343 = _336.z;
    vec4 _351 = textureLod(gInColourFiltered, _285 - _334, 0.0);
    float _352 = _351.x;
    float _355 = _351.y;
    float _358 = _351.z;
    vec2 _365 = _288 * 3.0;
    vec4 _367 = textureLod(gInColourFiltered, _285 + _365, 0.0);
    float _368 = _367.x;
    float _371 = _367.y;
    float _374 = _367.z;
    vec4 _382 = textureLod(gInColourFiltered, _285 - _365, 0.0);
    float _383 = _382.x;
    float _386 = _382.y;
    float _389 = _382.z;
    vec3 _394 = (((((min(vec3((_291 > 0.0) ? _291 : 0.0, (_294 > 0.0) ? _294 : 0.0, (_297 > 0.0) ? _297 : 0.0), vec3(65504.0)) + min(vec3((_306 > 0.0) ? _306 : 0.0, (_309 > 0.0) ? _309 : 0.0, (_312 > 0.0) ? _312 : 0.0), vec3(65504.0))) + min(vec3((_321 > 0.0) ? _321 : 0.0, (_324 > 0.0) ? _324 : 0.0, (_327 > 0.0) ? _327 : 0.0), vec3(65504.0))) + min(vec3((_337 > 0.0) ? _337 : 0.0, (_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0), vec3(65504.0))) + min(vec3((_352 > 0.0) ? _352 : 0.0, (_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0), vec3(65504.0))) + min(vec3((_368 > 0.0) ? _368 : 0.0, (_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0), vec3(65504.0))) + min(vec3((_383 > 0.0) ? _383 : 0.0, (_386 > 0.0) ? _386 : 0.0, (_389 > 0.0) ? _389 : 0.0), vec3(65504.0));
    vec3 _398 = mix(min(_394 * vec3(0.14285714924335479736328125), vec3(65504.0)), _269, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_164 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_269, 1.0);
    gOutColour = vec4(_398, 1.0);
}

