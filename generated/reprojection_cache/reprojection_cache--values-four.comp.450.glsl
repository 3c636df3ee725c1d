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
    vec2 _79 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _83 = _79 * parameters.gOutputSize.zw;
    vec4 _87 = textureLod(gInFresh, _83, 0.0);
    vec4 _91 = textureLod(gInCoarseDepth, _83, 0.0);
    float _92 = _91.x;
    vec4 _95 = mix(vec4(0.0), _87, lessThanEqual(abs(_87), vec4(65504.0)));
    float _99 = ((_92 > 0.0) && (_92 < 65504.0)) ? _92 : 65504.0;
    vec4 _111 = parameters.gViewToPreviousClip * vec4(fma(_83, parameters.gViewRay.xy, parameters.gViewRay.zw) * _99, _99, 1.0);
    float _114 = _111.w;
    vec2 _119 = fma(_111.xy * (1.0 / _114), vec2(0.5, -0.5), vec2(0.5));
    float _127 = dot(_111.zw, parameters.gClipToDepth);
    vec2 _133 = mix(vec2(-8.0), _119, bvec2((_114 > 0.0) && all(lessThanEqual(abs(_119), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _139 = max(fma(parameters.gMissThreshold.y, _99, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _143 = textureLod(gHistoryCacheFiltered, _133, 0.0);
    vec4 _147 = textureLod(gHistoryCacheStateFiltered, _133, 0.0);
    float _148 = _147.x;
    float _151 = (_148 > 0.0) ? min(_148, 255.0) : 0.0;
    float _158 = _139 - abs(((abs(_127) <= 9.9999996802856924650656260769173e+37) ? _127 : 0.0) - _147.y);
    float _161 = (_158 > 0.0) ? (_158 * (parameters.gConvergenceTime / _139)) : 0.0;
    vec4 _172 = abs(_143);
    float _176 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_172, vec4(65504.0)))) ? (((_161 > 0.0) && all(lessThanEqual(floatBitsToUint(_133), uvec2(1065353216u)))) ? min(_161, 1.0) : 0.0) : 0.0;
    float _189 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _191 = parameters.gSpeedPx.y - abs(length(fma(_79, parameters.gOutputSize.zw, -_133) * parameters.gOutputSize.xy));
    float _195 = ((_191 > 0.0) ? min(_191, _189) : 0.0) / _189;
    float _198 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _203 = _151 * _176;
    float _206 = (_203 > 0.0) ? min(_203, 255.0) : 0.0;
    float _210 = min(min(_206 / (_206 + 1.0), _198), ((_198 * _195) * _195) * fma(-2.0, _195, 3.0));
    vec4 _215 = mix(vec4(0.0), _95, bvec4(all(lessThanEqual(abs(_95), vec4(9.9999996802856924650656260769173e+37)))));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), mix(_95, mix(_215, _215 + ((_143 - _215) * clamp(_210, 0.0, 1.0)), bvec4(all(lessThanEqual(_172, vec4(9.9999996802856924650656260769173e+37))))), bvec4(_210 > 0.0)));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_151 > 0.0) ? min(_151, 255.0) : 0.0, (_176 > 0.0) ? min(_176, 1.0) : 0.0, 1.0), 255.0), _99, 0.0, 0.0));
}

