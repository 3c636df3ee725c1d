#version 300 es
precision highp float;
precision highp int;

float _69;

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
uniform highp sampler2D gInVelocity;
uniform highp sampler2D gHistoryCacheFiltered;

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _76 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _80 = textureLod(gInFresh, _76, 0.0);
    float _81 = _80.y;
    float _85 = ((_81 > 0.0) && (_81 < 65504.0)) ? _81 : 65504.0;
    float _86 = _80.x;
    vec2 _89 = vec2(_86, 0.0);
    bvec2 _90 = bvec2(abs(_86) <= 65504.0);
    vec2 _91 = vec2(_90.x ? _89.x : vec2(0.0).x, _90.y ? _89.y : vec2(0.0).y);
    vec2 _94 = _76 / parameters.gFrameToCoarse;
    float _110 = dot((parameters.gViewToPreviousClip * vec4((_76 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _85, _85, 1.0)).zw, parameters.gClipToDepth);
    float _113 = (abs(_110) <= 9.9999996802856924650656260769173e+37) ? _110 : 0.0;
    vec2 _125 = (-textureLod(gInVelocity, _94 - ((parameters.gOutputSize.zw * 0.125) / parameters.gFrameToCoarse), 0.0).xy) * parameters.gMotionToUv + _94;
    bvec2 _129 = bvec2(all(lessThanEqual(abs(_125), vec2(8.0))));
    vec2 _130 = vec2(_129.x ? _125.x : vec2(-8.0).x, _129.y ? _125.y : vec2(-8.0).y);
    vec2 _134 = _130 * parameters.gFrameToCoarse;
    vec4 _138 = textureLod(gHistoryCacheFiltered, _134, 0.0);
    float _139 = _138.x;
    vec2 _142 = vec2(_139, 0.0);
    bvec2 _143 = bvec2(abs(_139) <= 65504.0);
    vec2 _144 = vec2(_143.x ? _142.x : vec2(1.9999999360571384930131252153835e+38).x, _143.y ? _142.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _145 = _144.x;
    float _147 = _138.z;
    float _156 = max(parameters.gMissThreshold.y * _85 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    float _162 = _156 - abs(((abs(_113) <= 9.9999996802856924650656260769173e+37) ? _113 : 0.0) - _138.w);
    float _165 = (_162 > 0.0) ? (_162 * (parameters.gConvergenceTime / _156)) : 0.0;
    float _181 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_145, _144.y, _147, _138.w).xy), vec2(65504.0)))) ? (((_165 > 0.0) && all(lessThanEqual(abs(_130 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_165, 1.0) : 0.0) : 0.0;
    float _194 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _196 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_134)) * parameters.gOutputSize.xy));
    float _200 = ((_196 > 0.0) ? min(_196, _194) : 0.0) / _194;
    float _203 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _210 = (_147 > 0.0) ? min(_147, 255.0) : 0.0;
    float _211 = _210 * _181;
    float _214 = (_211 > 0.0) ? min(_211, 255.0) : 0.0;
    float _218 = min(min(_214 / (_214 + 1.0), _203), ((_203 * _200) * _200) * ((-2.0) * _200 + 3.0));
    float _219 = _91.x;
    bool _220 = _218 > 0.0;
    float _222 = _220 ? min(_218, 1.0) : 0.0;
    vec2 _229 = vec2((abs(_145) <= 9.9999996802856924650656260769173e+37) ? (_145 * _222 + (_219 * (1.0 - _222))) : _219, _69);
    bvec2 _230 = bvec2(_220);
    gOutCache = vec4(vec2(_230.x ? _229.x : _91.x, _230.y ? _229.y : _91.y).x, 0.0, min(_210 * ((_181 > 0.0) ? min(_181, 1.0) : 0.0) + 1.0, 255.0), _85);
}

