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
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;
layout(binding = 3) uniform sampler2D gHistoryCache;

void main()
{
    vec2 _90 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _94 = _90 * parameters.gOutputSize.zw;
    vec4 _98 = textureLod(gInFresh, _94, 0.0);
    float _99 = _98.y;
    float _100 = _98.x;
    float _105 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _106 = floor(_105);
    vec2 _114 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_100) <= 65504.0));
    vec2 _117 = mix(vec2(0.0), _114, lessThanEqual(abs(_114), vec2(65504.0)));
    float _121 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
    vec4 _133 = parameters.gViewToPreviousClip * vec4(fma(_94, parameters.gViewRay.xy, parameters.gViewRay.zw) * _121, _121, 1.0);
    float _136 = _133.w;
    vec2 _141 = fma(_133.xy * (1.0 / _136), vec2(0.5, -0.5), vec2(0.5));
    vec2 _147 = mix(vec2(-8.0), _141, bvec2((_136 > 0.0) && all(lessThanEqual(abs(_141), vec2(8.0)))));
    float _149 = dot(_133.zw, parameters.gClipToDepth);
    vec2 _155 = _147 * parameters.gFrameToCoarse;
    vec4 _159 = textureLod(gHistoryCacheStateFiltered, _155, 0.0);
    vec2 _161 = fma(_155, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _162 = floor(_161);
    vec2 _164 = (_162 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _168 = textureGather(gHistoryCache, _164);
    vec4 _172 = textureGather(gHistoryCache, _164, 1).wzxy;
    vec2 _173 = _161 - _162;
    vec2 _174 = vec2(1.0) - _173;
    float _175 = _174.x;
    float _176 = _173.x;
    vec4 _188 = mix(vec4(0.0), (vec4(_175, _176, _175, _176) * vec4(_174.yy, _173.yy)) * vec4(lessThanEqual(abs(_172), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_168.wzxy), vec4(65504.0)));
    float _191 = _168.w;
    float _195 = _168.z;
    float _199 = _168.x;
    float _203 = _168.y;
    vec4 _207 = vec4((_191 > 0.0) ? min(_191, 31.984375) : 0.0, (_195 > 0.0) ? min(_195, 31.984375) : 0.0, (_199 > 0.0) ? min(_199, 31.984375) : 0.0, (_203 > 0.0) ? min(_203, 31.984375) : 0.0);
    vec4 _208 = floor(_207);
    vec3 _220 = vec3(dot(_188, min(_207 - _208, vec4(0.984375))) * 1.01587307453155517578125, dot(_188, _208) * 0.0322580635547637939453125, dot(_188, mix(vec4(0.0), _172, greaterThan(_188, vec4(0.0))))) / vec3(max(dot(_188, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _221 = _220.xy;
    float _223 = _159.x;
    float _226 = (_223 > 0.0) ? min(_223, 255.0) : 0.0;
    float _232 = max(fma(parameters.gMissThreshold.y, _121, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _238 = _232 - abs(((abs(_149) <= 9.9999996802856924650656260769173e+37) ? _149 : 0.0) - _220.z);
    float _241 = (_238 > 0.0) ? (_238 * (parameters.gConvergenceTime / _232)) : 0.0;
    float _257 = ((parameters.gHistoryValid > 0.5) && (abs(_220.x) <= 65504.0)) ? (((_241 > 0.0) && all(lessThanEqual(abs(fma(_147, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_241, 1.0) : 0.0) : 0.0;
    float _269 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _271 = parameters.gSpeedPx.y - abs(length(fma(_90, parameters.gOutputSize.zw, -_155) * parameters.gOutputSize.xy));
    float _275 = ((_271 > 0.0) ? min(_271, _269) : 0.0) / _269;
    float _278 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _283 = _226 * _257;
    float _286 = (_283 > 0.0) ? min(_283, 255.0) : 0.0;
    float _290 = min(min(_286 / (_286 + 1.0), _278), ((_278 * _275) * _275) * fma(-2.0, _275, 3.0));
    vec2 _295 = mix(vec2(0.0), _117, bvec2(all(lessThanEqual(abs(_117), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _307 = mix(_117, mix(_295, _295 + ((_221 - _295) * clamp(_290, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_221), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_290 > 0.0));
    float _316 = _307.x;
    float _317 = _307.y;
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_316 > 0.0) ? min(_316, 1.0) : 0.0, 0.984375, floor(fma((_317 > 0.0) ? min(_317, 1.0) : 0.0, 31.0, 0.5))), _121, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_226 > 0.0) ? min(_226, 255.0) : 0.0, (_257 > 0.0) ? min(_257, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

