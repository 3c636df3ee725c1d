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
    float _226 = max(-parameters.gJitterPx.x, 0.0);
    float _228 = 1.0 - abs(parameters.gJitterPx.x);
    float _229 = max(parameters.gJitterPx.x, 0.0);
    vec3 _255 = (((((clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226) + (clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) + (clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _229)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226) + (clamp(textureLod(gInColour, _79, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) + (clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _229)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226) + (clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _228)) + (clamp(textureLodOffset(gInColour, _79, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _229)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _270 = min((_255 + ((clamp(textureLod(gHistoryColour, _167, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _255) * (all(lessThanEqual(abs(_167 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _286 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _289 = _165 * 0.083333335816860198974609375;
    vec4 _291 = textureLod(gInColourFiltered, _286, 0.0);
    float _292 = _291.x;
    float _295 = _291.y;
    float _298 = _291.z;
    vec2 _304 = _289 * 1.0;
    vec4 _306 = textureLod(gInColourFiltered, _286 + _304, 0.0);
    float _307 = _306.x;
    float _310 = _306.y;
    float _313 = _306.z;
    vec4 _321 = textureLod(gInColourFiltered, _286 - _304, 0.0);
    float _322 = _321.x;
    float _325 = _321.y;
    float _328 = _321.z;
    vec2 _335 = _289 * 2.0;
    vec4 _337 = textureLod(gInColourFiltered, _286 + _335, 0.0);
    float _338 = _337.x;
    float _341 = _337.y;
    float _344 = _337.z;
    vec4 _352 = textureLod(gInColourFiltered, _286 - _335, 0.0);
    float _353 = _352.x;
    float _356 = _352.y;
    float _359 = _352.z;
    vec2 _366 = _289 * 3.0;
    vec4 _368 = textureLod(gInColourFiltered, _286 + _366, 0.0);
    float _369 = _368.x;
    float _372 = _368.y;
    float _375 = _368.z;
    vec4 _383 = textureLod(gInColourFiltered, _286 - _366, 0.0);
    float _384 = _383.x;
    float _387 = _383.y;
    float _390 = _383.z;
    vec3 _395 = (((((min(vec3((_292 > 0.0) ? _292 : 0.0, (_295 > 0.0) ? _295 : 0.0, (_298 > 0.0) ? _298 : 0.0), vec3(65504.0)) + min(vec3((_307 > 0.0) ? _307 : 0.0, (_310 > 0.0) ? _310 : 0.0, (_313 > 0.0) ? _313 : 0.0), vec3(65504.0))) + min(vec3((_322 > 0.0) ? _322 : 0.0, (_325 > 0.0) ? _325 : 0.0, (_328 > 0.0) ? _328 : 0.0), vec3(65504.0))) + min(vec3((_338 > 0.0) ? _338 : 0.0, (_341 > 0.0) ? _341 : 0.0, (_344 > 0.0) ? _344 : 0.0), vec3(65504.0))) + min(vec3((_353 > 0.0) ? _353 : 0.0, (_356 > 0.0) ? _356 : 0.0, (_359 > 0.0) ? _359 : 0.0), vec3(65504.0))) + min(vec3((_369 > 0.0) ? _369 : 0.0, (_372 > 0.0) ? _372 : 0.0, (_375 > 0.0) ? _375 : 0.0), vec3(65504.0))) + min(vec3((_384 > 0.0) ? _384 : 0.0, (_387 > 0.0) ? _387 : 0.0, (_390 > 0.0) ? _390 : 0.0), vec3(65504.0));
    vec3 _399 = mix(min(_395 * vec3(0.14285714924335479736328125), vec3(65504.0)), _270, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_165 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_270, 1.0);
    gOutColour = vec4(_399, 1.0);
}

