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
        vec2 _100 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _102 = _100 * parameters.gOutputSize.zw;
        vec4 _106 = textureLod(gInFresh, _102, 0.0);
        float _107 = _106.y;
        float _108 = _106.x;
        float _113 = (_108 > 0.0) ? min(_108, 31.984375) : 0.0;
        float _114 = floor(_113);
        vec2 _122 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_114 * 0.0322580635547637939453125, min((_113 - _114) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_108) <= 65504.0));
        vec2 _125 = mix(vec2(0.0), _122, lessThanEqual(abs(_122), vec2(65504.0)));
        float _129 = ((_107 > 0.0) && (_107 < 65504.0)) ? _107 : 65504.0;
        vec4 _141 = parameters.gViewToPreviousClip * vec4(fma(_102, parameters.gViewRay.xy, parameters.gViewRay.zw) * _129, _129, 1.0);
        float _144 = _141.w;
        vec2 _149 = fma(_141.xy * (1.0 / _144), vec2(0.5, -0.5), vec2(0.5));
        vec2 _155 = mix(vec2(-8.0), _149, bvec2((_144 > 0.0) && all(lessThanEqual(abs(_149), vec2(8.0)))));
        float _157 = dot(_141.zw, parameters.gClipToDepth);
        vec2 _163 = _155 * parameters.gFrameToCoarse;
        vec4 _167 = textureLod(gHistoryCacheStateFiltered, _163, 0.0);
        vec2 _168 = fma(_163, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _169 = floor(_168);
        vec2 _171 = (_169 + vec2(1.0)) * parameters.gOutputSize.zw;
        vec4 _175 = textureGather(gHistoryCache, _171);
        vec4 _179 = textureGather(gHistoryCache, _171, 1).wzxy;
        vec2 _180 = _168 - _169;
        vec2 _181 = vec2(1.0) - _180;
        float _182 = _181.x;
        float _183 = _180.x;
        vec4 _195 = mix(vec4(0.0), (vec4(_182, _183, _182, _183) * vec4(_181.yy, _180.yy)) * vec4(lessThanEqual(abs(_179), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_175.wzxy), vec4(65504.0)));
        float _198 = _175.w;
        float _202 = _175.z;
        float _206 = _175.x;
        float _210 = _175.y;
        vec4 _214 = vec4((_198 > 0.0) ? min(_198, 31.984375) : 0.0, (_202 > 0.0) ? min(_202, 31.984375) : 0.0, (_206 > 0.0) ? min(_206, 31.984375) : 0.0, (_210 > 0.0) ? min(_210, 31.984375) : 0.0);
        vec4 _215 = floor(_214);
        vec3 _227 = vec3(dot(_195, min(_214 - _215, vec4(0.984375))) * 1.01587307453155517578125, dot(_195, _215) * 0.0322580635547637939453125, dot(_195, mix(vec4(0.0), _179, greaterThan(_195, vec4(0.0))))) / vec3(max(dot(_195, vec4(1.0)), 9.9999999747524270787835121154785e-07));
        vec2 _228 = _227.xy;
        float _230 = _167.x;
        float _233 = (_230 > 0.0) ? min(_230, 255.0) : 0.0;
        float _239 = max(fma(parameters.gMissThreshold.y, _129, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _245 = _239 - abs(((abs(_157) <= 9.9999996802856924650656260769173e+37) ? _157 : 0.0) - _227.z);
        float _248 = (_245 > 0.0) ? (_245 * (parameters.gConvergenceTime / _239)) : 0.0;
        float _264 = ((parameters.gHistoryValid > 0.5) && (abs(_227.x) <= 65504.0)) ? (((_248 > 0.0) && all(lessThanEqual(abs(fma(_155, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_248, 1.0) : 0.0) : 0.0;
        float _276 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _278 = parameters.gSpeedPx.y - abs(length(fma(_100, parameters.gOutputSize.zw, -_163) * parameters.gOutputSize.xy));
        float _282 = ((_278 > 0.0) ? min(_278, _276) : 0.0) / _276;
        float _285 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _290 = _233 * _264;
        float _293 = (_290 > 0.0) ? min(_290, 255.0) : 0.0;
        float _297 = min(min(_293 / (_293 + 1.0), _285), ((_285 * _282) * _282) * fma(-2.0, _282, 3.0));
        vec2 _302 = mix(vec2(0.0), _125, bvec2(all(lessThanEqual(abs(_125), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _314 = mix(_125, mix(_302, _302 + ((_228 - _302) * clamp(_297, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_228), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_297 > 0.0));
        float _323 = _314.x;
        float _324 = _314.y;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_323 > 0.0) ? min(_323, 1.0) : 0.0, 0.984375, floor(fma((_324 > 0.0) ? min(_324, 1.0) : 0.0, 31.0, 0.5))), _129, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_233 > 0.0) ? min(_233, 255.0) : 0.0, (_264 > 0.0) ? min(_264, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

