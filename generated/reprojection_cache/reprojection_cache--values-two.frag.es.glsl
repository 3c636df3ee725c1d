#version 300 es
precision highp float;
precision highp int;

layout(std140) uniform ReprojectionCacheParameters
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

uniform highp sampler2D gInFresh;
uniform highp sampler2D gInCoarseDepth;
uniform highp sampler2D gHistoryCacheFiltered;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _76 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _84 = textureLod(gInCoarseDepth, _76, 0.0);
    float _85 = _84.x;
    vec2 _86 = textureLod(gInFresh, _76, 0.0).xy;
    bvec2 _88 = lessThanEqual(abs(_86), vec2(65504.0));
    vec2 _89 = vec2(_88.x ? _86.x : vec2(0.0).x, _88.y ? _86.y : vec2(0.0).y);
    float _93 = ((_85 > 0.0) && (_85 < 65504.0)) ? _85 : 65504.0;
    vec4 _105 = parameters.gViewToPreviousClip * vec4((_76 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _93, _93, 1.0);
    float _108 = _105.w;
    vec2 _113 = (_105.xy * (1.0 / _108)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _118 = bvec2((_108 > 0.0) && all(lessThanEqual(abs(_113), vec2(8.0))));
    vec2 _119 = vec2(_118.x ? _113.x : vec2(-8.0).x, _118.y ? _113.y : vec2(-8.0).y);
    float _121 = dot(_105.zw, parameters.gClipToDepth);
    vec2 _127 = _119 * parameters.gFrameToCoarse;
    float _133 = max(parameters.gMissThreshold.y * _93 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _141 = textureLod(gHistoryCacheStateFiltered, _127, 0.0);
    vec2 _142 = textureLod(gHistoryCacheFiltered, _127, 0.0).xy;
    float _143 = _141.x;
    float _146 = (_143 > 0.0) ? min(_143, 255.0) : 0.0;
    float _153 = _133 - abs(((abs(_121) <= 9.9999996802856924650656260769173e+37) ? _121 : 0.0) - _141.y);
    float _156 = (_153 > 0.0) ? (_153 * (parameters.gConvergenceTime / _133)) : 0.0;
    vec2 _168 = abs(_142);
    float _172 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_168, vec2(65504.0)))) ? (((_156 > 0.0) && all(lessThanEqual(abs(_119 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_156, 1.0) : 0.0) : 0.0;
    float _185 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _187 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_127)) * parameters.gOutputSize.xy));
    float _191 = ((_187 > 0.0) ? min(_187, _185) : 0.0) / _185;
    float _194 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _199 = _146 * _172;
    float _202 = (_199 > 0.0) ? min(_199, 255.0) : 0.0;
    float _206 = min(min(_202 / (_202 + 1.0), _194), ((_194 * _191) * _191) * ((-2.0) * _191 + 3.0));
    bvec2 _210 = bvec2(all(lessThanEqual(abs(_89), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _211 = vec2(_210.x ? _89.x : vec2(0.0).x, _210.y ? _89.y : vec2(0.0).y);
    vec2 _217 = _211 + ((_142 - _211) * clamp(_206, 0.0, 1.0));
    bvec2 _218 = bvec2(all(lessThanEqual(_168, vec2(9.9999996802856924650656260769173e+37))));
    vec2 _219 = vec2(_218.x ? _217.x : _211.x, _218.y ? _217.y : _211.y);
    bvec2 _221 = bvec2(_206 > 0.0);
    gOutCache = vec4(vec2(_221.x ? _219.x : _89.x, _221.y ? _219.y : _89.y), 0.0, 0.0);
    gOutCacheState = vec4(min(((_146 > 0.0) ? min(_146, 255.0) : 0.0) * ((_172 > 0.0) ? min(_172, 1.0) : 0.0) + 1.0, 255.0), _93, 0.0, 0.0);
}

