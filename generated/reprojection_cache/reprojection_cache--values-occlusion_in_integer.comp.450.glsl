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
    vec2 _88 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
    vec2 _92 = _88 * parameters.gOutputSize.zw;
    vec4 _96 = textureLod(gInFresh, _92, 0.0);
    float _97 = _96.y;
    float _98 = _96.x;
    float _103 = (_98 > 0.0) ? min(_98, 31.984375) : 0.0;
    float _104 = floor(_103);
    vec2 _111 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_104 * 0.0322580635547637939453125, min((_103 - _104) * 1.01587307453155517578125, 1.0)), bvec2(abs(_98) <= 65504.0));
    vec2 _114 = mix(vec2(0.0), _111, lessThanEqual(abs(_111), vec2(65504.0)));
    float _118 = ((_97 > 0.0) && (_97 < 65504.0)) ? _97 : 65504.0;
    vec4 _130 = parameters.gViewToPreviousClip * vec4(fma(_92, parameters.gViewRay.xy, parameters.gViewRay.zw) * _118, _118, 1.0);
    float _133 = _130.w;
    vec2 _138 = fma(_130.xy * (1.0 / _133), vec2(0.5, -0.5), vec2(0.5));
    vec2 _144 = mix(vec2(-8.0), _138, bvec2((_133 > 0.0) && all(lessThanEqual(abs(_138), vec2(8.0)))));
    float _146 = dot(_130.zw, parameters.gClipToDepth);
    vec2 _152 = _144 * parameters.gFrameToCoarse;
    float _158 = max(fma(parameters.gMissThreshold.y, _118, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _160 = fma(_152, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _161 = floor(_160);
    vec2 _162 = _160 - _161;
    vec2 _163 = vec2(1.0) - _162;
    float _164 = _163.x;
    float _165 = _162.x;
    vec2 _172 = (_161 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _176 = textureGather(gHistoryCache, _172);
    vec4 _188 = vec4(_158) - abs(vec4((abs(_146) <= 9.9999996802856924650656260769173e+37) ? _146 : 0.0) - textureGather(gHistoryCache, _172, 1).wzxy);
    vec4 _191 = mix(vec4(0.0), _188 * (parameters.gConvergenceTime / _158), greaterThan(_188, vec4(0.0)));
    bvec4 _193 = greaterThan(_191, vec4(0.0));
    bvec4 _198 = bvec4(all(lessThanEqual(abs(fma(_144, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5))));
    vec4 _203 = mix(vec4(0.0), mix(vec4(0.0), min(_191, vec4(1.0)), bvec4(_193.x && _198.x, _193.y && _198.y, _193.z && _198.z, _193.w && _198.w)), lessThanEqual(abs(_176.wzxy), vec4(65504.0)));
    vec4 _204 = (vec4(_164, _165, _164, _165) * vec4(_163.yy, _162.yy)) * _203;
    vec4 _208 = _204 * (1.0 / max(dot(_204, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _210 = _176.w;
    float _214 = _176.z;
    float _218 = _176.x;
    float _222 = _176.y;
    vec4 _226 = vec4((_210 > 0.0) ? min(_210, 31.984375) : 0.0, (_214 > 0.0) ? min(_214, 31.984375) : 0.0, (_218 > 0.0) ? min(_218, 31.984375) : 0.0, (_222 > 0.0) ? min(_222, 31.984375) : 0.0);
    vec4 _227 = floor(_226);
    float _231 = dot(_208, _227) * 0.0322580635547637939453125;
    vec2 _234 = vec2(_231, dot(_208, min(_226 - _227, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _238 = textureLod(gHistoryCacheStateFiltered, _152, 0.0);
    float _239 = _238.x;
    float _242 = (_239 > 0.0) ? min(_239, 255.0) : 0.0;
    float _249 = ((parameters.gHistoryValid > 0.5) && (abs(_231) <= 65504.0)) ? dot(_208, _203) : 0.0;
    float _261 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _263 = parameters.gSpeedPx.y - abs(length(fma(_88, parameters.gOutputSize.zw, -_152) * parameters.gOutputSize.xy));
    float _267 = ((_263 > 0.0) ? min(_263, _261) : 0.0) / _261;
    float _270 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _275 = _242 * _249;
    float _278 = (_275 > 0.0) ? min(_275, 255.0) : 0.0;
    float _282 = min(min(_278 / (_278 + 1.0), _270), ((_270 * _267) * _267) * fma(-2.0, _267, 3.0));
    vec2 _287 = mix(vec2(0.0), _114, bvec2(all(lessThanEqual(abs(_114), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _299 = mix(_114, mix(_287, _287 + ((_234 - _287) * clamp(_282, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_234), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_282 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_299.y > 0.0) ? min(_299.y, 1.0) : 0.0, 0.984375, floor(fma((_299.x > 0.0) ? min(_299.x, 1.0) : 0.0, 31.0, 0.5))), _118, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_242 > 0.0) ? min(_242, 255.0) : 0.0, (_249 > 0.0) ? min(_249, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

