#version 450

layout(binding = 0, std140) uniform ReprojectionCacheParameters
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

layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 5) uniform sampler2D gHistoryCacheState;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _60 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _64 = textureLod(gInFresh, _60, 0.0);
    float _65 = _64.y;
    float _66 = _64.x;
    float _69 = (abs(_66) <= 65504.0) ? _66 : 0.0;
    float _73 = ((_65 > 0.0) && (_65 < 65504.0)) ? _65 : 65504.0;
    float _79 = max(fma(parameters.gMissThreshold.y, _73, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _83 = textureLod(gHistoryCache, _60, 0.0);
    vec4 _87 = textureLod(gHistoryCacheState, _60, 0.0);
    float _88 = _83.x;
    float _89 = _87.x;
    float _92 = (_89 > 0.0) ? min(_89, 255.0) : 0.0;
    float _99 = _79 - abs(_73 - _83.y);
    float _102 = (_99 > 0.0) ? (_99 * (parameters.gConvergenceTime / _79)) : 0.0;
    float _113 = abs(_88);
    float _116 = ((parameters.gHistoryValid > 0.5) && (_113 <= 65504.0)) ? (((_102 > 0.0) && all(lessThanEqual(floatBitsToUint(_60), uvec2(1065353216u)))) ? min(_102, 1.0) : 0.0) : 0.0;
    float _129 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _131 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_60) * parameters.gOutputSize.xy));
    float _135 = ((_131 > 0.0) ? min(_131, _129) : 0.0) / _129;
    float _138 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _143 = _92 * _116;
    float _146 = (_143 > 0.0) ? min(_143, 255.0) : 0.0;
    float _150 = min(min(_146 / (_146 + 1.0), _138), ((_138 * _135) * _135) * fma(-2.0, _135, 3.0));
    float _153 = (abs(_69) <= 9.9999996802856924650656260769173e+37) ? _69 : 0.0;
    gOutCache = vec4((_150 > 0.0) ? ((_113 <= 9.9999996802856924650656260769173e+37) ? fma(_88 - _153, clamp(_150, 0.0, 1.0), _153) : _153) : _69, _73, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_92 > 0.0) ? min(_92, 255.0) : 0.0, (_116 > 0.0) ? min(_116, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

