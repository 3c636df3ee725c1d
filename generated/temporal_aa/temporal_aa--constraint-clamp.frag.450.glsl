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
    vec2 _116 = mix(vec2(_105, -1.0), vec2(_108, 1.0), bvec2(_108 < _105));
    vec2 _121 = mix(vec2(_106, 0.0), _116, bvec2(_116.x < _106));
    vec2 _126 = mix(vec2(_103, -1.0), vec2(_107, 1.0), bvec2(_107 < _103));
    vec2 _131 = mix(vec2(_104, 0.0), _126, bvec2(_126.x < _104));
    vec2 _136 = mix(vec2(_109, -1.0), vec2(_111, 1.0), bvec2(_111 < _109));
    vec2 _141 = mix(vec2(_110, 0.0), _136, bvec2(_136.x < _110));
    bool _144 = _141.x < _131.x;
    vec2 _146 = mix(_131, _141, bvec2(_144));
    vec2 _166 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_121.y, 0.0), vec2(_146.y, _144 ? 1.0 : (-1.0)), bvec2(_146.x < _121.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _168 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_166);
    vec3 _182 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _187 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _192 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _197 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _202 = clamp(textureLod(gInColour, _80, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _207 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _212 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _217 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    vec3 _222 = clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    float _227 = max(-parameters.gJitterPx.x, 0.0);
    float _229 = 1.0 - abs(parameters.gJitterPx.x);
    float _230 = max(parameters.gJitterPx.x, 0.0);
    vec3 _256 = (((((_182 * _227) + (_187 * _229)) + (_192 * _230)) * max(-parameters.gJitterPx.y, 0.0)) + ((((_197 * _227) + (_202 * _229)) + (_207 * _230)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((_212 * _227) + (_217 * _229)) + (_222 * _230)) * max(parameters.gJitterPx.y, 0.0));
    ivec3 _257 = floatBitsToInt(_197);
    ivec3 _258 = floatBitsToInt(_207);
    ivec3 _260 = floatBitsToInt(_202);
    ivec3 _263 = floatBitsToInt(intBitsToFloat(min(min(_257, _258), _260)));
    ivec3 _264 = floatBitsToInt(_187);
    ivec3 _266 = floatBitsToInt(_217);
    ivec3 _272 = floatBitsToInt(intBitsToFloat(max(max(_257, _258), _260)));
    ivec3 _276 = floatBitsToInt(_182);
    ivec3 _277 = floatBitsToInt(_192);
    ivec3 _281 = floatBitsToInt(_212);
    ivec3 _282 = floatBitsToInt(_222);
    vec3 _321 = min((_256 + ((clamp(clamp(textureLod(gHistoryColour, _168, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)), (intBitsToFloat(min(min(_263, _264), _266)) + intBitsToFloat(min(min(_263, floatBitsToInt(intBitsToFloat(min(min(_276, _277), _264)))), floatBitsToInt(intBitsToFloat(min(min(_281, _282), _266)))))) * 0.5, (intBitsToFloat(max(max(_272, _264), _266)) + intBitsToFloat(max(max(_272, floatBitsToInt(intBitsToFloat(max(max(_276, _277), _264)))), floatBitsToInt(intBitsToFloat(max(max(_281, _282), _266)))))) * 0.5) - _256) * (all(lessThanEqual(abs(_168 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _337 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _340 = _166 * 0.083333335816860198974609375;
    vec4 _342 = textureLod(gInColourFiltered, _337, 0.0);
    float _343 = _342.x;
    float _346 = _342.y;
    float _349 = _342.z;
    vec2 _355 = _340 * 1.0;
    vec4 _357 = textureLod(gInColourFiltered, _337 + _355, 0.0);
    float _358 = _357.x;
    float _361 = _357.y;
    float _364 = _357.z;
    vec4 _372 = textureLod(gInColourFiltered, _337 - _355, 0.0);
    float _373 = _372.x;
    float _376 = _372.y;
    float _379 = _372.z;
    vec2 _386 = _340 * 2.0;
    vec4 _388 = textureLod(gInColourFiltered, _337 + _386, 0.0);
    float _389 = _388.x;
    float _392 = _388.y;
    float _395 = _388.z;
    vec4 _403 = textureLod(gInColourFiltered, _337 - _386, 0.0);
    float _404 = _403.x;
    float _407 = _403.y;
    float _410 = _403.z;
    vec2 _417 = _340 * 3.0;
    vec4 _419 = textureLod(gInColourFiltered, _337 + _417, 0.0);
    float _420 = _419.x;
    float _423 = _419.y;
    float _426 = _419.z;
    vec4 _434 = textureLod(gInColourFiltered, _337 - _417, 0.0);
    float _435 = _434.x;
    float _438 = _434.y;
    float _441 = _434.z;
    vec3 _446 = (((((min(vec3((_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0, (_349 > 0.0) ? _349 : 0.0), vec3(65504.0)) + min(vec3((_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0, (_364 > 0.0) ? _364 : 0.0), vec3(65504.0))) + min(vec3((_373 > 0.0) ? _373 : 0.0, (_376 > 0.0) ? _376 : 0.0, (_379 > 0.0) ? _379 : 0.0), vec3(65504.0))) + min(vec3((_389 > 0.0) ? _389 : 0.0, (_392 > 0.0) ? _392 : 0.0, (_395 > 0.0) ? _395 : 0.0), vec3(65504.0))) + min(vec3((_404 > 0.0) ? _404 : 0.0, (_407 > 0.0) ? _407 : 0.0, (_410 > 0.0) ? _410 : 0.0), vec3(65504.0))) + min(vec3((_420 > 0.0) ? _420 : 0.0, (_423 > 0.0) ? _423 : 0.0, (_426 > 0.0) ? _426 : 0.0), vec3(65504.0))) + min(vec3((_435 > 0.0) ? _435 : 0.0, (_438 > 0.0) ? _438 : 0.0, (_441 > 0.0) ? _441 : 0.0), vec3(65504.0));
    vec3 _450 = mix(min(_446 * vec3(0.14285714924335479736328125), vec3(65504.0)), _321, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_166 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_321, 1.0);
    gOutColour = vec4(_450, 1.0);
}

