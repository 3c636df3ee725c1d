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
    vec2 _110 = vec2(_105 * 0.0322580635547637939453125, min((_104 - _105) * 1.01587307453155517578125, 1.0));
    bvec2 _111 = bvec2(abs(_99) <= 65504.0);
    vec2 _112 = vec2(_111.x ? _110.x : vec2(1.9999999360571384930131252153835e+38).x, _111.y ? _110.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _114 = lessThanEqual(abs(_112), vec2(65504.0));
    vec2 _115 = vec2(_114.x ? _112.x : vec2(0.0).x, _114.y ? _112.y : vec2(0.0).y);
    float _119 = ((_98 > 0.0) && (_98 < 65504.0)) ? _98 : 65504.0;
    vec4 _131 = parameters.gViewToPreviousClip * vec4((_93 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _119, _119, 1.0);
    float _134 = _131.w;
    vec2 _139 = (_131.xy * (1.0 / _134)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _144 = bvec2((_134 > 0.0) && all(lessThanEqual(abs(_139), vec2(8.0))));
    vec2 _145 = vec2(_144.x ? _139.x : vec2(-8.0).x, _144.y ? _139.y : vec2(-8.0).y);
    float _147 = dot(_131.zw, parameters.gClipToDepth);
    vec2 _153 = _145 * parameters.gFrameToCoarse;
    vec4 _157 = textureLod(gHistoryCacheStateFiltered, _153, 0.0);
    vec2 _159 = _153 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _160 = floor(_159);
    vec2 _165 = (_160 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _166 = textureLod(gHistoryCache, _165, 0.0);
    float _167 = _166.x;
    vec2 _173 = (_160 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _174 = textureLod(gHistoryCache, _173, 0.0);
    float _175 = _174.x;
    vec2 _181 = (_160 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _182 = textureLod(gHistoryCache, _181, 0.0);
    float _183 = _182.x;
    vec2 _189 = (_160 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _190 = textureLod(gHistoryCache, _189, 0.0);
    float _191 = _190.x;
    vec4 _196 = vec4(textureLod(gHistoryCache, _165, 0.0).y, textureLod(gHistoryCache, _173, 0.0).y, textureLod(gHistoryCache, _181, 0.0).y, textureLod(gHistoryCache, _189, 0.0).y);
    vec2 _197 = _159 - _160;
    vec2 _198 = vec2(1.0) - _197;
    float _199 = _198.x;
    float _200 = _197.x;
    vec4 _209 = (vec4(_199, _200, _199, _200) * vec4(_198.yy, _197.yy)) * vec4(lessThanEqual(abs(_196), vec4(9.9999996802856924650656260769173e+37)));
    bvec4 _211 = lessThanEqual(abs(vec4(_167, _175, _183, _191)), vec4(65504.0));
    vec4 _212 = vec4(_211.x ? _209.x : vec4(0.0).x, _211.y ? _209.y : vec4(0.0).y, _211.z ? _209.z : vec4(0.0).z, _211.w ? _209.w : vec4(0.0).w);
    bvec4 _213 = greaterThan(_212, vec4(0.0));
    vec4 _227 = vec4((_167 > 0.0) ? min(_167, 31.984375) : 0.0, (_175 > 0.0) ? min(_175, 31.984375) : 0.0, (_183 > 0.0) ? min(_183, 31.984375) : 0.0, (_191 > 0.0) ? min(_191, 31.984375) : 0.0);
    vec4 _228 = floor(_227);
    vec3 _240 = vec3(dot(_212, _228) * 0.0322580635547637939453125, dot(_212, min(_227 - _228, vec4(0.984375))) * 1.01587307453155517578125, dot(_212, vec4(_213.x ? _196.x : vec4(0.0).x, _213.y ? _196.y : vec4(0.0).y, _213.z ? _196.z : vec4(0.0).z, _213.w ? _196.w : vec4(0.0).w))) / vec3(max(dot(_212, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _241 = _240.xy;
    float _243 = _157.x;
    float _246 = (_243 > 0.0) ? min(_243, 255.0) : 0.0;
    float _252 = max(parameters.gMissThreshold.y * _119 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    float _258 = _252 - abs(((abs(_147) <= 9.9999996802856924650656260769173e+37) ? _147 : 0.0) - _240.z);
    float _261 = (_258 > 0.0) ? (_258 * (parameters.gConvergenceTime / _252)) : 0.0;
    float _277 = ((parameters.gHistoryValid > 0.5) && (abs(_240.x) <= 65504.0)) ? (((_261 > 0.0) && all(lessThanEqual(abs(_145 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_261, 1.0) : 0.0) : 0.0;
    float _289 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _291 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_153)) * parameters.gOutputSize.xy));
    float _295 = ((_291 > 0.0) ? min(_291, _289) : 0.0) / _289;
    float _298 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _303 = _246 * _277;
    float _306 = (_303 > 0.0) ? min(_303, 255.0) : 0.0;
    float _310 = min(min(_306 / (_306 + 1.0), _298), ((_298 * _295) * _295) * ((-2.0) * _295 + 3.0));
    bvec2 _314 = bvec2(all(lessThanEqual(abs(_115), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _315 = vec2(_314.x ? _115.x : vec2(0.0).x, _314.y ? _115.y : vec2(0.0).y);
    vec2 _322 = _315 + ((_241 - _315) * clamp(_310, 0.0, 1.0));
    bvec2 _323 = bvec2(all(lessThanEqual(abs(_241), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _324 = vec2(_323.x ? _322.x : _315.x, _323.y ? _322.y : _315.y);
    bvec2 _326 = bvec2(_310 > 0.0);
    vec2 _327 = vec2(_326.x ? _324.x : _115.x, _326.y ? _324.y : _115.y);
    float _336 = _327.x;
    float _337 = _327.y;
    gOutCache = vec4(((_337 > 0.0) ? min(_337, 1.0) : 0.0) * 0.984375 + floor(((_336 > 0.0) ? min(_336, 1.0) : 0.0) * 31.0 + 0.5), _119, 0.0, 0.0);
    gOutCacheState = vec4(min(((_246 > 0.0) ? min(_246, 255.0) : 0.0) * ((_277 > 0.0) ? min(_277, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

