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
layout(binding = 7) uniform sampler2D gInCoarseDepth;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _78 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _86 = textureLod(gInCoarseDepth, _78, 0.0);
    float _87 = _86.x;
    vec2 _88 = textureLod(gInFresh, _78, 0.0).xy;
    vec2 _91 = mix(vec2(0.0), _88, lessThanEqual(abs(_88), vec2(65504.0)));
    float _95 = ((_87 > 0.0) && (_87 < 65504.0)) ? _87 : 65504.0;
    vec4 _107 = parameters.gViewToPreviousClip * vec4(fma(_78, parameters.gViewRay.xy, parameters.gViewRay.zw) * _95, _95, 1.0);
    float _110 = _107.w;
    vec2 _115 = fma(_107.xy * (1.0 / _110), vec2(0.5, -0.5), vec2(0.5));
    float _123 = dot(_107.zw, parameters.gClipToDepth);
    vec2 _129 = mix(vec2(-8.0), _115, bvec2((_110 > 0.0) && all(lessThanEqual(abs(_115), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _135 = max(fma(parameters.gMissThreshold.y, _95, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _143 = textureLod(gHistoryCacheStateFiltered, _129, 0.0);
    vec2 _144 = textureLod(gHistoryCacheFiltered, _129, 0.0).xy;
    float _145 = _143.x;
    float _148 = (_145 > 0.0) ? min(_145, 255.0) : 0.0;
    float _155 = _135 - abs(((abs(_123) <= 9.9999996802856924650656260769173e+37) ? _123 : 0.0) - _143.y);
    float _158 = (_155 > 0.0) ? (_155 * (parameters.gConvergenceTime / _135)) : 0.0;
    vec2 _169 = abs(_144);
    float _173 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_169, vec2(65504.0)))) ? (((_158 > 0.0) && all(lessThanEqual(floatBitsToUint(_129), uvec2(1065353216u)))) ? min(_158, 1.0) : 0.0) : 0.0;
    float _186 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _188 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_129) * parameters.gOutputSize.xy));
    float _192 = ((_188 > 0.0) ? min(_188, _186) : 0.0) / _186;
    float _195 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _200 = _148 * _173;
    float _203 = (_200 > 0.0) ? min(_200, 255.0) : 0.0;
    float _207 = min(min(_203 / (_203 + 1.0), _195), ((_195 * _192) * _192) * fma(-2.0, _192, 3.0));
    vec2 _212 = mix(vec2(0.0), _91, bvec2(all(lessThanEqual(abs(_91), vec2(9.9999996802856924650656260769173e+37)))));
    gOutCache = vec4(mix(_91, mix(_212, _212 + ((_144 - _212) * clamp(_207, 0.0, 1.0)), bvec2(all(lessThanEqual(_169, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_207 > 0.0)), 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_148 > 0.0) ? min(_148, 255.0) : 0.0, (_173 > 0.0) ? min(_173, 1.0) : 0.0, 1.0), 255.0), _95, 0.0, 0.0);
}

