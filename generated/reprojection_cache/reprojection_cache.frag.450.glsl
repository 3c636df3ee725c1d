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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _77 = textureLod(gInFresh, _73, 0.0);
    float _78 = _77.y;
    float _79 = _77.x;
    float _82 = (abs(_79) <= 65504.0) ? _79 : 0.0;
    float _86 = ((_78 > 0.0) && (_78 < 65504.0)) ? _78 : 65504.0;
    vec4 _98 = parameters.gViewToPreviousClip * vec4(fma(_73, parameters.gViewRay.xy, parameters.gViewRay.zw) * _86, _86, 1.0);
    float _101 = _98.w;
    vec2 _106 = fma(_98.xy * (1.0 / _101), vec2(0.5, -0.5), vec2(0.5));
    float _114 = dot(_98.zw, parameters.gClipToDepth);
    vec2 _120 = mix(vec2(-8.0), _106, bvec2((_101 > 0.0) && all(lessThanEqual(abs(_106), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _126 = max(fma(parameters.gMissThreshold.y, _86, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _130 = textureLod(gHistoryCacheFiltered, _120, 0.0);
    vec4 _134 = textureLod(gHistoryCacheStateFiltered, _120, 0.0);
    float _135 = _130.x;
    float _136 = _134.x;
    float _139 = (_136 > 0.0) ? min(_136, 255.0) : 0.0;
    float _146 = _126 - abs(((abs(_114) <= 9.9999996802856924650656260769173e+37) ? _114 : 0.0) - _130.y);
    float _149 = (_146 > 0.0) ? (_146 * (parameters.gConvergenceTime / _126)) : 0.0;
    float _160 = abs(_135);
    float _163 = ((parameters.gHistoryValid > 0.5) && (_160 <= 65504.0)) ? (((_149 > 0.0) && all(lessThanEqual(floatBitsToUint(_120), uvec2(1065353216u)))) ? min(_149, 1.0) : 0.0) : 0.0;
    float _176 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _178 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_120) * parameters.gOutputSize.xy));
    float _182 = ((_178 > 0.0) ? min(_178, _176) : 0.0) / _176;
    float _185 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _190 = _139 * _163;
    float _193 = (_190 > 0.0) ? min(_190, 255.0) : 0.0;
    float _197 = min(min(_193 / (_193 + 1.0), _185), ((_185 * _182) * _182) * fma(-2.0, _182, 3.0));
    float _200 = (abs(_82) <= 9.9999996802856924650656260769173e+37) ? _82 : 0.0;
    gOutCache = vec4((_197 > 0.0) ? ((_160 <= 9.9999996802856924650656260769173e+37) ? fma(_135 - _200, clamp(_197, 0.0, 1.0), _200) : _200) : _82, _86, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_139 > 0.0) ? min(_139, 255.0) : 0.0, (_163 > 0.0) ? min(_163, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

