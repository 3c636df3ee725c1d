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
        vec2 _97 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _99 = _97 * parameters.gOutputSize.zw;
        vec4 _103 = textureLod(gInFresh, _99, 0.0);
        float _104 = _103.y;
        float _105 = _103.x;
        float _110 = (_105 > 0.0) ? min(_105, 31.984375) : 0.0;
        float _111 = floor(_110);
        vec2 _118 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_111 * 0.0322580635547637939453125, (_110 - _111) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_105) <= 65504.0));
        vec2 _121 = mix(vec2(0.0), _118, lessThanEqual(abs(_118), vec2(65504.0)));
        float _125 = ((_104 > 0.0) && (_104 < 65504.0)) ? _104 : 65504.0;
        vec4 _137 = parameters.gViewToPreviousClip * vec4(fma(_99, parameters.gViewRay.xy, parameters.gViewRay.zw) * _125, _125, 1.0);
        float _140 = _137.w;
        vec2 _145 = fma(_137.xy * (1.0 / _140), vec2(0.5, -0.5), vec2(0.5));
        vec2 _151 = mix(vec2(-8.0), _145, bvec2((_140 > 0.0) && all(lessThanEqual(abs(_145), vec2(8.0)))));
        float _153 = dot(_137.zw, parameters.gClipToDepth);
        vec2 _159 = _151 * parameters.gFrameToCoarse;
        vec4 _163 = textureLod(gHistoryCacheStateFiltered, _159, 0.0);
        vec2 _164 = fma(_159, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _166 = floor(_164) + vec2(0.5);
        vec2 _167 = _166 * parameters.gOutputSize.zw;
        vec2 _168 = fma(_166, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
        vec2 _169 = fract(_164);
        vec2 _170 = vec2(1.0) - _169;
        vec4 _174 = textureLod(gHistoryCache, _167, 0.0);
        float _175 = _174.x;
        float _180 = (_175 > 0.0) ? min(_175, 31.984375) : 0.0;
        float _181 = floor(_180);
        vec4 _192 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_181 * 0.0322580635547637939453125, (_180 - _181) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_175) <= 65504.0)), _174.y, 0.0);
        vec4 _197 = textureLod(gHistoryCache, vec2(_168.x, _167.y), 0.0);
        float _198 = _197.x;
        float _203 = (_198 > 0.0) ? min(_198, 31.984375) : 0.0;
        float _204 = floor(_203);
        vec2 _211 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_204 * 0.0322580635547637939453125, (_203 - _204) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_198) <= 65504.0));
        vec4 _215 = vec4(_211, _197.y, 0.0);
        vec4 _220 = textureLod(gHistoryCache, vec2(_167.x, _168.y), 0.0);
        float _221 = _220.x;
        float _226 = (_221 > 0.0) ? min(_221, 31.984375) : 0.0;
        float _227 = floor(_226);
        vec2 _234 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_227 * 0.0322580635547637939453125, (_226 - _227) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_221) <= 65504.0));
        vec4 _238 = vec4(_234, _220.y, 0.0);
        vec4 _240 = textureLod(gHistoryCache, _168, 0.0);
        float _241 = _240.x;
        float _246 = (_241 > 0.0) ? min(_241, 31.984375) : 0.0;
        float _247 = floor(_246);
        vec4 _258 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_247 * 0.0322580635547637939453125, (_246 - _247) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_241) <= 65504.0)), _240.y, 0.0);
        float _259 = _170.x;
        float _260 = _169.x;
        bool _268 = all(lessThanEqual(abs(_192), vec4(9.9999996802856924650656260769173e+37)));
        bool _272 = all(lessThanEqual(abs(_215), vec4(9.9999996802856924650656260769173e+37)));
        bool _276 = all(lessThanEqual(abs(_238), vec4(9.9999996802856924650656260769173e+37)));
        bool _280 = all(lessThanEqual(abs(_258), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _283 = (vec4(_259, _260, _259, _260) * vec4(_170.yy, _169.yy)) * vec4(float(_268), float(_272), float(_276), float(_280));
        float _303 = dot(_283, vec4(1.0));
        vec4 _308 = mix(vec4(0.0), ((((mix(vec4(0.0), _192, bvec4(_268)) * _283.x) + (mix(vec4(0.0), _215, bvec4(_272)) * _283.y)) + (mix(vec4(0.0), _238, bvec4(_276)) * _283.z)) + (mix(vec4(0.0), _258, bvec4(_280)) * _283.w)) / vec4(_303), bvec4(_303 > 9.9999999747524270787835121154785e-07));
        vec2 _309 = _308.xy;
        float _311 = _163.x;
        float _314 = (_311 > 0.0) ? min(_311, 255.0) : 0.0;
        float _320 = max(fma(parameters.gMissThreshold.y, _125, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _326 = _320 - abs(((abs(_153) <= 9.9999996802856924650656260769173e+37) ? _153 : 0.0) - _308.z);
        float _329 = (_326 > 0.0) ? (_326 * (parameters.gConvergenceTime / _320)) : 0.0;
        vec2 _341 = abs(_309);
        float _345 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_341, vec2(65504.0)))) ? (((_329 > 0.0) && all(lessThanEqual(abs(fma(_151, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_329, 1.0) : 0.0) : 0.0;
        float _357 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _359 = parameters.gSpeedPx.y - abs(length(fma(_97, parameters.gOutputSize.zw, -_159) * parameters.gOutputSize.xy));
        float _363 = ((_359 > 0.0) ? min(_359, _357) : 0.0) / _357;
        float _366 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _371 = _314 * _345;
        float _374 = (_371 > 0.0) ? min(_371, 255.0) : 0.0;
        float _378 = min(min(_374 / (_374 + 1.0), _366), ((_366 * _363) * _363) * fma(-2.0, _363, 3.0));
        vec2 _383 = mix(vec2(0.0), _121, bvec2(all(lessThanEqual(abs(_121), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _394 = mix(_121, mix(_383, _383 + ((_309 - _383) * clamp(_378, 0.0, 1.0)), bvec2(all(lessThanEqual(_341, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_378 > 0.0));
        float _403 = _394.x;
        float _404 = _394.y;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_404 > 0.0) ? min(_404, 1.0) : 0.0, 0.984375, floor(fma((_403 > 0.0) ? min(_403, 1.0) : 0.0, 31.0, 0.5))), _125, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_314 > 0.0) ? min(_314, 255.0) : 0.0, (_345 > 0.0) ? min(_345, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

