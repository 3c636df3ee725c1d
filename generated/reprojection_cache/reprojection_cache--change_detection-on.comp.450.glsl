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
    vec2 _88 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _92 = _88 * parameters.gOutputSize.zw;
    vec4 _96 = textureLod(gInFresh, _92, 0.0);
    float _97 = _96.y;
    float _98 = _96.x;
    float _101 = (abs(_98) <= 65504.0) ? _98 : 0.0;
    float _105 = ((_97 > 0.0) && (_97 < 65504.0)) ? _97 : 65504.0;
    vec2 _106 = floor(_88);
    float _107 = _106.x;
    vec4 _117 = vec4(lessThan(abs((vec4(_107) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_107 * 0.0625), 7.5))), vec4(8.0)));
    float _118 = _106.y;
    vec4 _128 = vec4(lessThan(abs((vec4(_118) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_118 * 0.0625), 7.5))), vec4(8.0)));
    vec4 _131 = textureGather(gInFresh, _106 * parameters.gOutputSize.zw);
    vec4 _134 = mix(vec4(0.0), _131, lessThanEqual(abs(_131), vec4(65504.0)));
    vec4 _138 = textureGather(gInFresh, (_106 + vec2(2.0, 0.0)) * parameters.gOutputSize.zw);
    vec4 _141 = mix(vec4(0.0), _138, lessThanEqual(abs(_138), vec4(65504.0)));
    vec4 _145 = textureGather(gInFresh, (_106 + vec2(0.0, 2.0)) * parameters.gOutputSize.zw);
    vec4 _148 = mix(vec4(0.0), _145, lessThanEqual(abs(_145), vec4(65504.0)));
    vec4 _152 = textureGather(gInFresh, (_106 + vec2(2.0)) * parameters.gOutputSize.zw);
    vec4 _155 = mix(vec4(0.0), _152, lessThanEqual(abs(_152), vec4(65504.0)));
    vec4 _160 = vec4(_134.wz, _141.wz);
    vec4 _165 = vec4(_134.xy, _141.xy);
    vec4 _170 = vec4(_148.wz, _155.wz);
    vec4 _175 = vec4(_148.xy, _155.xy);
    float _176 = _128.x;
    float _178 = _128.y;
    float _181 = _128.z;
    float _184 = _128.w;
    float _190 = 1.0 / (dot(_117, vec4(1.0)) * dot(_128, vec4(1.0)));
    float _191 = dot((((_160 * _176) + (_165 * _178)) + (_170 * _181)) + (_175 * _184), _117);
    vec4 _193 = vec4(_191 * _190);
    vec4 _194 = _160 - _193;
    vec4 _197 = _165 - _193;
    vec4 _201 = _170 - _193;
    vec4 _205 = _175 - _193;
    vec4 _223 = parameters.gViewToPreviousClip * vec4(fma(_92, parameters.gViewRay.xy, parameters.gViewRay.zw) * _105, _105, 1.0);
    float _226 = _223.w;
    vec2 _231 = fma(_223.xy * (1.0 / _226), vec2(0.5, -0.5), vec2(0.5));
    vec2 _237 = mix(vec2(-8.0), _231, bvec2((_226 > 0.0) && all(lessThanEqual(abs(_231), vec2(8.0)))));
    float _239 = dot(_223.zw, parameters.gClipToDepth);
    vec2 _245 = _237 * parameters.gFrameToCoarse;
    float _251 = max(fma(parameters.gMissThreshold.y, _105, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _255 = textureLod(gHistoryCacheFiltered, _245, 0.0);
    vec4 _259 = textureLod(gHistoryCacheStateFiltered, _245, 0.0);
    float _260 = _255.x;
    float _261 = _259.x;
    float _264 = (_261 > 0.0) ? min(_261, 255.0) : 0.0;
    float _271 = _251 - abs(((abs(_239) <= 9.9999996802856924650656260769173e+37) ? _239 : 0.0) - _255.y);
    float _274 = (_271 > 0.0) ? (_271 * (parameters.gConvergenceTime / _251)) : 0.0;
    float _286 = abs(_260);
    float _289 = ((parameters.gHistoryValid > 0.5) && (_286 <= 65504.0)) ? (((_274 > 0.0) && all(lessThanEqual(abs(fma(_237, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_274, 1.0) : 0.0) : 0.0;
    float _304 = (_289 > 0.0) ? (_289 * clamp(2.0 - (abs(fma(-_191, _190, _260)) / max(fma(parameters.gChange.x, sqrt(dot(((((_194 * _194) * _176) + ((_197 * _197) * _178)) + ((_201 * _201) * _181)) + ((_205 * _205) * _184), _117) * _190), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _317 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _319 = parameters.gSpeedPx.y - abs(length(fma(_88, parameters.gOutputSize.zw, -_245) * parameters.gOutputSize.xy));
    float _323 = ((_319 > 0.0) ? min(_319, _317) : 0.0) / _317;
    float _326 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _331 = _264 * _304;
    float _334 = (_331 > 0.0) ? min(_331, 255.0) : 0.0;
    float _338 = min(min(_334 / (_334 + 1.0), _326), ((_326 * _323) * _323) * fma(-2.0, _323, 3.0));
    float _341 = (abs(_101) <= 9.9999996802856924650656260769173e+37) ? _101 : 0.0;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4((_338 > 0.0) ? ((_286 <= 9.9999996802856924650656260769173e+37) ? fma(_260 - _341, clamp(_338, 0.0, 1.0), _341) : _341) : _101, _105, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_264 > 0.0) ? min(_264, 255.0) : 0.0, (_304 > 0.0) ? min(_304, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

