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
    vec2 _113 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0)), bvec2(abs(_100) <= 65504.0));
    vec2 _116 = mix(vec2(0.0), _113, lessThanEqual(abs(_113), vec2(65504.0)));
    float _120 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
    vec4 _132 = parameters.gViewToPreviousClip * vec4(fma(_94, parameters.gViewRay.xy, parameters.gViewRay.zw) * _120, _120, 1.0);
    float _135 = _132.w;
    vec2 _140 = fma(_132.xy * (1.0 / _135), vec2(0.5, -0.5), vec2(0.5));
    vec2 _146 = mix(vec2(-8.0), _140, bvec2((_135 > 0.0) && all(lessThanEqual(abs(_140), vec2(8.0)))));
    float _148 = dot(_132.zw, parameters.gClipToDepth);
    vec2 _154 = _146 * parameters.gFrameToCoarse;
    vec4 _158 = textureLod(gHistoryCacheStateFiltered, _154, 0.0);
    vec2 _160 = fma(_154, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _161 = floor(_160);
    vec2 _163 = (_161 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _167 = textureGather(gHistoryCache, _163);
    vec4 _171 = textureGather(gHistoryCache, _163, 1).wzxy;
    vec2 _172 = _160 - _161;
    vec2 _173 = vec2(1.0) - _172;
    float _174 = _173.x;
    float _175 = _172.x;
    vec4 _187 = mix(vec4(0.0), (vec4(_174, _175, _174, _175) * vec4(_173.yy, _172.yy)) * vec4(lessThanEqual(abs(_171), vec4(9.9999996802856924650656260769173e+37))), lessThanEqual(abs(_167.wzxy), vec4(65504.0)));
    float _190 = _167.w;
    float _194 = _167.z;
    float _198 = _167.x;
    float _202 = _167.y;
    vec4 _206 = vec4((_190 > 0.0) ? min(_190, 31.984375) : 0.0, (_194 > 0.0) ? min(_194, 31.984375) : 0.0, (_198 > 0.0) ? min(_198, 31.984375) : 0.0, (_202 > 0.0) ? min(_202, 31.984375) : 0.0);
    vec4 _207 = floor(_206);
    vec3 _219 = vec3(dot(_187, _207) * 0.0322580635547637939453125, dot(_187, min(_206 - _207, vec4(0.984375))) * 1.01587307453155517578125, dot(_187, mix(vec4(0.0), _171, greaterThan(_187, vec4(0.0))))) / vec3(max(dot(_187, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec2 _220 = _219.xy;
    float _222 = _158.x;
    float _225 = (_222 > 0.0) ? min(_222, 255.0) : 0.0;
    float _231 = max(fma(parameters.gMissThreshold.y, _120, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _237 = _231 - abs(((abs(_148) <= 9.9999996802856924650656260769173e+37) ? _148 : 0.0) - _219.z);
    float _240 = (_237 > 0.0) ? (_237 * (parameters.gConvergenceTime / _231)) : 0.0;
    float _256 = ((parameters.gHistoryValid > 0.5) && (abs(_219.x) <= 65504.0)) ? (((_240 > 0.0) && all(lessThanEqual(abs(fma(_146, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_240, 1.0) : 0.0) : 0.0;
    float _268 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _270 = parameters.gSpeedPx.y - abs(length(fma(_90, parameters.gOutputSize.zw, -_154) * parameters.gOutputSize.xy));
    float _274 = ((_270 > 0.0) ? min(_270, _268) : 0.0) / _268;
    float _277 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _282 = _225 * _256;
    float _285 = (_282 > 0.0) ? min(_282, 255.0) : 0.0;
    float _289 = min(min(_285 / (_285 + 1.0), _277), ((_277 * _274) * _274) * fma(-2.0, _274, 3.0));
    vec2 _294 = mix(vec2(0.0), _116, bvec2(all(lessThanEqual(abs(_116), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _306 = mix(_116, mix(_294, _294 + ((_220 - _294) * clamp(_289, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_220), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_289 > 0.0));
    imageStore(gOutCache, ivec2(gl_GlobalInvocationID.xy), vec4(fma((_306.y > 0.0) ? min(_306.y, 1.0) : 0.0, 0.984375, floor(fma((_306.x > 0.0) ? min(_306.x, 1.0) : 0.0, 31.0, 0.5))), _120, 0.0, 0.0));
    imageStore(gOutCacheState, ivec2(gl_GlobalInvocationID.xy), vec4(min(fma((_225 > 0.0) ? min(_225, 255.0) : 0.0, (_256 > 0.0) ? min(_256, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0));
}

