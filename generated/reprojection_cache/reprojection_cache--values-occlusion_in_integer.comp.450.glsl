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
        vec2 _121 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_114 * 0.0322580635547637939453125, min((_113 - _114) * 1.01587307453155517578125, 1.0)), bvec2(abs(_108) <= 65504.0));
        vec2 _124 = mix(vec2(0.0), _121, lessThanEqual(abs(_121), vec2(65504.0)));
        float _128 = ((_107 > 0.0) && (_107 < 65504.0)) ? _107 : 65504.0;
        vec4 _140 = parameters.gViewToPreviousClip * vec4(fma(_102, parameters.gViewRay.xy, parameters.gViewRay.zw) * _128, _128, 1.0);
        float _143 = _140.w;
        vec2 _148 = fma(_140.xy * (1.0 / _143), vec2(0.5, -0.5), vec2(0.5));
        vec2 _154 = mix(vec2(-8.0), _148, bvec2((_143 > 0.0) && all(lessThanEqual(abs(_148), vec2(8.0)))));
        float _156 = dot(_140.zw, parameters.gClipToDepth);
        vec2 _162 = _154 * parameters.gFrameToCoarse;
        vec4 _166 = textureLod(gHistoryCacheStateFiltered, _162, 0.0);
        vec2 _167 = fma(_162, parameters.gOutputSize.xy, vec2(-0.5));
        vec2 _168 = floor(_167);
        vec2 _170 = (_168 + vec2(1.0)) * parameters.gOutputSize.zw;
        vec4 _174 = textureGather(gHistoryCache, _170);
        vec4 _178 = textureGather(gHistoryCache, _170, 1).wzxy;
        vec2 _179 = _167 - _168;
        vec2 _180 = vec2(1.0) - _179;
        float _181 = _180.x;
        float _182 = _179.x;
        vec4 _194 = mix(vec4(0.0), (vec4(_181, _182, _181, _182) * vec4(_180.yy, _179.yy)) * vec4(lessThanEqual(abs(_178), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_174.wzxy), vec4(65504.0)));
        float _197 = _174.w;
        float _201 = _174.z;
        float _205 = _174.x;
        float _209 = _174.y;
        vec4 _213 = vec4((_197 > 0.0) ? min(_197, 31.984375) : 0.0, (_201 > 0.0) ? min(_201, 31.984375) : 0.0, (_205 > 0.0) ? min(_205, 31.984375) : 0.0, (_209 > 0.0) ? min(_209, 31.984375) : 0.0);
        vec4 _214 = floor(_213);
        vec3 _226 = vec3(dot(_194, _214) * 0.0322580635547637939453125, dot(_194, min(_213 - _214, vec4(0.984375))) * 1.01587307453155517578125, dot(_194, mix(vec4(0.0), _178, greaterThan(_194, vec4(0.0))))) / vec3(max(dot(_194, vec4(1.0)), 9.9999999747524270787835121154785e-07));
        vec2 _227 = _226.xy;
        float _229 = _166.x;
        float _232 = (_229 > 0.0) ? min(_229, 255.0) : 0.0;
        float _238 = max(fma(parameters.gMissThreshold.y, _128, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _244 = _238 - abs(((abs(_156) <= 9.9999996802856924650656260769173e+37) ? _156 : 0.0) - _226.z);
        float _247 = (_244 > 0.0) ? (_244 * (parameters.gConvergenceTime / _238)) : 0.0;
        float _263 = ((parameters.gHistoryValid > 0.5) && (abs(_226.x) <= 65504.0)) ? (((_247 > 0.0) && all(lessThanEqual(abs(fma(_154, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_247, 1.0) : 0.0) : 0.0;
        float _275 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _277 = parameters.gSpeedPx.y - abs(length(fma(_100, parameters.gOutputSize.zw, -_162) * parameters.gOutputSize.xy));
        float _281 = ((_277 > 0.0) ? min(_277, _275) : 0.0) / _275;
        float _284 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _289 = _232 * _263;
        float _292 = (_289 > 0.0) ? min(_289, 255.0) : 0.0;
        float _296 = min(min(_292 / (_292 + 1.0), _284), ((_284 * _281) * _281) * fma(-2.0, _281, 3.0));
        vec2 _301 = mix(vec2(0.0), _124, bvec2(all(lessThanEqual(abs(_124), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _313 = mix(_124, mix(_301, _301 + ((_227 - _301) * clamp(_296, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_227), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_296 > 0.0));
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_313.y > 0.0) ? min(_313.y, 1.0) : 0.0, 0.984375, floor(fma((_313.x > 0.0) ? min(_313.x, 1.0) : 0.0, 31.0, 0.5))), _128, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_232 > 0.0) ? min(_232, 255.0) : 0.0, (_263 > 0.0) ? min(_263, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

