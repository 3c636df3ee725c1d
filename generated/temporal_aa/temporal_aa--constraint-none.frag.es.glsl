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
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _82 = textureLodOffset(gInDepth, _78, 0.0, ivec2(-1));
    float _83 = _82.x;
    vec4 _85 = textureLodOffset(gInDepth, _78, 0.0, ivec2(0, -1));
    float _86 = _85.x;
    vec4 _88 = textureLodOffset(gInDepth, _78, 0.0, ivec2(1, -1));
    float _89 = _88.x;
    vec4 _91 = textureLodOffset(gInDepth, _78, 0.0, ivec2(-1, 0));
    float _92 = _91.x;
    vec4 _94 = textureLod(gInDepth, _78, 0.0);
    float _95 = _94.x;
    vec4 _97 = textureLodOffset(gInDepth, _78, 0.0, ivec2(1, 0));
    float _98 = _97.x;
    vec4 _100 = textureLodOffset(gInDepth, _78, 0.0, ivec2(-1, 1));
    float _101 = _100.x;
    vec4 _103 = textureLodOffset(gInDepth, _78, 0.0, ivec2(0, 1));
    float _104 = _103.x;
    vec4 _106 = textureLodOffset(gInDepth, _78, 0.0, ivec2(1));
    float _107 = _106.x;
    vec2 _109 = vec2(_98, 1.0);
    vec2 _110 = vec2(_92, -1.0);
    bvec2 _111 = bvec2(_98 < _92);
    vec2 _112 = vec2(_111.x ? _109.x : _110.x, _111.y ? _109.y : _110.y);
    vec2 _115 = vec2(_95, 0.0);
    bvec2 _116 = bvec2(_112.x < _95);
    vec2 _117 = vec2(_116.x ? _112.x : _115.x, _116.y ? _112.y : _115.y);
    vec2 _119 = vec2(_89, 1.0);
    vec2 _120 = vec2(_83, -1.0);
    bvec2 _121 = bvec2(_89 < _83);
    vec2 _122 = vec2(_121.x ? _119.x : _120.x, _121.y ? _119.y : _120.y);
    vec2 _125 = vec2(_86, 0.0);
    bvec2 _126 = bvec2(_122.x < _86);
    vec2 _127 = vec2(_126.x ? _122.x : _125.x, _126.y ? _122.y : _125.y);
    vec2 _129 = vec2(_107, 1.0);
    vec2 _130 = vec2(_101, -1.0);
    bvec2 _131 = bvec2(_107 < _101);
    vec2 _132 = vec2(_131.x ? _129.x : _130.x, _131.y ? _129.y : _130.y);
    vec2 _135 = vec2(_104, 0.0);
    bvec2 _136 = bvec2(_132.x < _104);
    vec2 _137 = vec2(_136.x ? _132.x : _135.x, _136.y ? _132.y : _135.y);
    bool _140 = _137.x < _127.x;
    bvec2 _141 = bvec2(_140);
    vec2 _142 = vec2(_141.x ? _137.x : _127.x, _141.y ? _137.y : _127.y);
    vec2 _148 = vec2(_142.y, _140 ? 1.0 : (-1.0));
    vec2 _150 = vec2(_117.y, 0.0);
    bvec2 _151 = bvec2(_142.x < _117.x);
    vec2 _162 = textureLod(gInVelocity, gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(_151.x ? _148.x : _150.x, _151.y ? _148.y : _150.y) * parameters.gOutputSize.zw), 0.0).xy * parameters.gMotionToUv;
    vec2 _164 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_162);
    float _223 = max(-parameters.gJitterPx.x, 0.0);
    float _225 = 1.0 - abs(parameters.gJitterPx.x);
    float _226 = max(parameters.gJitterPx.x, 0.0);
    vec3 _252 = (((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _223) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, -1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) * max(-parameters.gJitterPx.y, 0.0)) + ((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _223) + (clamp(textureLod(gInColour, _78, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1, 0)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) * (1.0 - abs(parameters.gJitterPx.y)))) + ((((clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(-1, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _223) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(0, 1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _225)) + (clamp(textureLodOffset(gInColour, _78, 0.0, ivec2(1)).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) * _226)) * max(parameters.gJitterPx.y, 0.0));
    vec3 _267 = min((_252 + ((clamp(textureLod(gHistoryColour, _164, 0.0).xyz * 1.52587890625e-05, vec3(0.0), vec3(1.0)) - _252) * (all(lessThanEqual(abs(_164 - vec2(0.5)), vec2(0.5))) ? (parameters.gFeedbackMax * parameters.gHistoryValid) : 0.0))) * 65536.0, vec3(65504.0));
    vec2 _283 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gJitterPx * parameters.gOutputSize.zw);
    vec2 _286 = _162 * 0.083333335816860198974609375;
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
    vec3 _396 = mix(min(_392 * vec3(0.14285714924335479736328125), vec3(65504.0)), _267, vec3((parameters.gHistoryValid > 0.0) ? clamp((parameters.gBlurToPx - length(_162 * parameters.gOutputSize.xy)) / max(parameters.gBlurToPx - parameters.gBlurFromPx, 9.9999999747524270787835121154785e-07), 0.0, 1.0) : 1.0));
    gOutHistory = vec4(_267, 1.0);
    gOutColour = vec4(_396, 1.0);
}

