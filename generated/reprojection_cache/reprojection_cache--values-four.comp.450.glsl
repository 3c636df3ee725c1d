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
    vec4 _86 = textureLod(gInFresh, _82, 0.0);
    vec4 _90 = textureLod(gInCoarseDepth, _82, 0.0);
    float _91 = _90.x;
    vec4 _94 = mix(vec4(0.0), _86, lessThanEqual(abs(_86), vec4(65504.0)));
    float _98 = ((_91 > 0.0) && (_91 < 65504.0)) ? _91 : 65504.0;
    vec4 _110 = parameters.gViewToPreviousClip * vec4(fma(_82, parameters.gViewRay.xy, parameters.gViewRay.zw) * _98, _98, 1.0);
    float _113 = _110.w;
    vec2 _118 = fma(_110.xy * (1.0 / _113), vec2(0.5, -0.5), vec2(0.5));
    vec2 _124 = mix(vec2(-8.0), _118, bvec2((_113 > 0.0) && all(lessThanEqual(abs(_118), vec2(8.0)))));
    float _126 = dot(_110.zw, parameters.gClipToDepth);
    vec2 _132 = _124 * parameters.gFrameToCoarse;
    float _138 = max(fma(parameters.gMissThreshold.y, _98, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _142 = textureLod(gHistoryCacheFiltered, _132, 0.0);
    vec4 _146 = textureLod(gHistoryCacheStateFiltered, _132, 0.0);
    float _147 = _146.x;
    float _150 = (_147 > 0.0) ? min(_147, 255.0) : 0.0;
    float _157 = _138 - abs(((abs(_126) <= 9.9999996802856924650656260769173e+37) ? _126 : 0.0) - _146.y);
    float _160 = (_157 > 0.0) ? (_157 * (parameters.gConvergenceTime / _138)) : 0.0;
    vec4 _172 = abs(_142);
    float _176 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_172, vec4(65504.0)))) ? (((_160 > 0.0) && all(lessThanEqual(abs(fma(_124, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_160, 1.0) : 0.0) : 0.0;
    float _189 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _191 = parameters.gSpeedPx.y - abs(length(fma(_78, parameters.gOutputSize.zw, -_132) * parameters.gOutputSize.xy));
    float _195 = ((_191 > 0.0) ? min(_191, _189) : 0.0) / _189;
    float _198 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _203 = _150 * _176;
    float _206 = (_203 > 0.0) ? min(_203, 255.0) : 0.0;
    float _210 = min(min(_206 / (_206 + 1.0), _198), ((_198 * _195) * _195) * fma(-2.0, _195, 3.0));
    vec4 _215 = mix(vec4(0.0), _94, bvec4(all(lessThanEqual(abs(_94), vec4(9.9999996802856924650656260769173e+37)))));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), mix(_94, mix(_215, _215 + ((_142 - _215) * clamp(_210, 0.0, 1.0)), bvec4(all(lessThanEqual(_172, vec4(9.9999996802856924650656260769173e+37))))), bvec4(_210 > 0.0)));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_150 > 0.0) ? min(_150, 255.0) : 0.0, (_176 > 0.0) ? min(_176, 1.0) : 0.0, 1.0), 255.0), _98, 0.0, 0.0));
}

