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
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 5) uniform sampler2D gHistoryCacheState;

void main()
{
    vec2 _61 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _65 = _61 * parameters.gOutputSize.zw;
    vec4 _69 = textureLod(gInFresh, _65, 0.0);
    float _70 = _69.y;
    float _71 = _69.x;
    float _74 = (abs(_71) <= 65504.0) ? _71 : 0.0;
    float _78 = ((_70 > 0.0) && (_70 < 65504.0)) ? _70 : 65504.0;
    float _84 = max(fma(parameters.gMissThreshold.y, _78, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _88 = textureLod(gHistoryCache, _65, 0.0);
    vec4 _92 = textureLod(gHistoryCacheState, _65, 0.0);
    float _93 = _88.x;
    float _94 = _92.x;
    float _97 = (_94 > 0.0) ? min(_94, 255.0) : 0.0;
    float _104 = _84 - abs(_78 - _88.y);
    float _107 = (_104 > 0.0) ? (_104 * (parameters.gConvergenceTime / _84)) : 0.0;
    float _118 = abs(_93);
    float _121 = ((parameters.gHistoryValid > 0.5) && (_118 <= 65504.0)) ? (((_107 > 0.0) && all(lessThanEqual(floatBitsToUint(_65), uvec2(1065353216u)))) ? min(_107, 1.0) : 0.0) : 0.0;
    float _134 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _136 = parameters.gSpeedPx.y - abs(length(fma(_61, parameters.gOutputSize.zw, -_65) * parameters.gOutputSize.xy));
    float _140 = ((_136 > 0.0) ? min(_136, _134) : 0.0) / _134;
    float _143 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _148 = _97 * _121;
    float _151 = (_148 > 0.0) ? min(_148, 255.0) : 0.0;
    float _155 = min(min(_151 / (_151 + 1.0), _143), ((_143 * _140) * _140) * fma(-2.0, _140, 3.0));
    float _158 = (abs(_74) <= 9.9999996802856924650656260769173e+37) ? _74 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_155 > 0.0) ? ((_118 <= 9.9999996802856924650656260769173e+37) ? fma(_93 - _158, clamp(_155, 0.0, 1.0), _158) : _158) : _74, _78, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_97 > 0.0) ? min(_97, 255.0) : 0.0, (_121 > 0.0) ? min(_121, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

