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
    vec2 _89 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _93 = _89 * parameters.gOutputSize.zw;
    vec4 _97 = textureLod(gInFresh, _93, 0.0);
    float _98 = _97.y;
    float _99 = _97.x;
    float _102 = (abs(_99) <= 65504.0) ? _99 : 0.0;
    float _106 = ((_98 > 0.0) && (_98 < 65504.0)) ? _98 : 65504.0;
    vec2 _107 = floor(_89);
    float _108 = _107.x;
    vec4 _118 = vec4(lessThan(abs((vec4(_108) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_108 * 0.0625), 7.5))), vec4(8.0)));
    float _119 = _107.y;
    vec4 _129 = vec4(lessThan(abs((vec4(_119) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_119 * 0.0625), 7.5))), vec4(8.0)));
    vec4 _132 = textureGather(gInFresh, _107 * parameters.gOutputSize.zw);
    vec4 _135 = mix(vec4(0.0), _132, lessThanEqual(abs(_132), vec4(65504.0)));
    vec4 _139 = textureGather(gInFresh, (_107 + vec2(2.0, 0.0)) * parameters.gOutputSize.zw);
    vec4 _142 = mix(vec4(0.0), _139, lessThanEqual(abs(_139), vec4(65504.0)));
    vec4 _146 = textureGather(gInFresh, (_107 + vec2(0.0, 2.0)) * parameters.gOutputSize.zw);
    vec4 _149 = mix(vec4(0.0), _146, lessThanEqual(abs(_146), vec4(65504.0)));
    vec4 _153 = textureGather(gInFresh, (_107 + vec2(2.0)) * parameters.gOutputSize.zw);
    vec4 _156 = mix(vec4(0.0), _153, lessThanEqual(abs(_153), vec4(65504.0)));
    vec4 _161 = vec4(_135.wz, _142.wz);
    vec4 _166 = vec4(_135.xy, _142.xy);
    vec4 _171 = vec4(_149.wz, _156.wz);
    vec4 _176 = vec4(_149.xy, _156.xy);
    float _177 = _129.x;
    float _179 = _129.y;
    float _182 = _129.z;
    float _185 = _129.w;
    float _191 = 1.0 / (dot(_118, vec4(1.0)) * dot(_129, vec4(1.0)));
    float _192 = dot((((_161 * _177) + (_166 * _179)) + (_171 * _182)) + (_176 * _185), _118);
    vec4 _194 = vec4(_192 * _191);
    vec4 _195 = _161 - _194;
    vec4 _198 = _166 - _194;
    vec4 _202 = _171 - _194;
    vec4 _206 = _176 - _194;
    vec4 _224 = parameters.gViewToPreviousClip * vec4(fma(_93, parameters.gViewRay.xy, parameters.gViewRay.zw) * _106, _106, 1.0);
    float _227 = _224.w;
    vec2 _232 = fma(_224.xy * (1.0 / _227), vec2(0.5, -0.5), vec2(0.5));
    float _240 = dot(_224.zw, parameters.gClipToDepth);
    vec2 _246 = mix(vec2(-8.0), _232, bvec2((_227 > 0.0) && all(lessThanEqual(abs(_232), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _252 = max(fma(parameters.gMissThreshold.y, _106, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _256 = textureLod(gHistoryCacheFiltered, _246, 0.0);
    vec4 _260 = textureLod(gHistoryCacheStateFiltered, _246, 0.0);
    float _261 = _256.x;
    float _262 = _260.x;
    float _265 = (_262 > 0.0) ? min(_262, 255.0) : 0.0;
    float _272 = _252 - abs(((abs(_240) <= 9.9999996802856924650656260769173e+37) ? _240 : 0.0) - _256.y);
    float _275 = (_272 > 0.0) ? (_272 * (parameters.gConvergenceTime / _252)) : 0.0;
    float _286 = abs(_261);
    float _289 = ((parameters.gHistoryValid > 0.5) && (_286 <= 65504.0)) ? (((_275 > 0.0) && all(lessThanEqual(floatBitsToUint(_246), uvec2(1065353216u)))) ? min(_275, 1.0) : 0.0) : 0.0;
    float _304 = (_289 > 0.0) ? (_289 * clamp(2.0 - (abs(fma(-_192, _191, _261)) / max(fma(parameters.gChange.x, sqrt(dot(((((_195 * _195) * _177) + ((_198 * _198) * _179)) + ((_202 * _202) * _182)) + ((_206 * _206) * _185), _118) * _191), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _317 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _319 = parameters.gSpeedPx.y - abs(length(fma(_89, parameters.gOutputSize.zw, -_246) * parameters.gOutputSize.xy));
    float _323 = ((_319 > 0.0) ? min(_319, _317) : 0.0) / _317;
    float _326 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _331 = _265 * _304;
    float _334 = (_331 > 0.0) ? min(_331, 255.0) : 0.0;
    float _338 = min(min(_334 / (_334 + 1.0), _326), ((_326 * _323) * _323) * fma(-2.0, _323, 3.0));
    float _341 = (abs(_102) <= 9.9999996802856924650656260769173e+37) ? _102 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_338 > 0.0) ? ((_286 <= 9.9999996802856924650656260769173e+37) ? fma(_261 - _341, clamp(_338, 0.0, 1.0), _341) : _341) : _102, _106, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_265 > 0.0) ? min(_265, 255.0) : 0.0, (_304 > 0.0) ? min(_304, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

