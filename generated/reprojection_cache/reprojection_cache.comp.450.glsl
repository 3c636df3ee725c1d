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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

void main()
{
    vec2 _73 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _77 = _73 * parameters.gOutputSize.zw;
    vec4 _81 = textureLod(gInFresh, _77, 0.0);
    float _82 = _81.y;
    float _83 = _81.x;
    float _86 = (abs(_83) <= 65504.0) ? _83 : 0.0;
    float _90 = ((_82 > 0.0) && (_82 < 65504.0)) ? _82 : 65504.0;
    vec4 _102 = parameters.gViewToPreviousClip * vec4(fma(_77, parameters.gViewRay.xy, parameters.gViewRay.zw) * _90, _90, 1.0);
    float _105 = _102.w;
    vec2 _110 = fma(_102.xy * (1.0 / _105), vec2(0.5, -0.5), vec2(0.5));
    float _118 = dot(_102.zw, parameters.gClipToDepth);
    vec2 _124 = mix(vec2(-8.0), _110, bvec2((_105 > 0.0) && all(lessThanEqual(abs(_110), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _130 = max(fma(parameters.gMissThreshold.y, _90, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _134 = textureLod(gHistoryCacheFiltered, _124, 0.0);
    vec4 _138 = textureLod(gHistoryCacheStateFiltered, _124, 0.0);
    float _139 = _134.x;
    float _140 = _138.x;
    float _143 = (_140 > 0.0) ? min(_140, 255.0) : 0.0;
    float _150 = _130 - abs(((abs(_118) <= 9.9999996802856924650656260769173e+37) ? _118 : 0.0) - _134.y);
    float _153 = (_150 > 0.0) ? (_150 * (parameters.gConvergenceTime / _130)) : 0.0;
    float _164 = abs(_139);
    float _167 = ((parameters.gHistoryValid > 0.5) && (_164 <= 65504.0)) ? (((_153 > 0.0) && all(lessThanEqual(floatBitsToUint(_124), uvec2(1065353216u)))) ? min(_153, 1.0) : 0.0) : 0.0;
    float _180 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _182 = parameters.gSpeedPx.y - abs(length(fma(_73, parameters.gOutputSize.zw, -_124) * parameters.gOutputSize.xy));
    float _186 = ((_182 > 0.0) ? min(_182, _180) : 0.0) / _180;
    float _189 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _194 = _143 * _167;
    float _197 = (_194 > 0.0) ? min(_194, 255.0) : 0.0;
    float _201 = min(min(_197 / (_197 + 1.0), _189), ((_189 * _186) * _186) * fma(-2.0, _186, 3.0));
    float _204 = (abs(_86) <= 9.9999996802856924650656260769173e+37) ? _86 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_201 > 0.0) ? ((_164 <= 9.9999996802856924650656260769173e+37) ? fma(_139 - _204, clamp(_201, 0.0, 1.0), _204) : _204) : _86, _90, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_143 > 0.0) ? min(_143, 255.0) : 0.0, (_167 > 0.0) ? min(_167, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

