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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

void main()
{
    vec2 _75 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _79 = _75 * parameters.gOutputSize.zw;
    vec4 _83 = textureLod(gInFresh, _79, 0.0);
    float _84 = _83.y;
    float _85 = _83.x;
    float _88 = (abs(_85) <= 65504.0) ? _85 : 0.0;
    float _92 = ((_84 > 0.0) && (_84 < 65504.0)) ? _84 : 65504.0;
    vec2 _95 = _79 / parameters.gFrameToCoarse;
    float _111 = dot((parameters.gViewToPreviousClip * vec4(fma(_79, parameters.gViewRay.xy, parameters.gViewRay.zw) * _92, _92, 1.0)).zw, parameters.gClipToDepth);
    float _114 = (abs(_111) <= 9.9999996802856924650656260769173e+37) ? _111 : 0.0;
    vec2 _126 = fma(-textureLod(gInVelocity, _95 - ((parameters.gOutputSize.zw * 0.125) / parameters.gFrameToCoarse), 0.0).xy, parameters.gMotionToUv, _95);
    vec2 _135 = mix(vec2(-8.0), _126, bvec2(all(lessThanEqual(abs(_126), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _141 = max(fma(parameters.gMissThreshold.y, _92, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _145 = textureLod(gHistoryCacheFiltered, _135, 0.0);
    vec4 _149 = textureLod(gHistoryCacheStateFiltered, _135, 0.0);
    float _150 = _145.x;
    float _151 = _149.x;
    float _154 = (_151 > 0.0) ? min(_151, 255.0) : 0.0;
    float _161 = _141 - abs(((abs(_114) <= 9.9999996802856924650656260769173e+37) ? _114 : 0.0) - _145.y);
    float _164 = (_161 > 0.0) ? (_161 * (parameters.gConvergenceTime / _141)) : 0.0;
    float _175 = abs(_150);
    float _178 = ((parameters.gHistoryValid > 0.5) && (_175 <= 65504.0)) ? (((_164 > 0.0) && all(lessThanEqual(floatBitsToUint(_135), uvec2(1065353216u)))) ? min(_164, 1.0) : 0.0) : 0.0;
    float _191 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _193 = parameters.gSpeedPx.y - abs(length(fma(_75, parameters.gOutputSize.zw, -_135) * parameters.gOutputSize.xy));
    float _197 = ((_193 > 0.0) ? min(_193, _191) : 0.0) / _191;
    float _200 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _205 = _154 * _178;
    float _208 = (_205 > 0.0) ? min(_205, 255.0) : 0.0;
    float _212 = min(min(_208 / (_208 + 1.0), _200), ((_200 * _197) * _197) * fma(-2.0, _197, 3.0));
    float _215 = (abs(_88) <= 9.9999996802856924650656260769173e+37) ? _88 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_212 > 0.0) ? ((_175 <= 9.9999996802856924650656260769173e+37) ? fma(_150 - _215, clamp(_212, 0.0, 1.0), _215) : _215) : _88, _92, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_154 > 0.0) ? min(_154, 255.0) : 0.0, (_178 > 0.0) ? min(_178, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

