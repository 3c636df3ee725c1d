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
    vec4 _99 = parameters.gViewToPreviousClip * vec4(fma(_73, parameters.gViewRay.xy, parameters.gViewRay.zw), _82, 1.0);
    float _102 = _99.w;
    vec2 _107 = fma(_99.xy * (1.0 / _102), vec2(0.5, -0.5), vec2(0.5));
    vec2 _113 = mix(vec2(-8.0), _107, bvec2((_102 > 0.0) && all(lessThanEqual(abs(_107), vec2(8.0)))));
    float _115 = dot(_99.zw, parameters.gClipToDepth);
    vec2 _121 = _113 * parameters.gFrameToCoarse;
    vec4 _125 = textureLod(gHistoryCacheFiltered, _121, 0.0);
    float _126 = _125.x;
    vec2 _131 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_126, 0.0), bvec2(abs(_126) <= 65504.0));
    float _132 = _131.x;
    float _134 = _125.z;
    float _143 = max(fma(parameters.gMissThreshold.y, _82, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _149 = _143 - abs(((abs(_115) <= 9.9999996802856924650656260769173e+37) ? _115 : 0.0) - _125.w);
    float _152 = (_149 > 0.0) ? (_149 * (parameters.gConvergenceTime / _143)) : 0.0;
    float _168 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_132, _131.y, _134, _125.w).xy), vec2(65504.0)))) ? (((_152 > 0.0) && all(lessThanEqual(abs(fma(_113, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_152, 1.0) : 0.0) : 0.0;
    float _181 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _183 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_121) * parameters.gOutputSize.xy));
    float _187 = ((_183 > 0.0) ? min(_183, _181) : 0.0) / _181;
    float _190 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _197 = (_134 > 0.0) ? min(_134, 255.0) : 0.0;
    float _198 = _197 * _168;
    float _201 = (_198 > 0.0) ? min(_198, 255.0) : 0.0;
    float _205 = min(min(_201 / (_201 + 1.0), _190), ((_190 * _187) * _187) * fma(-2.0, _187, 3.0));
    float _206 = _88.x;
    bool _207 = _205 > 0.0;
    float _209 = _207 ? min(_205, 1.0) : 0.0;
    gOutCache = vec4(mix(_88, vec2((abs(_132) <= 9.9999996802856924650656260769173e+37) ? fma(_132, _209, _206 * (1.0 - _209)) : _206, _66), bvec2(_207)).x, 0.0, min(fma(_197, (_168 > 0.0) ? min(_168, 1.0) : 0.0, 1.0), 255.0), _82);
}

