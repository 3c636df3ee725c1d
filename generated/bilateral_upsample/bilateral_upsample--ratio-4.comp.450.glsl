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
        vec2 _77 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _80 = fma(_77, vec2(0.25), vec2(-0.5));
        vec2 _81 = floor(_80);
        vec2 _82 = _80 - _81;
        vec2 _83 = vec2(1.0) - _82;
        float _84 = _83.x;
        float _85 = _82.x;
        vec2 _97 = (_81 + vec2(1.0)) * parameters.gCoarseSize.zw;
        vec4 _100 = textureGather(gInFiltered, _97).wzxy;
        vec4 _103 = mix(vec4(1.9999999360571384930131252153835e+38), _100, lessThanEqual(abs(_100), vec4(65504.0)));
        vec4 _112 = textureLod(gInDepth, _77 * parameters.gOutputSize.zw, 0.0);
        float _113 = _112.x;
        float _123 = 1.0 / max(fma(_113, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _134 = vec4(lessThanEqual(abs(_103), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _137 = abs(vec4((abs(_113 - 0.5) <= 0.5) ? (((_123 > 0.0) && (_123 < min(parameters.gSkyDepth, 65504.0))) ? _123 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _97).wzxy);
        bvec4 _144 = greaterThan(_134 * vec4(lessThanEqual(abs(_137), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _145 = mix(vec4(0.0), (vec4(_84, _85, _84, _85) * vec4(_83.yy, _82.yy)) / (vec4(9.9999997473787516355514526367188e-05) + _137), _144);
        vec4 _147 = mix(vec4(0.0), _145, greaterThan(_145, vec4(0.0)));
        float _148 = dot(_147, vec4(1.0));
        vec4 _149 = mix(vec4(1.9999999360571384930131252153835e+38), _137, _144);
        vec4 _159 = mix(vec4(0.0), _134, lessThanEqual(_149, vec4(min(min(_149.x, _149.y), min(_149.z, _149.w)))));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4(dot(mix(vec4(0.0), _103, greaterThan(_134, vec4(0.5))), mix(_159 / vec4(max(dot(_159, vec4(1.0)), 1.0)), _147 / vec4(_148), bvec4((_148 >= 1.0000000031710768509710513471353e-30) && (_148 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

