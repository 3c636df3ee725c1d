#version 450

layout(binding = 0, std140) uniform BilateralFilterParameters
{
    vec4 gOutputSize;
    vec2 gDirection;
    vec2 gDepthAmplitude;
    float gConverged;
    float gMaxSmoothing;
    float gMinSmoothing;
} parameters;

layout(binding = 3) uniform sampler2D gInCacheState;
layout(binding = 1) uniform sampler2D gInCache;

layout(location = 0) out vec4 gOutFiltered;

void main()
{
    vec2 _73 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _76 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _84 = textureLod(gInCache, _73, 0.0);
    float _85 = _84.x;
    float _90 = (_85 > 0.0) ? min(_85, 31.984375) : 0.0;
    float _91 = floor(_90);
    vec2 _99 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_91 * 0.0322580635547637939453125, (_90 - _91) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_85) <= 65504.0));
    float _100 = _84.y;
    vec4 _104 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-4.0)), 0.0);
    float _105 = _104.x;
    float _110 = (_105 > 0.0) ? min(_105, 31.984375) : 0.0;
    float _111 = floor(_110);
    vec2 _119 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_111 * 0.0322580635547637939453125, (_110 - _111) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_105) <= 65504.0));
    vec4 _124 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-3.0)), 0.0);
    float _125 = _124.x;
    float _130 = (_125 > 0.0) ? min(_125, 31.984375) : 0.0;
    float _131 = floor(_130);
    vec2 _139 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_131 * 0.0322580635547637939453125, (_130 - _131) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_125) <= 65504.0));
    vec4 _144 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-2.0)), 0.0);
    float _145 = _144.x;
    float _150 = (_145 > 0.0) ? min(_145, 31.984375) : 0.0;
    float _151 = floor(_150);
    vec2 _159 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_151 * 0.0322580635547637939453125, (_150 - _151) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_145) <= 65504.0));
    vec4 _164 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-1.0)), 0.0);
    float _165 = _164.x;
    float _170 = (_165 > 0.0) ? min(_165, 31.984375) : 0.0;
    float _171 = floor(_170);
    vec2 _179 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_171 * 0.0322580635547637939453125, (_170 - _171) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_165) <= 65504.0));
    vec4 _184 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 1.0), 0.0);
    float _185 = _184.x;
    float _190 = (_185 > 0.0) ? min(_185, 31.984375) : 0.0;
    float _191 = floor(_190);
    vec2 _199 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_191 * 0.0322580635547637939453125, (_190 - _191) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_185) <= 65504.0));
    vec4 _204 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 2.0), 0.0);
    float _205 = _204.x;
    float _210 = (_205 > 0.0) ? min(_205, 31.984375) : 0.0;
    float _211 = floor(_210);
    vec2 _219 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_211 * 0.0322580635547637939453125, (_210 - _211) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_205) <= 65504.0));
    vec4 _224 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 3.0), 0.0);
    float _225 = _224.x;
    float _230 = (_225 > 0.0) ? min(_225, 31.984375) : 0.0;
    float _231 = floor(_230);
    vec2 _239 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_231 * 0.0322580635547637939453125, (_230 - _231) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_225) <= 65504.0));
    vec4 _244 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 4.0), 0.0);
    float _245 = _244.x;
    float _250 = (_245 > 0.0) ? min(_245, 31.984375) : 0.0;
    float _251 = floor(_250);
    vec2 _259 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_251 * 0.0322580635547637939453125, (_250 - _251) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_245) <= 65504.0));
    float _267 = textureLod(gInCacheState, _73, 0.0).x / max(parameters.gConverged, 1.0);
    float _280 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_267 > 0.0) ? min(_267, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _283 = (_280 > 0.0) ? min(_280, 16.0) : 0.0;
    float _289 = min(_100, 65504.0);
    float _292 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_100 > 0.001000000047497451305389404296875) ? _289 : 0.001000000047497451305389404296875));
    float _294 = abs(_104.y - _100);
    float _298 = (_292 > 0.0) ? min(_292, 9.9999996169031624536541560020822e+35) : 0.0;
    float _303 = 0.02724434249103069305419921875 * (_283 * ((_294 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _294, 1.0)) : 0.0));
    bool _306 = all(lessThanEqual(abs(_119), vec2(65504.0)));
    float _312 = abs(_124.y - _100);
    float _318 = 0.02724434249103069305419921875 * (_283 * ((_312 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _312, 1.0)) : 0.0));
    bool _321 = all(lessThanEqual(abs(_139), vec2(65504.0)));
    float _329 = abs(_144.y - _100);
    float _335 = 0.122100673615932464599609375 * (_283 * ((_329 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _329, 1.0)) : 0.0));
    bool _338 = all(lessThanEqual(abs(_159), vec2(65504.0)));
    float _346 = abs(_164.y - _100);
    float _352 = 0.122100673615932464599609375 * (_283 * ((_346 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _346, 1.0)) : 0.0));
    bool _355 = all(lessThanEqual(abs(_179), vec2(65504.0)));
    bool _364 = all(lessThanEqual(abs(_99), vec2(65504.0)));
    float _372 = abs(_184.y - _100);
    float _378 = 0.122100673615932464599609375 * (_283 * ((_372 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _372, 1.0)) : 0.0));
    bool _381 = all(lessThanEqual(abs(_199), vec2(65504.0)));
    float _389 = abs(_204.y - _100);
    float _395 = 0.122100673615932464599609375 * (_283 * ((_389 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _389, 1.0)) : 0.0));
    bool _398 = all(lessThanEqual(abs(_219), vec2(65504.0)));
    float _406 = abs(_224.y - _100);
    float _412 = 0.02724434249103069305419921875 * (_283 * ((_406 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _406, 1.0)) : 0.0));
    bool _415 = all(lessThanEqual(abs(_239), vec2(65504.0)));
    float _423 = abs(_244.y - _100);
    float _429 = 0.02724434249103069305419921875 * (_283 * ((_423 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_298, _423, 1.0)) : 0.0));
    bool _432 = all(lessThanEqual(abs(_259), vec2(65504.0)));
    float _438 = ((((((((_306 ? _303 : 0.0) + (_321 ? _318 : 0.0)) + (_338 ? _335 : 0.0)) + (_355 ? _352 : 0.0)) + (_364 ? 0.40261995792388916015625 : 0.0)) + (_381 ? _378 : 0.0)) + (_398 ? _395 : 0.0)) + (_415 ? _412 : 0.0)) + (_432 ? _429 : 0.0);
    vec2 _443 = mix(vec2(0.0), ((((((((mix(vec2(0.0), _119 * _303, bvec2(_306)) + mix(vec2(0.0), _139 * _318, bvec2(_321))) + mix(vec2(0.0), _159 * _335, bvec2(_338))) + mix(vec2(0.0), _179 * _352, bvec2(_355))) + mix(vec2(0.0), _99 * 0.40261995792388916015625, bvec2(_364))) + mix(vec2(0.0), _199 * _378, bvec2(_381))) + mix(vec2(0.0), _219 * _395, bvec2(_398))) + mix(vec2(0.0), _239 * _412, bvec2(_415))) + mix(vec2(0.0), _259 * _429, bvec2(_432))) * (1.0 / _438), bvec2(_438 > 1.0000000031710768509710513471353e-30));
    float _446 = _443.x;
    float _447 = _443.y;
    gOutFiltered = vec4(fma((_446 > 0.0) ? min(_446, 1.0) : 0.0, 0.984375, floor(fma((_447 > 0.0) ? min(_447, 1.0) : 0.0, 31.0, 0.5))), (_100 > 0.0) ? _289 : 0.0, 0.0, 0.0);
}

