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
uniform highp sampler2D gHistoryCache;
uniform highp sampler2D gHistoryCacheStateFiltered;

layout(location = 0) out vec4 gOutCache;
layout(location = 1) out vec4 gOutCacheState;

void main()
{
    vec2 _94 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _98 = textureLod(gInFresh, _94, 0.0);
    float _99 = _98.y;
    float _100 = _98.x;
    float _105 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _106 = floor(_105);
    vec2 _112 = vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0)).yx;
    bvec2 _113 = bvec2(abs(_100) <= 65504.0);
    vec2 _114 = vec2(_113.x ? _112.x : vec2(1.9999999360571384930131252153835e+38).x, _113.y ? _112.y : vec2(1.9999999360571384930131252153835e+38).y);
    bvec2 _116 = lessThanEqual(abs(_114), vec2(65504.0));
    vec2 _117 = vec2(_116.x ? _114.x : vec2(0.0).x, _116.y ? _114.y : vec2(0.0).y);
    float _121 = ((_99 > 0.0) && (_99 < 65504.0)) ? _99 : 65504.0;
    vec4 _133 = parameters.gViewToPreviousClip * vec4((_94 * parameters.gViewRay.xy + parameters.gViewRay.zw) * _121, _121, 1.0);
    float _136 = _133.w;
    vec2 _141 = (_133.xy * (1.0 / _136)) * vec2(0.5, -0.5) + vec2(0.5);
    bvec2 _146 = bvec2((_136 > 0.0) && all(lessThanEqual(abs(_141), vec2(8.0))));
    float _149 = dot(_133.zw, parameters.gClipToDepth);
    vec2 _155 = vec2(_146.x ? _141.x : vec2(-8.0).x, _146.y ? _141.y : vec2(-8.0).y) * parameters.gFrameToCoarse;
    float _161 = max(parameters.gMissThreshold.y * _121 + parameters.gMissThreshold.x, 9.9999999747524270787835121154785e-07);
    vec2 _163 = _155 * parameters.gOutputSize.xy + vec2(-0.5);
    vec2 _164 = floor(_163);
    vec2 _165 = _163 - _164;
    vec2 _166 = vec2(1.0) - _165;
    float _167 = _166.x;
    float _168 = _165.x;
    vec2 _175 = (_164 + vec2(0.5)) * parameters.gOutputSize.zw;
    vec4 _179 = textureLod(gHistoryCache, _175, 0.0);
    float _180 = _179.x;
    vec2 _185 = (_164 + vec2(1.5, 0.5)) * parameters.gOutputSize.zw;
    vec4 _187 = textureLod(gHistoryCache, _185, 0.0);
    float _188 = _187.x;
    vec2 _193 = (_164 + vec2(0.5, 1.5)) * parameters.gOutputSize.zw;
    vec4 _195 = textureLod(gHistoryCache, _193, 0.0);
    float _196 = _195.x;
    vec2 _201 = (_164 + vec2(1.5)) * parameters.gOutputSize.zw;
    vec4 _203 = textureLod(gHistoryCache, _201, 0.0);
    float _204 = _203.x;
    vec4 _217 = vec4(_161) - abs(vec4((abs(_149) <= 9.9999996802856924650656260769173e+37) ? _149 : 0.0) - vec4(textureLod(gHistoryCache, _175, 0.0).y, textureLod(gHistoryCache, _185, 0.0).y, textureLod(gHistoryCache, _193, 0.0).y, textureLod(gHistoryCache, _201, 0.0).y));
    vec4 _218 = _217 * (parameters.gConvergenceTime / _161);
    bvec4 _219 = greaterThan(_217, vec4(0.0));
    vec4 _220 = vec4(_219.x ? _218.x : vec4(0.0).x, _219.y ? _218.y : vec4(0.0).y, _219.z ? _218.z : vec4(0.0).z, _219.w ? _218.w : vec4(0.0).w);
    vec4 _221 = min(_220, vec4(1.0));
    bvec4 _222 = greaterThan(_220, vec4(0.0));
    bvec4 _226 = bvec4(all(lessThanEqual(floatBitsToUint(_155), uvec2(1065353216u))));
    bvec4 _227 = bvec4(_222.x && _226.x, _222.y && _226.y, _222.z && _226.z, _222.w && _226.w);
    vec4 _228 = vec4(_227.x ? _221.x : vec4(0.0).x, _227.y ? _221.y : vec4(0.0).y, _227.z ? _221.z : vec4(0.0).z, _227.w ? _221.w : vec4(0.0).w);
    bvec4 _230 = lessThanEqual(abs(vec4(_180, _188, _196, _204)), vec4(65504.0));
    vec4 _231 = vec4(_230.x ? _228.x : vec4(0.0).x, _230.y ? _228.y : vec4(0.0).y, _230.z ? _228.z : vec4(0.0).z, _230.w ? _228.w : vec4(0.0).w);
    vec4 _232 = (vec4(_167, _168, _167, _168) * vec4(_166.yy, _165.yy)) * _231;
    vec4 _236 = _232 * (1.0 / max(dot(_232, vec4(1.0)), 9.9999999747524270787835121154785e-07));
    vec4 _250 = vec4((_180 > 0.0) ? min(_180, 31.984375) : 0.0, (_188 > 0.0) ? min(_188, 31.984375) : 0.0, (_196 > 0.0) ? min(_196, 31.984375) : 0.0, (_204 > 0.0) ? min(_204, 31.984375) : 0.0);
    vec4 _251 = floor(_250);
    float _257 = dot(_236, min(_250 - _251, vec4(0.984375))) * 1.01587307453155517578125;
    vec2 _259 = vec2(dot(_236, _251) * 0.0322580635547637939453125, _257).yx;
    vec4 _263 = textureLod(gHistoryCacheStateFiltered, _155, 0.0);
    float _264 = _263.x;
    float _267 = (_264 > 0.0) ? min(_264, 255.0) : 0.0;
    float _274 = ((parameters.gHistoryValid > 0.5) && (abs(_257) <= 65504.0)) ? dot(_236, _231) : 0.0;
    float _286 = max(parameters.gSpeedPx.y - parameters.gSpeedPx.x, 9.9999999747524270787835121154785e-07);
    float _288 = parameters.gSpeedPx.y - abs(length((gl_FragCoord.xy * parameters.gOutputSize.zw + (-_155)) * parameters.gOutputSize.xy));
    float _292 = ((_288 > 0.0) ? min(_288, _286) : 0.0) / _286;
    float _295 = (parameters.gMaxWeight > 0.0) ? min(parameters.gMaxWeight, 1.0) : 0.0;
    float _300 = _267 * _274;
    float _303 = (_300 > 0.0) ? min(_300, 255.0) : 0.0;
    float _307 = min(min(_303 / (_303 + 1.0), _295), ((_295 * _292) * _292) * ((-2.0) * _292 + 3.0));
    bvec2 _311 = bvec2(all(lessThanEqual(abs(_117), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _312 = vec2(_311.x ? _117.x : vec2(0.0).x, _311.y ? _117.y : vec2(0.0).y);
    vec2 _319 = _312 + ((_259 - _312) * clamp(_307, 0.0, 1.0));
    bvec2 _320 = bvec2(all(lessThanEqual(abs(_259), vec2(9.9999996802856924650656260769173e+37))));
    vec2 _321 = vec2(_320.x ? _319.x : _312.x, _320.y ? _319.y : _312.y);
    bvec2 _323 = bvec2(_307 > 0.0);
    vec2 _324 = vec2(_323.x ? _321.x : _117.x, _323.y ? _321.y : _117.y);
    float _333 = _324.x;
    float _334 = _324.y;
    gOutCache = vec4(((_333 > 0.0) ? min(_333, 1.0) : 0.0) * 0.984375 + floor(((_334 > 0.0) ? min(_334, 1.0) : 0.0) * 31.0 + 0.5), _121, 0.0, 0.0);
    gOutCacheState = vec4(min(((_267 > 0.0) ? min(_267, 255.0) : 0.0) * ((_274 > 0.0) ? min(_274, 1.0) : 0.0) + 1.0, 255.0), 0.0, 0.0, 0.0);
}

