#version 450
layout(local_size_x = 16, local_size_y = 16, local_size_z = 1) in;

layout(binding = 0, std140) uniform BilateralUpsampleParameters
{
    vec4 gOutputSize;
    vec4 gCoarseSize;
    vec2 gLinearDepth;
    float gSkyDepth;
    float gContrast;
} parameters;

layout(binding = 16) uniform writeonly image2D gOutUpsampled;
layout(binding = 1) uniform sampler2D gInFiltered;
layout(binding = 2) uniform sampler2D gInCoarseDepth;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _73 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _76 = fma(_73, vec2(0.5), vec2(-0.5));
        vec2 _77 = floor(_76);
        vec2 _78 = _76 - _77;
        vec2 _79 = vec2(1.0) - _78;
        float _80 = _79.x;
        float _81 = _78.x;
        vec2 _93 = (_77 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _96 = textureGather(gInFiltered, _93).wzxy;
        vec4 _99 = mix(vec4(1.9999999360571384930131252153835e+38), _96, lessThanEqual(abs(_96), vec4(65504.0)));
        vec4 _108 = textureLod(gInDepth, _73 * parameters.gOutputSize.zw, 0.0);
        float _109 = _108.x;
        vec4 _119 = vec4(lessThanEqual(abs(_99), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _122 = abs(vec4(((_109 > 0.0) && (_109 < min(parameters.gSkyDepth, 65504.0))) ? _109 : 65504.0) - textureGather(gInCoarseDepth, _93).wzxy);
        bvec4 _129 = greaterThan(_119 * vec4(lessThanEqual(abs(_122), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _130 = mix(vec4(0.0), (vec4(_80, _81, _80, _81) * vec4(_79.yy, _78.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _122), _129);
        vec4 _132 = mix(vec4(0.0), _130, greaterThan(_130, vec4(0.0)));
        float _133 = dot(_132, vec4(1.0));
        vec4 _134 = mix(vec4(1.9999999360571384930131252153835e+38), _122, _129);
        vec4 _144 = mix(vec4(0.0), _119, lessThanEqual(_134, vec4(min(min(_134.x, _134.y), min(_134.z, _134.w)))));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4(dot(mix(vec4(0.0), _99, greaterThan(_119, vec4(0.5))), mix(_144 / vec4(max(dot(_144, vec4(1.0)), 1.0)), _132 / vec4(_133), bvec4((_133 >= 1.0000000031710768509710513471353e-30) && (_133 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

