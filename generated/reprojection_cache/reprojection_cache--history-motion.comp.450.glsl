#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

float _72;

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
layout(binding = 2) uniform sampler2D gInVelocity;
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
        vec4 _93 = textureLod(gInFresh, _89, 0.0);
        float _94 = _93.y;
        float _98 = ((_94 > 0.0) && (_94 < 65504.0)) ? _94 : 65504.0;
        float _99 = _93.x;
        vec2 _104 = mix(vec2(0.0), vec2(_99, 0.0), bvec2(abs(_99) <= 65504.0));
        vec2 _107 = _89 / parameters.gFrameToCoarse;
        float _123 = dot((parameters.gViewToPreviousClip * vec4(fma(_89, parameters.gViewRay.xy, parameters.gViewRay.zw) * _98, _98, 1.0)).zw, parameters.gClipToDepth);
        float _126 = (abs(_123) <= 9.9999996802856924650656260769173e+37) ? _123 : 0.0;
        vec2 _138 = fma(-textureLod(gInVelocity, _107 - ((parameters.gOutputSize.zw * 0.125) / parameters.gFrameToCoarse), 0.0).xy, parameters.gMotionToUv, _107);
        vec2 _143 = mix(vec2(-8.0), _138, bvec2(all(lessThanEqual(abs(_138), vec2(8.0)))));
        vec2 _147 = _143 * parameters.gFrameToCoarse;
        vec4 _151 = textureLod(gHistoryCacheFiltered, _147, 0.0);
        float _152 = _151.x;
        vec2 _157 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_152, 0.0), bvec2(abs(_152) <= 65504.0));
        float _158 = _157.x;
        float _160 = _151.z;
        float _169 = max(fma(parameters.gMissThreshold.y, _98, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
        float _175 = _169 - abs(((abs(_126) <= 9.9999996802856924650656260769173e+37) ? _126 : 0.0) - _151.w);
        float _178 = (_175 > 0.0) ? (_175 * (parameters.gConvergenceTime / _169)) : 0.0;
        float _194 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_158, _157.y, _160, _151.w).xy), vec2(65504.0)))) ? (((_178 > 0.0) && all(lessThanEqual(abs(fma(_143, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_178, 1.0) : 0.0) : 0.0;
        float _206 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
        float _208 = parameters.gSpeedPx.y - abs(length(fma(_87, parameters.gOutputSize.zw, -_147) * parameters.gOutputSize.xy));
        float _212 = ((_208 > 0.0) ? min(_208, _206) : 0.0) / _206;
        float _215 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
        float _222 = (_160 > 0.0) ? min(_160, 255.0) : 0.0;
        float _223 = _222 * _194;
        float _226 = (_223 > 0.0) ? min(_223, 255.0) : 0.0;
        float _230 = min(min(_226 / (_226 + 1.0), _215), ((_215 * _212) * _212) * fma(-2.0, _212, 3.0));
        float _231 = _104.x;
        bool _232 = _230 > 0.0;
        float _234 = _232 ? min(_230, 1.0) : 0.0;
        imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(mix(_104, vec2((abs(_158) <= 9.9999996802856924650656260769173e+37) ? fma(_158, _234, _231 * (1.0 - _234)) : _231, _72), bvec2(_232)).x, 0.0, min(fma(_222, (_194 > 0.0) ? min(_194, 1.0) : 0.0, 1.0), 255.0), _98));
        break;
    } while(false);
}

