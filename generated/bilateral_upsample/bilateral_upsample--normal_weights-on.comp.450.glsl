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
layout(binding = 4) uniform sampler2D gInNormal;
layout(binding = 3) uniform sampler2D gInDepth;

void main()
{
    do
    {
        if (any(greaterThanEqual(gl_GlobalInvocationID.xy, uvec2(parameters.gOutputSize.xy))))
        {
            break;
        }
        vec2 _84 = vec2(gl_GlobalInvocationID.xy) + vec2(0.5);
        vec2 _86 = _84 * parameters.gOutputSize.zw;
        vec2 _90 = fma(_84, vec2(0.5), vec2(-0.5));
        vec2 _91 = floor(_90);
        vec2 _92 = _90 - _91;
        vec2 _93 = vec2(1.0) - _92;
        vec2 _94 = max(parameters.gCoarseSize.xy, vec2(1.0));
        vec2 _95 = _94 - vec2(1.0);
        vec2 _98 = (clamp(_91, vec2(0.0), _95) + vec2(0.5)) / _94;
        vec2 _99 = _91 + vec2(1.0);
        vec2 _102 = (clamp(_99, vec2(0.0), _95) + vec2(0.5)) / _94;
        float _109 = _93.x;
        float _110 = _92.x;
        vec2 _119 = _99 * parameters.gCoarseSize.zw;
        vec4 _122 = textureGather(gInFiltered, _119).wzxy;
        vec4 _125 = mix(vec4(1.9999999360571384930131252153835e+38), _122, lessThanEqual(abs(_122), vec4(65504.0)));
        vec3 _159 = textureLod(gInNormal, _86, 0.0).xyz;
        float _162 = dot(textureLod(gInNormal, (fma(_98, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _159);
        float _166 = min(parameters.gContrast, 256.0);
        bool _169 = parameters.gContrast > 0.0;
        float _171 = dot(textureLod(gInNormal, (fma(vec2(_102.x, _98.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _159);
        float _178 = dot(textureLod(gInNormal, (fma(vec2(_98.x, _102.y), parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _159);
        float _185 = dot(textureLod(gInNormal, (fma(_102, parameters.gCoarseSize.xy, vec2(-0.125)) * 2.0) * parameters.gOutputSize.zw, 0.0).xyz, _159);
        vec4 _196 = textureLod(gInDepth, _86, 0.0);
        float _197 = _196.x;
        float _207 = 1.0 / max(fma(_197, parameters.gLinearDepth.x, parameters.gLinearDepth.y), 1.0000000031710768509710513471353e-30);
        vec4 _218 = vec4(lessThanEqual(abs(_125), vec4(9.9999996802856924650656260769173e+37)));
        vec4 _221 = abs(vec4((abs(_197 - 0.5) <= 0.5) ? (((_207 > 0.0) && (_207 < min(parameters.gSkyDepth, 65504.0))) ? _207 : 65504.0) : 65504.0) - textureGather(gInCoarseDepth, _119).wzxy);
        bvec4 _229 = greaterThan(_218 * vec4(lessThanEqual(abs(_221), vec4(9.9999996802856924650656260769173e+37))), vec4(0.5));
        vec4 _230 = mix(vec4(0.0), ((vec4(_109, _110, _109, _110) * vec4(_93.yy, _92.yy)) * vec4(_169 ? ((_162 > 0.0) ? pow(min(abs(_162), 1.0), _166) : 0.0) : 1.0, _169 ? ((_171 > 0.0) ? pow(min(abs(_171), 1.0), _166) : 0.0) : 1.0, _169 ? ((_178 > 0.0) ? pow(min(abs(_178), 1.0), _166) : 0.0) : 1.0, _169 ? ((_185 > 0.0) ? pow(min(abs(_185), 1.0), _166) : 0.0) : 1.0)) / (vec4(9.9999997473787516355514526367188e-05) + _221), _229);
        vec4 _232 = mix(vec4(0.0), _230, greaterThan(_230, vec4(0.0)));
        float _233 = dot(_232, vec4(1.0));
        vec4 _234 = mix(vec4(1.9999999360571384930131252153835e+38), _221, _229);
        vec4 _244 = mix(vec4(0.0), _218, lessThanEqual(_234, vec4(min(min(_234.x, _234.y), min(_234.z, _234.w)))));
        imageStore(gOutUpsampled, ivec2(gl_GlobalInvocationID.xy), vec4(dot(mix(vec4(0.0), _125, greaterThan(_218, vec4(0.5))), mix(_244 / vec4(max(dot(_244, vec4(1.0)), 1.0)), _232 / vec4(_233), bvec4((_233 >= 1.0000000031710768509710513471353e-30) && (_233 <= 9.9999996802856924650656260769173e+37)))), 0.0, 0.0, 0.0));
        break;
    } while(false);
}

