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
uniform highp sampler2D gHistoryCache;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _94 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _98 = textureLod(gInFresh, _94, 0.0);
    float _99 = _98.y;
    float _100 = _98.x;
    float _105 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _106 = floor(_105);
    vec2 _111 = vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0));
    bvec2 _112 = bvec2(abs(_100) <= 65504.0);
    vec2 _113 = vec2(_112.x ? _111.x : vec2(1.9999999360571384930131252153835e+38).x, _112.y ? _111.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _115 = lessThanEqual(abs(_113), vec2(65504.0));
    vec2 _116 = vec2(_115.x ? _113.x : vec2(0.0).x, _115.y ? _113.y : vec2(0.0).y);
    float _120 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
    vec4 _132 = parameters.gViewToPreviousClip * vec4((_94 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _120, _120, 1.0);
    float _135 = _132.w;
    vec2 _140 = (_132.xy * (1.0 / _135)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _145 = bvec2((_135 > 0.0) && all(lessThanEqual(abs(_140), vec2(8.0))));
    float _148 = dot(_132.zw, parameters.gClipToDepth);
    vec2 _154 = vec2(_145.x ? _140.x : vec2(-8.0).x, _145.y ? _140.y : vec2(-8.0).y) * parameters.gFrameToCoarse;
    float _160 = max(parameters.gMissThreshold.y * _120 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _162 = _154 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _163 = floor(_162);
    vec2 _164 = _162 - _163;
    vec2 _165 = vec2(1.0) - _164;
    float _166 = _165.x;
    float _167 = _164.x;
    vec2 _174 = (_163 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _178 = textureLod(gHistoryCache, _174, 0.0);
    float _179 = _178.x;
    vec2 _184 = (_163 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _186 = textureLod(gHistoryCache, _184, 0.0);
    float _187 = _186.x;
    vec2 _192 = (_163 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _194 = textureLod(gHistoryCache, _192, 0.0);
    float _195 = _194.x;
    vec2 _200 = (_163 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _202 = textureLod(gHistoryCache, _200, 0.0);
    float _203 = _202.x;
    vec4 _216 = vec4(_160) - abs(vec4((abs(_148) <= 9.9999996802856924650656260769173e+37) ? _148 : 0.0) - vec4(textureLod(gHistoryCache, _174, 0.0).y, textureLod(gHistoryCache, _184, 0.0).y, textureLod(gHistoryCache, _192, 0.0).y, textureLod(gHistoryCache, _200, 0.0).y));
    vec4 _217 = _216 * (parameters.gConvergenceTime / _160);
    bvec4 _218 = greaterThan(_216, vec4(0.0));
    vec4 _219 = vec4(_218.x ? _217.x : vec4(0.0).x, _218.y ? _217.y : vec4(0.0).y, _218.z ? _217.z : vec4(0.0).z, _218.w ? _217.w : vec4(0.0).w);
    vec4 _220 = min(_219, vec4(1.0));
    bvec4 _221 = greaterThan(_219, vec4(0.0));
    bvec4 _225 = bvec4(all(lessThanEqual(floatBitsToUint(_154), uvec2(1065353216u))));
    bvec4 _226 = bvec4(_221.x && _225.x, _221.y && _225.y, _221.z && _225.z, _221.w && _225.w);
    vec4 _227 = vec4(_226.x ? _220.x : vec4(0.0).x, _226.y ? _220.y : vec4(0.0).y, _226.z ? _220.z : vec4(0.0).z, _226.w ? _220.w : vec4(0.0).w);
    bvec4 _229 = lessThanEqual(abs(vec4(_179, _187, _195, _203)), vec4(65504.0));
    vec4 _230 = vec4(_229.x ? _227.x : vec4(0.0).x, _229.y ? _227.y : vec4(0.0).y, _229.z ? _227.z : vec4(0.0).z, _229.w ? _227.w : vec4(0.0).w);
    vec4 _231 = (vec4(_166, _167, _166, _167) * vec4(_165.yy, _164.yy)) * _230;
    vec4 _235 = _231 * (1.0 / max(dot(_231, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec4 _249 = vec4((_179 > 0.0) ? min(_179, 31.984375) : 0.0, (_187 > 0.0) ? min(_187, 31.984375) : 0.0, (_195 > 0.0) ? min(_195, 31.984375) : 0.0, (_203 > 0.0) ? min(_203, 31.984375) : 0.0);
    vec4 _250 = floor(_249);
    float _254 = dot(_235, _250) * 0.0322580635547637939453125;
    vec2 _257 = vec2(_254, dot(_235, min(_249 - _250, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _261 = textureLod(gHistoryCacheStateFiltered, _154, 0.0);
    float _262 = _261.x;
    float _265 = (_262 > 0.0) ? min(_262, 255.0) : 0.0;
    float _272 = ((parameters.gHistoryValid > 0.5) && (abs(_254) <= 65504.0)) ? dot(_235, _230) : 0.0;
    float _284 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _286 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_154)) * parameters.gOutputSize.xy));
    float _290 = ((_286 > 0.0) ? min(_286, _284) : 0.0) / _284;
    float _293 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _298 = _265 * _272;
    float _301 = (_298 > 0.0) ? min(_298, 255.0) : 0.0;
    float _305 = min(min(_301 / (_301 + 1.0), _293), ((_293 * _290) * _290) * ((-2.0) * _290 + 3.0));
    bvec2 _309 = bvec2(all(lessThanEqual(abs(_116), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _310 = vec2(_309.x ? _116.x : vec2(0.0).x, _309.y ? _116.y : vec2(0.0).y);
    vec2 _317 = _310 + ((_257 - _310) * clamp(_305, 0.0, 1.0));
    bvec2 _318 = bvec2(all(lessThanEqual(abs(_257), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _319 = vec2(_318.x ? _317.x : _310.x, _318.y ? _317.y : _310.y);
    bvec2 _321 = bvec2(_305 > 0.0);
    vec2 _322 = vec2(_321.x ? _319.x : _116.x, _321.y ? _319.y : _116.y);
    float _331 = _322.x;
    float _332 = _322.y;
    gOutCache = vec4(((_332 > 0.0) ? min(_332, 1.0) : 0.0) * 0.984375 + floor(((_331 > 0.0) ? min(_331, 1.0) : 0.0) * 31.0 + 0.5), _120, 0.0, 0.0);
    gOutCacheState = vec4(min(((_265 > 0.0) ? min(_265, 255.0) : 0.0) * ((_272 > 0.0) ? min(_272, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

