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
uniform highp sampler2D gHistoryCacheFiltered;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _101 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _105 = textureLod(gInFresh, _101, 0.0);
    float _106 = _105.y;
    float _107 = _105.x;
    float _110 = (abs(_107) <= 65504.0) ? _107 : 0.0;
    float _114 = ((_106 > 0.0) && (_106 < 65504.0)) ? _106 : 65504.0;
    vec2 _115 = floor(gl_FragCoord.xy);
    float _116 = _115.x;
    vec4 _126 = vec4(lessThan(abs((vec4(_116) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(16.0 * floor(_116 * 0.0625) + 7.5)), vec4(8.0)));
    float _127 = _115.y;
    vec4 _137 = vec4(lessThan(abs((vec4(_127) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(16.0 * floor(_127 * 0.0625) + 7.5)), vec4(8.0)));
    vec4 _141 = textureLod(gInFresh, (_115 + vec2(-0.5)) * parameters.gOutputSize.zw, 0.0);
    float _142 = _141.x;
    vec4 _149 = textureLod(gInFresh, (_115 + vec2(0.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _150 = _149.x;
    vec4 _157 = textureLod(gInFresh, (_115 + vec2(1.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _158 = _157.x;
    vec4 _165 = textureLod(gInFresh, (_115 + vec2(2.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _166 = _165.x;
    vec4 _173 = textureLod(gInFresh, (_115 + vec2(-0.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _174 = _173.x;
    vec4 _181 = textureLod(gInFresh, (_115 + vec2(0.5)) * parameters.gOutputSize.zw, 0.0);
    float _182 = _181.x;
    vec4 _189 = textureLod(gInFresh, (_115 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _190 = _189.x;
    vec4 _197 = textureLod(gInFresh, (_115 + vec2(2.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _198 = _197.x;
    vec4 _205 = textureLod(gInFresh, (_115 + vec2(-0.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _206 = _205.x;
    vec4 _213 = textureLod(gInFresh, (_115 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _214 = _213.x;
    vec4 _221 = textureLod(gInFresh, (_115 + vec2(1.5)) * parameters.gOutputSize.zw, 0.0);
    float _222 = _221.x;
    vec4 _229 = textureLod(gInFresh, (_115 + vec2(2.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _230 = _229.x;
    vec4 _237 = textureLod(gInFresh, (_115 + vec2(-0.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _238 = _237.x;
    vec4 _245 = textureLod(gInFresh, (_115 + vec2(0.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _246 = _245.x;
    vec4 _253 = textureLod(gInFresh, (_115 + vec2(1.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _254 = _253.x;
    vec4 _261 = textureLod(gInFresh, (_115 + vec2(2.5)) * parameters.gOutputSize.zw, 0.0);
    float _262 = _261.x;
    vec4 _266 = vec4((abs(_142) <= 65504.0) ? _142 : 0.0, (abs(_150) <= 65504.0) ? _150 : 0.0, (abs(_158) <= 65504.0) ? _158 : 0.0, (abs(_166) <= 65504.0) ? _166 : 0.0);
    vec4 _267 = vec4((abs(_174) <= 65504.0) ? _174 : 0.0, (abs(_182) <= 65504.0) ? _182 : 0.0, (abs(_190) <= 65504.0) ? _190 : 0.0, (abs(_198) <= 65504.0) ? _198 : 0.0);
    vec4 _268 = vec4((abs(_206) <= 65504.0) ? _206 : 0.0, (abs(_214) <= 65504.0) ? _214 : 0.0, (abs(_222) <= 65504.0) ? _222 : 0.0, (abs(_230) <= 65504.0) ? _230 : 0.0);
    vec4 _269 = vec4((abs(_238) <= 65504.0) ? _238 : 0.0, (abs(_246) <= 65504.0) ? _246 : 0.0, (abs(_254) <= 65504.0) ? _254 : 0.0, (abs(_262) <= 65504.0) ? _262 : 0.0);
    float _270 = _137.x;
    float _272 = _137.y;
    float _275 = _137.z;
    float _278 = _137.w;
    float _284 = 1.0 / (dot(_126, vec4(1.0)) * dot(_137, vec4(1.0)));
    float _285 = dot((((_266 * _270) + (_267 * _272)) + (_268 * _275)) + (_269 * _278), _126);
    vec4 _287 = vec4(_285 * _284);
    vec4 _288 = _266 - _287;
    vec4 _291 = _267 - _287;
    vec4 _295 = _268 - _287;
    vec4 _299 = _269 - _287;
    vec4 _317 = parameters.gViewToPreviousClip * vec4((_101 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _114, _114, 1.0);
    float _320 = _317.w;
    vec2 _325 = (_317.xy * (1.0 / _320)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _330 = bvec2((_320 > 0.0) && all(lessThanEqual(abs(_325), vec2(8.0))));
    float _333 = dot(_317.zw, parameters.gClipToDepth);
    vec2 _339 = vec2(_330.x ? _325.x : vec2(-8.0).x, _330.y ? _325.y : vec2(-8.0).y) * parameters.gFrameToCoarse;
    float _345 = max(parameters.gMissThreshold.y * _114 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _349 = textureLod(gHistoryCacheFiltered, _339, 0.0);
    vec4 _353 = textureLod(gHistoryCacheStateFiltered, _339, 0.0);
    float _354 = _349.x;
    float _355 = _353.x;
    float _358 = (_355 > 0.0) ? min(_355, 255.0) : 0.0;
    float _365 = _345 - abs(((abs(_333) <= 9.9999996802856924650656260769173e+37) ? _333 : 0.0) - _349.y);
    float _368 = (_365 > 0.0) ? (_365 * (parameters.gConvergenceTime / _345)) : 0.0;
    float _379 = abs(_354);
    float _382 = ((parameters.gHistoryValid > 0.5) && (_379 <= 65504.0)) ? (((_368 > 0.0) && all(lessThanEqual(floatBitsToUint(_339), uvec2(1065353216u)))) ? min(_368, 1.0) : 0.0) : 0.0;
    float _397 = (_382 > 0.0) ? (_382 * clamp(2.0 - (abs((-_285) * _284 + _354) / max(parameters.gChange.x * sqrt(dot(((((_288 * _288) * _270) + ((_291 * _291) * _272)) + ((_295 * _295) * _275)) + ((_299 * _299) * _278), _126) * _284) + parameters.gChange.y, 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _410 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _412 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_339)) * parameters.gOutputSize.xy));
    float _416 = ((_412 > 0.0) ? min(_412, _410) : 0.0) / _410;
    float _419 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _424 = _358 * _397;
    float _427 = (_424 > 0.0) ? min(_424, 255.0) : 0.0;
    float _431 = min(min(_427 / (_427 + 1.0), _419), ((_419 * _416) * _416) * ((-2.0) * _416 + 3.0));
    float _434 = (abs(_110) <= 9.9999996802856924650656260769173e+37) ? _110 : 0.0;
    gOutCache = vec4((_431 > 0.0) ? ((_379 <= 9.9999996802856924650656260769173e+37) ? ((_354 - _434) * clamp(_431, 0.0, 1.0) + _434) : _434) : _110, _114, 0.0, 0.0);
    gOutCacheState = vec4(min(((_358 > 0.0) ? min(_358, 255.0) : 0.0) * ((_397 > 0.0) ? min(_397, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

