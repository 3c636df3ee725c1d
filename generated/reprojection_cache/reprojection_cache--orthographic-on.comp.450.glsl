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
    vec4 _101 = parameters.gViewToPreviousClip * vec4(fma(_77, parameters.gViewRay.xy, parameters.gViewRay.zw), _90, 1.0);
    float _104 = _101.w;
    vec2 _109 = fma(_101.xy * (1.0 / _104), vec2(0.5, -0.5), vec2(0.5));
    float _117 = dot(_101.zw, parameters.gClipToDepth);
    vec2 _123 = mix(vec2(-8.0), _109, bvec2((_104 > 0.0) && all(lessThanEqual(abs(_109), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _129 = max(fma(parameters.gMissThreshold.y, _90, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _133 = textureLod(gHistoryCacheFiltered, _123, 0.0);
    vec4 _137 = textureLod(gHistoryCacheStateFiltered, _123, 0.0);
    float _138 = _133.x;
    float _139 = _137.x;
    float _142 = (_139 > 0.0) ? min(_139, 255.0) : 0.0;
    float _149 = _129 - abs(((abs(_117) <= 9.9999996802856924650656260769173e+37) ? _117 : 0.0) - _133.y);
    float _152 = (_149 > 0.0) ? (_149 * (parameters.gConvergenceTime / _129)) : 0.0;
    float _163 = abs(_138);
    float _166 = ((parameters.gHistoryValid > 0.5) && (_163 <= 65504.0)) ? (((_152 > 0.0) && all(lessThanEqual(floatBitsToUint(_123), uvec2(1065353216u)))) ? min(_152, 1.0) : 0.0) : 0.0;
    float _179 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _181 = parameters.gSpeedPx.y - abs(length(fma(_73, parameters.gOutputSize.zw, -_123) * parameters.gOutputSize.xy));
    float _185 = ((_181 > 0.0) ? min(_181, _179) : 0.0) / _179;
    float _188 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _193 = _142 * _166;
    float _196 = (_193 > 0.0) ? min(_193, 255.0) : 0.0;
    float _200 = min(min(_196 / (_196 + 1.0), _188), ((_188 * _185) * _185) * fma(-2.0, _185, 3.0));
    float _203 = (abs(_86) <= 9.9999996802856924650656260769173e+37) ? _86 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_200 > 0.0) ? ((_163 <= 9.9999996802856924650656260769173e+37) ? fma(_138 - _203, clamp(_200, 0.0, 1.0), _203) : _203) : _86, _90, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_142 > 0.0) ? min(_142, 255.0) : 0.0, (_166 > 0.0) ? min(_166, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

