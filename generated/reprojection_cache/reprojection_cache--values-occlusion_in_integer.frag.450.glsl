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
    vec2 _90 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _94 = textureLod(gInFresh, _90, 0.0);
    float _95 = _94.y;
    float _96 = _94.x;
    float _101 = (_96 > 0.0) ? min(_96, 31.984375) : 0.0;
    float _102 = floor(_101);
    vec2 _109 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_102 * 0.0322580635547637939453125, min((_101 - _102) * 1.01587307453155517578125, 1.0)), bvec2(abs(_96) <= 65504.0));
    vec2 _112 = mix(vec2(0.0), _109, lessThanEqual(abs(_109), vec2(65504.0)));
    float _116 = ((_95 > 0.0) && (_95 < 65504.0)) ? _95 : 65504.0;
    vec4 _128 = parameters.gViewToPreviousClip * vec4(fma(_90, parameters.gViewRay.xy, parameters.gViewRay.zw) * _116, _116, 1.0);
    float _131 = _128.w;
    vec2 _136 = fma(_128.xy * (1.0 / _131), vec2(0.5, -0.5), vec2(0.5));
    float _144 = dot(_128.zw, parameters.gClipToDepth);
    vec2 _150 = mix(vec2(-8.0), _136, bvec2((_131 > 0.0) && all(lessThanEqual(abs(_136), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _156 = max(fma(parameters.gMissThreshold.y, _116, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _158 = fma(_150, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _159 = floor(_158);
    vec2 _160 = _158 - _159;
    vec2 _161 = vec2(1.0) - _160;
    float _162 = _161.x;
    float _163 = _160.x;
    vec2 _170 = (_159 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _174 = textureGather(gHistoryCache, _170);
    vec4 _186 = vec4(_156) - abs(vec4((abs(_144) <= 9.9999996802856924650656260769173e+37) ? _144 : 0.0) - textureGather(gHistoryCache, _170, 1).wzxy);
    vec4 _189 = mix(vec4(0.0), _186 * (parameters.gConvergenceTime / _156), greaterThan(_186, vec4(0.0)));
    bvec4 _191 = greaterThan(_189, vec4(0.0));
    bvec4 _195 = bvec4(all(lessThanEqual(floatBitsToUint(_150), uvec2(1065353216u))));
    vec4 _200 = mix(vec4(0.0), mix(vec4(0.0), min(_189, vec4(1.0)), bvec4(_191.x && _195.x, _191.y && _195.y, _191.z && _195.z, _191.w && _195.w)), lessThanEqual(abs(_174.wzxy), vec4(65504.0)));
    vec4 _201 = (vec4(_162, _163, _162, _163) * vec4(_161.yy, _160.yy)) * _200;
    vec4 _205 = _201 * (1.0 / max(dot(_201, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _207 = _174.w;
    float _211 = _174.z;
    float _215 = _174.x;
    float _219 = _174.y;
    vec4 _223 = vec4((_207 > 0.0) ? min(_207, 31.984375) : 0.0, (_211 > 0.0) ? min(_211, 31.984375) : 0.0, (_215 > 0.0) ? min(_215, 31.984375) : 0.0, (_219 > 0.0) ? min(_219, 31.984375) : 0.0);
    vec4 _224 = floor(_223);
    float _228 = dot(_205, _224) * 0.0322580635547637939453125;
    vec2 _231 = vec2(_228, dot(_205, min(_223 - _224, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _235 = textureLod(gHistoryCacheStateFiltered, _150, 0.0);
    float _236 = _235.x;
    float _239 = (_236 > 0.0) ? min(_236, 255.0) : 0.0;
    float _246 = ((parameters.gHistoryValid > 0.5) && (abs(_228) <= 65504.0)) ? dot(_205, _200) : 0.0;
    float _258 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _260 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_150) * parameters.gOutputSize.xy));
    float _264 = ((_260 > 0.0) ? min(_260, _258) : 0.0) / _258;
    float _267 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _272 = _239 * _246;
    float _275 = (_272 > 0.0) ? min(_272, 255.0) : 0.0;
    float _279 = min(min(_275 / (_275 + 1.0), _267), ((_267 * _264) * _264) * fma(-2.0, _264, 3.0));
    vec2 _284 = mix(vec2(0.0), _112, bvec2(all(lessThanEqual(abs(_112), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _296 = mix(_112, mix(_284, _284 + ((_231 - _284) * clamp(_279, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_231), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_279 > 0.0));
    float _305 = _296.x;
    float _306 = _296.y;
    gOutCache = vec4(fma((_306 > 0.0) ? min(_306, 1.0) : 0.0, 0.984375, floor(fma((_305 > 0.0) ? min(_305, 1.0) : 0.0, 31.0, 0.5))), _116, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_239 > 0.0) ? min(_239, 255.0) : 0.0, (_246 > 0.0) ? min(_246, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

