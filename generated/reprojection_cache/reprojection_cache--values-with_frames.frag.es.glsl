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
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gHistoryCache;
uniform highp sampler2D gHistoryCoarseDepth;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _96 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _104 = textureLod(gInCoarseDepth, _96, 0.0);
    float _105 = _104.x;
    vec2 _106 = textureLod(gInFresh, _96, 0.0).xy;
    bvec2 _108 = lessThanEqual(abs(_106), vec2(65504.0));
    vec2 _109 = vec2(_108.x ? _106.x : vec2(0.0).x, _108.y ? _106.y : vec2(0.0).y);
    float _113 = ((_105 > 0.0) && (_105 < 65504.0)) ? _105 : 65504.0;
    vec4 _125 = parameters.gViewToPreviousClip * vec4((_96 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _113, _113, 1.0);
    float _128 = _125.w;
    vec2 _133 = (_125.xy * (1.0 / _128)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _138 = bvec2((_128 > 0.0) && all(lessThanEqual(abs(_133), vec2(8.0))));
    float _141 = dot(_125.zw, parameters.gClipToDepth);
    vec2 _147 = vec2(_138.x ? _133.x : vec2(-8.0).x, _138.y ? _133.y : vec2(-8.0).y) * parameters.gFrameToCoarse;
    float _153 = max(parameters.gMissThreshold.y * _113 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _155 = _147 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _156 = floor(_155);
    vec2 _157 = _155 - _156;
    vec2 _158 = vec2(1.0) - _157;
    float _159 = _158.x;
    float _160 = _157.x;
    vec2 _167 = (_156 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec2 _179 = (_156 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec2 _187 = (_156 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec2 _195 = (_156 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _199 = vec4(textureLod(gHistoryCache, _167, 0.0).x, textureLod(gHistoryCache, _179, 0.0).x, textureLod(gHistoryCache, _187, 0.0).x, textureLod(gHistoryCache, _195, 0.0).x);
    vec4 _211 = vec4(_153) - abs(vec4((abs(_141) <= 9.9999996802856924650656260769173e+37) ? _141 : 0.0) - vec4(textureLod(gHistoryCoarseDepth, _167, 0.0).x, textureLod(gHistoryCoarseDepth, _179, 0.0).x, textureLod(gHistoryCoarseDepth, _187, 0.0).x, textureLod(gHistoryCoarseDepth, _195, 0.0).x));
    vec4 _212 = _211 * (parameters.gConvergenceTime / _153);
    bvec4 _213 = greaterThan(_211, vec4(0.0));
    vec4 _214 = vec4(_213.x ? _212.x : vec4(0.0).x, _213.y ? _212.y : vec4(0.0).y, _213.z ? _212.z : vec4(0.0).z, _213.w ? _212.w : vec4(0.0).w);
    vec4 _215 = min(_214, vec4(1.0));
    bvec4 _216 = greaterThan(_214, vec4(0.0));
    bvec4 _220 = bvec4(all(lessThanEqual(floatBitsToUint(_147), uvec2(1065353216u))));
    bvec4 _221 = bvec4(_216.x && _220.x, _216.y && _220.y, _216.z && _220.z, _216.w && _220.w);
    bvec4 _223 = greaterThanEqual(_199, vec4(0.0));
    bvec4 _224 = lessThan(_199, vec4(16777216.0));
    vec4 _226 = vec4(bvec4(_223.x && _224.x, _223.y && _224.y, _223.z && _224.z, _223.w && _224.w));
    bvec4 _227 = greaterThan(_226, vec4(0.5));
    vec4 _228 = vec4(_227.x ? _199.x : vec4(0.0).x, _227.y ? _199.y : vec4(0.0).y, _227.z ? _199.z : vec4(0.0).z, _227.w ? _199.w : vec4(0.0).w);
    vec4 _230 = floor(_228 * 9.5367431640625e-07);
    vec4 _232 = _228 - (_230 * 1048576.0);
    vec4 _234 = floor(_232 * 0.0009765625);
    vec4 _240 = vec4(_221.x ? _215.x : vec4(0.0).x, _221.y ? _215.y : vec4(0.0).y, _221.z ? _215.z : vec4(0.0).z, _221.w ? _215.w : vec4(0.0).w) * _226;
    vec4 _241 = (vec4(_159, _160, _159, _160) * vec4(_158.yy, _157.yy)) * _240;
    vec4 _245 = _241 * (1.0 / max(dot(_241, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _249 = vec2(dot(_245, _234 * 0.000977517105638980865478515625), dot(_245, min((_232 - (_234 * 1024.0)) * 0.000977517105638980865478515625, vec4(1.0))));
    float _250 = dot(_245, _230);
    vec2 _254 = abs(_249);
    float _258 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_254, vec2(65504.0)))) ? dot(_245, _240) : 0.0;
    float _270 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _272 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_147)) * parameters.gOutputSize.xy));
    float _276 = ((_272 > 0.0) ? min(_272, _270) : 0.0) / _270;
    float _279 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _284 = _250 * _258;
    float _287 = (_284 > 0.0) ? min(_284, 255.0) : 0.0;
    float _291 = min(min(_287 / (_287 + 1.0), _279), ((_279 * _276) * _276) * ((-2.0) * _276 + 3.0));
    bvec2 _295 = bvec2(all(lessThanEqual(abs(_109), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _296 = vec2(_295.x ? _109.x : vec2(0.0).x, _295.y ? _109.y : vec2(0.0).y);
    vec2 _302 = _296 + ((_249 - _296) * clamp(_291, 0.0, 1.0));
    bvec2 _303 = bvec2(all(lessThanEqual(_254, vec2(9.9999996802856924650656260769173e+37))));
    vec2 _304 = vec2(_303.x ? _302.x : _296.x, _303.y ? _302.y : _296.y);
    bvec2 _306 = bvec2(_291 > 0.0);
    vec2 _307 = vec2(_306.x ? _304.x : _109.x, _306.y ? _304.y : _109.y);
    float _315 = min(((_250 > 0.0) ? min(_250, 255.0) : 0.0) * ((_258 > 0.0) ? min(_258, 1.0) : 0.0) + 1.0, 255.0);
    float _316 = _307.x;
    float _320 = _307.y;
    vec2 _327 = floor((vec2((_316 > 0.0) ? min(_316, 1.0) : 0.0, (_320 > 0.0) ? min(_320, 1.0) : 0.0) * 1023.0) + vec2(0.5));
    gOutCache = vec4((floor(((_315 > 0.0) ? min(_315, 15.0) : 0.0) + 0.5) * 1024.0 + _327.x) * 1024.0 + _327.y, 0.0, 0.0, 0.0);
}

