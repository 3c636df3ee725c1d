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
uniform highp sampler2D gHistoryCacheFiltered;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _71 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _75 = textureLod(gInFresh, _71, 0.0);
    float _76 = _75.y;
    float _77 = _75.x;
    float _80 = (abs(_77) <= 65504.0) ? _77 : 0.0;
    float _84 = ((_76 > 0.0) && (_76 < 65504.0)) ? _76 : 65504.0;
    vec4 _95 = parameters.gViewToPreviousClip * vec4(_71 * parameters.gViewRay.xy + parameters.gViewRay.zw, _84, 1.0);
    float _98 = _95.w;
    vec2 _103 = (_95.xy * (1.0 / _98)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _108 = bvec2((_98 > 0.0) && all(lessThanEqual(abs(_103), vec2(8.0))));
    vec2 _109 = vec2(_108.x ? _103.x : vec2(-8.0).x, _108.y ? _103.y : vec2(-8.0).y);
    float _111 = dot(_95.zw, parameters.gClipToDepth);
    vec2 _117 = _109 * parameters.gFrameToCoarse;
    float _123 = max(parameters.gMissThreshold.y * _84 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _127 = textureLod(gHistoryCacheFiltered, _117, 0.0);
    vec4 _131 = textureLod(gHistoryCacheStateFiltered, _117, 0.0);
    float _132 = _127.x;
    float _133 = _131.x;
    float _136 = (_133 > 0.0) ? min(_133, 255.0) : 0.0;
    float _143 = _123 - abs(((abs(_111) <= 9.9999996802856924650656260769173e+37) ? _111 : 0.0) - _127.y);
    float _146 = (_143 > 0.0) ? (_143 * (parameters.gConvergenceTime / _123)) : 0.0;
    float _158 = abs(_132);
    float _161 = ((parameters.gHistoryValid > 0.5) && (_158 <= 65504.0)) ? (((_146 > 0.0) && all(lessThanEqual(abs(_109 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_146, 1.0) : 0.0) : 0.0;
    float _174 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _176 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_117)) * parameters.gOutputSize.xy));
    float _180 = ((_176 > 0.0) ? min(_176, _174) : 0.0) / _174;
    float _183 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _188 = _136 * _161;
    float _191 = (_188 > 0.0) ? min(_188, 255.0) : 0.0;
    float _195 = min(min(_191 / (_191 + 1.0), _183), ((_183 * _180) * _180) * ((-2.0) * _180 + 3.0));
    float _198 = (abs(_80) <= 9.9999996802856924650656260769173e+37) ? _80 : 0.0;
    gOutCache = vec4((_195 > 0.0) ? ((_158 <= 9.9999996802856924650656260769173e+37) ? ((_132 - _198) * clamp(_195, 0.0, 1.0) + _198) : _198) : _80, _84, 0.0, 0.0);
    gOutCacheState = vec4(min(((_136 > 0.0) ? min(_136, 255.0) : 0.0) * ((_161 > 0.0) ? min(_161, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

