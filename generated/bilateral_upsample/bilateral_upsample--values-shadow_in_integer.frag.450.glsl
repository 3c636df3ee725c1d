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
    vec2 _68 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _69 = floor(_68);
    vec2 _70 = _68 - _69;
    vec2 _71 = vec2(1.0) - _70;
    float _72 = _71.x;
    float _73 = _70.x;
    vec2 _85 = (_69 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _88 = textureGather(gInFiltered, _85).wzxy;
    vec4 _91 = mix(vec4(1.9999999360571384930131252153835e+38), _88, lessThanEqual(abs(_88), vec4(65504.0)));
    float _97 = _91.x;
    float _102 = (_97 > 0.0) ? min(_97, 31.984375) : 0.0;
    float _103 = floor(_102);
    vec2 _112 = mix(vec2(_97), min(vec2(_103 * 0.0322580635547637939453125, (_102 - _103) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_97) <= 9.9999996802856924650656260769173e+37));
    float _113 = _91.y;
    float _118 = (_113 > 0.0) ? min(_113, 31.984375) : 0.0;
    float _119 = floor(_118);
    vec2 _128 = mix(vec2(_113), min(vec2(_119 * 0.0322580635547637939453125, (_118 - _119) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_113) <= 9.9999996802856924650656260769173e+37));
    float _129 = _91.z;
    float _134 = (_129 > 0.0) ? min(_129, 31.984375) : 0.0;
    float _135 = floor(_134);
    vec2 _144 = mix(vec2(_129), min(vec2(_135 * 0.0322580635547637939453125, (_134 - _135) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_129) <= 9.9999996802856924650656260769173e+37));
    float _145 = _91.w;
    float _150 = (_145 > 0.0) ? min(_145, 31.984375) : 0.0;
    float _151 = floor(_150);
    vec2 _160 = mix(vec2(_145), min(vec2(_151 * 0.0322580635547637939453125, (_150 - _151) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_145) <= 9.9999996802856924650656260769173e+37));
    vec4 _164 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _165 = _164.x;
    float _175 = 1.0 / max(fma(_165, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    bool _186 = all(lessThanEqual(abs(_112), vec2(9.9999996802856924650656260769173e+37)));
    bool _190 = all(lessThanEqual(abs(_128), vec2(9.9999996802856924650656260769173e+37)));
    bool _194 = all(lessThanEqual(abs(_144), vec2(9.9999996802856924650656260769173e+37)));
    bool _198 = all(lessThanEqual(abs(_160), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _200 = vec4(float(_186), float(_190), float(_194), float(_198));
    vec4 _203 = abs(vec4((abs(_165 - 0.5) <= 0.5) ? (((_175 > 0.0) && (_175 < min(parameters.gSkyDepth, 65504.0))) ? _175 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _85).wzxy);
    bvec4 _210 = greaterThan(_200 * vec4(lessThanEqual(abs(_203), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _211 = mix(vec4(0.0), (vec4(_72, _73, _72, _73) * vec4(_71.yy, _70.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _203), _210);
    vec4 _213 = mix(vec4(0.0), _211, greaterThan(_211, vec4(0.0)));
    float _214 = dot(_213, vec4(1.0));
    vec4 _215 = mix(vec4(1.9999999360571384930131252153835e+38), _203, _210);
    vec4 _225 = mix(vec4(0.0), _200, lessThanEqual(_215, vec4(min(min(_215.x, _215.y), min(_215.z, _215.w)))));
    vec4 _236 = mix(_225 / vec4(max(dot(_225, vec4(1.0)), 1.0)), _213 / vec4(_214), bvec4((_214 >= 1.0000000031710768509710513471353e-30) && (_214 <= 9.9999996802856924650656260769173e+37)));
    gOutUpsampled = vec4((((mix(vec2(0.0), _112, bvec2(_186)) * _236.x) + (mix(vec2(0.0), _128, bvec2(_190)) * _236.y)) + (mix(vec2(0.0), _144, bvec2(_194)) * _236.z)) + (mix(vec2(0.0), _160, bvec2(_198)) * _236.w), 0.0, 0.0);
}

