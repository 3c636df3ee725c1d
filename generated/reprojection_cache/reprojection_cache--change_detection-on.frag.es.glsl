#version 300 es
precision highp float;
precision highp int;

float _77;

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

layout(location = 0) out vec4 gOutCache;

void main()
{
    vec2 _84 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _88 = textureLod(gInFresh, _84, 0.0);
    float _89 = _88.y;
    float _93 = ((_89 > 0.0) && (_89 < 65504.0)) ? _89 : 65504.0;
    float _94 = _88.x;
    vec2 _97 = vec2(_94, 0.0);
    bvec2 _98 = bvec2(abs(_94) <= 65504.0);
    vec2 _99 = vec2(_98.x ? _97.x : vec2(0.0).x, _98.y ? _97.y : vec2(0.0).y);
    vec4 _111 = parameters.gViewToPreviousClip * vec4((_84 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _93, _93, 1.0);
    float _114 = _111.w;
    vec2 _119 = (_111.xy * (1.0 / _114)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _124 = bvec2((_114 > 0.0) && all(lessThanEqual(abs(_119), vec2(8.0))));
    vec2 _125 = vec2(_124.x ? _119.x : vec2(-8.0).x, _124.y ? _119.y : vec2(-8.0).y);
    float _127 = dot(_111.zw, parameters.gClipToDepth);
    vec2 _133 = _125 * parameters.gFrameToCoarse;
    vec4 _137 = textureLod(gHistoryCacheFiltered, _133, 0.0);
    float _138 = _137.x;
    vec2 _141 = vec2(_138, 0.0);
    bvec2 _142 = bvec2(abs(_138) <= 65504.0);
    vec2 _143 = vec2(_142.x ? _141.x : vec2(1.9999999360571384930131252153835e+38).x, _142.y ? _141.y : vec2(1.9999999360571384930131252153835e+38).y);
    float _144 = _143.x;
    float _146 = _137.z;
    float _155 = max(parameters.gMissThreshold.y * _93 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    float _161 = _155 - abs(((abs(_127) <= 9.9999996802856924650656260769173e+37) ? _127 : 0.0) - _137.w);
    float _164 = (_161 > 0.0) ? (_161 * (parameters.gConvergenceTime / _155)) : 0.0;
    float _180 = ((parameters.gHistoryValid > 0.5) && all(lessThanEqual(abs(vec4(_144, _143.y, _146, _137.w).xy), vec2(65504.0)))) ? (((_164 > 0.0) && all(lessThanEqual(abs(_125 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_164, 1.0) : 0.0) : 0.0;
    vec2 _182 = parameters.gOutputSize.zw * 0.5;
    vec2 _184 = gl_FragCoord.xy * parameters.gOutputSize.zw + (-_182);
    float _194 = _182.x;
    float _195 = _182.y;
    vec2 _197 = vec2(_194, -_195);
    vec2 _203 = vec2(-_194, _195);
    vec4 _207 = vec4(textureLod(gInFresh, _184 - _182, 0.0).x, textureLod(gInFresh, _184 + _182, 0.0).x, textureLod(gInFresh, _184 + _197, 0.0).x, textureLod(gInFresh, _184 + _203, 0.0).x);
    bvec4 _209 = lessThanEqual(abs(_207), vec4(65504.0));
    vec4 _210 = vec4(_209.x ? _207.x : vec4(0.0).x, _209.y ? _207.y : vec4(0.0).y, _209.z ? _207.z : vec4(0.0).z, _209.w ? _207.w : vec4(0.0).w);
    vec2 _212 = gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(1.5, -0.5) * parameters.gOutputSize.zw);
    vec4 _229 = vec4(textureLod(gInFresh, _212 - _182, 0.0).x, textureLod(gInFresh, _212 + _182, 0.0).x, textureLod(gInFresh, _212 + _197, 0.0).x, textureLod(gInFresh, _212 + _203, 0.0).x);
    bvec4 _231 = lessThanEqual(abs(_229), vec4(65504.0));
    vec4 _232 = vec4(_231.x ? _229.x : vec4(0.0).x, _231.y ? _229.y : vec4(0.0).y, _231.z ? _229.z : vec4(0.0).z, _231.w ? _229.w : vec4(0.0).w);
    vec2 _234 = gl_FragCoord.xy * parameters.gOutputSize.zw + (vec2(-0.5, 1.5) * parameters.gOutputSize.zw);
    vec4 _251 = vec4(textureLod(gInFresh, _234 - _182, 0.0).x, textureLod(gInFresh, _234 + _182, 0.0).x, textureLod(gInFresh, _234 + _197, 0.0).x, textureLod(gInFresh, _234 + _203, 0.0).x);
    bvec4 _253 = lessThanEqual(abs(_251), vec4(65504.0));
    vec4 _254 = vec4(_253.x ? _251.x : vec4(0.0).x, _253.y ? _251.y : vec4(0.0).y, _253.z ? _251.z : vec4(0.0).z, _253.w ? _251.w : vec4(0.0).w);
    vec2 _256 = gl_FragCoord.xy * parameters.gOutputSize.zw + (parameters.gOutputSize.zw * 1.5);
    vec4 _273 = vec4(textureLod(gInFresh, _256 - _182, 0.0).x, textureLod(gInFresh, _256 + _182, 0.0).x, textureLod(gInFresh, _256 + _197, 0.0).x, textureLod(gInFresh, _256 + _203, 0.0).x);
    bvec4 _275 = lessThanEqual(abs(_273), vec4(65504.0));
    vec4 _276 = vec4(_275.x ? _273.x : vec4(0.0).x, _275.y ? _273.y : vec4(0.0).y, _275.z ? _273.z : vec4(0.0).z, _275.w ? _273.w : vec4(0.0).w);
    float _280 = dot(((_210 + _232) + _254) + _276, vec4(0.0625));
    vec4 _281 = vec4(_280);
    vec4 _282 = _210 - _281;
    vec4 _283 = _232 - _281;
    vec4 _284 = _254 - _281;
    vec4 _285 = _276 - _281;
    float _304 = (_180 > 0.0) ? (_180 * clamp(2.0 - (abs(_144 - _280) / max(parameters.gChange.x * sqrt(dot(_285 * _285 + (_284 * _284 + (_282 * _282 + (_283 * _283))), vec4(0.0625))) + parameters.gChange.y, 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _317 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _319 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_133)) * parameters.gOutputSize.xy));
    float _323 = ((_319 > 0.0) ? min(_319, _317) : 0.0) / _317;
    float _326 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _333 = (_146 > 0.0) ? min(_146, 255.0) : 0.0;
    float _334 = _333 * _304;
    float _337 = (_334 > 0.0) ? min(_334, 255.0) : 0.0;
    float _341 = min(min(_337 / (_337 + 1.0), _326), ((_326 * _323) * _323) * ((-2.0) * _323 + 3.0));
    float _342 = _99.x;
    bool _343 = _341 > 0.0;
    float _345 = _343 ? min(_341, 1.0) : 0.0;
    vec2 _352 = vec2((abs(_144) <= 9.9999996802856924650656260769173e+37) ? (_144 * _345 + (_342 * (1.0 - _345))) : _342, _77);
    bvec2 _353 = bvec2(_343);
    gOutCache = vec4(vec2(_353.x ? _352.x : _99.x, _353.y ? _352.y : _99.y).x, 0.0, min(_333 * ((_304 > 0.0) ? min(_304, 1.0) : 0.0) + 1.0, 255.0), _93);
}

