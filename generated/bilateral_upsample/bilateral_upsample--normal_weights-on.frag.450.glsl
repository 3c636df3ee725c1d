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
    vec2 _70 = gl_FragCoord.xy * parameters.gOutputSize.zw;
    vec2 _74 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _75 = floor(_74);
    vec2 _76 = _74 - _75;
    vec2 _77 = vec2(1.0) - _76;
    vec2 _78 = max(parameters.gCoarseSize.xy, vec2(1.0));
    vec2 _79 = _78 - vec2(1.0);
    vec2 _82 = (clamp(_75, vec2(0.0), _79) + vec2(0.5)) / _78;
    vec2 _83 = _75 + vec2(1.0);
    vec2 _86 = (clamp(_83, vec2(0.0), _79) + vec2(0.5)) / _78;
    float _93 = _77.x;
    float _94 = _76.x;
    vec2 _103 = _83 * parameters.gCoarseSize.zw;
    vec4 _106 = textureGather(gInFiltered, _103).wzxy;
    vec4 _109 = mix(vec4(1.9999999360571384930131252153835e+38), _106, lessThanEqual(abs(_106), vec4(65504.0)));
    vec3 _143 = textureLod(gInNormal, _70, 0.0).xyz;
    float _146 = dot(textureLod(gInNormal, (fma(_82, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _143);
    float _150 = min(parameters.gContrast, 256.0);
    bool _153 = parameters.gContrast > 0.0;
    float _155 = dot(textureLod(gInNormal, (fma(vec2(_86.x, _82.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _143);
    float _162 = dot(textureLod(gInNormal, (fma(vec2(_82.x, _86.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _143);
    float _169 = dot(textureLod(gInNormal, (fma(_86, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _143);
    vec4 _180 = textureLod(gInDepth, _70, 0.0);
    float _181 = _180.x;
    float _191 = 1.0 / max(fma(_181, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
    vec4 _202 = vec4(lessThanEqual(abs(_109), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _205 = abs(vec4((abs(_181 - 0.5) <= 0.5) ? (((_191 > 0.0) && (_191 < min(parameters.gSkyDepth, 65504.0))) ? _191 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _103).wzxy);
    bvec4 _213 = greaterThan(_202 * vec4(lessThanEqual(abs(_205), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _214 = mix(vec4(0.0), ((vec4(_93, _94, _93, _94) * vec4(_77.yy, _76.yy)) * vec4(_153 ? ((_146 > 0.0) ? pow(min(abs(_146), 1.0), _150) : 0.0) : 1.0, _153 ? ((_155 > 0.0) ? pow(min(abs(_155), 1.0), _150) : 0.0) : 1.0, _153 ? ((_162 > 0.0) ? pow(min(abs(_162), 1.0), _150) : 0.0) : 1.0, _153 ? ((_169 > 0.0) ? pow(min(abs(_169), 1.0), _150) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _205), _213);
    vec4 _216 = mix(vec4(0.0), _214, greaterThan(_214, vec4(0.0)));
    float _217 = dot(_216, vec4(1.0));
    vec4 _218 = mix(vec4(1.9999999360571384930131252153835e+38), _205, _213);
    vec4 _228 = mix(vec4(0.0), _202, lessThanEqual(_218, vec4(min(min(_218.x, _218.y), min(_218.z, _218.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _109, greaterThan(_202, vec4(0.5))), mix(_228 / vec4(max(dot(_228, vec4(1.0)), 1.0)), _216 / vec4(_217), bvec4((_217 >= 1.0000000031710768509710513471353e-30) && (_217 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

