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
    vec2 _84 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _88 = textureLod(gInFresh, _84, 0.0);
    float _89 = _88.y;
    float _90 = _88.x;
    float _95 = (_90 > 0.0) ? min(_90, 31.984375) : 0.0;
    float _96 = floor(_95);
    vec2 _103 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_96 * 0.0322580635547637939453125, (_95 - _96) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_90) <= 65504.0));
    vec2 _106 = mix(vec2(0.0), _103, lessThanEqual(abs(_103), vec2(65504.0)));
    float _110 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
    vec4 _122 = parameters.gViewToPreviousClip * vec4(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw) * _110, _110, 1.0);
    float _125 = _122.w;
    vec2 _130 = fma(_122.xy * (1.0 / _125), vec2(0.5, -0.5), vec2(0.5));
    vec2 _136 = mix(vec2(-8.0), _130, bvec2((_125 > 0.0) && all(lessThanEqual(abs(_130), vec2(8.0)))));
    float _138 = dot(_122.zw, parameters.gClipToDepth);
    vec2 _144 = _136 * parameters.gFrameToCoarse;
    vec4 _148 = textureLod(gHistoryCacheStateFiltered, _144, 0.0);
    vec2 _150 = fma(_144, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _152 = floor(_150) + vec2(0.5);
    vec2 _153 = _152 * parameters.gOutputSize.zw;
    vec2 _154 = fma(_152, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _155 = fract(_150);
    vec2 _156 = vec2(1.0) - _155;
    vec4 _160 = textureLod(gHistoryCache, _153, 0.0);
    float _161 = _160.x;
    float _166 = (_161 > 0.0) ? min(_161, 31.984375) : 0.0;
    float _167 = floor(_166);
    vec4 _178 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_167 * 0.0322580635547637939453125, (_166 - _167) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_161) <= 65504.0)), _160.y, 0.0);
    vec4 _183 = textureLod(gHistoryCache, vec2(_154.x, _153.y), 0.0);
    float _184 = _183.x;
    float _189 = (_184 > 0.0) ? min(_184, 31.984375) : 0.0;
    float _190 = floor(_189);
    vec4 _201 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_190 * 0.0322580635547637939453125, (_189 - _190) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_184) <= 65504.0)), _183.y, 0.0);
    vec4 _206 = textureLod(gHistoryCache, vec2(_153.x, _154.y), 0.0);
    float _207 = _206.x;
    float _212 = (_207 > 0.0) ? min(_207, 31.984375) : 0.0;
    float _213 = floor(_212);
    vec4 _224 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_213 * 0.0322580635547637939453125, (_212 - _213) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_207) <= 65504.0)), _206.y, 0.0);
    vec4 _226 = textureLod(gHistoryCache, _154, 0.0);
    float _227 = _226.x;
    float _232 = (_227 > 0.0) ? min(_227, 31.984375) : 0.0;
    float _233 = floor(_232);
    vec4 _244 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_233 * 0.0322580635547637939453125, (_232 - _233) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_227) <= 65504.0)), _226.y, 0.0);
    float _245 = _156.x;
    float _246 = _155.x;
    bool _254 = all(lessThanEqual(abs(_178), vec4(9.9999996802856924650656260769173e+37)));
    bool _258 = all(lessThanEqual(abs(_201), vec4(9.9999996802856924650656260769173e+37)));
    bool _262 = all(lessThanEqual(abs(_224), vec4(9.9999996802856924650656260769173e+37)));
    bool _266 = all(lessThanEqual(abs(_244), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _269 = (vec4(_245, _246, _245, _246) * vec4(_156.yy, _155.yy)) * vec4(float(_254), float(_258), float(_262), float(_266));
    float _289 = dot(_269, vec4(1.0));
    vec4 _294 = mix(vec4(0.0), ((((mix(vec4(0.0), _178, bvec4(_254)) * _269.x) + (mix(vec4(0.0), _201, bvec4(_258)) * _269.y)) + (mix(vec4(0.0), _224, bvec4(_262)) * _269.z)) + (mix(vec4(0.0), _244, bvec4(_266)) * _269.w)) / vec4(_289), bvec4(_289 > 9.9999999747524270787835121154785e-07));
    vec2 _295 = _294.xy;
    float _297 = _148.x;
    float _300 = (_297 > 0.0) ? min(_297, 255.0) : 0.0;
    float _306 = max(fma(parameters.gMissThreshold.y, _110, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _312 = _306 - abs(((abs(_138) <= 9.9999996802856924650656260769173e+37) ? _138 : 0.0) - _294.z);
    float _315 = (_312 > 0.0) ? (_312 * (parameters.gConvergenceTime / _306)) : 0.0;
    vec2 _327 = abs(_295);
    float _331 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_327, vec2(65504.0)))) ? (((_315 > 0.0) && all(lessThanEqual(abs(fma(_136, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_315, 1.0) : 0.0) : 0.0;
    float _343 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _345 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_144) * parameters.gOutputSize.xy));
    float _349 = ((_345 > 0.0) ? min(_345, _343) : 0.0) / _343;
    float _352 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _357 = _300 * _331;
    float _360 = (_357 > 0.0) ? min(_357, 255.0) : 0.0;
    float _364 = min(min(_360 / (_360 + 1.0), _352), ((_352 * _349) * _349) * fma(-2.0, _349, 3.0));
    vec2 _369 = mix(vec2(0.0), _106, bvec2(all(lessThanEqual(abs(_106), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _380 = mix(_106, mix(_369, _369 + ((_295 - _369) * clamp(_364, 0.0, 1.0)), bvec2(all(lessThanEqual(_327, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_364 > 0.0));
    float _389 = _380.x;
    float _390 = _380.y;
    gOutCache = vec4(fma((_390 > 0.0) ? min(_390, 1.0) : 0.0, 0.984375, floor(fma((_389 > 0.0) ? min(_389, 1.0) : 0.0, 31.0, 0.5))), _110, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_300 > 0.0) ? min(_300, 255.0) : 0.0, (_331 > 0.0) ? min(_331, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

