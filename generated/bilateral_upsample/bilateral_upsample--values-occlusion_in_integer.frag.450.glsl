#version 450

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 1) uniform sampler2D gInFiltered;
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
    vec4 _80 = textureGather(gInCoarseDepth, _75).wzxy;
    vec4 _87 = textureGather(gInFiltered, _75);
    float _88 = _87.w;
    float _93 = (_88 > 0.0) ? min(_88, 31.984375) : 0.0;
    float _94 = floor(_93);
    vec2 _101 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_94 * 0.0322580635547637939453125, min((_93 - _94) * 1.01587307453155517578125, 1.0)), bvec2(abs(_88) <= 65504.0));
    float _102 = _87.z;
    float _107 = (_102 > 0.0) ? min(_102, 31.984375) : 0.0;
    float _108 = floor(_107);
    vec2 _115 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_108 * 0.0322580635547637939453125, min((_107 - _108) * 1.01587307453155517578125, 1.0)), bvec2(abs(_102) <= 65504.0));
    float _116 = _87.x;
    float _121 = (_116 > 0.0) ? min(_116, 31.984375) : 0.0;
    float _122 = floor(_121);
    vec2 _129 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_122 * 0.0322580635547637939453125, min((_121 - _122) * 1.01587307453155517578125, 1.0)), bvec2(abs(_116) <= 65504.0));
    float _130 = _87.y;
    float _135 = (_130 > 0.0) ? min(_130, 31.984375) : 0.0;
    float _136 = floor(_135);
    vec2 _143 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_136 * 0.0322580635547637939453125, min((_135 - _136) * 1.01587307453155517578125, 1.0)), bvec2(abs(_130) <= 65504.0));
    float _147 = float(abs(_101.x) <= 65504.0);
    float _154 = float(abs(_115.x) <= 65504.0);
    float _161 = float(abs(_129.x) <= 65504.0);
    float _168 = float(abs(_143.x) <= 65504.0);
    vec4 _180 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _181 = _180.x;
    float _191 = 1.0 / max(fma(_181, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _203 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_181 - 0.5) <= 0.5) ? (((_191 > 0.0) && (_191 < min(parameters.gSkyDepth, 65504.0))) ? _191 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_80, vec4(65504.0)), greaterThan(_80, vec4(0.0))));
    vec4 _210 = ((((vec4(_64, _65, _64, _65) * vec4(_63.yy, _62.yy)) * vec4(_147, _154, _161, _168)) * _203.yxxx) * _203.zzyy) * _203.wwwz;
    vec4 _214 = _210 * (1.0 / max(dot(_210, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _101, bvec2(_147 > 0.5)) * _214.x) + (mix(vec2(0.0), _115, bvec2(_154 > 0.5)) * _214.y)) + (mix(vec2(0.0), _129, bvec2(_161 > 0.5)) * _214.z)) + (mix(vec2(0.0), _143, bvec2(_168 > 0.5)) * _214.w), 0.0, 0.0);
}

