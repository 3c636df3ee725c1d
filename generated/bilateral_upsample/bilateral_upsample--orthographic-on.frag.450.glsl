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
    float _103 = fma(_95, parameters.gLinearDepth.x, parameters.gLinearDepth.y);
    vec4 _114 = vec4(lessThanEqual(abs(_81), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _117 = abs(vec4((abs(_95 - 0.5) <= 0.5) ? (((_103 > 0.0) && (_103 < min(parameters.gSkyDepth, 65504.0))) ? _103 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _75).wzxy);
    bvec4 _124 = greaterThan(_114 * vec4(lessThanEqual(abs(_117), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _125 = mix(vec4(0.0), (vec4(_62, _63, _62, _63) * vec4(_61.yy, _60.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _117), _124);
    vec4 _127 = mix(vec4(0.0), _125, greaterThan(_125, vec4(0.0)));
    float _128 = dot(_127, vec4(1.0));
    vec4 _129 = mix(vec4(1.9999999360571384930131252153835e+38), _117, _124);
    vec4 _139 = mix(vec4(0.0), _114, lessThanEqual(_129, vec4(min(min(_129.x, _129.y), min(_129.z, _129.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _81, greaterThan(_114, vec4(0.5))), mix(_139 / vec4(max(dot(_139, vec4(1.0)), 1.0)), _127 / vec4(_128), bvec4((_128 >= 1.0000000031710768509710513471353e-30) && (_128 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

