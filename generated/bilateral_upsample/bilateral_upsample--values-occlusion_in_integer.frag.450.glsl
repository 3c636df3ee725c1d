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
    vec2 _93 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_86 * 0.0322580635547637939453125, min((_85 - _86) * 1.01587307453155517578125, 1.0)), bvec2(abs(_80) <= 65504.0));
    float _94 = _79.z;
    float _99 = (_94 > 0.0) ? min(_94, 31.984375) : 0.0;
    float _100 = floor(_99);
    vec2 _107 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_100 * 0.0322580635547637939453125, min((_99 - _100) * 1.01587307453155517578125, 1.0)), bvec2(abs(_94) <= 65504.0));
    float _108 = _79.x;
    float _113 = (_108 > 0.0) ? min(_108, 31.984375) : 0.0;
    float _114 = floor(_113);
    vec2 _121 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_114 * 0.0322580635547637939453125, min((_113 - _114) * 1.01587307453155517578125, 1.0)), bvec2(abs(_108) <= 65504.0));
    float _122 = _79.y;
    float _127 = (_122 > 0.0) ? min(_122, 31.984375) : 0.0;
    float _128 = floor(_127);
    vec2 _135 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_128 * 0.0322580635547637939453125, min((_127 - _128) * 1.01587307453155517578125, 1.0)), bvec2(abs(_122) <= 65504.0));
    float _139 = float(abs(_93.x) <= 65504.0);
    float _146 = float(abs(_107.x) <= 65504.0);
    float _153 = float(abs(_121.x) <= 65504.0);
    float _160 = float(abs(_135.x) <= 65504.0);
    vec4 _169 = textureGather(gInCoarseDepth, _75).wzxy;
    vec4 _180 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _181 = _180.x;
    float _191 = 1.0 / max(fma(_181, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _203 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_181 - 0.5) <= 0.5) ? (((_191 > 0.0) && (_191 < min(parameters.gSkyDepth, 65504.0))) ? _191 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_169, vec4(65504.0)), greaterThan(_169, vec4(0.0))));
    vec4 _210 = ((((vec4(_64, _65, _64, _65) * vec4(_63.yy, _62.yy)) * vec4(_139, _146, _153, _160)) * _203.yxxx) * _203.zzyy) * _203.wwwz;
    vec4 _214 = _210 * (1.0 / max(dot(_210, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _93, bvec2(_139 > 0.5)) * _214.x) + (mix(vec2(0.0), _107, bvec2(_146 > 0.5)) * _214.y)) + (mix(vec2(0.0), _121, bvec2(_153 > 0.5)) * _214.z)) + (mix(vec2(0.0), _135, bvec2(_160 > 0.5)) * _214.w), 0.0, 0.0);
}

