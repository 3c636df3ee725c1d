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
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

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
    float _149 = dot(_133.zw, parameters.gClipToDepth);
    vec2 _155 = mix(vec2(-8.0), _141, bvec2((_136 > 0.0) && all(lessThanEqual(abs(_141), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _161 = max(fma(parameters.gMissThreshold.y, _121, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _163 = fma(_155, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _164 = floor(_163);
    vec2 _165 = _163 - _164;
    vec2 _166 = vec2(1.0) - _165;
    float _167 = _166.x;
    float _168 = _165.x;
    vec2 _175 = (_164 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _179 = textureGather(gHistoryCache, _175);
    vec4 _191 = vec4(_161) - abs(vec4((abs(_149) <= 9.9999996802856924650656260769173e+37) ? _149 : 0.0) - textureGather(gHistoryCache, _175, 1).wzxy);
    vec4 _194 = mix(vec4(0.0), _191 * (parameters.gConvergenceTime / _161), greaterThan(_191, vec4(0.0)));
    bvec4 _196 = greaterThan(_194, vec4(0.0));
    bvec4 _200 = bvec4(all(lessThanEqual(floatBitsToUint(_155), uvec2(1065353216u))));
    vec4 _205 = mix(vec4(0.0), mix(vec4(0.0), min(_194, vec4(1.0)), bvec4(_196.x && _200.x, _196.y && _200.y, _196.z && _200.z, _196.w && _200.w)), lessThanEqual(abs(_179.wzxy), vec4(65504.0)));
    vec4 _206 = (vec4(_167, _168, _167, _168) * vec4(_166.yy, _165.yy)) * _205;
    vec4 _210 = _206 * (1.0 / max(dot(_206, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _212 = _179.w;
    float _216 = _179.z;
    float _220 = _179.x;
    float _224 = _179.y;
    vec4 _228 = vec4((_212 > 0.0) ? min(_212, 31.984375) : 0.0, (_216 > 0.0) ? min(_216, 31.984375) : 0.0, (_220 > 0.0) ? min(_220, 31.984375) : 0.0, (_224 > 0.0) ? min(_224, 31.984375) : 0.0);
    vec4 _229 = floor(_228);
    float _235 = dot(_210, min(_228 - _229, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _237 = vec2(dot(_210, _229) * 0.0322580635547637939453125, _235).yx;
    vec4 _241 = textureLod(gHistoryCacheStateFiltered, _155, 0.0);
    float _242 = _241.x;
    float _245 = (_242 > 0.0) ? min(_242, 255.0) : 0.0;
    float _252 = ((parameters.gHistoryValid > 0.5) && (abs(_235) <= 65504.0)) ? dot(_210, _205) : 0.0;
    float _264 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _266 = parameters.gSpeedPx.y - abs(length(fma(_90, parameters.gOutputSize.zw, -_155) * parameters.gOutputSize.xy));
    float _270 = ((_266 > 0.0) ? min(_266, _264) : 0.0) / _264;
    float _273 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _278 = _245 * _252;
    float _281 = (_278 > 0.0) ? min(_278, 255.0) : 0.0;
    float _285 = min(min(_281 / (_281 + 1.0), _273), ((_273 * _270) * _270) * fma(-2.0, _270, 3.0));
    vec2 _290 = mix(vec2(0.0), _117, bvec2(all(lessThanEqual(abs(_117), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _302 = mix(_117, mix(_290, _290 + ((_237 - _290) * clamp(_285, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_237), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_285 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_302.x > 0.0) ? min(_302.x, 1.0) : 0.0, 0.984375, floor(fma((_302.y > 0.0) ? min(_302.y, 1.0) : 0.0, 31.0, 0.5))), _121, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_245 > 0.0) ? min(_245, 255.0) : 0.0, (_252 > 0.0) ? min(_252, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

