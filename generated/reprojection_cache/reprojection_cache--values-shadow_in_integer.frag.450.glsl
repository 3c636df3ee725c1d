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

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _82 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _86 = textureLod(gInFresh, _82, 0.0);
    float _87 = _86.y;
    float _91 = ((_87 > 0.0) && (_87 < 65504.0)) ? _87 : 65504.0;
    float _92 = _86.x;
    float _97 = (_92 > 0.0) ? min(_92, 31.984375) : 0.0;
    float _98 = floor(_97);
    vec2 _106 = mix(vec2(0.0), min(vec2(_98 * 0.0322580635547637939453125, (_97 - _98) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_92) <= 65504.0));
    vec4 _118 = parameters.gViewToPreviousClip * vec4(fma(_82, parameters.gViewRay.xy, parameters.gViewRay.zw) * _91, _91, 1.0);
    float _121 = _118.w;
    vec2 _126 = fma(_118.xy * (1.0 / _121), vec2(0.5, -0.5), vec2(0.5));
    vec2 _132 = mix(vec2(-8.0), _126, bvec2((_121 > 0.0) && all(lessThanEqual(abs(_126), vec2(8.0)))));
    float _134 = dot(_118.zw, parameters.gClipToDepth);
    vec2 _140 = _132 * parameters.gFrameToCoarse;
    vec2 _142 = fma(_140, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _144 = floor(_142) + vec2(0.5);
    vec2 _145 = _144 * parameters.gOutputSize.zw;
    vec2 _146 = fma(_144, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
    vec2 _147 = fract(_142);
    vec2 _148 = vec2(1.0) - _147;
    vec4 _152 = textureLod(gHistoryCache, _145, 0.0);
    float _153 = _152.x;
    float _158 = (_153 > 0.0) ? min(_153, 31.984375) : 0.0;
    float _159 = floor(_158);
    vec4 _172 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_159 * 0.0322580635547637939453125, (_158 - _159) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_153) <= 65504.0)), _152.zw);
    vec4 _177 = textureLod(gHistoryCache, vec2(_146.x, _145.y), 0.0);
    float _178 = _177.x;
    float _183 = (_178 > 0.0) ? min(_178, 31.984375) : 0.0;
    float _184 = floor(_183);
    vec4 _197 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_184 * 0.0322580635547637939453125, (_183 - _184) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_178) <= 65504.0)), _177.zw);
    vec4 _202 = textureLod(gHistoryCache, vec2(_145.x, _146.y), 0.0);
    float _203 = _202.x;
    float _208 = (_203 > 0.0) ? min(_203, 31.984375) : 0.0;
    float _209 = floor(_208);
    vec4 _222 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_209 * 0.0322580635547637939453125, (_208 - _209) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_203) <= 65504.0)), _202.zw);
    vec4 _224 = textureLod(gHistoryCache, _146, 0.0);
    float _225 = _224.x;
    float _230 = (_225 > 0.0) ? min(_225, 31.984375) : 0.0;
    float _231 = floor(_230);
    vec4 _244 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_231 * 0.0322580635547637939453125, (_230 - _231) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_225) <= 65504.0)), _224.zw);
    float _245 = _148.x;
    float _246 = _147.x;
    bool _254 = all(lessThanEqual(abs(_172), vec4(9.9999996802856924650656260769173e+37)));
    bool _258 = all(lessThanEqual(abs(_197), vec4(9.9999996802856924650656260769173e+37)));
    bool _262 = all(lessThanEqual(abs(_222), vec4(9.9999996802856924650656260769173e+37)));
    bool _266 = all(lessThanEqual(abs(_244), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _269 = (vec4(_245, _246, _245, _246) * vec4(_148.yy, _147.yy)) * vec4(float(_254), float(_258), float(_262), float(_266));
    float _289 = dot(_269, vec4(1.0));
    vec4 _294 = mix(vec4(0.0), ((((mix(vec4(0.0), _172, bvec4(_254)) * _269.x) + (mix(vec4(0.0), _197, bvec4(_258)) * _269.y)) + (mix(vec4(0.0), _222, bvec4(_262)) * _269.z)) + (mix(vec4(0.0), _244, bvec4(_266)) * _269.w)) / vec4(_289), bvec4(_289 > 9.9999999747524270787835121154785e-07));
    float _296 = _294.z;
    float _303 = max(fma(parameters.gMissThreshold.y, _91, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _309 = _303 - abs(((abs(_134) <= 9.9999996802856924650656260769173e+37) ? _134 : 0.0) - _294.w);
    float _312 = (_309 > 0.0) ? (_309 * (parameters.gConvergenceTime / _303)) : 0.0;
    float _328 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(_294.xy), vec2(65504.0)))) ? (((_312 > 0.0) && all(lessThanEqual(abs(fma(_132, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_312, 1.0) : 0.0) : 0.0;
    float _340 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _342 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_140) * parameters.gOutputSize.xy));
    float _346 = ((_342 > 0.0) ? min(_342, _340) : 0.0) / _340;
    float _349 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _356 = (_296 > 0.0) ? min(_296, 255.0) : 0.0;
    float _357 = _356 * _328;
    float _360 = (_357 > 0.0) ? min(_357, 255.0) : 0.0;
    float _364 = min(min(_360 / (_360 + 1.0), _349), ((_349 * _346) * _346) * fma(-2.0, _346, 3.0));
    float _365 = _294.x;
    float _366 = _106.x;
    bool _367 = _364 > 0.0;
    float _369 = _367 ? min(_364, 1.0) : 0.0;
    float _372 = 1.0 - _369;
    float _376 = _294.y;
    float _377 = _106.y;
    vec2 _385 = mix(_106, vec2((abs(_365) <= 9.9999996802856924650656260769173e+37) ? fma(_365, _369, _366 * _372) : _366, (abs(_376) <= 9.9999996802856924650656260769173e+37) ? fma(_376, _369, _377 * _372) : _377), bvec2(_367));
    float _386 = _385.x;
    float _387 = _385.y;
    gOutCache = vec4(fma((_386 > 0.0) ? min(_386, 1.0) : 0.0, 0.984375, floor(fma((_387 > 0.0) ? min(_387, 1.0) : 0.0, 31.0, 0.5))), 0.0, min(fma(_356, (_328 > 0.0) ? min(_328, 1.0) : 0.0, 1.0), 255.0), _91);
}

