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
layout(binding = 7) uniform sampler2D gInCoarseDepth;
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
        vec2 _88 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _90 = _88 * parameters.gOutputSize.zw;
        vec4 _94 = textureLod(gInFresh, _90, 0.0);
        vec4 _98 = textureLod(gInCoarseDepth, _90, 0.0);
        float _99 = _98.x;
        vec4 _102 = mix(vec4(0.0), _94, lessThanEqual(abs(_94), vec4(65504.0)));
        float _106 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
        vec4 _118 = parameters.gViewToPreviousClip * vec4(fma(_90, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106, 1.0);
        float _121 = _118.w;
        vec2 _126 = fma(_118.xy * (1.0 / _121), vec2(0.5, -0.5), vec2(0.5));
        vec2 _132 = mix(vec2(-8.0), _126, bvec2((_121 > 0.0) && all(lessThanEqual(abs(_126), vec2(8.0)))));
        float _134 = dot(_118.zw, parameters.gClipToDepth);
        vec2 _140 = _132 * parameters.gFrameToCoarse;
        vec4 _144 = textureLod(gHistoryCacheStateFiltered, _140, 0.0);
        vec4 _148 = textureLod(gHistoryCacheFiltered, _140, 0.0);
        float _150 = _144.x;
        float _153 = (_150 > 0.0) ? min(_150, 255.0) : 0.0;
        float _159 = max(fma(parameters.gMissThreshold.y, _106, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _165 = _159 - abs(((abs(_134) <= 9.9999996802856924650656260769173e+37) ? _134 : 0.0) - _144.y);
        float _168 = (_165 > 0.0) ? (_165 * (parameters.gConvergenceTime / _159)) : 0.0;
        vec4 _180 = abs(_148);
        float _184 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_180, vec4(65504.0)))) ? (((_168 > 0.0) && all(lessThanEqual(abs(fma(_132, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_168, 1.0) : 0.0) : 0.0;
        float _196 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _198 = parameters.gSpeedPx.y - abs(length(fma(_88, parameters.gOutputSize.zw, -_140) * parameters.gOutputSize.xy));
        float _202 = ((_198 > 0.0) ? min(_198, _196) : 0.0) / _196;
        float _205 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _210 = _153 * _184;
        float _213 = (_210 > 0.0) ? min(_210, 255.0) : 0.0;
        float _217 = min(min(_213 / (_213 + 1.0), _205), ((_205 * _202) * _202) * fma(-2.0, _202, 3.0));
        vec4 _222 = mix(vec4(0.0), _102, bvec4(all(lessThanEqual(abs(_102), vec4(9.9999996802856924650656260769173e+37)))));
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), mix(_102, mix(_222, _222 + ((_148 - _222) * clamp(_217, 0.0, 1.0)), bvec4(all(lessThanEqual(_180, vec4(9.9999996802856924650656260769173e+37))))), bvec4(_217 > 0.0)));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_153 > 0.0) ? min(_153, 255.0) : 0.0, (_184 > 0.0) ? min(_184, 1.0) : 0.0, 1.0), 255.0), _106, 0.0, 0.0));
        break;
    } while(false);
}

