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
    vec2 _104 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_96 * 0.0322580635547637939453125, (_95 - _96) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_90) <= 65504.0));
    vec2 _107 = mix(vec2(0.0), _104, lessThanEqual(abs(_104), vec2(65504.0)));
    float _111 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
    vec4 _123 = parameters.gViewToPreviousClip * vec4(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw) * _111, _111, 1.0);
    float _126 = _123.w;
    vec2 _131 = fma(_123.xy * (1.0 / _126), vec2(0.5, -0.5), vec2(0.5));
    vec2 _137 = mix(vec2(-8.0), _131, bvec2((_126 > 0.0) && all(lessThanEqual(abs(_131), vec2(8.0)))));
    float _139 = dot(_123.zw, parameters.gClipToDepth);
    vec2 _145 = _137 * parameters.gFrameToCoarse;
    vec4 _149 = textureLod(gHistoryCacheStateFiltered, _145, 0.0);
    vec2 _151 = fma(_145, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _153 = floor(_151) + vec2(0.5);
    vec2 _154 = _153 * parameters.gOutputSize.zw;
    vec2 _155 = fma(_153, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _156 = fract(_151);
    vec2 _157 = vec2(1.0) - _156;
    vec4 _161 = textureLod(gHistoryCache, _154, 0.0);
    float _162 = _161.x;
    float _167 = (_162 > 0.0) ? min(_162, 31.984375) : 0.0;
    float _168 = floor(_167);
    vec4 _180 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_168 * 0.0322580635547637939453125, (_167 - _168) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_162) <= 65504.0)), _161.y, 0.0);
    vec4 _185 = textureLod(gHistoryCache, vec2(_155.x, _154.y), 0.0);
    float _186 = _185.x;
    float _191 = (_186 > 0.0) ? min(_186, 31.984375) : 0.0;
    float _192 = floor(_191);
    vec4 _204 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_192 * 0.0322580635547637939453125, (_191 - _192) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_186) <= 65504.0)), _185.y, 0.0);
    vec4 _209 = textureLod(gHistoryCache, vec2(_154.x, _155.y), 0.0);
    float _210 = _209.x;
    float _215 = (_210 > 0.0) ? min(_210, 31.984375) : 0.0;
    float _216 = floor(_215);
    vec4 _228 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_216 * 0.0322580635547637939453125, (_215 - _216) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_210) <= 65504.0)), _209.y, 0.0);
    vec4 _230 = textureLod(gHistoryCache, _155, 0.0);
    float _231 = _230.x;
    float _236 = (_231 > 0.0) ? min(_231, 31.984375) : 0.0;
    float _237 = floor(_236);
    vec4 _249 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_237 * 0.0322580635547637939453125, (_236 - _237) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_231) <= 65504.0)), _230.y, 0.0);
    float _250 = _157.x;
    float _251 = _156.x;
    bool _259 = all(lessThanEqual(abs(_180), vec4(9.9999996802856924650656260769173e+37)));
    bool _263 = all(lessThanEqual(abs(_204), vec4(9.9999996802856924650656260769173e+37)));
    bool _267 = all(lessThanEqual(abs(_228), vec4(9.9999996802856924650656260769173e+37)));
    bool _271 = all(lessThanEqual(abs(_249), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _274 = (vec4(_250, _251, _250, _251) * vec4(_157.yy, _156.yy)) * vec4(float(_259), float(_263), float(_267), float(_271));
    float _294 = dot(_274, vec4(1.0));
    vec4 _299 = mix(vec4(0.0), ((((mix(vec4(0.0), _180, bvec4(_259)) * _274.x) + (mix(vec4(0.0), _204, bvec4(_263)) * _274.y)) + (mix(vec4(0.0), _228, bvec4(_267)) * _274.z)) + (mix(vec4(0.0), _249, bvec4(_271)) * _274.w)) / vec4(_294), bvec4(_294 > 9.9999999747524270787835121154785e-07));
    vec2 _300 = _299.xy;
    float _302 = _149.x;
    float _305 = (_302 > 0.0) ? min(_302, 255.0) : 0.0;
    float _311 = max(fma(parameters.gMissThreshold.y, _111, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _317 = _311 - abs(((abs(_139) <= 9.9999996802856924650656260769173e+37) ? _139 : 0.0) - _299.z);
    float _320 = (_317 > 0.0) ? (_317 * (parameters.gConvergenceTime / _311)) : 0.0;
    vec2 _332 = abs(_300);
    float _336 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_332, vec2(65504.0)))) ? (((_320 > 0.0) && all(lessThanEqual(abs(fma(_137, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_320, 1.0) : 0.0) : 0.0;
    float _348 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _350 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_145) * parameters.gOutputSize.xy));
    float _354 = ((_350 > 0.0) ? min(_350, _348) : 0.0) / _348;
    float _357 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _362 = _305 * _336;
    float _365 = (_362 > 0.0) ? min(_362, 255.0) : 0.0;
    float _369 = min(min(_365 / (_365 + 1.0), _357), ((_357 * _354) * _354) * fma(-2.0, _354, 3.0));
    vec2 _374 = mix(vec2(0.0), _107, bvec2(all(lessThanEqual(abs(_107), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _385 = mix(_107, mix(_374, _374 + ((_300 - _374) * clamp(_369, 0.0, 1.0)), bvec2(all(lessThanEqual(_332, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_369 > 0.0));
    float _394 = _385.x;
    float _395 = _385.y;
    gOutCache = vec4(fma((_394 > 0.0) ? min(_394, 1.0) : 0.0, 0.984375, floor(fma((_395 > 0.0) ? min(_395, 1.0) : 0.0, 31.0, 0.5))), _111, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_305 > 0.0) ? min(_305, 255.0) : 0.0, (_336 > 0.0) ? min(_336, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

