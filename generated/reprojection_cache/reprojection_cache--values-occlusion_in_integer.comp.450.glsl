#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

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

layout(binding = 16) uniform writeonly image2D gOutCache;
layout(binding = 17) uniform writeonly image2D gOutCacheState;
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 3) uniform sampler2D gHistoryCache;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _95 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _97 = _95 * parameters.gOutputSize.zw;
        vec4 _101 = textureLod(gInFresh, _97, 0.0);
        float _102 = _101.y;
        float _103 = _101.x;
        float _108 = (_103 > 0.0) ? min(_103, 31.984375) : 0.0;
        float _109 = floor(_108);
        vec2 _116 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_109 * 0.0322580635547637939453125, (_108 - _109) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_103) <= 65504.0));
        vec2 _119 = mix(vec2(0.0), _116, lessThanEqual(abs(_116), vec2(65504.0)));
        float _123 = ((_102 > 0.0) && (_102 < 65504.0)) ? _102 : 65504.0;
        vec4 _135 = parameters.gViewToPreviousClip * vec4(fma(_97, parameters.gViewRay.xy, parameters.gViewRay.zw) * _123, _123, 1.0);
        float _138 = _135.w;
        vec2 _143 = fma(_135.xy * (1.0 / _138), vec2(0.5, -0.5), vec2(0.5));
        vec2 _149 = mix(vec2(-8.0), _143, bvec2((_138 > 0.0) && all(lessThanEqual(abs(_143), vec2(8.0)))));
        float _151 = dot(_135.zw, parameters.gClipToDepth);
        vec2 _157 = _149 * parameters.gFrameToCoarse;
        vec4 _161 = textureLod(gHistoryCacheStateFiltered, _157, 0.0);
        vec2 _162 = fma(_157, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _164 = floor(_162) + vec2(0.5);
        vec2 _165 = _164 * parameters.gOutputSize.zw;
        vec2 _166 = fma(_164, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
        vec2 _167 = fract(_162);
        vec2 _168 = vec2(1.0) - _167;
        vec4 _172 = textureLod(gHistoryCache, _165, 0.0);
        float _173 = _172.x;
        float _178 = (_173 > 0.0) ? min(_173, 31.984375) : 0.0;
        float _179 = floor(_178);
        vec4 _190 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_179 * 0.0322580635547637939453125, (_178 - _179) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_173) <= 65504.0)), _172.y, 0.0);
        vec4 _195 = textureLod(gHistoryCache, vec2(_166.x, _165.y), 0.0);
        float _196 = _195.x;
        float _201 = (_196 > 0.0) ? min(_196, 31.984375) : 0.0;
        float _202 = floor(_201);
        vec2 _209 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_202 * 0.0322580635547637939453125, (_201 - _202) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_196) <= 65504.0));
        vec4 _213 = vec4(_209, _195.y, 0.0);
        vec4 _218 = textureLod(gHistoryCache, vec2(_165.x, _166.y), 0.0);
        float _219 = _218.x;
        float _224 = (_219 > 0.0) ? min(_219, 31.984375) : 0.0;
        float _225 = floor(_224);
        vec2 _232 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_225 * 0.0322580635547637939453125, (_224 - _225) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_219) <= 65504.0));
        vec4 _236 = vec4(_232, _218.y, 0.0);
        vec4 _238 = textureLod(gHistoryCache, _166, 0.0);
        float _239 = _238.x;
        float _244 = (_239 > 0.0) ? min(_239, 31.984375) : 0.0;
        float _245 = floor(_244);
        vec4 _256 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_245 * 0.0322580635547637939453125, (_244 - _245) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_239) <= 65504.0)), _238.y, 0.0);
        float _257 = _168.x;
        float _258 = _167.x;
        bool _266 = all(lessThanEqual(abs(_190), vec4(9.9999996802856924650656260769173e+37)));
        bool _270 = all(lessThanEqual(abs(_213), vec4(9.9999996802856924650656260769173e+37)));
        bool _274 = all(lessThanEqual(abs(_236), vec4(9.9999996802856924650656260769173e+37)));
        bool _278 = all(lessThanEqual(abs(_256), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _281 = (vec4(_257, _258, _257, _258) * vec4(_168.yy, _167.yy)) * vec4(float(_266), float(_270), float(_274), float(_278));
        float _301 = dot(_281, vec4(1.0));
        vec4 _306 = mix(vec4(0.0), ((((mix(vec4(0.0), _190, bvec4(_266)) * _281.x) + (mix(vec4(0.0), _213, bvec4(_270)) * _281.y)) + (mix(vec4(0.0), _236, bvec4(_274)) * _281.z)) + (mix(vec4(0.0), _256, bvec4(_278)) * _281.w)) / vec4(_301), bvec4(_301 > 9.9999999747524270787835121154785e-07));
        vec2 _307 = _306.xy;
        float _309 = _161.x;
        float _312 = (_309 > 0.0) ? min(_309, 255.0) : 0.0;
        float _318 = max(fma(parameters.gMissThreshold.y, _123, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _324 = _318 - abs(((abs(_151) <= 9.9999996802856924650656260769173e+37) ? _151 : 0.0) - _306.z);
        float _327 = (_324 > 0.0) ? (_324 * (parameters.gConvergenceTime / _318)) : 0.0;
        vec2 _339 = abs(_307);
        float _343 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_339, vec2(65504.0)))) ? (((_327 > 0.0) && all(lessThanEqual(abs(fma(_149, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_327, 1.0) : 0.0) : 0.0;
        float _355 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _357 = parameters.gSpeedPx.y - abs(length(fma(_95, parameters.gOutputSize.zw, -_157) * parameters.gOutputSize.xy));
        float _361 = ((_357 > 0.0) ? min(_357, _355) : 0.0) / _355;
        float _364 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _369 = _312 * _343;
        float _372 = (_369 > 0.0) ? min(_369, 255.0) : 0.0;
        float _376 = min(min(_372 / (_372 + 1.0), _364), ((_364 * _361) * _361) * fma(-2.0, _361, 3.0));
        vec2 _381 = mix(vec2(0.0), _119, bvec2(all(lessThanEqual(abs(_119), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _392 = mix(_119, mix(_381, _381 + ((_307 - _381) * clamp(_376, 0.0, 1.0)), bvec2(all(lessThanEqual(_339, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_376 > 0.0));
        float _401 = _392.x;
        float _402 = _392.y;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_402 > 0.0) ? min(_402, 1.0) : 0.0, 0.984375, floor(fma((_401 > 0.0) ? min(_401, 1.0) : 0.0, 31.0, 0.5))), _123, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_312 > 0.0) ? min(_312, 255.0) : 0.0, (_343 > 0.0) ? min(_343, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

