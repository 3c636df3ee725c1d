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
        vec2 _87 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _89 = _87 * parameters.gOutputSize.zw;
        vec4 _97 = textureLod(gInCoarseDepth, _89, 0.0);
        float _98 = _97.x;
        vec2 _99 = textureLod(gInFresh, _89, 0.0).xy;
        vec2 _102 = mix(vec2(0.0), _99, lessThanEqual(abs(_99), vec2(65504.0)));
        float _106 = ((_98 > 0.0) && (_98 < 65504.0)) ? _98 : 65504.0;
        vec4 _118 = parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106, 1.0);
        float _121 = _118.w;
        vec2 _126 = fma(_118.xy * (1.0 / _121), vec2(0.5, -0.5), vec2(0.5));
        vec2 _132 = mix(vec2(-8.0), _126, bvec2((_121 > 0.0) && all(lessThanEqual(abs(_126), vec2(8.0)))));
        float _134 = dot(_118.zw, parameters.gClipToDepth);
        vec2 _140 = _132 * parameters.gFrameToCoarse;
        vec4 _144 = textureLod(gHistoryCacheStateFiltered, _140, 0.0);
        vec2 _149 = textureLod(gHistoryCacheFiltered, _140, 0.0).xy;
        float _151 = _144.x;
        float _154 = (_151 > 0.0) ? min(_151, 255.0) : 0.0;
        float _160 = max(fma(parameters.gMissThreshold.y, _106, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _166 = _160 - abs(((abs(_134) <= 9.9999996802856924650656260769173e+37) ? _134 : 0.0) - _144.y);
        float _169 = (_166 > 0.0) ? (_166 * (parameters.gConvergenceTime / _160)) : 0.0;
        vec2 _181 = abs(_149);
        float _185 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_181, vec2(65504.0)))) ? (((_169 > 0.0) && all(lessThanEqual(abs(fma(_132, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_169, 1.0) : 0.0) : 0.0;
        float _197 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _199 = parameters.gSpeedPx.y - abs(length(fma(_87, parameters.gOutputSize.zw, -_140) * parameters.gOutputSize.xy));
        float _203 = ((_199 > 0.0) ? min(_199, _197) : 0.0) / _197;
        float _206 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _211 = _154 * _185;
        float _214 = (_211 > 0.0) ? min(_211, 255.0) : 0.0;
        float _218 = min(min(_214 / (_214 + 1.0), _206), ((_206 * _203) * _203) * fma(-2.0, _203, 3.0));
        vec2 _223 = mix(vec2(0.0), _102, bvec2(all(lessThanEqual(abs(_102), vec2(9.9999996802856924650656260769173e+37)))));
        vec2 _234 = mix(_102, mix(_223, _223 + ((_149 - _223) * clamp(_218, 0.0, 1.0)), bvec2(all(lessThanEqual(_181, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_218 > 0.0));
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(_234, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_154 > 0.0) ? min(_154, 255.0) : 0.0, (_185 > 0.0) ? min(_185, 1.0) : 0.0, 1.0), 255.0), _106, 0.0, 0.0));
        break;
    } while(false);
}

