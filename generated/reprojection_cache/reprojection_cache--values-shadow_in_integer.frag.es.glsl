#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform ReprojectionCacheParameters
{
    mat4 gViewToPreviousClip;
    vec4 gOutputSize;
    vec4 gViewRay;
    vec2 gFrameToCoarse;
    vec2 gMotionToUv;
    vec2 gClipToDepth;
    vec2 gMissThreshold;
    vec2 gSpeedPx;
    vec2 gChange;
    float gConvergenceTime;
    float gMaxWeight;
    float gHistoryValid;
} parameters;

uniform highp sampler2D gInFresh;
uniform highp sampler2D gHistoryCacheStateFiltered;
uniform highp sampler2D gHistoryCache;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _93 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _97 = textureLod(gInFresh, _93, 0.0);
    float _98 = _97.y;
    float _99 = _97.x;
    float _104 = (_99 > 0.0) ? min(_99, 31.984375) : 0.0;
    float _105 = floor(_104);
    vec2 _111 = vec2(_105 * 0.0322580635547637939453125, min((_104 - _105) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _112 = bvec2(abs(_99) <= 65504.0);
    vec2 _113 = vec2(_112.x ? _111.x : vec2(1.9999999360571384930131252153835e+38).x, _112.y ? _111.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _115 = lessThanEqual(abs(_113), vec2(65504.0));
    vec2 _116 = vec2(_115.x ? _113.x : vec2(0.0).x, _115.y ? _113.y : vec2(0.0).y);
    float _120 = ((_98 > 0.0) && (_98 < 65504.0)) ? _98 : 65504.0;
    vec4 _132 = parameters.gViewToPreviousClip * vec4((_93 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _120, _120, 1.0);
    float _135 = _132.w;
    vec2 _140 = (_132.xy * (1.0 / _135)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _145 = bvec2((_135 > 0.0) && all(lessThanEqual(abs(_140), vec2(8.0))));
    vec2 _146 = vec2(_145.x ? _140.x : vec2(-8.0).x, _145.y ? _140.y : vec2(-8.0).y);
    float _148 = dot(_132.zw, parameters.gClipToDepth);
    vec2 _154 = _146 * parameters.gFrameToCoarse;
    vec4 _158 = textureLod(gHistoryCacheStateFiltered, _154, 0.0);
    vec2 _160 = _154 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _161 = floor(_160);
    vec2 _166 = (_161 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _167 = textureLod(gHistoryCache, _166, 0.0);
    float _168 = _167.x;
    vec2 _174 = (_161 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _175 = textureLod(gHistoryCache, _174, 0.0);
    float _176 = _175.x;
    vec2 _182 = (_161 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _183 = textureLod(gHistoryCache, _182, 0.0);
    float _184 = _183.x;
    vec2 _190 = (_161 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _191 = textureLod(gHistoryCache, _190, 0.0);
    float _192 = _191.x;
    vec4 _197 = vec4(textureLod(gHistoryCache, _166, 0.0).y, textureLod(gHistoryCache, _174, 0.0).y, textureLod(gHistoryCache, _182, 0.0).y, textureLod(gHistoryCache, _190, 0.0).y);
    vec2 _198 = _160 - _161;
    vec2 _199 = vec2(1.0) - _198;
    float _200 = _199.x;
    float _201 = _198.x;
    vec4 _210 = (vec4(_200, _201, _200, _201) * vec4(_199.yy, _198.yy)) * vec4(lessThanEqual(abs(_197), vec4(9.9999996802856924650656260769173e+37)));
    bvec4 _212 = lessThanEqual(abs(vec4(_168, _176, _184, _192)), vec4(65504.0));
    vec4 _213 = vec4(_212.x ? _210.x : vec4(0.0).x, _212.y ? _210.y : vec4(0.0).y, _212.z ? _210.z : vec4(0.0).z, _212.w ? _210.w : vec4(0.0).w);
    bvec4 _214 = greaterThan(_213, vec4(0.0));
    vec4 _228 = vec4((_168 > 0.0) ? min(_168, 31.984375) : 0.0, (_176 > 0.0) ? min(_176, 31.984375) : 0.0, (_184 > 0.0) ? min(_184, 31.984375) : 0.0, (_192 > 0.0) ? min(_192, 31.984375) : 0.0);
    vec4 _229 = floor(_228);
    vec3 _241 = vec3(dot(_213, min(_228 - _229, vec4(0.984375))) * 1.01587307453155517578125, dot(_213, _229) * 0.0322580635547637939453125, dot(_213, vec4(_214.x ? _197.x : vec4(0.0).x, _214.y ? _197.y : vec4(0.0).y, _214.z ? _197.z : vec4(0.0).z, _214.w ? _197.w : vec4(0.0).w))) / vec3(max(dot(_213, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _242 = _241.xy;
    float _244 = _158.x;
    float _247 = (_244 > 0.0) ? min(_244, 255.0) : 0.0;
    float _253 = max(parameters.gMissThreshold.y * _120 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    float _259 = _253 - abs(((abs(_148) <= 9.9999996802856924650656260769173e+37) ? _148 : 0.0) - _241.z);
    float _262 = (_259 > 0.0) ? (_259 * (parameters.gConvergenceTime / _253)) : 0.0;
    float _278 = ((parameters.gHistoryValid > 0.5) && (abs(_241.x) <= 65504.0)) ? (((_262 > 0.0) && all(lessThanEqual(abs(_146 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_262, 1.0) : 0.0) : 0.0;
    float _290 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _292 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_154)) * parameters.gOutputSize.xy));
    float _296 = ((_292 > 0.0) ? min(_292, _290) : 0.0) / _290;
    float _299 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _304 = _247 * _278;
    float _307 = (_304 > 0.0) ? min(_304, 255.0) : 0.0;
    float _311 = min(min(_307 / (_307 + 1.0), _299), ((_299 * _296) * _296) * ((-2.0) * _296 + 3.0));
    bvec2 _315 = bvec2(all(lessThanEqual(abs(_116), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _316 = vec2(_315.x ? _116.x : vec2(0.0).x, _315.y ? _116.y : vec2(0.0).y);
    vec2 _323 = _316 + ((_242 - _316) * clamp(_311, 0.0, 1.0));
    bvec2 _324 = bvec2(all(lessThanEqual(abs(_242), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _325 = vec2(_324.x ? _323.x : _316.x, _324.y ? _323.y : _316.y);
    bvec2 _327 = bvec2(_311 > 0.0);
    vec2 _328 = vec2(_327.x ? _325.x : _116.x, _327.y ? _325.y : _116.y);
    float _337 = _328.x;
    float _338 = _328.y;
    gOutCache = vec4(((_337 > 0.0) ? min(_337, 1.0) : 0.0) * 0.984375 + floor(((_338 > 0.0) ? min(_338, 1.0) : 0.0) * 31.0 + 0.5), _120, 0.0, 0.0);
    gOutCacheState = vec4(min(((_247 > 0.0) ? min(_247, 255.0) : 0.0) * ((_278 > 0.0) ? min(_278, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

