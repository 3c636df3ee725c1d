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
    vec2 _64 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _65 = floor(_64);
    vec2 _66 = _64 - _65;
    vec2 _67 = vec2(1.0) - _66;
    float _68 = _67.x;
    float _69 = _66.x;
    vec2 _81 = (_65 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _84 = textureGather(gInFiltered, _81).wzxy;
    vec4 _87 = mix(vec4(1.9999999360571384930131252153835e+38), _84, lessThanEqual(abs(_84), vec4(65504.0)));
    vec4 _100 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _101 = _100.x;
    float _111 = 1.0 / max(fma(_101, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    float _120 = _87.x;
    float _125 = (_120 > 0.0) ? min(_120, 31.984375) : 0.0;
    float _126 = floor(_125);
    vec2 _135 = mix(vec2(_120), min(vec2(_126 * 0.0322580635547637939453125, (_125 - _126) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_120) <= 9.9999996802856924650656260769173e+37));
    float _136 = _87.y;
    float _141 = (_136 > 0.0) ? min(_136, 31.984375) : 0.0;
    float _142 = floor(_141);
    vec2 _151 = mix(vec2(_136), min(vec2(_142 * 0.0322580635547637939453125, (_141 - _142) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_136) <= 9.9999996802856924650656260769173e+37));
    float _152 = _87.z;
    float _157 = (_152 > 0.0) ? min(_152, 31.984375) : 0.0;
    float _158 = floor(_157);
    vec2 _167 = mix(vec2(_152), min(vec2(_158 * 0.0322580635547637939453125, (_157 - _158) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_152) <= 9.9999996802856924650656260769173e+37));
    float _168 = _87.w;
    float _173 = (_168 > 0.0) ? min(_168, 31.984375) : 0.0;
    float _174 = floor(_173);
    vec2 _183 = mix(vec2(_168), min(vec2(_174 * 0.0322580635547637939453125, (_173 - _174) * 1.01587307453155517578125), vec2(1.0)).yx, bvec2(abs(_168) <= 9.9999996802856924650656260769173e+37));
    bool _186 = all(lessThanEqual(abs(_135), vec2(9.9999996802856924650656260769173e+37)));
    bool _190 = all(lessThanEqual(abs(_151), vec2(9.9999996802856924650656260769173e+37)));
    bool _194 = all(lessThanEqual(abs(_167), vec2(9.9999996802856924650656260769173e+37)));
    bool _198 = all(lessThanEqual(abs(_183), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _200 = vec4(float(_186), float(_190), float(_194), float(_198));
    vec4 _203 = abs(vec4((abs(_101 - 0.5) <= 0.5) ? (((_111 > 0.0) && (_111 < min(parameters.gSkyDepth, 65504.0))) ? _111 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _81).wzxy);
    bvec4 _210 = greaterThan(_200 * vec4(lessThanEqual(abs(_203), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _211 = mix(vec4(0.0), (vec4(_68, _69, _68, _69) * vec4(_67.yy, _66.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _203), _210);
    vec4 _213 = mix(vec4(0.0), _211, greaterThan(_211, vec4(0.0)));
    float _214 = dot(_213, vec4(1.0));
    vec4 _215 = mix(vec4(1.9999999360571384930131252153835e+38), _203, _210);
    vec4 _225 = mix(vec4(0.0), _200, lessThanEqual(_215, vec4(min(min(_215.x, _215.y), min(_215.z, _215.w)))));
    vec4 _236 = mix(_225 / vec4(max(dot(_225, vec4(1.0)), 1.0)), _213 / vec4(_214), bvec4((_214 >= 1.0000000031710768509710513471353e-30) && (_214 <= 9.9999996802856924650656260769173e+37)));
    gOutUpsampled = vec4((((mix(vec2(0.0), _135, bvec2(_186)) * _236.x) + (mix(vec2(0.0), _151, bvec2(_190)) * _236.y)) + (mix(vec2(0.0), _167, bvec2(_194)) * _236.z)) + (mix(vec2(0.0), _183, bvec2(_198)) * _236.w), 0.0, 0.0);
}

