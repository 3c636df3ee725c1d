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
    vec2 _59 = fma(gl_FragCoord.xy, vec2(0.25), vec2(-0.5));
    vec2 _60 = floor(_59);
    vec2 _61 = _59 - _60;
    vec2 _62 = vec2(1.0) - _61;
    float _63 = _62.x;
    float _64 = _61.x;
    vec2 _76 = (_60 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _79 = textureGather(gInFiltered, _76).wzxy;
    vec4 _82 = mix(vec4(1.9999999360571384930131252153835e+38), _79, lessThanEqual(abs(_79), vec4(65504.0)));
    vec4 _95 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _96 = _95.x;
    float _106 = 1.0 / max(fma(_96, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _117 = vec4(lessThanEqual(abs(_82), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _120 = abs(vec4((abs(_96 - 0.5) <= 0.5) ? (((_106 > 0.0) && (_106 < min(parameters.gSkyDepth, 65504.0))) ? _106 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _76).wzxy);
    bvec4 _127 = greaterThan(_117 * vec4(lessThanEqual(abs(_120), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _128 = mix(vec4(0.0), (vec4(_63, _64, _63, _64) * vec4(_62.yy, _61.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _120), _127);
    vec4 _130 = mix(vec4(0.0), _128, greaterThan(_128, vec4(0.0)));
    float _131 = dot(_130, vec4(1.0));
    vec4 _132 = mix(vec4(1.9999999360571384930131252153835e+38), _120, _127);
    vec4 _142 = mix(vec4(0.0), _117, lessThanEqual(_132, vec4(min(min(_132.x, _132.y), min(_132.z, _132.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _82, greaterThan(_117, vec4(0.5))), mix(_142 / vec4(max(dot(_142, vec4(1.0)), 1.0)), _130 / vec4(_131), bvec4((_131 >= 1.0000000031710768509710513471353e-30) && (_131 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

