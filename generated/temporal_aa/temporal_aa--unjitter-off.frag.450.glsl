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
    vec3 _202 = clamp(textureLod(gInColour, _80, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    ivec3 _223 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _224 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _226 = floatBitsToInt(_202);
    ivec3 _229 = floatBitsToInt(intBitsToFloat(min(min(_223, _224), _226)));
    ivec3 _230 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _232 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _238 = floatBitsToInt(intBitsToFloat(max(max(_223, _224), _226)));
    ivec3 _242 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _243 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _247 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _248 = floatBitsToInt(clamp(textureLodOffset(gInColour, _80, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _272 = ((intBitsToFloat(max(max(_238, _230), _232)) + intBitsToFloat(max(max(_238, floatBitsToInt(intBitsToFloat(max(max(_242, _243), _230)))), floatBitsToInt(intBitsToFloat(max(max(_247, _248), _232)))))) * 0.5) * 0.5;
    vec3 _273 = ((intBitsToFloat(min(min(_229, _230), _232)) + intBitsToFloat(min(min(_229, floatBitsToInt(intBitsToFloat(min(min(_242, _243), _230)))), floatBitsToInt(intBitsToFloat(min(min(_247, _248), _232)))))) * 0.5) * 0.5;
    vec3 _274 = _272 + _273;
    vec3 _276 = max(_272 - _273, vec3(1.5258789240815695542607954848791e-12));
    vec3 _277 = clamp(textureLod(gHistoryColour, _168, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _274;
    vec3 _280 = _276 / max(abs(_277), _276);
    vec3 _302 = min((_202 + (((_274 + (_277 * min(_280.x, min(_280.y, _280.z)))) - _202) * (all(lessThanEqual(abs(_168 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _319 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _322 = _166 * 0.083333335816860198974609375;
    vec4 _324 = textureLod(gInColourFiltered, _319, 0.0);
    float _325 = _324.x;
    float _328 = _324.y;
    float _331 = _324.z;
    vec2 _337 = _322 * 1.0;
    vec4 _339 = textureLod(gInColourFiltered, _319 + _337, 0.0);
    float _340 = _339.x;
    float _343 = _339.y;
    float _346 = _339.z;
    vec4 _354 = textureLod(gInColourFiltered, _319 - _337, 0.0);
    float _355 = _354.x;
    float _358 = _354.y;
    float _361 = _354.z;
    vec2 _368 = _322 * 2.0;
    vec4 _370 = textureLod(gInColourFiltered, _319 + _368, 0.0);
    float _371 = _370.x;
    float _374 = _370.y;
    float _377 = _370.z;
    vec4 _385 = textureLod(gInColourFiltered, _319 - _368, 0.0);
    float _386 = _385.x;
    float _389 = _385.y;
    float _392 = _385.z;
    vec2 _399 = _322 * 3.0;
    vec4 _401 = textureLod(gInColourFiltered, _319 + _399, 0.0);
    float _402 = _401.x;
    float _405 = _401.y;
    float _408 = _401.z;
    vec4 _416 = textureLod(gInColourFiltered, _319 - _399, 0.0);
    float _417 = _416.x;
    float _420 = _416.y;
    float _423 = _416.z;
    vec3 _428 = (((((min(vec3((_325 > 0.0) ? _325 : 0.0, (_328 > 0.0) ? _328 : 0.0, (_331 > 0.0) ? _331 : 0.0), vec3(65504.0)) + min(vec3((_340 > 0.0) ? _340 : 0.0, (_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0), vec3(65504.0))) + min(vec3((_355 > 0.0) ? _355 : 0.0, (_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0), vec3(65504.0))) + min(vec3((_371 > 0.0) ? _371 : 0.0, (_374 > 0.0) ? _374 : 0.0, (_377 > 0.0) ? _377 : 0.0), vec3(65504.0))) + min(vec3((_386 > 0.0) ? _386 : 0.0, (_389 > 0.0) ? _389 : 0.0, (_392 > 0.0) ? _392 : 0.0), vec3(65504.0))) + min(vec3((_402 > 0.0) ? _402 : 0.0, (_405 > 0.0) ? _405 : 0.0, (_408 > 0.0) ? _408 : 0.0), vec3(65504.0))) + min(vec3((_417 > 0.0) ? _417 : 0.0, (_420 > 0.0) ? _420 : 0.0, (_423 > 0.0) ? _423 : 0.0), vec3(65504.0));
    vec3 _432 = mix(min(_428 * vec3(0.14285714924335479736328125), vec3(65504.0)), _302, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_166 * parameters.gOutputSize.xy)) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_302, 1.0);
    gOutColour = vec4(_432, 1.0);
}

