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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 3) uniform sampler2D gHistoryCache;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _86 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _90 = textureLod(gInFresh, _86, 0.0);
    float _91 = _90.y;
    float _92 = _90.x;
    float _97 = (_92 > 0.0) ? min(_92, 31.984375) : 0.0;
    float _98 = floor(_97);
    vec2 _106 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_98 * 0.0322580635547637939453125, (_97 - _98) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_92) <= 65504.0));
    vec2 _109 = mix(vec2(0.0), _106, lessThanEqual(abs(_106), vec2(65504.0)));
    float _113 = ((_91 > 0.0) && (_91 < 65504.0)) ? _91 : 65504.0;
    vec4 _125 = parameters.gViewToPreviousClip * vec4(fma(_86, parameters.gViewRay.xy, parameters.gViewRay.zw) * _113, _113, 1.0);
    float _128 = _125.w;
    vec2 _133 = fma(_125.xy * (1.0 / _128), vec2(0.5, -0.5), vec2(0.5));
    vec2 _139 = mix(vec2(-8.0), _133, bvec2((_128 > 0.0) && all(lessThanEqual(abs(_133), vec2(8.0)))));
    float _141 = dot(_125.zw, parameters.gClipToDepth);
    vec2 _147 = _139 * parameters.gFrameToCoarse;
    vec4 _151 = textureLod(gHistoryCacheStateFiltered, _147, 0.0);
    vec2 _153 = fma(_147, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _155 = floor(_153) + vec2(0.5);
    vec2 _156 = _155 * parameters.gOutputSize.zw;
    vec2 _157 = fma(_155, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _158 = fract(_153);
    vec2 _159 = vec2(1.0) - _158;
    vec4 _163 = textureLod(gHistoryCache, _156, 0.0);
    float _164 = _163.x;
    float _169 = (_164 > 0.0) ? min(_164, 31.984375) : 0.0;
    float _170 = floor(_169);
    vec4 _182 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_170 * 0.0322580635547637939453125, (_169 - _170) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_164) <= 65504.0)), _163.y, 0.0);
    vec4 _187 = textureLod(gHistoryCache, vec2(_157.x, _156.y), 0.0);
    float _188 = _187.x;
    float _193 = (_188 > 0.0) ? min(_188, 31.984375) : 0.0;
    float _194 = floor(_193);
    vec4 _206 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_194 * 0.0322580635547637939453125, (_193 - _194) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_188) <= 65504.0)), _187.y, 0.0);
    vec4 _211 = textureLod(gHistoryCache, vec2(_156.x, _157.y), 0.0);
    float _212 = _211.x;
    float _217 = (_212 > 0.0) ? min(_212, 31.984375) : 0.0;
    float _218 = floor(_217);
    vec4 _230 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_218 * 0.0322580635547637939453125, (_217 - _218) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_212) <= 65504.0)), _211.y, 0.0);
    vec4 _232 = textureLod(gHistoryCache, _157, 0.0);
    float _233 = _232.x;
    float _238 = (_233 > 0.0) ? min(_233, 31.984375) : 0.0;
    float _239 = floor(_238);
    vec4 _251 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_239 * 0.0322580635547637939453125, (_238 - _239) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_233) <= 65504.0)), _232.y, 0.0);
    float _252 = _159.x;
    float _253 = _158.x;
    bool _261 = all(lessThanEqual(abs(_182), vec4(9.9999996802856924650656260769173e+37)));
    bool _265 = all(lessThanEqual(abs(_206), vec4(9.9999996802856924650656260769173e+37)));
    bool _269 = all(lessThanEqual(abs(_230), vec4(9.9999996802856924650656260769173e+37)));
    bool _273 = all(lessThanEqual(abs(_251), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _276 = (vec4(_252, _253, _252, _253) * vec4(_159.yy, _158.yy)) * vec4(float(_261), float(_265), float(_269), float(_273));
    float _296 = dot(_276, vec4(1.0));
    vec4 _301 = mix(vec4(0.0), ((((mix(vec4(0.0), _182, bvec4(_261)) * _276.x) + (mix(vec4(0.0), _206, bvec4(_265)) * _276.y)) + (mix(vec4(0.0), _230, bvec4(_269)) * _276.z)) + (mix(vec4(0.0), _251, bvec4(_273)) * _276.w)) / vec4(_296), bvec4(_296 > 9.9999999747524270787835121154785e-07));
    vec2 _302 = _301.xy;
    float _304 = _151.x;
    float _307 = (_304 > 0.0) ? min(_304, 255.0) : 0.0;
    float _313 = max(fma(parameters.gMissThreshold.y, _113, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _319 = _313 - abs(((abs(_141) <= 9.9999996802856924650656260769173e+37) ? _141 : 0.0) - _301.z);
    float _322 = (_319 > 0.0) ? (_319 * (parameters.gConvergenceTime / _313)) : 0.0;
    vec2 _334 = abs(_302);
    float _338 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_334, vec2(65504.0)))) ? (((_322 > 0.0) && all(lessThanEqual(abs(fma(_139, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_322, 1.0) : 0.0) : 0.0;
    float _350 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _352 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_147) * parameters.gOutputSize.xy));
    float _356 = ((_352 > 0.0) ? min(_352, _350) : 0.0) / _350;
    float _359 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _364 = _307 * _338;
    float _367 = (_364 > 0.0) ? min(_364, 255.0) : 0.0;
    float _371 = min(min(_367 / (_367 + 1.0), _359), ((_359 * _356) * _356) * fma(-2.0, _356, 3.0));
    vec2 _376 = mix(vec2(0.0), _109, bvec2(all(lessThanEqual(abs(_109), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _387 = mix(_109, mix(_376, _376 + ((_302 - _376) * clamp(_371, 0.0, 1.0)), bvec2(all(lessThanEqual(_334, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_371 > 0.0));
    float _396 = _387.x;
    float _397 = _387.y;
    gOutCache = vec4(fma((_396 > 0.0) ? min(_396, 1.0) : 0.0, 0.984375, floor(fma((_397 > 0.0) ? min(_397, 1.0) : 0.0, 31.0, 0.5))), _113, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_307 > 0.0) ? min(_307, 255.0) : 0.0, (_338 > 0.0) ? min(_338, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

