#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform TemporalAaParameters
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

uniform highp sampler2D gInDepth;
uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryColour;
uniform highp sampler2D gInColour;
uniform highp sampler2D gInColourFiltered;

layout(location = 0) out vec4 gOutHistory;
layout(location = 1) out vec4 gOutColour;

void main()
{
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _81 = textureLodOffset(gInDepth, _77, 0.0, ivec2(-1));
    float _82 = _81.x;
    vec4 _84 = textureLodOffset(gInDepth, _77, 0.0, ivec2(0, -1));
    float _85 = _84.x;
    vec4 _87 = textureLodOffset(gInDepth, _77, 0.0, ivec2(1, -1));
    float _88 = _87.x;
    vec4 _90 = textureLodOffset(gInDepth, _77, 0.0, ivec2(-1, 0));
    float _91 = _90.x;
    vec4 _93 = textureLod(gInDepth, _77, 0.0);
    float _94 = _93.x;
    vec4 _96 = textureLodOffset(gInDepth, _77, 0.0, ivec2(1, 0));
    float _97 = _96.x;
    vec4 _99 = textureLodOffset(gInDepth, _77, 0.0, ivec2(-1, 1));
    float _100 = _99.x;
    vec4 _102 = textureLodOffset(gInDepth, _77, 0.0, ivec2(0, 1));
    float _103 = _102.x;
    vec4 _105 = textureLodOffset(gInDepth, _77, 0.0, ivec2(1));
    float _106 = _105.x;
    vec2 _108 = vec2(_97, 1.0);
    vec2 _109 = vec2(_91, -1.0);
    bvec2 _110 = bvec2(_97 < _91);
    vec2 _111 = vec2(_110.x ? _108.x : _109.x, _110.y ? _108.y : _109.y);
    vec2 _114 = vec2(_94, 0.0);
    bvec2 _115 = bvec2(_111.x < _94);
    vec2 _116 = vec2(_115.x ? _111.x : _114.x, _115.y ? _111.y : _114.y);
    vec2 _118 = vec2(_88, 1.0);
    vec2 _119 = vec2(_82, -1.0);
    bvec2 _120 = bvec2(_88 < _82);
    vec2 _121 = vec2(_120.x ? _118.x : _119.x, _120.y ? _118.y : _119.y);
    vec2 _124 = vec2(_85, 0.0);
    bvec2 _125 = bvec2(_121.x < _85);
    vec2 _126 = vec2(_125.x ? _121.x : _124.x, _125.y ? _121.y : _124.y);
    vec2 _128 = vec2(_106, 1.0);
    vec2 _129 = vec2(_100, -1.0);
    bvec2 _130 = bvec2(_106 < _100);
    vec2 _131 = vec2(_130.x ? _128.x : _129.x, _130.y ? _128.y : _129.y);
    vec2 _134 = vec2(_103, 0.0);
    bvec2 _135 = bvec2(_131.x < _103);
    vec2 _136 = vec2(_135.x ? _131.x : _134.x, _135.y ? _131.y : _134.y);
    bool _139 = _136.x < _126.x;
    bvec2 _140 = bvec2(_139);
    vec2 _141 = vec2(_140.x ? _136.x : _126.x, _140.y ? _136.y : _126.y);
    vec2 _147 = vec2(_141.y, _139 ? 1.0 : (-1.0));
    vec2 _149 = vec2(_116.y, 0.0);
    bvec2 _150 = bvec2(_141.x < _116.x);
    vec2 _161 = textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(_150.x ? _147.x : _149.x, _150.y ? _147.y : _149.y) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _163 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_161);
    float _222 = max(-parameters.gJitterPx.x, 0.0);
    float _224 = 1.0 - abs(parameters.gJitterPx.x);
    float _225 = max(parameters.gJitterPx.x, 0.0);
    vec3 _251 = (((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _222) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _222) + (clamp(textureLod(gInColour, _77, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _222) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _224)) + (clamp(textureLodOffset(gInColour, _77, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _266 = min((_251 + ((clamp(textureLod(gHistoryColour, _163, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _251) * (all(lessThanEqual(abs(_163 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _281 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _284 = _161 * 0.083333335816860198974609375;
    vec4 _286 = textureLod(gInColourFiltered, _281, 0.0);
    float _287 = _286.x;
    float _290 = _286.y;
    float _293 = _286.z;
    vec2 _299 = _284 * 1.0;
    vec4 _301 = textureLod(gInColourFiltered, _281 + _299, 0.0);
    float _302 = _301.x;
    float _305 = _301.y;
    float _308 = _301.z;
    vec4 _316 = textureLod(gInColourFiltered, _281 - _299, 0.0);
    float _317 = _316.x;
    float _320 = _316.y;
    float _323 = _316.z;
    vec2 _330 = _284 * 2.0;
    vec4 _332 = textureLod(gInColourFiltered, _281 + _330, 0.0);
    float _333 = _332.x;
    float _336 = _332.y;
    float _339 = _332.z;
    vec4 _347 = textureLod(gInColourFiltered, _281 - _330, 0.0);
    float _348 = _347.x;
    float _351 = _347.y;
    float _354 = _347.z;
    vec2 _361 = _284 * 3.0;
    vec4 _363 = textureLod(gInColourFiltered, _281 + _361, 0.0);
    float _364 = _363.x;
    float _367 = _363.y;
    float _370 = _363.z;
    vec4 _378 = textureLod(gInColourFiltered, _281 - _361, 0.0);
    float _379 = _378.x;
    float _382 = _378.y;
    float _385 = _378.z;
    vec3 _390 = (((((min(vec3((_287 > 0.0) ? _287 : 0.0, (_290 > 0.0) ? _290 : 0.0, (_293 > 0.0) ? _293 : 0.0), vec3(65504.0)) + min(vec3((_302 > 0.0) ? _302 : 0.0, (_305 > 0.0) ? _305 : 0.0, (_308 > 0.0) ? _308 : 0.0), vec3(65504.0))) + min(vec3((_317 > 0.0) ? _317 : 0.0, (_320 > 0.0) ? _320 : 0.0, (_323 > 0.0) ? _323 : 0.0), vec3(65504.0))) + min(vec3((_333 > 0.0) ? _333 : 0.0, (_336 > 0.0) ? _336 : 0.0, (_339 > 0.0) ? _339 : 0.0), vec3(65504.0))) + min(vec3((_348 > 0.0) ? _348 : 0.0, (_351 > 0.0) ? _351 : 0.0, (_354 > 0.0) ? _354 : 0.0), vec3(65504.0))) + min(vec3((_364 > 0.0) ? _364 : 0.0, (_367 > 0.0) ? _367 : 0.0, (_370 > 0.0) ? _370 : 0.0), vec3(65504.0))) + min(vec3((_379 > 0.0) ? _379 : 0.0, (_382 > 0.0) ? _382 : 0.0, (_385 > 0.0) ? _385 : 0.0), vec3(65504.0));
    vec3 _394 = mix(min(_390 * vec3(0.14285714924335479736328125), vec3(65504.0)), _266, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_161 * parameters.gOutputSize.xy)) / (parameters.gBlurToPx - parameters.gBlurFromPx), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_266, 1.0);
    gOutColour = vec4(_394, 1.0);
}

