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
layout(binding = 4) uniform sampler2D gHistoryCacheFiltered;
layout(binding = 6) uniform sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _71 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _75 = textureLod(gInFresh, _71, 0.0);
    float _76 = _75.y;
    float _77 = _75.x;
    float _80 = (abs(_77) <= 65504.0) ? _77 : 0.0;
    float _84 = ((_76 > 0.0) && (_76 < 65504.0)) ? _76 : 65504.0;
    vec4 _96 = parameters.gViewToPreviousClip * vec4(fma(_71, parameters.gViewRay.xy, parameters.gViewRay.zw) * _84, _84, 1.0);
    float _99 = _96.w;
    vec2 _104 = fma(_96.xy * (1.0 / _99), vec2(0.5, -0.5), vec2(0.5));
    vec2 _110 = mix(vec2(-8.0), _104, bvec2((_99 > 0.0) && all(lessThanEqual(abs(_104), vec2(8.0)))));
    float _112 = dot(_96.zw, parameters.gClipToDepth);
    vec2 _118 = _110 * parameters.gFrameToCoarse;
    float _124 = max(fma(parameters.gMissThreshold.y, _84, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _128 = textureLod(gHistoryCacheFiltered, _118, 0.0);
    vec4 _132 = textureLod(gHistoryCacheStateFiltered, _118, 0.0);
    float _133 = _128.x;
    float _134 = _132.x;
    float _137 = (_134 > 0.0) ? min(_134, 255.0) : 0.0;
    float _144 = _124 - abs(((abs(_112) <= 9.9999996802856924650656260769173e+37) ? _112 : 0.0) - _128.y);
    float _147 = (_144 > 0.0) ? (_144 * (parameters.gConvergenceTime / _124)) : 0.0;
    float _159 = abs(_133);
    float _162 = ((parameters.gHistoryValid > 0.5) && (_159 <= 65504.0)) ? (((_147 > 0.0) && all(lessThanEqual(abs(fma(_110, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_147, 1.0) : 0.0) : 0.0;
    float _175 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _177 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_118) * parameters.gOutputSize.xy));
    float _181 = ((_177 > 0.0) ? min(_177, _175) : 0.0) / _175;
    float _184 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _189 = _137 * _162;
    float _192 = (_189 > 0.0) ? min(_189, 255.0) : 0.0;
    float _196 = min(min(_192 / (_192 + 1.0), _184), ((_184 * _181) * _181) * fma(-2.0, _181, 3.0));
    float _199 = (abs(_80) <= 9.9999996802856924650656260769173e+37) ? _80 : 0.0;
    gOutCache = vec4((_196 > 0.0) ? ((_159 <= 9.9999996802856924650656260769173e+37) ? fma(_133 - _199, clamp(_196, 0.0, 1.0), _199) : _199) : _80, _84, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_137 > 0.0) ? min(_137, 255.0) : 0.0, (_162 > 0.0) ? min(_162, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

