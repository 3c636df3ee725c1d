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
    vec2 _58 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _59 = floor(_58);
    vec2 _60 = _58 - _59;
    vec2 _61 = vec2(1.0) - _60;
    float _62 = _61.x;
    float _63 = _60.x;
    vec2 _75 = (_59 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _78 = textureGather(gInFiltered, _75).wzxy;
    vec4 _81 = mix(vec4(1.9999999360571384930131252153835e+38), _78, lessThanEqual(abs(_78), vec4(65504.0)));
    vec4 _94 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _95 = _94.x;
    float _105 = 1.0 / max(fma(_95, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _116 = vec4(lessThanEqual(abs(_81), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _119 = abs(vec4((abs(_95 - 0.5) <= 0.5) ? (((_105 > 0.0) && (_105 < min(parameters.gSkyDepth, 65504.0))) ? _105 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _75).wzxy);
    bvec4 _126 = greaterThan(_116 * vec4(lessThanEqual(abs(_119), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _127 = mix(vec4(0.0), (vec4(_62, _63, _62, _63) * vec4(_61.yy, _60.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _119), _126);
    vec4 _129 = mix(vec4(0.0), _127, greaterThan(_127, vec4(0.0)));
    float _130 = dot(_129, vec4(1.0));
    vec4 _131 = mix(vec4(1.9999999360571384930131252153835e+38), _119, _126);
    vec4 _141 = mix(vec4(0.0), _116, lessThanEqual(_131, vec4(min(min(_131.x, _131.y), min(_131.z, _131.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _81, greaterThan(_116, vec4(0.5))), mix(_141 / vec4(max(dot(_141, vec4(1.0)), 1.0)), _129 / vec4(_130), bvec4((_130 >= 1.0000000031710768509710513471353e-30) && (_130 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

