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
    vec2 _93 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_86 * 0.0322580635547637939453125, min((_85 - _86) * 1.01587307453155517578125, 1.0)), bvec2(abs(_80) <= 65504.0));
    float _94 = _79.y;
    vec4 _99 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(-3.5)), 0.0);
    float _100 = _99.x;
    float _105 = (_100 > 0.0) ? min(_100, 31.984375) : 0.0;
    float _106 = floor(_105);
    vec4 _119 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(-3.5)), 0.0);
    float _120 = _119.x;
    float _125 = (_120 > 0.0) ? min(_120, 31.984375) : 0.0;
    float _126 = floor(_125);
    vec2 _136 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_106 * 0.0322580635547637939453125, min((_105 - _106) * 1.01587307453155517578125, 1.0)), bvec2(abs(_100) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_126 * 0.0322580635547637939453125, min((_125 - _126) * 1.01587307453155517578125, 1.0)), bvec2(abs(_120) <= 65504.0))) * 0.5;
    vec4 _142 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(-1.5)), 0.0);
    float _143 = _142.x;
    float _148 = (_143 > 0.0) ? min(_143, 31.984375) : 0.0;
    float _149 = floor(_148);
    vec4 _162 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(-1.5)), 0.0);
    float _163 = _162.x;
    float _168 = (_163 > 0.0) ? min(_163, 31.984375) : 0.0;
    float _169 = floor(_168);
    vec2 _179 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_149 * 0.0322580635547637939453125, min((_148 - _149) * 1.01587307453155517578125, 1.0)), bvec2(abs(_143) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_169 * 0.0322580635547637939453125, min((_168 - _169) * 1.01587307453155517578125, 1.0)), bvec2(abs(_163) <= 65504.0))) * 0.5;
    vec4 _185 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(1.5)), 0.0);
    float _186 = _185.x;
    float _191 = (_186 > 0.0) ? min(_186, 31.984375) : 0.0;
    float _192 = floor(_191);
    vec4 _205 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(1.5)), 0.0);
    float _206 = _205.x;
    float _211 = (_206 > 0.0) ? min(_206, 31.984375) : 0.0;
    float _212 = floor(_211);
    vec2 _222 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_192 * 0.0322580635547637939453125, min((_191 - _192) * 1.01587307453155517578125, 1.0)), bvec2(abs(_186) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_212 * 0.0322580635547637939453125, min((_211 - _212) * 1.01587307453155517578125, 1.0)), bvec2(abs(_206) <= 65504.0))) * 0.5;
    vec4 _228 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * floor(3.5)), 0.0);
    float _229 = _228.x;
    float _234 = (_229 > 0.0) ? min(_229, 31.984375) : 0.0;
    float _235 = floor(_234);
    vec4 _248 = textureLod(gInCache, fma(gl_FragCoord.xy, parameters.gOutputSize.zw, _71 * ceil(3.5)), 0.0);
    float _249 = _248.x;
    float _254 = (_249 > 0.0) ? min(_249, 31.984375) : 0.0;
    float _255 = floor(_254);
    vec2 _265 = (mix(vec2(1.9999999360571384930131252153835e+38), vec2(_235 * 0.0322580635547637939453125, min((_234 - _235) * 1.01587307453155517578125, 1.0)), bvec2(abs(_229) <= 65504.0)) + mix(vec2(1.9999999360571384930131252153835e+38), vec2(_255 * 0.0322580635547637939453125, min((_254 - _255) * 1.01587307453155517578125, 1.0)), bvec2(abs(_249) <= 65504.0))) * 0.5;
    float _273 = textureLod(gInCacheState, _68, 0.0).x / max(parameters.gConverged, 1.0);
    float _286 = (fma(((parameters.gMaxSmoothing > 1.0) ? min(parameters.gMaxSmoothing, 16.0) : 1.0) - 1.0, 1.0 - ((_273 > 0.0) ? min(_273, 1.0) : 0.0), 1.0) - 1.0) + parameters.gMinSmoothing;
    float _289 = (_286 > 0.0) ? min(_286, 16.0) : 0.0;
    float _295 = min(_94, 65504.0);
    float _298 = parameters.gDepthAmplitude.x + (parameters.gDepthAmplitude.y / ((_94 > 0.001000000047497451305389404296875) ? _295 : 0.001000000047497451305389404296875));
    float _299 = -_94;
    float _301 = abs(fma(0.5, _99.y + _119.y, _299));
    float _305 = (_298 > 0.0) ? min(_298, 9.9999996169031624536541560020822e+35) : 0.0;
    float _310 = 0.0544886849820613861083984375 * (_289 * ((_301 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_305, _301, 1.0)) : 0.0));
    bool _313 = abs(_136.x) <= 65504.0;
    float _319 = abs(fma(0.5, _142.y + _162.y, _299));
    float _325 = 0.24420134723186492919921875 * (_289 * ((_319 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_305, _319, 1.0)) : 0.0));
    bool _328 = abs(_179.x) <= 65504.0;
    bool _337 = abs(_93.x) <= 65504.0;
    float _345 = abs(fma(0.5, _185.y + _205.y, _299));
    float _351 = 0.24420134723186492919921875 * (_289 * ((_345 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_305, _345, 1.0)) : 0.0));
    bool _354 = abs(_222.x) <= 65504.0;
    float _362 = abs(fma(0.5, _228.y + _248.y, _299));
    float _368 = 0.0544886849820613861083984375 * (_289 * ((_362 <= 9.9999996169031624536541560020822e+35) ? (1.0 / fma(_305, _362, 1.0)) : 0.0));
    bool _371 = abs(_265.x) <= 65504.0;
    float _377 = ((((_313 ? _310 : 0.0) + (_328 ? _325 : 0.0)) + (_337 ? 0.40261995792388916015625 : 0.0)) + (_354 ? _351 : 0.0)) + (_371 ? _368 : 0.0);
    vec2 _382 = mix(vec2(0.0), ((((mix(vec2(0.0), _136 * _310, bvec2(_313)) + mix(vec2(0.0), _179 * _325, bvec2(_328))) + mix(vec2(0.0), _93 * 0.40261995792388916015625, bvec2(_337))) + mix(vec2(0.0), _222 * _351, bvec2(_354))) + mix(vec2(0.0), _265 * _368, bvec2(_371))) * (1.0 / _377), bvec2(_377 > 1.0000000031710768509710513471353e-30));
    float _385 = _382.x;
    float _386 = _382.y;
    gOutFiltered = vec4(fma((_386 > 0.0) ? min(_386, 1.0) : 0.0, 0.984375, floor(fma((_385 > 0.0) ? min(_385, 1.0) : 0.0, 31.0, 0.5))), (_94 > 0.0) ? _295 : 0.0, 0.0, 0.0);
}

