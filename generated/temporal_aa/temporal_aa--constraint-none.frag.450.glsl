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
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _80 = parameters.gOutputSize.zw * 0.5;
    vec4 _84 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_80));
    float _86 = _80.x;
    float _87 = _80.y;
    vec4 _91 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(_86, -_87)));
    vec4 _96 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-_86, _87)));
    vec4 _99 = textureGather(gInDepth, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _80));
    float _100 = _84.w;
    float _101 = _84.z;
    float _102 = _84.x;
    float _103 = _84.y;
    float _104 = _91.z;
    float _105 = _91.y;
    float _106 = _96.x;
    float _107 = _96.y;
    float _108 = _99.y;
    vec2 _113 = mix(vec2(_102, -1.0), vec2(_105, 1.0), bvec2(_105 < _102));
    vec2 _118 = mix(vec2(_103, 0.0), _113, bvec2(_113.x < _103));
    vec2 _123 = mix(vec2(_100, -1.0), vec2(_104, 1.0), bvec2(_104 < _100));
    vec2 _128 = mix(vec2(_101, 0.0), _123, bvec2(_123.x < _101));
    vec2 _133 = mix(vec2(_106, -1.0), vec2(_108, 1.0), bvec2(_108 < _106));
    vec2 _138 = mix(vec2(_107, 0.0), _133, bvec2(_133.x < _107));
    bool _141 = _138.x < _128.x;
    vec2 _143 = mix(_128, _138, bvec2(_141));
    vec2 _163 = textureLod(gInVelocity, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, mix(vec2(_118.y, 0.0), vec2(_143.y, _141 ? 1.0 : (-1.0)), bvec2(_143.x < _118.x)) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _165 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_163);
    float _224 = max(-parameters.gJitterPx.x, 0.0);
    float _226 = 1.0 - abs(parameters.gJitterPx.x);
    float _227 = max(parameters.gJitterPx.x, 0.0);
    vec3 _253 = (((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224) + (clamp(textureLod(gInColour, _77, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _227)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _268 = min((_253 + ((clamp(textureLod(gHistoryColour, _165, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _253) * (all(lessThanEqual(abs(_165 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _283 = fma(gl_FragCoord.xy, parameters.gOutputSize.zw, parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _286 = _163 * 0.083333335816860198974609375;
    vec4 _288 = textureLod(gInColourFiltered, _283, 0.0);
    float _289 = _288.x;
    float _292 = _288.y;
    float _295 = _288.z;
    vec2 _301 = _286 * 1.0;
    vec4 _303 = textureLod(gInColourFiltered, _283 + _301, 0.0);
    float _304 = _303.x;
    float _307 = _303.y;
    float _310 = _303.z;
    vec4 _318 = textureLod(gInColourFiltered, _283 - _301, 0.0);
    float _319 = _318.x;
    float _322 = _318.y;
    float _325 = _318.z;
    vec2 _332 = _286 * 2.0;
    vec4 _334 = textureLod(gInColourFiltered, _283 + _332, 0.0);
    float _335 = _334.x;
    float _338 = _334.y;
    float _341 = _334.z;
    vec4 _349 = textureLod(gInColourFiltered, _283 - _332, 0.0);
    float _350 = _349.x;
    float _353 = _349.y;
    float _356 = _349.z;
    vec2 _363 = _286 * 3.0;
    vec4 _365 = textureLod(gInColourFiltered, _283 + _363, 0.0);
    float _366 = _365.x;
    float _369 = _365.y;
    float _372 = _365.z;
    vec4 _380 = textureLod(gInColourFiltered, _283 - _363, 0.0);
    float _381 = _380.x;
    float _384 = _380.y;
    float _387 = _380.z;
    vec3 _392 = (((((min(vec3((_289 > 0.0) ? _289 : 0.0, (_292 > 0.0) ? _292 : 0.0, (_295 > 0.0) ? _295 : 0.0), vec3(65504.0)) + min(vec3((_304 > 0.0) ? _304 : 0.0, (_307 > 0.0) ? _307 : 0.0, (_310 > 0.0) ? _310 : 0.0), vec3(65504.0))) + min(vec3((_319 > 0.0) ? _319 : 0.0, (_322 > 0.0) ? _322 : 0.0, (_325 > 0.0) ? _325 : 0.0), vec3(65504.0))) + min(vec3((_335 > 0.0) ? _335 : 0.0, (_338 > 0.0) ? _338 : 0.0, (_341 > 0.0) ? _341 : 0.0), vec3(65504.0))) + min(vec3((_350 > 0.0) ? _350 : 0.0, (_353 > 0.0) ? _353 : 0.0, (_356 > 0.0) ? _356 : 0.0), vec3(65504.0))) + min(vec3((_366 > 0.0) ? _366 : 0.0, (_369 > 0.0) ? _369 : 0.0, (_372 > 0.0) ? _372 : 0.0), vec3(65504.0))) + min(vec3((_381 > 0.0) ? _381 : 0.0, (_384 > 0.0) ? _384 : 0.0, (_387 > 0.0) ? _387 : 0.0), vec3(65504.0));
    vec3 _396 = mix(min(_392 * vec3(0.14285714924335479736328125), vec3(65504.0)), _268, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_163 * parameters.gOutputSize.xy)) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_268, 1.0);
    gOutColour = vec4(_396, 1.0);
}

