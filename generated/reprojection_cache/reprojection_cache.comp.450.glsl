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
    vec4 _101 = parameters.gViewToPreviousClip * vec4(fma(_76, parameters.gViewRay.xy, parameters.gViewRay.zw) * _89, _89, 1.0);
    float _104 = _101.w;
    vec2 _109 = fma(_101.xy * (1.0 / _104), vec2(0.5, -0.5), vec2(0.5));
    vec2 _115 = mix(vec2(-8.0), _109, bvec2((_104 > 0.0) && all(lessThanEqual(abs(_109), vec2(8.0)))));
    float _117 = dot(_101.zw, parameters.gClipToDepth);
    vec2 _123 = _115 * parameters.gFrameToCoarse;
    float _129 = max(fma(parameters.gMissThreshold.y, _89, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _133 = textureLod(gHistoryCacheFiltered, _123, 0.0);
    vec4 _137 = textureLod(gHistoryCacheStateFiltered, _123, 0.0);
    float _138 = _133.x;
    float _139 = _137.x;
    float _142 = (_139 > 0.0) ? min(_139, 255.0) : 0.0;
    float _149 = _129 - abs(((abs(_117) <= 9.9999996802856924650656260769173e+37) ? _117 : 0.0) - _133.y);
    float _152 = (_149 > 0.0) ? (_149 * (parameters.gConvergenceTime / _129)) : 0.0;
    float _164 = abs(_138);
    float _167 = ((parameters.gHistoryValid > 0.5) && (_164 <= 65504.0)) ? (((_152 > 0.0) && all(lessThanEqual(abs(fma(_115, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_152, 1.0) : 0.0) : 0.0;
    float _180 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _182 = parameters.gSpeedPx.y - abs(length(fma(_72, parameters.gOutputSize.zw, -_123) * parameters.gOutputSize.xy));
    float _186 = ((_182 > 0.0) ? min(_182, _180) : 0.0) / _180;
    float _189 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _194 = _142 * _167;
    float _197 = (_194 > 0.0) ? min(_194, 255.0) : 0.0;
    float _201 = min(min(_197 / (_197 + 1.0), _189), ((_189 * _186) * _186) * fma(-2.0, _186, 3.0));
    float _204 = (abs(_85) <= 9.9999996802856924650656260769173e+37) ? _85 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_201 > 0.0) ? ((_164 <= 9.9999996802856924650656260769173e+37) ? fma(_138 - _204, clamp(_201, 0.0, 1.0), _204) : _204) : _85, _89, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_142 > 0.0) ? min(_142, 255.0) : 0.0, (_167 > 0.0) ? min(_167, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

