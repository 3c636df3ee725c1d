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
    vec2 _72 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _76 = _72 * parameters.gOutputSize.zw;
    vec4 _80 = textureLod(gInFresh, _76, 0.0);
    float _81 = _80.y;
    float _82 = _80.x;
    float _85 = (abs(_82) <= 65504.0) ? _82 : 0.0;
    float _89 = ((_81 > 0.0) && (_81 < 65504.0)) ? _81 : 65504.0;
    vec4 _100 = parameters.gViewToPreviousClip * vec4(fma(_76, parameters.gViewRay.xy, parameters.gViewRay.zw), _89, 1.0);
    float _103 = _100.w;
    vec2 _108 = fma(_100.xy * (1.0 / _103), vec2(0.5, -0.5), vec2(0.5));
    vec2 _114 = mix(vec2(-8.0), _108, bvec2((_103 > 0.0) && all(lessThanEqual(abs(_108), vec2(8.0)))));
    float _116 = dot(_100.zw, parameters.gClipToDepth);
    vec2 _122 = _114 * parameters.gFrameToCoarse;
    float _128 = max(fma(parameters.gMissThreshold.y, _89, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _132 = textureLod(gHistoryCacheFiltered, _122, 0.0);
    vec4 _136 = textureLod(gHistoryCacheStateFiltered, _122, 0.0);
    float _137 = _132.x;
    float _138 = _136.x;
    float _141 = (_138 > 0.0) ? min(_138, 255.0) : 0.0;
    float _148 = _128 - abs(((abs(_116) <= 9.9999996802856924650656260769173e+37) ? _116 : 0.0) - _132.y);
    float _151 = (_148 > 0.0) ? (_148 * (parameters.gConvergenceTime / _128)) : 0.0;
    float _163 = abs(_137);
    float _166 = ((parameters.gHistoryValid > 0.5) && (_163 <= 65504.0)) ? (((_151 > 0.0) && all(lessThanEqual(abs(fma(_114, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_151, 1.0) : 0.0) : 0.0;
    float _179 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _181 = parameters.gSpeedPx.y - abs(length(fma(_72, parameters.gOutputSize.zw, -_122) * parameters.gOutputSize.xy));
    float _185 = ((_181 > 0.0) ? min(_181, _179) : 0.0) / _179;
    float _188 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _193 = _141 * _166;
    float _196 = (_193 > 0.0) ? min(_193, 255.0) : 0.0;
    float _200 = min(min(_196 / (_196 + 1.0), _188), ((_188 * _185) * _185) * fma(-2.0, _185, 3.0));
    float _203 = (abs(_85) <= 9.9999996802856924650656260769173e+37) ? _85 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_200 > 0.0) ? ((_163 <= 9.9999996802856924650656260769173e+37) ? fma(_137 - _203, clamp(_200, 0.0, 1.0), _203) : _203) : _85, _89, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_141 > 0.0) ? min(_141, 255.0) : 0.0, (_166 > 0.0) ? min(_166, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

