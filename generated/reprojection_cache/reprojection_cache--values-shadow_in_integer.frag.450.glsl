#version 450

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

layout(binding = 1) uniform sampler2D gInFresh;
layout(binding = 3) uniform sampler2D gHistoryCache;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _87 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _91 = textureLod(gInFresh, _87, 0.0);
    float _92 = _91.y;
    float _93 = _91.x;
    float _98 = (_93 > 0.0) ? min(_93, 31.984375) : 0.0;
    float _99 = floor(_98);
    vec2 _107 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_99 * 0.0322580635547637939453125, min((_98 - _99) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_93) <= 65504.0));
    vec2 _110 = mix(vec2(0.0), _107, lessThanEqual(abs(_107), vec2(65504.0)));
    float _114 = ((_92 > 0.0) && (_92 < 65504.0)) ? _92 : 65504.0;
    vec4 _126 = parameters.gViewToPreviousClip * vec4(fma(_87, parameters.gViewRay.xy, parameters.gViewRay.zw) * _114, _114, 1.0);
    float _129 = _126.w;
    vec2 _134 = fma(_126.xy * (1.0 / _129), vec2(0.5, -0.5), vec2(0.5));
    vec2 _140 = mix(vec2(-8.0), _134, bvec2((_129 > 0.0) && all(lessThanEqual(abs(_134), vec2(8.0)))));
    float _142 = dot(_126.zw, parameters.gClipToDepth);
    vec2 _148 = _140 * parameters.gFrameToCoarse;
    float _154 = max(fma(parameters.gMissThreshold.y, _114, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec2 _156 = fma(_148, parameters.gOutputSize.xy, vec2(-0.5));
    vec2 _157 = floor(_156);
    vec2 _158 = _156 - _157;
    vec2 _159 = vec2(1.0) - _158;
    float _160 = _159.x;
    float _161 = _158.x;
    vec2 _168 = (_157 + vec2(1.0)) * parameters.gOutputSize.zw;
    vec4 _172 = textureGather(gHistoryCache, _168);
    vec4 _184 = vec4(_154) - abs(vec4((abs(_142) <= 9.9999996802856924650656260769173e+37) ? _142 : 0.0) - textureGather(gHistoryCache, _168, 1).wzxy);
    vec4 _187 = mix(vec4(0.0), _184 * (parameters.gConvergenceTime / _154), greaterThan(_184, vec4(0.0)));
    bvec4 _189 = greaterThan(_187, vec4(0.0));
    bvec4 _194 = bvec4(all(lessThanEqual(abs(fma(_140, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5))));
    vec4 _199 = mix(vec4(0.0), mix(vec4(0.0), min(_187, vec4(1.0)), bvec4(_189.x && _194.x, _189.y && _194.y, _189.z && _194.z, _189.w && _194.w)), lessThanEqual(abs(_172.wzxy), vec4(65504.0)));
    vec4 _200 = (vec4(_160, _161, _160, _161) * vec4(_159.yy, _158.yy)) * _199;
    vec4 _204 = _200 * (1.0 / max(dot(_200, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    float _206 = _172.w;
    float _210 = _172.z;
    float _214 = _172.x;
    float _218 = _172.y;
    vec4 _222 = vec4((_206 > 0.0) ? min(_206, 31.984375) : 0.0, (_210 > 0.0) ? min(_210, 31.984375) : 0.0, (_214 > 0.0) ? min(_214, 31.984375) : 0.0, (_218 > 0.0) ? min(_218, 31.984375) : 0.0);
    vec4 _223 = floor(_222);
    float _229 = dot(_204, min(_222 - _223, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _231 = vec2(dot(_204, _223) * 0.0322580635547637939453125, _229).yx;
    vec4 _235 = textureLod(gHistoryCacheStateFiltered, _148, 0.0);
    float _236 = _235.x;
    float _239 = (_236 > 0.0) ? min(_236, 255.0) : 0.0;
    float _246 = ((parameters.gHistoryValid > 0.5) && (abs(_229) <= 65504.0)) ? dot(_204, _199) : 0.0;
    float _258 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _260 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_148) * parameters.gOutputSize.xy));
    float _264 = ((_260 > 0.0) ? min(_260, _258) : 0.0) / _258;
    float _267 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _272 = _239 * _246;
    float _275 = (_272 > 0.0) ? min(_272, 255.0) : 0.0;
    float _279 = min(min(_275 / (_275 + 1.0), _267), ((_267 * _264) * _264) * fma(-2.0, _264, 3.0));
    vec2 _284 = mix(vec2(0.0), _110, bvec2(all(lessThanEqual(abs(_110), vec2(9.9999996802856924650656260769173e+37)))));
    vec2 _296 = mix(_110, mix(_284, _284 + ((_231 - _284) * clamp(_279, 0.0, 1.0)), bvec2(all(lessThanEqual(abs(_231), vec2(9.9999996802856924650656260769173e+37))))), bvec2(_279 > 0.0));
    float _305 = _296.x;
    float _306 = _296.y;
    gOutCache = vec4(fma((_305 > 0.0) ? min(_305, 1.0) : 0.0, 0.984375, floor(fma((_306 > 0.0) ? min(_306, 1.0) : 0.0, 31.0, 0.5))), _114, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_239 > 0.0) ? min(_239, 255.0) : 0.0, (_246 > 0.0) ? min(_246, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

