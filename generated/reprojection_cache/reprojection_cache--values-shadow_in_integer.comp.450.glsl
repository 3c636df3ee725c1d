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
        vec2 _117 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_109 * 0.0322580635547637939453125, (_108 - _109) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_103) <= 65504.0));
        vec2 _120 = mix(vec2(0.0), _117, lessThanEqual(abs(_117), vec2(65504.0)));
        float _124 = ((_102 > 0.0) && (_102 < 65504.0)) ? _102 : 65504.0;
        vec4 _136 = parameters.gViewToPreviousClip * vec4(fma(_97, parameters.gViewRay.xy, parameters.gViewRay.zw) * _124, _124, 1.0);
        float _139 = _136.w;
        vec2 _144 = fma(_136.xy * (1.0 / _139), vec2(0.5, -0.5), vec2(0.5));
        vec2 _150 = mix(vec2(-8.0), _144, bvec2((_139 > 0.0) && all(lessThanEqual(abs(_144), vec2(8.0)))));
        float _152 = dot(_136.zw, parameters.gClipToDepth);
        vec2 _158 = _150 * parameters.gFrameToCoarse;
        vec4 _162 = textureLod(gHistoryCacheStateFiltered, _158, 0.0);
        vec2 _163 = fma(_158, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _165 = floor(_163) + vec2(0.5);
        vec2 _166 = _165 * parameters.gOutputSize.zw;
        vec2 _167 = fma(_165, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
        vec2 _168 = fract(_163);
        vec2 _169 = vec2(1.0) - _168;
        vec4 _173 = textureLod(gHistoryCache, _166, 0.0);
        float _174 = _173.x;
        float _179 = (_174 > 0.0) ? min(_174, 31.984375) : 0.0;
        float _180 = floor(_179);
        vec4 _192 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_180 * 0.0322580635547637939453125, (_179 - _180) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_174) <= 65504.0)), _173.y, 0.0);
        vec4 _197 = textureLod(gHistoryCache, vec2(_167.x, _166.y), 0.0);
        float _198 = _197.x;
        float _203 = (_198 > 0.0) ? min(_198, 31.984375) : 0.0;
        float _204 = floor(_203);
        vec2 _212 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_204 * 0.0322580635547637939453125, (_203 - _204) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_198) <= 65504.0));
        vec4 _216 = vec4(_212, _197.y, 0.0);
        vec4 _221 = textureLod(gHistoryCache, vec2(_166.x, _167.y), 0.0);
        float _222 = _221.x;
        float _227 = (_222 > 0.0) ? min(_222, 31.984375) : 0.0;
        float _228 = floor(_227);
        vec2 _236 = mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_228 * 0.0322580635547637939453125, (_227 - _228) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_222) <= 65504.0));
        vec4 _240 = vec4(_236, _221.y, 0.0);
        vec4 _242 = textureLod(gHistoryCache, _167, 0.0);
        float _243 = _242.x;
        float _248 = (_243 > 0.0) ? min(_243, 31.984375) : 0.0;
        float _249 = floor(_248);
        vec4 _261 = vec4(mix(vec2(9.9999996802856924650656260769173e+37), min(vec2(_249 * 0.0322580635547637939453125, (_248 - _249) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_243) <= 65504.0)), _242.y, 0.0);
        float _262 = _169.x;
        float _263 = _168.x;
        bool _271 = all(lessThanEqual(abs(_192), vec4(9.9999996802856924650656260769173e+37)));
        bool _275 = all(lessThanEqual(abs(_216), vec4(9.9999996802856924650656260769173e+37)));
        bool _279 = all(lessThanEqual(abs(_240), vec4(9.9999996802856924650656260769173e+37)));
        bool _283 = all(lessThanEqual(abs(_261), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _286 = (vec4(_262, _263, _262, _263) * vec4(_169.yy, _168.yy)) * vec4(float(_271), float(_275), float(_279), float(_283));
        float _306 = dot(_286, vec4(1.0));
        vec4 _311 = mix(vec4(0.0), ((((mix(vec4(0.0), _192, bvec4(_271)) * _286.x) + (mix(vec4(0.0), _216, bvec4(_275)) * _286.y)) + (mix(vec4(0.0), _240, bvec4(_279)) * _286.z)) + (mix(vec4(0.0), _261, bvec4(_283)) * _286.w)) / vec4(_306), bvec4(_306 > 9.9999999747524270787835121154785e-07));
        vec2 _312 = _311.xy;
        float _314 = _162.x;
        float _317 = (_314 > 0.0) ? min(_314, 255.0) : 0.0;
        float _323 = max(fma(parameters.gMissThreshold.y, _124, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _329 = _323 - abs(((abs(_152) <= 9.9999996802856924650656260769173e+37) ? _152 : 0.0) - _311.z);
        float _332 = (_329 > 0.0) ? (_329 * (parameters.gConvergenceTime / _323)) : 0.0;
        vec2 _344 = abs(_312);
        float _348 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_344, vec2(65504.0)))) ? (((_332 > 0.0) && all(lessThanEqual(abs(fma(_150, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_332, 1.0) : 0.0) : 0.0;
        float _360 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _362 = parameters.gSpeedPx.y - abs(length(fma(_95, parameters.gOutputSize.zw, -_158) * parameters.gOutputSize.xy));
        float _366 = ((_362 > 0.0) ? min(_362, _360) : 0.0) / _360;
        float _369 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _374 = _317 * _348;
        float _377 = (_374 > 0.0) ? min(_374, 255.0) : 0.0;
        float _381 = min(min(_377 / (_377 + 1.0), _369), ((_369 * _366) * _366) * fma(-2.0, _366, 3.0));
        vec2 _386 = mix(vec2(0.0), _120, bvec2(all(lessThanEqual(abs(_120), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _397 = mix(_120, mix(_386, _386 + ((_312 - _386) * clamp(_381, 0.0, 1.0)), bvec2(all(lessThanEqual(_344, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_381 > 0.0));
        float _406 = _397.x;
        float _407 = _397.y;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_406 > 0.0) ? min(_406, 1.0) : 0.0, 0.984375, floor(fma((_407 > 0.0) ? min(_407, 1.0) : 0.0, 31.0, 0.5))), _124, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_317 > 0.0) ? min(_317, 255.0) : 0.0, (_348 > 0.0) ? min(_348, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

