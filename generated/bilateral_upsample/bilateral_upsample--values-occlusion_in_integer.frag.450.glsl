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
    vec2 _111 = mix(vec2(_97), min(vec2(_103 * 0.0322580635547637939453125, (_102 - _103) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_97) <= 9.9999996802856924650656260769173e+37));
    float _112 = _91.y;
    float _117 = (_112 > 0.0) ? min(_112, 31.984375) : 0.0;
    float _118 = floor(_117);
    vec2 _126 = mix(vec2(_112), min(vec2(_118 * 0.0322580635547637939453125, (_117 - _118) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_112) <= 9.9999996802856924650656260769173e+37));
    float _127 = _91.z;
    float _132 = (_127 > 0.0) ? min(_127, 31.984375) : 0.0;
    float _133 = floor(_132);
    vec2 _141 = mix(vec2(_127), min(vec2(_133 * 0.0322580635547637939453125, (_132 - _133) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_127) <= 9.9999996802856924650656260769173e+37));
    float _142 = _91.w;
    float _147 = (_142 > 0.0) ? min(_142, 31.984375) : 0.0;
    float _148 = floor(_147);
    vec2 _156 = mix(vec2(_142), min(vec2(_148 * 0.0322580635547637939453125, (_147 - _148) * 1.01587307453155517578125), vec2(1.0)), bvec2(abs(_142) <= 9.9999996802856924650656260769173e+37));
    vec4 _160 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _161 = _160.x;
    float _171 = 1.0 / max(fma(_161, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    bool _182 = all(lessThanEqual(abs(_111), vec2(9.9999996802856924650656260769173e+37)));
    bool _186 = all(lessThanEqual(abs(_126), vec2(9.9999996802856924650656260769173e+37)));
    bool _190 = all(lessThanEqual(abs(_141), vec2(9.9999996802856924650656260769173e+37)));
    bool _194 = all(lessThanEqual(abs(_156), vec2(9.9999996802856924650656260769173e+37)));
    vec4 _196 = vec4(float(_182), float(_186), float(_190), float(_194));
    vec4 _199 = abs(vec4((abs(_161 - 0.5) <= 0.5) ? (((_171 > 0.0) && (_171 < min(parameters.gSkyDepth, 65504.0))) ? _171 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _85).wzxy);
    bvec4 _206 = greaterThan(_196 * vec4(lessThanEqual(abs(_199), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _207 = mix(vec4(0.0), (vec4(_72, _73, _72, _73) * vec4(_71.yy, _70.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _199), _206);
    vec4 _209 = mix(vec4(0.0), _207, greaterThan(_207, vec4(0.0)));
    float _210 = dot(_209, vec4(1.0));
    vec4 _211 = mix(vec4(1.9999999360571384930131252153835e+38), _199, _206);
    vec4 _221 = mix(vec4(0.0), _196, lessThanEqual(_211, vec4(min(min(_211.x, _211.y), min(_211.z, _211.w)))));
    vec4 _232 = mix(_221 / vec4(max(dot(_221, vec4(1.0)), 1.0)), _209 / vec4(_210), bvec4((_210 >= 1.0000000031710768509710513471353e-30) && (_210 <= 9.9999996802856924650656260769173e+37)));
    gOutUpsampled = vec4((((mix(vec2(0.0), _111, bvec2(_182)) * _232.x) + (mix(vec2(0.0), _126, bvec2(_186)) * _232.y)) + (mix(vec2(0.0), _141, bvec2(_190)) * _232.z)) + (mix(vec2(0.0), _156, bvec2(_194)) * _232.w), 0.0, 0.0);
}

