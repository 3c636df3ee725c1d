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
    vec2 _84 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _87 = parameters.gOutputSize.zw * 0.5;
    vec4 _91 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_87));
    float _93 = _87.x;
    float _94 = _87.y;
    vec4 _98 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_93, -_94)));
    vec4 _103 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_93, _94)));
    vec4 _106 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _87));
    float _107 = _91.w;
    float _108 = _91.z;
    float _109 = _91.x;
    float _110 = _91.y;
    float _111 = _98.z;
    float _112 = _98.y;
    float _113 = _103.x;
    float _114 = _103.y;
    float _115 = _106.y;
    vec2 _120 = mix(vec2(_109, -1.0), vec2(_112, 1.0), bvec2(_112 < _109));
    vec2 _125 = mix(vec2(_110, 0.0), _120, bvec2(_120.x < _110));
    vec2 _130 = mix(vec2(_107, -1.0), vec2(_111, 1.0), bvec2(_111 < _107));
    vec2 _135 = mix(vec2(_108, 0.0), _130, bvec2(_130.x < _108));
    vec2 _140 = mix(vec2(_113, -1.0), vec2(_115, 1.0), bvec2(_115 < _113));
    vec2 _145 = mix(vec2(_114, 0.0), _140, bvec2(_140.x < _114));
    bool _148 = _145.x < _135.x;
    vec2 _150 = mix(_135, _145, bvec2(_148));
    vec2 _170 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_125.y, 0.0), vec2(_150.y, _148 ? 1.0 : (-1.0)), bvec2(_150.x < _125.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _172 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_170);
    vec3 _206 = clamp(textureLod(gInColour, _84, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0));
    ivec3 _227 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _228 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _230 = floatBitsToInt(_206);
    ivec3 _233 = floatBitsToInt(intBitsToFloat(min(min(_227, _228), _230)));
    ivec3 _234 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _236 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _242 = floatBitsToInt(intBitsToFloat(max(max(_227, _228), _230)));
    ivec3 _246 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _247 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _251 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    ivec3 _252 = floatBitsToInt(clamp(textureLodOffset(gInColour, _84, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)));
    vec3 _272 = intBitsToFloat(min(min(_233, _234), _236)) + intBitsToFloat(min(min(_233, floatBitsToInt(intBitsToFloat(min(min(_246, _247), _234)))), floatBitsToInt(intBitsToFloat(min(min(_251, _252), _236)))));
    vec3 _273 = intBitsToFloat(max(max(_242, _234), _236)) + intBitsToFloat(max(max(_242, floatBitsToInt(intBitsToFloat(max(max(_246, _247), _234)))), floatBitsToInt(intBitsToFloat(max(max(_251, _252), _236)))));
    vec3 _274 = _273 + _272;
    vec3 _276 = max(_273 - _272, vec3(6.1035156963262782170431819395162e-12));
    vec3 _278 = (clamp(textureLod(gHistoryColour, _172, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * 4.0) - _274;
    vec3 _281 = _276 / max(abs(_278), _276);
    vec3 _304 = min((_206 + ((((_274 + (_278 * min(_281.x, min(_281.y, _281.z)))) * 0.25) - _206) * (all(lessThanEqual(abs(_172 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _322 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _325 = _170 * 0.083333335816860198974609375;
    vec4 _327 = textureLod(gInColourFiltered, _322, 0.0);
    float _328 = _327.x;
    float _331 = _327.y;
    float _334 = _327.z;
    vec2 _340 = _325 * 1.0;
    vec4 _342 = textureLod(gInColourFiltered, _322 + _340, 0.0);
    float _343 = _342.x;
    float _346 = _342.y;
    float _349 = _342.z;
    vec4 _357 = textureLod(gInColourFiltered, _322 - _340, 0.0);
    float _358 = _357.x;
    float _361 = _357.y;
    float _364 = _357.z;
    vec2 _371 = _325 * 2.0;
    vec4 _373 = textureLod(gInColourFiltered, _322 + _371, 0.0);
    float _374 = _373.x;
    float _377 = _373.y;
    float _380 = _373.z;
    vec4 _388 = textureLod(gInColourFiltered, _322 - _371, 0.0);
    float _389 = _388.x;
    float _392 = _388.y;
    float _395 = _388.z;
    vec2 _402 = _325 * 3.0;
    vec4 _404 = textureLod(gInColourFiltered, _322 + _402, 0.0);
    float _405 = _404.x;
    float _408 = _404.y;
    float _411 = _404.z;
    vec4 _419 = textureLod(gInColourFiltered, _322 - _402, 0.0);
    float _420 = _419.x;
    float _423 = _419.y;
    float _426 = _419.z;
    vec3 _431 = (((((min(vec3((_328 > 0.0) ? _328 : 0.0, (_331 > 0.0) ? _331 : 0.0, (_334 > 0.0) ? _334 : 0.0), vec3(65504.0)) + min(vec3((_343 > 0.0) ? _343 : 0.0, (_346 > 0.0) ? _346 : 0.0, (_349 > 0.0) ? _349 : 0.0), vec3(65504.0))) + min(vec3((_358 > 0.0) ? _358 : 0.0, (_361 > 0.0) ? _361 : 0.0, (_364 > 0.0) ? _364 : 0.0), vec3(65504.0))) + min(vec3((_374 > 0.0) ? _374 : 0.0, (_377 > 0.0) ? _377 : 0.0, (_380 > 0.0) ? _380 : 0.0), vec3(65504.0))) + min(vec3((_389 > 0.0) ? _389 : 0.0, (_392 > 0.0) ? _392 : 0.0, (_395 > 0.0) ? _395 : 0.0), vec3(65504.0))) + min(vec3((_405 > 0.0) ? _405 : 0.0, (_408 > 0.0) ? _408 : 0.0, (_411 > 0.0) ? _411 : 0.0), vec3(65504.0))) + min(vec3((_420 > 0.0) ? _420 : 0.0, (_423 > 0.0) ? _423 : 0.0, (_426 > 0.0) ? _426 : 0.0), vec3(65504.0));
    vec3 _435 = mix(min(_431 * vec3(0.14285714924335479736328125), vec3(65504.0)), _304, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_170 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_304, 1.0);
    gOutColour = vec4(_435, 1.0);
}

