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
    vec2 _68 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _71 = parameters.gDirection * parameters.gOutputSize.zw;
    vec4 _79 = textureLod(gInCache, _68, 0.0);
    float _80 = _79.x;
    float _85 = (_80 > 0.0) ? min(_80, 31.984375) : 0.0;
    float _86 = floor(_85);
    vec2 _94 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_86 * 0.0322580635547637939453125, min((_85 - _86) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_80) <= 65504.0));
    float _95 = _79.y;
    vec4 _100 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(-3.5)), 0.0);
    float _101 = _100.x;
    float _106 = (_101 > 0.0) ? min(_101, 31.984375) : 0.0;
    float _107 = floor(_106);
    vec4 _121 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(-3.5)), 0.0);
    float _122 = _121.x;
    float _127 = (_122 > 0.0) ? min(_122, 31.984375) : 0.0;
    float _128 = floor(_127);
    vec2 _139 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_107 * 0.0322580635547637939453125, min((_106 - _107) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_101) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_128 * 0.0322580635547637939453125, min((_127 - _128) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_122) <= 65504.0))) * 0.5;
    vec4 _145 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(-1.5)), 0.0);
    float _146 = _145.x;
    float _151 = (_146 > 0.0) ? min(_146, 31.984375) : 0.0;
    float _152 = floor(_151);
    vec4 _166 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(-1.5)), 0.0);
    float _167 = _166.x;
    float _172 = (_167 > 0.0) ? min(_167, 31.984375) : 0.0;
    float _173 = floor(_172);
    vec2 _184 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_152 * 0.0322580635547637939453125, min((_151 - _152) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_146) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_173 * 0.0322580635547637939453125, min((_172 - _173) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_167) <= 65504.0))) * 0.5;
    vec4 _190 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(1.5)), 0.0);
    float _191 = _190.x;
    float _196 = (_191 > 0.0) ? min(_191, 31.984375) : 0.0;
    float _197 = floor(_196);
    vec4 _211 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(1.5)), 0.0);
    float _212 = _211.x;
    float _217 = (_212 > 0.0) ? min(_212, 31.984375) : 0.0;
    float _218 = floor(_217);
    vec2 _229 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_197 * 0.0322580635547637939453125, min((_196 - _197) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_191) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_218 * 0.0322580635547637939453125, min((_217 - _218) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_212) <= 65504.0))) * 0.5;
    vec4 _235 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(3.5)), 0.0);
    float _236 = _235.x;
    float _241 = (_236 > 0.0) ? min(_236, 31.984375) : 0.0;
    float _242 = floor(_241);
    vec4 _256 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(3.5)), 0.0);
    float _257 = _256.x;
    float _262 = (_257 > 0.0) ? min(_257, 31.984375) : 0.0;
    float _263 = floor(_262);
    vec2 _274 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_242 * 0.0322580635547637939453125, min((_241 - _242) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_236) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_263 * 0.0322580635547637939453125, min((_262 - _263) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_257) <= 65504.0))) * 0.5;
    float _282 = textureLod(gInCacheState, _68, 0.0).x / max(parameters.gConverged, 1.0);
    float _295 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_282 > 0.0) ? min(_282, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _298 = (_295 > 0.0) ? min(_295, 16.0) : 0.0;
    float _304 = min(_95, 65504.0);
    float _307 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_95 > 0.001000000047497451305389404296875) ? _304 : 0.001000000047497451305389404296875));
    float _308 = -_95;
    float _310 = abs(fma(0.5, _100.y + _121.y, _308));
    float _314 = (_307 > 0.0) ? min(_307, 9.9999996169031624536541560020822e+35) : 0.0;
    float _319 = 0.0544886849820613861083984375 * (_298 * ((_310 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_314, _310, 1.0)) : 0.0));
    bool _322 = abs(_139.x) <= 65504.0;
    float _328 = abs(fma(0.5, _145.y + _166.y, _308));
    float _334 = 0.24420134723186492919921875 * (_298 * ((_328 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_314, _328, 1.0)) : 0.0));
    bool _337 = abs(_184.x) <= 65504.0;
    bool _346 = abs(_94.x) <= 65504.0;
    float _354 = abs(fma(0.5, _190.y + _211.y, _308));
    float _360 = 0.24420134723186492919921875 * (_298 * ((_354 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_314, _354, 1.0)) : 0.0));
    bool _363 = abs(_229.x) <= 65504.0;
    float _371 = abs(fma(0.5, _235.y + _256.y, _308));
    float _377 = 0.0544886849820613861083984375 * (_298 * ((_371 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_314, _371, 1.0)) : 0.0));
    bool _380 = abs(_274.x) <= 65504.0;
    float _386 = ((((_322 ? _319 : 0.0) + (_337 ? _334 : 0.0)) + (_346 ? 0.40261995792388916015625 : 0.0)) + (_363 ? _360 : 0.0)) + (_380 ? _377 : 0.0);
    vec2 _391 = mix(vec2(0.0), ((((mix(vec2(0.0), _139 * _319, bvec2(_322)) + mix(vec2(0.0), _184 * _334, bvec2(_337))) + mix(vec2(0.0), _94 * 0.40261995792388916015625, bvec2(_346))) + mix(vec2(0.0), _229 * _360, bvec2(_363))) + mix(vec2(0.0), _274 * _377, bvec2(_380))) * (1.0 / _386), bvec2(_386 > 1.0000000031710768509710513471353e-30));
    float _394 = _391.x;
    float _395 = _391.y;
    gOutFiltered = vec4(fma((_394 > 0.0) ? min(_394, 1.0) : 0.0, 0.984375, floor(fma((_395 > 0.0) ? min(_395, 1.0) : 0.0, 31.0, 0.5))), (_95 > 0.0) ? _304 : 0.0, 0.0, 0.0);
}

