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
    vec2 _134 = mix(vec2(_120), min(vec2(_126 * 0.0322580635547637939453125, (_125 - _126) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_120) <= 9.9999996802856924650656260769173e+37));
    float _135 = _87.y;
    float _140 = (_135 > 0.0) ? min(_135, 31.984375) : 0.0;
    float _141 = floor(_140);
    vec2 _149 = mix(vec2(_135), min(vec2(_141 * 0.0322580635547637939453125, (_140 - _141) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_135) <= 9.9999996802856924650656260769173e+37));
    float _150 = _87.z;
    float _155 = (_150 > 0.0) ? min(_150, 31.984375) : 0.0;
    float _156 = floor(_155);
    vec2 _164 = mix(vec2(_150), min(vec2(_156 * 0.0322580635547637939453125, (_155 - _156) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_150) <= 9.9999996802856924650656260769173e+37));
    float _165 = _87.w;
    float _170 = (_165 > 0.0) ? min(_165, 31.984375) : 0.0;
    float _171 = floor(_170);
    vec2 _179 = mix(vec2(_165), min(vec2(_171 * 0.0322580635547637939453125, (_170 - _171) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_165) <= 9.9999996802856924650656260769173e+37));
    bool _182 = all(lessThanEqual(abs(_134), vec2(9.9999996802856924650656260769173e+37)));
    bool _186 = all(lessThanEqual(abs(_149), vec2(9.9999996802856924650656260769173e+37)));
    bool _190 = all(lessThanEqual(abs(_164), vec2(9.9999996802856924650656260769173e+37)));
    bool _194 = all(lessThanEqual(abs(_179), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _196 = vec4(float(_182), float(_186), float(_190), float(_194));
    vec4 _199 = abs(vec4((abs(_101 - 0.5) <= 0.5) ? (((_111 > 0.0) && (_111 < min(parameters.gSkyDepth, 65504.0))) ? _111 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _81).wzxy);
    bvec4 _206 = greaterThan(_196 * vec4(lessThanEqual(abs(_199), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _207 = mix(vec4(0.0), (vec4(_68, _69, _68, _69) * vec4(_67.yy, _66.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _199), _206);
    vec4 _209 = mix(vec4(0.0), _207, greaterThan(_207, vec4(0.0)));
    float _210 = dot(_209, vec4(1.0));
    vec4 _211 = mix(vec4(1.9999999360571384930131252153835e+38), _199, _206);
    vec4 _221 = mix(vec4(0.0), _196, lessThanEqual(_211, vec4(min(min(_211.x, _211.y), min(_211.z, _211.w)))));
    vec4 _232 = mix(_221 / vec4(max(dot(_221, vec4(1.0)), 1.0)), _209 / vec4(_210), bvec4((_210 >= 1.0000000031710768509710513471353e-30) && (_210 <= 9.9999996802856924650656260769173e+37)));
    gOutUpsampled = vec4((((mix(vec2(0.0), _134, bvec2(_182)) * _232.x) + (mix(vec2(0.0), _149, bvec2(_186)) * _232.y)) + (mix(vec2(0.0), _164, bvec2(_190)) * _232.z)) + (mix(vec2(0.0), _179, bvec2(_194)) * _232.w), 0.0, 0.0);
}

