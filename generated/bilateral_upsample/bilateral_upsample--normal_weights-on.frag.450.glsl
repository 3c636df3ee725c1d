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
layout(binding = 5) uniform sampler2D gInCoarseNormal;
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _69 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _73 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _74 = floor(_73);
    vec2 _75 = _73 - _74;
    vec2 _76 = vec2(1.0) - _75;
    vec2 _77 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _78 = _77 - vec2(1.0);
    vec2 _81 = (clamp(_74, vec2(0.0), _78) + vec2(0.5)) / _77;
    vec2 _82 = _74 + vec2(1.0);
    vec2 _85 = (clamp(_82, vec2(0.0), _78) + vec2(0.5)) / _77;
    float _92 = _76.x;
    float _93 = _75.x;
    vec2 _102 = _82 * parameters.gCoarseSize.zw;
    vec4 _105 = textureGather(gInFiltered, _102).wzxy;
    vec4 _108 = mix(vec4(1.9999999360571384930131252153835e+38), _105, lessThanEqual(abs(_105), vec4(65504.0)));
    vec3 _132 = textureLod(gInNormal, _69, 0.0).xyz;
    float _136 = min(dot(textureLod(gInCoarseNormal, _81, 0.0).xyz, _132), 1.0);
    float _139 = min(parameters.gContrast, 256.0);
    bool _142 = parameters.gContrast > 0.0;
    float _145 = min(dot(textureLod(gInCoarseNormal, vec2(_85.x, _81.y), 0.0).xyz, _132), 1.0);
    float _152 = min(dot(textureLod(gInCoarseNormal, vec2(_81.x, _85.y), 0.0).xyz, _132), 1.0);
    float _159 = min(dot(textureLod(gInCoarseNormal, _85, 0.0).xyz, _132), 1.0);
    vec4 _169 = textureLod(gInDepth, _69, 0.0);
    float _170 = _169.x;
    float _180 = 1.0 / max(fma(_170, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _191 = vec4(lessThanEqual(abs(_108), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _194 = abs(vec4((abs(_170 - 0.5) <= 0.5) ? (((_180 > 0.0) && (_180 < min(parameters.gSkyDepth, 65504.0))) ? _180 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _102).wzxy);
    bvec4 _202 = greaterThan(_191 * vec4(lessThanEqual(abs(_194), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _203 = mix(vec4(0.0), ((vec4(_92, _93, _92, _93) * vec4(_76.yy, _75.yy)) * vec4(_142 ? ((_136 > 0.0) ? pow(abs(_136), _139) : 0.0) : 1.0, _142 ? ((_145 > 0.0) ? pow(abs(_145), _139) : 0.0) : 1.0, _142 ? ((_152 > 0.0) ? pow(abs(_152), _139) : 0.0) : 1.0, _142 ? ((_159 > 0.0) ? pow(abs(_159), _139) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _194), _202);
    vec4 _205 = mix(vec4(0.0), _203, greaterThan(_203, vec4(0.0)));
    float _206 = dot(_205, vec4(1.0));
    vec4 _207 = mix(vec4(1.9999999360571384930131252153835e+38), _194, _202);
    vec4 _217 = mix(vec4(0.0), _191, lessThanEqual(_207, vec4(min(min(_207.x, _207.y), min(_207.z, _207.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _108, greaterThan(_191, vec4(0.5))), mix(_217 / vec4(max(dot(_217, vec4(1.0)), 1.0)), _205 / vec4(_206), bvec4((_206 >= 1.0000000031710768509710513471353e-30) && (_206 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

