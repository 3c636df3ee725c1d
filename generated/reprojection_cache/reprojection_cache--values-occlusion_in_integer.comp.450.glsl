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
    vec2 _113 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0)), bvec2(abs(_100) <= 65504.0));
    vec2 _116 = mix(vec2(0.0), _113, lessThanEqual(abs(_113), vec2(65504.0)));
    float _120 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
    vec4 _132 = parameters.gViewToPreviousClip * vec4(fma(_94, parameters.gViewRay.xy, parameters.gViewRay.zw) * _120, _120, 1.0);
    float _135 = _132.w;
    vec2 _140 = fma(_132.xy * (1.0 / _135), vec2(0.5, -0.5), vec2(0.5));
    float _148 = dot(_132.zw, parameters.gClipToDepth);
    vec2 _154 = mix(vec2(-8.0), _140, bvec2((_135 > 0.0) && all(lessThanEqual(abs(_140), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _160 = max(fma(parameters.gMissThreshold.y, _120, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _162 = fma(_154, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _163 = floor(_162);
    vec2 _164 = _162 - _163;
    vec2 _165 = vec2(1.0) - _164;
    float _166 = _165.x;
    float _167 = _164.x;
    vec2 _174 = (_163 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _178 = textureGather(gHistoryCache, _174);
    vec4 _190 = vec4(_160) - abs(vec4((abs(_148) <= 9.9999996802856924650656260769173e+37) ? _148 : 0.0) - textureGather(gHistoryCache, _174, 1).wzxy);
    vec4 _193 = mix(vec4(0.0), _190 * (parameters.gConvergenceTime / _160), greaterThan(_190, vec4(0.0)));
    bvec4 _195 = greaterThan(_193, vec4(0.0));
    bvec4 _199 = bvec4(all(lessThanEqual(floatBitsToUint(_154), uvec2(1065353216u))));
    vec4 _204 = mix(vec4(0.0), mix(vec4(0.0), min(_193, vec4(1.0)), bvec4(_195.x && _199.x, _195.y && _199.y, _195.z && _199.z, _195.w && _199.w)), lessThanEqual(abs(_178.wzxy), vec4(65504.0)));
    vec4 _205 = (vec4(_166, _167, _166, _167) * vec4(_165.yy, _164.yy)) * _204;
    vec4 _209 = _205 * (1.0 / max(dot(_205, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _211 = _178.w;
    float _215 = _178.z;
    float _219 = _178.x;
    float _223 = _178.y;
    vec4 _227 = vec4((_211 > 0.0) ? min(_211, 31.984375) : 0.0, (_215 > 0.0) ? min(_215, 31.984375) : 0.0, (_219 > 0.0) ? min(_219, 31.984375) : 0.0, (_223 > 0.0) ? min(_223, 31.984375) : 0.0);
    vec4 _228 = floor(_227);
    float _232 = dot(_209, _228) * 0.0322580635547637939453125;
    vec2 _235 = vec2(_232, dot(_209, min(_227 - _228, vec4(0.984375))) * 1.01587307453155517578125);
    vec4 _239 = textureLod(gHistoryCacheStateFiltered, _154, 0.0);
    float _240 = _239.x;
    float _243 = (_240 > 0.0) ? min(_240, 255.0) : 0.0;
    float _250 = ((parameters.gHistoryValid > 0.5) && (abs(_232) <= 65504.0)) ? dot(_209, _204) : 0.0;
    float _262 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _264 = parameters.gSpeedPx.y - abs(length(fma(_90, parameters.gOutputSize.zw, -_154) * parameters.gOutputSize.xy));
    float _268 = ((_264 > 0.0) ? min(_264, _262) : 0.0) / _262;
    float _271 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _276 = _243 * _250;
    float _279 = (_276 > 0.0) ? min(_276, 255.0) : 0.0;
    float _283 = min(min(_279 / (_279 + 1.0), _271), ((_271 * _268) * _268) * fma(-2.0, _268, 3.0));
    vec2 _288 = mix(vec2(0.0), _116, bvec2(all(lessThanEqual(abs(_116), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _300 = mix(_116, mix(_288, _288 + ((_235 - _288) * clamp(_283, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_235), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_283 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_300.y > 0.0) ? min(_300.y, 1.0) : 0.0, 0.984375, floor(fma((_300.x > 0.0) ? min(_300.x, 1.0) : 0.0, 31.0, 0.5))), _120, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_243 > 0.0) ? min(_243, 255.0) : 0.0, (_250 > 0.0) ? min(_250, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

