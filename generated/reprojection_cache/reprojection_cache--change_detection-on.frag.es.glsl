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
    vec2 _98 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _102 = textureLod(gInFresh, _98, 0.0);
    float _103 = _102.y;
    float _104 = _102.x;
    float _107 = (abs(_104) <= 65504.0) ? _104 : 0.0;
    float _111 = ((_103 > 0.0) && (_103 < 65504.0)) ? _103 : 65504.0;
    vec2 _112 = floor(gl_FragCoord.xy);
    float _113 = _112.x;
    vec4 _123 = vec4(lessThan(abs((vec4(_113) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(16.0 * floor(_113 * 0.0625) + 7.5)), vec4(8.0)));
    float _124 = _112.y;
    vec4 _134 = vec4(lessThan(abs((vec4(_124) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(16.0 * floor(_124 * 0.0625) + 7.5)), vec4(8.0)));
    vec4 _138 = textureLod(gInFresh, (_112 + vec2(-0.5)) * parameters.gOutputSize.zw, 0.0);
    float _139 = _138.x;
    vec4 _146 = textureLod(gInFresh, (_112 + vec2(0.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _147 = _146.x;
    vec4 _154 = textureLod(gInFresh, (_112 + vec2(1.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _155 = _154.x;
    vec4 _162 = textureLod(gInFresh, (_112 + vec2(2.5, -0.5)) * parameters.gOutputSize.zw, 0.0);
    float _163 = _162.x;
    vec4 _170 = textureLod(gInFresh, (_112 + vec2(-0.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _171 = _170.x;
    vec4 _178 = textureLod(gInFresh, (_112 + vec2(0.5)) * parameters.gOutputSize.zw, 0.0);
    float _179 = _178.x;
    vec4 _186 = textureLod(gInFresh, (_112 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _187 = _186.x;
    vec4 _194 = textureLod(gInFresh, (_112 + vec2(2.5, 0.5)) * parameters.gOutputSize.zw, 0.0);
    float _195 = _194.x;
    vec4 _202 = textureLod(gInFresh, (_112 + vec2(-0.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _203 = _202.x;
    vec4 _210 = textureLod(gInFresh, (_112 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _211 = _210.x;
    vec4 _218 = textureLod(gInFresh, (_112 + vec2(1.5)) * parameters.gOutputSize.zw, 0.0);
    float _219 = _218.x;
    vec4 _226 = textureLod(gInFresh, (_112 + vec2(2.5, 1.5)) * parameters.gOutputSize.zw, 0.0);
    float _227 = _226.x;
    vec4 _234 = textureLod(gInFresh, (_112 + vec2(-0.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _235 = _234.x;
    vec4 _242 = textureLod(gInFresh, (_112 + vec2(0.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _243 = _242.x;
    vec4 _250 = textureLod(gInFresh, (_112 + vec2(1.5, 2.5)) * parameters.gOutputSize.zw, 0.0);
    float _251 = _250.x;
    vec4 _258 = textureLod(gInFresh, (_112 + vec2(2.5)) * parameters.gOutputSize.zw, 0.0);
    float _259 = _258.x;
    vec4 _263 = vec4((abs(_139) <= 65504.0) ? _139 : 0.0, (abs(_147) <= 65504.0) ? _147 : 0.0, (abs(_155) <= 65504.0) ? _155 : 0.0, (abs(_163) <= 65504.0) ? _163 : 0.0);
    vec4 _264 = vec4((abs(_171) <= 65504.0) ? _171 : 0.0, (abs(_179) <= 65504.0) ? _179 : 0.0, (abs(_187) <= 65504.0) ? _187 : 0.0, (abs(_195) <= 65504.0) ? _195 : 0.0);
    vec4 _265 = vec4((abs(_203) <= 65504.0) ? _203 : 0.0, (abs(_211) <= 65504.0) ? _211 : 0.0, (abs(_219) <= 65504.0) ? _219 : 0.0, (abs(_227) <= 65504.0) ? _227 : 0.0);
    vec4 _266 = vec4((abs(_235) <= 65504.0) ? _235 : 0.0, (abs(_243) <= 65504.0) ? _243 : 0.0, (abs(_251) <= 65504.0) ? _251 : 0.0, (abs(_259) <= 65504.0) ? _259 : 0.0);
    float _267 = _134.x;
    float _269 = _134.y;
    float _272 = _134.z;
    float _275 = _134.w;
    float _281 = 1.0 / (dot(_123, vec4(1.0)) * dot(_134, vec4(1.0)));
    float _282 = dot((((_263 * _267) + (_264 * _269)) + (_265 * _272)) + (_266 * _275), _123);
    vec4 _284 = vec4(_282 * _281);
    vec4 _285 = _263 - _284;
    vec4 _288 = _264 - _284;
    vec4 _292 = _265 - _284;
    vec4 _296 = _266 - _284;
    vec4 _314 = parameters.gViewToPreviousClip * vec4((_98 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _111, _111, 1.0);
    float _317 = _314.w;
    vec2 _322 = (_314.xy * (1.0 / _317)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _327 = bvec2((_317 > 0.0) && all(lessThanEqual(abs(_322), vec2(8.0))));
    vec2 _328 = vec2(_327.x ? _322.x : vec2(-8.0).x, _327.y ? _322.y : vec2(-8.0).y);
    float _330 = dot(_314.zw, parameters.gClipToDepth);
    vec2 _336 = _328 * parameters.gFrameToCoarse;
    float _342 = max(parameters.gMissThreshold.y * _111 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec4 _346 = textureLod(gHistoryCacheFiltered, _336, 0.0);
    vec4 _350 = textureLod(gHistoryCacheStateFiltered, _336, 0.0);
    float _351 = _346.x;
    float _352 = _350.x;
    float _355 = (_352 > 0.0) ? min(_352, 255.0) : 0.0;
    float _362 = _342 - abs(((abs(_330) <= 9.9999996802856924650656260769173e+37) ? _330 : 0.0) - _346.y);
    float _365 = (_362 > 0.0) ? (_362 * (parameters.gConvergenceTime / _342)) : 0.0;
    float _377 = abs(_351);
    float _380 = ((parameters.gHistoryValid > 0.5) && (_377 <= 65504.0)) ? (((_365 > 0.0) && all(lessThanEqual(abs(_328 * parameters.gFrameToCoarse + vec2(-0.5)), vec2(0.5)))) ? min(_365, 1.0) : 0.0) : 0.0;
    float _395 = (_380 > 0.0) ? (_380 * clamp(2.0 - (abs((-_282) * _281 + _351) / max(parameters.gChange.x * sqrt(dot(((((_285 * _285) * _267) + ((_288 * _288) * _269)) + ((_292 * _292) * _272)) + ((_296 * _296) * _275), _123) * _281) + parameters.gChange.y, 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _408 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _410 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_336)) * parameters.gOutputSize.xy));
    float _414 = ((_410 > 0.0) ? min(_410, _408) : 0.0) / _408;
    float _417 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _422 = _355 * _395;
    float _425 = (_422 > 0.0) ? min(_422, 255.0) : 0.0;
    float _429 = min(min(_425 / (_425 + 1.0), _417), ((_417 * _414) * _414) * ((-2.0) * _414 + 3.0));
    float _432 = (abs(_107) <= 9.9999996802856924650656260769173e+37) ? _107 : 0.0;
    gOutCache = vec4((_429 > 0.0) ? ((_377 <= 9.9999996802856924650656260769173e+37) ? ((_351 - _432) * clamp(_429, 0.0, 1.0) + _432) : _432) : _107, _111, 0.0, 0.0);
    gOutCacheState = vec4(min(((_355 > 0.0) ? min(_355, 255.0) : 0.0) * ((_395 > 0.0) ? min(_395, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

