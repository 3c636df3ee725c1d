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
        vec2 _119 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_111 * 0.0322580635547637939453125, (_110 - _111) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_105) <= 65504.0));
        vec2 _122 = mix(vec2(0.0), _119, lessThanEqual(abs(_119), vec2(65504.0)));
        float _126 = ((_104 > 0.0) && (_104 < 65504.0)) ? _104 : 65504.0;
        vec4 _138 = parameters.gViewToPreviousClip * vec4(fma(_99, parameters.gViewRay.xy, parameters.gViewRay.zw) * _126, _126, 1.0);
        float _141 = _138.w;
        vec2 _146 = fma(_138.xy * (1.0 / _141), vec2(0.5, -0.5), vec2(0.5));
        vec2 _152 = mix(vec2(-8.0), _146, bvec2((_141 > 0.0) && all(lessThanEqual(abs(_146), vec2(8.0)))));
        float _154 = dot(_138.zw, parameters.gClipToDepth);
        vec2 _160 = _152 * parameters.gFrameToCoarse;
        vec4 _164 = textureLod(gHistoryCacheStateFiltered, _160, 0.0);
        vec2 _165 = fma(_160, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _167 = floor(_165) + vec2(0.5);
        vec2 _168 = _167 * parameters.gOutputSize.zw;
        vec2 _169 = fma(_167, parameters.gOutputSize.zw, parameters.gOutputSize.zw);
        vec2 _170 = fract(_165);
        vec2 _171 = vec2(1.0) - _170;
        vec4 _175 = textureLod(gHistoryCache, _168, 0.0);
        float _176 = _175.x;
        float _181 = (_176 > 0.0) ? min(_176, 31.984375) : 0.0;
        float _182 = floor(_181);
        vec4 _194 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_182 * 0.0322580635547637939453125, (_181 - _182) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_176) <= 65504.0)), _175.y, 0.0);
        vec4 _199 = textureLod(gHistoryCache, vec2(_169.x, _168.y), 0.0);
        float _200 = _199.x;
        float _205 = (_200 > 0.0) ? min(_200, 31.984375) : 0.0;
        float _206 = floor(_205);
        vec2 _214 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_206 * 0.0322580635547637939453125, (_205 - _206) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_200) <= 65504.0));
        vec4 _218 = vec4(_214, _199.y, 0.0);
        vec4 _223 = textureLod(gHistoryCache, vec2(_168.x, _169.y), 0.0);
        float _224 = _223.x;
        float _229 = (_224 > 0.0) ? min(_224, 31.984375) : 0.0;
        float _230 = floor(_229);
        vec2 _238 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_230 * 0.0322580635547637939453125, (_229 - _230) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_224) <= 65504.0));
        vec4 _242 = vec4(_238, _223.y, 0.0);
        vec4 _244 = textureLod(gHistoryCache, _169, 0.0);
        float _245 = _244.x;
        float _250 = (_245 > 0.0) ? min(_245, 31.984375) : 0.0;
        float _251 = floor(_250);
        vec4 _263 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_251 * 0.0322580635547637939453125, (_250 - _251) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_245) <= 65504.0)), _244.y, 0.0);
        float _264 = _171.x;
        float _265 = _170.x;
        bool _273 = all(lessThanEqual(abs(_194), vec4(9.9999996802856924650656260769173e+37)));
        bool _277 = all(lessThanEqual(abs(_218), vec4(9.9999996802856924650656260769173e+37)));
        bool _281 = all(lessThanEqual(abs(_242), vec4(9.9999996802856924650656260769173e+37)));
        bool _285 = all(lessThanEqual(abs(_263), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _288 = (vec4(_264, _265, _264, _265) * vec4(_171.yy, _170.yy)) * vec4(float(_273), float(_277), float(_281), float(_285));
        float _308 = dot(_288, vec4(1.0));
        vec4 _313 = mix(vec4(0.0), ((((mix(vec4(0.0), _194, bvec4(_273)) * _288.x) + (mix(vec4(0.0), _218, bvec4(_277)) * _288.y)) + (mix(vec4(0.0), _242, bvec4(_281)) * _288.z)) + (mix(vec4(0.0), _263, bvec4(_285)) * _288.w)) / vec4(_308), bvec4(_308 > 9.9999999747524270787835121154785e-07));
        vec2 _314 = _313.xy;
        float _316 = _164.x;
        float _319 = (_316 > 0.0) ? min(_316, 255.0) : 0.0;
        float _325 = max(fma(parameters.gMissThreshold.y, _126, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _331 = _325 - abs(((abs(_154) <= 9.9999996802856924650656260769173e+37) ? _154 : 0.0) - _313.z);
        float _334 = (_331 > 0.0) ? (_331 * (parameters.gConvergenceTime / _325)) : 0.0;
        vec2 _346 = abs(_314);
        float _350 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_346, vec2(65504.0)))) ? (((_334 > 0.0) && all(lessThanEqual(abs(fma(_152, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_334, 1.0) : 0.0) : 0.0;
        float _362 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _364 = parameters.gSpeedPx.y - abs(length(fma(_97, parameters.gOutputSize.zw, -_160) * parameters.gOutputSize.xy));
        float _368 = ((_364 > 0.0) ? min(_364, _362) : 0.0) / _362;
        float _371 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _376 = _319 * _350;
        float _379 = (_376 > 0.0) ? min(_376, 255.0) : 0.0;
        float _383 = min(min(_379 / (_379 + 1.0), _371), ((_371 * _368) * _368) * fma(-2.0, _368, 3.0));
        vec2 _388 = mix(vec2(0.0), _122, bvec2(all(lessThanEqual(abs(_122), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _399 = mix(_122, mix(_388, _388 + ((_314 - _388) * clamp(_383, 0.0, 1.0)), bvec2(all(lessThanEqual(_346, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_383 > 0.0));
        float _408 = _399.x;
        float _409 = _399.y;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_408 > 0.0) ? min(_408, 1.0) : 0.0, 0.984375, floor(fma((_409 > 0.0) ? min(_409, 1.0) : 0.0, 31.0, 0.5))), _126, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_319 > 0.0) ? min(_319, 255.0) : 0.0, (_350 > 0.0) ? min(_350, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

