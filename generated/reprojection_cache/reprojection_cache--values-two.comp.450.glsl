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
    vec2 _77 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _81 = _77 * parameters.gOutputSize.zw;
    vec4 _89 = textureLod(gInCoarseDepth, _81, 0.0);
    float _90 = _89.x;
    vec2 _91 = textureLod(gInFresh, _81, 0.0).xy;
    vec2 _94 = mix(vec2(0.0), _91, lessThanEqual(abs(_91), vec2(65504.0)));
    float _98 = ((_90 > 0.0) && (_90 < 65504.0)) ? _90 : 65504.0;
    vec4 _110 = parameters.gViewToPreviousClip * vec4(fma(_81, parameters.gViewRay.xy, parameters.gViewRay.zw) * _98, _98, 1.0);
    float _113 = _110.w;
    vec2 _118 = fma(_110.xy * (1.0 / _113), vec2(0.5, -0.5), vec2(0.5));
    vec2 _124 = mix(vec2(-8.0), _118, bvec2((_113 > 0.0) && all(lessThanEqual(abs(_118), vec2(8.0)))));
    float _126 = dot(_110.zw, parameters.gClipToDepth);
    vec2 _132 = _124 * parameters.gFrameToCoarse;
    float _138 = max(fma(parameters.gMissThreshold.y, _98, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _146 = textureLod(gHistoryCacheStateFiltered, _132, 0.0);
    vec2 _147 = textureLod(gHistoryCacheFiltered, _132, 0.0).xy;
    float _148 = _146.x;
    float _151 = (_148 > 0.0) ? min(_148, 255.0) : 0.0;
    float _158 = _138 - abs(((abs(_126) <= 9.9999996802856924650656260769173e+37) ? _126 : 0.0) - _146.y);
    float _161 = (_158 > 0.0) ? (_158 * (parameters.gConvergenceTime / _138)) : 0.0;
    vec2 _173 = abs(_147);
    float _177 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_173, vec2(65504.0)))) ? (((_161 > 0.0) && all(lessThanEqual(abs(fma(_124, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_161, 1.0) : 0.0) : 0.0;
    float _190 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _192 = parameters.gSpeedPx.y - abs(length(fma(_77, parameters.gOutputSize.zw, -_132) * parameters.gOutputSize.xy));
    float _196 = ((_192 > 0.0) ? min(_192, _190) : 0.0) / _190;
    float _199 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _204 = _151 * _177;
    float _207 = (_204 > 0.0) ? min(_204, 255.0) : 0.0;
    float _211 = min(min(_207 / (_207 + 1.0), _199), ((_199 * _196) * _196) * fma(-2.0, _196, 3.0));
    vec2 _216 = mix(vec2(0.0), _94, bvec2(all(lessThanEqual(abs(_94), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _227 = mix(_94, mix(_216, _216 + ((_147 - _216) * clamp(_211, 0.0, 1.0)), bvec2(all(lessThanEqual(_173, vec2(9.9999996802856924650656260769173e+37))))), bvec2(_211 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(_227, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_151 > 0.0) ? min(_151, 255.0) : 0.0, (_177 > 0.0) ? min(_177, 1.0) : 0.0, 1.0), 255.0), _98, 0.0, 0.0));
}

