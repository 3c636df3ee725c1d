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
    vec2 _98 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_91 * 0.0322580635547637939453125, (_90 - _91) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_85) <= 65504.0));
    float _99 = _84.y;
    vec4 _103 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-4.0)), 0.0);
    float _104 = _103.x;
    float _109 = (_104 > 0.0) ? min(_104, 31.984375) : 0.0;
    float _110 = floor(_109);
    vec2 _117 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_110 * 0.0322580635547637939453125, (_109 - _110) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_104) <= 65504.0));
    vec4 _122 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-3.0)), 0.0);
    float _123 = _122.x;
    float _128 = (_123 > 0.0) ? min(_123, 31.984375) : 0.0;
    float _129 = floor(_128);
    vec2 _136 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_129 * 0.0322580635547637939453125, (_128 - _129) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_123) <= 65504.0));
    vec4 _141 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-2.0)), 0.0);
    float _142 = _141.x;
    float _147 = (_142 > 0.0) ? min(_142, 31.984375) : 0.0;
    float _148 = floor(_147);
    vec2 _155 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_148 * 0.0322580635547637939453125, (_147 - _148) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_142) <= 65504.0));
    vec4 _160 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * (-1.0)), 0.0);
    float _161 = _160.x;
    float _166 = (_161 > 0.0) ? min(_161, 31.984375) : 0.0;
    float _167 = floor(_166);
    vec2 _174 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_167 * 0.0322580635547637939453125, (_166 - _167) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_161) <= 65504.0));
    vec4 _179 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 1.0), 0.0);
    float _180 = _179.x;
    float _185 = (_180 > 0.0) ? min(_180, 31.984375) : 0.0;
    float _186 = floor(_185);
    vec2 _193 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_186 * 0.0322580635547637939453125, (_185 - _186) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_180) <= 65504.0));
    vec4 _198 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 2.0), 0.0);
    float _199 = _198.x;
    float _204 = (_199 > 0.0) ? min(_199, 31.984375) : 0.0;
    float _205 = floor(_204);
    vec2 _212 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_205 * 0.0322580635547637939453125, (_204 - _205) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_199) <= 65504.0));
    vec4 _217 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 3.0), 0.0);
    float _218 = _217.x;
    float _223 = (_218 > 0.0) ? min(_218, 31.984375) : 0.0;
    float _224 = floor(_223);
    vec2 _231 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_224 * 0.0322580635547637939453125, (_223 - _224) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_218) <= 65504.0));
    vec4 _236 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _76 * 4.0), 0.0);
    float _237 = _236.x;
    float _242 = (_237 > 0.0) ? min(_237, 31.984375) : 0.0;
    float _243 = floor(_242);
    vec2 _250 = mix(vec2(1.9999999360571384930131252153835e+38), min(vec2(_243 * 0.0322580635547637939453125, (_242 - _243) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_237) <= 65504.0));
    float _258 = textureLod(gInCacheState, _73, 0.0).x / max(parameters.gConverged, 1.0);
    float _271 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_258 > 0.0) ? min(_258, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _274 = (_271 > 0.0) ? min(_271, 16.0) : 0.0;
    float _280 = min(_99, 65504.0);
    float _283 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_99 > 0.001000000047497451305389404296875) ? _280 : 0.001000000047497451305389404296875));
    float _285 = abs(_103.y - _99);
    float _289 = (_283 > 0.0) ? min(_283, 9.9999996169031624536541560020822e+35) : 0.0;
    float _294 = 0.02724434249103069305419921875 * (_274 * ((_285 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _285, 1.0)) : 0.0));
    bool _297 = all(lessThanEqual(abs(_117), vec2(65504.0)));
    float _303 = abs(_122.y - _99);
    float _309 = 0.02724434249103069305419921875 * (_274 * ((_303 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _303, 1.0)) : 0.0));
    bool _312 = all(lessThanEqual(abs(_136), vec2(65504.0)));
    float _320 = abs(_141.y - _99);
    float _326 = 0.122100673615932464599609375 * (_274 * ((_320 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _320, 1.0)) : 0.0));
    bool _329 = all(lessThanEqual(abs(_155), vec2(65504.0)));
    float _337 = abs(_160.y - _99);
    float _343 = 0.122100673615932464599609375 * (_274 * ((_337 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _337, 1.0)) : 0.0));
    bool _346 = all(lessThanEqual(abs(_174), vec2(65504.0)));
    bool _355 = all(lessThanEqual(abs(_98), vec2(65504.0)));
    float _363 = abs(_179.y - _99);
    float _369 = 0.122100673615932464599609375 * (_274 * ((_363 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _363, 1.0)) : 0.0));
    bool _372 = all(lessThanEqual(abs(_193), vec2(65504.0)));
    float _380 = abs(_198.y - _99);
    float _386 = 0.122100673615932464599609375 * (_274 * ((_380 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _380, 1.0)) : 0.0));
    bool _389 = all(lessThanEqual(abs(_212), vec2(65504.0)));
    float _397 = abs(_217.y - _99);
    float _403 = 0.02724434249103069305419921875 * (_274 * ((_397 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _397, 1.0)) : 0.0));
    bool _406 = all(lessThanEqual(abs(_231), vec2(65504.0)));
    float _414 = abs(_236.y - _99);
    float _420 = 0.02724434249103069305419921875 * (_274 * ((_414 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_289, _414, 1.0)) : 0.0));
    bool _423 = all(lessThanEqual(abs(_250), vec2(65504.0)));
    float _429 = ((((((((_297 ? _294 : 0.0) + (_312 ? _309 : 0.0)) + (_329 ? _326 : 0.0)) + (_346 ? _343 : 0.0)) + (_355 ? 0.40261995792388916015625 : 0.0)) + (_372 ? _369 : 0.0)) + (_389 ? _386 : 0.0)) + (_406 ? _403 : 0.0)) + (_423 ? _420 : 0.0);
    vec2 _434 = mix(vec2(0.0), ((((((((mix(vec2(0.0), _117 * _294, bvec2(_297)) + mix(vec2(0.0), _136 * _309, bvec2(_312))) + mix(vec2(0.0), _155 * _326, bvec2(_329))) + mix(vec2(0.0), _174 * _343, bvec2(_346))) + mix(vec2(0.0), _98 * 0.40261995792388916015625, bvec2(_355))) + mix(vec2(0.0), _193 * _369, bvec2(_372))) + mix(vec2(0.0), _212 * _386, bvec2(_389))) + mix(vec2(0.0), _231 * _403, bvec2(_406))) + mix(vec2(0.0), _250 * _420, bvec2(_423))) * (1.0 / _429), bvec2(_429 > 1.0000000031710768509710513471353e-30));
    float _437 = _434.x;
    float _438 = _434.y;
    gOutFiltered = vec4(fma((_438 > 0.0) ? min(_438, 1.0) : 0.0, 0.984375, floor(fma((_437 > 0.0) ? min(_437, 1.0) : 0.0, 31.0, 0.5))), (_99 > 0.0) ? _280 : 0.0, 0.0, 0.0);
}

