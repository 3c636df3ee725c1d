#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _60 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _61 = floor(_60);
    vec2 _62 = _60 - _61;
    vec2 _63 = vec2(1.0) - _62;
    float _64 = _63.x;
    float _65 = _62.x;
    vec2 _75 = (_61 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _79 = textureGather(gInFiltered, _75);
    float _80 = _79.w;
    float _85 = (_80 > 0.0) ? min(_80, 31.984375) : 0.0;
    float _86 = floor(_85);
    vec2 _94 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_86 * 0.0322580635547637939453125, min((_85 - _86) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_80) <= 65504.0));
    float _95 = _79.z;
    float _100 = (_95 > 0.0) ? min(_95, 31.984375) : 0.0;
    float _101 = floor(_100);
    vec2 _109 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_101 * 0.0322580635547637939453125, min((_100 - _101) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_95) <= 65504.0));
    float _110 = _79.x;
    float _115 = (_110 > 0.0) ? min(_110, 31.984375) : 0.0;
    float _116 = floor(_115);
    vec2 _124 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_116 * 0.0322580635547637939453125, min((_115 - _116) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_110) <= 65504.0));
    float _125 = _79.y;
    float _130 = (_125 > 0.0) ? min(_125, 31.984375) : 0.0;
    float _131 = floor(_130);
    vec2 _139 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_131 * 0.0322580635547637939453125, min((_130 - _131) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_125) <= 65504.0));
    float _143 = float(abs(_94.x) <= 65504.0);
    float _150 = float(abs(_109.x) <= 65504.0);
    float _157 = float(abs(_124.x) <= 65504.0);
    float _164 = float(abs(_139.x) <= 65504.0);
    vec4 _173 = textureGather(gInCoarseDepth, _75).wzxy;
    vec4 _184 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _185 = _184.x;
    float _195 = 1.0 / max(fma(_185, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _207 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_185 - 0.5) <= 0.5) ? (((_195 > 0.0) && (_195 < min(parameters.gSkyDepth, 65504.0))) ? _195 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_173, vec4(65504.0)), greaterThan(_173, vec4(0.0))));
    vec4 _214 = ((((vec4(_64, _65, _64, _65) * vec4(_63.yy, _62.yy)) * vec4(_143, _150, _157, _164)) * _207.yxxx) * _207.zzyy) * _207.wwwz;
    vec4 _218 = _214 * (1.0 / max(dot(_214, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _94, bvec2(_143 > 0.5)) * _218.x) + (mix(vec2(0.0), _109, bvec2(_150 > 0.5)) * _218.y)) + (mix(vec2(0.0), _124, bvec2(_157 > 0.5)) * _218.z)) + (mix(vec2(0.0), _139, bvec2(_164 > 0.5)) * _218.w), 0.0, 0.0);
}

