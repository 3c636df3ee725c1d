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
layout(binding = 2) uniform sampler2D gInVelocity;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _74 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _78 = textureLod(gInFresh, _74, 0.0);
    float _79 = _78.y;
    float _80 = _78.x;
    float _83 = (abs(_80) <= 65504.0) ? _80 : 0.0;
    float _87 = ((_79 > 0.0) && (_79 < 65504.0)) ? _79 : 65504.0;
    vec2 _90 = _74 / parameters.gFrameToCoarse;
    float _106 = dot((parameters.gViewToPreviousClip * vec4(fma(_74, parameters.gViewRay.xy, parameters.gViewRay.zw) * _87, _87, 1.0)).zw, parameters.gClipToDepth);
    float _109 = (abs(_106) <= 9.9999996802856924650656260769173e+37) ? _106 : 0.0;
    vec2 _121 = fma(-textureLod(gInVelocity, _90 - ((parameters.gOutputSize.zw * 0.125) / parameters.gFrameToCoarse), 0.0).xy, parameters.gMotionToUv, _90);
    vec2 _130 = mix(vec2(-8.0), _121, bvec2(all(lessThanEqual(abs(_121), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _136 = max(fma(parameters.gMissThreshold.y, _87, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _140 = textureLod(gHistoryCacheFiltered, _130, 0.0);
    vec4 _144 = textureLod(gHistoryCacheStateFiltered, _130, 0.0);
    float _145 = _140.x;
    float _146 = _144.x;
    float _149 = (_146 > 0.0) ? min(_146, 255.0) : 0.0;
    float _156 = _136 - abs(((abs(_109) <= 9.9999996802856924650656260769173e+37) ? _109 : 0.0) - _140.y);
    float _159 = (_156 > 0.0) ? (_156 * (parameters.gConvergenceTime / _136)) : 0.0;
    float _170 = abs(_145);
    float _173 = ((parameters.gHistoryValid > 0.5) && (_170 <= 65504.0)) ? (((_159 > 0.0) && all(lessThanEqual(floatBitsToUint(_130), uvec2(1065353216u)))) ? min(_159, 1.0) : 0.0) : 0.0;
    float _186 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _188 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_130) * parameters.gOutputSize.xy));
    float _192 = ((_188 > 0.0) ? min(_188, _186) : 0.0) / _186;
    float _195 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _200 = _149 * _173;
    float _203 = (_200 > 0.0) ? min(_200, 255.0) : 0.0;
    float _207 = min(min(_203 / (_203 + 1.0), _195), ((_195 * _192) * _192) * fma(-2.0, _192, 3.0));
    float _210 = (abs(_83) <= 9.9999996802856924650656260769173e+37) ? _83 : 0.0;
    gOutCache = vec4((_207 > 0.0) ? ((_170 <= 9.9999996802856924650656260769173e+37) ? fma(_145 - _210, clamp(_207, 0.0, 1.0), _210) : _210) : _83, _87, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_149 > 0.0) ? min(_149, 255.0) : 0.0, (_173 > 0.0) ? min(_173, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

