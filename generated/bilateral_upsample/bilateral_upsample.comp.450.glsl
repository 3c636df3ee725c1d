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
        vec2 _75 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _78 = fma(_75, vec2(0.5), vec2(-0.5));
        vec2 _79 = floor(_78);
        vec2 _80 = _78 - _79;
        vec2 _81 = vec2(1.0) - _80;
        float _82 = _81.x;
        float _83 = _80.x;
        vec2 _95 = (_79 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _98 = textureGather(gInFiltered, _95).wzxy;
        vec4 _101 = mix(vec4(1.9999999360571384930131252153835e+38), _98, lessThanEqual(abs(_98), vec4(65504.0)));
        vec4 _110 = textureLod(gInDepth, _75 * parameters.gOutputSize.zw, 0.0);
        float _111 = _110.x;
        float _121 = 1.0 / max(fma(_111, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _132 = vec4(lessThanEqual(abs(_101), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _135 = abs(vec4((abs(_111 - 0.5) <= 0.5) ? (((_121 > 0.0) && (_121 < min(parameters.gSkyDepth, 65504.0))) ? _121 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _95).wzxy);
        bvec4 _142 = greaterThan(_132 * vec4(lessThanEqual(abs(_135), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _143 = mix(vec4(0.0), (vec4(_82, _83, _82, _83) * vec4(_81.yy, _80.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _135), _142);
        vec4 _145 = mix(vec4(0.0), _143, greaterThan(_143, vec4(0.0)));
        float _146 = dot(_145, vec4(1.0));
        vec4 _147 = mix(vec4(1.9999999360571384930131252153835e+38), _135, _142);
        vec4 _157 = mix(vec4(0.0), _132, lessThanEqual(_147, vec4(min(min(_147.x, _147.y), min(_147.z, _147.w)))));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4(dot(mix(vec4(0.0), _101, greaterThan(_132, vec4(0.5))), mix(_157 / vec4(max(dot(_157, vec4(1.0)), 1.0)), _145 / vec4(_146), bvec4((_146 >= 1.0000000031710768509710513471353e-30) && (_146 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

