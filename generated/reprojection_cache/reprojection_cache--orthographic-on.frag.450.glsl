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
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _77 = textureLod(gInFresh, _73, 0.0);
    float _78 = _77.y;
    float _79 = _77.x;
    float _82 = (abs(_79) <= 65504.0) ? _79 : 0.0;
    float _86 = ((_78 > 0.0) && (_78 < 65504.0)) ? _78 : 65504.0;
    vec4 _97 = parameters.gViewToPreviousClip * vec4(fma(_73, parameters.gViewRay.xy, parameters.gViewRay.zw), _86, 1.0);
    float _100 = _97.w;
    vec2 _105 = fma(_97.xy * (1.0 / _100), vec2(0.5, -0.5), vec2(0.5));
    float _113 = dot(_97.zw, parameters.gClipToDepth);
    vec2 _119 = mix(vec2(-8.0), _105, bvec2((_100 > 0.0) && all(lessThanEqual(abs(_105), vec2(8.0))))) * parameters.gFrameToCoarse;
    float _125 = max(fma(parameters.gMissThreshold.y, _86, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _129 = textureLod(gHistoryCacheFiltered, _119, 0.0);
    vec4 _133 = textureLod(gHistoryCacheStateFiltered, _119, 0.0);
    float _134 = _129.x;
    float _135 = _133.x;
    float _138 = (_135 > 0.0) ? min(_135, 255.0) : 0.0;
    float _145 = _125 - abs(((abs(_113) <= 9.9999996802856924650656260769173e+37) ? _113 : 0.0) - _129.y);
    float _148 = (_145 > 0.0) ? (_145 * (parameters.gConvergenceTime / _125)) : 0.0;
    float _159 = abs(_134);
    float _162 = ((parameters.gHistoryValid > 0.5) && (_159 <= 65504.0)) ? (((_148 > 0.0) && all(lessThanEqual(floatBitsToUint(_119), uvec2(1065353216u)))) ? min(_148, 1.0) : 0.0) : 0.0;
    float _175 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _177 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_119) * parameters.gOutputSize.xy));
    float _181 = ((_177 > 0.0) ? min(_177, _175) : 0.0) / _175;
    float _184 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _189 = _138 * _162;
    float _192 = (_189 > 0.0) ? min(_189, 255.0) : 0.0;
    float _196 = min(min(_192 / (_192 + 1.0), _184), ((_184 * _181) * _181) * fma(-2.0, _181, 3.0));
    float _199 = (abs(_82) <= 9.9999996802856924650656260769173e+37) ? _82 : 0.0;
    gOutCache = vec4((_196 > 0.0) ? ((_159 <= 9.9999996802856924650656260769173e+37) ? fma(_134 - _199, clamp(_196, 0.0, 1.0), _199) : _199) : _82, _86, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_138 > 0.0) ? min(_138, 255.0) : 0.0, (_162 > 0.0) ? min(_162, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

