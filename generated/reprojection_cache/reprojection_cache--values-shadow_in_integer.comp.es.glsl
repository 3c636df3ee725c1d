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
        vec2 _119 = mix(vec2(0.0), min(vec2(_111 * 0.0322580635547637939453125, (_110 - _111) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_105) <= 65504.0));
        vec4 _131 = parameters.gViewToPreviousClip * vec4((_95 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _104, _104, 1.0);
        float _134 = _131.w;
        vec2 _139 = (_131.xy * (1.0 / _134)) * vec2(0.5, -0.5) + vec2(0.5);
        vec2 _145 = mix(vec2(-8.0), _139, bvec2((_134 > 0.0) && all(lessThanEqual(abs(_139), vec2(8.0)))));
        float _147 = dot(_131.zw, parameters.gClipToDepth);
        vec2 _153 = _145 * parameters.gFrameToCoarse;
        vec2 _154 = _153 * parameters.gOutputSize.xy + vec2(-0.5);
        vec2 _156 = floor(_154) + vec2(0.5);
        vec2 _157 = _156 * parameters.gOutputSize.zw;
        vec2 _158 = _156 * parameters.gOutputSize.zw + parameters.gOutputSize.zw;
        vec2 _159 = fract(_154);
        vec2 _160 = vec2(1.0) - _159;
        vec4 _164 = textureLod(gHistoryCache, _157, 0.0);
        float _165 = _164.x;
        float _170 = (_165 > 0.0) ? min(_165, 31.984375) : 0.0;
        float _171 = floor(_170);
        vec4 _184 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_171 * 0.0322580635547637939453125, (_170 - _171) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_165) <= 65504.0)), _164.zw);
        vec4 _189 = textureLod(gHistoryCache, vec2(_158.x, _157.y), 0.0);
        float _190 = _189.x;
        float _195 = (_190 > 0.0) ? min(_190, 31.984375) : 0.0;
        float _196 = floor(_195);
        vec2 _204 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_196 * 0.0322580635547637939453125, (_195 - _196) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_190) <= 65504.0));
        vec4 _209 = vec4(_204, _189.zw);
        vec4 _214 = textureLod(gHistoryCache, vec2(_157.x, _158.y), 0.0);
        float _215 = _214.x;
        float _220 = (_215 > 0.0) ? min(_215, 31.984375) : 0.0;
        float _221 = floor(_220);
        vec2 _229 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_221 * 0.0322580635547637939453125, (_220 - _221) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_215) <= 65504.0));
        vec4 _234 = vec4(_229, _214.zw);
        vec4 _236 = textureLod(gHistoryCache, _158, 0.0);
        float _237 = _236.x;
        float _242 = (_237 > 0.0) ? min(_237, 31.984375) : 0.0;
        float _243 = floor(_242);
        vec4 _256 = vec4(mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_243 * 0.0322580635547637939453125, (_242 - _243) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_237) <= 65504.0)), _236.zw);
        float _257 = _160.x;
        float _258 = _159.x;
        bool _266 = all(lessThanEqual(abs(_184), vec4(9.9999996802856924650656260769173e+37)));
        bool _270 = all(lessThanEqual(abs(_209), vec4(9.9999996802856924650656260769173e+37)));
        bool _274 = all(lessThanEqual(abs(_234), vec4(9.9999996802856924650656260769173e+37)));
        bool _278 = all(lessThanEqual(abs(_256), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _281 = (vec4(_257, _258, _257, _258) * vec4(_160.yy, _159.yy)) * vec4(float(_266), float(_270), float(_274), float(_278));
        float _301 = dot(_281, vec4(1.0));
        vec4 _306 = mix(vec4(0.0), ((((mix(vec4(0.0), _184, bvec4(_266)) * _281.x) + (mix(vec4(0.0), _209, bvec4(_270)) * _281.y)) + (mix(vec4(0.0), _234, bvec4(_274)) * _281.z)) + (mix(vec4(0.0), _256, bvec4(_278)) * _281.w)) / vec4(_301), bvec4(_301 > 9.9999999747524270787835121154785e-07));
        float _308 = _306.z;
        float _315 = max(parameters.gMissThreshold.y * _104 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
        float _321 = _315 - abs(((abs(_147) <= 9.9999996802856924650656260769173e+37) ? _147 : 0.0) - _306.w);
        float _324 = (_321 > 0.0) ? (_321 * (parameters.gConvergenceTime / _315)) : 0.0;
        float _340 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(_306.xy), vec2(65504.0)))) ? (((_324 > 0.0) && all(lessThanEqual(abs(_145 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_324, 1.0) : 0.0) : 0.0;
        float _352 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _354 = parameters.gSpeedPx.y - abs(length((_93 * parameters.gOutputSize.zw + (-_153)) * parameters.gOutputSize.xy));
        float _358 = ((_354 > 0.0) ? min(_354, _352) : 0.0) / _352;
        float _361 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _368 = (_308 > 0.0) ? min(_308, 255.0) : 0.0;
        float _369 = _368 * _340;
        float _372 = (_369 > 0.0) ? min(_369, 255.0) : 0.0;
        float _376 = min(min(_372 / (_372 + 1.0), _361), ((_361 * _358) * _358) * ((-2.0) * _358 + 3.0));
        float _377 = _306.x;
        float _378 = _119.x;
        bool _379 = _376 > 0.0;
        float _381 = _379 ? min(_376, 1.0) : 0.0;
        float _384 = 1.0 - _381;
        float _388 = _306.y;
        float _389 = _119.y;
        vec2 _397 = mix(_119, vec2((abs(_377) <= 9.9999996802856924650656260769173e+37) ? (_377 * _381 + (_378 * _384)) : _378, (abs(_388) <= 9.9999996802856924650656260769173e+37) ? (_388 * _381 + (_389 * _384)) : _389), bvec2(_379));
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(((_397.x > 0.0) ? min(_397.x, 1.0) : 0.0) * 0.984375 + floor(((_397.y > 0.0) ? min(_397.y, 1.0) : 0.0) * 31.0 + 0.5), 0.0, min(_368 * ((_340 > 0.0) ? min(_340, 1.0) : 0.0) + 1.0, 255.0), _104));
        break;
    } while(false);
}

