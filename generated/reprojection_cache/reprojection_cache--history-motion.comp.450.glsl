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
layout(binding = 2) uniform sampler2D gInVelocity;
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
        vec2 _85 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _87 = _85 * parameters.gOutputSize.zw;
        vec4 _91 = textureLod(gInFresh, _87, 0.0);
        float _92 = _91.y;
        float _93 = _91.x;
        float _96 = (abs(_93) <= 65504.0) ? _93 : 0.0;
        float _100 = ((_92 > 0.0) && (_92 < 65504.0)) ? _92 : 65504.0;
        vec2 _103 = _87 / parameters.gFrameToCoarse;
        float _119 = dot((parameters.gViewToPreviousClip * vec4(fma(_87, parameters.gViewRay.xy, parameters.gViewRay.zw) * _100, _100, 1.0)).zw, parameters.gClipToDepth);
        float _122 = (abs(_119) <= 9.9999996802856924650656260769173e+37) ? _119 : 0.0;
        vec2 _134 = fma(-textureLod(gInVelocity, _103 - ((parameters.gOutputSize.zw * 0.125) / parameters.gFrameToCoarse), 0.0).xy, parameters.gMotionToUv, _103);
        vec2 _139 = mix(vec2(-8.0), _134, bvec2(all(lessThanEqual(abs(_134), vec2(8.0)))));
        vec2 _143 = _139 * parameters.gFrameToCoarse;
        vec4 _147 = textureLod(gHistoryCacheStateFiltered, _143, 0.0);
        vec4 _151 = textureLod(gHistoryCacheFiltered, _143, 0.0);
        float _152 = _151.x;
        float _154 = _147.x;
        float _157 = (_154 > 0.0) ? min(_154, 255.0) : 0.0;
        float _163 = max(fma(parameters.gMissThreshold.y, _100, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _169 = _163 - abs(((abs(_122) <= 9.9999996802856924650656260769173e+37) ? _122 : 0.0) - _151.y);
        float _172 = (_169 > 0.0) ? (_169 * (parameters.gConvergenceTime / _163)) : 0.0;
        float _184 = abs(_152);
        float _187 = ((parameters.gHistoryValid > 0.5) && (_184 <= 65504.0)) ? (((_172 > 0.0) && all(lessThanEqual(abs(fma(_139, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_172, 1.0) : 0.0) : 0.0;
        float _199 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _201 = parameters.gSpeedPx.y - abs(length(fma(_85, parameters.gOutputSize.zw, -_143) * parameters.gOutputSize.xy));
        float _205 = ((_201 > 0.0) ? min(_201, _199) : 0.0) / _199;
        float _208 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _213 = _157 * _187;
        float _216 = (_213 > 0.0) ? min(_213, 255.0) : 0.0;
        float _220 = min(min(_216 / (_216 + 1.0), _208), ((_208 * _205) * _205) * fma(-2.0, _205, 3.0));
        float _223 = (abs(_96) <= 9.9999996802856924650656260769173e+37) ? _96 : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_220 > 0.0) ? ((_184 <= 9.9999996802856924650656260769173e+37) ? fma(_152 - _223, clamp(_220, 0.0, 1.0), _223) : _223) : _96, _100, 0.0, 0.0));
        imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_157 > 0.0) ? min(_157, 255.0) : 0.0, (_187 > 0.0) ? min(_187, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

