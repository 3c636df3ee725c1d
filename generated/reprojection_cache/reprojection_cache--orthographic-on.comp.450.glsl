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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _82 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _84 = _82 * parameters.gOutputSize.zw;
        vec4 _88 = textureLod(gInFresh, _84, 0.0);
        float _89 = _88.y;
        float _90 = _88.x;
        float _93 = (abs(_90) <= 65504.0) ? _90 : 0.0;
        float _97 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
        vec4 _108 = parameters.gViewToPreviousClip * vec4(fma(_84, parameters.gViewRay.xy, parameters.gViewRay.zw), _97, 1.0);
        float _111 = _108.w;
        vec2 _116 = fma(_108.xy * (1.0 / _111), vec2(0.5, -0.5), vec2(0.5));
        vec2 _122 = mix(vec2(-8.0), _116, bvec2((_111 > 0.0) && all(lessThanEqual(abs(_116), vec2(8.0)))));
        float _124 = dot(_108.zw, parameters.gClipToDepth);
        vec2 _130 = _122 * parameters.gFrameToCoarse;
        vec4 _134 = textureLod(gHistoryCacheStateFiltered, _130, 0.0);
        vec4 _138 = textureLod(gHistoryCacheFiltered, _130, 0.0);
        float _139 = _138.x;
        float _141 = _134.x;
        float _144 = (_141 > 0.0) ? min(_141, 255.0) : 0.0;
        float _150 = max(fma(parameters.gMissThreshold.y, _97, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _156 = _150 - abs(((abs(_124) <= 9.9999996802856924650656260769173e+37) ? _124 : 0.0) - _138.y);
        float _159 = (_156 > 0.0) ? (_156 * (parameters.gConvergenceTime / _150)) : 0.0;
        float _171 = abs(_139);
        float _174 = ((parameters.gHistoryValid > 0.5) && (_171 <= 65504.0)) ? (((_159 > 0.0) && all(lessThanEqual(abs(fma(_122, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_159, 1.0) : 0.0) : 0.0;
        float _186 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _188 = parameters.gSpeedPx.y - abs(length(fma(_82, parameters.gOutputSize.zw, -_130) * parameters.gOutputSize.xy));
        float _192 = ((_188 > 0.0) ? min(_188, _186) : 0.0) / _186;
        float _195 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _200 = _144 * _174;
        float _203 = (_200 > 0.0) ? min(_200, 255.0) : 0.0;
        float _207 = min(min(_203 / (_203 + 1.0), _195), ((_195 * _192) * _192) * fma(-2.0, _192, 3.0));
        float _210 = (abs(_93) <= 9.9999996802856924650656260769173e+37) ? _93 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_207 > 0.0) ? ((_171 <= 9.9999996802856924650656260769173e+37) ? fma(_139 - _210, clamp(_207, 0.0, 1.0), _210) : _210) : _93, _97, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_144 > 0.0) ? min(_144, 255.0) : 0.0, (_174 > 0.0) ? min(_174, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

