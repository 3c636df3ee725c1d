#version 310 es
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

layout(binding = 16, rgba16f) uniform writeonly highp image2D gOutCache;
layout(binding = 1) uniform highp sampler2D gInFresh;
layout(binding = 3) uniform highp sampler2D gHistoryCache;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _93 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _95 = _93 * parameters.gOutputSize.zw;
        vec4 _99 = textureLod(gInFresh, _95, 0.0);
        float _100 = _99.y;
        float _104 = ((_100 > 0.0) && (_100 < 65504.0)) ? _100 : 65504.0;
        float _105 = _99.x;
        float _110 = (_105 > 0.0) ? min(_105, 31.984375) : 0.0;
        float _111 = floor(_110);
        vec2 _118 = mix(vec2(0.0), min(vec2(_111 * 0.0322580635547637939453125, (_110 - _111) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_105) <= 65504.0));
        vec4 _130 = parameters.gViewToPreviousClip * vec4((_95 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _104, _104, 1.0);
        float _133 = _130.w;
        vec2 _138 = (_130.xy * (1.0 / _133)) * vec2(0.5, -0.5) + vec2(0.5);
        vec2 _144 = mix(vec2(-8.0), _138, bvec2((_133 > 0.0) && all(lessThanEqual(abs(_138), vec2(8.0)))));
        float _146 = dot(_130.zw, parameters.gClipToDepth);
        vec2 _152 = _144 * parameters.gFrameToCoarse;
        vec2 _153 = _152 * parameters.gOutputSize.xy + vec2(-0.5);
        vec2 _155 = floor(_153) + vec2(0.5);
        vec2 _156 = _155 * parameters.gOutputSize.zw;
        vec2 _157 = _155 * parameters.gOutputSize.zw + parameters.gOutputSize.zw;
        vec2 _158 = fract(_153);
        vec2 _159 = vec2(1.0) - _158;
        vec4 _163 = textureLod(gHistoryCache, _156, 0.0);
        float _164 = _163.x;
        float _169 = (_164 > 0.0) ? min(_164, 31.984375) : 0.0;
        float _170 = floor(_169);
        vec4 _182 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_170 * 0.0322580635547637939453125, (_169 - _170) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_164) <= 65504.0)), _163.zw);
        vec4 _187 = textureLod(gHistoryCache, vec2(_157.x, _156.y), 0.0);
        float _188 = _187.x;
        float _193 = (_188 > 0.0) ? min(_188, 31.984375) : 0.0;
        float _194 = floor(_193);
        vec2 _201 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_194 * 0.0322580635547637939453125, (_193 - _194) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_188) <= 65504.0));
        vec4 _206 = vec4(_201, _187.zw);
        vec4 _211 = textureLod(gHistoryCache, vec2(_156.x, _157.y), 0.0);
        float _212 = _211.x;
        float _217 = (_212 > 0.0) ? min(_212, 31.984375) : 0.0;
        float _218 = floor(_217);
        vec2 _225 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_218 * 0.0322580635547637939453125, (_217 - _218) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_212) <= 65504.0));
        vec4 _230 = vec4(_225, _211.zw);
        vec4 _232 = textureLod(gHistoryCache, _157, 0.0);
        float _233 = _232.x;
        float _238 = (_233 > 0.0) ? min(_233, 31.984375) : 0.0;
        float _239 = floor(_238);
        vec4 _251 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_239 * 0.0322580635547637939453125, (_238 - _239) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_233) <= 65504.0)), _232.zw);
        float _252 = _159.x;
        float _253 = _158.x;
        bool _261 = all(lessThanEqual(abs(_182), vec4(9.9999996802856924650656260769173e+37)));
        bool _265 = all(lessThanEqual(abs(_206), vec4(9.9999996802856924650656260769173e+37)));
        bool _269 = all(lessThanEqual(abs(_230), vec4(9.9999996802856924650656260769173e+37)));
        bool _273 = all(lessThanEqual(abs(_251), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _276 = (vec4(_252, _253, _252, _253) * vec4(_159.yy, _158.yy)) * vec4(float(_261), float(_265), float(_269), float(_273));
        float _296 = dot(_276, vec4(1.0));
        vec4 _301 = mix(vec4(0.0), ((((mix(vec4(0.0), _182, bvec4(_261)) * _276.x) + (mix(vec4(0.0), _206, bvec4(_265)) * _276.y)) + (mix(vec4(0.0), _230, bvec4(_269)) * _276.z)) + (mix(vec4(0.0), _251, bvec4(_273)) * _276.w)) / vec4(_296), bvec4(_296 > 9.9999999747524270787835121154785e-07));
        float _303 = _301.z;
        float _310 = max(parameters.gMissThreshold.y * _104 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
        float _316 = _310 - abs(((abs(_146) <= 9.9999996802856924650656260769173e+37) ? _146 : 0.0) - _301.w);
        float _319 = (_316 > 0.0) ? (_316 * (parameters.gConvergenceTime / _310)) : 0.0;
        float _335 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(_301.xy), vec2(65504.0)))) ? (((_319 > 0.0) && all(lessThanEqual(abs(_144 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_319, 1.0) : 0.0) : 0.0;
        float _347 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _349 = parameters.gSpeedPx.y - abs(length((_93 * parameters.gOutputSize.zw + (-_152)) * parameters.gOutputSize.xy));
        float _353 = ((_349 > 0.0) ? min(_349, _347) : 0.0) / _347;
        float _356 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _363 = (_303 > 0.0) ? min(_303, 255.0) : 0.0;
        float _364 = _363 * _335;
        float _367 = (_364 > 0.0) ? min(_364, 255.0) : 0.0;
        float _371 = min(min(_367 / (_367 + 1.0), _356), ((_356 * _353) * _353) * ((-2.0) * _353 + 3.0));
        float _372 = _301.x;
        float _373 = _118.x;
        bool _374 = _371 > 0.0;
        float _376 = _374 ? min(_371, 1.0) : 0.0;
        float _379 = 1.0 - _376;
        float _383 = _301.y;
        float _384 = _118.y;
        vec2 _392 = mix(_118, vec2((abs(_372) <= 9.9999996802856924650656260769173e+37) ? (_372 * _376 + (_373 * _379)) : _373, (abs(_383) <= 9.9999996802856924650656260769173e+37) ? (_383 * _376 + (_384 * _379)) : _384), bvec2(_374));
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(((_392.y > 0.0) ? min(_392.y, 1.0) : 0.0) * 0.984375 + floor(((_392.x > 0.0) ? min(_392.x, 1.0) : 0.0) * 31.0 + 0.5), 0.0, min(_363 * ((_335 > 0.0) ? min(_335, 1.0) : 0.0) + 1.0, 255.0), _104));
        break;
    } while(false);
}

