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
    float _114 = abs(_88);
    float _117 = ((parameters.gHistoryValid > 0.5) && (_114 <= 65504.0)) ? (((_102 > 0.0) && all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5)))) ? min(_102, 1.0) : 0.0) : 0.0;
    float _130 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _132 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_60) * parameters.gOutputSize.xy));
    float _136 = ((_132 > 0.0) ? min(_132, _130) : 0.0) / _130;
    float _139 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _144 = _92 * _117;
    float _147 = (_144 > 0.0) ? min(_144, 255.0) : 0.0;
    float _151 = min(min(_147 / (_147 + 1.0), _139), ((_139 * _136) * _136) * fma(-2.0, _136, 3.0));
    float _154 = (abs(_69) <= 9.9999996802856924650656260769173e+37) ? _69 : 0.0;
    gOutCache = vec4((_151 > 0.0) ? ((_114 <= 9.9999996802856924650656260769173e+37) ? fma(_88 - _154, clamp(_151, 0.0, 1.0), _154) : _154) : _69, _73, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_92 > 0.0) ? min(_92, 255.0) : 0.0, (_117 > 0.0) ? min(_117, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

