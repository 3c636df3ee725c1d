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
    vec2 _105 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_98 * 0.0322580635547637939453125, (_97 - _98) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_92) <= 65504.0));
    vec2 _108 = mix(vec2(0.0), _105, lessThanEqual(abs(_105), vec2(65504.0)));
    float _112 = ((_91 > 0.0) && (_91 < 65504.0)) ? _91 : 65504.0;
    vec4 _124 = parameters.gViewToPreviousClip * vec4(fma(_86, parameters.gViewRay.xy, parameters.gViewRay.zw) * _112, _112, 1.0);
    float _127 = _124.w;
    vec2 _132 = fma(_124.xy * (1.0 / _127), vec2(0.5, -0.5), vec2(0.5));
    vec2 _138 = mix(vec2(-8.0), _132, bvec2((_127 > 0.0) && all(lessThanEqual(abs(_132), vec2(8.0)))));
    float _140 = dot(_124.zw, parameters.gClipToDepth);
    vec2 _146 = _138 * parameters.gFrameToCoarse;
    vec4 _150 = textureLod(gHistoryCacheStateFiltered, _146, 0.0);
    vec2 _152 = fma(_146, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _154 = floor(_152) + vec2(0.5);
    vec2 _155 = _154 * parameters.gOutputSize.zw;
    vec2 _156 = fma(_154, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _157 = fract(_152);
    vec2 _158 = vec2(1.0) - _157;
    vec4 _162 = textureLod(gHistoryCache, _155, 0.0);
    float _163 = _162.x;
    float _168 = (_163 > 0.0) ? min(_163, 31.984375) : 0.0;
    float _169 = floor(_168);
    vec4 _180 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_169 * 0.0322580635547637939453125, (_168 - _169) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_163) <= 65504.0)), _162.y, 0.0);
    vec4 _185 = textureLod(gHistoryCache, vec2(_156.x, _155.y), 0.0);
    float _186 = _185.x;
    float _191 = (_186 > 0.0) ? min(_186, 31.984375) : 0.0;
    float _192 = floor(_191);
    vec4 _203 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_192 * 0.0322580635547637939453125, (_191 - _192) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_186) <= 65504.0)), _185.y, 0.0);
    vec4 _208 = textureLod(gHistoryCache, vec2(_155.x, _156.y), 0.0);
    float _209 = _208.x;
    float _214 = (_209 > 0.0) ? min(_209, 31.984375) : 0.0;
    float _215 = floor(_214);
    vec4 _226 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_215 * 0.0322580635547637939453125, (_214 - _215) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_209) <= 65504.0)), _208.y, 0.0);
    vec4 _228 = textureLod(gHistoryCache, _156, 0.0);
    float _229 = _228.x;
    float _234 = (_229 > 0.0) ? min(_229, 31.984375) : 0.0;
    float _235 = floor(_234);
    vec4 _246 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_235 * 0.0322580635547637939453125, (_234 - _235) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_229) <= 65504.0)), _228.y, 0.0);
    float _247 = _158.x;
    float _248 = _157.x;
    bool _256 = all(lessThanEqual(abs(_180), vec4(9.9999996802856924650656260769173e+37)));
    bool _260 = all(lessThanEqual(abs(_203), vec4(9.9999996802856924650656260769173e+37)));
    bool _264 = all(lessThanEqual(abs(_226), vec4(9.9999996802856924650656260769173e+37)));
    bool _268 = all(lessThanEqual(abs(_246), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _271 = (vec4(_247, _248, _247, _248) * vec4(_158.yy, _157.yy)) * vec4(float(_256), float(_260), float(_264), float(_268));
    float _291 = dot(_271, vec4(1.0));
    vec4 _296 = mix(vec4(0.0), ((((mix(vec4(0.0), _180, bvec4(_256)) * _271.x) + (mix(vec4(0.0), _203, bvec4(_260)) * _271.y)) + (mix(vec4(0.0), _226, bvec4(_264)) * _271.z)) + (mix(vec4(0.0), _246, bvec4(_268)) * _271.w)) / vec4(_291), bvec4(_291 > 9.9999999747524270787835121154785e-07));
    vec2 _297 = _296.xy;
    float _299 = _150.x;
    float _302 = (_299 > 0.0) ? min(_299, 255.0) : 0.0;
    float _308 = max(fma(parameters.gMissThreshold.y, _112, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _314 = _308 - abs(((abs(_140) <= 9.9999996802856924650656260769173e+37) ? _140 : 0.0) - _296.z);
    float _317 = (_314 > 0.0) ? (_314 * (parameters.gConvergenceTime / _308)) : 0.0;
    vec2 _329 = abs(_297);
    float _333 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_329, vec2(65504.0)))) ? (((_317 > 0.0) && all(lessThanEqual(abs(fma(_138, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_317, 1.0) : 0.0) : 0.0;
    float _345 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _347 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_146) * parameters.gOutputSize.xy));
    float _351 = ((_347 > 0.0) ? min(_347, _345) : 0.0) / _345;
    float _354 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _359 = _302 * _333;
    float _362 = (_359 > 0.0) ? min(_359, 255.0) : 0.0;
    float _366 = min(min(_362 / (_362 + 1.0), _354), ((_354 * _351) * _351) * fma(-2.0, _351, 3.0));
    vec2 _371 = mix(vec2(0.0), _108, bvec2(all(lessThanEqual(abs(_108), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _382 = mix(_108, mix(_371, _371 + ((_297 - _371) * clamp(_366, 0.0, 1.0)), bvec2(all(lessThanEqual(_329, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_366 > 0.0));
    float _391 = _382.x;
    float _392 = _382.y;
    gOutCache = vec4(fma((_392 > 0.0) ? min(_392, 1.0) : 0.0, 0.984375, floor(fma((_391 > 0.0) ? min(_391, 1.0) : 0.0, 31.0, 0.5))), _112, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_302 > 0.0) ? min(_302, 255.0) : 0.0, (_333 > 0.0) ? min(_333, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

