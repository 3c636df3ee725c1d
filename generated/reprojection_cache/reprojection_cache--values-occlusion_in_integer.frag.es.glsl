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
    vec2 _91 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _95 = textureLod(gInFresh, _91, 0.0);
    float _96 = _95.y;
    float _97 = _95.x;
    float _102 = (_97 > 0.0) ? min(_97, 31.984375) : 0.0;
    float _103 = floor(_102);
    vec2 _108 = vec2(_103 * 0.0322580635547637939453125, min((_102 - _103) * 1.01587307453155517578125, 1.0));
    bvec2 _109 = bvec2(abs(_97) <= 65504.0);
    vec2 _110 = vec2(_109.x ? _108.x : vec2(1.9999999360571384930131252153835e+38).x, _109.y ? _108.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _112 = lessThanEqual(abs(_110), vec2(65504.0));
    vec2 _113 = vec2(_112.x ? _110.x : vec2(0.0).x, _112.y ? _110.y : vec2(0.0).y);
    float _117 = ((_96 > 0.0) && (_96 < 65504.0)) ? _96 : 65504.0;
    vec4 _129 = parameters.gViewToPreviousClip * vec4((_91 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _117, _117, 1.0);
    float _132 = _129.w;
    vec2 _137 = (_129.xy * (1.0 / _132)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _142 = bvec2((_132 > 0.0) && all(lessThanEqual(abs(_137), vec2(8.0))));
    vec2 _143 = vec2(_142.x ? _137.x : vec2(-8.0).x, _142.y ? _137.y : vec2(-8.0).y);
    float _145 = dot(_129.zw, parameters.gClipToDepth);
    vec2 _151 = _143 * parameters.gFrameToCoarse;
    float _157 = max(parameters.gMissThreshold.y * _117 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _159 = _151 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _160 = floor(_159);
    vec2 _161 = _159 - _160;
    vec2 _162 = vec2(1.0) - _161;
    float _163 = _162.x;
    float _164 = _161.x;
    vec2 _171 = (_160 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _175 = textureLod(gHistoryCache, _171, 0.0);
    float _176 = _175.x;
    vec2 _181 = (_160 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _183 = textureLod(gHistoryCache, _181, 0.0);
    float _184 = _183.x;
    vec2 _189 = (_160 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _191 = textureLod(gHistoryCache, _189, 0.0);
    float _192 = _191.x;
    vec2 _197 = (_160 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _199 = textureLod(gHistoryCache, _197, 0.0);
    float _200 = _199.x;
    vec4 _213 = vec4(_157) - abs(vec4((abs(_145) <= 9.9999996802856924650656260769173e+37) ? _145 : 0.0) - vec4(textureLod(gHistoryCache, _171, 0.0).y, textureLod(gHistoryCache, _181, 0.0).y, textureLod(gHistoryCache, _189, 0.0).y, textureLod(gHistoryCache, _197, 0.0).y));
    vec4 _214 = _213 * (parameters.gConvergenceTime / _157);
    bvec4 _215 = greaterThan(_213, vec4(0.0));
    vec4 _216 = vec4(_215.x ? _214.x : vec4(0.0).x, _215.y ? _214.y : vec4(0.0).y, _215.z ? _214.z : vec4(0.0).z, _215.w ? _214.w : vec4(0.0).w);
    vec4 _217 = min(_216, vec4(1.0));
    bvec4 _218 = greaterThan(_216, vec4(0.0));
    bvec4 _223 = bvec4(all(lessThanEqual(abs(_143 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5))));
    bvec4 _224 = bvec4(_218.x && _223.x, _218.y && _223.y, _218.z && _223.z, _218.w && _223.w);
    vec4 _225 = vec4(_224.x ? _217.x : vec4(0.0).x, _224.y ? _217.y : vec4(0.0).y, _224.z ? _217.z : vec4(0.0).z, _224.w ? _217.w : vec4(0.0).w);
    bvec4 _227 = lessThanEqual(abs(vec4(_176, _184, _192, _200)), vec4(65504.0));
    vec4 _228 = vec4(_227.x ? _225.x : vec4(0.0).x, _227.y ? _225.y : vec4(0.0).y, _227.z ? _225.z : vec4(0.0).z, _227.w ? _225.w : vec4(0.0).w);
    vec4 _229 = (vec4(_163, _164, _163, _164) * vec4(_162.yy, _161.yy)) * _228;
    vec4 _233 = _229 * (1.0 / max(dot(_229, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec4 _247 = vec4((_176 > 0.0) ? min(_176, 31.984375) : 0.0, (_184 > 0.0) ? min(_184, 31.984375) : 0.0, (_192 > 0.0) ? min(_192, 31.984375) : 0.0, (_200 > 0.0) ? min(_200, 31.984375) : 0.0);
    vec4 _248 = floor(_247);
    float _252 = dot(_233, _248) * 0.0322580635547637939453125;
    vec2 _255 = vec2(_252, dot(_233, min(_247 - _248, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _259 = textureLod(gHistoryCacheStateFiltered, _151, 0.0);
    float _260 = _259.x;
    float _263 = (_260 > 0.0) ? min(_260, 255.0) : 0.0;
    float _270 = ((parameters.gHistoryValid > 0.5) && (abs(_252) <= 65504.0)) ? dot(_233, _228) : 0.0;
    float _282 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _284 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_151)) * parameters.gOutputSize.xy));
    float _288 = ((_284 > 0.0) ? min(_284, _282) : 0.0) / _282;
    float _291 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _296 = _263 * _270;
    float _299 = (_296 > 0.0) ? min(_296, 255.0) : 0.0;
    float _303 = min(min(_299 / (_299 + 1.0), _291), ((_291 * _288) * _288) * ((-2.0) * _288 + 3.0));
    bvec2 _307 = bvec2(all(lessThanEqual(abs(_113), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _308 = vec2(_307.x ? _113.x : vec2(0.0).x, _307.y ? _113.y : vec2(0.0).y);
    vec2 _315 = _308 + ((_255 - _308) * clamp(_303, 0.0, 1.0));
    bvec2 _316 = bvec2(all(lessThanEqual(abs(_255), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _317 = vec2(_316.x ? _315.x : _308.x, _316.y ? _315.y : _308.y);
    bvec2 _319 = bvec2(_303 > 0.0);
    vec2 _320 = vec2(_319.x ? _317.x : _113.x, _319.y ? _317.y : _113.y);
    float _329 = _320.x;
    float _330 = _320.y;
    gOutCache = vec4(((_330 > 0.0) ? min(_330, 1.0) : 0.0) * 0.984375 + floor(((_329 > 0.0) ? min(_329, 1.0) : 0.0) * 31.0 + 0.5), _117, 0.0, 0.0);
    gOutCacheState = vec4(min(((_263 > 0.0) ? min(_263, 255.0) : 0.0) * ((_270 > 0.0) ? min(_270, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

