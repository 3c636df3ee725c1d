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
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

layout(location = 0) out vec4 gOutUpsampled;

void main()
{
    vec2 _70 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _71 = floor(_70);
    vec2 _72 = _70 - _71;
    vec2 _73 = vec2(1.0) - _72;
    vec2 _74 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _75 = _74 - vec2(1.0);
    vec2 _78 = (clamp(_71, vec2(0.0), _75) + vec2(0.5)) / _74;
    vec2 _79 = _71 + vec2(1.0);
    vec2 _82 = (clamp(_79, vec2(0.0), _75) + vec2(0.5)) / _74;
    float _89 = _73.x;
    float _90 = _72.x;
    vec2 _99 = _79 * parameters.gCoarseSize.zw;
    vec4 _102 = textureGather(gInFiltered, _99).wzxy;
    vec4 _105 = mix(vec4(1.9999999360571384930131252153835e+38), _102, lessThanEqual(abs(_102), vec4(65504.0)));
    vec2 _142 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec4 _144 = textureLod(gInDepth, _142, 0.0);
    float _145 = _144.x;
    float _155 = 1.0 / max(fma(_145, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec3 _166 = textureLod(gInNormal, _142, 0.0).xyz;
    float _169 = dot(textureLod(gInNormal, (fma(_78, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _166);
    float _173 = min(parameters.gContrast, 256.0);
    bool _176 = parameters.gContrast > 0.0;
    float _178 = dot(textureLod(gInNormal, (fma(vec2(_82.x, _78.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _166);
    float _185 = dot(textureLod(gInNormal, (fma(vec2(_78.x, _82.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _166);
    float _192 = dot(textureLod(gInNormal, (fma(_82, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _166);
    vec4 _202 = vec4(lessThanEqual(abs(_105), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _205 = abs(vec4((abs(_145 - 0.5) <= 0.5) ? (((_155 > 0.0) && (_155 < min(parameters.gSkyDepth, 65504.0))) ? _155 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _99).wzxy);
    bvec4 _213 = greaterThan(_202 * vec4(lessThanEqual(abs(_205), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _214 = mix(vec4(0.0), ((vec4(_89, _90, _89, _90) * vec4(_73.yy, _72.yy)) * vec4(_176 ? ((_169 > 0.0) ? pow(min(abs(_169), 1.0), _173) : 0.0) : 1.0, _176 ? ((_178 > 0.0) ? pow(min(abs(_178), 1.0), _173) : 0.0) : 1.0, _176 ? ((_185 > 0.0) ? pow(min(abs(_185), 1.0), _173) : 0.0) : 1.0, _176 ? ((_192 > 0.0) ? pow(min(abs(_192), 1.0), _173) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _205), _213);
    vec4 _216 = mix(vec4(0.0), _214, greaterThan(_214, vec4(0.0)));
    float _217 = dot(_216, vec4(1.0));
    vec4 _218 = mix(vec4(1.9999999360571384930131252153835e+38), _205, _213);
    vec4 _228 = mix(vec4(0.0), _202, lessThanEqual(_218, vec4(min(min(_218.x, _218.y), min(_218.z, _218.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _105, greaterThan(_202, vec4(0.5))), mix(_228 / vec4(max(dot(_228, vec4(1.0)), 1.0)), _216 / vec4(_217), bvec4((_217 >= 1.0000000031710768509710513471353e-30) && (_217 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

