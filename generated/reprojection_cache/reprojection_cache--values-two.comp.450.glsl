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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

void main()
{
    vec2 _78 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _82 = _78 * parameters.gOutputSize.zw;
    vec4 _90 = textureLod(gInCoarseDepth, _82, 0.0);
    float _91 = _90.x;
    vec2 _92 = textureLod(gInFresh, _82, 0.0).xy;
    vec2 _95 = mix(vec2(0.0), _92, lessThanEqual(abs(_92), vec2(65504.0)));
    float _99 = ((_91 > 0.0) && (_91 < 65504.0)) ? _91 : 65504.0;
    vec4 _111 = parameters.gViewToPreviousClip * vec4(fma(_82, parameters.gViewRay.xy, parameters.gViewRay.zw) * _99, _99, 1.0);
    float _114 = _111.w;
    vec2 _119 = fma(_111.xy * (1.0 / _114), vec2(0.5, -0.5), vec2(0.5));
    float _127 = dot(_111.zw, parameters.gClipToDepth);
    vec2 _133 = mix(vec2(-8.0), _119, bvec2((_114 > 0.0) && all(lessThanEqual(abs(_119), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _139 = max(fma(parameters.gMissThreshold.y, _99, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _147 = textureLod(gHistoryCacheStateFiltered, _133, 0.0);
    vec2 _148 = textureLod(gHistoryCacheFiltered, _133, 0.0).xy;
    float _149 = _147.x;
    float _152 = (_149 > 0.0) ? min(_149, 255.0) : 0.0;
    float _159 = _139 - abs(((abs(_127) <= 9.9999996802856924650656260769173e+37) ? _127 : 0.0) - _147.y);
    float _162 = (_159 > 0.0) ? (_159 * (parameters.gConvergenceTime / _139)) : 0.0;
    vec2 _173 = abs(_148);
    float _177 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_173, vec2(65504.0)))) ? (((_162 > 0.0) && all(lessThanEqual(floatBitsToUint(_133), uvec2(1065353216u)))) ? min(_162, 1.0) : 0.0) : 0.0;
    float _190 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _192 = parameters.gSpeedPx.y - abs(length(fma(_78, parameters.gOutputSize.zw, -_133) * parameters.gOutputSize.xy));
    float _196 = ((_192 > 0.0) ? min(_192, _190) : 0.0) / _190;
    float _199 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _204 = _152 * _177;
    float _207 = (_204 > 0.0) ? min(_204, 255.0) : 0.0;
    float _211 = min(min(_207 / (_207 + 1.0), _199), ((_199 * _196) * _196) * fma(-2.0, _196, 3.0));
    vec2 _216 = mix(vec2(0.0), _95, bvec2(all(lessThanEqual(abs(_95), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _227 = mix(_95, mix(_216, _216 + ((_148 - _216) * clamp(_211, 0.0, 1.0)), bvec2(all(lessThanEqual(_173, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_211 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(_227, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_152 > 0.0) ? min(_152, 255.0) : 0.0, (_177 > 0.0) ? min(_177, 1.0) : 0.0, 1.0), 255.0), _99, 0.0, 0.0));
}

