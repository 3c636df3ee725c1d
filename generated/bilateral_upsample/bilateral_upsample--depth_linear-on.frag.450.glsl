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
    vec2 _56 = fma(gl_FragCoord.xy, vec2(0.5), vec2(-0.5));
    vec2 _57 = floor(_56);
    vec2 _58 = _56 - _57;
    vec2 _59 = vec2(1.0) - _58;
    float _60 = _59.x;
    float _61 = _58.x;
    vec2 _73 = (_57 + vec2(1.0)) * parameters.gCoarseSize.zw;
    vec4 _76 = textureGather(gInFiltered, _73).wzxy;
    vec4 _79 = mix(vec4(1.9999999360571384930131252153835e+38), _76, lessThanEqual(abs(_76), vec4(65504.0)));
    vec4 _92 = textureLod(gInDepth, gl_FragCoord.xy * parameters.gOutputSize.zw, 0.0);
    float _93 = _92.x;
    vec4 _103 = vec4(lessThanEqual(abs(_79), vec4(9.9999996802856924650656260769173e+37)));
    vec4 _106 = abs(vec4(((_93 > 0.0) && (_93 < min(parameters.gSkyDepth, 65504.0))) ? _93 : 65504.0) - textureGather(gInCoarseDepth, _73).wzxy);
    bvec4 _113 = greaterThan(_103 * vec4(lessThanEqual(abs(_106), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
    vec4 _114 = mix(vec4(0.0), (vec4(_60, _61, _60, _61) * vec4(_59.yy, _58.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _106), _113);
    vec4 _116 = mix(vec4(0.0), _114, greaterThan(_114, vec4(0.0)));
    float _117 = dot(_116, vec4(1.0));
    vec4 _118 = mix(vec4(1.9999999360571384930131252153835e+38), _106, _113);
    vec4 _128 = mix(vec4(0.0), _103, lessThanEqual(_118, vec4(min(min(_118.x, _118.y), min(_118.z, _118.w)))));
    gOutUpsampled = vec4(dot(mix(vec4(0.0), _79, greaterThan(_103, vec4(0.5))), mix(_128 / vec4(max(dot(_128, vec4(1.0)), 1.0)), _116 / vec4(_117), bvec4((_117 >= 1.0000000031710768509710513471353e-30) && (_117 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0);
}

