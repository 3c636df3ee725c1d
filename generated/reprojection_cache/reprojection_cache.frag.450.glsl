#version 450

float _66;

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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _77 = textureLod(gInFresh, _73, 0.0);
    float _78 = _77.y;
    float _82 = ((_78 > 0.0) && (_78 < 65504.0)) ? _78 : 65504.0;
    float _83 = _77.x;
    vec2 _88 = mix(vec2(0.0), vec2(_83, 0.0), bvec2(abs(_83) <= 65504.0));
    vec4 _100 = parameters.gViewToPreviousClip * vec4(fma(_73, parameters.gViewRay.xy, parameters.gViewRay.zw) * _82, _82, 1.0);
    float _103 = _100.w;
    vec2 _108 = fma(_100.xy * (1.0 / _103), vec2(0.5, -0.5), vec2(0.5));
    vec2 _114 = mix(vec2(-8.0), _108, bvec2((_103 > 0.0) && all(lessThanEqual(abs(_108), vec2(8.0)))));
    float _116 = dot(_100.zw, parameters.gClipToDepth);
    vec2 _122 = _114 * parameters.gFrameToCoarse;
    vec4 _126 = textureLod(gHistoryCacheFiltered, _122, 0.0);
    float _127 = _126.x;
    vec2 _132 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_127, 0.0), bvec2(abs(_127) <= 65504.0));
    float _133 = _132.x;
    float _135 = _126.z;
    float _144 = max(fma(parameters.gMissThreshold.y, _82, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _150 = _144 - abs(((abs(_116) <= 9.9999996802856924650656260769173e+37) ? _116 : 0.0) - _126.w);
    float _153 = (_150 > 0.0) ? (_150 * (parameters.gConvergenceTime / _144)) : 0.0;
    float _169 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_133, _132.y, _135, _126.w).xy), vec2(65504.0)))) ? (((_153 > 0.0) && all(lessThanEqual(abs(fma(_114, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_153, 1.0) : 0.0) : 0.0;
    float _182 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _184 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_122) * parameters.gOutputSize.xy));
    float _188 = ((_184 > 0.0) ? min(_184, _182) : 0.0) / _182;
    float _191 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _198 = (_135 > 0.0) ? min(_135, 255.0) : 0.0;
    float _199 = _198 * _169;
    float _202 = (_199 > 0.0) ? min(_199, 255.0) : 0.0;
    float _206 = min(min(_202 / (_202 + 1.0), _191), ((_191 * _188) * _188) * fma(-2.0, _188, 3.0));
    float _207 = _88.x;
    bool _208 = _206 > 0.0;
    float _210 = _208 ? min(_206, 1.0) : 0.0;
    gOutCache = vec4(mix(_88, vec2((abs(_133) <= 9.9999996802856924650656260769173e+37) ? fma(_133, _210, _207 * (1.0 - _210)) : _207, _66), bvec2(_208)).x, 0.0, min(fma(_198, (_169 > 0.0) ? min(_169, 1.0) : 0.0, 1.0), 255.0), _82);
}

