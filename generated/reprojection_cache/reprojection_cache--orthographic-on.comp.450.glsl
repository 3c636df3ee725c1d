#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

float _69;

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
layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _84 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _86 = _84 * parameters.gOutputSize.zw;
        vec4 _90 = textureLod(gInFresh, _86, 0.0);
        float _91 = _90.y;
        float _95 = ((_91 > 0.0) && (_91 < 65504.0)) ? _91 : 65504.0;
        float _96 = _90.x;
        vec2 _101 = mix(vec2(0.0), vec2(_96, 0.0), bvec2(abs(_96) <= 65504.0));
        vec4 _112 = parameters.gViewToPreviousClip * vec4(fma(_86, parameters.gViewRay.xy, parameters.gViewRay.zw), _95, 1.0);
        float _115 = _112.w;
        vec2 _120 = fma(_112.xy * (1.0 / _115), vec2(0.5, -0.5), vec2(0.5));
        vec2 _126 = mix(vec2(-8.0), _120, bvec2((_115 > 0.0) && all(lessThanEqual(abs(_120), vec2(8.0)))));
        float _128 = dot(_112.zw, parameters.gClipToDepth);
        vec2 _134 = _126 * parameters.gFrameToCoarse;
        vec4 _138 = textureLod(gHistoryCacheFiltered, _134, 0.0);
        float _139 = _138.x;
        vec2 _144 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_139, 0.0), bvec2(abs(_139) <= 65504.0));
        float _145 = _144.x;
        float _147 = _138.z;
        float _156 = max(fma(parameters.gMissThreshold.y, _95, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _162 = _156 - abs(((abs(_128) <= 9.9999996802856924650656260769173e+37) ? _128 : 0.0) - _138.w);
        float _165 = (_162 > 0.0) ? (_162 * (parameters.gConvergenceTime / _156)) : 0.0;
        float _181 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_145, _144.y, _147, _138.w).xy), vec2(65504.0)))) ? (((_165 > 0.0) && all(lessThanEqual(abs(fma(_126, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_165, 1.0) : 0.0) : 0.0;
        float _193 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _195 = parameters.gSpeedPx.y - abs(length(fma(_84, parameters.gOutputSize.zw, -_134) * parameters.gOutputSize.xy));
        float _199 = ((_195 > 0.0) ? min(_195, _193) : 0.0) / _193;
        float _202 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _209 = (_147 > 0.0) ? min(_147, 255.0) : 0.0;
        float _210 = _209 * _181;
        float _213 = (_210 > 0.0) ? min(_210, 255.0) : 0.0;
        float _217 = min(min(_213 / (_213 + 1.0), _202), ((_202 * _199) * _199) * fma(-2.0, _199, 3.0));
        float _218 = _101.x;
        bool _219 = _217 > 0.0;
        float _221 = _219 ? min(_217, 1.0) : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(_101, vec2((abs(_145) <= 9.9999996802856924650656260769173e+37) ? fma(_145, _221, _218 * (1.0 - _221)) : _218, _69), bvec2(_219)).x, 0.0, min(fma(_209, (_181 > 0.0) ? min(_181, 1.0) : 0.0, 1.0), 255.0), _95));
        break;
    } while(false);
}

