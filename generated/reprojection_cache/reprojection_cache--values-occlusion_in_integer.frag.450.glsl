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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _87 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _91 = textureLod(gInFresh, _87, 0.0);
    float _92 = _91.y;
    float _93 = _91.x;
    float _98 = (_93 > 0.0) ? min(_93, 31.984375) : 0.0;
    float _99 = floor(_98);
    vec2 _106 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_99 * 0.0322580635547637939453125, min((_98 - _99) * 1.01587307453155517578125, 1.0)), bvec2(abs(_93) <= 65504.0));
    vec2 _109 = mix(vec2(0.0), _106, lessThanEqual(abs(_106), vec2(65504.0)));
    float _113 = ((_92 > 0.0) && (_92 < 65504.0)) ? _92 : 65504.0;
    vec4 _125 = parameters.gViewToPreviousClip * vec4(fma(_87, parameters.gViewRay.xy, parameters.gViewRay.zw) * _113, _113, 1.0);
    float _128 = _125.w;
    vec2 _133 = fma(_125.xy * (1.0 / _128), vec2(0.5, -0.5), vec2(0.5));
    vec2 _139 = mix(vec2(-8.0), _133, bvec2((_128 > 0.0) && all(lessThanEqual(abs(_133), vec2(8.0)))));
    float _141 = dot(_125.zw, parameters.gClipToDepth);
    vec2 _147 = _139 * parameters.gFrameToCoarse;
    float _153 = max(fma(parameters.gMissThreshold.y, _113, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _155 = fma(_147, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _156 = floor(_155);
    vec2 _157 = _155 - _156;
    vec2 _158 = vec2(1.0) - _157;
    float _159 = _158.x;
    float _160 = _157.x;
    vec2 _167 = (_156 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _171 = textureGather(gHistoryCache, _167);
    vec4 _183 = vec4(_153) - abs(vec4((abs(_141) <= 9.9999996802856924650656260769173e+37) ? _141 : 0.0) - textureGather(gHistoryCache, _167, 1).wzxy);
    vec4 _186 = mix(vec4(0.0), _183 * (parameters.gConvergenceTime / _153), greaterThan(_183, vec4(0.0)));
    bvec4 _188 = greaterThan(_186, vec4(0.0));
    bvec4 _193 = bvec4(all(lessThanEqual(abs(fma(_139, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5))));
    vec4 _198 = mix(vec4(0.0), mix(vec4(0.0), min(_186, vec4(1.0)), bvec4(_188.x && _193.x, _188.y && _193.y, _188.z && _193.z, _188.w && _193.w)), lessThanEqual(abs(_171.wzxy), vec4(65504.0)));
    vec4 _199 = (vec4(_159, _160, _159, _160) * vec4(_158.yy, _157.yy)) * _198;
    vec4 _203 = _199 * (1.0 / max(dot(_199, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _205 = _171.w;
    float _209 = _171.z;
    float _213 = _171.x;
    float _217 = _171.y;
    vec4 _221 = vec4((_205 > 0.0) ? min(_205, 31.984375) : 0.0, (_209 > 0.0) ? min(_209, 31.984375) : 0.0, (_213 > 0.0) ? min(_213, 31.984375) : 0.0, (_217 > 0.0) ? min(_217, 31.984375) : 0.0);
    vec4 _222 = floor(_221);
    float _226 = dot(_203, _222) * 0.0322580635547637939453125;
    vec2 _229 = vec2(_226, dot(_203, min(_221 - _222, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _233 = textureLod(gHistoryCacheStateFiltered, _147, 0.0);
    float _234 = _233.x;
    float _237 = (_234 > 0.0) ? min(_234, 255.0) : 0.0;
    float _244 = ((parameters.gHistoryValid > 0.5) && (abs(_226) <= 65504.0)) ? dot(_203, _198) : 0.0;
    float _256 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _258 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_147) * parameters.gOutputSize.xy));
    float _262 = ((_258 > 0.0) ? min(_258, _256) : 0.0) / _256;
    float _265 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _270 = _237 * _244;
    float _273 = (_270 > 0.0) ? min(_270, 255.0) : 0.0;
    float _277 = min(min(_273 / (_273 + 1.0), _265), ((_265 * _262) * _262) * fma(-2.0, _262, 3.0));
    vec2 _282 = mix(vec2(0.0), _109, bvec2(all(lessThanEqual(abs(_109), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _294 = mix(_109, mix(_282, _282 + ((_229 - _282) * clamp(_277, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_229), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_277 > 0.0));
    float _303 = _294.x;
    float _304 = _294.y;
    gOutCache = vec4(fma((_304 > 0.0) ? min(_304, 1.0) : 0.0, 0.984375, floor(fma((_303 > 0.0) ? min(_303, 1.0) : 0.0, 31.0, 0.5))), _113, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_237 > 0.0) ? min(_237, 255.0) : 0.0, (_244 > 0.0) ? min(_244, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

