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
    vec2 _89 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _93 = textureLod(gInFresh, _89, 0.0);
    float _94 = _93.y;
    float _95 = _93.x;
    float _100 = (_95 > 0.0) ? min(_95, 31.984375) : 0.0;
    float _101 = floor(_100);
    vec2 _108 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_101 * 0.0322580635547637939453125, min((_100 - _101) * 1.01587307453155517578125, 1.0)), bvec2(abs(_95) <= 65504.0));
    vec2 _111 = mix(vec2(0.0), _108, lessThanEqual(abs(_108), vec2(65504.0)));
    float _115 = ((_94 > 0.0) && (_94 < 65504.0)) ? _94 : 65504.0;
    vec4 _127 = parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _115, _115, 1.0);
    float _130 = _127.w;
    vec2 _135 = fma(_127.xy * (1.0 / _130), vec2(0.5, -0.5), vec2(0.5));
    vec2 _141 = mix(vec2(-8.0), _135, bvec2((_130 > 0.0) && all(lessThanEqual(abs(_135), vec2(8.0)))));
    float _143 = dot(_127.zw, parameters.gClipToDepth);
    vec2 _149 = _141 * parameters.gFrameToCoarse;
    vec4 _153 = textureLod(gHistoryCacheStateFiltered, _149, 0.0);
    vec2 _155 = fma(_149, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _156 = floor(_155);
    vec2 _158 = (_156 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _162 = textureGather(gHistoryCache, _158);
    vec4 _166 = textureGather(gHistoryCache, _158, 1).wzxy;
    vec2 _167 = _155 - _156;
    vec2 _168 = vec2(1.0) - _167;
    float _169 = _168.x;
    float _170 = _167.x;
    vec4 _182 = mix(vec4(0.0), (vec4(_169, _170, _169, _170) * vec4(_168.yy, _167.yy)) * vec4(lessThanEqual(abs(_166), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_162.wzxy), vec4(65504.0)));
    float _185 = _162.w;
    float _189 = _162.z;
    float _193 = _162.x;
    float _197 = _162.y;
    vec4 _201 = vec4((_185 > 0.0) ? min(_185, 31.984375) : 0.0, (_189 > 0.0) ? min(_189, 31.984375) : 0.0, (_193 > 0.0) ? min(_193, 31.984375) : 0.0, (_197 > 0.0) ? min(_197, 31.984375) : 0.0);
    vec4 _202 = floor(_201);
    vec3 _214 = vec3(dot(_182, _202) * 0.0322580635547637939453125, dot(_182, min(_201 - _202, vec4(0.984375))) * 1.01587307453155517578125, dot(_182, mix(vec4(0.0), _166, greaterThan(_182, vec4(0.0))))) / vec3(max(dot(_182, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _215 = _214.xy;
    float _217 = _153.x;
    float _220 = (_217 > 0.0) ? min(_217, 255.0) : 0.0;
    float _226 = max(fma(parameters.gMissThreshold.y, _115, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _232 = _226 - abs(((abs(_143) <= 9.9999996802856924650656260769173e+37) ? _143 : 0.0) - _214.z);
    float _235 = (_232 > 0.0) ? (_232 * (parameters.gConvergenceTime / _226)) : 0.0;
    float _251 = ((parameters.gHistoryValid > 0.5) && (abs(_214.x) <= 65504.0)) ? (((_235 > 0.0) && all(lessThanEqual(abs(fma(_141, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_235, 1.0) : 0.0) : 0.0;
    float _263 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _265 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_149) * parameters.gOutputSize.xy));
    float _269 = ((_265 > 0.0) ? min(_265, _263) : 0.0) / _263;
    float _272 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _277 = _220 * _251;
    float _280 = (_277 > 0.0) ? min(_277, 255.0) : 0.0;
    float _284 = min(min(_280 / (_280 + 1.0), _272), ((_272 * _269) * _269) * fma(-2.0, _269, 3.0));
    vec2 _289 = mix(vec2(0.0), _111, bvec2(all(lessThanEqual(abs(_111), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _301 = mix(_111, mix(_289, _289 + ((_215 - _289) * clamp(_284, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_215), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_284 > 0.0));
    float _310 = _301.x;
    float _311 = _301.y;
    gOutCache = vec4(fma((_311 > 0.0) ? min(_311, 1.0) : 0.0, 0.984375, floor(fma((_310 > 0.0) ? min(_310, 1.0) : 0.0, 31.0, 0.5))), _115, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_220 > 0.0) ? min(_220, 255.0) : 0.0, (_251 > 0.0) ? min(_251, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

