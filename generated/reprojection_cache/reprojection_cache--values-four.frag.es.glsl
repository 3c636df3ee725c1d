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
uniform highp sampler2D gHistoryCacheFiltered;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _77 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _81 = textureLod(gInFresh, _77, 0.0);
    vec4 _85 = textureLod(gInCoarseDepth, _77, 0.0);
    float _86 = _85.x;
    bvec4 _88 = lessThanEqual(abs(_81), vec4(65504.0));
    vec4 _89 = vec4(_88.x ? _81.x : vec4(0.0).x, _88.y ? _81.y : vec4(0.0).y, _88.z ? _81.z : vec4(0.0).z, _88.w ? _81.w : vec4(0.0).w);
    float _93 = ((_86 > 0.0) && (_86 < 65504.0)) ? _86 : 65504.0;
    vec4 _105 = parameters.gViewToPreviousClip * vec4((_77 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _93, _93, 1.0);
    float _108 = _105.w;
    vec2 _113 = (_105.xy * (1.0 / _108)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _118 = bvec2((_108 > 0.0) && all(lessThanEqual(abs(_113), vec2(8.0))));
    vec2 _119 = vec2(_118.x ? _113.x : vec2(-8.0).x, _118.y ? _113.y : vec2(-8.0).y);
    float _121 = dot(_105.zw, parameters.gClipToDepth);
    vec2 _127 = _119 * parameters.gFrameToCoarse;
    float _133 = max(parameters.gMissThreshold.y * _93 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _137 = textureLod(gHistoryCacheFiltered, _127, 0.0);
    vec4 _141 = textureLod(gHistoryCacheStateFiltered, _127, 0.0);
    float _142 = _141.x;
    float _145 = (_142 > 0.0) ? min(_142, 255.0) : 0.0;
    float _152 = _133 - abs(((abs(_121) <= 9.9999996802856924650656260769173e+37) ? _121 : 0.0) - _141.y);
    float _155 = (_152 > 0.0) ? (_152 * (parameters.gConvergenceTime / _133)) : 0.0;
    vec4 _167 = abs(_137);
    float _171 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_167, vec4(65504.0)))) ? (((_155 > 0.0) && all(lessThanEqual(abs(_119 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_155, 1.0) : 0.0) : 0.0;
    float _184 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _186 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_127)) * parameters.gOutputSize.xy));
    float _190 = ((_186 > 0.0) ? min(_186, _184) : 0.0) / _184;
    float _193 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _198 = _145 * _171;
    float _201 = (_198 > 0.0) ? min(_198, 255.0) : 0.0;
    float _205 = min(min(_201 / (_201 + 1.0), _193), ((_193 * _190) * _190) * ((-2.0) * _190 + 3.0));
    bvec4 _209 = bvec4(all(lessThanEqual(abs(_89), vec4(9.9999996802856924650656260769173e+37))));
    vec4 _210 = vec4(_209.x ? _89.x : vec4(0.0).x, _209.y ? _89.y : vec4(0.0).y, _209.z ? _89.z : vec4(0.0).z, _209.w ? _89.w : vec4(0.0).w);
    vec4 _216 = _210 + ((_137 - _210) * clamp(_205, 0.0, 1.0));
    bvec4 _217 = bvec4(all(lessThanEqual(_167, vec4(9.9999996802856924650656260769173e+37))));
    vec4 _218 = vec4(_217.x ? _216.x : _210.x, _217.y ? _216.y : _210.y, _217.z ? _216.z : _210.z, _217.w ? _216.w : _210.w);
    bvec4 _220 = bvec4(_205 > 0.0);
    gOutCache = vec4(_220.x ? _218.x : _89.x, _220.y ? _218.y : _89.y, _220.z ? _218.z : _89.z, _220.w ? _218.w : _89.w);
    gOutCacheState = vec4(min(((_145 > 0.0) ? min(_145, 255.0) : 0.0) * ((_171 > 0.0) ? min(_171, 1.0) : 0.0) + 1.0, 255.0), _93, 0.0, 0.0);
}

