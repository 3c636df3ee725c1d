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
    vec2 _79 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _83 = textureLod(gInFresh, _79, 0.0);
    vec4 _87 = textureLod(gInCoarseDepth, _79, 0.0);
    float _88 = _87.x;
    bvec4 _90 = lessThanEqual(abs(_83), vec4(65504.0));
    vec4 _91 = vec4(_90.x ? _83.x : vec4(0.0).x, _90.y ? _83.y : vec4(0.0).y, _90.z ? _83.z : vec4(0.0).z, _90.w ? _83.w : vec4(0.0).w);
    float _95 = ((_88 > 0.0) && (_88 < 65504.0)) ? _88 : 65504.0;
    vec4 _107 = parameters.gViewToPreviousClip * vec4((_79 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _95, _95, 1.0);
    float _110 = _107.w;
    vec2 _115 = (_107.xy * (1.0 / _110)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _120 = bvec2((_110 > 0.0) && all(lessThanEqual(abs(_115), vec2(8.0))));
    float _123 = dot(_107.zw, parameters.gClipToDepth);
    vec2 _129 = vec2(_120.x ? _115.x : vec2(-8.0).x, _120.y ? _115.y : vec2(-8.0).y) * parameters.gFrameToCoarse;
    float _135 = max(parameters.gMissThreshold.y * _95 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _139 = textureLod(gHistoryCacheFiltered, _129, 0.0);
    vec4 _143 = textureLod(gHistoryCacheStateFiltered, _129, 0.0);
    float _144 = _143.x;
    float _147 = (_144 > 0.0) ? min(_144, 255.0) : 0.0;
    float _154 = _135 - abs(((abs(_123) <= 9.9999996802856924650656260769173e+37) ? _123 : 0.0) - _143.y);
    float _157 = (_154 > 0.0) ? (_154 * (parameters.gConvergenceTime / _135)) : 0.0;
    vec4 _168 = abs(_139);
    float _172 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(_168, vec4(65504.0)))) ? (((_157 > 0.0) && all(lessThanEqual(floatBitsToUint(_129), uvec2(1065353216u)))) ? min(_157, 1.0) : 0.0) : 0.0;
    float _185 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _187 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_129)) * parameters.gOutputSize.xy));
    float _191 = ((_187 > 0.0) ? min(_187, _185) : 0.0) / _185;
    float _194 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _199 = _147 * _172;
    float _202 = (_199 > 0.0) ? min(_199, 255.0) : 0.0;
    float _206 = min(min(_202 / (_202 + 1.0), _194), ((_194 * _191) * _191) * ((-2.0) * _191 + 3.0));
    bvec4 _210 = bvec4(all(lessThanEqual(abs(_91), vec4(9.9999996802856924650656260769173e+37))));
    vec4 _211 = vec4(_210.x ? _91.x : vec4(0.0).x, _210.y ? _91.y : vec4(0.0).y, _210.z ? _91.z : vec4(0.0).z, _210.w ? _91.w : vec4(0.0).w);
    vec4 _217 = _211 + ((_139 - _211) * clamp(_206, 0.0, 1.0));
    bvec4 _218 = bvec4(all(lessThanEqual(_168, vec4(9.9999996802856924650656260769173e+37))));
    vec4 _219 = vec4(_218.x ? _217.x : _211.x, _218.y ? _217.y : _211.y, _218.z ? _217.z : _211.z, _218.w ? _217.w : _211.w);
    bvec4 _221 = bvec4(_206 > 0.0);
    gOutCache = vec4(_221.x ? _219.x : _91.x, _221.y ? _219.y : _91.y, _221.z ? _219.z : _91.z, _221.w ? _219.w : _91.w);
    gOutCacheState = vec4(min(((_147 > 0.0) ? min(_147, 255.0) : 0.0) * ((_172 > 0.0) ? min(_172, 1.0) : 0.0) + 1.0, 255.0), _95, 0.0, 0.0);
}

