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
layout(binding = 3) uniform sampler2D gHistoryCache;

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
        vec4 _113 = parameters.gViewToPreviousClip * vec4(fma(_86, parameters.gViewRay.xy, parameters.gViewRay.zw) * _95, _95, 1.0);
        float _116 = _113.w;
        vec2 _121 = fma(_113.xy * (1.0 / _116), vec2(0.5, -0.5), vec2(0.5));
        vec2 _127 = mix(vec2(-8.0), _121, bvec2((_116 > 0.0) && all(lessThanEqual(abs(_121), vec2(8.0)))));
        float _129 = dot(_113.zw, parameters.gClipToDepth);
        vec2 _135 = _127 * parameters.gFrameToCoarse;
        vec4 _139 = textureLod(gHistoryCache, _135, 0.0);
        float _140 = _139.x;
        vec2 _145 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_140, 0.0), bvec2(abs(_140) <= 65504.0));
        float _146 = _145.x;
        float _148 = _139.z;
        float _157 = max(fma(parameters.gMissThreshold.y, _95, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _163 = _157 - abs(((abs(_129) <= 9.9999996802856924650656260769173e+37) ? _129 : 0.0) - _139.w);
        float _166 = (_163 > 0.0) ? (_163 * (parameters.gConvergenceTime / _157)) : 0.0;
        float _182 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_146, _145.y, _148, _139.w).xy), vec2(65504.0)))) ? (((_166 > 0.0) && all(lessThanEqual(abs(fma(_127, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_166, 1.0) : 0.0) : 0.0;
        float _194 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _196 = parameters.gSpeedPx.y - abs(length(fma(_84, parameters.gOutputSize.zw, -_135) * parameters.gOutputSize.xy));
        float _200 = ((_196 > 0.0) ? min(_196, _194) : 0.0) / _194;
        float _203 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _210 = (_148 > 0.0) ? min(_148, 255.0) : 0.0;
        float _211 = _210 * _182;
        float _214 = (_211 > 0.0) ? min(_211, 255.0) : 0.0;
        float _218 = min(min(_214 / (_214 + 1.0), _203), ((_203 * _200) * _200) * fma(-2.0, _200, 3.0));
        float _219 = _101.x;
        bool _220 = _218 > 0.0;
        float _222 = _220 ? min(_218, 1.0) : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(_101, vec2((abs(_146) <= 9.9999996802856924650656260769173e+37) ? fma(_146, _222, _219 * (1.0 - _222)) : _219, _69), bvec2(_220)).x, 0.0, min(fma(_210, (_182 > 0.0) ? min(_182, 1.0) : 0.0, 1.0), 255.0), _95));
        break;
    } while(false);
}

