#version 450

float _55;

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

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _62 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _66 = textureLod(gInFresh, _62, 0.0);
    float _67 = _66.y;
    float _71 = ((_67 > 0.0) && (_67 < 65504.0)) ? _67 : 65504.0;
    float _72 = _66.x;
    vec2 _77 = mix(vec2(0.0), vec2(_72, 0.0), bvec2(abs(_72) <= 65504.0));
    vec4 _81 = textureLod(gHistoryCache, _62, 0.0);
    float _82 = _81.x;
    vec2 _87 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_82, 0.0), bvec2(abs(_82) <= 65504.0));
    float _88 = _87.x;
    float _90 = _81.z;
    float _99 = max(fma(parameters.gMissThreshold.y, _71, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    float _105 = _99 - abs(_71 - _81.w);
    float _108 = (_105 > 0.0) ? (_105 * (parameters.gConvergenceTime / _99)) : 0.0;
    float _124 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_88, _87.y, _90, _81.w).xy), vec2(65504.0)))) ? (((_108 > 0.0) && all(lessThanEqual(abs(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, vec2(-0.5))), vec2(0.5)))) ? min(_108, 1.0) : 0.0) : 0.0;
    float _137 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _139 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_62) * parameters.gOutputSize.xy));
    float _143 = ((_139 > 0.0) ? min(_139, _137) : 0.0) / _137;
    float _146 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _153 = (_90 > 0.0) ? min(_90, 255.0) : 0.0;
    float _154 = _153 * _124;
    float _157 = (_154 > 0.0) ? min(_154, 255.0) : 0.0;
    float _161 = min(min(_157 / (_157 + 1.0), _146), ((_146 * _143) * _143) * fma(-2.0, _143, 3.0));
    float _162 = _77.x;
    bool _163 = _161 > 0.0;
    float _165 = _163 ? min(_161, 1.0) : 0.0;
    gOutCache = vec4(mix(_77, vec2((abs(_88) <= 9.9999996802856924650656260769173e+37) ? fma(_88, _165, _162 * (1.0 - _165)) : _162, _55), bvec2(_163)).x, 0.0, min(fma(_153, (_124 > 0.0) ? min(_124, 1.0) : 0.0, 1.0), 255.0), _71);
}

