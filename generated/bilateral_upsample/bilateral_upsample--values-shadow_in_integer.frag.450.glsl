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
    vec2 _102 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_94 * 0.0322580635547637939453125, min((_93 - _94) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_88) <= 65504.0));
    float _103 = _87.z;
    float _108 = (_103 > 0.0) ? min(_103, 31.984375) : 0.0;
    float _109 = floor(_108);
    vec2 _117 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_109 * 0.0322580635547637939453125, min((_108 - _109) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_103) <= 65504.0));
    float _118 = _87.x;
    float _123 = (_118 > 0.0) ? min(_118, 31.984375) : 0.0;
    float _124 = floor(_123);
    vec2 _132 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_124 * 0.0322580635547637939453125, min((_123 - _124) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_118) <= 65504.0));
    float _133 = _87.y;
    float _138 = (_133 > 0.0) ? min(_133, 31.984375) : 0.0;
    float _139 = floor(_138);
    vec2 _147 = mix(vec2(1.9999999360571384930131252153835e+38), vec2(_139 * 0.0322580635547637939453125, min((_138 - _139) * 1.01587307453155517578125, 1.0)).yx, bvec2(abs(_133) <= 65504.0));
    float _151 = float(abs(_102.x) <= 65504.0);
    float _158 = float(abs(_117.x) <= 65504.0);
    float _165 = float(abs(_132.x) <= 65504.0);
    float _172 = float(abs(_147.x) <= 65504.0);
    vec4 _184 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _185 = _184.x;
    float _195 = 1.0 / max(fma(_185, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _207 = vec4(9.9999997473787516355514526367188e-05) + abs(vec4((abs(_185 - 0.5) <= 0.5) ? (((_195 > 0.0) && (_195 < min(parameters.gSkyDepth, 65504.0))) ? _195 : 65504.0) : 65504.0) - mix(vec4(65504.0), min(_80, vec4(65504.0)), greaterThan(_80, vec4(0.0))));
    vec4 _214 = ((((vec4(_64, _65, _64, _65) * vec4(_63.yy, _62.yy)) * vec4(_151, _158, _165, _172)) * _207.yxxx) * _207.zzyy) * _207.wwwz;
    vec4 _218 = _214 * (1.0 / max(dot(_214, vec4(1.0)), 1.0000000031710768509710513471353e-30));
    gOutUpsampled = vec4((((mix(vec2(0.0), _102, bvec2(_151 > 0.5)) * _218.x) + (mix(vec2(0.0), _117, bvec2(_158 > 0.5)) * _218.y)) + (mix(vec2(0.0), _132, bvec2(_165 > 0.5)) * _218.z)) + (mix(vec2(0.0), _147, bvec2(_172 > 0.5)) * _218.w), 0.0, 0.0);
}

