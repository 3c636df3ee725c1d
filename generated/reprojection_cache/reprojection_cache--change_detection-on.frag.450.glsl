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
    vec2 _87 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _91 = textureLod(gInFresh, _87, 0.0);
    float _92 = _91.y;
    float _93 = _91.x;
    float _96 = (abs(_93) <= 65504.0) ? _93 : 0.0;
    float _100 = ((_92 > 0.0) && (_92 < 65504.0)) ? _92 : 65504.0;
    vec2 _101 = floor(gl_FragCoord.xy);
    float _102 = _101.x;
    vec4 _112 = vec4(lessThan(abs((vec4(_102) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_102 * 0.0625), 7.5))), vec4(8.0)));
    float _113 = _101.y;
    vec4 _123 = vec4(lessThan(abs((vec4(_113) + vec4(-1.0, 0.0, 1.0, 2.0)) - vec4(fma(16.0, floor(_113 * 0.0625), 7.5))), vec4(8.0)));
    vec4 _126 = textureGather(gInFresh, _101 * parameters.gOutputSize.zw);
    vec4 _129 = mix(vec4(0.0), _126, lessThanEqual(abs(_126), vec4(65504.0)));
    vec4 _133 = textureGather(gInFresh, (_101 + vec2(2.0, 0.0)) * parameters.gOutputSize.zw);
    vec4 _136 = mix(vec4(0.0), _133, lessThanEqual(abs(_133), vec4(65504.0)));
    vec4 _140 = textureGather(gInFresh, (_101 + vec2(0.0, 2.0)) * parameters.gOutputSize.zw);
    vec4 _143 = mix(vec4(0.0), _140, lessThanEqual(abs(_140), vec4(65504.0)));
    vec4 _147 = textureGather(gInFresh, (_101 + vec2(2.0)) * parameters.gOutputSize.zw);
    vec4 _150 = mix(vec4(0.0), _147, lessThanEqual(abs(_147), vec4(65504.0)));
    vec4 _155 = vec4(_129.wz, _136.wz);
    vec4 _160 = vec4(_129.xy, _136.xy);
    vec4 _165 = vec4(_143.wz, _150.wz);
    vec4 _170 = vec4(_143.xy, _150.xy);
    float _171 = _123.x;
    float _173 = _123.y;
    float _176 = _123.z;
    float _179 = _123.w;
    float _185 = 1.0 / (dot(_112, vec4(1.0)) * dot(_123, vec4(1.0)));
    float _186 = dot((((_155 * _171) + (_160 * _173)) + (_165 * _176)) + (_170 * _179), _112);
    vec4 _188 = vec4(_186 * _185);
    vec4 _189 = _155 - _188;
    vec4 _192 = _160 - _188;
    vec4 _196 = _165 - _188;
    vec4 _200 = _170 - _188;
    vec4 _218 = parameters.gViewToPreviousClip * vec4(fma(_87, parameters.gViewRay.xy, parameters.gViewRay.zw) * _100, _100, 1.0);
    float _221 = _218.w;
    vec2 _226 = fma(_218.xy * (1.0 / _221), vec2(0.5, -0.5), vec2(0.5));
    vec2 _232 = mix(vec2(-8.0), _226, bvec2((_221 > 0.0) && all(lessThanEqual(abs(_226), vec2(8.0)))));
    float _234 = dot(_218.zw, parameters.gClipToDepth);
    vec2 _240 = _232 * parameters.gFrameToCoarse;
    float _246 = max(fma(parameters.gMissThreshold.y, _100, parameters.gMissThreshold.x), 9.9999999747524270787835121154785e-07);
    vec4 _250 = textureLod(gHistoryCacheFiltered, _240, 0.0);
    vec4 _254 = textureLod(gHistoryCacheStateFiltered, _240, 0.0);
    float _255 = _250.x;
    float _256 = _254.x;
    float _259 = (_256 > 0.0) ? min(_256, 255.0) : 0.0;
    float _266 = _246 - abs(((abs(_234) <= 9.9999996802856924650656260769173e+37) ? _234 : 0.0) - _250.y);
    float _269 = (_266 > 0.0) ? (_266 * (parameters.gConvergenceTime / _246)) : 0.0;
    float _281 = abs(_255);
    float _284 = ((parameters.gHistoryValid > 0.5) && (_281 <= 65504.0)) ? (((_269 > 0.0) && all(lessThanEqual(abs(fma(_232, parameters.gFrameToCoarse, vec2(-0.5))), vec2(0.5)))) ? min(_269, 1.0) : 0.0) : 0.0;
    float _299 = (_284 > 0.0) ? (_284 * clamp(2.0 - (abs(fma(-_186, _185, _255)) / max(fma(parameters.gChange.x, sqrt(dot(((((_189 * _189) * _171) + ((_192 * _192) * _173)) + ((_196 * _196) * _176)) + ((_200 * _200) * _179), _112) * _185), parameters.gChange.y), 9.9999997473787516355514526367188e-05)), 0.0, 1.0)) : 0.0;
    float _312 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _314 = parameters.gSpeedPx.y - abs(length(fma(gl_FragCoord.xy, parameters.gOutputSize.zw, -_240) * parameters.gOutputSize.xy));
    float _318 = ((_314 > 0.0) ? min(_314, _312) : 0.0) / _312;
    float _321 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _326 = _259 * _299;
    float _329 = (_326 > 0.0) ? min(_326, 255.0) : 0.0;
    float _333 = min(min(_329 / (_329 + 1.0), _321), ((_321 * _318) * _318) * fma(-2.0, _318, 3.0));
    float _336 = (abs(_96) <= 9.9999996802856924650656260769173e+37) ? _96 : 0.0;
    gOutCache = vec4((_333 > 0.0) ? ((_281 <= 9.9999996802856924650656260769173e+37) ? fma(_255 - _336, clamp(_333, 0.0, 1.0), _336) : _336) : _96, _100, 0.0, 0.0);
    gOutCacheState = vec4(min(fma((_259 > 0.0) ? min(_259, 255.0) : 0.0, (_299 > 0.0) ? min(_299, 1.0) : 0.0, 1.0), 255.0), 0.0, 0.0, 0.0);
}

