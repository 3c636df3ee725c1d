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
    vec2 _109 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_101 * 0.0322580635547637939453125, min((_100 - _101) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_95) <= 65504.0));
    vec2 _112 = mix(vec2(0.0), _109, lessThanEqual(abs(_109), vec2(65504.0)));
    float _116 = ((_94 > 0.0) && (_94 < 65504.0)) ? _94 : 65504.0;
    vec4 _128 = parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _116, _116, 1.0);
    float _131 = _128.w;
    vec2 _136 = fma(_128.xy * (1.0 / _131), vec2(0.5, -0.5), vec2(0.5));
    vec2 _142 = mix(vec2(-8.0), _136, bvec2((_131 > 0.0) && all(lessThanEqual(abs(_136), vec2(8.0)))));
    float _144 = dot(_128.zw, parameters.gClipToDepth);
    vec2 _150 = _142 * parameters.gFrameToCoarse;
    vec4 _154 = textureLod(gHistoryCacheStateFiltered, _150, 0.0);
    vec2 _156 = fma(_150, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _157 = floor(_156);
    vec2 _159 = (_157 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _163 = textureGather(gHistoryCache, _159);
    vec4 _167 = textureGather(gHistoryCache, _159, 1).wzxy;
    vec2 _168 = _156 - _157;
    vec2 _169 = vec2(1.0) - _168;
    float _170 = _169.x;
    float _171 = _168.x;
    vec4 _183 = mix(vec4(0.0), (vec4(_170, _171, _170, _171) * vec4(_169.yy, _168.yy)) * vec4(lessThanEqual(abs(_167), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_163.wzxy), vec4(65504.0)));
    float _186 = _163.w;
    float _190 = _163.z;
    float _194 = _163.x;
    float _198 = _163.y;
    vec4 _202 = vec4((_186 > 0.0) ? min(_186, 31.984375) : 0.0, (_190 > 0.0) ? min(_190, 31.984375) : 0.0, (_194 > 0.0) ? min(_194, 31.984375) : 0.0, (_198 > 0.0) ? min(_198, 31.984375) : 0.0);
    vec4 _203 = floor(_202);
    vec3 _215 = vec3(dot(_183, min(_202 - _203, vec4(0.984375))) * 1.01587307453155517578125, dot(_183, _203) * 0.0322580635547637939453125, dot(_183, mix(vec4(0.0), _167, greaterThan(_183, vec4(0.0))))) / vec3(max(dot(_183, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _216 = _215.xy;
    float _218 = _154.x;
    float _221 = (_218 > 0.0) ? min(_218, 255.0) : 0.0;
    float _227 = max(fma(parameters.gMissThreshold.y, _116, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _233 = _227 - abs(((abs(_144) <= 9.9999996802856924650656260769173e+37) ? _144 : 0.0) - _215.z);
    float _236 = (_233 > 0.0) ? (_233 * (parameters.gConvergenceTime / _227)) : 0.0;
    float _252 = ((parameters.gHistoryValid > 0.5) && (abs(_215.x) <= 65504.0)) ? (((_236 > 0.0) && all(lessThanEqual(abs(fma(_142, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_236, 1.0) : 0.0) : 0.0;
    float _264 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _266 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_150) * parameters.gOutputSize.xy));
    float _270 = ((_266 > 0.0) ? min(_266, _264) : 0.0) / _264;
    float _273 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _278 = _221 * _252;
    float _281 = (_278 > 0.0) ? min(_278, 255.0) : 0.0;
    float _285 = min(min(_281 / (_281 + 1.0), _273), ((_273 * _270) * _270) * fma(-2.0, _270, 3.0));
    vec2 _290 = mix(vec2(0.0), _112, bvec2(all(lessThanEqual(abs(_112), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _302 = mix(_112, mix(_290, _290 + ((_216 - _290) * clamp(_285, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_216), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_285 > 0.0));
    float _311 = _302.x;
    float _312 = _302.y;
    gOutCache = vec4(fma((_311 > 0.0) ? min(_311, 1.0) : 0.0, 0.984375, floor(fma((_312 > 0.0) ? min(_312, 1.0) : 0.0, 31.0, 0.5))), _116, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_221 > 0.0) ? min(_221, 255.0) : 0.0, (_252 > 0.0) ? min(_252, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

